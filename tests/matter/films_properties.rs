//! What holds for every film, stack, absorber and scattering volume, on ones that nobody chose.
#![cfg(feature = "libm")]

use nanospectra::math::Portable;
use nanospectra::matter::{
    Absorber, Burley, BurleyFit, Dipole, Layer, Medium, PowerShares, Stack, ThinFilm, burley_distance,
};
use nanospectra::{Factor, Nodes, Reflectance, Spectrum};
use proptest::prelude::*;

/// What matter has, and what the types take.
fn index() -> impl Strategy<Value = f32> {
    prop_oneof![1.0f32..4.0, Just(1.0f32), Just(1.5f32), 1e-3f32..1e3]
}

fn cosine() -> impl Strategy<Value = f32> {
    prop_oneof![0.0f32..=1.0, Just(0.0f32), Just(1.0f32), 0.0f32..1e-6, Just(1e-30f32)]
}

fn thickness() -> impl Strategy<Value = f32> {
    prop_oneof![0.0f32..2000.0, Just(0.0f32), 0.0f32..1e8, 0.0f32..1e12, 0.0f32..1e-20]
}

fn layers() -> impl Strategy<Value = [Layer; 5]> {
    let extinction = prop_oneof![Just(0.0f32), 0.0f32..5.0, 0.0f32..1e-6, 0.0f32..1e3];
    let layer = (index(), extinction, thickness())
        .prop_map(|(n, k, thickness_nm)| Layer { medium: Medium { n, k }, thickness_nm });
    prop::array::uniform5(layer)
}

/// All shares between 0 and 1, and nothing lost.
fn whole(shares: PowerShares, tolerance: f32) -> Result<(), TestCaseError> {
    let PowerShares { reflected, transmitted, absorbed } = shares;
    for share in [reflected, transmitted, absorbed] {
        prop_assert!((0.0..=1.0).contains(&share), "{shares:?}");
    }
    let sum = reflected + transmitted + absorbed;
    prop_assert!((sum - 1.0).abs() <= tolerance, "{shares:?}: {sum}");
    Ok(())
}

/// No NaN and nothing negative.
fn sound<const N: usize, G>(spectrum: &Spectrum<Factor, N, G>) -> Result<(), TestCaseError>
where
    G: nanospectra::Grid,
{
    prop_assert!(spectrum.values().iter().all(|v| *v >= 0.0), "{spectrum:?}");
    Ok(())
}

fn finite() -> impl Strategy<Value = f32> {
    use prop::num::f32::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: if cfg!(debug_assertions) { 1_000 } else { 40_000 },
        ..ProptestConfig::default()
    })]

    #[test]
    fn a_film_loses_nothing(n in prop::array::uniform3(index()), d in thickness(), cos in cosine(), nm in 200.0f32..2000.0) {
        for shares in ThinFilm::new(n, d).at(nm, cos) {
            whole(shares, 1e-5)?;
        }
    }

    #[test]
    fn the_mean_of_a_film_loses_nothing(
        n in prop::array::uniform3(index()), d in thickness(), cos in cosine(), nm in 200.0f32..2000.0, width in 0.1f32..200.0,
    ) {
        for shares in ThinFilm::new(n, d).between_with::<Portable>(nm, nm + width, cos) {
            whole(shares, 2e-5)?;
        }
    }

    #[test]
    fn any_thickness_and_wavelength_have_an_answer(
        n in prop::array::uniform3(index()), d in finite(), cos in finite(), nm in finite(),
    ) {
        for shares in ThinFilm::new(n, d.abs()).at(nm.abs().clamp(f32::MIN_POSITIVE, 1e9), cos) {
            whole(shares, 1e-5)?;
        }
    }

    #[test]
    fn a_stack_loses_nothing_but_what_it_absorbs(
        incident in index(), layers in layers(), n in index(), k in prop_oneof![Just(0.0f32), 0.0f32..1e3],
        cos in cosine(), nm in 200.0f32..2000.0,
    ) {
        for shares in (Stack { incident, layers, substrate: Medium { n, k } }).at(nm, cos) {
            whole(shares, 1e-6)?;
        }
    }

    #[test]
    fn a_clear_stack_absorbs_nothing(
        incident in 1.0f32..3.0, media in prop::array::uniform5((1.0f32..4.0, 0.0f32..2000.0)), n in 1.0f32..4.0, cos in 0.05f32..1.0,
    ) {
        let layers = media.map(|(n, thickness_nm)| Layer { medium: Medium { n, k: 0.0 }, thickness_nm });
        for shares in (Stack { incident, layers, substrate: Medium { n, k: 0.0 } }).at(550.0, cos) {
            prop_assert_eq!(shares.absorbed, 0.0);
            whole(shares, 2e-7)?;
        }
    }

    #[test]
    fn light_goes_through_a_film_as_easily_as_back(
        n in prop::array::uniform3(1.0f32..4.0), d in 0.0f32..1e5, cos in 0.01f32..1.0, nm in 200.0f32..2000.0,
    ) {
        let [n0, n1, n2] = n;
        let sine = n0 * (1.0 - cos * cos).sqrt() / n2;
        if sine > 0.99 {
            return Ok(());
        }
        let there = ThinFilm::new(n, d).at(nm, cos);
        let back = ThinFilm::new([n2, n1, n0], d).at(nm, (1.0 - sine * sine).sqrt());
        for (there, back) in there.into_iter().zip(back) {
            // The other cosine is rounded: a long film turns that into another phase, so thin ones only; and
            // a grazing cosine, the root of what is left of 1, is not got back from it to better than this.
            if d < 300.0 {
                prop_assert!((there.transmitted - back.transmitted).abs() * cos < 6e-6, "{there:?} {back:?}");
            }
        }
    }

    #[test]
    fn absorbers_may_be_permuted(
        a in prop::array::uniform8(0.0f32..10.0), b in prop::array::uniform8(0.0f32..10.0), c in prop::array::uniform8(0.0f32..10.0),
        path in 0.0f32..1.0,
    ) {
        let [a, b, c] = [a, b, c].map(|per_m| Absorber::<8>::from_per_m(per_m).expect("coefficients"));
        let light = Reflectance::<8>::flat(0.7);
        let filters = [a, b, c].map(|absorber| absorber.transmittance(path));
        let [one, two, three] = filters;
        let seen = light * one * two * three;
        // Three products round three times; a sum of the coefficients rounds the exponent, of up to 30.
        for (other, share) in [
            (light * three * two * one, 3e-7), (light * two * three * one, 3e-7), (light * (a + b + c).transmittance(path), 4e-6),
        ] {
            for (x, y) in seen.values().iter().zip(other.values()) {
                prop_assert!((x - y).abs() <= share * x, "{x} {y}");
            }
        }
    }

    #[test]
    fn absorbed_and_transmitted_are_all(per_m in prop::array::uniform4(finite()), path in finite()) {
        let absorber = Absorber::<4>::from_per_m(per_m.map(f32::abs)).expect("coefficients");
        let (through, kept) = (absorber.transmittance(path.abs()), absorber.absorbed(path.abs()));
        for (t, a) in through.values().iter().zip(kept.values()) {
            prop_assert!((t + a - 1.0).abs() < 3e-7 && *t >= 0.0 && *a >= 0.0, "{t} {a}");
        }
    }

    #[test]
    fn profiles_are_never_nan(
        albedo in prop::array::uniform4(0.0f32..=1.0), length in prop::array::uniform4(finite()), r in finite(),
        one in prop::array::uniform4(0.0f32..1e18), other in prop::array::uniform4(0.0f32..1e3), eta in 1.0f32..3.0,
    ) {
        let (length, r) = (length.map(f32::abs), r.abs());
        let skin = Burley::<4, Nodes<400, 700>>::from_mean_free_path(Reflectance::from_bins(albedo), length, BurleyFit::Beam);
        sound(&skin.within(r))?;
        sound(&skin.times_radius(r))?;
        for (inside, all) in skin.within(r).values().iter().zip(albedo) {
            prop_assert!(*inside <= all * 1.000_000_3, "{inside} of {all}");
        }
        for dipole in [Dipole::<4>::new(one, other, eta), Dipole::<4>::new(other, one, eta)] {
            sound(&dipole.profile(r))?;
            sound(&dipole.reflectance())?;
            prop_assert!(dipole.reflectance().values().iter().all(|v| *v <= 1.0));
        }
    }

    #[test]
    fn what_leaves_within_a_distance_has_that_distance(x in 1e-6f32..15.0) {
        let inside = Burley::<1>::new(Reflectance::flat(1.0), [1.0]).within(x).values()[0];
        prop_assert!(inside > 0.99 || (burley_distance(inside) / x - 1.0).abs() < 1e-5);
    }
}
