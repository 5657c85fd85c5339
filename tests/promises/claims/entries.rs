//! tests/data/claims.txt: which numbers of the documentation are held, and by what.

use super::sections::Section;

pub const PATH: &str = "tests/data/claims.txt";

/// A section of the documentation, and the rows below its title.
pub struct Entry {
    pub title: String,
    pub rows: Vec<Row>,
}

/// Numbers that one line of the table covers, and by what.
pub struct Row {
    /// The line of the table, from 0.
    pub line: usize,
    pub numbers: Vec<String>,
    pub holder: String,
    pub what: String,
}

impl Row {
    /// Can its numbers be written anew by what holds them?
    pub fn is_recorded(&self) -> bool {
        ["measured", "absolute", "record"].contains(&self.holder.as_str())
    }

    /// Its numbers, without the places of those that stand in their section more than once.
    pub fn values(&self) -> impl Iterator<Item = &str> {
        self.numbers.iter().map(|number| place(number).0)
    }
}

const HOLDERS: [&str; 7] = ["measured", "absolute", "formula", "record", "test", "text", "reading"];

/// What the text of the table says.
pub fn entries(text: &str) -> Vec<Entry> {
    let mut entries: Vec<Entry> = Vec::new();
    for (number, line) in
        text.lines().enumerate().filter(|(_, line)| !line.is_empty() && !line.starts_with('#'))
    {
        let Some(row) = line.strip_prefix("  ") else {
            entries.push(Entry { title: line.to_string(), rows: Vec::new() });
            continue;
        };
        let words: Vec<&str> = row.split(' ').collect();
        let place = words.iter().position(|word| HOLDERS.contains(word));
        let place = place.unwrap_or_else(|| panic!("what holds it? {line}"));
        entries.last_mut().unwrap_or_else(|| panic!("of which section? {line}")).rows.push(Row {
            line: number,
            numbers: words[..place].iter().map(|number| number.to_string()).collect(),
            holder: words[place].to_string(),
            what: words[place + 1..].join(" "),
        });
    }
    entries
}

/// `444#2` is the second 444 of the section.
fn place(number: &str) -> (&str, Option<usize>) {
    match number.split_once('#') {
        Some((number, place)) => (number, Some(place.parse().expect("a place behind #"))),
        None => (number, None),
    }
}

impl Entry {
    /// Each number of each row, and which number of the section it is. A number that may be written anew has
    /// to be told from others that read the same.
    pub fn places<'a>(&'a self, section: &Section) -> Result<Vec<(&'a Row, usize, usize)>, String> {
        let mut places: Vec<(&Row, usize, usize)> = Vec::new();
        let all = || self.rows.iter().flat_map(|row| (0..row.numbers.len()).map(move |k| (row, k)));
        for (n, (row, k)) in all().enumerate() {
            let (number, given) = place(&row.numbers[k]);
            let same = |(row, k): &(&Row, usize)| place(&row.numbers[*k]).0 == number;
            let there: Vec<usize> =
                (0..section.numbers.len()).filter(|&k| section.numbers[k].text == number).collect();
            let (rows, recorded) =
                (all().filter(same).count(), all().filter(same).any(|(row, _)| row.is_recorded()));
            if given.is_none() && recorded && rows != there.len() {
                return Err(format!(
                    "{number} stands there {} times, in {rows} rows: say which is held by {number}#1, {number}#2, ...",
                    there.len()
                ));
            }
            let nth = given.map_or_else(|| all().take(n).filter(same).count(), |nth| nth - 1);
            let place = *there.get(nth).ok_or(format!("no {} is there", row.numbers[k]))?;
            if places.iter().any(|(.., taken)| *taken == place) {
                return Err(format!("{} is held twice", row.numbers[k]));
            }
            places.push((row, k, place));
        }
        Ok(places)
    }
}
