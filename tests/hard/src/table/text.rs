//! The table as Markdown.

use super::{Error, HardCase, rules};
use std::fmt::Write;

const INTRODUCTION: &str = "\
<!-- By `NANOSPECTRA_BLESS=1 cargo test -p nanospectra-hard`. -->

# Hard cases

What the textbook's form is off by in f32, and the crate's at the same inputs, against f64: on x86-64, and on a
Cortex-M4F with flush-to-zero off and on (as QEMU ran the image `hard`). e is 2^-24, half the distance between 1 and
the next f32. Errors are the largest of the row's inputs; \"2 NaN\" counts results that are NaN, \"2 lost\" those that
are infinite or infinitely far off. The naive column has a second figure where flushing changes it.

";

const HEADING: &str = "\
| row | naive form | inputs | error | naive | ours | allowed | M4F | M4F, flushing | test |
|---|---|---|---|---|---|---|---|---|---|
";

const RULES: &str = "
## Rules

| rule | test |
|---|---|
";

/// The rows, and the rules.
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
    // A bar of a formula is none of the table.
    let _ = writeln!(text, "{}", line.replace("|Δx|", "\\|Δx\\|").replace("|Duv|", "\\|Duv\\|"));
}

/// Two digits of the error, and how many results are none.
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
