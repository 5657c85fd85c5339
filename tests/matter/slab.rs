//! A colored window: its two faces and what goes to and fro between them, beam by beam.
#![cfg(feature = "libm")]

use model::allowed::{Singles, check};
use model::check::EPS;
use model::fresnel::reflectances;
use nanospectra::matter::{
    Absorber, AbsorberError, Dielectric, Glass, N_BK7, Polarizer, PowerShares, Slab, internal_transmittance,
};
use nanospectra::observer::CIE_1931;
use nanospectra::{Bins, Curve, Light, Observer, Power, Reflectance, Spectrum};

fn slab<const N: usize>(index: [f32; N], per_m: [f32; N], thickness_m: f32) -> Slab<N> {
    let absorber = Absorber::from_per_m(per_m).expect("coefficients");
    Slab { index: Spectrum::from_bins(index), absorber, thickness_m }
}

/// Reflected, transmitted, absorbed.
fn all<const N: usize>(slab: &Slab<N>, cos: f32) -> [Reflectance<N>; 3] {
    [slab.reflectance(cos), slab.transmittance(cos), slab.absorbed(cos)]
}

/// One beam followed from face to face until nothing is left of it.
fn followed(face: f64, inside: f64) -> [f64; 3] {
    let [mut reflected, mut transmitted, mut absorbed] = [face, 0.0, 0.0];
    let mut beam = 1.0 - face;
    while beam > 1e-15 {
        for leaves in [&mut transmitted, &mut reflected] {
            absorbed += beam * (1.0 - inside);
            *leaves += beam * inside * (1.0 - face);
            beam *= inside * face;
        }
    }
    [reflected, transmitted, absorbed]
}

/// s and p, each reflected, transmitted and absorbed.
fn model(index: f32, per_m: f32, thickness: f32, cos: f32) -> [[f64; 3]; 2] {
    let [n, sigma, d, cos] = [index, per_m, thickness, cos].map(f64::from);
    let cos_t = (1.0 - (1.0 - cos * cos) / (n * n)).sqrt();
    let inside = (-sigma * d / cos_t).exp();
    let (s, p) = reflectances([n, 0.0], cos);
    [followed(s, inside), followed(p, inside)]
}

#[test]
fn half_gray_glass_has_the_textbooks_numbers() {
    let tint = Absorber::from_transmittance(&Reflectance::<4>::flat(0.5), 3e-3).expect("a glass");
    let window = Slab { index: Spectrum::flat(1.5), absorber: tint, thickness_m: 3e-3 };
    let [r, t, a] = all(&window, 1.0).map(|share| share.values()[0]);
    assert!((t - 0.460_98).abs() < 5e-6 && (r - 0.049_22).abs() < 5e-6, "{r} {t}");
    assert!((a - 0.489_80).abs() < 5e-6, "{a}");
    let clear = slab([1.5], [0.0], 3e-3);
    assert!((clear.transmittance(1.0).values()[0] - 12.0 / 13.0).abs() < 1e-7); // (1 - R) / (1 + R)
    assert_eq!(clear.absorbed(1.0).values(), &[0.0]);
}

#[test]
fn all_beams_to_and_fro_are_counted() {
    let (mut shares, mut kept, mut sums) =
        (check("slabs, reflected and transmitted"), check("slabs, absorbed"), check("slabs, all shares"));
    let mut slabs = 0;
    for index in [1.0f32, 1.000_01, 1.1, 1.33, 1.5, 1.52, 2.4, 30.0] {
        for per_m in [0.0f32, 1e-3, 7.0, 170.0, 460.0, 1000.0, 3e4] {
            for step in 1..=64 {
                let cos = step as f32 / 64.0;
                let window = slab([index], [per_m], 4e-3);
                let place = format!("n {index}, {per_m} per m, cos {cos}");
                let exact = model(index, per_m, 4e-3, cos);
                let picks = [
                    |s: PowerShares| s.reflected,
                    |s: PowerShares| s.transmitted,
                    |s: PowerShares| s.absorbed,
                ];
                for (k, (pick, mean)) in picks.into_iter().zip(all(&window, cos)).enumerate() {
                    let check = if k == 2 { &mut kept } else { &mut shares };
                    for (got, exact) in window.components(cos, pick).iter().zip(&exact) {
                        check.add(&place, got.values()[0], exact[k]);
                    }
                    check.add(&place, mean.values()[0], 0.5 * (exact[0][k] + exact[1][k]));
                }
                let total: f64 = all(&window, cos).iter().map(|share| f64::from(share.values()[0])).sum();
                sums.value(&place, total, 1.0);
                slabs += 1;
            }
        }
    }
    shares.tight(slabs * 6);
    kept.tight(slabs * 3);
    sums.tight(slabs);
}

#[test]
fn faint_absorption_and_faint_light_keep_their_digits() {
    let mut check = check("slabs, faint shares, in eps");
    let mut add = |place: &str, got: f32, exact: f64| {
        check.in_eps(place, got, exact);
    };
    // A depth so small that what is kept is E a / (E + R a) = a.
    for sigma in [1e-3f32, 1e-6, 1e-12, 1e-24] {
        let kept = slab([1.5], [sigma], 1e-3).absorbed(1.0).values()[0];
        let a = -(-f64::from(sigma) * f64::from(1e-3f32)).exp_m1();
        add(&format!("{sigma}"), kept, 0.96 * a / (0.96 + 0.04 * a));
    }
    // Clear and grazing, or nearly closed: E / (1 + R) gets through of each component.
    let through = |index: f32, cos: f32| {
        slab([index], [0.0], 1e-3).components(cos, |shares| shares.transmitted).map(|share| share.values()[0])
    };
    for cos in [1e-3f32, 1e-6, 1e-12, 1e-24] {
        let (s, p) = model::fresnel::absorbed([1.5, 0.0], f64::from(cos));
        for (got, entering) in through(1.5, cos).into_iter().zip([s, p]) {
            add(&format!("cos {cos}"), got, entering / (2.0 - entering));
        }
    }
    for index in [1e3f32, 1e6, 1e9] {
        let (s, _) = model::fresnel::absorbed([f64::from(index), 0.0], 1.0);
        add(&format!("n {index}"), through(index, 1.0)[0], s / (2.0 - s));
    }
    check.tight(15);
}

#[test]
fn the_ends_are_defined() {
    let at = |index: f32, per_m: f32, thickness: f32, cos: f32| {
        all(&slab([index], [per_m], thickness), cos).map(|share| share.values()[0])
    };
    // Opaque: what the first face lets in stays.
    let [r, t, a] = at(1.5, f32::INFINITY, 1e-3, 1.0);
    assert!((r - 0.04).abs() < 1e-8 && t == 0.0 && (a - 0.96).abs() < 1e-7, "{r} {t} {a}");
    // Grazing: a mirror, but for n = 1, where there is no face and the way through is endless.
    assert_eq!(at(1.5, 10.0, 1e-3, 0.0), [1.0, 0.0, 0.0]);
    assert_eq!(at(1.0, 10.0, 1e-3, 0.0), [0.0, 0.0, 1.0]);
    assert_eq!(at(1.0, 0.0, 1e-3, 0.0), [0.0, 1.0, 0.0]);
    assert_eq!(at(1.0, 10.0, 0.0, 0.0), [0.0, 1.0, 0.0]);
    // A gap of air in glass, beyond the critical angle (41.8 degrees); the evanescent field does not reach
    // across.
    assert_eq!(at(1.0 / 1.5, 0.0, 1e-3, 0.7), [1.0, 0.0, 0.0]);
    // Below it as from the outside: the face is the same.
    assert!((at(1.0 / 1.5, 0.0, 1e-3, 1.0)[1] - 12.0 / 13.0).abs() < 1e-6);
    // A cosine beyond 0..=1 is the nearer end.
    assert_eq!(at(1.5, 10.0, 1e-3, 1.5), at(1.5, 10.0, 1e-3, 1.0));
    assert_eq!(at(1.5, 10.0, 1e-3, -1.0), at(1.5, 10.0, 1e-3, 0.0));
    for cos in [0.0f32, 1e-30, 1e-6, 0.5, 1.0] {
        assert!(
            at(1.5, 10.0, -1e-3, cos).iter().all(|share| share.is_nan()),
            "a negative thickness at {cos}"
        );
        for k in 0..3 {
            let mut given = [1.5, 10.0, 1e-3, cos];
            given[[0, 2, 3][k]] = f32::NAN;
            let [index, per_m, thickness, cos] = given;
            let shares = at(index, per_m, thickness, cos);
            assert!(shares.iter().all(|share| share.is_nan()), "NaN for {k}: {shares:?}");
        }
        for (index, per_m, thickness) in [0.0f32, 1e-20, 0.5, 0.999_999_9, 1.0, 1.000_000_1, 1e15, f32::MAX]
            .into_iter()
            .flat_map(|n| [0.0, 1e-38, 1.0, 1e38].map(|sigma| (n, sigma)))
            .flat_map(|(n, sigma)| [0.0, 1e-40, 1.0, 1e38].map(|d| (n, sigma, d)))
        {
            let shares = at(index, per_m, thickness, cos);
            let place = format!("n {index}, {per_m} per m, {thickness} m, cos {cos}: {shares:?}");
            assert!(shares.iter().all(|share| (0.0..=1.0).contains(share)), "{place}");
            assert!((shares.iter().sum::<f32>() - 1.0).abs() < 4e-7, "{place}");
        }
    }
}

#[test]
fn internal_transmittance_comes_back_from_the_external_one() {
    let mut inverse = check("internal transmittance, in eps");
    for index in [1.0f32, 1.33, 1.5, 1.9, 4.0, 1e3] {
        let (face, _) = reflectances([f64::from(index), 0.0], 1.0);
        for internal in [1e-12, 1e-3, 0.1, 0.5, 0.8, 0.99, 0.999_999] {
            // In f64 from the f32 that is given: the root of the quadratic equation by bisection.
            let external = followed(face, internal)[1] as f32;
            let (mut low, mut high) = (0.0f64, 1.0);
            for _ in 0..80 {
                let middle = 0.5 * (low + high);
                let through = (1.0 - face).powi(2) * middle / (1.0 - (face * middle).powi(2));
                *(if through < f64::from(external) { &mut low } else { &mut high }) = middle;
            }
            let got = internal_transmittance(&Reflectance::<1>::flat(external), &Spectrum::flat(index));
            let got = f64::from(got.expect("passive").values()[0]);
            inverse.value(&format!("n {index}, {internal}"), (got - low).abs() / (low * EPS), 0.0);
        }
    }
    inverse.tight_over_all();
}

#[test]
fn measured_glass_is_used_at_another_thickness_and_angle() {
    let index = N_BK7.indices::<16, Bins<380, 730>>().expect("indices");
    let tint = Reflectance::from_bins(std::array::from_fn(|k| 0.2 + 0.045 * k as f32));
    let window = Slab::from_transmittance(&tint, index, 2e-3).expect("a filter");
    for (got, measured) in window.transmittance(1.0).values().iter().zip(tint.values()) {
        assert!((got - measured).abs() < 3e-7, "{got} for {measured}");
    }
    // Twice as thick is darker by the internal transmittance and a little less.
    let thicker = Slab { thickness_m: 4e-3, ..window };
    let internal = internal_transmittance(&tint, &index).expect("passive");
    for ((thick, thin), internal) in
        thicker.transmittance(1.0).values().iter().zip(tint.values()).zip(internal.values())
    {
        let ratio = thick / (thin * internal);
        assert!(ratio < 1.0 && ratio > 1.0 - 2.1e-3, "{ratio}");
    }
    for (got, index) in
        internal_transmittance(&tint, &index).iter().flat_map(Spectrum::values).zip(index.values())
    {
        assert!(*got < 1.0 && *index > 1.5);
    }
}

#[test]
fn what_no_glass_lets_through_is_refused() {
    let of = |external: f32, index: f32| {
        let external = Reflectance::<2>::from_bins([0.5, external]);
        internal_transmittance(&external, &Spectrum::flat(index)).map(|tau| tau.values()[1])
    };
    assert_eq!(of(0.95, 1.5), Err(AbsorberError::OutOfRange { bin: 1 }));
    assert_eq!(of(-1e-3, 1.5), Err(AbsorberError::OutOfRange { bin: 1 }));
    assert_eq!(of(f32::NAN, 1.5), Err(AbsorberError::OutOfRange { bin: 1 }));
    assert_eq!(of(0.0, 1.5), Ok(0.0));
    assert_eq!(of(1.0, 1.0), Ok(1.0));
    // Clear glass by its own formula, and rounding beyond it.
    assert!(of(12.0 / 13.0, 1.5).is_ok_and(|tau| (tau - 1.0).abs() < 3e-7));
    assert_eq!(of(12.0 / 13.0 + 5e-7, 1.5), Ok(1.0));
    let bin_0 = Err(AbsorberError::OutOfRange { bin: 0 });
    assert_eq!(of(0.0, 0.0).map(|_| ()), bin_0, "no index");
    assert_eq!(of(0.5, f32::NAN).map(|_| ()), bin_0);
    let plate = Slab::<2>::from_transmittance(&Reflectance::flat(0.5), Spectrum::flat(1.5), 0.0);
    assert_eq!(plate, Err(AbsorberError::Amount));
}

#[test]
fn a_tilted_window_polarizes() {
    let cos = 0.342_020_14; // 70 degrees
    let pane = slab([1.5; 31], [50.0; 31], 4e-3);
    let [s, p] = pane.components(cos, |shares| shares.transmitted);
    let tilted = Polarizer::new(&p, &s, 0.25);
    let sun = Light::flat(1.0);
    let [i, q, u, v] = sun.polarized().through(&tilted).stokes_at(15);
    assert!((i - pane.transmittance(cos).values()[15]).abs() < 1e-7);
    assert!(q < -0.1 * i && u.abs() < 1e-6 && v == 0.0, "{q} {u} {v}");
    // U of light polarized askew, as a field: both amplitudes of each beam, and beams add as powers.
    let [sigma, d] = [50.0f64, f64::from(4e-3f32)];
    let inside = (-sigma * d / (1.0 - 0.883_022_2 / 2.25_f64).sqrt()).exp();
    let face = Dielectric::new(1.5).fresnel(cos);
    let (rs, rp) = (f64::from(face.s), f64::from(face.p));
    let exact = (1.0 - rs) * (1.0 - rp) * inside / (1.0 - rs * rp * inside * inside);
    let taken = f64::from(s.values()[0] * p.values()[0]).sqrt();
    assert!(taken > exact && taken < 1.03 * exact, "{taken} for {exact}");
}

#[test]
fn a_window_is_a_filter_in_a_path() {
    static EYE: Observer<3, 31, Power> = CIE_1931.fold(Curve::Step);
    let (lamp, paper) = (Light::flat(1.0), Reflectance::flat(0.8));
    let behind = |window: &Slab<31>| {
        let through = window.transmittance(1.0);
        EYE.sees(lamp.onto(&paper).through(&through))
    };
    let (clear, tinted) =
        (behind(&slab([1.5; 31], [0.0; 31], 4e-3)), behind(&slab([1.5; 31], [200.0; 31], 4e-3)));
    let bare = EYE.sees(lamp.onto(&paper));
    assert!((clear[1] / bare[1] - 12.0 / 13.0).abs() < 1e-6);
    assert!((f64::from(tinted[1] / bare[1]) - followed(0.04, (-0.8f64).exp())[1]).abs() < 1e-6);
}
