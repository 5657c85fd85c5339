//! Scenes: paths chosen at run time give what the typed ones give, cost what they say, and leave out what
//! does not show.
#![cfg(feature = "libm")]

use model::allowed::{Singles, check};
use model::delta_e::de2000;
use model::lab::lab;
use nanospectra::light::{self, FL11};
use nanospectra::math::{Fast, Portable};
use nanospectra::matter::{Donaldson, Dye, Mirror, Polarizer, Retarder};
use nanospectra::observer::{CIE_1931, CIE_1964};
use nanospectra::path::{Effects, IntoPart, Part, PolarizationError, Price, Scene, SceneFullError, price_of};
use nanospectra::{Bins, Curve, Interpolation, Light, Observer, Power, Reflectance};
use proptest::prelude::*;

static EYE: Observer<3, 31, Power> = CIE_1931.fold(Curve::Step);

fn lamp<const N: usize>(name: &str) -> Light<N> {
    light::named(name).expect("a CIE illuminant").resample()
}

/// Rises from 0 to 1 around `at`.
fn step(nm: f32, at: f32, width: f32) -> f32 {
    1.0 / (1.0 + ((at - nm) / width).exp())
}

fn bell(nm: f32, peak: f32, width: f32) -> f32 {
    (-0.5 * ((nm - peak) / width).powi(2)).exp()
}

/// What a dye is measured as, and the dye.
struct Measured<const N: usize> {
    reflects: Reflectance<N>,
    absorbs: Reflectance<N>,
    emits: Light<N>,
    quantum_yield: f32,
}

impl<const N: usize> Measured<N> {
    /// Fluorescent yellow: absorbs blue, emits green.
    fn vest() -> Self {
        Measured {
            reflects: Reflectance::averaged(|nm| 0.06 + 0.74 * step(nm, 500.0, 8.0)),
            absorbs: Reflectance::averaged(|nm| 0.9 * (1.0 - step(nm, 487.0, 7.0))),
            emits: Light::averaged(|nm| {
                if nm <= 470.0 { 0.0 } else { (-0.5 * (((nm - 470.0) / 45.0).ln() / 0.45).powi(2)).exp() }
            }),
            quantum_yield: 0.9,
        }
    }

    /// Paper with an optical brightener: absorbs violet (and more that no grid from 380 nm sees), emits blue.
    fn brightened_paper() -> Self {
        Measured {
            reflects: Reflectance::averaged(|nm| 0.85 - 0.6 * (1.0 - step(nm, 395.0, 6.0))),
            absorbs: Reflectance::averaged(|nm| 0.6 * (1.0 - step(nm, 395.0, 6.0))),
            emits: Light::averaged(|nm| if nm <= 400.0 { 0.0 } else { bell(nm, 440.0, 18.0) }),
            quantum_yield: 0.9,
        }
    }

    fn dye(&self) -> Dye<N> {
        Dye::new(&self.reflects, &self.absorbs, &self.emits, self.quantum_yield).expect("a dye")
    }

    /// CIEDE2000 between the glowing and the dull surface, in f64 by the definition.
    fn cost_by_the_model(&self, eye: &Observer<3, N, Power>, lamp: &Light<N>) -> f64 {
        let pairs = |spectrum: &Light<N>| -> Vec<(f64, f64)> {
            spectrum.iter().map(|(nm, value)| (f64::from(nm), f64::from(value))).collect()
        };
        let (light, emits) = (pairs(lamp), pairs(&self.emits));
        let photons: f64 = emits.iter().map(|(nm, power)| nm * power).sum();
        let absorbed: f64 = light
            .iter()
            .zip(self.absorbs.values())
            .map(|((nm, power), share)| nm * power * f64::from(*share))
            .sum();
        let glow = f64::from(self.quantum_yield) * absorbed / photons;
        let seen = |share: f64, factor: &dyn Fn(usize) -> f64| {
            eye.weights().map(|row| -> f64 {
                let leaves = |k: usize| light[k].1 * factor(k) + share * glow * emits[k].1;
                row.iter().enumerate().map(|(k, weight)| f64::from(*weight) * leaves(k)).sum()
            })
        };
        let white = seen(0.0, &|_| 1.0);
        let reflects = |k: usize| f64::from(self.reflects.values()[k]);
        de2000(lab(seen(1.0, &reflects), white), lab(seen(0.0, &reflects), white))
    }
}

/// One of each.
struct Pool {
    glass: Reflectance<31>,
    paper: Reflectance<31>,
    vest: Dye<31>,
    brightened: Donaldson<31, 496>,
    lake: Mirror<31>,
    sheet: Polarizer<31>,
    plate: Retarder<31>,
}

impl Pool {
    fn new() -> Self {
        let mut shares = [[0.0; 31]; 31];
        for (k, row) in shares.iter_mut().enumerate() {
            for (i, share) in row.iter_mut().enumerate().take(k + 1) {
                *share = if i == k { 0.5 } else { 0.01 * ((7 * i + 3 * k) % 5) as f32 / 5.0 };
            }
        }
        Pool {
            glass: Reflectance::at_centers(|nm| nm / 800.0),
            paper: Reflectance::at_centers(|nm| 1.0 - nm / 900.0),
            vest: Measured::vest().dye(),
            brightened: Donaldson::new(&shares).expect("no more than came"),
            lake: Mirror::dielectric(&[1.33; 31], 0.6, 0.03),
            sheet: Polarizer::new(&Reflectance::flat(0.8), &Reflectance::flat(0.05), 0.1),
            plate: Retarder::from_path_difference(137.5, 0.2),
        }
    }

    fn part(&self, kind: usize) -> Part<'_, 31> {
        match kind % 7 {
            0 => Part::Filter(&self.glass),
            1 => Part::Surface(&self.paper),
            2 => (&self.vest).into_part(),
            3 => (&self.brightened).into_part(),
            4 => (&self.lake).into_part(),
            5 => (&self.sheet).into_part(),
            _ => (&self.plate).into_part(),
        }
    }

    fn scene<const CAP: usize>(&self, kinds: &[usize]) -> Scene<'_, 31, CAP> {
        let mut scene = Scene::new();
        for kind in kinds {
            scene.push(self.part(*kind)).expect("room");
        }
        scene
    }

    /// The sum of the terms' sizes: of a dark picture between crossed sheets what would be seen if Mueller's
    /// elements had no signs.
    fn sizes(&self, kinds: &[usize], out: usize, light: &Light<31>) -> Light<31> {
        let mut stokes = [*light.values(), [0.0; 31], [0.0; 31], [0.0; 31]];
        for (place, kind) in kinds.iter().enumerate() {
            let mueller = match kind % 7 {
                _ if place == out => None,
                4 => Some(self.lake.mueller()),
                5 => Some(self.sheet.mueller()),
                6 => Some(self.plate.mueller()),
                _ => None,
            };
            if let Some(mueller) = mueller {
                let mut leaving = [[0.0; 31]; 4];
                for (i, row) in stokes.iter().enumerate() {
                    for (k, value) in row.iter().enumerate() {
                        let mut alone = [0.0; 4];
                        alone[i] = *value;
                        for (leaving, term) in leaving.iter_mut().zip(mueller.turn(k, alone)) {
                            leaving[k] += term.abs();
                        }
                    }
                }
                stokes = leaving;
            } else {
                let part: Scene<31, 1> = self.scene(&[*kind]).leaving_out(if place == out { 0 } else { 1 });
                stokes = stokes.map(|row| *part.leaving_polarized(&Light::from_bins(row)).values());
            }
        }
        Light::from_bins(stokes[0])
    }
}

#[test]
fn a_scene_is_the_typed_path_to_the_bit() {
    let (pool, sun) = (Pool::new(), lamp::<31>("FL11"));
    let Pool { glass, paper, vest, brightened, lake, sheet, plate } = &pool;
    let same = |kinds: &[usize], typed: Light<31>| {
        let scene: Scene<31, 6> = pool.scene(kinds);
        assert_eq!(scene.leaving_polarized(&sun), typed, "{kinds:?}");
    };
    same(&[], sun);
    same(&[0, 1], sun.through(glass).onto(paper).collected());
    same(&[0, 2, 0], sun.through(glass).onto(vest).through(glass).collected());
    same(&[3, 1], sun.onto(brightened).onto(paper).collected());
    same(&[2, 3, 2], sun.onto(vest).onto(brightened).through(vest).collected());
    let wet = sun.polarized().onto(lake).through(glass).through(sheet);
    same(&[4, 0, 5], wet.ignoring_polarization().collected());
    same(&[4, 0, 5, 6, 5], wet.through(plate).through(sheet).ignoring_polarization().collected());
    same(&[4, 0, 5, 1, 2], wet.onto(paper).onto(vest).collected());
    let again = sun.polarized().through(sheet).onto(vest).polarized().onto(lake);
    same(&[5, 2, 4], again.ignoring_polarization().collected());
}

#[test]
fn a_part_left_out_is_what_remains_of_it_without_its_effect() {
    let (pool, sun) = (Pool::new(), lamp::<31>("LED-B3"));
    let Pool { glass, paper, vest, brightened, lake, sheet, .. } = &pool;
    let diagonal = brightened.into_part().without_effect();
    assert_eq!(diagonal, Reflectance::flat(0.5));
    let dull = sun.onto(&vest.reflectance()).onto(&diagonal).collected();
    let scene: Scene<31, 6> = pool.scene(&[2, 3]);
    assert_eq!(scene.leaving_out(0).leaving_out(1).leaving(&sun), Ok(dull));
    // A mirror left out still dims light that is polarized already.
    let dim = lake.ignoring_polarization();
    let through = sun.polarized().through(sheet).through(&dim).through(sheet);
    let scene: Scene<31, 6> = pool.scene(&[5, 4, 5]);
    assert_eq!(scene.leaving_out(1).leaving_polarized(&sun), through.ignoring_polarization().collected());
    // Without any effect it is plain, and what has none cannot lose it.
    let scene: Scene<31, 6> = pool.scene(&[0, 4, 1, 5]);
    assert_eq!(scene.leaving(&sun), Err(PolarizationError { part: 1 }));
    let plain = scene.leaving_out(0).leaving_out(1).leaving_out(3).leaving_out(17);
    assert!(plain.effects().is_empty() && plain.left_out().eq([1, 3]));
    let gray = Reflectance::flat(0.425);
    assert_eq!(
        plain.leaving(&sun),
        Ok(sun.through(glass).through(&dim).onto(paper).through(&gray).collected())
    );
    assert_eq!(plain.fold(&EYE), Ok(EYE.through(&gray).looking_at(paper).through(&dim).through(glass)));
}

#[test]
fn what_polarizes_is_refused_and_carried_on_request() {
    let (pool, sun) = (Pool::new(), lamp::<31>("D65"));
    let scene: Scene<31, 6> = pool.scene(&[0, 2, 4, 5]);
    assert_eq!(scene.fold(&EYE), Err(PolarizationError { part: 2 }));
    assert_eq!(scene.leaving(&sun), Err(PolarizationError { part: 2 }));
    let said = PolarizationError { part: 2 }.to_string();
    assert!(said.contains("part 2") && said.contains("fold_polarized"), "{said}");
    let Pool { glass, vest, lake, sheet, .. } = &pool;
    let typed = EYE
        .polarized()
        .through_polarizer(sheet)
        .looking_at_mirror(lake)
        .unpolarized_light()
        .looking_at_dye(vest)
        .through(glass);
    let mut folds = check("scenes folded, beside the typed fold");
    for (got, expected) in scene.fold_polarized(&EYE).weights().iter().zip(typed.weights()) {
        for (k, (got, expected)) in got.iter().zip(expected).enumerate() {
            folds.add(&k.to_string(), *got, f64::from(*expected));
        }
    }
    folds.tight(93);
}

#[test]
fn a_full_scene_takes_no_more() {
    let pool = Pool::new();
    let mut scene: Scene<31, 2> = pool.scene(&[0, 1]);
    assert_eq!(scene.push(&pool.vest), Err(SceneFullError { capacity: 2 }));
    assert!(scene.parts().map(Part::name).eq(["filter", "surface"]));
    assert_eq!(Scene::<31, 0>::new().push(Part::Filter(&pool.glass)), Err(SceneFullError { capacity: 0 }));
    assert_eq!(SceneFullError { capacity: 2 }.to_string(), "the scene has room for 2 parts");
}

#[test]
fn the_bill_adds_up_to_what_the_typed_stages_cost() {
    let pool = Pool::new();
    let all: Scene<31, 8> = pool.scene(&[0, 1, 2, 3, 4, 5, 6, 0]);
    let lines: Vec<_> = all.bill().collect();
    assert_eq!(lines[2].price, price_of(&pool.vest));
    assert_eq!(lines[3].price, price_of(&pool.brightened));
    // The first that polarizes has one number of each bin to work on, and the next all four.
    let turned = price_of(pool.lake.mueller());
    assert_eq!(lines[4].price, Price { multiply_adds: 4 * 31, ..turned });
    assert_eq!((lines[5].price, lines[6].price), (turned, turned));
    let sun = Light::<31>::flat(1.0);
    let typed =
        sun.polarized().onto(&pool.lake).through(&pool.sheet).through(&pool.plate).through(&pool.glass);
    let polarizing: Scene<31, 4> = pool.scene(&[4, 5, 6, 0]);
    assert_eq!(Price::light(31).plus(polarizing.price()), typed.price());
    assert_eq!(lines[0].price, Price::factor(31));
    // Behind the mirror there are four numbers for each bin.
    assert_eq!(lines[7].price, Price::factor(31).and_multiply_adds(3 * 31));
    let sum = lines.iter().fold(Price::NONE, |sum, line| sum.plus(line.price));
    assert_eq!(sum, all.price());
    assert_eq!(all.effects(), Effects::FLUORESCENCE.and(Effects::POLARIZATION));
    let names = ["filter", "surface", "dye", "donaldson", "mirror", "polarizer", "retarder", "filter"];
    assert!(lines.iter().map(|line| line.name).eq(names) && lines.iter().map(|line| line.part).eq(0..8));
    // A matrix left out is 31 factors, and the typed path says the same of a plain scene.
    assert_eq!(all.leaving_out(3).price().multiply_adds, all.price().multiply_adds - 496 + 31);
    let (plain, sun): (Scene<31, 8>, Light<31>) = (pool.scene(&[0, 1]), Light::flat(1.0));
    let typed = sun.through(&pool.glass).onto(&pool.paper).price();
    assert_eq!(Price::light(31).plus(plain.price()), typed);
    assert_eq!(all.folded_price(3), Price { effects: Effects::NONE, multiply_adds: 93, bytes: 372 });
}

/// What leaving the glow out costs, by lamp: for the vest always, for the paper where the lamp has violet.
#[test]
fn a_vest_glows_under_every_lamp_and_a_brightener_not_under_a_blue_led() {
    static EYE: Observer<3, 60, Power> = CIE_1931.fold(Curve::Step);
    let (vest, paper) = (Measured::vest(), Measured::brightened_paper());
    let (vest_dye, paper_dye) = (vest.dye(), paper.dye());
    let mut scenes = [Scene::<60, 1>::new(), Scene::new()];
    scenes[0].push(&vest_dye).expect("room");
    scenes[1].push(&paper_dye).expect("room");
    let mut costs = check("cost of leaving out a glow, CIEDE2000");
    let mut range = [[f32::INFINITY, 0.0f32]; 2];
    let lamps = ["D65", "FL2", "FL7", "FL11", "LED-B1", "LED-B3", "LED-B5", "LED-RGB1"];
    for name in lamps {
        let lamp = lamp::<60>(name);
        for ((scene, measured), range) in scenes.iter().zip([&vest, &paper]).zip(&mut range) {
            let cost = scene.difference(&scene.leaving_out(0), &EYE, &lamp);
            costs.add(name, cost, measured.cost_by_the_model(&EYE, &lamp));
            println!("{name}: {cost}");
            *range = [range[0].min(cost), range[1].max(cost)];
            let found = scene.within_budget(&EYE, &lamp, 0.1);
            assert_eq!(found.scene.left_out().count(), usize::from(cost <= 0.1), "{name}");
        }
    }
    costs.tight(2 * lamps.len());
    let [least, most] = range[0];
    assert!((7.0..9.0).contains(&least) && (19.0..=20.0).contains(&most), "the vest: {least} to {most}");
    let [least, most] = range[1];
    assert!((0.0..=0.1).contains(&least) && (4.0..5.0).contains(&most), "the paper: {least} to {most}");
}

#[test]
fn what_is_left_out_together_stays_within_the_budget_and_nothing_more_would() {
    let pool = Pool::new();
    let scene: Scene<31, 8> = pool.scene(&[3, 0, 4, 6, 5, 3, 2, 6]);
    let mut counts = Vec::new();
    for lamp in ["D65", "FL11", "LED-B3", "A"].map(lamp::<31>) {
        for budget in [0.0, 0.3, 1.0, 3.0, 6.0, 12.0, 25.0, 100.0] {
            let found = scene.within_budget(&EYE, &lamp, budget);
            let cost = scene.difference(&found.scene, &EYE, &lamp);
            assert!(cost <= budget && cost == found.delta_e, "{budget}: {cost} and {}", found.delta_e);
            for line in found.scene.bill().filter(|line| !line.price.effects.is_empty()) {
                let less = found.scene.leaving_out(line.part);
                assert!(scene.difference(&less, &EYE, &lamp) > budget, "{budget}: part {}", line.part);
            }
            counts.push(found.scene.left_out().count());
        }
    }
    println!("{counts:?}");
    // The last plate goes for nothing, all goes for a hundred.
    assert!(counts.chunks(8).all(|counts| counts[0] == 1 && counts[7] == 7), "{counts:?}");
}

#[test]
fn two_effects_that_each_would_fit_do_not_both_go() {
    let (pool, sun) = (Pool::new(), lamp::<31>("D65"));
    let scene: Scene<31, 2> = pool.scene(&[3, 3]);
    let alone = [0, 1].map(|k| scene.difference(&scene.leaving_out(k), &EYE, &sun));
    let both = scene.difference(&scene.leaving_out(0).leaving_out(1), &EYE, &sun);
    let budget = 0.5 * (alone[0].max(alone[1]) + both);
    assert!(alone[0] < budget && alone[1] < budget && budget < both, "{alone:?} {both}");
    assert_eq!(scene.within_budget(&EYE, &sun, budget).scene.left_out().count(), 1);
}

#[test]
fn of_effects_that_save_as_much_the_first_goes() {
    let pool = Pool::new();
    let sun = lamp::<31>("D65");
    // With a filter between the two papers neither makes the same difference. The budget has room for one.
    let scene: Scene<31, 3> = pool.scene(&[3, 0, 3]);
    let saves = [0, 2].map(|k| scene.leaving_out(k).price().multiply_adds);
    assert_eq!(saves[0], saves[1]);
    let alone = [0, 2].map(|k| scene.difference(&scene.leaving_out(k), &EYE, &sun));
    let both = scene.difference(&scene.leaving_out(0).leaving_out(2), &EYE, &sun);
    let budget = 0.5 * (alone[0].max(alone[1]) + both);
    assert!(
        alone[0] != alone[1] && alone[0] < budget && alone[1] < budget && budget < both,
        "{alone:?} {both}"
    );
    let found = scene.within_budget(&EYE, &sun, budget);
    assert!(found.scene.left_out().eq([0]) && found.delta_e == alone[0], "{found:?}");
}

#[test]
fn short_names_are_portable_and_other_functions_judge_alike() {
    let (pool, sun) = (Pool::new(), lamp::<31>("FL7"));
    let scene: Scene<31, 4> = pool.scene(&[0, 3, 4, 2]);
    let less = scene.leaving_out(3);
    let cost = scene.difference(&less, &EYE, &sun);
    assert_eq!(cost, scene.difference_with::<Portable>(&less, &EYE, &sun));
    let fast = scene.difference_with::<Fast>(&less, &EYE, &sun);
    assert!(cost > 1.0 && (fast - cost).abs() < 1e-4, "{fast} {cost}");
    for budget in [0.5, 5.0, 30.0] {
        let found = scene.within_budget(&EYE, &sun, budget);
        let portable = scene.within_budget_with::<Portable>(&EYE, &sun, budget);
        assert!(portable.delta_e == found.delta_e && portable.scene.left_out().eq(found.scene.left_out()));
        let fast = scene.within_budget_with::<Fast>(&EYE, &sun, budget);
        assert!(fast.scene.left_out().eq(found.scene.left_out()), "{budget}");
    }
}

/// Each weight is made by so many roundings, and few bins average little of them out.
#[test]
fn folds_of_long_scenes_are_off_by_a_rounding_or_so_for_each_part() {
    type Few = Bins<400, 700>;
    let mut random = 0x5eed_u32;
    let mut unit = || {
        random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (random >> 8) as f32 / 16_777_216.0
    };
    let eye: Observer<3, 3, Power, Few> = CIE_1931.fold(Curve::Step);
    for (parts, what) in [(8, "folds of 8 parts, in eps"), (16, "folds of 16 parts, in eps")] {
        let mut check = check(what);
        let bound = 4e-7 + 3e-8 * (parts as f64 - 4.0);
        for _ in 0..20_000 {
            let mut bins = || [(); 3].map(|()| 0.05 + 0.9 * unit());
            let light = Light::<3, Few>::from_bins(bins());
            let glasses: [Reflectance<3, Few>; 16] = std::array::from_fn(|_| Reflectance::from_bins(bins()));
            let mut scene: Scene<3, 16, Few> = Scene::new();
            for glass in glasses.iter().take(parts) {
                scene.push(Part::Filter(glass)).expect("room");
            }
            let walked = eye.sees(&scene.leaving(&light).expect("plain"));
            for (folded, walked) in scene.fold(&eye).expect("plain").sees(&light).into_iter().zip(walked) {
                let error = (f64::from(folded) / f64::from(walked) - 1.0).abs();
                assert!(error <= bound, "{parts} parts: {error:e}");
                check.value("", error * 16_777_216.0, 0.0);
            }
        }
        check.tight(60_000);
    }
}

#[test]
fn a_pair_of_polarizers_cannot_be_left_out() {
    let sun = lamp::<31>("D65");
    for turns in [0.0, 0.125, 0.25] {
        let (first, second) = (Polarizer::ideal(0.0), Polarizer::ideal(turns));
        let mut scene: Scene<31, 2> = Scene::new();
        scene.push(&first).expect("room");
        scene.push(&second).expect("room");
        // At 45 degrees the pair is what two gray filters are: only there it may go.
        let out = if turns == 0.125 { 2 } else { 0 };
        assert_eq!(scene.within_budget(&EYE, &sun, 1.0).scene.left_out().count(), out, "{turns}");
        // Malus: 0.5 cos^2.
        let cos = f64::from(turns * std::f32::consts::TAU).cos();
        let [_, y, _] = scene.fold_polarized(&EYE).sees(&sun);
        let [_, white, _] = EYE.sees(&sun);
        assert!((f64::from(y / white) - 0.5 * cos * cos).abs() < 1e-7, "{turns}: {}", y / white);
    }
}

#[test]
fn nothing_is_left_out_that_cannot_be_judged() {
    let pool = Pool::new();
    let scene: Scene<31, 2> = pool.scene(&[2, 6]);
    let (sun, dark, unknown) = (lamp("D65"), Light::flat(0.0), Light::flat(f32::NAN));
    assert_eq!(scene.within_budget(&EYE, &sun, f32::NAN).scene.left_out().count(), 0);
    assert_eq!(scene.within_budget(&EYE, &sun, -1.0).scene.left_out().count(), 0);
    assert_eq!(scene.within_budget(&EYE, &dark, 1e9).scene.left_out().count(), 0);
    assert_eq!(scene.within_budget(&EYE, &unknown, 1e9).scene.left_out().count(), 0);
    assert!(scene.difference(&scene, &EYE, &unknown).is_nan());
    assert!(scene.leaving_polarized(&unknown).values().iter().all(|value| value.is_nan()));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 256, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn folded_and_walked_scenes_see_the_same(kinds in prop::collection::vec(0usize..7, 0..8), out in 0usize..8) {
        let (pool, sun) = (Pool::new(), FL11.interpolate(Interpolation::Linear));
        static EYE: Observer<3, 31, Power> = CIE_1964.fold(Curve::Step);
        for out in [usize::MAX, out] {
            let scene: Scene<31, 8> = pool.scene(&kinds).leaving_out(out);
            let walked = EYE.sees(&scene.leaving_polarized(&sun));
            let folded = scene.fold_polarized(&EYE).sees(&sun);
            let sizes = EYE.sees(&pool.sizes(&kinds, out, &sun));
            for ((walked, folded), size) in walked.into_iter().zip(folded).zip(sizes) {
                let allowed = 4e-7 + 3e-8 * kinds.len().saturating_sub(4) as f32;
                prop_assert!((walked - folded).abs() <= allowed * size, "{walked} {folded} {kinds:?}");
            }
            let plain = scene.fold(&EYE).is_ok();
            prop_assert_eq!(plain, !scene.effects().contains(Effects::POLARIZATION));
        }
    }
}
