//! The crate against published and precomputed values: light, interpolation, chromaticity.

use model::allowed::check;
use model::csv::{Row, golden};
use model::interpolation::{Interpolation as By, Outside as Beyond, Samples};
use model::photometry::Photometry;
use model::tables::{reflectance, source};
use nanospectra::color::{Cct, Uv1960, Xy, Xyz, dominant_wavelength};
use nanospectra::light::{blackbody_exitance, blackbody_peak_nm, daylight, daylight_xy};
use nanospectra::observer::{ALPHA_OPIC, CIE_1931, CIE_1964, CIE_2015_2, CIE_2015_10};
use nanospectra::radiometry::{
    AlphaOpic, illuminance, luminous_efficacy, photon_flux, ppfd, scotopic_illuminance,
};
use nanospectra::{Factor, Fine, FineObserver, Interpolation, Nodes, Outside, Power, Spectrum};

fn observer(name: &str) -> &'static FineObserver<3> {
    match name {
        "1931_2" => &CIE_1931,
        "1964_10" => &CIE_1964,
        "2015_2" => &CIE_2015_2,
        "2015_10" => &CIE_2015_10,
        _ => panic!("no observer called {name}"),
    }
}

/// Samples as a program would have them: pairs of f32.
fn pairs(samples: &Samples) -> Vec<(f32, f32)> {
    samples.points().iter().map(|(nm, value)| (*nm as f32, *value as f32)).collect()
}

fn fine(samples: &Samples, by: Interpolation, outside: Outside) -> Fine<Power> {
    Fine::interpolated_outside(&pairs(samples), by, outside).expect("a golden source is a good spectrum")
}

fn sprague(id: &str) -> Fine<Power> {
    fine(&source(id), Interpolation::Sprague, Outside::Zero)
}

#[test]
fn every_golden_light_has_its_xyz_from_its_samples() {
    let (mut linear, mut zero, mut hold, mut xy) = (
        check("XYZ of lights, linear to 1 nm"),
        check("XYZ of lights, Sprague to 1 nm, zero outside"),
        check("XYZ of lights, Sprague to 1 nm, held outside"),
        check("xy of lights"),
    );
    let mut rows = [0; 3];
    for row in golden("01_xyz_sources").rows() {
        let (method, by, outside, check) = match row.text("method") {
            "linear_zero" => (0, Interpolation::Linear, Outside::Zero, &mut linear),
            "sprague_zero" => (1, Interpolation::Sprague, Outside::Zero, &mut zero),
            "sprague_const" => (2, Interpolation::Sprague, Outside::Hold, &mut hold),
            // Sums over the native steps are no rule of the crate.
            _ => continue,
        };
        rows[method] += 1;
        let light = fine(&source(row.text("id")), by, outside);
        let xyz = Xyz::from(observer(row.text("observer")).sees(&light));
        let relative = xyz.with_y(100.0).expect("a visible light");
        check.cells(row, ["X", "Z"], [relative.x, relative.z].map(f64::from));
        let point = xyz.xy().expect("a visible light");
        xy.cells(row, ["x", "y"], [point.x, point.y].map(f64::from));
    }
    linear.tight(2 * rows[0]);
    zero.tight(2 * rows[1]);
    hold.tight(2 * rows[2]);
    xy.tight(2 * (rows[0] + rows[1] + rows[2]));
    assert_eq!(rows, [82, 252, 126], "rows of the golden");
}

#[test]
fn values_between_samples_are_the_published_ones() {
    let (mut linear, mut sprague) = (check("interpolation, linear"), check("interpolation, Sprague"));
    let mut rows = 0;
    for row in golden("01c_interpolation").rows() {
        let (file, column) = row.text("series").split_once(':').expect("file:column");
        let samples = pairs(&model::tables::samples(file, column));
        let nm = row.number("wavelength_nm");
        // Grids are types: one of quarter nanometers has a node at all but the odd wavelengths.
        if nm * 4.0 != (nm * 4.0).round() || !(360.0..=830.0).contains(&nm) {
            continue;
        }
        let at = |by| f64::from(quarter_nanometer(nm, &samples, by));
        linear.cell(row, "linear", at(Interpolation::Linear));
        sprague.cell(row, "sprague", at(Interpolation::Sprague));
        rows += 1;
    }
    linear.tight(rows);
    sprague.tight(rows);
    assert_eq!(rows, 116, "rows of the golden");
}

/// The value at a wavelength on the grid of quarter nanometers over 360..=830.
fn quarter_nanometer(nm: f64, samples: &[(f32, f32)], by: Interpolation) -> f32 {
    let spectrum = Spectrum::<Power, 1881, Nodes<360, 830>>::interpolated(samples, by)
        .expect("a golden series is a good spectrum");
    spectrum.values()[((nm - 360.0) * 4.0) as usize]
}

fn near(outcome: Cct, place: &str) -> (f64, f64) {
    let (cct_k, duv) = outcome.near().unwrap_or_else(|| panic!("{place}: {outcome:?}"));
    (f64::from(cct_k), f64::from(duv))
}

#[test]
fn cct_and_duv_are_those_of_the_nearest_black_body() {
    let (mut cct, mut duv) = (check("CCT of the grid, mired"), check("Duv of the grid"));
    let golden = golden("02_cct_grid");
    for row in golden.rows() {
        let uv = Uv1960 { u: row.number("u") as f32, v: row.number("v") as f32 };
        let (t, d) = near(uv.cct(), &row.place());
        cct.value(&row.place(), 1e6 / t, 1e6 / row.number("T_exact"));
        duv.cell(row, "Duv_exact", d);
    }
    cct.tight(golden.len());
    duv.tight(golden.len());
}

#[test]
fn cct_holds_up_to_a_million_kelvin() {
    let mut cct = check("CCT hotter than the grid, mired");
    let mut duv = check("Duv hotter than the grid");
    for step in 0..=40 {
        let mired = 1.0 + f64::from(step);
        for offset in [-0.05, -0.02, -0.001, 0.0, 0.001, 0.02, 0.05] {
            let [u, v] = model::cct::uv_at(1e6 / mired, offset);
            let place = format!("{mired} mired, Duv {offset}");
            let (t, d) = near(Uv1960 { u: u as f32, v: v as f32 }.cct(), &place);
            cct.value(&place, 1e6 / t, mired);
            duv.value(&place, d, offset);
        }
    }
    cct.tight_over_all();
    duv.tight_over_all();
}

#[test]
fn lights_have_their_cct_or_a_reason() {
    let (mut cct, mut duv) = (check("CCT of lights, mired"), check("Duv of lights"));
    let (mut rows, mut off) = (0, 0);
    for row in golden("02_cct_sources").rows() {
        let uv = Xyz::from(CIE_1931.sees(&sprague(row.text("id")))).uv1960().expect("visible");
        if row.number("Duv_exact").abs() > 0.05 {
            assert_eq!(uv.cct(), Cct::OffLocus, "{}", row.place());
            off += 1;
            continue;
        }
        let (t, d) = near(uv.cct(), &row.place());
        cct.value(&row.place(), 1e6 / t, 1e6 / row.number("T_exact"));
        duv.cell(row, "Duv_exact", d);
        rows += 1;
    }
    cct.tight(rows);
    duv.tight(rows);
    assert_eq!(rows + off, 63, "rows of the golden");
}

#[test]
fn daylight_follows_the_formula() {
    let (mut xy, mut spd) = (check("daylight chromaticity"), check("daylight spectrum"));
    let golden = golden("02_cie_daylight");
    for row in golden.rows() {
        let t = row.number("T") as f32;
        let point = daylight_xy(t).expect("in range");
        xy.cells(row, ["xD", "yD"], [point.x, point.y].map(f64::from));
        let light = daylight(t).expect("in range");
        let at = |nm: usize| f64::from(light.values()[(nm - 300) / 5]);
        spd.cells(row, ["S460", "S560", "S650"], [at(460), at(560), at(650)]);
    }
    xy.tight(2 * golden.len());
    spd.tight(3 * golden.len());
    assert!(daylight(3999.0).is_none() && daylight(25001.0).is_none() && daylight(f32::NAN).is_none());
}

#[test]
fn photometric_and_other_weighted_sums_are_right() {
    let mut ler = check("luminous efficacy");
    let mut scotopic = check("scotopic over photopic");
    let mut alpha = check("alpha-opic ratios");
    let mut photons = check("photons from one wavelength to another");
    let golden = golden("07_photometry_sources");
    for row in golden.rows() {
        let light = sprague(row.text("id"));
        let power = light.power();
        ler.cell(row, "LER_683.002", luminous_efficacy(&light).expect("power").into());
        let ratio = scotopic_illuminance(&light) / illuminance(&light);
        // The golden's ratio is to 683, the crate's to 683.002 lm/W.
        let ratio_683 = f64::from(ratio) * 683.002 / 683.0;
        scotopic.cell(row, "SP_ratio_1700_683", ratio_683);
        let der = AlphaOpic::der(&light).expect("visible");
        alpha.cells(
            row,
            ["DER_sc", "DER_mc", "DER_lc", "DER_rh", "DER_mel"],
            [der.s_cone, der.m_cone, der.l_cone, der.rhodopic, der.melanopic].map(f64::from),
        );
        let exact = Photometry::of(&source(row.text("id")).on_cie_grid(By::Sprague, Beyond::Zero));
        for (from, to) in [(400, 700), (400, 750), (655, 665), (725, 735), (700, 800)] {
            let found = f64::from(photon_flux(&light, f32::from(from), f32::from(to)) / power);
            photons.value(&format!("{} {from}", row.text("id")), found, exact.photons(from, to));
        }
        assert_eq!(ppfd(&light), photon_flux(&light, 400.0, 700.0));
    }
    ler.tight(golden.len());
    scotopic.tight(golden.len());
    alpha.tight(5 * golden.len());
    photons.tight(5 * golden.len());
    assert_eq!(ALPHA_OPIC.weights().len(), 5);
}

#[test]
fn dominant_wavelengths_lie_on_the_ray_from_the_white() {
    let (mut nm, mut purity) = (check("dominant wavelength, nm"), check("excitation purity"));
    let (mut rows, mut edges) = (0, 0);
    for row in golden("11_dominant_wavelength").rows() {
        let point = |x, y| Xy { x: row.number(x) as f32, y: row.number(y) as f32 };
        let found = dominant_wavelength(point("x", "y"), point("xw", "yw"), observer(row.text("observer")))
            .unwrap_or_else(|| panic!("{}: no dominant wavelength", row.place()));
        if row.number("edge") == 1.0 {
            assert!(found.nm.is_finite() && found.purity > 0.0, "{}", row.place());
            edges += 1;
            continue;
        }
        nm.cell(row, "dominant_nm", found.nm.into());
        purity.cell(row, "Pe", found.purity.into());
        rows += 1;
    }
    nm.tight(rows);
    purity.tight(rows);
    println!("{rows} rows, {edges} at the ends of the locus");
    assert!(rows > 500, "rows of the golden");
}

#[test]
fn every_laser_is_its_own_dominant_wavelength() {
    let equal_energy = Xy::new(1.0 / 3.0, 1.0 / 3.0);
    for eye in [&CIE_1931, &CIE_1964, &CIE_2015_2, &CIE_2015_10] {
        let [x, y, z] = eye.weights();
        let mut lasers = 0;
        for k in 20..471 {
            let Some(xy) = Xyz::new(x[k], y[k], z[k]).xy() else { continue };
            let (nm, found) = (360.0 + k as f32, dominant_wavelength(xy, equal_energy, eye));
            let found = found.unwrap_or_else(|| panic!("{nm} nm has no dominant wavelength"));
            assert!(found.nm > 0.0 && found.purity <= 1.0, "{nm} nm: {found:?}");
            // Beyond these the locus folds back, and two wavelengths have one hue.
            assert!(!(410.0..=690.0).contains(&nm) || (found.nm - nm).abs() < 0.5, "{nm} nm: {found:?}");
            lasers += 1;
        }
        assert!(lasers >= 441, "{lasers} lasers");
    }
}

#[test]
fn surfaces_under_lights_have_their_xyz() {
    let mut check = check("surfaces under lights");
    let mut rows = 0;
    for row in golden("04_reflectance_colorimetry").rows() {
        let eye = observer(row.text("observer"));
        let light = sprague_or_flat(row.text("illuminant"));
        let samples = match row.text("sample").split_once(':') {
            Some(("VS", _)) | None => continue,
            _ => pairs(&reflectance(row.text("sample"))),
        };
        let by = Interpolation::Sprague;
        let surface: Fine<Factor> = Fine::interpolated(&samples, by).expect("a good sample");
        let xyz = eye.under(&light).with_white_y(100.0).sees(&surface);
        check.cells(row, ["X", "Y", "Z"], xyz.map(f64::from));
        rows += 1;
    }
    check.tight(3 * rows);
    assert!(rows > 1000, "{rows} rows of the golden");
}

fn sprague_or_flat(id: &str) -> Fine<Power> {
    if id == "E" { Fine::flat(1.0) } else { sprague(id) }
}

#[test]
fn a_black_body_has_stefans_exitance_and_wiens_peak() {
    let (mut exitance, mut peak) = (check("black body exitance"), check("black body peak"));
    let golden = golden("06_wien_stefan");
    for row in golden.rows() {
        let t = kelvin(row);
        exitance.cell(row, "M_sigmaT4_W_m2", blackbody_exitance(t).into());
        peak.cell(row, "peak_lambda_nm", blackbody_peak_nm(t).into());
    }
    exitance.tight(golden.len());
    peak.tight(golden.len());
}

fn kelvin(row: Row<'_>) -> f32 {
    row.number("T") as f32
}
