//! Computes the numbers about a surface in a light.

use super::{Bench, Reading};
use crate::failure::Failure;
use crate::measure::source::Source;
use nanospectra::color::{Adaptation, Bradford, Lab, Rgb, RgbSpace, Srgb, Xy, Xyz, ciede2000};
use nanospectra::{Factor, Fine};

const PERFECT_WHITE: Lab = Lab { l: 100.0, a: 0.0, b: 0.0 };

/// The keys of the numbers that only a light has.
const OF_THE_LIGHT: &str = "cct_k duv lux ler_lm_per_w cri_ra cri_r cri_r9 cri_is_valid tm30_rf tm30_rg \
                            melanopic_edi_ratio ppfd epar photons photon_shares r_fr alpha_opic peak_nm \
                            centroid_nm fwhm_nm";

pub fn measure(bench: &Bench, source: &Source) -> Result<Reading, Failure> {
    let room = &bench.room;
    let reflectance = source.reflectance(bench.between)?;
    let xyz = Xyz::from(room.eye.sees(&reflectance));
    let white = room.white.xy().unwrap_or(Xy { x: 1.0 / 3.0, y: 1.0 / 3.0 });

    let mut reading = Reading::of(bench, source, xyz, white);
    reading.curve_y = f64::from(xyz.y);
    reading.raw_y = reading.curve_y;
    reading.lab = xyz.lab(room.white);
    match reading.lab {
        Some(lab) => reading.delta_e2000_to_white = Some(ciede2000(lab, PERFECT_WHITE)),
        None => reading.missing(
            &["lab", "delta_e2000_to_white"],
            "X, Y or Z of the light is not above zero, so it has no white",
        ),
    }
    match Adaptation::between::<Bradford>(room.white, Srgb::WHITE_XYZ) {
        Some(to_d65) => {
            let was_inside = reading.show(Rgb::from_xyz(to_d65.apply(xyz)));
            if !was_inside {
                reading.note("srgb", "the color is outside the gamut; this and hex are clipped");
            }
        }
        None => reading.missing(&["srgb", "hex"], "the light is not a white that can be adapted to D65"),
    }
    for key in OF_THE_LIGHT.split(' ') {
        reading.note(key, "only a light has this number, and a surface has not");
    }
    for remark in source.remarks::<Factor>(bench.between) {
        reading.note("data", remark);
    }
    let above = source.samples.iter().filter(|(_, value)| *value > 1.0).count();
    if above > 0 {
        let what =
            format!("{above} values are above 1: more light leaves than arrives (fluorescence or gloss?)");
        reading.note("data", what);
    }
    reading.curve = Some(Fine::from_bins(*reflectance.values()));
    Ok(reading)
}
