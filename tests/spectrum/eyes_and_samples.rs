//! The shipped functions of the eye and the shipped surfaces: that they mean what their names say.

use model::allowed::check;
use model::csv::table;
use model::interpolation::Samples;
use model::tables::{ALPHA_OPIC as ALPHA_OPIC_COLUMNS, Observer, alpha_opic, samples, test_color_samples};
use nanospectra::matter::{CES, TCS};
use nanospectra::observer::{
    self, ALPHA_OPIC, CIE_1931, CIE_1964, CIE_2006_LMS_2, CIE_2006_LMS_10, CIE_2015_2, CIE_2015_10,
    NamedObserver, V_PHOTOPIC, V_SCOTOPIC,
};
use nanospectra::{Factor, Fine, FineObserver};

fn rounded(values: &[f64]) -> Vec<f32> {
    values.iter().map(|v| *v as f32).collect()
}

#[test]
fn the_functions_are_the_cells_of_their_files() {
    let eyes = [
        (&CIE_1931, Observer::Cie1931),
        (&CIE_1964, Observer::Cie1964),
        (&CIE_2015_2, Observer::Cie2015Deg2),
        (&CIE_2015_10, Observer::Cie2015Deg10),
    ];
    // Nothing that the crate names is left out.
    let named = observer::ALL.iter().map(|named| named.functions);
    assert!(eyes.iter().map(|(eye, _)| *eye).eq(named), "this list and observer::ALL");
    for (eye, published) in eyes {
        for (row, published) in eye.weights().iter().zip(published.on_cie_grid()) {
            assert_eq!(row.as_slice(), rounded(&published));
        }
    }
    for (row, column) in ALPHA_OPIC.weights().iter().zip(ALPHA_OPIC_COLUMNS) {
        assert_eq!(row.as_slice(), rounded(&alpha_opic(column)), "{column}");
    }
    let [v, scotopic] = [("v_photopic", "V"), ("v_scotopic", "V_prime")]
        .map(|(file, column)| model::tables::function(&format!("cmf/{file}_1nm.csv"), column));
    assert_eq!(V_PHOTOPIC.weights()[0].as_slice(), rounded(&v));
    assert_eq!(V_SCOTOPIC.weights()[0].as_slice(), rounded(&scotopic));
}

#[test]
fn y_bar_of_1931_is_v_lambda() {
    assert_eq!(CIE_1931.weights()[1], V_PHOTOPIC.weights()[0]);
    for other in [&CIE_1964, &CIE_2015_2, &CIE_2015_10] {
        assert_ne!(other.weights()[1], V_PHOTOPIC.weights()[0]);
    }
}

#[test]
fn an_observer_is_found_by_its_whole_name() {
    for eye in &observer::ALL {
        assert!(observer::named(eye.name).is_some_and(|found| core::ptr::eq(found, eye)));
        assert!(observer::named(&eye.name[1..]).is_none() && observer::named(&eye.name[..2]).is_none());
    }
}

#[test]
fn the_equal_energy_light_is_white_to_every_xyz_observer() {
    // All of them are normalized to x = y = 1/3 for it.
    let mut white = check("xy of equal energy");
    for NamedObserver { name, functions, .. } in &observer::ALL {
        let [x, y, z] = functions.row_sums();
        white.value(&format!("{name} x"), x / (x + y + z), 1.0 / 3.0);
        white.value(&format!("{name} y"), y / (x + y + z), 1.0 / 3.0);
    }
    white.tight(2 * observer::ALL.len());
}

#[test]
fn no_two_functions_are_copies_of_each_other() {
    let eyes = observer::ALL.iter().map(|named| named.functions).chain([&CIE_2006_LMS_2, &CIE_2006_LMS_10]);
    // Melanopsin; the cones of CIE S 026 are those of 10 degrees, its rhodopsin is V'.
    let rows = eyes.flat_map(|eye| eye.weights()).chain(V_SCOTOPIC.weights());
    let rows: Vec<&[f32; 471]> = rows.chain(&ALPHA_OPIC.weights()[4..]).collect();
    let mut nearest = f32::INFINITY;
    for (i, a) in rows.iter().enumerate() {
        for b in &rows[..i] {
            nearest = a.iter().zip(*b).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max).min(nearest);
        }
    }
    println!("nearest two functions differ by {nearest}");
    assert!(nearest > 0.01, "two functions differ by no more than {nearest}");
    assert_eq!(rows.len(), 3 * observer::ALL.len() + 8);
}

#[test]
fn cones_are_the_official_table_at_its_nodes_and_never_negative() {
    let files = [("2deg", "", &CIE_2006_LMS_2), ("10deg", "10", &CIE_2006_LMS_10)];
    for (file, suffix, cones) in files {
        for (row, cone) in cones.weights().iter().zip(["l", "m", "s"]) {
            let published =
                samples(&format!("cmf/cie_2006_{file}_lms_5nm_official.csv"), &format!("{cone}{suffix}_bar"));
            let nodes: Vec<f32> = row[30..].iter().step_by(5).copied().collect();
            assert_eq!(nodes, rounded(&published.values), "{file} {cone}");
            assert!(row[..30].iter().all(|w| *w == 0.0), "{file} {cone}: CIE tabulates nothing below 390 nm");
            assert!(row.iter().all(|w| *w >= 0.0), "{file} {cone}");
        }
    }
}

/// CIE 170-2:2015: from the cones to XYZ, 2 and 10 degrees.
const TO_XYZ_2: [[f32; 3]; 3] =
    [[1.94735469, -1.41445123, 0.36476327], [0.68990272, 0.34832189, 0.0], [0.0, 0.0, 1.93485343]];
const TO_XYZ_10: [[f32; 3]; 3] =
    [[1.93986443, -1.34664359, 0.43044935], [0.69283932, 0.34967567, 0.0], [0.0, 0.0, 2.14687945]];

fn compare_cones(name: &'static str, cones: &FineObserver<3>, matrix: &[[f32; 3]; 3], xyz: &FineObserver<3>) {
    let mut check = check(name);
    let made = cones.mixed(matrix);
    for (c, (got, expected)) in made.weights().iter().zip(xyz.weights()).enumerate() {
        // Below 390 nm neither is tabulated.
        for k in 30..471 {
            check.value(&format!("row {c} at {} nm", 360 + k), got[k].into(), expected[k].into());
        }
    }
    check.tight(3 * 441);
}

#[test]
fn cones_make_the_xyz_functions_by_the_matrix_of_cie_170_2() {
    compare_cones("cones to XYZ, 2 degrees", &CIE_2006_LMS_2, &TO_XYZ_2, &CIE_2015_2);
    compare_cones("cones to XYZ, 10 degrees", &CIE_2006_LMS_10, &TO_XYZ_10, &CIE_2015_10);
}

#[test]
fn the_alpha_opic_cones_and_rods_are_those_of_their_sources() {
    let mut cones = check("alpha-opic cones against the 10 degree cones");
    let [s, m, l, rods, melanopsin] = ALPHA_OPIC.weights();
    // CIE S 026 counts from the short wavelengths, CIE 170 from the long ones.
    for (name, a, b) in [("L", l, 0), ("M", m, 1), ("S", s, 2)] {
        let both = CIE_2006_LMS_10.weights()[b].iter().zip(a).enumerate();
        for (k, (of_cone, alpha_opic)) in both.take(421).skip(30) {
            cones.value(&format!("{name} at {} nm", 360 + k), (*of_cone).into(), (*alpha_opic).into());
        }
    }
    cones.tight(3 * 391);
    let mut rhodopsin = check("rhodopsin's function against V'");
    for (k, (rods, scotopic)) in rods.iter().zip(&V_SCOTOPIC.weights()[0]).enumerate().take(421).skip(20) {
        rhodopsin.value(&format!("{} nm", 360 + k), (*rods).into(), (*scotopic).into());
    }
    rhodopsin.tight(401);
    let peak = (0..471).find(|k| melanopsin[*k] == 1.0).expect("normalized to 1");
    assert_eq!(360 + peak, 490, "melanopsin sees best at 490 nm");
}

#[test]
fn test_color_samples_are_fifteen_and_cover_what_cie_13_3_says() {
    let published: Vec<Samples> = test_color_samples();
    assert_eq!((published.len(), TCS.len()), (15, 15));
    for (k, (sample, published)) in TCS.iter().zip(&published).enumerate() {
        let name = format!("TCS{:02}", k + 1);
        for (nm, value) in published.points() {
            assert_eq!(sample.values()[nm as usize - 360], value as f32, "{name} at {nm} nm");
        }
        assert!(sample.values().iter().all(|v| (0.0..=1.0).contains(v)), "{name} is no reflectance");
    }
    let at = |k: usize, nm: usize| TCS[k - 1].values()[nm - 360];
    // Strong red, yellow, green, blue; foliage green with its infrared edge.
    assert!(at(9, 650) > 0.6 && at(9, 500) < 0.1);
    assert!(at(10, 600) > 0.7 && at(10, 450) < 0.1);
    assert!(at(11, 520) > at(11, 450) && at(11, 520) > at(11, 620));
    assert!(at(12, 450) > at(12, 550) && at(12, 450) > at(12, 600));
    assert!(at(14, 750) > 2.0 * at(14, 550) && at(14, 550) > at(14, 450));
    // TCS15 is published over 380..780 nm; its ends are held.
    assert_eq!(at(15, 370), at(15, 380));
    assert_eq!(at(15, 800), at(15, 780));
}

#[test]
fn color_evaluation_samples_are_ninety_nine_different_reflectances() {
    let file = table("samples/cie224_ces99_1nm.csv");
    assert_eq!((file.names().len(), CES.len()), (99, 99));
    let (mut low, mut high) = (f32::INFINITY, 0.0f32);
    for (sample, name) in CES.iter().zip(file.names()) {
        assert_eq!(sample.values().as_slice(), rounded(&file.column(name)), "{name}");
        low = sample.values().iter().copied().fold(low, f32::min);
        high = sample.values().iter().copied().fold(high, f32::max);
    }
    println!("reflectances from {low} to {high}");
    assert!((0.0..0.01).contains(&low) && (0.9..=1.0).contains(&high), "{low} to {high}");
    for (i, a) in CES.iter().enumerate() {
        for (j, b) in CES[..i].iter().enumerate() {
            let differs = a.values().iter().zip(b.values()).any(|(a, b)| (a - b).abs() > 0.01);
            assert!(differs, "CES{:02} is a copy of CES{:02}", i + 1, j + 1);
        }
    }
    let gray: Fine<Factor> = Fine::flat(0.18);
    assert!(CIE_1931.looking_at(&gray).weights()[1][195] == 0.18, "Y at 555 nm off a gray card");
}
