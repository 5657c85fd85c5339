//! Mirrors, polarizers and retarders: published values, closed forms, and naive 4 by 4 matrices in f64.

use model::allowed::{Singles, check};
use model::check::Check;
use model::csv::golden;
use nanospectra::matter::{Mirror, Polarizer, Retarder};
use nanospectra::observer::CIE_1931;
use nanospectra::{Bins, Curve, Light, Observer, Power, Reflectance, Spectrum};
use proptest::prelude::*;
use std::array::from_fn;
use std::f64::consts::TAU;

/// One band: what these tests are about is not in the wavelength.
type One = Bins<500, 600>;
const LAMP: Light<1, One> = Light::flat(1.0);

type Vector = [f64; 4];
type Matrix = [[f64; 4]; 4];

fn times(m: &Matrix, v: Vector) -> Vector {
    m.map(|row| row.iter().zip(v).map(|(a, b)| a * b).sum())
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    from_fn(|i| from_fn(|j| (0..4).map(|k| a[i][k] * b[k][j]).sum()))
}

/// Into axes turned by so many turns.
fn rotation(turns: f64) -> Matrix {
    let (sin, cos) = (2.0 * TAU * turns).sin_cos();
    [[1.0, 0.0, 0.0, 0.0], [0.0, cos, sin, 0.0], [0.0, -sin, cos, 0.0], [0.0, 0.0, 0.0, 1.0]]
}

/// An element with amplitudes (transmission or reflection) along and across its axis, `x` and `y`: complex,
/// for waves as e^(i omega t), so that what is delayed has the smaller phase.
fn element(x: (f64, f64), y: (f64, f64), axis_turns: f64) -> Matrix {
    let (xx, yy) = (x.0 * x.0 + x.1 * x.1, y.0 * y.0 + y.1 * y.1);
    // x times the conjugate of y
    let (c, s) = (x.0 * y.0 + x.1 * y.1, x.1 * y.0 - x.0 * y.1);
    let (a, b) = ((xx + yy) / 2.0, (xx - yy) / 2.0);
    let own = [[a, b, 0.0, 0.0], [b, a, 0.0, 0.0], [0.0, 0.0, c, s], [0.0, 0.0, -s, c]];
    product(&rotation(-axis_turns), &product(&own, &rotation(axis_turns)))
}

/// Fresnel's amplitudes of s and p by the textbook (Born and Wolf), p turned round so that both agree at
/// right angles: what a mirror does along the unfolded path.
fn fresnel(eta: f64, degrees: f64) -> ((f64, f64), (f64, f64)) {
    let cos = degrees.to_radians().cos();
    let sin = degrees.to_radians().sin();
    let inner = 1.0 - (sin / eta).powi(2);
    // The wave beyond fades out: the cosine of the angle of refraction is -i times something.
    let (re, im) = if inner >= 0.0 { (inner.sqrt(), 0.0) } else { (0.0, -(-inner).sqrt()) };
    let over = |n: (f64, f64), d: (f64, f64)| {
        let size = d.0 * d.0 + d.1 * d.1;
        ((n.0 * d.0 + n.1 * d.1) / size, (n.1 * d.0 - n.0 * d.1) / size)
    };
    let s = over((cos - eta * re, -eta * im), (cos + eta * re, eta * im));
    let p = over((re - eta * cos, im), (re + eta * cos, im));
    (s, p)
}

fn stokes(light: impl FnOnce() -> [f32; 4]) -> Vector {
    light().map(f64::from)
}

#[test]
fn malus_law_holds_at_every_angle() {
    let mut check = check("Malus' law");
    for k in 0..=720 {
        let turns = k as f32 / 720.0;
        let (first, second) = (Polarizer::ideal(0.0), Polarizer::ideal(turns));
        let [intensity, ..] = LAMP.polarized().through(&first).through(&second).stokes_at(0);
        check.add(&format!("{turns}"), intensity, 0.5 * (TAU * f64::from(turns)).cos().powi(2));
    }
    check.tight(721);
}

#[test]
fn crossed_polarizers_are_dark_and_a_third_between_them_lets_an_eighth_through() {
    for turns in [0.0, 0.1, 0.37, 0.5, 0.75] {
        let (first, between) = (Polarizer::ideal(turns), Polarizer::ideal(turns + 0.125));
        let crossed = Polarizer::ideal(turns + 0.25);
        let [dark, ..] = LAMP.polarized().through(&first).through(&crossed).stokes_at(0);
        assert!(dark.abs() < 1e-7, "{turns}: {dark:e}");
        let [eighth, ..] = LAMP.polarized().through(&first).through(&between).through(&crossed).stokes_at(0);
        assert!((eighth - 0.125).abs() < 1e-7, "{turns}: {eighth}");
    }
    let crossed =
        LAMP.polarized().through(&Polarizer::ideal(0.0)).through(&Polarizer::ideal(0.25)).stokes_at(0);
    assert_eq!(crossed, [0.0; 4], "along the reference it is no light at all");
}

#[test]
fn a_quarter_wave_plate_makes_circular_light_and_two_turn_it() {
    let (sheet, quarter) = (Polarizer::ideal(0.0), Retarder::flat(0.25, 0.125));
    let circular = stokes(|| LAMP.polarized().through(&sheet).through(&quarter).stokes_at(0));
    for (got, exact) in circular.into_iter().zip([0.5, 0.0, 0.0, 0.5]) {
        assert!((got - exact).abs() < 1e-7, "{circular:?}");
    }
    let turned = stokes(|| LAMP.polarized().through(&sheet).through(&quarter).through(&quarter).stokes_at(0));
    for (got, exact) in turned.into_iter().zip([0.5, -0.5, 0.0, 0.0]) {
        assert!((got - exact).abs() < 1e-7, "{turned:?}");
    }
    // Of circular light every polarizer lets half through.
    for turns in [0.0, 0.1, 0.2, 0.3] {
        let behind = Polarizer::ideal(turns);
        let [half, ..] = LAMP.polarized().through(&sheet).through(&quarter).through(&behind).stokes_at(0);
        assert!((half - 0.25).abs() < 1e-7, "{turns}: {half}");
    }
}

/// What is used against the glare of a display: a polarizer and a quarter-wave plate, passed twice.
#[test]
fn a_circular_polarizer_before_a_mirror_is_dark() {
    let (sheet, quarter) = (Polarizer::ideal(0.0), Retarder::flat(0.25, 0.125));
    let silver = Mirror::new(&Reflectance::flat(0.9), &Reflectance::flat(0.9), &[[1.0, 0.0]], 0.3);
    let back = LAMP.polarized().through(&sheet).through(&quarter).onto(&silver).through(&quarter);
    let [glare, ..] = back.through(&sheet).stokes_at(0);
    assert!(glare.abs() < 1e-7, "{glare:e}");
}

#[test]
fn two_parallel_mirrors_at_brewsters_angle_reflect_twice_what_unpolarized_maths_says() {
    // tan(angle) = 1.5: 56.31 degrees
    let cos = (1.0 / (1.0 + 1.5f64 * 1.5).sqrt()) as f32;
    let mirror = Mirror::dielectric(&[1.5], cos, 0.0);
    let mut check = check("two mirrors at Brewster's angle");
    let reflected = LAMP.polarized().onto(&mirror).onto(&mirror).stokes_at(0);
    let rs: f64 = (1.25f64 / 3.25).powi(2);
    assert!((rs - 0.147_929).abs() < 1e-6, "the published value");
    assert!((rs * rs / 2.0 - 0.010_941).abs() < 1e-6, "the published value");
    check.add("parallel", reflected[0], rs * rs / 2.0);
    check.add("parallel, all of it polarized", reflected[1], rs * rs / 2.0);
    let plain = mirror.ignoring_polarization();
    let ignoring = LAMP.onto(&plain).onto(&plain).collected().values()[0];
    check.add("ignoring polarization", ignoring, rs * rs / 4.0);
    let crossed = Mirror::dielectric(&[1.5], cos, 0.25);
    let [dark, ..] = LAMP.polarized().onto(&mirror).onto(&crossed).stokes_at(0);
    check.add("crossed", dark, 0.0);
    check.tight(4);
}

#[test]
fn mirrors_agree_with_the_golden() {
    let mut check = check("mirrors, golden 10");
    let (along, mut compared) = (Polarizer::ideal(0.0), 0);
    for row in golden("10_fresnel").rows() {
        let [n1, n2, k2, degrees] = row.numbers(["n1", "n2", "k2", "theta_deg"]);
        let [eta, k, cos] = [n2 / n1, k2 / n1, degrees.to_radians().cos()].map(|v| v as f32);
        // The golden is not for these very f32: only where their rounding does not show.
        if degrees > 89.5 {
            continue;
        }
        for (column, axis) in [("Rs", 0.0), ("Rp", 0.25)] {
            let metal = Mirror::conductor(&Spectrum::flat(eta), &Spectrum::flat(k), cos, axis);
            let glass = Mirror::dielectric(&[eta], cos, axis);
            for mirror in [metal, if k == 0.0 { glass } else { metal }] {
                let [intensity, ..] = LAMP.polarized().through(&along).onto(&mirror).stokes_at(0);
                check.cell(row, column, 2.0 * f64::from(intensity));
                compared += 1;
            }
        }
    }
    check.tight(compared);
    assert!(compared > 40, "{compared}");
}

#[test]
fn a_metal_that_does_not_absorb_turns_phases_as_glass_does() {
    // Light at 45 degrees to the plane of incidence, from without and from within, so that U and V show the
    // phase.
    let (across, plate) = (Polarizer::ideal(0.125), Retarder::flat(0.1, 0.05));
    for eta in [0.5f32, 0.8, 1.0, 1.5, 2.4] {
        for cos in [-0.5f32, 0.0, 0.1, 0.3, 0.6, 0.8, 1.0] {
            let glass = Mirror::dielectric(&[eta], cos, 0.2);
            let metal = Mirror::conductor(&Spectrum::flat(eta), &Spectrum::flat(0.0), cos, 0.2);
            let light = LAMP.polarized().through(&across).through(&plate);
            let (one, other) = (light.onto(&glass).stokes_at(0), light.onto(&metal).stokes_at(0));
            for (a, b) in one.into_iter().zip(other) {
                assert!((a - b).abs() < 2e-6, "{eta} {cos}: {one:?} {other:?}");
            }
        }
    }
}

#[test]
fn total_reflection_turns_the_phase_as_fresnel_says() {
    let mut check = check("phase of total reflection");
    for eta in [0.66f32, 0.75, 0.5] {
        for step in 1..90 {
            let (cos, along) = ((f64::from(step).to_radians().cos()) as f32, Polarizer::ideal(0.125));
            let degrees = f64::from(cos).acos().to_degrees();
            let critical = f64::from(eta).asin().to_degrees();
            if (degrees - critical).abs() < 0.5 {
                continue;
            }
            let mirror = Mirror::dielectric(&[eta], cos, 0.0);
            let got = LAMP.polarized().through(&along).onto(&mirror).stokes_at(0);
            let (s, p) = fresnel(eta.into(), degrees);
            let exact = times(&element(s, p, 0.0), [0.5, 0.0, 0.5, 0.0]);
            for (got, exact) in got.into_iter().zip(exact) {
                check.add(&format!("{eta} {degrees}"), got, exact);
            }
        }
    }
    check.tight_over_all();
}

/// Two total reflections at 54 degrees 37 minutes in glass of 1.51 make a quarter wave (Born and Wolf,
/// 1.5.4).
#[test]
fn a_fresnel_rhomb_makes_circular_light() {
    let cos = (54.0 + 37.0 / 60.0f64).to_radians().cos() as f32;
    let (sheet, face) = (Polarizer::ideal(0.125), Mirror::dielectric(&[1.0 / 1.51], cos, 0.0));
    let [i, q, u, v] = stokes(|| LAMP.polarized().through(&sheet).onto(&face).onto(&face).stokes_at(0));
    assert!((i - 0.5).abs() < 1e-6 && (v.abs() - 0.5).abs() < 1e-4, "{v}");
    assert!(q.abs() < 1e-6 && u.abs() < 2e-3, "{q} {u}");
}

#[test]
fn at_right_angles_the_plane_of_incidence_does_not_matter() {
    let sheet = Polarizer::ideal(0.2);
    for axis in [0.0, 0.1, 0.4] {
        for eta in [1.5f32, 1.0 / 1.5] {
            let mirror = Mirror::dielectric(&[eta], 1.0, axis);
            let [i, q, u, v] = LAMP.polarized().through(&sheet).onto(&mirror).stokes_at(0);
            let [.., q0, u0, v0] = LAMP.polarized().through(&sheet).stokes_at(0);
            for (got, exact) in [(i, 0.02), (q, 0.04 * q0), (u, 0.04 * u0), (v, v0)] {
                assert!((got - exact).abs() < 1e-8, "{axis} {eta}: {got} {exact}");
            }
        }
    }
}

#[test]
fn no_surface_and_light_from_behind_reflect_nothing_and_nan_stays() {
    let sees = |eta: f32, cos: f32| {
        let [i, ..] = LAMP.polarized().onto(&Mirror::dielectric(&[eta], cos, 0.1)).stokes_at(0);
        i
    };
    for cos in [0.0, 1e-3, 0.5, 1.0, -0.1] {
        assert_eq!(sees(1.0, cos), 0.0);
    }
    for eta in [0.5, 1.5, 1e3, 1e-3] {
        assert_eq!(sees(eta, -0.1), 0.0);
        assert_eq!(sees(eta, 0.0), 1.0, "grazing");
    }
    // No index and no angle that f32 has gives what is no light.
    for eta in [0.0, 1e-45, 1e-30, 0.999_999_94, 1.000_000_1, 2.0, 1e15, 1e30, f32::MAX, f32::INFINITY] {
        for cos in
            [0.0, 1e-45, 1e-20, 1e-5, 0.5, 1.0f32.next_down(), 1.0, 1.0f32.next_up(), 1e20, f32::INFINITY]
        {
            let light = LAMP.polarized().onto(&Mirror::dielectric(&[eta], cos, 0.0)).stokes_at(0);
            assert!(is_light(light, 1e-7) && light[0] <= 1.0, "{eta} {cos}: {light:?}");
        }
    }
    for (eta, cos) in [(f32::NAN, 0.5), (1.5, f32::NAN), (1.0, f32::NAN), (0.0, f32::NAN)] {
        assert!(sees(eta, cos).is_nan(), "{eta} {cos}");
    }
    assert!(LAMP.polarized().stokes_at(1)[0].is_nan(), "there is no second bin");
}

#[test]
fn a_plate_of_one_path_difference_is_its_mean_over_the_bin() {
    // 137.5 nm are a quarter wave at 550 nm, but for what the bin of 10 nm is wide.
    let plate = Retarder::<1, Bins<545, 555>>::from_path_difference(137.5, 0.125);
    let (lamp, sheet) = (Light::<1, Bins<545, 555>>::flat(1.0), Polarizer::ideal(0.0));
    let light = lamp.polarized().through(&sheet).through(&plate);
    let [_, q, _, v] = light.stokes_at(0);
    assert!(q.abs() < 1e-4 && (v - 0.5).abs() < 1e-4, "{q} {v}");
}

/// Colors of high order are white.
#[test]
fn a_thick_plate_between_crossed_sheets_passes_a_quarter() {
    let eye: Observer<3, 31, Power> = CIE_1931.fold(Curve::Step);
    let (sun, first, second) = (Light::<31>::flat(1.0), Polarizer::ideal(0.0), Polarizer::ideal(0.25));
    let [_, white, _] = eye.sees(&sun);
    for path_nm in [3e4, 1e5, 1e6, 1e9, f32::MAX] {
        let plate = Retarder::from_path_difference(path_nm, 0.125);
        let light = sun.polarized().through(&first).through(&plate).through(&second);
        let [_, y, _] = eye.sees(light.ignoring_polarization());
        assert!((y / white - 0.25).abs() < 0.01, "{path_nm}: {}", y / white);
    }
}

/// Bins that end at no wavelength at all.
#[test]
fn a_plate_on_a_grid_from_zero_is_light() {
    for path_nm in [0.0, 1.0, 1e3, 1e30, f32::MAX] {
        let plate = Retarder::<2, Bins<0, 700>>::from_path_difference(path_nm, 0.1);
        let turned = plate.mueller().turn(0, [1.0, 0.6, 0.0, 0.8]);
        assert!(is_light(turned, 1e-6), "{path_nm}: {turned:?}");
    }
}

#[test]
fn no_axis_is_too_large_and_no_transmittance_too_small() {
    let lamp = [1.0, 0.6, 0.0, 0.8];
    for axis in [f32::MAX, f32::MIN, 1e30, 8_388_608.0] {
        let level = Polarizer::<1, One>::ideal(0.0).mueller().turn(0, lamp);
        assert_eq!(Polarizer::<1, One>::ideal(axis).mueller().turn(0, lamp), level, "{axis}: whole turns");
    }
    let flat = Reflectance::<1, One>::flat;
    let sheet = |along: f32, across: f32| Polarizer::new(&flat(along), &flat(across), 0.0);
    assert_eq!(sheet(-0.1, 0.5), sheet(0.0, 0.5));
    assert_eq!(sheet(0.5, -0.1), sheet(0.5, 0.0));
    for same in [1e-30f32, 1e-20, 1e-10, 1.0, 1e20, 1e38, f32::MAX] {
        let [_, _, u, _] = sheet(same, same).mueller().turn(0, [1.0, 0.0, 1.0, 0.0]);
        assert!((u / same - 1.0).abs() < 3e-7, "{same}: {u}");
    }
    assert!(sheet(f32::NAN, 0.5).mueller().turn(0, lamp)[0].is_nan());
}

#[test]
fn no_metal_reflects_more_than_all() {
    for n in 1..200 {
        for c in 0..200 {
            let (eta, cos) = (n as f32 / 200.0, c as f32 / 200.0);
            let mirror = Mirror::<1, One>::conductor(&Spectrum::flat(eta), &Spectrum::flat(0.0), cos, 0.0);
            for q in [1.0, -1.0] {
                let [i, ..] = mirror.mueller().turn(0, [1.0, q, 0.0, 0.0]);
                assert!(i <= 1.0, "{eta} {cos} {q}: {i}");
            }
        }
    }
}

/// What can stand in the path of polarized light, as data.
#[derive(Clone, Copy, Debug)]
enum Part {
    Mirror { eta: f32, cos: f32, axis: f32 },
    Polarizer { along: f32, across: f32, axis: f32 },
    Retarder { retardance: f32, axis: f32 },
}

fn part() -> impl Strategy<Value = Part> {
    let axis = || -1.0f32..1.0;
    prop_oneof![
        (0.3f32..3.0, 0.0f32..1.0, axis()).prop_map(|(eta, cos, axis)| Part::Mirror { eta, cos, axis }),
        (0.0f32..1.0, 0.0f32..1.0, axis()).prop_map(|(along, across, axis)| Part::Polarizer {
            along,
            across,
            axis
        }),
        (-1.0f32..1.0, axis()).prop_map(|(retardance, axis)| Part::Retarder { retardance, axis }),
    ]
}

impl Part {
    fn turn(self, light: [f32; 4]) -> [f32; 4] {
        match self {
            Part::Mirror { eta, cos, axis } => {
                Mirror::<1, One>::dielectric(&[eta], cos, axis).mueller().turn(0, light)
            }
            Part::Polarizer { along, across, axis } => {
                let [along, across] = [along, across].map(Reflectance::<1, One>::flat);
                Polarizer::new(&along, &across, axis).mueller().turn(0, light)
            }
            Part::Retarder { retardance, axis } => {
                Retarder::<1, One>::flat(retardance, axis).mueller().turn(0, light)
            }
        }
    }

    fn matrix(self) -> Matrix {
        match self {
            Part::Mirror { eta, cos, axis } => {
                let (s, p) = fresnel(eta.into(), f64::from(cos).acos().to_degrees());
                element(s, p, axis.into())
            }
            Part::Polarizer { along, across, axis } => {
                element((f64::from(along).sqrt(), 0.0), (f64::from(across).sqrt(), 0.0), axis.into())
            }
            Part::Retarder { retardance, axis } => {
                let (sin, cos) = (TAU * f64::from(retardance)).sin_cos();
                element((1.0, 0.0), (cos, -sin), axis.into())
            }
        }
    }
}

/// Whether no more of the light is polarized than there is, but for rounding: a share of the light that came
/// in, since next to extinction what is left is a difference.
fn is_light([i, q, u, v]: [f32; 4], rounding: f64) -> bool {
    let [i, q, u, v] = [i, q, u, v].map(f64::from);
    i >= -rounding && (q * q + u * u + v * v).sqrt() <= i + rounding
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn light_stays_light_however_long_the_path(parts in prop::collection::vec(part(), 1..8)) {
        let (mut light, mut rounding) = ([1.0f32, 0.0, 0.0, 0.0], 0.0);
        for part in parts {
            rounding += 3e-7 * f64::from(light[0].abs());
            light = part.turn(light);
            prop_assert!(is_light(light, rounding), "{part:?} {light:?}");
            prop_assert!(f64::from(light[0]) <= 1.0 + rounding);
        }
    }

    #[test]
    fn every_element_is_its_matrix(part in part(), angle in 0.0f32..1.0, degree in 0.0f32..1.0) {
        // Beside the critical angle the phase is what f32 makes of the angle.
        if let Part::Mirror { eta, cos, .. } = part {
            let g = f64::from(eta).powi(2) - 1.0 + f64::from(cos).powi(2);
            prop_assume!(g.abs() > 1e-2);
        }
        let (sin, cos) = (TAU * f64::from(angle)).sin_cos();
        let light = [1.0, degree * cos as f32, degree * sin as f32 * 0.8, degree * sin as f32 * 0.6];
        let exact = times(&part.matrix(), light.map(f64::from));
        for (got, exact) in part.turn(light).into_iter().zip(exact) {
            prop_assert!((f64::from(got) - exact).abs() < 4e-6, "{part:?}: {got} {exact}");
        }
    }

    #[test]
    fn folding_what_polarizes_is_walking_through_it(
        eta in 1.1f32..2.5, cos in 0.05f32..1.0, axis in 0.0f32..1.0, sheet in 0.0f32..1.0, plate in 50.0f32..900.0,
        values in prop::collection::vec(0.05f32..1.0, 31),
    ) {
        let mut glass = Reflectance::<31>::flat(0.0);
        glass.values_mut().copy_from_slice(&values);
        let lamp = Light::<31>::flat(1.0);
        let (lake, sheet) = (Mirror::dielectric(&[eta; 31], cos, axis), Polarizer::ideal(sheet));
        let plate = Retarder::from_path_difference(plate, 0.1);
        let eye: Observer<3, 31, Power> = CIE_1931.fold(Curve::Step);
        let path = lamp.polarized().onto(&lake).through(&plate).through(&glass).through(&sheet);
        let walked = eye.sees(path.ignoring_polarization());
        let behind = eye.polarized().through_polarizer(&sheet).through(&glass).through_retarder(&plate);
        let folded = behind.looking_at_mirror(&lake).unpolarized_light().sees(&lamp);
        // Next to extinction the difference of two roundings is left: of what the mirror reflects.
        let all = eye.through(&lake.ignoring_polarization()).sees(&lamp);
        for ((walked, folded), all) in walked.into_iter().zip(folded).zip(all) {
            prop_assert!((walked - folded).abs() <= 4e-7 * all, "{walked} {folded} of {all}");
        }
    }
}

/// The largest error over a lattice of elements, against naive matrices.
#[test]
fn elements_are_their_matrices_to_rounding() {
    let mut check: Check = check("polarized light against matrices of 4 by 4");
    for axis in 0..12 {
        for size in 0..10 {
            let (axis, size) = (axis as f32 / 12.0, size as f32 / 10.0);
            let parts = [
                Part::Mirror { eta: 1.5, cos: 0.05 + 0.9 * size, axis },
                Part::Polarizer { along: 0.9, across: size * 0.8, axis },
                Part::Retarder { retardance: size, axis },
            ];
            for part in parts {
                let light = [1.0f32, 0.5, -0.3, 0.7];
                let exact = times(&part.matrix(), light.map(f64::from));
                for (got, exact) in part.turn(light).into_iter().zip(exact) {
                    check.add(&format!("{part:?}"), got, exact);
                }
            }
        }
    }
    check.tight_over_all();
}
