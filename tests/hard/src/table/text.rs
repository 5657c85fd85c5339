//! The table as Markdown.

use super::{Error, HardCase, rules};
use std::fmt::Write;

const INTRODUCTION: &str = "\
<!-- Made by `NANOSPECTRA_BLESS=1 cargo test -p nanospectra-hard`; do not edit. -->

# Hard cases

Each row of this table is a formula that loses accuracy, or fails, when it is computed in f32 as textbooks write it.
The column *naive* has the largest error of the textbook's form over the inputs of the row. The column *ours* has that
of the crate's form at the same inputs, and *allowed* is what the named test permits. A computation in f64 decides what
is right. The column *error* says how errors are measured. Where the column *naive form* names a second form after a
semicolon, that is the crate's.

* *naive* and *ours* were computed on x86-64. *M4F* and *M4F, flushing* are *ours* on a Cortex-M4F (the image `hard`
  of `examples/firmware` in QEMU), without and with subnormal numbers flushed to zero. Where flushing changes the
  naive form, the column *naive* has a second figure after a semicolon.
* e is 2^-24, which is half the distance between 1 and the next f32.
* *answers* means that no number is right, so that each number counts as an error of 1.
* \"2 NaN\" means that two results are NaN although a number is right. \"2 lost\" means that two results are infinite
  or infinitely far off.

";

const HEADING: &str = "\
| row | naive form | inputs | error | naive | ours | allowed | M4F | M4F, flushing | test |
|---|---|---|---|---|---|---|---|---|---|
";

const RULES: &str = "
## Rules

These are rules of behavior rather than of accuracy, each with the test that holds it.

| rule | test |
|---|---|
";

/// Writes the introduction, the table and the rules.
pub fn markdown(cases: &[HardCase]) -> String {
    let mut text = String::from(INTRODUCTION);
    text.push_str(HEADING);
    for case in cases {
        row(&mut text, case);
    }
    text.push_str(RULES);
    for rule in rules() {
        let _ = writeln!(text, "| {} | `{}` |", rule.rule, rule.test);
    }
    text
}

fn row(text: &mut String, case: &HardCase) {
    let mut naive = shown(&case.naive, case.count);
    let flushed = shown(&case.naive_m4f_ftz, case.count);
    if flushed != naive {
        naive = format!("{naive}; {flushed}");
    }
    let claim = &case.claim;
    let line = format!(
        "| {} | {} | {} | {} | {naive} | {} | {} | {} | {} | `{}` |",
        claim.row,
        claim.what,
        claim.inputs,
        claim.measured,
        shown(&case.ours, case.count),
        claim.tolerance(),
        shown(&case.m4f, case.count),
        shown(&case.m4f_ftz, case.count),
        claim.test
    );
    // The bars of these formulas would be read as those of the table.
    let _ = writeln!(text, "{}", line.replace("|Δx|", "\\|Δx\\|").replace("|Duv|", "\\|Duv\\|"));
}

/// Writes two digits of the error, and how many of the `count` results are NaN or lost.
fn shown(error: &Error, count: usize) -> String {
    let size = match error.size {
        0.0 => String::from("0"),
        size if (0.1..1000.0).contains(&size) => format!("{size:.2}"),
        size => format!("{size:.1e}"),
    };
    let lost = |what: &str, some: usize| match some {
        0 => String::new(),
        _ if some == count => what.to_string(),
        _ => format!("{some} {what}"),
    };
    let parts = [size, lost("NaN", error.nan), lost("lost", error.infinite)];
    let finite = usize::from(error.nan + error.infinite == count);
    parts[finite..].iter().filter(|part| !part.is_empty()).cloned().collect::<Vec<_>>().join(", ")
}
