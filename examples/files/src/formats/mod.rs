//! Reads the kinds of files that have a structure of their own: CGATS, JCAMP-DX, TM-27, CxF, JSON and .xlsx.

mod cgats;
mod contents;
#[cfg(feature = "xml")]
mod cxf;
mod jcamp;
#[cfg(feature = "json")]
mod json;
#[cfg(feature = "xml")]
mod tm27;
#[cfg(feature = "xlsx")]
pub mod xlsx;
#[cfg(feature = "xml")]
mod xml;

pub use contents::Contents;

use crate::refusal::Refusal;

/// The most bytes that a file may have, or may unpack to, if it must be in memory as a whole.
const LARGEST: usize = 200_000_000;

/// Reads a text if it is of one of these kinds, and returns `None` if it is of none.
pub fn read(text: &str) -> Option<Result<Contents, Refusal>> {
    let start = text.trim_start();
    if start.starts_with('<') && is_markup(start) {
        return Some(check_size(text).and_then(|()| markup(text)));
    }
    if start.starts_with("{\\rtf") {
        return Some(Err(Refusal::of("this is a document of a word processor (RTF); save it as plain text")));
    }
    if is_json(start) {
        return Some(check_size(text).and_then(|()| notation(text)));
    }
    if jcamp::is_jcamp(text) {
        return Some(jcamp::read(text));
    }
    cgats::is_cgats(text).then(|| cgats::read(text))
}

fn check_size(text: &str) -> Result<(), Refusal> {
    if text.len() > LARGEST { Err(too_large()) } else { Ok(()) }
}

/// Refuses what would need too much memory.
fn too_large() -> Refusal {
    Refusal::of("the file unpacks to more than 200 MB; save the spectra that you need in a file of their own")
}

/// Returns whether a text that begins with `<` is XML or HTML rather than a table.
fn is_markup(text: &str) -> bool {
    let second = text.chars().nth(1).unwrap_or(' ');
    text.starts_with("<?xml")
        || text.starts_with("<!")
        || (second.is_alphabetic() && (text.contains("</") || text.contains("/>")))
}

/// Returns whether a text begins as JSON does. A section such as `[Data]` does not.
fn is_json(text: &str) -> bool {
    let mut characters = text.chars().filter(|c| !c.is_whitespace());
    match (characters.next(), characters.next()) {
        (Some('{'), second) => matches!(second, None | Some('"' | '}')),
        (Some('['), Some(second)) => {
            matches!(second, '[' | '{' | '"' | '-' | ']') || (second.is_ascii_digit() && !is_index(text))
        }
        _ => false,
    }
}

/// Returns whether a text begins with a number in brackets, as lines that R prints do.
fn is_index(text: &str) -> bool {
    let line = text.lines().next().unwrap_or("");
    line.split_once(']')
        .is_some_and(|(inside, after)| !inside.contains(',') && after.starts_with([' ', '\t']))
}

#[cfg(feature = "json")]
fn notation(text: &str) -> Result<Contents, Refusal> {
    json::read(text)
}

#[cfg(not(feature = "json"))]
fn notation(_: &str) -> Result<Contents, Refusal> {
    Err(Refusal::of("this is JSON, which is not read here; save the spectrum as CSV"))
}

#[cfg(feature = "xml")]
fn markup(text: &str) -> Result<Contents, Refusal> {
    let root = xml::root(text)?;
    let name = root.to_ascii_lowercase();
    if name.starts_with("iestm27") {
        tm27::read(text)
    } else if name == "cxf" {
        cxf::read(text)
    } else if name == "html" {
        Err(Refusal::of("this is a web page; save the file that it links to or shows"))
    } else {
        let what = format!(
            "this is XML of a kind that is not read, with <{root}> outermost; of XML only TM-27 (.spdx) and CxF \
             are read, so export the spectrum as one of these or as CSV"
        );
        Err(Refusal::of(what))
    }
}

#[cfg(not(feature = "xml"))]
fn markup(_: &str) -> Result<Contents, Refusal> {
    Err(Refusal::of("this is XML, which is not read here; export the spectrum as CSV"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_are_recognized_by_their_beginning() {
        for text in
            ["{\"380\": 1}", " [[380, 1]]", "[1, 2]", "{", "<?xml", "<a/>", "##TITLE= a\n", "CGATS.17\n"]
        {
            assert!(read(text).is_some(), "{text}");
        }
        for text in [
            "",
            "380,1\n381,2",
            "[Data]\n380\t1",
            "[nm]\t[W]\n380\t1",
            "[1] 0.5 0.6",
            "## made by x = 5\n380 1",
            "< 5",
            "{380}",
            "SPECTRUM\n380 1",
        ] {
            assert!(read(text).is_none(), "{text}");
        }
    }

    #[cfg(feature = "xml")]
    #[test]
    fn other_markup_is_refused_by_name() {
        let refusal = |text: &str| read(text).unwrap().unwrap_err().what;
        assert!(refusal("<?xml version='1.0'?><a:Lamp xmlns:a='b'/>").contains("<Lamp>"));
        assert!(refusal("<!DOCTYPE html><html></html>").contains("web page"));
        assert!(refusal("<?xml version='1.0'?>").contains("cut"));
    }
}
