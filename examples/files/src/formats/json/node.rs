//! The tree of a JSON text, in which arrays of numbers need 8 bytes a number.

use crate::formats::LARGEST;
use crate::text::number::{Cell, Decimal, cell};
use serde::de::{DeserializeSeed, Deserializer, Error, MapAccess, SeqAccess, Visitor};
use std::borrow::Cow;
use std::fmt;

/// A part of the tree.
#[derive(Clone, Debug, PartialEq)]
pub enum Node {
    /// Nothing, or a truth value.
    Empty,
    Number(f64),
    Text(String),
    /// An array of numbers, where NaN stands for one that is missing.
    Numbers(Vec<f64>),
    Array(Vec<Node>),
    /// The members of an object, in the order of the file.
    Object(Vec<(String, Node)>),
}

/// Why a text has no tree.
#[derive(Debug, PartialEq)]
pub enum Fault {
    TooLarge,
    Broken { line: usize, what: String },
}

/// What the error of a tree that grows too large says.
const TOO_LARGE: &str = "too large";

/// Returns the tree of a text.
pub fn parse(text: &str) -> Result<Node, Fault> {
    let text = without_nan(text);
    let mut room = LARGEST;
    let mut json = serde_json::Deserializer::from_str(&text);
    let node = Seed { room: &mut room }.deserialize(&mut json).and_then(|node| {
        json.end()?;
        Ok(node)
    });
    node.map_err(|error| {
        let what = error.to_string();
        if what.starts_with(TOO_LARGE) {
            return Fault::TooLarge;
        }
        let what = what.split(" at line ").next().unwrap_or("").to_owned();
        Fault::Broken { line: error.line().max(1), what }
    })
}

/// Replaces the words that Python writes for numbers that JSON does not have.
fn without_nan(text: &str) -> Cow<'_, str> {
    const WORDS: [&str; 3] = ["NaN", "-Infinity", "Infinity"];
    if !WORDS.iter().any(|word| text.contains(word)) {
        return Cow::Borrowed(text);
    }
    let mut replaced = String::with_capacity(text.len());
    let mut rest = text;
    let mut is_quoted = false;
    while let Some(first) = rest.chars().next() {
        let word = WORDS.iter().find(|word| !is_quoted && rest.starts_with(**word));
        let length = match (word, first) {
            (Some(word), _) => {
                replaced.push_str("null");
                word.len()
            }
            (None, '\\') if is_quoted => {
                let length = 1 + rest[1..].chars().next().map_or(0, char::len_utf8);
                replaced.push_str(&rest[..length]);
                length
            }
            (None, other) => {
                is_quoted ^= other == '"';
                replaced.push(other);
                other.len_utf8()
            }
        };
        rest = &rest[length..];
    }
    Cow::Owned(replaced)
}

/// Reads a node as long as there is room for it.
struct Seed<'a> {
    room: &'a mut usize,
}

impl Seed<'_> {
    fn take<E: Error>(&mut self, bytes: usize) -> Result<(), E> {
        *self.room = self.room.checked_sub(bytes).ok_or_else(|| E::custom(TOO_LARGE))?;
        Ok(())
    }
}

impl<'de> DeserializeSeed<'de> for Seed<'_> {
    type Value = Node;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Node, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Seed<'_> {
    type Value = Node;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a value")
    }

    fn visit_unit<E: Error>(self) -> Result<Node, E> {
        Ok(Node::Empty)
    }

    fn visit_bool<E: Error>(self, _: bool) -> Result<Node, E> {
        Ok(Node::Empty)
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<Node, E> {
        Ok(Node::Number(number as f64))
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<Node, E> {
        Ok(Node::Number(number as f64))
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<Node, E> {
        Ok(Node::Number(number))
    }

    fn visit_str<E: Error>(mut self, text: &str) -> Result<Node, E> {
        self.take(text.len())?;
        Ok(Node::Text(text.to_owned()))
    }

    fn visit_seq<A: SeqAccess<'de>>(mut self, mut array: A) -> Result<Node, A::Error> {
        let mut numbers: Vec<f64> = Vec::new();
        let mut nodes: Vec<Node> = Vec::new();
        while let Some(node) = array.next_element_seed(Seed { room: &mut *self.room })? {
            if nodes.is_empty() {
                if let Some(number) = number(&node) {
                    self.take(size_of::<f64>())?;
                    numbers.push(number);
                    continue;
                }
                self.take(numbers.len() * size_of::<Node>())?;
                nodes = numbers.drain(..).map(Node::Number).collect();
            }
            self.take(size_of::<Node>())?;
            nodes.push(node);
        }
        Ok(if nodes.is_empty() { Node::Numbers(numbers) } else { Node::Array(nodes) })
    }

    fn visit_map<A: MapAccess<'de>>(mut self, mut object: A) -> Result<Node, A::Error> {
        let mut members = Vec::new();
        while let Some(key) = object.next_key::<String>()? {
            self.take(key.len() + size_of::<(String, Node)>())?;
            members.push((key, object.next_value_seed(Seed { room: &mut *self.room })?));
        }
        Ok(Node::Object(members))
    }
}

/// Returns the number of a node, where null stands for a missing one. Some programs write numbers as texts.
pub fn number(node: &Node) -> Option<f64> {
    match node {
        Node::Number(number) => Some(*number),
        Node::Empty => Some(f64::NAN),
        Node::Text(text) => match cell(text, Decimal::Point) {
            Cell::Number(number) => Some(number),
            Cell::Missing => Some(f64::NAN),
            Cell::Text(_) => match cell(text, Decimal::Comma) {
                Cell::Number(number) => Some(number),
                _ => None,
            },
        },
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrays_of_numbers_are_compact() {
        let node = |text| parse(text).unwrap();
        assert_eq!(node("[1, 2.5, \"3\", -4]"), Node::Numbers(vec![1.0, 2.5, 3.0, -4.0]));
        assert_eq!(node("[1, \"a\"]"), Node::Array(vec![Node::Number(1.0), Node::Text("a".into())]));
        assert!(
            matches!(node("[NaN, -Infinity, null]"), Node::Numbers(numbers) if numbers.iter().all(|n| n.is_nan()))
        );
        assert_eq!(node("{\"NaN\\\"\": true}"), Node::Object(vec![("NaN\"".into(), Node::Empty)]));
        let deep = "[".repeat(300);
        assert!(matches!(parse(&deep), Err(Fault::Broken { .. })));
        assert_eq!(parse("{\n\"a\":\n}"), Err(Fault::Broken { line: 3, what: "expected value".into() }));
    }

    #[test]
    fn what_needs_too_much_memory_is_not_built() {
        let many = format!("[{}1]", "[1],".repeat(8_000_000));
        assert_eq!(parse(&many), Err(Fault::TooLarge));
    }
}
