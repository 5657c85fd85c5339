//! Chromaticity from color temperature and Duv: the f64 integral, searched for the worst, and the way back.

use model::allowed::check;
use model::cct::{planckian_uv, uv_at};
use model::noise::Noise;
use nanospectra::color::{Uv1960, Xy};

/// Black bodies of the golden table, and illuminant A by its definition.
#[test]
fn published_points_of_the_locus_are_found() {
    let a = Uv1960::planckian(1.4388 / 1.4350 * 2848.0).expect("a black body").xy();
    assert!((a.x - 0.447_58).abs() < 1.5e-5 && (a.y - 0.407_45).abs() < 1.5e-5, "{a}");
    let mut compared = 0;
    for row in model::csv::golden("02_planckian_locus").rows() {
        let [kelvin, u, v] = row.numbers(["T", "u", "v"]);
        let Some(found) = Uv1960::planckian(kelvin as f32) else {
            assert!(!(1000.0..=1e6).contains(&kelvin), "{kelvin} K");
            continue;
        };
        assert!((f64::from(found.u) - u).abs() < 3e-7 && (f64::from(found.v) - v).abs() < 3e-7, "{kelvin} K");
        compared += 1;
    }
    assert!(compared > 20, "{compared}");
}

/// u and v off, and the color temperature in mired on the way back.
fn errors(mired: f64, duv: f64) -> [f64; 3] {
    let (cct_k, duv) = ((1e6 / mired) as f32, duv as f32);
    let found = Uv1960::of_cct(cct_k, duv).expect("in the band");
    let exact = uv_at(f64::from(cct_k), f64::from(duv));
    let off = (f64::from(found.u) - exact[0]).abs().max((f64::from(found.v) - exact[1]).abs());
    let Some((back_k, back_duv)) = found.cct().near() else {
        // At the ends of the band rounding may lead out of it.
        assert!(!(1.001..999.9).contains(&mired), "{mired} mired, Duv {duv}");
        return [off, 0.0, 0.0];
    };
    [off, (1e6 / f64::from(back_k) - 1e6 / f64::from(cct_k)).abs(), f64::from((back_duv - duv).abs())]
}

#[test]
fn every_point_of_the_band_is_found_at_its_worst() {
    let mut on = check("uv of black bodies, searched");
    let mut all =
        ["uv of CCT and Duv, searched", "CCT of what was made of it, mired", "Duv of what was made of it"]
            .map(check);
    let mut noise = Noise(1960);
    let mut worst = [(0.0, 500.0, 0.0); 4];
    let mut judge = |mired: f64, duv: f64, worst: &mut [(f64, f64, f64); 4]| {
        let (mired, duv) = (mired.clamp(1.0, 1000.0), duv.clamp(-0.0499, 0.0499));
        let place = format!("{mired} mired, Duv {duv}");
        let black = errors(mired, 0.0)[0];
        on.value(&place, black, 0.0);
        let found = errors(mired, duv);
        all.iter_mut().zip(found).for_each(|(check, found)| check.value(&place, found, 0.0));
        for (worst, found) in worst.iter_mut().zip(found.into_iter().chain([black])) {
            if found > worst.0 {
                *worst = (found, mired, duv);
            }
        }
    };
    for k in 0..=2000 {
        let mired = 1.0 + 999.0 * (f64::from(k) / 2000.0).powi(2);
        for duv in [-0.05, 0.05, 0.1 * noise.uniform() - 0.05] {
            judge(mired, duv, &mut worst);
        }
    }
    for k in 0..4000 {
        let (_, mired, duv) = worst[k % 4];
        let reach = 0.995_f64.powi(k as i32);
        let step = f64::from(noise.offset());
        judge(mired + 20.0 * reach * step, duv + 0.02 * reach * f64::from(noise.offset()), &mut worst);
    }
    on.tight_over_all();
    all.into_iter().for_each(|check| check.tight_over_all());
}

#[test]
fn what_is_not_in_the_band_is_none_and_nan_stays_nan() {
    for (cct_k, duv) in
        [(999.0, 0.0), (1.01e6, 0.0), (-1.0, 0.0), (0.0, 0.0), (5000.0, 0.0501), (5000.0, -0.0501)]
    {
        assert_eq!(Uv1960::of_cct(cct_k, duv), None, "{cct_k} K, Duv {duv}");
    }
    for (cct_k, duv) in [(1000.0, 0.05), (1e6, -0.05), (1000.0, 0.0), (1e6, 0.0)] {
        assert!(Uv1960::of_cct(cct_k, duv).is_some_and(|uv| uv.u.is_finite() && uv.v.is_finite()));
    }
    assert!(Uv1960::of_cct(f32::NAN, 0.0).is_some_and(|uv| uv.u.is_nan()));
    assert!(Uv1960::of_cct(5000.0, f32::NAN).is_some_and(|uv| uv.u.is_nan()));
}

#[test]
fn the_diagrams_convert_into_each_other() {
    let a = Xy::new(0.447_58, 0.407_45);
    let (there, prime) = (a.uv1960(), a.uv1976());
    let back = there.xy();
    assert!((back.x - a.x).abs() < 1e-7 && (back.y - a.y).abs() < 1e-7, "{back}");
    assert_eq!(there.uv1976(), prime);
    let locus = planckian_uv(2855.54);
    assert!((f64::from(there.u) - locus[0]).abs() < 1.5e-5);
}
