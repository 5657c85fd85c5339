//! Tables that are made completely from the report.

use super::grouped;
use crate::counts::{self, Core, Profile};
use crate::record::{CLASSES, Choice, choices, number, rows, text};
use crate::text::figure;
use serde_json::Value;

/// Makes a table from a report.
type Maker = fn(&Value) -> String;

/// Finds the function that makes the table of this name, and the table of the record that it needs.
pub fn maker(name: &str) -> Option<(&'static str, Maker)> {
    match name {
        "headline" => Some(("xyz", |report| headline(&choices(report)))),
        "xyz" => Some(("xyz", |report| xyz(&choices(report)))),
        "xyz-cost" => Some(("xyz", |report| xyz_cost(&choices(report)))),
        "losses" => Some(("losses", losses)),
        "math" => Some(("math", math)),
        "cct" => Some(("cct", cct)),
        "upsample" => Some(("upsample", upsample)),
        "gamuts" => Some(("gamuts", gamuts)),
        _ => None,
    }
}

/// The choices that the guide shows: range, scheme, bands, and the label of the row.
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

/// The choices that README.md shows, with instructions that are counted in one build.
const FIRST: [(&str, &str, u32, &str); 6] = [
    ("-", "sRGB product", 3, "product of two sRGB colors"),
    ("400..700", "points", 31, "31 samples, every 10 nm, *not folded*"),
    ("380..730", "folded spline", 8, "8 folded bands"),
    ("380..730", "folded spline", 16, "**16 folded bands**"),
    ("380..730", "folded spline", 31, "31 folded bands"),
    ("380..730", "folded spline", 81, "81 folded bands"),
];

/// Shows the mean and the largest error under three kinds of lamps, the instructions, and the bytes that are
/// read.
fn headline(choices: &[Choice]) -> String {
    let mut out =
        "| a surface under a lamp, as | daylight, incandescent | white LEDs | triphosphor | instructions \
        | bytes |\n|---|--:|--:|--:|--:|--:|\n"
            .to_owned();
    for (range, scheme, bands, shown) in FIRST {
        let Some(choice) = choices.iter().find(|choice| choice.is(range, scheme, bands)) else { continue };
        let errors = ["smooth", "led", "triphosphor"].map(|class| {
            let class = CLASSES.iter().position(|name| *name == class);
            class.map_or_else(String::new, |k| {
                format!("{} / {}", figure(choice.mean[k]), figure(choice.max[k]))
            })
        });
        let instructions = counts::instructions_as(Core::M4F, Profile::Release, &counted(choice));
        out += &format!(
            "| {shown} | {} | {} | {} |\n",
            errors.join(" | "),
            instructions.map_or_else(String::new, grouped),
            grouped((choice.constants + choice.surface) as u32),
        );
    }
    out
}

/// Shows the errors of each choice.
fn xyz(choices: &[Choice]) -> String {
    let mut out = "| bands | smooth | halophosphate FL | triphosphor FL | LED | HID | lines |\n\
        |---|---|---|---|---|---|---|\n"
        .to_owned();
    for (range, scheme, bands, shown) in SHOWN {
        let Some(choice) = choices.iter().find(|choice| choice.is(range, scheme, bands)) else { continue };
        let bold = shown.starts_with("**");
        let errors = (0..CLASSES.len()).map(|k| {
            let cell = format!("{} / {}", figure(choice.mean[k]), figure(choice.max[k]));
            if bold { format!("**{cell}**") } else { cell }
        });
        out += &format!("| {shown} | {} |\n", errors.collect::<Vec<_>>().join(" | "));
    }
    out
}

/// Shows what each choice costs.
fn xyz_cost(choices: &[Choice]) -> String {
    let mut out =
        "| bands | constants, bytes | a surface, bytes | Cortex-M4F, opt 3 | \"s\" | Cortex-M0, opt 3 |\n\
        |---|--:|--:|--:|--:|--:|\n"
            .to_owned();
    for (range, scheme, bands, shown) in SHOWN {
        let Some(choice) = choices.iter().find(|choice| choice.is(range, scheme, bands)) else { continue };
        let m4f = [Profile::Release, Profile::Small].map(|profile| {
            counts::instructions_as(Core::M4F, profile, &counted(choice)).map_or_else(String::new, grouped)
        });
        out += &format!(
            "| {shown} | {} | {} | {} | {} |\n",
            grouped(choice.constants as u32),
            grouped(choice.surface as u32),
            m4f.join(" | "),
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

/// Returns the largest of errors, from 0.001 on, with the digits of [`figure`] but rounded up.
fn no_more(error: f64) -> String {
    let decimals = figure(error).split_once('.').map_or(0, |(_, decimals)| decimals.len() as i32);
    let unit = 10f64.powi(-decimals);
    figure((error / unit - 1e-6).ceil() * unit)
}

fn cct(report: &Value) -> String {
    let mut out =
        "| | of lamps | of the plane | table | Cortex-M4F | Cortex-M0 |\n|---|--:|--:|--:|--:|--:|\n"
            .to_owned();
    for row in rows(report, "cct") {
        let mired = |column| {
            number(row, column).map_or_else(|| "-".to_owned(), |error| format!("{} mired", no_more(error)))
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

fn upsample(report: &Value) -> String {
    let most = |counted: &str, profile| counts::instructions_as(Core::M4F, profile, counted);
    let mut out = "| | bytes | back, mean / most | wrong 8-bit codes | under A / FL2 / FL11 / LED-B3 \
        | Cortex-M4F, opt 3 | \"s\" |\n|---|--:|--:|--:|--:|--:|--:|\n"
        .to_owned();
    for row in rows(report, "upsample") {
        let method = text(row, "method");
        let (shown, counted) = SHOWN_METHODS
            .into_iter()
            .find_map(|(name, shown, counted)| (name == method).then_some((shown, counted)))
            .unwrap_or((method, ""));
        let de2000 = |column| number(row, column).map_or_else(|| "-".to_owned(), figure);
        let lamps = ["a", "fl2", "fl11", "led_b3"].map(|lamp| {
            number(row, &format!("{lamp}_de2000"))
                .map_or_else(|| "-".to_owned(), |error| format!("{error:.1}"))
        });
        let wrong = number(row, "wrong_codes_percent");
        let instructions = [Profile::Release, Profile::Small].map(|profile| {
            let all = [most(counted, profile), most(&format!("{counted}-most"), profile)];
            let all: Vec<String> = all.into_iter().flatten().map(grouped).collect();
            if all.is_empty() { "-".to_owned() } else { all.join(" / ") }
        });
        out += &format!(
            "| {shown} | {} | {} / {} | {} | {} | {} |\n",
            count(number(row, "bytes")),
            de2000("mean_de2000"),
            de2000("max_de2000"),
            wrong.map_or_else(|| "-".to_owned(), |percent| format!("{} %", figure(percent))),
            lamps.join(" / "),
            instructions.join(" | "),
        );
    }
    out
}

/// Shows how much of each space has a spectrum, by a sigmoid and by any.
fn gamuts(report: &Value) -> String {
    let mut out =
        "| | a sigmoid, 31 bands | any spectrum, 31 bands | a sigmoid, 81 bands | any spectrum, 81 bands \
        | any spectrum, every 3 nm |\n|---|--:|--:|--:|--:|--:|\n"
            .to_owned();
    for row in rows(report, "gamuts") {
        let columns = ["sigmoid_31", "any_31", "sigmoid_81", "any_81", "any"].map(|column| {
            number(row, &format!("{column}_percent"))
                .map_or_else(String::new, |share| format!("{share:.2} %"))
        });
        out += &format!("| {} | {} |\n", text(row, "space"), columns.join(" | "));
    }
    out
}

/// The methods of upsampling: their names in the record and in the guide, and the name of their instructions.
const SHOWN_METHODS: [(&str, &str, &str); 6] = [
    ("Sigmoid, Linear", "`Sigmoid`, `LinearStart`", "upsample-linear-31"),
    ("Sigmoid, Cubic", "**`Sigmoid`, `CubicStart`**", "upsample-cubic-31"),
    ("Sigmoid, Quintic", "`Sigmoid`, `QuinticStart`", "upsample-quintic-31"),
    ("Basis", "`Basis` (linear)", "upsample-basis-31"),
    ("Smits", "`Smits` (the classic)", "upsample-smits-31"),
    ("product of RGB", "a product of RGB, no spectrum", "rgb-product"),
];

fn count(count: Option<f64>) -> String {
    count.map_or_else(|| "-".to_owned(), |count| grouped(count as u32))
}

/// Returns an error with two significant digits, such as 1.4e-7 or 0.69.
fn error(value: f64) -> String {
    if value >= 0.1 { format!("{value:.2}") } else { format!("{value:.1e}") }
}
