//! Splits a text into lines.

/// A line of a text, without its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line<'a> {
    /// Where it stands, counted from 1.
    pub number: usize,
    /// What it holds.
    pub text: &'a str,
}

/// Returns the lines of a text, which end with LF, CRLF or CR.
pub fn lines(text: &str) -> impl Iterator<Item = Line<'_>> + Clone {
    let mut rest = Some(text);
    let mut number = 0;
    std::iter::from_fn(move || {
        let text = rest.filter(|text| !text.is_empty())?;
        let end = text.find(['\n', '\r']).unwrap_or(text.len());
        let width = if text[end..].starts_with("\r\n") { 2 } else { 1 };
        rest = text.get(end + width..);
        number += 1;
        Some(Line { number, text: &text[..end] })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_line_ends_are_known() {
        let texts = |text| lines(text).map(|line| line.text).collect::<Vec<_>>();
        assert_eq!(texts("a\nb\r\nc\rd"), ["a", "b", "c", "d"]);
        assert_eq!(texts("a\n\r\nb\n"), ["a", "", "b"]);
        assert_eq!(texts(""), [""; 0]);
        assert_eq!(lines("a\rb").last().map(|line| line.number), Some(2));
    }
}
