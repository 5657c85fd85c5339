//! Tests that the methods of others, with which nanospectra is compared, give what their authors published.

use model::allowed::check;
use model::cct::planckian_uv;
use model::chromaticity::xy_from_uv1960;
use model::csv::golden;
use model::tables::Observer;
use nanospectra::math::Portable;
use nanospectra_hard::yardstick::cct::{ISOTHERMS, LOCUS, mccamy, ohno, robertson};
use nanospectra_hard::yardstick::lobes::color_matching;
use nanospectra_hard::yardstick::product::rgb_product;
use nanospectra_hard::yardstick::sums;

#[test]
fn the_table_of_1_percent_is_the_locus() {
    let table = concat!(env!("CARGO_MANIFEST_DIR"), "/src/yardstick/locus_1_percent.txt");
    let entries: Vec<String> = (-1..=464)
        .map(|step| {
            let kelvin = 1000.0 * 1.01f64.powi(step);
            let [u, v] = planckian_uv(kelvin);
            format!("[{:?}, {:?}, {:?}]", kelvin as f32, u as f32, v as f32)
        })
        .collect();
    let lines: String = entries.chunks(3).map(|three| format!("    {},\n", three.join(", "))).collect();
    let made = format!("[\n{lines}]\n");
    if std::env::var_os("NANOSPECTRA_BLESS").is_some() {
        std::fs::write(table, &made).expect("a folder of this package");
    }
    let text = std::fs::read_to_string(table).expect("a file of this package");
    assert!(text == made, "{table} is not what the model makes; NANOSPECTRA_BLESS=1 makes it again");
}

#[test]
fn mccamy_gives_what_his_polynomial_gives() {
    let mut kelvin = check("McCamy's polynomial in f32");
    let golden = golden("02_cct_grid");
    for row in golden.rows() {
        let xy = xy_from_uv1960([row.number("u"), row.number("v")]);
        kelvin.cell(row, "T_mccamy", mccamy(xy.map(|c| c as f32)).into());
    }
    kelvin.tight(golden.len());
}

#[test]
fn robertson_gives_what_his_isotherms_give() {
    let mut mired = check("Robertson's isotherms in f32, mired");
    let mut duv = check("Duv by Robertson's isotherms in f32");
    let golden = golden("02_cct_grid");
    let mut rows = 0;
    for row in golden.rows() {
        let found = robertson([row.number("u") as f32, row.number("v") as f32]);
        // Beyond Robertson's last isotherm, other implementations return that isotherm.
        if row.number("T_robertson_colour") < 1e6 / 599.99 {
            assert_eq!(found, None, "{}", row.place());
            continue;
        }
        let [kelvin, distance] = found.unwrap_or_else(|| panic!("{}: nothing", row.place()));
        mired.value(&row.place(), 1e6 / f64::from(kelvin), 1e6 / row.number("T_robertson_colour"));
        duv.cell(row, "Duv_robertson_colour", distance.into());
        rows += 1;
    }
    mired.tight(rows);
    duv.tight(rows);
    assert_eq!(rows, 364, "rows from 1667 K up");
    assert_eq!(size_of_val(&ISOTHERMS), 496);
}

#[test]
fn ohno_on_1_percent_is_as_far_off_as_elsewhere() {
    let (mut mired, mut duv) = (check("Ohno's table of 1 %, mired"), check("Duv by Ohno's table of 1 %"));
    let golden = golden("02_cct_grid");
    let mut elsewhere = [0.0f64; 2];
    for row in golden.rows() {
        let found = ohno([row.number("u") as f32, row.number("v") as f32]);
        let [kelvin, distance] = found.unwrap_or_else(|| panic!("{}: nothing", row.place()));
        mired.value(&row.place(), 1e6 / f64::from(kelvin), 1e6 / row.number("T_exact"));
        duv.cell(row, "Duv_exact", distance.into());
        let theirs = 1e6 / row.number("T_ohno_colour_1.01") - 1e6 / row.number("T_exact");
        let duv_theirs = row.number("Duv_ohno_colour_1.01") - row.number("Duv_exact");
        elsewhere = [elsewhere[0].max(theirs.abs()), elsewhere[1].max(duv_theirs.abs())];
    }
    // Expected values from another table in steps of 1 %, in f64.
    println!("elsewhere: {:.3} mired, {:.1e}", elsewhere[0], elsewhere[1]);
    mired.tight(golden.len());
    duv.tight(golden.len());
    assert_eq!(size_of_val(&LOCUS), 5592);
}

#[test]
fn outside_their_tables_and_for_nan_robertson_and_ohno_have_nothing() {
    for kelvin in [900.0, 980.0] {
        let uv = planckian_uv(kelvin).map(|c| c as f32);
        assert_eq!((robertson(uv), ohno(uv)), (None, None), "{kelvin} K");
    }
    let hot = planckian_uv(200_000.0).map(|c| c as f32);
    assert!(ohno(hot).is_none() && robertson(hot).is_some());
    for uv in [[f32::NAN, 0.3], [0.2, f32::NAN]] {
        assert_eq!((robertson(uv), ohno(uv)), (None, None));
    }
    assert!(mccamy([f32::NAN, 0.3]).is_nan());
}

#[test]
fn the_lobes_follow_the_1931_functions() {
    let mut curves = ["x bar by lobes", "y bar by lobes", "z bar by lobes"].map(check);
    let cmf = Observer::Cie1931.on_cie_grid();
    for (k, nm) in (360..=830u16).enumerate() {
        let fitted = color_matching::<Portable>(f32::from(nm));
        for (c, curve) in curves.iter_mut().enumerate() {
            curve.value(&format!("{nm} nm"), fitted[c].into(), cmf[c][k]);
        }
    }
    let [x, y, z] = curves;
    x.tight(471);
    y.tight(471);
    z.tight(471);
    assert!(color_matching::<Portable>(f32::NAN).iter().all(|value| value.is_nan()));
}

#[test]
fn a_white_surface_under_rgb_light_has_the_xyz_of_the_light() {
    let mut product = check("product of RGBs");
    let to_xyz = model::rgb::named("sRGB").rgb_to_xyz();
    let lights = [[1.0, 1.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.9, 0.5, 0.2]];
    for light in lights {
        for gray in [1.0, 0.25] {
            let found = rgb_product(light.map(|c| c as f32), [gray as f32; 3]);
            for (row, found) in to_xyz.iter().zip(found) {
                let expected: f64 = row.iter().zip(light).map(|(m, c)| 100.0 * m * c * gray).sum();
                product.value(&format!("{light:?} on {gray}"), found.into(), expected);
            }
        }
    }
    product.tight(3 * 2 * lights.len());
    assert_eq!(rgb_product([1.0; 3], [0.0; 3]), [0.0; 3]);
}

/// Returns the largest error of 64 sums of 471 products, in units of 2^-24 of the sum of their sizes.
fn worst_of(sum: fn(&[f32], &[f32]) -> f32) -> f64 {
    let mut state = 1u32;
    let mut next = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 8) as f32 / 16_777_216.0
    };
    let mut worst = 0.0f64;
    for _ in 0..64 {
        let (a, b): (Vec<f32>, Vec<f32>) = (0..471).map(|_| (next(), next())).unzip();
        let exact: f64 = a.iter().zip(&b).map(|(a, b)| f64::from(*a) * f64::from(*b)).sum();
        worst = worst.max((f64::from(sum(&a, &b)) - exact).abs() / exact * 16_777_216.0);
    }
    worst
}

#[test]
fn a_sum_in_pairs_is_nearer_than_one_after_the_other() {
    let (naive, pairwise) = (worst_of(sums::naive), worst_of(sums::pairwise));
    println!("sums of 471 products, in eps: naive {naive:.1}, pairwise {pairwise:.1}");
    assert!((8.0..64.0).contains(&naive) && (0.5..4.0).contains(&pairwise), "{naive} {pairwise}");
    for n in [0, 1, 2, 7, 8, 9, 16, 17, 471] {
        let ones = vec![1.0; n];
        assert_eq!((sums::naive(&ones, &ones), sums::pairwise(&ones, &ones)), (n as f32, n as f32));
    }
}
