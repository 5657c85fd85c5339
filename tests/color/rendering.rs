//! Color rendering against the goldens: CIE 13.3, TM-30-18 and the spectral similarity index.
#![cfg(feature = "libm")]

use model::allowed::check;
use model::cri::{Method, Mode};
use model::csv::{Row, golden};
use model::tables::source;
use nanospectra::color::{RenderingError, cri, ssi, tm30};
use nanospectra::light::blackbody_relative;
use nanospectra::{Fine, Interpolation, Power};

/// The goldens' rule: Sprague to 1 nm, nothing outside.
fn light(id: &str) -> Fine<Power> {
    let samples: Vec<(f32, f32)> =
        source(id).points().iter().map(|(nm, value)| (*nm as f32, *value as f32)).collect();
    Fine::interpolated(&samples, Interpolation::Sprague).expect("a good spectrum")
}

/// What is found for the light of a row; nothing of one that is no white.
fn found<T>(row: Row<'_>, index: fn(&Fine<Power>) -> Result<T, RenderingError>) -> Option<T> {
    let no_white = |error| assert!(row.number("Duv").abs() > 0.05, "{}: {error}", row.place());
    index(&light(row.text("id"))).map_err(no_white).ok()
}

#[test]
fn cri_is_that_of_the_goldens() {
    let (mut ra, mut r) = (check("Ra"), check("R1 to R15"));
    let (mut rows, mut refused) = (0, 0);
    for row in golden("03_cri").rows().filter(|row| row.text("mode") == "1nm") {
        let Some(found) = found(row, cri) else {
            refused += 1;
            continue;
        };
        ra.cell(row, "Ra", found.ra.into());
        for (k, value) in found.r.iter().enumerate() {
            r.cell(row, &format!("R{}", k + 1), f64::from(*value));
        }
        rows += 1;
    }
    ra.tight(rows);
    r.tight(15 * rows);
    assert_eq!(rows + refused, 63, "rows of the golden");
}

/// The references below 5000 K are series; a black body of any of their temperatures is its own.
#[test]
fn black_bodies_render_colors_perfectly() {
    let mut r = check("R1 to R15 of black bodies");
    let kelvins = (1001..4999).step_by(31);
    for kelvin in kelvins.clone() {
        let light = Fine::at_centers(|nm| blackbody_relative(nm, kelvin as f32));
        for value in cri(&light).expect("a white").r {
            r.value(&format!("{kelvin} K"), value.into(), 100.0);
        }
    }
    r.tight(15 * kelvins.count());
}

/// Every nanometer counts, at the ends of the range as in the middle of a step of 5 nm between two samples.
#[test]
fn a_line_anywhere_shows_in_every_sample() {
    let method = Method::new(Mode::OneNm);
    let mut r = check("R1 to R14 of lights with a line");
    let lines = (360..=830).step_by(3).chain([361, 362, 364, 826, 828, 829, 830]);
    for nm in lines.clone() {
        let mut light = Fine::at_centers(|nm| blackbody_relative(nm, 4000.0));
        let height = if (400..=700).contains(&nm) { 5.0 } else { 1e3 };
        if let Some(value) = light.values_mut().get_mut(nm - 360) {
            *value += height;
        }
        let found = cri(&light).expect("a white");
        let expected = method.of_values(&light.values().map(f64::from));
        for (k, (found, expected)) in found.r.iter().zip(expected.r).take(14).enumerate() {
            r.value(&format!("R{} with {nm} nm", k + 1), f64::from(*found), expected);
        }
    }
    r.tight(14 * lines.count());
}

#[test]
fn tm30_is_that_of_the_goldens() {
    let (mut rf, mut rg) = (check("Rf"), check("Rg"));
    let (mut local, mut chroma, mut hue) =
        (check("Rf of hue bins"), check("chroma shift"), check("hue shift"));
    let mut samples = check("Rf of samples");
    let (mut rows, mut refused, mut clear, mut listed) = (0, 0, 0, 0);
    for row in golden("03_tm30").rows().filter(|row| row.text("mode") == "1nm") {
        let Some(found) = found(row, tm30) else {
            refused += 1;
            continue;
        };
        rows += 1;
        rf.cell(row, "Rf", found.rf.into());
        let each = golden("03_tm30_rfi");
        if let Some(row) = each.rows().find(|r| r.text("id") == row.text("id") && r.text("mode") == "1nm") {
            listed += 1;
            for (k, value) in found.rf_ces.iter().enumerate() {
                samples.cell(row, &format!("Rf{:02}", k + 1), f64::from(*value));
            }
        }
        // Where a sample sits on the edge between two bins, rounding decides where it counts.
        if row.number("min_hue_bin_edge_deg") > 0.05 {
            clear += 1;
            rg.cell(row, "Rg", found.rg.into());
            for (k, bin) in found.bins.iter().enumerate() {
                let bin = bin.expect("every bin holds samples");
                local.cell(row, &format!("Rfh{}", k + 1), bin.rf.into());
                chroma.cell(row, &format!("Rcs{}", k + 1), bin.chroma_shift.into());
                hue.cell(row, &format!("Rhs{}", k + 1), bin.hue_shift.into());
            }
        }
    }
    println!("{rows} lights, {clear} clear of bin edges, {listed} with samples listed");
    rf.tight(rows);
    rg.tight(clear);
    samples.tight(99 * listed);
    local.tight(16 * clear);
    chroma.tight(16 * clear);
    hue.tight(16 * clear);
    assert_eq!(rows + refused, 63, "rows of the golden");
}

#[test]
fn darkness_and_colors_have_no_rendering() {
    assert_eq!(cri(&Fine::flat(0.0)), Err(RenderingError::Dark));
    assert_eq!(tm30(&Fine::flat(0.0)), Err(RenderingError::Dark));
    let mut green = Fine::flat(0.0);
    assert_eq!(green.add_line(530.0, 1.0), 0.0);
    assert!(matches!(cri(&green), Err(RenderingError::NoReference(_))));
    assert!(matches!(tm30(&green), Err(RenderingError::NoReference(_))));
}

/// The spectral similarity index of colour-science 0.4.7, which interpolates linearly, before it is rounded.
#[test]
fn the_similarity_of_lights_is_that_of_colour_science() {
    let mut index = check("spectral similarity index");
    let pairs = [
        ("FL2", "D65", 58.262198),
        ("D55", "D65", 90.624895),
        ("C", "D65", 94.182971),
        ("E", "D65", 89.546928),
        ("FL11", "C", 27.391060),
        ("LED-B3", "FL4", 49.657064),
        ("HP1", "FL4", 48.247372),
        ("FL7", "D55", 83.439600),
        ("D65", "FL2", 63.737468),
        ("LED-RGB1", "D75", -0.133365),
    ];
    for (light, reference, expected) in pairs {
        let [of, to] = [light, reference].map(|name| nanospectra::light::named(name).expect("a light"));
        let found = ssi(&of, &to).expect("lights");
        index.value(&format!("{light} to {reference}"), found.into(), expected);
        assert_eq!(ssi(&of, &of), Some(100.0));
        // Brightness does not count.
        assert!((ssi(&(of * 1e6), &to).expect("lights") - found).abs() < 1e-4);
    }
    index.tight(pairs.len());
    let (dark, e) = (Fine::<Power>::flat(0.0), Fine::<Power>::flat(1.0));
    assert_eq!((ssi(&dark, &e), ssi(&e, &dark)), (None, None));
    assert!(ssi(&Fine::flat(f32::NAN), &e).is_some_and(f32::is_nan));
}

/// A light with a negative line: white as daylight, but the red sample would reflect less than nothing of it.
#[test]
fn a_sample_without_light_is_no_color() {
    use nanospectra::observer::CIE_1931;
    let lines = [450, 595, 640];
    let rows = CIE_1931.weights();
    let columns = [0, 1, 2].map(|row: usize| lines.map(|nm| f64::from(rows[row][nm - 360])));
    let white = [0.9642, 1.0, 0.8249];
    let powers = model::linear::apply(model::linear::inverse(columns), white);
    assert!(powers[0] > 0.0 && powers[1] > 0.0 && powers[2] < 0.0, "{powers:?}");
    let samples: Vec<(f32, f32)> = (360..=830)
        .map(|nm| (nm as f32, lines.iter().position(|line| *line == nm).map_or(0.0, |k| powers[k] as f32)))
        .collect();
    let lamp = Fine::interpolated(&samples, Interpolation::Linear).expect("a good spectrum");
    assert_eq!(cri(&lamp).map(|found| found.ra), Err(RenderingError::Unreal));
    assert_eq!(tm30(&lamp).map(|found| found.rf), Err(RenderingError::Unreal));
}
