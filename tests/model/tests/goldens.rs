//! Is the f64 model itself right? Lights: every golden it can compute, every row, at the digits
//! printed. `color_goldens.rs` goes on with surfaces and color spaces.

use model::cct::{cct, cct_codata, planckian, uv_at};
use model::check::Check;
use model::chromaticity::{uv1960, xy};
use model::cri::{self, Mode};
use model::csv::golden;
use model::interpolation::{Interpolation, Outside};
use model::photometry::{KM_SCOTOPIC, Photometry, d65_elr};
use model::tables::{Observer, samples, source};
use model::tm30::{self, Mix};
use model::tristimulus::{Method, xyz_of_light};
use model::{daylight, planck};

/// A light on the CIE grid the way most goldens want it: Sprague, zero outside.
fn light(id: &str) -> Vec<f64> {
    source(id).on_cie_grid(Interpolation::Sprague, Outside::Zero)
}

fn uv_of_source(id: &str) -> [f64; 2] {
    uv1960(xyz_of_light(&source(id), Observer::Cie1931, Method::SpragueZero).0)
}

#[test]
fn every_light_has_its_published_tristimulus_values() {
    let mut check = Check::new("01 XYZ of lights", 1e-10, 2e-11);
    for row in golden("01_xyz_sources").rows() {
        let observer = Observer::named(row.text("observer"));
        let method = Method::named(row.text("method"));
        let ([x, y, z], k) = xyz_of_light(&source(row.text("id")), observer, method);
        let [small_x, small_y] = xy([x, y, z]);
        check.cells(row, ["X", "Y", "Z", "x", "y", "k"], [x, y, z, small_x, small_y, k]);
    }
    check.finish(542 * 6);
}

#[test]
fn the_functions_sum_to_their_checksums() {
    let mut check = Check::new("01b sums of functions", 0.0, 1e-11);
    for row in golden("01b_cmf_sums").rows() {
        let (file, column) = row.text("id").split_once(':').expect("file:column");
        if file.starts_with("cie_2006") {
            continue; // the 1 nm LMS tables are not at hand, only the official 5 nm ones
        }
        let function = samples(&format!("cmf/{file}.csv"), column);
        let at = |nm: f64| function.at(nm, Interpolation::Linear, Outside::Zero);
        let sum = |step| (380..=780).step_by(step).map(|nm| at(f64::from(nm))).sum::<f64>();
        check.cell(row, "sum_1nm_full", function.values.iter().sum());
        check.cell(row, "sum_1nm_380_780", sum(1));
        check.cell(row, "sum_5nm_380_780", sum(5));
        check.cell(row, "peak", function.values.iter().copied().fold(0.0, f64::max));
        check.cell(row, "peak", at(row.number("peak_nm")));
    }
    check.finish(11 * 5);
}

#[test]
fn between_samples_lies_the_line_and_the_sprague_quintic() {
    let mut check = Check::new("01c interpolation", 1e-12, 4e-13);
    for row in golden("01c_interpolation").rows() {
        let (file, column) = row.text("series").split_once(':').expect("file:column");
        let series = samples(file, column);
        let at = |between| series.at(row.number("wavelength_nm"), between, Outside::Zero);
        check.cell(row, "sprague", at(Interpolation::Sprague));
        check.cell(row, "linear", at(Interpolation::Linear));
    }
    check.finish(240 * 2);
}

#[test]
fn the_planckian_locus_and_its_slope_are_exact() {
    let mut check = Check::new("02 Planckian locus", 0.0, 1e-12);
    for row in golden("02_planckian_locus").rows() {
        let ([u, v], [du, dv]) = planckian(row.number("T"), planck::C2_CIE);
        check.cells(row, ["u", "v", "du_dT", "dv_dT"], [u, v, du, dv]);
    }
    check.finish(38 * 4);
}

#[test]
fn points_on_the_normal_find_back_to_their_temperature() {
    let mut built = Check::new("02 grid: construction", 1e-12, 0.0);
    let mut temperature = Check::new("02 grid: CCT", 0.0, 1e-10);
    let mut distance = Check::new("02 grid: Duv", 1e-12, 0.0);
    for row in golden("02_cct_grid").rows() {
        let uv = row.numbers(["u", "v"]);
        built.cells(row, ["u", "v"], uv_at(row.number("T_true"), row.number("Duv_true")));
        let (cie, codata) = (cct(uv), cct_codata(uv));
        temperature.cell(row, "T_exact", cie.cct_k);
        temperature.cell(row, "T_exact_c2codata", codata.cct_k);
        distance.cell(row, "Duv_exact", cie.duv);
        distance.cell(row, "Duv_exact_c2codata", codata.duv);
    }
    built.finish(538 * 2);
    temperature.finish(538 * 2);
    distance.finish(538 * 2);
}

#[test]
fn every_light_has_its_color_temperature() {
    let mut check = Check::new("02 CCT and uv of lights", 2e-12, 1e-11);
    let mut distance = Check::new("02 Duv of lights", 1e-12, 0.0);
    for row in golden("02_cct_sources").rows() {
        let uv = uv_of_source(row.text("id"));
        check.cells(row, ["u", "v"], uv);
        let (cie, codata) = (cct(uv), cct_codata(uv));
        check.cell(row, "T_exact", cie.cct_k);
        check.cell(row, "T_exact_c2codata", codata.cct_k);
        distance.cell(row, "Duv_exact", cie.duv);
        distance.cell(row, "Duv_exact_c2codata", codata.duv);
    }
    check.finish(63 * 4);
    distance.finish(63 * 2);
}

#[test]
fn cie_daylight_has_its_published_color() {
    let mut check = Check::new("02 daylight", 2e-11, 1e-11);
    for row in golden("02_cie_daylight").rows() {
        let kelvin = row.number("T");
        check.cells(row, ["xD", "yD"], daylight::xy(kelvin));
        let factors = daylight::factors(kelvin);
        check.cells(row, ["M1", "M2"], factors);
        for (factors, suffix) in [(factors, ""), (daylight::rounded_factors(kelvin), "_r3")] {
            let spectrum = daylight::spectrum(factors);
            let (xyz, _) = xyz_of_light(&spectrum, Observer::Cie1931, Method::LinearZero);
            let ([x, y], found) = (xy(xyz), cct(uv1960(xyz)));
            let got = [xyz[0], xyz[2], x, y, found.cct_k, found.duv];
            for (name, value) in ["X", "Z", "x", "y", "T_exact", "Duv_exact"].iter().zip(got) {
                check.cell(row, &format!("{name}{suffix}"), value);
            }
        }
        let spectrum = daylight::on_cie_grid(factors);
        let at = |nm: usize| spectrum[nm - 360];
        check.cells(row, ["S460", "S560", "S650"], [at(460), at(560), at(650)]);
    }
    check.finish(13 * 19);
}

#[test]
fn cri_agrees_for_every_light() {
    let mut check = Check::new("03 CRI", 1e-9, 2e-12);
    let methods = [Mode::OneNm, Mode::FiveNm].map(cri::Method::new);
    for row in golden("03_cri").rows() {
        let method = &methods[Mode::named(row.text("mode")) as usize];
        let light = source(row.text("id"));
        let got = method.of(&light);
        check.cells(row, ["T", "Duv", "dC", "Ra"], [got.cct.cct_k, got.cct.duv, got.dc, got.ra]);
        check.cell(row, "Ra_r3", method.of_rounded(&light).ra);
        for (k, r) in got.r.iter().enumerate() {
            check.cell(row, &format!("R{}", k + 1), *r);
        }
    }
    check.finish(104 * 20);
}

#[test]
fn tm30_agrees_for_every_light() {
    let mut check = Check::new("03 TM-30", 1e-9, 4e-12);
    let mut binned = Check::new("03 TM-30 hue bins", 1e-9, 4e-12);
    let methods = [Mode::OneNm, Mode::FiveNm].map(tm30::Method::new);
    for row in golden("03_tm30").rows() {
        let method = &methods[Mode::named(row.text("mode")) as usize];
        let light = source(row.text("id"));
        let got = method.of(&light);
        let mix10 = method.with_mix(&light, Mix::Cie1964);
        check.cells(row, ["T", "Duv"], [got.cct.cct_k, got.cct.duv]);
        check.cells(row, ["Rf", "Rf_mix10"], [got.rf, mix10.rf]);
        check.cell(row, "min_hue_bin_edge_deg", got.nearest_edge_deg);
        binned.cells(row, ["Rg", "Rg_mix10"], [got.rg, mix10.rg]);
        for j in 0..16 {
            binned.cell(row, &format!("Rfh{}", j + 1), got.rfh[j]);
            binned.cell(row, &format!("Rcs{}", j + 1), got.rcs[j]);
            binned.cell(row, &format!("Rhs{}", j + 1), got.rhs[j]);
        }
    }
    check.finish(104 * 5);
    binned.finish(104 * 50);
}

#[test]
fn each_of_the_99_samples_has_its_fidelity() {
    let mut check = Check::new("03 TM-30 samples", 1e-9, 4e-12);
    let methods = [Mode::OneNm, Mode::FiveNm].map(tm30::Method::new);
    for row in golden("03_tm30_rfi").rows() {
        let got = methods[Mode::named(row.text("mode")) as usize].of(&source(row.text("id")));
        for (k, rf) in got.rf_ces.iter().enumerate() {
            check.cell(row, &format!("Rf{:02}", k + 1), *rf);
        }
    }
    check.finish(63 * 99);
}

#[test]
fn radiation_constants_follow_from_the_si() {
    let mut check = Check::new("06 constants", 0.0, 1e-14);
    let golden = golden("06_constants");
    let wien = planck::peak_x(3.0) * planck::K / planck::H;
    for (name, value) in [
        ("c1=2*pi*h*c^2", planck::C1),
        ("sigma", planck::stefan_boltzmann()),
        ("wien_b_nu_HzperK", wien),
        ("x_peak_nu", planck::peak_x(3.0)),
        ("V_at_540THz_nm_vac", planck::C / 540e12 * 1e9),
    ] {
        check.cell(golden.find("name", name), "value", value);
    }
    check.finish(golden.len());
}

#[test]
fn planck_radiates_what_sixty_digits_say() {
    let mut check = Check::new("06 Planck", 0.0, 1e-12);
    for row in golden("06_planck").rows() {
        let [nm, t] = row.numbers(["wavelength_nm", "T"]);
        check.cell(row, "x", planck::x(nm, t));
        check.cell(row, "ln_B_lambda", planck::ln_radiance(nm, t));
        for (column, law) in [
            ("B_lambda", planck::radiance as fn(f64, f64) -> f64),
            ("photon_radiance", planck::photon_radiance),
            ("dB_dT", planck::radiance_per_kelvin),
            ("B_nu", planck::radiance_per_hertz),
            ("B_cie", planck::radiance_cie),
        ] {
            // x itself carries an error of an ulp or two, which e^x makes x times larger
            if row.number(column) > 1e-290 && planck::x(nm, t) < 700.0 {
                check.cell(row, column, law(nm, t));
            } else {
                assert!(law(nm, t) < 1e-280, "{} {column}", row.place());
            }
        }
    }
    // 371 of 4263 are too small to compare
    check.finish(609 * 7 - 371);
}

#[test]
fn wien_and_stefan_boltzmann_hold() {
    let mut check = Check::new("06 Wien, Stefan-Boltzmann", 2e-15, 1e-12);
    for row in golden("06_wien_stefan").rows() {
        let t = row.number("T");
        let total = planck::stefan_boltzmann() * t.powi(4);
        let peak_nm = |n: f64| planck::C2_CODATA / planck::peak_x(n) / t * 1e9;
        check.cell(row, "M_sigmaT4_W_m2", total);
        check.cell(row, "L_W_m2_sr", total / std::f64::consts::PI);
        check.cell(row, "peak_lambda_nm", peak_nm(5.0));
        check.cell(row, "peak_photon_lambda_nm", peak_nm(4.0));
        check.cell(row, "peak_nu_Hz", planck::peak_x(3.0) * planck::K * t / planck::H);
        for (from, to) in [(380, 780), (400, 700), (360, 830), (100, 400), (780, 3000)] {
            let fraction = planck::fraction(f64::from(from), f64::from(to), t);
            check.cell(row, &format!("frac_{from}_{to}"), fraction);
        }
    }
    check.finish(10 * 10);
}

#[test]
fn photons_of_flat_light_are_the_integral_of_the_wavelength() {
    let flat = Photometry::of(&[1.0; 471]);
    for (from, to) in [(400, 700), (400, 750), (655, 665), (360, 830)] {
        let [a, b] = [from, to].map(f64::from);
        // h c N_A = 0.119626565824... J m / mol, exact in the SI.
        let expected = (b * b - a * a) / 2.0 / 119.626_565_638_697;
        assert!((flat.photons(from, to) * flat.total / expected - 1.0).abs() < 1e-10, "{from} to {to}");
    }
}

#[test]
fn watts_become_lumens_melanopic_light_and_photons() {
    let mut check = Check::new("07 photometry", 0.0, 1e-11);
    for row in golden("07_photometry_sources").rows() {
        let p = Photometry::of(&light(row.text("id")));
        let scotopic = p.scotopic_fraction();
        check.cell(row, "sum_360_830_relative", p.total);
        check.cell(row, "LER_683", 683.0 * p.v_fraction());
        check.cell(row, "LER_683.002", p.ler());
        check.cell(row, "LER_V10_683", 683.0 * p.v10_fraction());
        check.cell(row, "LER_VF2_683.358", 683.358 * p.vf_fraction());
        check.cell(row, "scotopic_LER_1700", 1700.0 * scotopic);
        check.cell(row, "scotopic_LER_1700.06", KM_SCOTOPIC * scotopic);
        check.cell(row, "SP_ratio_1700_683", 1700.0 * scotopic / (683.0 * p.v_fraction()));
        check.cell(row, "SP_ratio_1700.06_683.002", p.scotopic_to_photopic());
        check.cell(row, "V_fraction", p.v_fraction());
        let (elr, der) = (p.alpha_opic_elr(), p.alpha_opic_der());
        for (i, name) in ["sc", "mc", "lc", "rh", "mel"].iter().enumerate() {
            check.cell(row, &format!("ELR_{name}_mW_per_lm"), 1000.0 * elr[i]);
            check.cell(row, &format!("DER_{name}"), der[i]);
        }
        check.cell(row, "melEDI_at_1000lx", 1000.0 * der[4]);
        check.cell(row, "PPF_400_700_umol_per_J", p.photon_sum(400, 700));
        check.cell(row, "PAR_W_400_700", p.band(400, 700));
        check.cell(row, "PPFD_umol_per_klx", 1000.0 * p.photon_sum(400, 700) / p.ler());
        check.cell(row, "photon_360_830_umol_per_J", p.photon_sum(360, 830));
        for (from, to) in [(400, 500), (500, 600), (600, 700), (700, 800)] {
            check.cell(row, &format!("photon_{from}_{to}"), p.photon_sum(from, to));
        }
    }
    check.finish(63 * 29);

    let mut daylight = Check::new("07 efficacies of D65", 0.0, 1e-11);
    let mut published = Check::new("07 efficacies of D65 as CIE S 026 prints them", 5.1e-8, 0.0);
    for (row, elr) in golden("07_alphaopic_d65_elr").rows().zip(d65_elr()) {
        daylight.cell(row, "ELR_D65_W_per_lm", elr);
        published.cell(row, "S026_published_W_per_lm", elr);
    }
    daylight.finish(5);
    published.finish(5);
}
