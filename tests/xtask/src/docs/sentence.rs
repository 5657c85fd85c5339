//! The first sentence of a documentation, and whether it is one.

use pulldown_cmark::{Event, Parser, Tag, TagEnd};
use std::collections::BTreeSet;

/// The fault that a word may be missing in the list of verbs.
pub const VERBLESS: &str = "begins with a sentence without a verb";

/// What ends in a period that does not end a sentence.
const ABBREVIATIONS: [&str; 14] = [
    "e.g.", "i.e.", "cf.", "vs.", "al.", "approx.", "ca.", "resp.", "ed.", "pp.", "Eq.", "Eqs.", "Fig.",
    "No.",
];

/// The first sentence, as plain text with code between backticks, if the documentation begins with a
/// paragraph.
pub fn first_sentence(docs: &str) -> Option<String> {
    let mut events = Parser::new(docs);
    if events.next() != Some(Event::Start(Tag::Paragraph)) {
        return None;
    }
    let mut text = String::new();
    for event in events.take_while(|event| *event != Event::End(TagEnd::Paragraph)) {
        match event {
            Event::Text(part) => text += &part,
            Event::Code(code) => text += &format!("`{code}`"),
            Event::SoftBreak | Event::HardBreak => text.push(' '),
            _ => {}
        }
    }
    let end = end_of_sentence(&text);
    text.truncate(end);
    Some(text)
}

/// Where the first sentence of a paragraph ends: behind a mark that a beginning of a sentence follows.
fn end_of_sentence(text: &str) -> usize {
    let mut in_code = false;
    for (place, char) in text.char_indices() {
        in_code ^= char == '`';
        if in_code || !matches!(char, '.' | '!' | '?') {
            continue;
        }
        let (sentence, rest) = text.split_at(place + 1);
        let closed = rest.trim_start_matches([')', '"', '\'', '”', '’']);
        let begins = |char: char| char.is_uppercase() || matches!(char, '`' | '(' | '[' | '"' | '“');
        let next = closed.trim_start();
        let is_apart = next.len() < closed.len() && next.starts_with(begins);
        let word = sentence.rsplit([' ', '(']).next().unwrap_or_default();
        if is_apart && !ABBREVIATIONS.contains(&word) {
            return text.len() - closed.len();
        }
    }
    text.len()
}

/// Why a text is no full sentence, if it is none.
pub fn fault(sentence: &str, verbs: &BTreeSet<String>) -> Option<String> {
    // Every other part is code, which is one word and never a verb.
    let parts = || sentence.split('`').enumerate();
    let prose: String = parts().map(|(k, part)| if k % 2 == 0 { part } else { "0" }).collect();
    let words = prose.split_whitespace().filter(|word| word.contains(char::is_alphanumeric)).count();
    if words < 5 {
        return Some(format!("begins with a sentence of fewer than five words: \"{sentence}\""));
    }
    let lower = prose.to_lowercase();
    let mut words = lower.split(|char: char| !char.is_alphabetic() && !matches!(char, '\'' | '-'));
    if words.any(|word| verbs.contains(word)) {
        return None;
    }
    Some(format!("{VERBLESS}: \"{sentence}\""))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_sentence_ends_where_a_reader_would_end_it() {
        let cases = [
            ("Returns it. And more.", "Returns it."),
            ("Takes a step, e.g. Five nanometers. Then stops.", "Takes a step, e.g. Five nanometers."),
            ("Takes a step (e.g. Five nanometers).\nThen stops.", "Takes a step (e.g. Five nanometers)."),
            ("Wyman et al. 2013 fit it. It is short.", "Wyman et al. 2013 fit it."),
            ("The table has a step of 5 nm. The CIE's has 1 nm.", "The table has a step of 5 nm."),
            (
                "Uses `code.with.dots` and 0.5 of `a. B` each. Next.",
                "Uses `code.with.dots` and 0.5 of `a. B` each.",
            ),
            ("By CIE 15: 2018, which says it. Next.", "By CIE 15: 2018, which says it."),
            ("Is it black? It is.", "Is it black?"),
            ("Is (see there.) It is.", "Is (see there.)"),
            (
                "Shows [`Dye`] to\nan [observer](crate::Observer#example). `x` is new.",
                "Shows [`Dye`] to an observer.",
            ),
            ("Has one paragraph\n\nand another. Next.", "Has one paragraph"),
            ("Relative to Y. It is.", "Relative to Y."),
        ];
        for (docs, sentence) in cases {
            assert_eq!(first_sentence(docs).as_deref(), Some(sentence));
        }
        for docs in ["# A heading", "* A list of things.", "```\nlet code = 1;\n```"] {
            assert_eq!(first_sentence(docs), None);
        }
    }

    #[test]
    fn a_sentence_has_five_words_and_a_verb() {
        let verbs = ["is", "re-emits"].map(str::to_owned).into();
        assert_eq!(fault("This word is the fifth.", &verbs), None);
        assert_eq!(fault("`Dye::new(0.5, 3)` is - of `Dye` here.", &verbs), None);
        assert_eq!(fault("The dye re-emits all light.", &verbs), None);
        assert!(fault("This is - four words.", &verbs).unwrap().contains("fewer than five words"));
        assert_eq!(fault("`this is - it` is what really matters.", &verbs), None);
        assert!(
            fault("Five words but `is` code, this isn't one.", &verbs).unwrap().contains("without a verb")
        );
    }
}
