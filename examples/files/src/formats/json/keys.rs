//! What the keys of objects mean.

use crate::text::number::{Decimal, labeled, number};
use crate::unit::{AxisUnit, names_axis, plain};

/// Returns the letters and digits of a key in lower case: `startWavelength_nm` becomes `startwavelengthnm`.
fn letters(key: &str) -> String {
    plain(key).chars().filter(|c| c.is_alphanumeric()).collect()
}

/// Returns whether a key names the axis of a spectrum.
pub fn is_axis(key: &str) -> bool {
    if key == "x" || key == "w" {
        return true;
    }
    let text = plain(key);
    names_axis(key)
        && !["unit", "start", "end", "step", "min", "max", "range", "count"]
            .iter()
            .any(|word| text.contains(word))
}

/// Returns whether a key says how its values are measured, rather than what was measured.
pub fn is_common(key: &str) -> bool {
    const COMMON: [&str; 18] = [
        "value",
        "values",
        "data",
        "y",
        "v",
        "spd",
        "spectrum",
        "spectra",
        "power",
        "intensity",
        "intensities",
        "samples",
        "curve",
        "curves",
        "measurements",
        "points",
        "results",
        "spectraldata",
    ];
    COMMON.contains(&letters(key).as_str())
}

/// Returns the rank of a key that holds the name of a spectrum, where 0 is best.
pub fn name_rank(key: &str) -> Option<usize> {
    const NAMES: [&str; 7] = ["name", "samplename", "title", "label", "sample", "id", "description"];
    let key = letters(key);
    NAMES.iter().position(|name| *name == key)
}

/// What a key says of wavelengths in equal steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    Start,
    End,
    Size,
}

/// Returns what a key such as `start`, `wavelength_end` or `stepNm` says of the steps.
pub fn step(key: &str) -> Option<Step> {
    let text = letters(key);
    let mut text = text.as_str();
    for word in ["wavelength", "lambda", "wl", "spectral", "spectrum"] {
        text = text.trim_start_matches(word).trim_end_matches(word);
    }
    let text = text.strip_suffix("nm").unwrap_or(text);
    let text = text.strip_suffix("wavelength").or_else(|| text.strip_suffix("wl")).unwrap_or(text);
    Some(match text {
        "start" | "min" | "first" | "from" | "begin" | "minimum" => Step::Start,
        "end" | "stop" | "max" | "last" | "to" | "maximum" => Step::End,
        "step" | "interval" | "increment" | "delta" | "spacing" | "resolution" | "stepsize" => Step::Size,
        _ => return None,
    })
}

/// What a key of units is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum About {
    Axis,
    Values,
}

/// Returns whether a key such as `unit`, `y_units` or `wavelengthUnit` states a unit, and of what.
pub fn unit(key: &str) -> Option<About> {
    let text = letters(key);
    if matches!(text.as_str(), "quantity" | "spectralquantity" | "measurement" | "measurementtype" | "type") {
        return Some(About::Values);
    }
    let text = text.strip_suffix('s').unwrap_or(&text);
    let about = text.strip_suffix("unit").or_else(|| text.strip_prefix("unit"))?;
    let axis = about.starts_with('x')
        || about.contains("wave")
        || about.contains("lambda")
        || about.contains("axis");
    Some(if axis && !about.starts_with('y') { About::Axis } else { About::Values })
}

/// Returns the wavelength that a key is, such as `380` or `380.5nm`.
pub fn wavelength(key: &str) -> Option<f64> {
    number(key.trim(), Decimal::Point).or_else(|| {
        let label = labeled(key, Decimal::Point)?;
        (label.before.is_empty() && AxisUnit::parse(label.after).is_some()).then_some(label.number)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_understood() {
        for key in ["wavelength", "wavelengths", "wavelength_nm", "waveLength", "nm", "x", "lambda", "wl"] {
            assert!(is_axis(key), "{key}");
        }
        for key in ["values", "wavelengthUnit", "wavelength_start", "lamp", "y"] {
            assert!(!is_axis(key), "{key}");
        }
        for (key, meaning) in [
            ("start", Some(Step::Start)),
            ("wavelength_start", Some(Step::Start)),
            ("startWavelength", Some(Step::Start)),
            ("start_nm", Some(Step::Start)),
            ("StartWL", Some(Step::Start)),
            ("lambda_max", Some(Step::End)),
            ("step_nm", Some(Step::Size)),
            ("interval", Some(Step::Size)),
            ("name", None),
        ] {
            assert_eq!(step(key), meaning, "{key}");
        }
        assert_eq!(unit("unit"), Some(About::Values));
        assert_eq!(unit("y_units"), Some(About::Values));
        assert_eq!(unit("wavelengthUnit"), Some(About::Axis));
        assert_eq!(unit("x_unit"), Some(About::Axis));
        assert_eq!(unit("values"), None);
        assert_eq!(wavelength("380.5 nm"), Some(380.5));
        assert_eq!(wavelength("R380"), None);
    }
}
