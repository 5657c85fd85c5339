//! Correlated color temperature: every point that has one gets it, every other point gets a reason.

use model::allowed::check;
use model::cct::{cct as nearest, planckian};
use model::noise::Noise;
use model::planck::C2_CIE;
use nanospectra::color::{Cct, Uv1960, Xy, Xyz};

/// The point at a distance from the locus, of which `planckian` has given place and direction.
fn beside((place, direction): ([f64; 2], [f64; 2]), duv: f64) -> Uv1960 {
    let ([u, v], [du, dv]) = (place, direction);
    let length = du.hypot(dv);
    Uv1960 { u: (u + duv * dv / length) as f32, v: (v - duv * du / length) as f32 }
}

#[test]
fn every_temperature_from_1000_to_a_million_kelvin_is_found_at_every_duv() {
    let (mut mireds, mut duvs) = (check("CCT of the whole band, mired"), check("Duv of the whole band"));
    // Steps of 1/4 mired; at the hot end, where kelvins are dear, finer.
    let all =
        (0..=3996).map(|k| 1.0 + f64::from(k) * 0.25).chain((1..100).map(|k| 1.0 + f64::from(k) * 0.05));
    for mired in all {
        let locus = planckian(1e6 / mired, C2_CIE);
        for step in -20..=20 {
            let duv = f64::from(step) * 0.0025;
            let found = beside(locus, duv).cct();
            let place = format!("{mired} mired, Duv {duv}");
            let Cct::Near { cct_k, duv: distance } = found else { panic!("{place}: {found:?}") };
            mireds.value(&place, 1e6 / f64::from(cct_k), mired);
            duvs.value(&place, distance.into(), duv);
        }
    }
    mireds.tight_over_all();
    duvs.tight_over_all();
}

#[test]
fn beyond_the_band_there_is_a_reason_and_no_number() {
    for mired in [1.5, 10.0, 100.0, 153.8, 192.6, 350.0, 700.0, 990.0] {
        let locus = planckian(1e6 / mired, C2_CIE);
        for duv in [0.0501, 0.06, 0.08, 0.0999, -0.0501, -0.06, -0.08, -0.0999, -0.15, 0.2] {
            assert_eq!(beside(locus, duv).cct(), Cct::OffLocus, "{mired} mired, Duv {duv}");
        }
        for duv in [0.0499, -0.0499] {
            assert!(beside(locus, duv).cct().near().is_some(), "{mired} mired, Duv {duv}");
        }
    }
    for duv in [-0.04, -0.01, 0.0, 0.01, 0.04] {
        let at = |mired: f64| beside(planckian(1e6 / mired, C2_CIE), duv).cct();
        assert_eq!(at(1000.5), Cct::TooCold, "999.5 K, Duv {duv}");
        assert_eq!(at(1100.0), Cct::TooCold, "909 K, Duv {duv}");
        assert_eq!(at(0.9), Cct::TooHot, "1.1e6 K, Duv {duv}");
        assert_eq!(at(0.05), Cct::TooHot, "2e7 K, Duv {duv}");
    }
    // Bluer than any black body; the primaries of sRGB; the center of curvature near 5200 K.
    assert_eq!(Xy::new(0.235, 0.225).uv1960().cct(), Cct::TooHot);
    for (x, y) in [(0.64, 0.33), (0.30, 0.60), (0.15, 0.06)] {
        assert_eq!(Xy::new(x, y).uv1960().cct().near(), None, "{x}, {y}");
    }
    assert_eq!(beside(planckian(5192.0, C2_CIE), -0.1001).cct(), Cct::OffLocus);
}

#[test]
fn what_is_no_number_has_no_temperature() {
    let at = |u, v| Uv1960 { u, v }.cct();
    for (u, v) in [(f32::NAN, 0.3), (0.2, f32::NAN), (f32::NAN, f32::NAN)] {
        let Cct::Near { cct_k, duv } = at(u, v) else { panic!("NaN was hidden: {:?}", at(u, v)) };
        assert!(cct_k.is_nan() && duv.is_nan());
    }
    for (cct_k, duv) in [(f32::NAN, 0.01), (6500.0, f32::NAN), (f32::INFINITY, 0.0)] {
        let text = Cct::Near { cct_k, duv }.to_string();
        assert_eq!(text, "not a color: its chromaticity is not a number");
    }
    let far = [f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN, 1e30, -1e30, 1e15, 7.0, -3.0];
    for a in far {
        for b in far {
            assert_eq!(at(a, b).near(), None, "({a}, {b})");
        }
        for (u, v) in [(a, 0.3), (0.2, a), (a, 0.0), (0.0, a)] {
            assert_eq!(at(u, v).near(), None, "({u}, {v})");
        }
    }
}

/// Is the outcome what the exact nearest point says? Within `slack` of a limit either side will do.
fn agrees(uv: Uv1960, outcome: Cct) -> Result<(), String> {
    let exact = nearest([uv.u.into(), uv.v.into()]);
    let (mired, distance) = (1e6 / exact.cct_k, exact.duv.abs());
    let inside = |slack: f64| (1.0 - slack..1000.0 + slack).contains(&mired) && distance < 0.05 + slack / 1e4;
    let right = match outcome {
        Cct::Near { cct_k, duv } => {
            inside(0.05)
                && (1e6 / f64::from(cct_k) - mired).abs() < 0.05
                && (f64::from(duv) - exact.duv).abs() < 1e-6
        }
        Cct::OffLocus => distance > 0.05 - 5e-6 || !inside(0.0),
        Cct::TooCold => mired > 1000.0 - 0.05,
        Cct::TooHot => mired < 1.0 + 0.05,
        _ => false,
    };
    let must_be_near = inside(-0.05);
    if right && (!must_be_near || outcome.near().is_some()) {
        return Ok(());
    }
    Err(format!("{uv:?}: {outcome:?}, the nearest point is {mired} mired, Duv {}", exact.duv))
}

#[test]
fn random_points_get_the_nearest_temperature_or_a_reason() {
    let mut noise = Noise(0x9e37_79b9_7f4a_7c15);
    let (mut near, mut checked, mut wrong) = (0, 0, Vec::new());
    let points = if cfg!(debug_assertions) { 100_000 } else { 1_000_000 };
    for k in 0..points {
        let uv = match k % 4 {
            // Any bits at all: huge, tiny, infinite, NaN.
            0 => Uv1960 { u: f32::from_bits(noise.bits()), v: f32::from_bits(noise.bits()) },
            // The diagram and around it.
            1 => Uv1960 { u: noise.between(-0.2, 0.8), v: noise.between(-0.2, 0.6) },
            2 => Uv1960 { u: noise.between(0.1, 0.6), v: noise.between(0.2, 0.45) },
            // Near the end at infinite temperature.
            _ => Uv1960 { u: noise.between(0.13, 0.23), v: noise.between(0.21, 0.32) },
        };
        let outcome = uv.cct();
        if let Cct::Near { cct_k, duv } = outcome {
            if uv.u.is_nan() || uv.v.is_nan() {
                assert!(cct_k.is_nan() && duv.is_nan(), "{uv:?}: {outcome:?}");
                continue;
            }
            near += 1;
            let sane = (999.9..1.0102e6).contains(&cct_k) && duv.abs() < 0.05 + 1e-6;
            assert!(sane, "{uv:?}: {outcome:?}");
        }
        // The exact search takes half a millisecond: not for every point.
        let in_the_diagram = uv.u.abs() < 10.0 && uv.v.abs() < 10.0;
        if in_the_diagram && k % 401 < 4 {
            checked += 1;
            wrong.extend(agrees(uv, outcome).err());
        }
    }
    println!("{near} of {points} have a temperature, {checked} compared with the exact search");
    assert!(near > points / 10 && checked > points / 200, "{near} {checked}");
    assert!(
        wrong.is_empty(),
        "{} of {checked} are wrong:\n{}",
        wrong.len(),
        wrong[..wrong.len().min(20)].join("\n")
    );
}

#[test]
fn values_are_shown_with_the_digits_that_are_asked_for() {
    let white = Xyz::new(95.047, 100.0, 108.883);
    assert_eq!(white.to_string(), "X 95.047 Y 100 Z 108.883");
    let (xy, uv) = (white.xy().expect("a white"), white.uv1976().expect("a white"));
    assert_eq!(format!("{xy:.4}, {uv:.4}"), "x 0.3127 y 0.3290, u' 0.1978 v' 0.4683");
    assert_eq!(format!("{:+.0}", white.lab(white).expect("a white")), "L* +100 a* +0 b* +0");
    assert_eq!(Cct::TooCold.to_string(), "redder than a black body of 1000 K");
    assert_eq!(white.cct(), white.uv1960().map(|uv| uv.cct()));
}
