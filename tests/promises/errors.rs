//! Every error says in words what is wrong, whatever numbers it holds: never NaN or inf.

use crate::claims::sections::texts;
use nanospectra::color::{Cct, RenderingError, Xyz};
use nanospectra::matter::{AbsorberError, FluorescenceError};
use nanospectra::path::{PolarizationError, SceneFullError};
use nanospectra::sensor::{
    CrosstalkError, FitError, LadderError, PixelWavelengthsError, PstLmError, ReadingError,
    ResponsivityError, ResponsivityErrorKind,
};
use nanospectra::{SamplesError, sensor::Channels};
use std::collections::BTreeSet;
use std::error::Error;

const NUMBERS: [f32; 7] = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN, 1e-45, 0.0];
const COUNTS: [usize; 2] = [0, usize::MAX];

/// Every error of the library, with numbers that are as bad as they can be.
fn errors() -> Vec<Box<dyn Error>> {
    let mut errors: Vec<Box<dyn Error>> = vec![Box::new(CrosstalkError), Box::new(ReadingError::TooDark)];
    errors.push(Box::new(ReadingError::Saturated { channels: Channels::default() }));
    for number in NUMBERS {
        errors.push(Box::new(FitError::IllConditioned { condition: number }));
        for cct in [Cct::Near { cct_k: number, duv: 0.0 }, Cct::Near { cct_k: 6504.0, duv: number }] {
            errors.push(Box::new(RenderingError::NoReference(cct)));
        }
        for xyz in [Xyz::new(number, 0.0, -1.0), Xyz::new(0.0, number, -1.0), Xyz::new(-1.0, 0.0, number)] {
            errors.push(Box::new(ReadingError::Negative { xyz }));
        }
    }
    for cct in [Cct::OffLocus, Cct::TooCold, Cct::TooHot] {
        errors.push(Box::new(RenderingError::NoReference(cct)));
    }
    for error in [RenderingError::Dark, RenderingError::Unreal] {
        errors.push(Box::new(error));
    }
    for count in COUNTS {
        let few = FitError::TooFew { patches: count as u32, needed: count };
        for error in [few, FitError::NotFinite, FitError::NotConverged { iterations: count as u32 }] {
            errors.push(Box::new(error));
        }
        use {FluorescenceError as Glow, LadderError as Ladder, SamplesError as Samples};
        for error in [Ladder::Empty, Ladder::CannotCount { index: count }, Ladder::NotSorted { index: count }]
        {
            errors.push(Box::new(error));
        }
        for error in [AbsorberError::OutOfRange { bin: count }, AbsorberError::Amount] {
            errors.push(Box::new(error));
        }
        for error in [
            Glow::OutOfRange { bin: count },
            Glow::AntiStokes { from: count, to: count },
            Glow::QuantumYield,
            Glow::NoEmission,
            Glow::Energy { bin: count },
            Glow::Photons { bin: count },
        ] {
            errors.push(Box::new(error));
        }
        for error in [
            Samples::TooFew { needed: count },
            Samples::NotFinite { index: count },
            Samples::NotIncreasing { index: count },
            Samples::NotRegular { index: count },
        ] {
            errors.push(Box::new(error));
        }
        errors.push(Box::new(PixelWavelengthsError { pixel: count }));
        errors.push(Box::new(PolarizationError { part: count }));
        errors.push(Box::new(SceneFullError { capacity: count }));
        errors
            .push(Box::new(ResponsivityError { line: count as u32, kind: ResponsivityErrorKind::TooLarge }));
    }
    for error in [PstLmError::TooShort, PstLmError::NoLight, PstLmError::NotANumber] {
        errors.push(Box::new(error));
    }
    #[cfg(feature = "heapless")]
    for error in [
        nanospectra::PushError::Full,
        nanospectra::PushError::NotFinite,
        nanospectra::PushError::NotIncreasing,
    ] {
        errors.push(Box::new(error));
    }
    errors
}

/// The names of all types in the source that are errors.
fn names_in_source() -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    for (_, text) in texts().iter().filter(|(file, _)| file.starts_with("src/")) {
        let named = text.lines().filter_map(|line| line.split_once("error::Error for "));
        names.extend(named.filter_map(|(_, rest)| Some(rest.split_once(' ')?.0.to_owned())));
    }
    names
}

#[test]
fn every_error_says_why_without_nan_and_infinity() {
    for error in errors() {
        let said = error.to_string();
        let words: Vec<&str> = said.split(|c: char| !c.is_alphanumeric()).collect();
        assert!(words.len() > 3 && !said.contains("  "), "{error:?}: {said}");
        for word in ["nan", "inf", "infinity"] {
            assert!(!words.iter().any(|said| said.eq_ignore_ascii_case(word)), "{error:?}: {said}");
        }
    }
}

/// (An import that is not used would be a warning.)
#[test]
fn no_error_is_left_out() {
    let here = include_str!("errors.rs");
    let names = names_in_source();
    let left_out: Vec<&String> = names.iter().filter(|name| !here.contains(*name)).collect();
    assert!(left_out.is_empty() && names.len() >= 13, "{left_out:?} of {names:?}");
}
