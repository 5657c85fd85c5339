//! tests/data/claims.txt: for every number of every section, what holds it.

use std::fs;
use std::path::Path;

use super::numbers::value;
use super::sections::ROOT;
use model::allowed::record;

/// A section of the documentation, and the rows below its title.
pub struct Entry {
    pub title: String,
    pub rows: Vec<Row>,
}

/// Numbers that one line of the table covers, and by what.
pub struct Row {
    pub numbers: Vec<String>,
    pub holder: String,
    pub what: String,
}

const HOLDERS: [&str; 10] =
    ["measured", "absolute", "formula", "record", "test", "reading", "once", "algorithm", "context", "words"];

/// The table.
pub fn entries() -> Vec<Entry> {
    let text = read("tests/data/claims.txt");
    let mut entries: Vec<Entry> = Vec::new();
    for line in text.lines().filter(|line| !line.is_empty() && !line.starts_with('#')) {
        let Some(row) = line.strip_prefix("  ") else {
            entries.push(Entry { title: line.to_string(), rows: Vec::new() });
            continue;
        };
        let words: Vec<&str> = row.split(' ').collect();
        let place = words.iter().position(|word| HOLDERS.contains(word));
        let place = place.unwrap_or_else(|| panic!("what holds it? {line}"));
        entries.last_mut().unwrap_or_else(|| panic!("of which section? {line}")).rows.push(Row {
            numbers: words[..place].iter().map(|number| number.to_string()).collect(),
            holder: words[place].to_string(),
            what: words[place + 1..].join(" "),
        });
    }
    entries
}

/// Is this what the row's holder says of this number?
pub fn holds(row: &Row, number: &str) -> Result<(), String> {
    let what = row.what.as_str();
    match row.holder.as_str() {
        "measured" => near_the_error(number, what, |[absolute, relative]| {
            if absolute > 0.0 && relative > 0.0 { f64::NAN } else { absolute.max(relative) }
        }),
        "absolute" => near_the_error(number, what, |[absolute, _]| absolute),
        "formula" => {
            let share = error(what)?.into_iter().sum::<f64>();
            let formula =
                what.split_once('(').and_then(|(_, rest)| rest.split_once(')')).ok_or("no formula")?.0;
            let mut numbers = formula.split(|c: char| !c.is_ascii_digit());
            let found = numbers.any(|digits| digits == number);
            verdict(found && (0.5..=1.0).contains(&share), || format!("{share} of it, {what}"))
        }
        "record" => near_the_record(number, what),
        "test" => stands_in_the_test(number, what),
        "reading" => {
            let (bench, id) = what.split_once(' ').ok_or("no id")?;
            let found = read(&format!("benches/{bench}.rs")).contains(id);
            verdict(found, || format!("no '{id}' in benches/{bench}.rs"))
        }
        _ => Ok(()),
    }
}

fn verdict(passes: bool, otherwise: impl FnOnce() -> String) -> Result<(), String> {
    if passes { Ok(()) } else { Err(otherwise()) }
}

fn read(path: &str) -> String {
    let path = Path::new(ROOT).join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// What is on record for this check of tests/allowed.
fn error(name: &str) -> Result<[f64; 2], String> {
    record::read().get(name).copied().ok_or(format!("no error of '{name}' is on record"))
}

/// `NAME` or `NAME * FACTOR`: the number is at least the error that was measured, and no more than twice that.
fn near_the_error(number: &str, what: &str, part: impl Fn([f64; 2]) -> f64) -> Result<(), String> {
    let (name, factor) = what.split_once(" * ").map_or((what, 1.0), |(name, factor)| (name, value(factor)));
    let measured = factor * part(error(name)?);
    let claimed = value(number);
    verdict(measured <= claimed && claimed <= 2.0 * measured, || format!("{measured:.3e} measured, {name}"))
}

/// `CORE PROFILE UNIT NAME`, with ` / NUMBER` for a part of it: the number is what was counted, to 2 %.
fn near_the_record(number: &str, what: &str) -> Result<(), String> {
    let (what, parts) = what.split_once(" / ").map_or((what, 1.0), |(what, parts)| (what, value(parts)));
    let [core, profile, unit, name] = what.split(' ').collect::<Vec<_>>()[..] else {
        return Err(format!("no record: {what}"));
    };
    let target = match core {
        "M4F" => "thumbv7em-none-eabihf",
        "M0" => "thumbv6m-none-eabi",
        _ => return Err(format!("no core: {core}")),
    };
    let records = read("tests/data/instructions.txt");
    let start = format!("{target} {profile} {name} ");
    let counted = records
        .lines()
        .find_map(|line| line.strip_prefix(&start)?.strip_suffix(unit)?.trim_end().parse().ok());
    let counted: f64 = counted.ok_or(format!("no {unit} of {name} on record"))?;
    let counted = counted / parts;
    let near = (value(number) - counted).abs() <= 0.02 * counted;
    verdict(near, || format!("{counted} {unit} on record, {what}"))
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
