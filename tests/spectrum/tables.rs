//! The shipped tables: that they are the files on record, and that they mean what their names say. (Published
//! crates have had LED tables that were copies of FL, and an FL11 that was not.)
#![cfg(feature = "libm")]

use model::allowed::check;
use model::csv::golden;
use model::tables::samples;
use nanospectra::color::{Cct, Xy, Xyz, cri};
use nanospectra::light::{self, *};
use nanospectra::observer::{
    ALPHA_OPIC, CIE_1931, CIE_1964, CIE_2006_LMS_2, CIE_2006_LMS_10, CIE_2015_2, CIE_2015_10, V_PHOTOPIC,
    V_SCOTOPIC,
};
use nanospectra::{Fine, Grid, Interpolation, Nodes, Power, Spectrum};
use std::collections::BTreeSet;
use std::path::Path;

/// A lamp on 5 nm nodes, as CIE 15 prints it.
type Lamp = Spectrum<Power, 81, Nodes<380, 780>>;
/// The same on 1 nm nodes.
type Lamp1nm = Spectrum<Power, 401, Nodes<380, 780>>;

/// Name in CIE 15, constant, its 1 nm version, x, y and CCT as printed there; Ra too, for lamps that have
/// one.
struct Entry(&'static str, &'static Lamp, Option<&'static Lamp1nm>, f32, f32, f32, Option<f32>);

macro_rules! lamps {
    ($($name:literal $table:ident $($fine:ident)?: $x:literal $y:literal $cct:literal $($ra:literal)?;)*) => {
        [$(Entry($name, &light::$table, lamps!(@ $(&light::$fine)?), $x, $y, $cct, lamps!(@ $($ra)?))),*]
    };
    (@) => { None };
    (@ $some:expr) => { Some($some) };
}

static LAMPS: [Entry; 41] = lamps! {
    "FL1" FL1 FL1_1NM: 0.3131 0.3371 6430.0 76.0;
    "FL2" FL2 FL2_1NM: 0.3721 0.3751 4230.0 64.0;
    "FL3" FL3 FL3_1NM: 0.4091 0.3941 3450.0 57.0;
    "FL4" FL4 FL4_1NM: 0.4402 0.4031 2940.0 51.0;
    "FL5" FL5 FL5_1NM: 0.3138 0.3452 6350.0 72.0;
    "FL6" FL6 FL6_1NM: 0.3779 0.3882 4150.0 59.0;
    "FL7" FL7 FL7_1NM: 0.3129 0.3292 6500.0 90.0;
    "FL8" FL8 FL8_1NM: 0.3458 0.3586 5000.0 95.0;
    "FL9" FL9 FL9_1NM: 0.3741 0.3727 4150.0 90.0;
    "FL10" FL10 FL10_1NM: 0.3458 0.3588 5000.0 81.0;
    "FL11" FL11 FL11_1NM: 0.3805 0.3769 4000.0 83.0;
    "FL12" FL12 FL12_1NM: 0.4370 0.4042 3000.0 83.0;
    "FL3.1" FL3_1 FL3_1_1NM: 0.4407 0.4033 2932.0;
    "FL3.2" FL3_2 FL3_2_1NM: 0.3808 0.3734 3965.0;
    "FL3.3" FL3_3 FL3_3_1NM: 0.3153 0.3439 6280.0;
    "FL3.4" FL3_4 FL3_4_1NM: 0.4429 0.4043 2904.0;
    "FL3.5" FL3_5 FL3_5_1NM: 0.3749 0.3672 4086.0;
    "FL3.6" FL3_6 FL3_6_1NM: 0.3488 0.3600 4894.0;
    "FL3.7" FL3_7 FL3_7_1NM: 0.4384 0.4045 2979.0;
    "FL3.8" FL3_8 FL3_8_1NM: 0.3820 0.3832 4006.0;
    "FL3.9" FL3_9 FL3_9_1NM: 0.3499 0.3591 4853.0;
    "FL3.10" FL3_10 FL3_10_1NM: 0.3455 0.3560 5000.0;
    "FL3.11" FL3_11 FL3_11_1NM: 0.3245 0.3434 5854.0;
    "FL3.12" FL3_12 FL3_12_1NM: 0.4377 0.4037 2984.0;
    "FL3.13" FL3_13 FL3_13_1NM: 0.3830 0.3724 3896.0;
    "FL3.14" FL3_14 FL3_14_1NM: 0.3447 0.3609 5045.0;
    "FL3.15" FL3_15 FL3_15_1NM: 0.3127 0.3288 6509.0;
    "HP1" HP1: 0.5330 0.4150 1959.0;
    "HP2" HP2: 0.4778 0.4158 2506.0;
    "HP3" HP3: 0.4302 0.4075 3144.0;
    "HP4" HP4: 0.3812 0.3797 4002.0;
    "HP5" HP5: 0.3776 0.3713 4039.0;
    "LED-B1" LED_B1 LED_B1_1NM: 0.4560 0.4078 2733.0;
    "LED-B2" LED_B2 LED_B2_1NM: 0.4357 0.4012 2998.0;
    "LED-B3" LED_B3 LED_B3_1NM: 0.3756 0.3723 4103.0;
    "LED-B4" LED_B4 LED_B4_1NM: 0.3422 0.3502 5109.0;
    "LED-B5" LED_B5 LED_B5_1NM: 0.3118 0.3236 6598.0;
    "LED-BH1" LED_BH1 LED_BH1_1NM: 0.4474 0.4066 2851.0;
    "LED-RGB1" LED_RGB1 LED_RGB1_1NM: 0.4557 0.4211 2840.0;
    "LED-V1" LED_V1 LED_V1_1NM: 0.4548 0.4044 2724.0;
    "LED-V2" LED_V2 LED_V2_1NM: 0.3781 0.3775 4070.0;
};

fn lamp(name: &str) -> &'static Entry {
    LAMPS.iter().find(|entry| entry.0 == name).unwrap_or_else(|| panic!("no lamp called {name}"))
}

/// CIE 15's own method for these numbers: a sum over 380, 385, .. 780 nm.
fn xy_at_5nm<const N: usize, G: Grid>(light: &Spectrum<Power, N, G>) -> Xy {
    let nodes: Lamp = light.interpolate(Interpolation::Linear);
    let sums = CIE_1931.weights().map(|row| {
        let every_fifth = row.iter().skip(20).step_by(5);
        every_fifth.zip(nodes.values()).map(|(w, s)| f64::from(*w) * f64::from(*s)).sum::<f64>()
    });
    Xyz::from(sums.map(|sum| sum as f32)).xy().expect("a visible light")
}

/// The sum over 360, 361, .. 830 nm.
fn xyz_at_1nm<const N: usize, G: Grid>(light: &Spectrum<Power, N, G>) -> Xyz {
    Xyz::from(CIE_1931.sees(&light.fine()))
}

fn fnv1a(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

#[test]
fn sources_md_lists_every_file_with_its_rows_and_checksum() {
    let tables = Path::new(env!("CARGO_MANIFEST_DIR")).join("tables");
    let sources = std::fs::read_to_string(tables.join("SOURCES.md")).expect("tables/SOURCES.md");
    let mut listed = BTreeSet::new();
    for line in sources.lines().filter(|line| line.contains(".csv |")) {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        let [file, name, publication, doi, license, check, rows, checksum] = cells[..] else {
            panic!("not eight cells: {line}")
        };
        assert!(cells.iter().all(|cell| !cell.is_empty()), "an empty cell: {line}");
        let bytes = std::fs::read(tables.join(file)).unwrap_or_else(|error| panic!("{file}: {error}"));
        let text = String::from_utf8(bytes.clone()).expect("a CSV is text");
        assert!(text.contains(&format!("# name: {name}\n")), "{file}: the name is not the header's");
        assert!(
            text.contains(&format!("# source: {publication}\n")),
            "{file}: the source is not the header's"
        );
        assert!(
            doi == "none" || doi.starts_with("10.25039/CIE.DS.") == (license == "CC BY-SA 4.0"),
            "{file}: the CIE publishes under one license"
        );
        let told = text.contains(&format!("# doi: {doi}\n")) || !doi.starts_with("10.25039");
        assert!(told, "{file}: the DOI is not the header's");
        let licensed = text.lines().any(|line| line.starts_with("# license: ") && line.contains(license));
        assert!(licensed, "{file}: the license is not the header's");
        let kinds = ["bytes of CIE_", "sums of CIE_", "made again", "golden 08"];
        assert!(kinds.iter().any(|kind| check.starts_with(kind)), "{file}: no such check: {check}");
        // One line of the data is the row of names.
        let data = text.lines().filter(|line| !line.starts_with('#')).count() - 1;
        assert_eq!(data.to_string(), rows, "{file}: rows");
        assert_eq!(format!("{:016x}", fnv1a(&bytes)), checksum, "{file}: checksum");
        assert!(listed.insert(file.to_string()), "{file} is listed twice");
    }
    let mut shipped = BTreeSet::new();
    for folder in ["cmf", "illuminants", "samples", "upsample"] {
        for entry in std::fs::read_dir(tables.join(folder)).expect("a folder of tables") {
            let name = entry.expect("an entry").file_name();
            shipped.insert(format!("{folder}/{}", name.to_str().expect("a plain name")));
        }
    }
    assert_eq!(listed, shipped);
    assert_eq!(fnv1a(b"foobar"), 0x85944171f73967e8, "the published test vector of FNV-1a");
}

/// The CIE publishes the sum of each column of its tables, to check copies by.
#[test]
fn every_column_has_the_sum_that_the_cie_publishes() {
    let sources = include_str!("../../tables/SOURCES.md");
    let (mut files, mut columns) = (0, 0);
    for row in golden("cie_published_sums").rows() {
        let (file, published) = (row.text("file"), row.text("published"));
        let said = sources.lines().find(|line| line.starts_with(&format!("| {file} |")));
        assert!(
            said.is_some_and(|line| line.contains(&format!(" of {published} |"))),
            "{file} in SOURCES.md"
        );
        let table = model::csv::table(file);
        let names = std::iter::once("wavelength_nm").chain(table.names().iter().map(String::as_str));
        let sums: Vec<f64> = row.text("sums").split(' ').map(|sum| sum.parse().expect("a sum")).collect();
        assert_eq!(sums.len(), table.names().len() + 1, "{file}: columns");
        for (name, sum) in names.zip(sums) {
            let own: f64 = table.column(name).iter().sum();
            assert!((own - sum).abs() <= 1e-12 * sum.abs(), "{file} {name}: {own}, the CIE has {sum}");
            columns += 1;
        }
        files += 1;
    }
    assert_eq!((files, columns), (27, 255));
}

#[test]
fn sums_and_peaks_of_the_functions_are_on_record() {
    let (mut sums, mut peaks) = (check("sums of the 1 nm functions"), check("peaks of the 1 nm functions"));
    let mut cones = check("sums of the cones, brought to 1 nm");
    let golden = golden("01b_cmf_sums");
    let (mut published, mut brought) = (0, 0);
    for row in golden.rows() {
        let weights = match row.text("id") {
            "cie_1931_2deg_xyz_1nm:x_bar" => &CIE_1931.weights()[0],
            "cie_1931_2deg_xyz_1nm:y_bar" => &CIE_1931.weights()[1],
            "cie_1964_10deg_xyz_1nm:z10_bar" => &CIE_1964.weights()[2],
            "cie_2015_2deg_xyz_1nm:zF_bar" => &CIE_2015_2.weights()[2],
            "cie_2015_10deg_xyz_1nm:yF10_bar" => &CIE_2015_10.weights()[1],
            "v_photopic_1nm:V" => &V_PHOTOPIC.weights()[0],
            "v_scotopic_1nm:V_prime" => &V_SCOTOPIC.weights()[0],
            "alpha_opic_s026_1nm:s_sc" => &ALPHA_OPIC.weights()[0],
            "alpha_opic_s026_1nm:s_mc" => &ALPHA_OPIC.weights()[1],
            "alpha_opic_s026_1nm:s_lc" => &ALPHA_OPIC.weights()[2],
            "alpha_opic_s026_1nm:s_mel" => &ALPHA_OPIC.weights()[4],
            "cie_2006_2deg_lms_1nm:l_bar" => &CIE_2006_LMS_2.weights()[0],
            "cie_2006_2deg_lms_1nm:m_bar" => &CIE_2006_LMS_2.weights()[1],
            "cie_2006_2deg_lms_1nm:s_bar" => &CIE_2006_LMS_2.weights()[2],
            "cie_2006_10deg_lms_1nm:l10_bar" => &CIE_2006_LMS_10.weights()[0],
            "cie_2006_10deg_lms_1nm:m10_bar" => &CIE_2006_LMS_10.weights()[1],
            other => panic!("{other}: a function that the crate does not have"),
        };
        let sum = |from: usize, to: usize, step: usize| -> f64 {
            weights[from - 360..=to - 360].iter().step_by(step).map(|w| f64::from(*w)).sum()
        };
        let (all, visible, coarse) = (sum(360, 830, 1), sum(380, 780, 1), sum(380, 780, 5));
        let columns = ["sum_1nm_full", "sum_1nm_380_780", "sum_5nm_380_780"];
        if row.text("id").starts_with("cie_2006") {
            // The golden's 1 nm cones are another table than the official 5 nm one that is shipped.
            cones.cells(row, columns, [all, visible, coarse]);
            brought += 1;
            continue;
        }
        sums.cells(row, columns, [all, visible, coarse]);
        let at = weights.iter().position(|w| *w >= weights.iter().copied().fold(0.0, f32::max));
        peaks.cell(row, "peak_nm", 360.0 + at.expect("a largest value") as f64);
        peaks.cell(row, "peak", weights[at.expect("a largest value")].into());
        published += 1;
    }
    sums.tight(3 * published);
    peaks.tight(2 * published);
    cones.tight(3 * brought);
    assert_eq!((published, brought), (11, 5), "rows of the golden");
}

#[test]
fn every_lamp_is_the_column_of_its_file_bit_for_bit() {
    for Entry(name, table, fine, ..) in &LAMPS {
        let series: String = name.chars().take_while(|c| c.is_alphabetic()).collect();
        let of_file = |suffix| -> Vec<f32> {
            let column = samples(&format!("illuminants/{series}_{suffix}.csv"), name);
            column.values.iter().map(|v| *v as f32).collect()
        };
        assert_eq!(table.values().as_slice(), of_file("5nm"), "{name}");
        assert_eq!(fine.is_none(), series == "HP", "{name}: HP lamps alone have no 1 nm table");
        if let Some(fine) = fine {
            assert_eq!(fine.values().as_slice(), of_file("1nm"), "{name}, 1 nm");
        }
    }
}

#[test]
fn lamps_have_the_chromaticity_that_cie_15_prints() {
    let mut xy = check("xy of lamps against CIE 15, 5 nm sums");
    for Entry(name, table, _, x, y, ..) in &LAMPS {
        let found = xy_at_5nm(table);
        xy.value(&format!("{name} x"), found.x.into(), (*x).into());
        xy.value(&format!("{name} y"), found.y.into(), (*y).into());
    }
    xy.tight(2 * LAMPS.len());
}

#[test]
fn standard_illuminants_have_the_chromaticity_that_cie_15_prints() {
    let (mut xy, mut at_1nm) =
        (check("xy of illuminants against CIE 15, 5 nm sums"), check("xy of illuminants, 1 nm sums"));
    let lights = [
        ("A", A.fine(), 0.44758, 0.40745),
        ("C", C.fine(), 0.31006, 0.31616),
        ("D50", D50.fine(), 0.34567, 0.35851),
        ("D55", D55.fine(), 0.33243, 0.34744),
        ("D65", D65.fine(), 0.31272, 0.32903),
        ("D75", D75.fine(), 0.29903, 0.31488),
    ];
    for (name, light, x, y) in &lights {
        let found = xy_at_5nm(light);
        xy.value(&format!("{name} x"), found.x.into(), *x);
        xy.value(&format!("{name} y"), found.y.into(), *y);
        // The others are 5 nm tables: straight lines between the nodes make them other lights.
        if ["A", "D50", "D65"].contains(name) {
            let found = xyz_at_1nm(light).xy().expect("a visible light");
            at_1nm.value(&format!("{name} x"), found.x.into(), *x);
            at_1nm.value(&format!("{name} y"), found.y.into(), *y);
        }
    }
    xy.tight(12);
    at_1nm.tight(6);
    // Indoor daylight, printed with four digits.
    for (light, x, y) in [(&ID50, 0.3432, 0.3602), (&ID65, 0.3107, 0.3307)] {
        let found = xy_at_5nm(light);
        assert!((found.x - x).abs() < 5e-5 && (found.y - y).abs() < 5e-5, "{found:?}");
    }
}

#[test]
fn lamps_have_the_cct_and_ra_that_cie_15_prints() {
    let (mut cct, mut ra) = (check("CCT of lamps against CIE 15"), check("Ra of lamps against CIE 15"));
    let mut with_ra = 0;
    for Entry(name, table, _, _, _, kelvin, index) in &LAMPS {
        let (found, _) = xy_at_5nm(table).uv1960().cct().near().expect("a white lamp");
        cct.value(name, found.into(), (*kelvin).into());
        if let Some(index) = index {
            let found = cri(&table.fine()).expect("a white lamp").ra;
            ra.value(name, found.into(), (*index).into());
            with_ra += 1;
        }
    }
    cct.tight(LAMPS.len());
    ra.tight(with_ra);
    assert_eq!(with_ra, 12, "FL1 to FL12");
}

#[test]
fn the_1nm_tables_are_the_lamps_of_their_5nm_tables() {
    let mut xy = check("xy of 1 nm lamps against their 5 nm tables");
    for Entry(name, table, other, ..) in &LAMPS {
        let Some(other) = other else { continue };
        let (a, b) = (xyz_at_1nm(*table).xy(), xyz_at_1nm(*other).xy());
        let (a, b) = (a.expect("a visible light"), b.expect("a visible light"));
        xy.value(&format!("{name} x"), a.x.into(), b.x.into());
        xy.value(&format!("{name} y"), a.y.into(), b.y.into());
    }
    xy.tight(2 * 36);
}

#[test]
fn no_two_tables_are_copies_of_each_other() {
    let mut all: Vec<(String, Fine<Power>)> = Vec::new();
    for Entry(name, table, other, ..) in &LAMPS {
        all.push((name.to_string(), table.fine()));
        if let Some(other) = other {
            all.push((format!("{name} 1 nm"), other.fine()));
        }
    }
    let others =
        [("A", A.fine()), ("C", C.fine()), ("D50", D50.fine()), ("D55", D55.fine()), ("D65", D65.fine())];
    all.extend(others.map(|(name, light)| (name.to_string(), light)));
    let others = [("D75", D75.fine()), ("ID50", ID50.fine()), ("ID65", ID65.fine()), ("L41", L41)];
    all.extend(others.map(|(name, light)| (name.to_string(), light)));
    // Nothing that the crate names is left out (but equal energy, which has no table).
    let tested: BTreeSet<String> = all.iter().map(|(name, _)| name.replace(" 1 nm", "_1NM")).collect();
    let named: BTreeSet<String> = light::NAMES.iter().skip(1).map(|name| name.to_string()).collect();
    assert_eq!(tested, named, "LAMPS or the others, and light::NAMES");
    assert_eq!((light::NAMES[0], all.len()), ("E", light::NAMES.len() - 1));
    for (name, light) in &all {
        assert_eq!(light::named(&name.replace(" 1 nm", "_1NM")).as_ref(), Some(light), "{name}");
    }
    // Brought to equal power, so that a scaled copy counts as one; what differs, of twice the power.
    let shares: Vec<Spectrum<Power, 471, _>> = all.iter().map(|(_, l)| *l * (1.0 / l.power())).collect();
    let (mut nearest, mut pair) = (f32::INFINITY, String::new());
    for i in 0..all.len() {
        for j in 0..i {
            // L41 of CIE 251 is modeled on LED-B3.
            if all[i].0 == format!("{} 1 nm", all[j].0) || all[i].0 == "L41" && all[j].0.starts_with("LED-B3")
            {
                continue;
            }
            let difference = (shares[i] - shares[j]).values().map(f32::abs).iter().sum::<f32>() / 2.0;
            if difference < nearest {
                (nearest, pair) = (difference, format!("{} and {}", all[i].0, all[j].0));
            }
        }
    }
    println!("nearest two: {pair}, {nearest}");
    assert_ne!(LED_B3_1NM.fine(), L41);
    assert!(nearest > 0.01, "{pair} differ by only {nearest} of their power");
}

#[test]
fn fl11_is_a_triphosphor_lamp_and_fl2_is_not() {
    // A triphosphor lamp has its power in three narrow bands; a halophosphate one in broad ones.
    let in_bands = |light: &Lamp| {
        let bands = [(430.0, 440.0), (485.0, 495.0), (540.0, 550.0), (605.0, 620.0)];
        bands.iter().map(|(from, to)| light.within(*from, *to).power()).sum::<f32>() / light.power()
    };
    let (fl11, fl2) = (in_bands(lamp("FL11").1), in_bands(lamp("FL2").1));
    assert!(fl11 > 0.55 && fl2 < 0.35, "{fl11} {fl2}");
    let found = cri(&lamp("FL11").1.fine()).expect("a white lamp");
    assert!((found.cct_k - 4000.0).abs() < 5.0 && (found.ra - 83.0).abs() < 0.5, "{found:?}");
    assert!(found.r[8] < 50.0, "R9 of a triphosphor lamp is poor: {}", found.r[8]);
}

#[test]
fn duv_is_positive_above_the_locus_and_negative_below() {
    let duv = |xy: Xy| match xy.uv1960().cct() {
        Cct::Near { duv, .. } => duv,
        other => panic!("{other:?}"),
    };
    let d65 = duv(xyz_at_1nm(&D65).xy().expect("visible"));
    assert!((d65 - 0.0032).abs() < 5e-5, "{d65}");
    assert!(duv(xyz_at_1nm(&A).xy().expect("visible")).abs() < 1e-5);
    // Green is above, purple below.
    assert!(duv(Xy::new(0.3127, 0.3490)) > 0.01 && duv(Xy::new(0.3127, 0.3090)) < -0.005);
}

#[test]
fn the_documentation_of_a_light_says_its_color() {
    // What the build script has written, with the documentation of every light.
    let text = include_str!(concat!(env!("OUT_DIR"), "/illuminants.rs"));
    let mut lights = 0;
    for line in text.lines().filter(|line| line.contains(" with a CCT of ")) {
        let (name, rest) = line.trim_start_matches("/// CIE ").split_once(" is ").expect(line);
        let fine = light::named(&format!("{name}_1NM")).filter(|_| rest.ends_with(" steps of 1 nm."));
        let xyz = Xyz::from(CIE_1931.sees(&fine.or_else(|| light::named(name)).expect(line)));
        let (Some(xy), Some(Cct::Near { cct_k, .. })) = (xyz.xy(), xyz.cct()) else { panic!("{line}") };
        let found = format!(" with a CCT of {cct_k:.0} K (x = {:.4}, y = {:.4}), here in", xy.x, xy.y);
        assert!(line.contains(&found), "{line} {found}");
        lights += 1;
    }
    // Equal energy has no table.
    assert_eq!(lights, light::NAMES.len() - 1);
}
