//! What the holder of a row says of its numbers.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use super::entries::Row;
use super::numbers::{Rounding, like, value};
use super::sections::ROOT;

/// What is on record: the errors of checks by their names, absolute and relative, and the counts on devices.
pub struct Records {
    pub errors: BTreeMap<String, [f64; 2]>,
    pub counts: String,
}

/// Is this what the row's holder says of this number?
pub fn holds(row: &Row, number: &str, records: &Records) -> Result<(), String> {
    let what = row.what.as_str();
    match row.holder.as_str() {
        "formula" => {
            let share = records.error(what)?.into_iter().sum::<f64>();
            let formula =
                what.split_once('(').and_then(|(_, rest)| rest.split_once(')')).ok_or("no formula")?.0;
            let mut numbers = formula.split(|c: char| !c.is_ascii_digit());
            let found = numbers.any(|digits| digits == number);
            verdict(found && (0.5..=1.0).contains(&share), || format!("{share} of it, {what}"))
        }
        "test" => stands_in_the_test(number, what),
        "text" => verdict(has_word(&read(what), number), || format!("no {number} in {what}")),
        "reading" => {
            let (bench, id) = what.split_once(' ').ok_or("no id")?;
            let found = read(&format!("benches/{bench}.rs")).contains(id);
            verdict(found, || format!("no '{id}' in benches/{bench}.rs"))
        }
        _ => {
            let now = renewed(row, number, records)?;
            verdict(value(&now) == value(number), || format!("{now} by what is on record, {what}"))
        }
    }
}

/// A number that a record holds, as the record has it today; the same if it still holds.
pub fn renewed(row: &Row, number: &str, records: &Records) -> Result<String, String> {
    let what = row.what.as_str();
    if row.holder == "record" {
        return Ok(like(number, records.count(what)?, Rounding::Nearest));
    }
    // `NAME` or `NAME * FACTOR`: at least the error that was measured, and no more than twice that.
    let (name, factor) = what.split_once(" * ").map_or((what, 1.0), |(name, factor)| (name, value(factor)));
    let measured = factor
        * match (row.holder.as_str(), records.error(name)?) {
            ("absolute", [absolute, _]) => absolute,
            (_, [absolute, relative]) if absolute == 0.0 || relative == 0.0 => absolute.max(relative),
            _ => return Err(format!("absolute or relative? {name}")),
        };
    let holds = (measured..=2.0 * measured).contains(&value(number));
    Ok(if holds { number.into() } else { like(number, measured, Rounding::Up) })
}

impl Records {
    pub fn of_today() -> Records {
        Records { errors: model::allowed::record::read(), counts: read("tests/data/instructions.txt") }
    }

    /// What is on record for this check.
    fn error(&self, name: &str) -> Result<[f64; 2], String> {
        self.errors.get(name).copied().ok_or(format!("no error of '{name}' is on record"))
    }

    /// `CORE PROFILE UNIT NAME`, with ` + NAME` for the sum of several and ` / NUMBER` for a part of it.
    fn count(&self, what: &str) -> Result<f64, String> {
        let (what, parts) = what.split_once(" / ").map_or((what, 1.0), |(what, parts)| (what, value(parts)));
        let [core, profile, unit, names] = what.splitn(4, ' ').collect::<Vec<_>>()[..] else {
            return Err(format!("no record: {what}"));
        };
        let target = match core {
            "M4F" => "thumbv7em-none-eabihf",
            "M0" => "thumbv6m-none-eabi",
            _ => return Err(format!("no core: {core}")),
        };
        let count = |name: &str| -> Option<f64> {
            let start = format!("{target} {profile} {name} ");
            let mut lines = self.counts.lines();
            lines.find_map(|line| line.strip_prefix(&start)?.strip_suffix(unit)?.trim_end().parse().ok())
        };
        let sum: Option<f64> = names.split(" + ").map(count).sum();
        Ok(sum.ok_or(format!("no {unit} of {names} on record"))? / parts)
    }
}

fn verdict(passes: bool, otherwise: impl FnOnce() -> String) -> Result<(), String> {
    if passes { Ok(()) } else { Err(otherwise()) }
}

pub fn read(path: &str) -> String {
    let path = Path::new(ROOT).join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// `FILE TEST` or `FILE TEST LITERAL`: that test has the number, or what the number is there, in its body.
fn stands_in_the_test(number: &str, what: &str) -> Result<(), String> {
    let mut words = what.splitn(3, ' ');
    let (Some(file), Some(name)) = (words.next(), words.next()) else {
        return Err(format!("no test: {what}"));
    };
    let literal = words.next().unwrap_or(number);
    let text = read(&format!("tests/{file}.rs"));
    let body = body(&text, name).ok_or(format!("no test {name} in tests/{file}.rs"))?;
    verdict(literal.is_empty() || has_word(body, literal), || {
        format!("no {literal} in tests/{file}.rs {name}")
    })
}

/// From `fn NAME` to the brace that closes it, by its indentation.
fn body<'a>(text: &'a str, name: &str) -> Option<&'a str> {
    let start = ["(", "<"].into_iter().find_map(|end| text.find(&format!("fn {name}{end}")))?;
    let line = text[..start].rfind('\n').map_or(0, |newline| newline + 1);
    let indent = &text[line..start];
    let indent = &indent[..indent.len() - indent.trim_start().len()];
    let rest = &text[start..];
    Some(&rest[..rest.find(&format!("\n{indent}}}"))?])
}

/// Does the text have this, and not as a part of another number or word?
fn has_word(text: &str, word: &str) -> bool {
    let within = |c: char| c.is_alphanumeric() || c == '.' || c == '_';
    text.match_indices(word).any(|(k, _)| {
        let before = text[..k].chars().next_back().is_some_and(within) && !text[..k].ends_with("..");
        let after = text[k + word.len()..].trim_start_matches("f32").trim_start_matches("_f32");
        let runs_on = after.starts_with(within) && !after.starts_with("..") && !after.starts_with(". ");
        !before && !runs_on
    })
}
