//! Tables of the README that are made completely from the report.

use super::grouped;
use crate::counts::{self, Core, Profile};
use crate::record::{CLASSES, Choice, choices, number, rows, text};
use crate::text::figure;
use serde_json::Value;

/// Finds the function that makes the table of this name.
pub fn maker(name: &str) -> Option<fn(&Value) -> String> {
    match name {
        "xyz" => Some(|report| xyz(&choices(report))),
        "losses" => Some(losses),
        "math" => Some(math),
        "cct" => Some(cct),
        _ => None,
    }
}

/// The choices that the README shows: range, scheme, bands, and the label of the row.
const SHOWN: [(&str, &str, u32, &str); 12] = [
    ("380..730", "folded spline", 8, "8"),
    ("380..730", "folded spline", 12, "12"),
    ("380..730", "folded spline", 16, "**16**"),
    ("380..730", "folded spline", 20, "20"),
    ("380..730", "folded spline", 31, "31"),
    ("380..730", "folded spline", 81, "81"),
    ("380..730", "folded step", 31, "31, never negative (`Curve::Step`)"),
    ("380..730", "observer parabola", 16, "16, *the light not folded in*"),
    ("380..730", "averages", 60, "60 averages, *not folded*"),
    ("400..700", "averages", 60, "60 averages, 400..700, *not folded*"),
    ("400..700", "points", 31, "31 points, every 10 nm, *not folded*"),
    ("-", "sRGB product", 3, "a product of sRGB colors"),
];

fn xyz(choices: &[Choice]) -> String {
    let mut out = "| bands | smooth | halophosphate FL | triphosphor FL | LED | HID | lines | constants \
        | Cortex-M4F, opt 3 / \"s\" | Cortex-M0 |\n|---|---|---|---|---|---|---|--:|--:|--:|\n"
        .to_owned();
    for (range, scheme, bands, shown) in SHOWN {
        let Some(choice) = choices.iter().find(|choice| choice.is(range, scheme, bands)) else { continue };
        let bold = shown.starts_with("**");
        let errors = (0..CLASSES.len()).map(|k| {
            let cell = format!("{} / {}", figure(choice.mean[k]), figure(choice.max[k]));
            if bold { format!("**{cell}**") } else { cell }
        });
        let m4f = [Profile::Release, Profile::Small].map(|profile| {
            counts::instructions_as(Core::M4F, profile, &counted(choice)).map_or_else(String::new, grouped)
        });
        out += &format!(
            "| {shown} | {} | {} B | {} | {} |\n",
            errors.collect::<Vec<_>>().join(" | "),
            choice.constants,
            m4f.join(" / "),
            count(choice.instructions(Core::M0)),
        );
    }
    out
}

/// Returns the name under which the instructions of a choice are on record.
fn counted(choice: &Choice) -> String {
    match choice.scheme.as_str() {
        "sRGB product" => "rgb-product".to_owned(),
        scheme if scheme.starts_with("folded") => format!("xyz-{}", choice.bands),
        _ => format!("path-surface-{}", choice.bands),
    }
}

/// Shows the worst case of each kind of loss.
fn losses(report: &Value) -> String {
    let rows = rows(report, "losses");
    let mut kinds: Vec<&str> = rows.iter().map(|row| text(row, "more")).collect();
    kinds.dedup();
    let mut out = "| more | lamps | is worse | than | CIEDE2000 |\n|---|---|---|---|--:|\n".to_owned();
    for kind in kinds {
        let ratio = |row: &&Value| number(row, "ratio").unwrap_or(0.0);
        let of = rows.iter().filter(|row| text(row, "more") == kind);
        if let Some(row) = of.max_by(|a, b| ratio(a).total_cmp(&ratio(b))) {
            let error = |column| number(row, column).map_or_else(String::new, figure);
            out += &format!(
                "| {kind} | {} | {} | {} | {}, not {} |\n",
                text(row, "lamps"),
                text(row, "choice"),
                text(row, "than"),
                error("mean_de2000"),
                error("than_mean_de2000")
            );
        }
    }
    out
}

fn math(report: &Value) -> String {
    let rows = rows(report, "math");
    let backends = [
        ("Fast", "`Fast`"),
        ("Portable", "`Portable` (default)"),
        ("Libm", "`Libm`"),
        ("Micromath", "`Micromath`"),
    ];
    let mut functions: Vec<&str> = rows.iter().map(|row| text(row, "function")).collect();
    functions.dedup();
    let headings = backends.map(|(_, heading)| heading);
    let mut out = format!("| | {} |\n|---|{}\n", headings.join(" | "), "---|".repeat(backends.len()));
    for function in functions {
        let cells = backends.map(|(backend, _)| {
            let row =
                rows.iter().find(|row| (text(row, "function"), text(row, "backend")) == (function, backend));
            row.map_or_else(String::new, |row| {
                let error = number(row, "max_error").map_or_else(|| "-".to_owned(), error);
                format!("{error}, {}", count(number(row, "m4f_instructions")))
            })
        });
        out += &format!("| {function} | {} |\n", cells.join(" | "));
    }
    out
}

fn cct(report: &Value) -> String {
    let mut out =
        "| | of lamps | of the plane | table | Cortex-M4F | Cortex-M0 |\n|---|--:|--:|--:|--:|--:|\n"
            .to_owned();
    for row in rows(report, "cct") {
        let mired = |column| {
            number(row, column).map_or_else(|| "-".to_owned(), |error| format!("{} mired", figure(error)))
        };
        out += &format!(
            "| {} | {} | {} | {} B | {} | {} |\n",
            text(row, "method"),
            mired("max_mired_of_lamps"),
            mired("max_mired"),
            count(number(row, "bytes")),
            count(number(row, "m4f_instructions")),
            count(number(row, "m0_instructions")),
        );
    }
    out
}

fn count(count: Option<f64>) -> String {
    count.map_or_else(|| "-".to_owned(), |count| grouped(count as u32))
}

/// Returns an error with two significant digits, such as 1.4e-7 or 0.69.
fn error(value: f64) -> String {
    if value >= 0.1 { format!("{value:.2}") } else { format!("{value:.1e}") }
}
