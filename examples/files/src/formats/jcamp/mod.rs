//! Reads JCAMP-DX 4.24 and 5.01, which chemists use for spectra of all kinds.

mod block;
mod compressed;
mod points;

use super::Contents;
use crate::refusal::{Note, Refusal};
use crate::text::lines::{Line, lines};
use block::Block;

/// The labels that no other kind of file has, spelled as [`label`] returns them.
const LABELS: [&str; 6] = ["TITLE", "JCAMPDX", "DATATYPE", "XYDATA", "XYPOINTS", "XUNITS"];

/// Returns whether the first labels of a text are those of JCAMP-DX.
pub fn is_jcamp(text: &str) -> bool {
    let begins = lines(text).find(|line| !line.text.trim().is_empty() && !line.text.trim().starts_with("$$"));
    begins.is_some_and(|line| line.text.trim_start().starts_with("##"))
        && lines(text)
            .take(100)
            .any(|line| label(line.text).is_some_and(|(label, _)| LABELS.contains(&&*label)))
}

/// Returns the label of a line such as `##DATA TYPE= UV/VIS SPECTRUM` without what its spelling may vary in, and its
/// value.
fn label(line: &str) -> Option<(String, &str)> {
    let (label, value) = line.trim_start().strip_prefix("##")?.split_once('=')?;
    let plain = label.chars().filter(|c| !matches!(c, ' ' | '-' | '/' | '_' | '\t'));
    Some((plain.flat_map(char::to_uppercase).collect(), without_remark(value).trim()))
}

fn without_remark(text: &str) -> &str {
    text.split_once("$$").map_or(text, |(before, _)| before)
}

/// Reads the blocks of a file.
pub fn read(text: &str) -> Result<Contents, Refusal> {
    let lines: Vec<Line> = lines(text).collect();
    let mut contents = Contents::default();
    let mut refusals: Vec<(String, Refusal)> = Vec::new();
    for block in blocks(&lines, &mut contents) {
        let title = block.value("TITLE").unwrap_or("").to_owned();
        match block.read(&lines, &mut contents.notes) {
            Ok(Some(spectrum)) => contents.add(spectrum),
            Ok(None) => {}
            Err(refusal) => refusals.push((title, refusal)),
        }
    }
    if contents.grids.is_empty() {
        let first = refusals.into_iter().next().map(|(_, refusal)| refusal);
        let nothing =
            "the file has no XYDATA and no XYPOINTS, so it holds no spectrum; export the curve itself";
        return Err(first.unwrap_or_else(|| Refusal::of(nothing)));
    }
    for (title, refusal) in refusals {
        contents.notes.push(Note::left_out(format!("the block '{title}': {refusal}")));
    }
    Ok(contents)
}

/// Splits a file into its blocks, each from a title to its end. Blocks may stand inside of others.
fn blocks(lines: &[Line], contents: &mut Contents) -> Vec<Block> {
    let mut done = Vec::new();
    let mut open: Vec<Block> = Vec::new();
    for (place, line) in lines.iter().enumerate() {
        let Some((name, value)) = label(line.text) else {
            if let Some(block) = open.last_mut() {
                block.goes_on(place);
            }
            continue;
        };
        match name.as_str() {
            // A spectrum whose end is missing ends where the next begins.
            "TITLE" if open.last().is_some_and(Block::has_data) => done.extend(open.pop()),
            "END" => {
                done.extend(open.pop());
                continue;
            }
            _ => {}
        }
        if name == "TITLE" || open.is_empty() {
            open.push(Block::default());
        }
        let shown =
            line.text.trim_start().trim_start_matches('#').split_once('=').map_or("", |(name, _)| name);
        contents.fact(line.number, shown, value);
        if let Some(block) = open.last_mut() {
            block.state(name, value, line.number, place);
        }
    }
    // Those that were cut are looked at, too, because their number of points tells.
    done.extend(open);
    done
}

#[cfg(test)]
mod tests;
