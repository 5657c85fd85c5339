//! Color rendering and Lab under lamps that stand in no table, and that nothing was tuned to: drawn from a
//! seed, on several axes, and searched for the largest errors.
#![cfg(feature = "libm")]

use model::allowed::check;
use model::check::Check;
use model::cri::{self, Mode};
use model::csv::golden;
use model::interpolation::{self, Samples};
use model::lamps::{KINDS, Lamp, Power, is_white};
use model::noise::Noise;
use model::tables::Observer;
use model::tm30::{self, Mix};
use model::tristimulus::{dot, xyz_of_surface};
use nanospectra::color::{Xyz, cri, tm30};
use nanospectra::matter::CES;
use nanospectra::observer::CIE_1931;
use nanospectra::{Fine, Interpolation, Outside};

/// The farthest that the lamps are from the Planckian locus, a little less than where color temperature ends.
const DUV: f64 = 0.0499;

/// Where an instrument samples a light: from where to where, by which step, and what is assumed in between.
struct Axis {
    from: usize,
    to: usize,
    step: usize,
    by: Interpolation,
}

const AXES: [Axis; 4] = [
    Axis { from: 380, to: 780, step: 5, by: Interpolation::Sprague },
    Axis { from: 360, to: 830, step: 5, by: Interpolation::Linear },
    Axis { from: 380, to: 730, step: 10, by: Interpolation::Sprague },
    Axis { from: 380, to: 780, step: 1, by: Interpolation::Linear },
];

/// The same light at every nanometer, as the crate has it and in f64.
type Pair = (Fine<nanospectra::Power>, Power);

fn at_every_nanometer(power: Power) -> Pair {
    let mut light = Fine::flat(0.0);
    light.values_mut().iter_mut().zip(&power).for_each(|(value, exact)| *value = *exact as f32);
    (light, power)
}

fn on_axis(power: &Power, axis: &Axis) -> Pair {
    let values: Vec<f64> = (axis.from..=axis.to).step_by(axis.step).map(|nm| power[nm - 360]).collect();
    let samples = Samples::new(axis.from as f64, axis.step as f64, values);
    let pairs: Vec<(f32, f32)> =
        samples.points().iter().map(|(nm, value)| (*nm as f32, *value as f32)).collect();
    let by = match axis.by {
        Interpolation::Linear => interpolation::Interpolation::Linear,
        _ => interpolation::Interpolation::Sprague,
    };
    let light = Fine::interpolated_outside(&pairs, axis.by, Outside::Zero).expect("a good spectrum");
    (light, samples.on_cie_grid(by, interpolation::Outside::Zero))
}

/// The checks of color rendering, with the methods of the model.
struct Rendering {
    cri: cri::Method,
    tm30: tm30::Method,
    ra: Check,
    r: Check,
    rf: Check,
    rg: Check,
    samples: Check,
    bins: Check,
}

impl Rendering {
    /// The names of the checks are those of Ra, of R1 to R15, of Rf, of Rg, of the samples and of the hue
    /// bins.
    fn new(names: [&'static str; 6]) -> Self {
        let [ra, r, rf, rg, samples, bins] = names.map(check);
        let (cri, tm30) = (cri::Method::new(Mode::OneNm), tm30::Method::new(Mode::OneNm));
        Rendering { cri, tm30, ra, r, rf, rg, samples, bins }
    }

    fn of_any_lamp() -> Self {
        Rendering::new([
            "Ra of any lamp",
            "R1 to R15 of any lamp",
            "Rf of any lamp",
            "Rg of any lamp",
            "Rf of samples under any lamp",
            "Rf of hue bins of any lamp",
        ])
    }

    fn of_the_worst_lamps() -> Self {
        Rendering::new([
            "Ra of the worst lamps",
            "R1 to R15 of the worst lamps",
            "Rf of the worst lamps",
            "Rg of the worst lamps",
            "Rf of samples under the worst lamps",
            "Rf of hue bins of the worst lamps",
        ])
    }

    /// Compares all indices of a light. Returns the errors of Ra, of R1 to R15, of Rf, of Rg, and of the
    /// color temperature in mired.
    fn compare(&mut self, place: &str, (light, exact): &Pair) -> Option<[f64; 5]> {
        // At 5000 K the reference of the CRI changes by a jump, and rounding may decide on which side a light
        // is.
        let right = self.cri.of_values(exact);
        if (right.cct.cct_k - 5000.0).abs() < 0.05 || !is_white(exact, DUV) {
            return None;
        }
        let found = cri(light).unwrap_or_else(|error| panic!("{place}: {error}"));
        self.ra.value(place, found.ra.into(), right.ra);
        let mired = (1e6 / f64::from(found.cct_k) - 1e6 / right.cct.cct_k).abs();
        let mut errors = [(f64::from(found.ra) - right.ra).abs(), 0.0, 0.0, 0.0, mired];
        for (k, (found, right)) in found.r.iter().zip(right.r).enumerate() {
            // Below -100 the error grows with the difference of color.
            let error = (f64::from(*found) - right).abs() / ((100.0 - right) / 200.0).max(1.0);
            self.r.value(&format!("R{} of {place}", k + 1), error, 0.0);
            errors[1] = errors[1].max(error);
        }

        let right = self.tm30.of_values(&exact[20..=420], Mix::Cie1931);
        let found = tm30(light).unwrap_or_else(|error| panic!("{place}: {error}"));
        self.rf.value(place, found.rf.into(), right.rf);
        errors[2] = (f64::from(found.rf) - right.rf).abs();
        for (k, (found, right)) in found.rf_ces.iter().zip(&right.rf_ces).enumerate() {
            self.samples.value(&format!("CES{} under {place}", k + 1), f64::from(*found), *right);
        }
        // Where a sample sits on the edge between two bins, rounding decides where it counts.
        if right.nearest_edge_deg > 0.01 {
            let bins = found.bins.iter().zip(right.rfh);
            bins.filter_map(|(found, right)| found.map(|found| (found, right)))
                .for_each(|(found, right)| self.bins.value(place, found.rf.into(), right));
            // The model has no area where a bin is empty.
            if right.rg.is_finite() {
                self.rg.value(place, found.rg.into(), right.rg);
                errors[3] = (f64::from(found.rg) - right.rg).abs();
            }
        }
        Some(errors)
    }

    /// Fails if an index was off by more than allowed, however few lamps were compared.
    fn hold(self) {
        for check in [self.ra, self.r, self.rf, self.rg] {
            let compared = check.compared;
            check.finish(compared);
        }
    }

    fn tight(self) {
        for check in [self.ra, self.r, self.rf, self.rg, self.samples, self.bins] {
            check.tight_over_all();
        }
    }
}

/// Where `a_search_finds_no_lamps_that_are_worse` found the largest errors.
fn worst_lamps() -> impl Iterator<Item = Lamp> {
    golden("worst_lamps").rows().map(|row| {
        let kind = KINDS.into_iter().find(|kind| format!("{kind:?}") == row.text("kind"));
        let numbers: Vec<f64> =
            row.text("numbers").split(' ').map(|number| number.parse().expect("a number")).collect();
        Lamp { kind: kind.expect("a kind of lamps"), numbers: numbers.try_into().expect("14 numbers") }
    })
}

/// Where each error is largest of all lights below. The dev profile looks at these, and at the first lamp of
/// each kind.
const HARDEST: [&str; 7] = [
    "BlackBody 5 380..730 every 10 nm",
    "BlackBody 23 380..780 every 5 nm",
    "BlackBody 26 every nm",
    "FilteredTungsten 35 380..780 every 5 nm",
    "Halophosphate 23 every nm",
    "NarrowDiodes 11 every nm",
    "Triphosphor 33 380..730 every 10 nm",
];

#[test]
fn lamps_of_no_table_render_as_the_model_says() {
    let mut rendering = Rendering::of_any_lamp();
    let mut mired = check("CCT of color rendering, mired");
    let mut noise = Noise(0x5eed_0f1a_3b5c_0001);
    let mut compared = 0;
    for kind in KINDS {
        for k in 0..40 {
            let power = Lamp::drawn(kind, DUV, &mut noise).power();
            let left_out = |place: &str| cfg!(debug_assertions) && k > 0 && !HARDEST.contains(&place);
            let place = format!("{kind:?} {k} every nm");
            if !left_out(&place)
                && let Some([.., error]) = rendering.compare(&place, &at_every_nanometer(power.clone()))
            {
                compared += 1;
                mired.value(&place, error, 0.0);
            }
            for axis in &AXES {
                let place = format!("{kind:?} {k} {}..{} every {} nm", axis.from, axis.to, axis.step);
                if !left_out(&place) {
                    compared += u32::from(rendering.compare(&place, &on_axis(&power, axis)).is_some());
                }
            }
        }
    }
    println!("{compared} lights compared");
    assert!(compared > if cfg!(debug_assertions) { 50 } else { 1800 }, "{compared}");
    mired.tight_over_all();
    rendering.tight();
}

#[test]
fn the_worst_lamps_render_nearly_as_the_model_says() {
    let mut rendering = Rendering::of_the_worst_lamps();
    for lamp in worst_lamps() {
        let place = format!("{:?}", lamp.kind);
        assert!(rendering.compare(&place, &at_every_nanometer(lamp.power())).is_some());
    }
    rendering.tight();
}

/// Moves the numbers of lamps to where each of five errors is largest, which must stay below what the worst lamps
/// have on record. It prints them for `worst_lamps.csv`. The whole search takes ten minutes:
///
///     NANOSPECTRA_SEARCH=8 cargo test --release -p nanospectra --test color search -- --nocapture
#[test]
fn a_search_finds_no_lamps_that_are_worse() {
    let starts: usize = std::env::var("NANOSPECTRA_SEARCH").map_or(1, |text| text.parse().expect("a number"));
    let (drawn, steps) = if starts > 1 { (60, 2000) } else { (4, 60) };
    let mut rendering = Rendering::of_the_worst_lamps();
    let mut samples = ColorsOfSamples::new("Lab of samples under the worst lamps");
    let mut noise = Noise(0x5eed_0f1a_3b5c_0002);
    let mut errors = |lamp: &Lamp| {
        let power = lamp.power();
        if !is_white(&power, DUV) {
            return None;
        }
        let pair = at_every_nanometer(power);
        let [ra, r, rf, rg, _] = rendering.compare("", &pair)?;
        Some([ra, r, rf, rg, samples.compare("", &pair)])
    };
    let mut pool = Vec::new();
    for kind in KINDS {
        for _ in 0..drawn {
            let lamp = Lamp::drawn(kind, DUV, &mut noise);
            pool.extend(errors(&lamp).map(|errors| (lamp, errors)));
        }
    }
    for (objective, name) in ["Ra", "R1 to R15", "Rf", "Rg", "Lab"].into_iter().enumerate() {
        pool.sort_by(|(_, a), (_, b)| b[objective].total_cmp(&a[objective]));
        for (mut lamp, all) in pool.iter().take(starts).cloned() {
            let mut best = all[objective];
            for step in 0..steps {
                let size = 0.3 * (1e-5f64 / 0.3).powf(f64::from(step) / f64::from(steps));
                let mut moved = lamp.clone();
                let share = if noise.uniform() < 0.5 { 1.0 } else { 0.3 };
                for number in &mut moved.numbers {
                    if noise.uniform() < share {
                        *number = (*number + size * noise.normal()).clamp(0.0, 1.0);
                    }
                }
                if let Some(error) =
                    errors(&moved).map(|errors| errors[objective]).filter(|error| *error > best)
                {
                    (lamp, best) = (moved, error);
                }
            }
            let numbers = lamp.numbers.map(|number| number.to_string()).join(" ");
            println!("{:?},{name},{best:.2e},{numbers}", lamp.kind);
        }
    }
    rendering.hold();
    let compared = samples.lab.compared;
    samples.lab.finish(compared);
}

/// Lab of the 99 samples under a light, from its spectrum on.
struct ColorsOfSamples {
    cmf: [Vec<f64>; 3],
    reflectances: Vec<Vec<f64>>,
    lab: Check,
}

impl ColorsOfSamples {
    fn new(name: &'static str) -> Self {
        let reflectances = CES.iter().map(|sample| sample.fine().values().map(f64::from).to_vec()).collect();
        ColorsOfSamples { cmf: Observer::Cie1931.on_cie_grid(), reflectances, lab: check(name) }
    }

    /// Compares all samples, and returns the largest error.
    fn compare(&mut self, place: &str, (light, exact): &Pair) -> f64 {
        let eye = CIE_1931.under(light).with_white_y(100.0);
        let white = Xyz::from(eye.sees(&Fine::flat(1.0)));
        let scale = 100.0 / dot(exact, &self.cmf[1]);
        let exact_white = [0, 1, 2].map(|c| scale * dot(exact, &self.cmf[c]));
        let mut largest = 0.0f64;
        for (ces, (sample, reflectance)) in CES.iter().zip(&self.reflectances).enumerate() {
            let found = Xyz::from(eye.sees(&sample.fine())).lab(white).expect("a white");
            let right = model::lab::lab(xyz_of_surface(reflectance, exact, &self.cmf), exact_white);
            for (found, right) in [found.l, found.a, found.b].into_iter().zip(right) {
                self.lab.value(&format!("CES{} under {place}", ces + 1), found.into(), right);
                largest = largest.max((f64::from(found) - right).abs());
            }
        }
        largest
    }
}

#[test]
fn lab_under_lamps_of_no_table_is_what_f64_says() {
    let mut samples = ColorsOfSamples::new("Lab of samples under any lamp");
    let mut noise = Noise(0x5eed_0f1a_3b5c_0003);
    for kind in KINDS {
        for k in 0..40 {
            let lamp = Lamp::drawn(kind, DUV, &mut noise);
            samples.compare(&format!("{kind:?} {k}"), &at_every_nanometer(lamp.power()));
        }
    }
    samples.lab.tight(3 * 99 * 400);
}

#[test]
fn lab_under_the_worst_lamps_is_nearly_what_f64_says() {
    let mut samples = ColorsOfSamples::new("Lab of samples under the worst lamps");
    for lamp in worst_lamps() {
        samples.compare(&format!("{:?}", lamp.kind), &at_every_nanometer(lamp.power()));
    }
    samples.lab.tight_over_all();
}
