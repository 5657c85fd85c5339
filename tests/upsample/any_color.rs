//! What holds for every color, on colors that nobody chose.
#![cfg(feature = "libm")]

use crate::LIGHT;
use nanospectra::color::{Bt2020, DisplayP3, Rgb, RgbSpace, Srgb, Xyz};
use nanospectra::light::D65;
use nanospectra::observer::CIE_1931;
use nanospectra::upsample::{
    Basis, LinearStart, Sigmoid, SigmoidReflectance, Smits, Solved, StartMap, Status, Viewing, kubelka_munk,
};
use nanospectra::{Bins, Curve, Factor, Interpolation, Light, Nodes, Observer, Reflectance};
use proptest::prelude::*;
use proptest::sample::select;

type Grid = Nodes<400, 700>;
static EYE: Observer<3, 31, Factor, Grid> = CIE_1931.under(&LIGHT).fold(Curve::Step).with_white_y(100.0);
static VIEWING: Viewing<31, Grid> = Viewing::new(&EYE);
static SIGMOID: Sigmoid<31, Grid> = Sigmoid::new(&VIEWING);
static BASIS: Basis<31, Grid> = Basis::new(&VIEWING);
static SMITS: Smits<31, Grid> = Smits::new();
static WHITE: Light<31, Grid> = D65.interpolate(Interpolation::Linear);
/// Few bands and a wide space: much of it is out of reach.
static WIDE_VIEWING: Viewing<16, Bins<380, 730>, Bt2020> =
    Viewing::new(&CIE_1931.under(&LIGHT).fold(Curve::Step));
static WIDE: Sigmoid<16, Bins<380, 730>, Bt2020, LinearStart> = Sigmoid::new(&WIDE_VIEWING);
static WIDE_BASIS: Basis<16, Bins<380, 730>, Bt2020> = Basis::new(&WIDE_VIEWING);

/// The whole range, the faces, near black, near white, near gray.
fn component() -> impl Strategy<Value = f32> {
    prop_oneof![
        4 => 0.0f32..=1.0,
        1 => Just(0.0f32),
        1 => Just(1.0f32),
        1 => (-30.0f32..0.0).prop_map(f32::exp2),
        1 => (-24.0f32..0.0).prop_map(|e| 1.0 - e.exp2()),
        1 => (-1e-6f32..1e-6).prop_map(|d| 0.5 + d),
    ]
}

fn color() -> impl Strategy<Value = [f32; 3]> {
    let near_gray = (0.0f32..=1.0, -1e-6f32..1e-6, -1e-6f32..1e-6)
        .prop_map(|(gray, d, e)| [gray, (gray + d).clamp(0.0, 1.0), (gray + e).clamp(0.0, 1.0)]);
    prop_oneof![5 => [component(), component(), component()], 1 => near_gray]
}

fn any_number() -> impl Strategy<Value = f32> {
    prop_oneof![
        3 => component(),
        2 => -3.0f32..5.0,
        1 => Just(f32::NAN),
        1 => Just(f32::INFINITY),
        1 => Just(f32::NEG_INFINITY),
        1 => any::<f32>(),
    ]
}

/// Every finite size that there is, and so in a color sizes that do not go together.
fn wild() -> impl Strategy<Value = f32> {
    let size = (any::<bool>(), -149.0f32..127.9);
    const ENDS: [f32; 7] = [0.0, 1e-45, f32::MIN_POSITIVE, 1e-20, 1e20, 0.25 * f32::MAX, f32::MAX];
    prop_oneof![
        2 => component(),
        1 => -3.0f32..5.0,
        2 => size.prop_map(|(minus, e)| if minus { -e.exp2() } else { e.exp2() }),
        1 => (any::<bool>(), select(&ENDS[..])).prop_map(|(minus, size)| if minus { -size } else { size }),
    ]
}

/// Of four colors about three are in the gamut, so that there are some beside each that is not.
fn neighbor() -> impl Strategy<Value = [f32; 3]> {
    let any = (any_number(), wild(), any_number()).prop_map(|(r, g, b)| [r, g, b]);
    prop_oneof![3 => color(), 1 => any]
}

/// At least one component is NaN or infinite.
fn not_finite() -> impl Strategy<Value = [f32; 3]> {
    let bad = select(&[f32::NAN, -f32::NAN, f32::INFINITY, f32::NEG_INFINITY][..]);
    (bad, any_number(), any_number(), 0..3usize).prop_map(|(bad, b, c, turn)| {
        let mut rgb = [bad, b, c];
        rgb.rotate_right(turn);
        rgb
    })
}

fn rgb<S: RgbSpace>([r, g, b]: [f32; 3]) -> Rgb<S> {
    Rgb::new(r, g, b)
}

/// The bits of a reflectance and its status, for NaN is not equal to itself.
fn bits(solved: &Solved<SigmoidReflectance>) -> ([u32; 4], String) {
    (solved.spectrum.to_texel().map(f32::to_bits), format!("{:?}", solved.status))
}

/// What must hold for the reflectance of any finite color; `exact` is what `Exact` may be off by, in
/// CIEDE2000.
fn assert_sound<const N: usize, G: nanospectra::Grid, S: RgbSpace, M: StartMap>(
    viewing: &Viewing<N, G, S>,
    sigmoid: &Sigmoid<N, G, S, M>,
    color: [f32; 3],
    exact: f32,
) -> Result<(), TestCaseError> {
    let solved = sigmoid.reflectance(rgb(color));
    let spectrum = solved.spectrum.on_grid::<N, G>();
    prop_assert_ne!(solved.status, Status::NotFinite);
    prop_assert!(spectrum.values().iter().all(|s| (0.0..=1.0).contains(s)), "{:?} {:?}", solved, spectrum);
    for nm in [-f32::MAX, 0.0, 555.5, 1e20, f32::MAX] {
        prop_assert!((0.0..=1.0).contains(&solved.spectrum.at(nm)), "{:?} at {}", solved, nm);
    }
    if solved.status == Status::Exact {
        // Of the dark all digits count: as bright as can be if the solver alone finds it, and else brought to
        // a thousandth of white.
        let (xyz, white) = (viewing.xyz(rgb(color)), viewing.xyz(rgb([1.0; 3])));
        let shares = [xyz.x / white.x, xyz.y / white.y, xyz.z / white.z];
        let size = shares.into_iter().fold(0.0, |most: f32, share| most.max(share.abs()));
        let largest = color.into_iter().fold(0.0, f32::max);
        let k = match sigmoid.solve(rgb(color)) {
            Some(_) if (1e-30..0.5).contains(&largest) => 0.5 / largest,
            None if largest > 0.0 && (1e-29..1e-3).contains(&size) => 1e-3 / size,
            _ => 1.0,
        };
        let off = viewing.delta_e(rgb(color.map(|c| k * c)), &(spectrum * k));
        prop_assert!(off <= exact, "{} off, {:?}", off, solved);
    }
    if let Some(found) = sigmoid.solve(rgb(color)) {
        prop_assert_eq!(Solved { spectrum: found, status: Status::Exact }, solved);
    }
    let less = sigmoid.desaturated(rgb(color));
    let spectrum = less.spectrum.on_grid::<N, G>();
    prop_assert!(spectrum.values().iter().all(|s| (0.0..=1.0).contains(s)), "{:?} {:?}", less, spectrum);
    match less.status {
        Status::Exact => prop_assert_eq!(less, solved),
        Status::Desaturated { kept, .. } => prop_assert!((0.0..1.0).contains(&kept), "{}", kept),
        other => prop_assert!(false, "{:?}", other),
    }
    Ok(())
}

fn solve([r, g, b]: [f32; 3]) -> Reflectance<31, Grid> {
    let solved = SIGMOID.reflectance(Rgb::new(r, g, b));
    assert_eq!(solved.status, Status::Exact, "{r} {g} {b}");
    solved.spectrum.on_grid()
}

fn largest_difference(a: &Reflectance<31, Grid>, b: &Reflectance<31, Grid>) -> f32 {
    a.values().iter().zip(b.values()).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
}

#[test]
fn sizes_that_do_not_go_together_have_a_status_and_no_infinity() {
    const MOST: f32 = f32::MAX;
    for color in [[1e-20, -1e20, 0.0], [1e-30, -MOST, 1e-30], [MOST, 0.0, 0.0], [MOST, -MOST, MOST]] {
        for (r, g, b) in [(0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (2, 1, 0), (1, 0, 2)] {
            let color = [color[r], color[g], color[b]];
            assert_sound(&VIEWING, &SIGMOID, color, 2e-3).expect("sound");
            assert_sound(&WIDE_VIEWING, &WIDE, color, 2e-3).expect("sound");
            let solved = SIGMOID.unbounded(rgb(color));
            let spectrum = solved.spectrum.on_grid::<31, Grid>();
            assert_ne!(solved.status, Status::Exact, "{color:?}");
            // Twice the largest component is the scale: it can be too large to say.
            let largest = color.into_iter().fold(0.0, f32::max);
            assert_eq!(solved.status == Status::NotFinite, largest == MOST, "{color:?}");
            let sound = |s: &f32| if largest == MOST { !s.is_infinite() } else { s.is_finite() };
            assert!(spectrum.values().iter().all(sound), "{color:?} {spectrum:?}");
        }
    }
}

#[test]
fn black_and_white_are_exact_by_way_of_xyz() {
    for share in [0.0, 1.0] {
        let (one, other) = (VIEWING.xyz(rgb([share; 3])), WIDE_VIEWING.xyz(rgb([share; 3])));
        assert_eq!(SIGMOID.reflectance(VIEWING.rgb_of_xyz(one)).status, Status::Exact, "{one:?}");
        assert_eq!(WIDE.reflectance(WIDE_VIEWING.rgb_of_xyz(other)).status, Status::Exact, "{other:?}");
    }
}

#[test]
fn what_is_called_exact_is_so_at_the_limit_of_the_solid() {
    static P3_VIEWING: Viewing<31, Grid, DisplayP3> = Viewing::new(&CIE_1931.under(&LIGHT).fold(Curve::Step));
    static P3: Sigmoid<31, Grid, DisplayP3> = Sigmoid::new(&P3_VIEWING);
    assert_sound(&VIEWING, &SIGMOID, [-0.44654286, 0.6677848, 0.48186123], 2e-3).expect("sound");
    assert_sound(&P3_VIEWING, &P3, [0.967581, 0.05272889, 0.09193975], 2e-3).expect("sound");
}

#[test]
fn what_comes_near_a_primary_is_hardly_further_off_than_a_mixture_with_gray() {
    for color in 1..7 {
        let color = rgb([1, 2, 4].map(|bit| if color & bit > 0 { 1.0 } else { 0.0 }));
        let off =
            |solved: Solved<SigmoidReflectance>| WIDE_VIEWING.delta_e(color, &solved.spectrum.on_grid());
        let (damped, less) = (off(WIDE.reflectance(color)), off(WIDE.desaturated(color)));
        assert!(damped < 2.0 * less, "{damped} and {less} off {color:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 2000,
        ..ProptestConfig::default()
    })]

    #[test]
    fn every_color_of_the_cube_has_a_possible_reflectance_that_gives_it_back(rgb in color()) {
        let spectrum = solve(rgb);
        prop_assert!(spectrum.values().iter().all(|s| (0.0..=1.0).contains(s)), "{:?}", spectrum);
        let [r, g, b] = rgb;
        let off = VIEWING.delta_e(Rgb::new(r, g, b), &spectrum);
        prop_assert!(off <= 2e-3, "{} for {:?}", off, rgb);
    }

    #[test]
    fn a_dark_spectrum_is_no_brighter_than_twice_its_largest_component(rgb in color()) {
        let largest = rgb.into_iter().fold(0.0, f32::max);
        let smallest = rgb.into_iter().fold(1.0, f32::min);
        for share in solve(rgb).values() {
            prop_assert!(*share <= (2.0 * largest).min(1.0) && 1.0 - share <= (2.0 * (1.0 - smallest)).min(1.0));
        }
    }

    #[test]
    fn exposure_scales_dark_spectra(rgb in color(), stops in 1..40i32) {
        let dark = rgb.map(|c| 0.25 * c);
        let bright = solve(dark);
        let darker = solve(dark.map(|c| c * 0.5f32.powi(stops)));
        // Subnormal components lose bits, and so may their spectra.
        prop_assume!(dark.iter().all(|c| *c == 0.0 || *c > 1e-20));
        prop_assert_eq!(darker, bright * 0.5f32.powi(stops));
    }

    #[test]
    fn a_darker_exposure_is_darker_at_every_wavelength(rgb in color(), part in 0.05f32..0.95) {
        let dark = rgb.map(|c| 0.49 * c);
        let (bright, less) = (solve(dark), solve(dark.map(|c| part * c)));
        for (bright, less) in bright.values().iter().zip(less.values()) {
            prop_assert!(less <= bright, "{} {}", less, bright);
        }
    }

    #[test]
    fn there_is_no_seam_where_the_scale_and_the_complement_begin(rgb in color()) {
        let [r, g, b] = rgb;
        let largest = r.max(g).max(b).max(1e-3);
        let seam = [r, g, b].map(|c| 0.5 * (c / largest));
        let below = solve(seam.map(|c| c * (1.0 - 1e-6)));
        let above = solve(seam.map(|c| (c * (1.0 + 1e-6)).min(1.0)));
        prop_assert!(largest_difference(&below, &above) < 1e-3, "{:?}", seam);
        let high = seam.map(|c| 1.0 - c);
        let below = solve(high.map(|c| c * (1.0 - 1e-6)));
        let above = solve(high.map(|c| (c * (1.0 + 1e-6)).min(1.0)));
        prop_assert!(largest_difference(&below, &above) < 1e-3, "{:?}", high);
    }

    #[test]
    fn the_basis_is_linear_and_possible(one in color(), other in color(), part in 0.0f32..=1.0) {
        let viewing: Viewing<60, Bins<400, 700>> = Viewing::new(&CIE_1931.under(&LIGHT).fold(Curve::Step));
        let basis = Basis::new(&viewing);
        let of = |[r, g, b]: [f32; 3]| basis.reflectance(Rgb::new(r, g, b));
        let mixed = of([0, 1, 2].map(|c| part * one[c] + (1.0 - part) * other[c]));
        let sum = of(one) * part + of(other) * (1.0 - part);
        for (mixed, sum) in mixed.values().iter().zip(sum.values()) {
            prop_assert!((mixed - sum).abs() < 1e-6 && (-1e-7..=1.0000001).contains(mixed));
        }
    }

    #[test]
    fn what_is_not_finite_says_so_and_is_nan(color in not_finite()) {
        let is_nan = |values: &[f32]| values.iter().all(|s| s.is_nan());
        for solved in [SIGMOID.reflectance(rgb(color)), SIGMOID.desaturated(rgb(color))] {
            prop_assert_eq!(solved.status, Status::NotFinite);
            prop_assert!(is_nan(solved.spectrum.on_grid::<31, Grid>().values()), "{:?}", solved);
            prop_assert!(solved.spectrum.at(550.0).is_nan());
        }
        prop_assert_eq!(SIGMOID.solve(rgb(color)), None);
        let unbounded = SIGMOID.unbounded(rgb(color));
        prop_assert_eq!(unbounded.status, Status::NotFinite);
        prop_assert!(is_nan(unbounded.spectrum.on_grid::<31, Grid>().values()), "{:?}", unbounded);
        let light = SIGMOID.illuminant(rgb(color));
        prop_assert_eq!(light.status, Status::NotFinite);
        prop_assert!(is_nan(light.spectrum.on_grid(&WHITE).values()), "{:?}", light);
        let [x, y, z] = color;
        prop_assert_eq!(SIGMOID.reflectance(VIEWING.rgb_of_xyz(Xyz { x, y, z })).status, Status::NotFinite);
        if color.iter().any(|c| c.is_nan()) {
            prop_assert!(is_nan(BASIS.reflectance(rgb(color)).values()));
            prop_assert!(is_nan(SMITS.reflectance(rgb::<Srgb>(color)).values()));
        }
    }

    #[test]
    fn xyz_of_the_cube_have_spectra_that_give_them_back(color in color()) {
        let asked = VIEWING.xyz(rgb(color));
        let back = VIEWING.rgb_of_xyz(asked);
        let solved = SIGMOID.reflectance(back);
        prop_assert_eq!(solved.status, Status::Exact, "{:?}", back);
        let [x, y, z] = EYE.sees(&solved.spectrum.on_grid());
        prop_assert!((x - asked.x).abs() + (y - asked.y).abs() + (z - asked.z).abs() < 1e-3);
    }

    #[test]
    fn linear_methods_overflow_near_the_largest_number_and_not_before(color in [wild(), wild(), wild()]) {
        let largest = color.iter().fold(0.0, |most: f32, c| most.max(c.abs()));
        let all = [
            BASIS.reflectance(rgb(color)).values().to_vec(),
            WIDE_BASIS.reflectance(rgb(color)).values().to_vec(),
            SMITS.reflectance(rgb::<Srgb>(color)).values().to_vec(),
        ];
        for values in all {
            prop_assert!(largest > 0.125 * f32::MAX || values.iter().all(|s| s.is_finite()), "{:?}", values);
        }
    }

    #[test]
    fn smits_has_no_seam_where_components_change_places(a in 0.0f32..=1.0, b in 0.0f32..=1.0, turn in 0..3usize) {
        for both in [[a, a, b], [a, b, b], [a, a, a]] {
            let mut equal = both;
            equal.rotate_right(turn);
            for k in 0..3 {
                let mut moved = equal;
                moved[k] += 1e-6;
                let (one, other) = (SMITS.reflectance(rgb::<Srgb>(equal)), SMITS.reflectance(rgb::<Srgb>(moved)));
                prop_assert!(largest_difference(&one, &other) < 3e-6, "{:?}", moved);
            }
        }
    }

    #[test]
    fn texels_and_wavelengths_read_what_the_grid_reads(color in color()) {
        let solved = SIGMOID.reflectance(rgb(color)).spectrum;
        prop_assert_eq!(SigmoidReflectance::from_texel(solved.to_texel()), solved);
        for (nm, share) in solved.on_grid::<31, Grid>().iter() {
            prop_assert!((solved.at(nm) - share).abs() < 1e-5);
        }
    }

    #[test]
    fn a_mixture_of_paints_is_possible(
        shares in [0.0f32..=1.0, 0.0f32..=1.0],
        scale in -40.0f32..40.0,
        one in component(),
        other in component(),
    ) {
        prop_assume!(shares[0] + shares[1] > 0.0);
        let [one, other] = [one, other].map(Reflectance::<16>::flat);
        let [a, b] = shares.map(|share| share * scale.exp2());
        let mixed = kubelka_munk(&[(a, &one), (b, &other)]);
        let (low, high) = (one.values()[0].min(other.values()[0]), one.values()[0].max(other.values()[0]));
        for r in mixed.values() {
            prop_assert!((low * (1.0 - 1e-5)..=high * (1.0 + 1e-5)).contains(r), "{} of {} {}", r, low, high);
        }
    }
}

/// How many colors are drawn that may be out of reach, whose search takes a hundred times as long.
const FAR: u32 = if cfg!(debug_assertions) { 200 } else { 2000 };

proptest! {
    #![proptest_config(ProptestConfig {
        cases: FAR,
        ..ProptestConfig::default()
    })]

    #[test]
    fn finite_colors_have_possible_reflectances([r, g, b] in [wild(), wild(), wild()]) {
        assert_sound(&VIEWING, &SIGMOID, [r, g, b], 2e-3)?;
        assert_sound(&WIDE_VIEWING, &WIDE, [r, g, b], 2e-3)?;
    }

    #[test]
    fn a_miss_of_a_finite_color_is_a_number(color in [wild(), wild(), wild()]) {
        // From 1e16 on f32 does not hold the squares of Lab.
        let color = color.map(|c| c.clamp(-5e15, 5e15));
        if let Status::Unreachable(miss) = SIGMOID.reflectance(rgb(color)).status {
            prop_assert!(miss.delta_e() >= 0.0 && miss.delta_e76() >= 0.0, "{:?}", miss);
        }
    }

    #[test]
    fn what_is_called_exact_without_a_bound_is_finite_and_has_the_color(color in [wild(), wild(), wild()]) {
        let solved = SIGMOID.unbounded(rgb(color));
        let spectrum = solved.spectrum.on_grid::<31, Grid>();
        let light = SIGMOID.illuminant(rgb(color));
        prop_assert_eq!(format!("{:?}", light.status), format!("{:?}", solved.status));
        let largest = color.into_iter().fold(0.0, f32::max);
        // Twice the largest component is the scale, and white is above 1.
        if largest < 1e-3 * f32::MAX {
            prop_assert_ne!(solved.status, Status::NotFinite);
            prop_assert!(spectrum.values().iter().all(|s| s.is_finite() && *s >= 0.0), "{:?}", solved);
            let light = light.spectrum.on_grid(&WHITE);
            prop_assert!(light.values().iter().all(|s| s.is_finite() && *s >= 0.0), "{:?}", solved);
        }
        if solved.status == Status::Exact {
            prop_assert!(spectrum.values().iter().all(|s| s.is_finite() && *s >= 0.0), "{:?}", solved);
            if largest > 1e-30 {
                // One after the other: their quotient may overflow.
                let half = |c: f32| 0.5 * (c / largest);
                let scaled = Reflectance::<31, Grid>::from_bins(spectrum.values().map(half));
                let off = VIEWING.delta_e(rgb(color.map(half)), &scaled);
                prop_assert!(off <= 2e-3, "{} off, {:?}", off, solved);
            }
        }
    }

    #[test]
    fn neighbors_in_a_batch_change_nothing(
        colors in prop::collection::vec(neighbor(), 0..20),
        other in 0..5usize,
    ) {
        let colors: Vec<Rgb<Srgb>> = colors.into_iter().map(rgb).collect();
        let untouched = Solved { spectrum: SigmoidReflectance::gray(0.25), status: Status::Exact };
        let mut spectra = vec![untouched; (colors.len() + other).saturating_sub(2)];
        SIGMOID.reflectance_each(&colors, &mut spectra);
        for (color, solved) in colors.iter().zip(&spectra) {
            prop_assert_eq!(bits(solved), bits(&SIGMOID.reflectance(*color)));
        }
        prop_assert!(spectra.iter().skip(colors.len()).all(|solved| *solved == untouched));
        for eight in colors.chunks_exact(8) {
            let eight: [Rgb<Srgb>; 8] = eight.try_into().expect("eight");
            for (color, solved) in eight.iter().zip(SIGMOID.reflectance_8(&eight)) {
                prop_assert_eq!(bits(&solved), bits(&SIGMOID.reflectance(*color)));
            }
        }
    }
}

/// The solver alone gives the bits of the whole, wherever it gives something.
#[test]
fn the_solver_alone_gives_the_same_spectrum() {
    let (mut some, mut all) = (0, 0);
    crate::cube(9, |color| {
        let whole = SIGMOID.reflectance(rgb(color));
        all += 1;
        if let Some(alone) = SIGMOID.solve(rgb(color)) {
            some += 1;
            assert_eq!((whole.spectrum, whole.status), (alone, Status::Exact), "{color:?}");
        }
    });
    assert!(some * 100 > 99 * all, "{some} of {all}");
}

/// Four times the light misses by four times as much.
#[test]
fn the_miss_of_a_light_has_the_scale_of_the_light() {
    let mut missed = 0;
    crate::cube(9, |color| {
        let [one, four] = [1.0, 4.0].map(|scale| WIDE.unbounded(rgb::<Bt2020>(color.map(|v| scale * v))));
        if let (Status::Unreachable(one), Status::Unreachable(four)) = (one.status, four.status) {
            missed += 1;
            assert_eq!([four.asked, four.given], [one.asked.scaled(4.0), one.given.scaled(4.0)], "{color:?}");
        }
    });
    assert!(missed > 30, "{missed}");
}
