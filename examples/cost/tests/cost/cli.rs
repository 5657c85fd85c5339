//! The program as a user meets it: its help, what it refuses, and the choices that it advises with their
//! lines of Rust.

use nanospectra::light::FL11;
use nanospectra::observer::CIE_1931;
use nanospectra::{Bins, Curve, Factor, Light, Observer, Power, Reflectance};
use std::process::Command;

/// The text of this file, which must contain the lines that are advised.
const THIS: &str = include_str!("cli.rs");

struct Outcome {
    code: Option<i32>,
    out: String,
    err: String,
}

fn run(arguments: &[&str]) -> Outcome {
    let output = Command::new(env!("CARGO_BIN_EXE_cost")).args(arguments).output().expect("the program runs");
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    Outcome { code: output.status.code(), out: text(output.stdout), err: text(output.stderr) }
}

/// Asserts that the program ended with exit code 2 and one line, which begins with `start`, contains `word`,
/// and says what to do.
#[track_caller]
fn assert_refused(outcome: &Outcome, start: &str, word: &str) {
    let message = &outcome.err;
    assert_eq!((outcome.code, outcome.out.as_str()), (Some(2), ""), "{message:?}");
    assert_eq!(message.lines().count(), 1, "{message:?}");
    for part in [word, ";"] {
        assert!(
            message.starts_with(start) && message.contains(part),
            "{message:?}: no {start:?} with {part:?}"
        );
    }
}

#[test]
fn help_names_every_option_and_exits_well() {
    let help = run(&["--help"]);
    assert_eq!((help.code, help.err.as_str()), (Some(0), ""));
    for option in ["--quick", "--only", "--json", "--check", "--bless", "--docs", "--advise", "--lamps"] {
        assert!(help.out.contains(option), "{option}");
    }
}

#[test]
fn wrong_words_are_refused_on_one_line_that_says_what_to_do() {
    for (arguments, start, word) in [
        (&["--only", "xys"][..], "--only: ", "xys"),
        (&["--fast"], "cost: ", "--fast"),
        (&["--bless", "--check"], "cost: ", "--check"),
        (&["--lamps", "fl"], "cost: ", "--advise"),
        (&["--advise"], "--advise: ", "no limit"),
        (&["--advise", "--most-error", "0"], "cost: ", "above 0"),
        (&["--advise", "--most-error", "1", "--core", "m7"], "cost: ", "m4f"),
        (
            &["--advise", "--most-error", "1", "--lamps", "fl,neon"],
            "--lamps: ",
            "halophosphate, triphosphor, led",
        ),
    ] {
        assert_refused(&run(arguments), start, word);
    }
}

#[test]
fn an_impossible_limit_is_refused_with_what_is_next_to_it() {
    assert_refused(&run(&["--advise", "--most-instructions", "10"]), "--most-instructions: ", "sRGB product");
    let refused = run(&["--advise", "--most-error", "0.0001", "--lamps", "led"]);
    assert_refused(&refused, "--most-error: ", "folded");
    // The choice that the message names is found with its own error as the limit.
    let nearest = refused.err.split("nearest has ").nth(1).and_then(|rest| rest.split(' ').next());
    let again = run(&["--advise", "--lamps", "led", "--most-error", nearest.expect("a number")]);
    assert_eq!((again.code, again.err.as_str()), (Some(0), ""));
    // Both limits hold at once.
    let both = run(&["--advise", "--most-instructions", "50", "--most-error", "0.1"]);
    assert_refused(&both, "--most-error: ", "N = 3");
}

/// Returns the advised choice, which is the first line, and the rest.
fn advised(arguments: &[&str]) -> (String, String) {
    let outcome = run(&[&["--advise"], arguments].concat());
    assert_eq!((outcome.code, outcome.err.as_str()), (Some(0), ""), "{arguments:?}");
    let (first, rest) = outcome.out.split_once('\n').expect("lines");
    (first.to_owned(), rest.to_owned())
}

#[test]
fn sixteen_folded_bands_are_advised_for_200_instructions() {
    let (choice, rest) = advised(&["--lamps", "fl,led", "--most-instructions", "200"]);
    assert_eq!(choice, "folded spline, N = 16, 380..730 nm");
    let record = include_str!("../../../../tests/data/instructions.txt");
    let counted = |line: &str| line.strip_prefix("thumbv7em-none-eabihf release xyz-16 ").map(str::to_owned);
    let instructions = record.lines().find_map(counted).expect("what 16 bands take");
    for word in [instructions.as_str(), "192 bytes", "halophosphate", "triphosphor", "led", "negative"] {
        assert!(rest.contains(word), "{word}: {rest}");
    }
    assert!(!rest.contains("hid"), "{rest}");
}

#[test]
fn the_reverse_question_has_the_cheapest_choice_for_an_answer() {
    let (near, _) = advised(&["--lamps", "fl,led", "--most-error", "0.1"]);
    assert_eq!(near, "folded spline, N = 16, 380..730 nm");
    let (coarse, _) = advised(&["--lamps", "smooth", "--most-error", "0.1"]);
    assert_eq!(coarse, "folded spline, N = 12, 400..700 nm");
}

#[test]
fn what_must_never_be_negative_or_may_change_is_not_folded_by_a_curve() {
    let (step, rest) = advised(&["--never-negative", "--most-error", "0.2"]);
    assert!(step.starts_with("folded step, ") && !rest.contains("may be negative"), "{step} {rest}");
    let (changing, _) = advised(&["--light-changes", "--most-instructions", "400"]);
    assert!(changing.starts_with("observer parabola, "), "{changing}");
    let (both, _) = advised(&["--light-changes", "--never-negative", "--most-bytes", "2000"]);
    assert!(both.starts_with("averages+tails, "), "{both}");
    let (small, _) = advised(&["--core", "m0", "--most-instructions", "9000"]);
    assert_eq!(small, "folded spline, N = 12, 400..700 nm");
}

#[test]
fn the_lines_that_are_given_compile() {
    let given = |arguments: &[&str]| {
        let (_, rest) = advised(arguments);
        let code: Vec<String> = rest
            .lines()
            .skip_while(|line| !line.starts_with("static ") && !line.starts_with("// "))
            .map(|line| line.trim().to_owned())
            .filter(|line| !line.is_empty())
            .collect();
        assert!(code.len() > 3, "{rest}");
        code
    };
    // The same lines stand below, where they are compiled.
    let here: String = THIS.split_whitespace().collect();
    for arguments in [
        &["--lamps", "fl,led", "--most-instructions", "200"][..],
        &["--light-changes", "--most-instructions", "191"],
    ] {
        for line in given(arguments) {
            let line: String = line.split_whitespace().collect();
            assert!(here.contains(&line), "{line}");
        }
    }
    let white = folded::xyz(&Reflectance::flat(1.0));
    assert!((white[1] - 100.0).abs() < 1e-4, "{white:?}");
    assert!(changing::xyz(&Light::flat(1.0), &Reflectance::flat(1.0))[1] > 100.0);
}

mod folded {
    use super::*;

    // Your lamp for FL11; worked out by the compiler.
    #[rustfmt::skip]
    static EYE: Observer<3, 16, Factor, Bins<380, 730>> =
        CIE_1931.under(&FL11.fine()).fold(Curve::Spline).with_white_y(100.0);

    pub fn xyz(surface: &Reflectance<16, Bins<380, 730>>) -> [f32; 3] {
        EYE.sees(surface)
    }
}

mod changing {
    use super::*;

    static EYE: Observer<3, 16, Power, Bins<380, 730>> = CIE_1931.fold(Curve::Parabola);

    #[rustfmt::skip]
    pub fn xyz(light: &Light<16, Bins<380, 730>>, surface: &Reflectance<16, Bins<380, 730>>) -> [f32; 3] {
        EYE.sees(light.onto(surface))
    }
}
