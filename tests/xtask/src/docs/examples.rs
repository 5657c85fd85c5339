//! The examples of a documentation, and the links to others.

use pulldown_cmark::{BrokenLink, CodeBlockKind, CowStr, Event, HeadingLevel, Options, Parser, Tag, TagEnd};
use std::collections::HashMap;

/// What a documentation shows.
pub struct Page {
    /// Whether it has code that is compiled, and meant to be.
    pub has_example: bool,
    /// The addresses of links whose text has the word "example".
    pub example_links: Vec<String>,
    sections: Vec<Section>,
}

/// A heading, by the name that links to it have.
struct Section {
    anchor: String,
    level: HeadingLevel,
    is_open: bool,
    has_example: bool,
}

impl Page {
    pub fn new(docs: &str) -> Self {
        let mut page = Page { has_example: false, example_links: Vec::new(), sections: Vec::new() };
        // A link that has its target for a text is unknown to the parser.
        let keep = |link: BrokenLink| Some((link.reference.into_string().into(), CowStr::from("")));
        let mut anchors = HashMap::<String, usize>::new();
        let mut text = String::new();
        let mut links = Vec::new();
        for event in Parser::new_with_broken_link_callback(docs, Options::ENABLE_TABLES, Some(keep)) {
            match event {
                Event::Text(part) | Event::Code(part) => text += &part,
                Event::SoftBreak | Event::HardBreak => text.push(' '),
                Event::Start(Tag::Heading { .. }) => text.clear(),
                Event::End(TagEnd::Heading(level)) => {
                    page.sections.iter_mut().for_each(|section| section.is_open &= section.level < level);
                    let name = anchor(&text);
                    let times = anchors.entry(name.clone()).or_default();
                    let anchor = if *times == 0 { name } else { format!("{name}-{times}") };
                    *times += 1;
                    page.sections.push(Section { anchor, level, is_open: true, has_example: false });
                }
                Event::Start(Tag::Link { dest_url, .. }) => links.push((dest_url.into_string(), text.len())),
                Event::End(TagEnd::Link) => {
                    let link = links.pop();
                    let is_outside = |link: &str| link.contains("://");
                    let names = |start| text.get(start..).is_some_and(|text| text.contains("example"));
                    page.example_links.extend(
                        link.filter(|(link, start)| !is_outside(link) && names(*start)).map(|(link, _)| link),
                    );
                }
                Event::Start(Tag::CodeBlock(kind)) if is_example(&kind) => {
                    page.has_example = true;
                    let open = page.sections.iter_mut().filter(|section| section.is_open);
                    open.for_each(|section| section.has_example = true);
                }
                _ => {}
            }
        }
        page
    }

    /// Whether there is an example below the heading with this anchor.
    pub fn shows(&self, anchor: &str) -> bool {
        self.sections.iter().any(|section| section.anchor == anchor && section.has_example)
    }
}

/// Rust that a test compiles. What must not compile shows no use of an item.
fn is_example(kind: &CodeBlockKind) -> bool {
    let CodeBlockKind::Fenced(info) = kind else { return true };
    let mut words = info.split([',', ' ']).filter(|word| !word.is_empty());
    words.all(|word| ["rust", "should_panic", "no_run"].contains(&word) || word.starts_with("edition"))
}

/// The name that rustdoc gives to a heading for links.
fn anchor(heading: &str) -> String {
    let kept = |char: char| match char {
        ' ' => Some('-'),
        _ if char.is_alphanumeric() || matches!(char, '-' | '_') => Some(char.to_ascii_lowercase()),
        _ => None,
    };
    heading.chars().filter_map(kept).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_example_is_code_that_is_compiled() {
        for info in ["", "rust", "no_run", "should_panic,edition2024"] {
            assert!(Page::new(&format!("Shows it.\n\n```{info}\nlet x = 1;\n```")).has_example, "{info}");
        }
        for info in ["text", "ignore", "compile_fail", "compile_fail,E0308", "sh", "toml"] {
            assert!(!Page::new(&format!("Shows it.\n\n```{info}\nlet x = 1;\n```")).has_example, "{info}");
        }
    }

    #[test]
    fn a_section_lasts_until_the_next_of_its_level() {
        let page = Page::new(
            "# Example\n\nSome.\n\n## A `Dye`, first\n\n```\nlet x = 1;\n```\n\n# Cost\n\nNone.\n\n# Example\n\n\
             ```\nlet x = 1;\n```",
        );
        assert!(page.shows("example") && page.shows("a-dye-first") && page.shows("example-1"));
        assert!(!page.shows("cost") && !page.shows("a-dye"));
    }

    #[test]
    fn links_to_examples_say_so() {
        let page = Page::new(
            "See the [example](#example), the [first\nexample](Dye#example), [examples/cli](https://example.org), \
             [the `example` there][Observer], [`Dye`] and [more](#example).",
        );
        assert_eq!(page.example_links, ["#example", "Dye#example", "Observer"]);
    }
}
