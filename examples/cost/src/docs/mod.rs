//! The tables of README.md and of the guides that are made from what is on record.
//!
//! Each stands between `<!-- cost: NAME -->` and `<!-- end -->`. The tables in [`made`] are made completely
//! from the report. Those in [`counted`] are worded by the page, and only the counts are put in.

mod counted;
mod made;

use crate::record::rows;
use nanospectra_cli::failure::Failure;
use serde_json::Value;

const START: &str = "<!-- cost: ";
const CLOSE: &str = " -->";
const END: &str = "<!-- end -->";

/// Returns the text of a page with every table renewed from the report and the counts.
pub fn rewritten(page: &str, text: &str, report: &Value) -> Result<String, Failure> {
    let unfinished =
        |name: &str, end: &str| Failure::of(page, format_args!("{name} does not end; write {end} behind it"));
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((before, after)) = rest.split_once(START) {
        let (name, after) = after.split_once(CLOSE).ok_or_else(|| unfinished("a mark", CLOSE))?;
        let (old, after) = after.split_once(END).ok_or_else(|| unfinished(name, END))?;
        let table = match made::maker(name) {
            None => counted::table(page, name, old.trim())?,
            Some((record, _)) if rows(report, record).is_empty() => {
                let missing = format!("the record has no table {record}; run with --bless");
                return Err(Failure::of(page, missing));
            }
            Some((_, make)) => make(report),
        };
        out += &format!("{before}{START}{name}{CLOSE}\n{table}{END}");
        rest = after;
    }
    Ok(out + rest)
}

/// Returns a count with commas between thousands.
fn grouped(count: u32) -> String {
    let digits = count.to_string();
    let mut out = String::new();
    for (k, digit) in digits.chars().enumerate() {
        if k > 0 && (digits.len() - k).is_multiple_of(3) {
            out.push(',');
        }
        out.push(digit);
    }
    out
}
