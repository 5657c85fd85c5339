//! Walks through XML without regard to namespaces, and without entities of its own.

use crate::refusal::Refusal;
use quick_xml::XmlVersion;
use quick_xml::events::{BytesStart, Event};
use quick_xml::reader::Reader;

/// The beginning or the end of an element.
pub enum Tag<'a> {
    Open { name: &'a str, attributes: &'a [(String, String)] },
    Close { name: &'a str, parent: &'a str, text: &'a str },
}

/// Returns the name of the outermost element.
pub fn root(text: &str) -> Result<String, Refusal> {
    let mut walk = Walk::of(text);
    loop {
        match walk.next()? {
            Event::Start(start) => return Ok(start.local_name().into_inner().to_owned()),
            Event::Eof => {
                return Err(Refusal::of("the XML has no element, so the file was cut; save it again"));
            }
            _ => {}
        }
    }
}

/// Calls a function at each beginning and end of an element, with the line where it stands. The text of an element
/// is what stands behind the last element inside it.
pub fn walk(text: &str, mut visit: impl FnMut(Tag, usize) -> Result<(), Refusal>) -> Result<(), Refusal> {
    let mut walk = Walk::of(text);
    let mut open: Vec<(String, usize)> = Vec::new();
    let mut inside = String::new();
    loop {
        let event = walk.next()?;
        let line = walk.line;
        match event {
            Event::Start(start) => {
                let name = start.local_name().into_inner().to_owned();
                let attributes = attributes(&start, line)?;
                visit(Tag::Open { name: &name, attributes: &attributes }, line)?;
                open.push((name, line));
                inside.clear();
            }
            Event::End(_) => {
                let Some((name, _)) = open.pop() else { continue };
                let parent = open.last().map_or("", |(name, _)| name.as_str());
                visit(Tag::Close { name: &name, parent, text: inside.trim() }, line)?;
                inside.clear();
            }
            Event::Text(text) => inside.push_str(&text),
            Event::CData(text) => inside.push_str(&text),
            Event::GeneralRef(reference) => inside.push(character(&reference, line)?),
            Event::Eof => break,
            _ => {}
        }
    }
    match open.last() {
        Some((name, line)) => {
            let what = format!("<{name}> has no end, so the file was cut; save or export it again");
            Err(Refusal::at(*line, what))
        }
        None => Ok(()),
    }
}

/// Returns an attribute, whatever the case of its name is.
pub fn attribute<'a>(attributes: &'a [(String, String)], wanted: &str) -> Option<&'a str> {
    let found = attributes.iter().find(|(name, _)| name.eq_ignore_ascii_case(wanted));
    found.map(|(_, value)| value.trim())
}

/// A reader that knows its line.
struct Walk<'a> {
    reader: Reader<&'a [u8]>,
    text: &'a str,
    position: usize,
    line: usize,
}

impl<'a> Walk<'a> {
    fn of(text: &'a str) -> Self {
        let mut reader = Reader::from_str(text);
        reader.config_mut().expand_empty_elements = true;
        Walk { reader, text, position: 0, line: 1 }
    }

    fn next(&mut self) -> Result<Event<'a>, Refusal> {
        let event = self.reader.read_event();
        let reached = match event {
            Ok(_) => self.reader.buffer_position(),
            Err(_) => self.reader.error_position(),
        };
        let end = self.text.len().min(reached as usize).max(self.position);
        let bytes = &self.text.as_bytes()[self.position..end];
        let feeds = bytes.iter().filter(|byte| **byte == b'\n').count();
        // Old files have CR alone.
        self.line += if feeds > 0 { feeds } else { bytes.iter().filter(|byte| **byte == b'\r').count() };
        self.position = end;
        event.map_err(|error| {
            Refusal::at(self.line, format!("the XML is broken: {error}; save the file again"))
        })
    }
}

fn attributes(start: &BytesStart, line: usize) -> Result<Vec<(String, String)>, Refusal> {
    let broken = |error: &dyn std::fmt::Display| {
        Refusal::at(line, format!("the XML is broken: {error}; save the file again"))
    };
    start
        .attributes()
        .map(|attribute| {
            let attribute = attribute.map_err(|error| broken(&error))?;
            let value =
                attribute.normalized_value(XmlVersion::Implicit1_0).map_err(|error| broken(&error))?;
            Ok((attribute.key.local_name().into_inner().to_owned(), value.into_owned()))
        })
        .collect()
}

/// Returns the character of a reference: one of the five of XML, or a number.
fn character(name: &str, line: usize) -> Result<char, Refusal> {
    let number = |text: &str, base| u32::from_str_radix(text, base).ok().and_then(char::from_u32);
    let found = match name {
        "lt" => Some('<'),
        "gt" => Some('>'),
        "amp" => Some('&'),
        "quot" => Some('"'),
        "apos" => Some('\''),
        _ => match (name.strip_prefix("#x"), name.strip_prefix('#')) {
            (Some(digits), _) => number(digits, 16),
            (None, Some(digits)) => number(digits, 10),
            (None, None) => None,
        },
    };
    found.ok_or_else(|| {
        Refusal::at(
            line,
            format!("&{name}; is an entity that is not one of XML's own; replace it by its text"),
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tags(text: &str) -> Result<Vec<String>, Refusal> {
        let mut tags = Vec::new();
        walk(text, |tag, line| {
            tags.push(match tag {
                Tag::Open { name, attributes } => format!("{line} <{name}> {attributes:?}"),
                Tag::Close { name, parent, text } => format!("{line} {parent}/{name} {text}"),
            });
            Ok(())
        })?;
        Ok(tags)
    }

    #[test]
    fn elements_come_with_their_lines() {
        let text = "<?xml version='1.0'?>\n<n:a b='1 &lt; 2'>\n <c/>x &amp; <![CDATA[<y>]]> &#65;\r\n</n:a>";
        assert_eq!(
            tags(text).unwrap(),
            ["2 <a> [(\"b\", \"1 < 2\")]", "3 <c> []", "3 a/c ", "4 /a x & <y> A"]
        );
        assert_eq!(root(text).unwrap(), "a");
    }

    #[test]
    fn broken_markup_is_refused_with_its_line() {
        let line = |text: &str| tags(text).unwrap_err().line;
        assert_eq!(line("<a>\n<b>\n</a>"), Some(3));
        assert_eq!(line("<a>\n<b>"), Some(2));
        assert_eq!(line("<a>\n&what;</a>"), Some(2));
        assert_eq!(line("<a>\n<b c='&what;'/></a>"), Some(2));
        let bomb = "<!DOCTYPE a [<!ENTITY b 'xx'>]>\n<a>&b;</a>";
        assert_eq!(line(bomb), Some(2));
    }
}
