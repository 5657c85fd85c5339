//! What the command flicker says of waveforms.

use crate::run::{Program, assert_near, number};
use std::f64::consts::TAU;

const FLICKER: Program = Program("flicker", module_path!());

/// A file of readings of a light that jumps by 0.6832 %, 17.6 times a second, and swings by 11 % with 100 Hz.
/// Pst LM is 1 by IEC TR 61547-1, and SVM is 0.11 / 0.2563 by IEC TR 63158.
fn waveform(rate_hz: f64, seconds: f64) -> String {
    let row = |k: usize| {
        let time = k as f64 / rate_hz;
        let up = if (8.8 * time).fract() < 0.5 { 1.0 } else { -1.0 };
        let ripple = 1.0 - 0.11 * (TAU * 100.0 * time).cos();
        format!("{:.2}\n", 2000.0 * ripple * (1.0 + up * 0.003_416))
    };
    (0..(rate_hz * seconds) as usize).map(row).collect()
}

#[test]
fn a_waveform_has_both_measures_of_what_people_see() {
    let text = format!("# a photodiode\nvolts\n\n{}", waveform(4000.0, 40.0));
    let [answer] = <[_; 1]>::try_from(FLICKER.json_with(&text, &["-", "--rate-hz", "4000"])).expect("one");
    assert_eq!([&answer["kind"], &answer["file"]], ["waveform", "stdin"]);
    assert_eq!((number(&answer["readings"]), number(&answer["rate_hz"])), (160_000.0, 4000.0));
    assert_near(&answer["pst_lm"], 1.0, 0.005);
    let at = &answer["flicker"][0];
    assert_near(&at["frequency_hz"], 100.0, 0.0);
    assert_near(&at["svm"], 0.11 / 0.2563, 0.005);
    assert_near(&at["mean"], 2000.0, 10.0);
    assert_near(&at["amplitude"], 0.11, 0.001);
    assert_near(&at["percent"], 11.3, 0.1);
    assert_eq!(answer["notes"].as_array().map(Vec::len), Some(0), "{answer}");

    let said = FLICKER.says_to(&text, &["-", "--rate-hz", "4000", "--flicker-hz", "100,3000"]);
    assert!(said.starts_with("stdin: 160000 readings, 4000.0 per second\n  Pst LM "), "{said}");
    assert!(said.contains("\n  100 Hz: mean ") && said.contains(", SVM 0.429"), "{said}");
    assert!(said.ends_with("\n  3000 Hz: needs 6000 or more readings a second\n"), "{said}");
}

#[test]
fn what_is_unknown_has_a_reason() {
    let short = waveform(1000.0, 1.0);
    let said = FLICKER.says_to(&short, &["-", "--rate-hz", "1000"]);
    assert!(said.contains("Pst LM unknown (needs readings of 30 s or more)"), "{said}");
    assert!(said.contains("SVM unknown (needs 4000 or more readings a second)"), "{said}");
    let answer = &FLICKER.json_with(&short, &["-", "--rate-hz", "1000"])[0];
    assert!(answer["pst_lm"].is_null() && answer["flicker"][0]["svm"].is_null());
    let notes = answer["notes"].to_string();
    assert!(notes.contains("pst_lm: needs readings of 30 s or more"), "{notes}");
    assert!(notes.contains("flicker.svm: needs 4000 or more readings a second"), "{notes}");
    let slow = FLICKER.says_to(&short, &["-", "--rate-hz", "10", "--flicker-hz", "1"]);
    assert!(slow.contains("Pst LM unknown (needs 400 to 50000 readings a second)"), "{slow}");
    let dark = FLICKER.says_to("0\n".repeat(31 * 400), &["-", "--rate-hz", "400"]);
    assert!(dark.contains("Pst LM unknown (there is no light)"), "{dark}");
    assert!(dark.contains("100 Hz: needs a whole period, and light"), "{dark}");
    let huge = FLICKER.says_to("3e38\n1e38\n".repeat(31 * 200), &["-", "--rate-hz", "400"]);
    assert!(huge.contains("Pst LM unknown (a reading is not a number, or too large)"), "{huge}");
    let few = FLICKER.says_to(waveform(5000.0, 1.0), &["-", "--rate-hz", "5000", "--flicker-hz", "0.5"]);
    assert!(few.contains("0.5 Hz: needs a whole period, and light"), "{few}");
}

#[test]
fn what_is_no_waveform_is_refused() {
    let rate = ["-", "--rate-hz", "1000"];
    for (input, arguments, start, word) in [
        ("", &rate[..], "stdin:1: ", "no readings"),
        ("light\n", &rate, "stdin:1: ", "no readings"),
        ("1\n2,3\n", &rate, "stdin:2: ", "'2,3' is not one number"),
        ("1;5\n", &rate, "stdin:1: ", "'1;5' is not one number"),
        ("light\nlight\n", &rate, "stdin:2: ", "one reading in each row"),
        ("1\ninf\n", &rate, "stdin:2: ", "not one number"),
        ("1\n1e39\n", &rate, "stdin:2: ", "not one number"),
        ("1\n2\r3\n", &rate, "stdin:2: ", "carriage return"),
        ("1\n", &["-"], "flicker: ", "--rate-hz"),
        ("1\n", &["--rate-hz", "1000"], "flicker: ", "FILE"),
        ("1\n", &["-", "--rate-hz", "0"], "--rate-hz: ", "above 0"),
        ("1\n", &["-", "--rate-hz", "-5"], "--rate-hz: ", "above 0"),
        ("1\n", &["-", "--rate-hz", "inf"], "--rate-hz: ", "above 0"),
        ("1\n", &["-", "--rate-hz", "9", "--flicker-hz", "1,NaN"], "--flicker-hz: ", "above 0"),
        ("1\n", &["nowhere.txt", "--rate-hz", "9"], "nowhere.txt: ", "no such file"),
    ] {
        FLICKER.refuses_of(input, arguments, start, word);
    }
}

#[test]
fn help_explains_the_measures() {
    FLICKER.assert_helps("FILE --rate-hz --flicker-hz --json Pst SVM 180 4000 61547-1 63158");
}
