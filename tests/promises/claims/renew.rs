//! Numbers in documentation and table that are no longer what is on record, written anew.

use std::cmp::Reverse;
use std::ops::Range;

use super::entries::entries;
use super::held::{Records, renewed};
use super::numbers::{plain, value};
use super::sections::{Texts, sections};

/// Renews the texts and the table, and says what was changed, a line for each number. What it cannot renew is
/// left to the tests to find.
pub fn renew(texts: &mut Texts, table: &mut String, records: &Records) -> Vec<String> {
    let sections = sections(texts);
    let mut lines: Vec<String> = table.lines().map(str::to_string).collect();
    let mut edits: Vec<(&str, Range<usize>, String)> = Vec::new();
    let mut changes = Vec::new();
    for entry in entries(table) {
        let Some(section) = sections.get(&entry.title) else { continue };
        let places = entry.places(section).unwrap_or_default();
        let mut now: Vec<String> = section.numbers.iter().map(|number| number.text.clone()).collect();
        let mut moved = Vec::new();
        for &(row, _, place) in places.iter().filter(|(row, ..)| row.is_recorded()) {
            let number = &section.numbers[place];
            let old = &texts[&section.file][number.at.clone()];
            let Some(new) = renewed(row, old, records).ok().filter(|new| value(new) != value(old)) else {
                continue;
            };
            changes.push(format!("{}: {old} -> {new}", entry.title));
            now[place] = plain(&new);
            moved.extend([number.text.clone(), plain(&new)]);
            edits.push((&section.file, number.at.clone(), new));
        }
        for (row, k, place) in places {
            if moved.contains(&now[place]) || moved.contains(&section.numbers[place].text) {
                // Behind the two spaces that a row begins with.
                let mut words: Vec<String> = lines[row.line].split(' ').map(str::to_string).collect();
                let same = |end: usize| now[..end].iter().filter(|text| **text == now[place]).count();
                let nth = if same(now.len()) > 1 { format!("#{}", same(place) + 1) } else { String::new() };
                words[k + 2] = format!("{}{nth}", now[place]);
                lines[row.line] = words.join(" ");
            }
        }
    }
    edits.sort_by_key(|(_, at, _)| Reverse(at.start));
    for (file, at, new) in edits {
        texts.get_mut(file).expect("the text of a section").replace_range(at, &new);
    }
    if !changes.is_empty() {
        *table = lines.join("\n") + "\n";
    }
    changes
}
