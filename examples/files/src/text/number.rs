//! Reads the numbers of cells.

/// The sign between the whole part of a number and its fraction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decimal {
    /// As in 0.5.
    Point,
    /// As in 0,5.
    Comma,
}

/// What a cell holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cell<'a> {
    /// A finite number.
    Number(f64),
    /// Nothing, or a word such as NaN that stands for it.
    Missing,
    /// Anything else.
    Text(&'a str),
}

/// The words for a value that is not there, in lower case.
const MISSING: [&str; 20] = [
    "",
    "nan",
    "na",
    "n/a",
    "#n/a",
    "null",
    "none",
    "nil",
    "-",
    "--",
    "---",
    "#num!",
    "#value!",
    "#div/0!",
    "inf",
    "-inf",
    "+inf",
    "infinity",
    "-infinity",
    "+infinity",
];

/// Reads a cell.
pub fn cell(text: &str, decimal: Decimal) -> Cell<'_> {
    let text = text.trim();
    if let Some(number) = number(text, decimal) {
        return Cell::Number(number);
    }
    // Infinity stands for a division by nothing, as the words of spreadsheets do.
    let short = text.len() <= 9;
    if short && MISSING.contains(&text.to_lowercase().as_str()) { Cell::Missing } else { Cell::Text(text) }
}

/// Reads a finite number, with the exponents of Fortran and the minus sign of print too.
pub fn number(text: &str, decimal: Decimal) -> Option<f64> {
    let first = text.chars().next()?;
    if !(first.is_ascii_digit() || matches!(first, '+' | '-' | '−' | '.' | ',')) {
        return None;
    }
    let plain =
        text.bytes().all(|byte| byte.is_ascii_digit() || matches!(byte, b'.' | b'-' | b'+' | b'e' | b'E'));
    let parsed = if plain && decimal == Decimal::Point {
        text.parse::<f64>()
    } else {
        let (mark, other) = if decimal == Decimal::Comma { (',', '.') } else { ('.', ',') };
        let whole = text.split(mark).next().unwrap_or("");
        if text.contains(other) && !(text.contains(mark) && is_grouped(whole, other)) {
            return None;
        }
        let replaced = text.replace(other, "").replace(mark, ".").replace('−', "-").replace(['d', 'D'], "e");
        // Nothing but what a number has, so that "infinity" and "nan" stay words.
        if !replaced
            .bytes()
            .all(|byte| byte.is_ascii_digit() || matches!(byte, b'.' | b'-' | b'+' | b'e' | b'E'))
        {
            return None;
        }
        replaced.parse::<f64>()
    };
    parsed.ok().filter(|number| number.is_finite())
}

/// Returns whether the digits stand in groups of three, as in 1,234,567.
fn is_grouped(whole: &str, mark: char) -> bool {
    let mut groups = whole.trim_start_matches(['+', '-', '−']).split(mark);
    let is_group = |group: &str| group.len() == 3 && group.bytes().all(|byte| byte.is_ascii_digit());
    groups.next().is_some_and(|first| (1..=3).contains(&first.len())) && groups.all(is_group)
}

/// A cell that holds a number and words around it, such as `380nm` or `Spectral Data 380[nm]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Labeled<'a> {
    /// The number.
    pub number: f64,
    /// What stands before it.
    pub before: &'a str,
    /// What stands behind it.
    pub after: &'a str,
}

impl<'a> Labeled<'a> {
    /// Returns the words behind the number, or those before it if there are none.
    pub fn said(&self) -> &'a str {
        if self.after.is_empty() { self.before } else { self.after }
    }
}

/// Finds the first number in a cell that has words, too.
pub fn labeled(text: &str, decimal: Decimal) -> Option<Labeled<'_>> {
    let text = text.trim();
    let start = text.find(|c: char| c.is_ascii_digit())?;
    let mark = if decimal == Decimal::Comma { ',' } else { '.' };
    let length = text[start..].find(|c: char| !c.is_ascii_digit() && c != mark).unwrap_or(text.len() - start);
    let digits = text[start..start + length].trim_end_matches(mark);
    let (before, after) = (text[..start].trim(), text[start + digits.len()..].trim());
    if before.is_empty() && after.is_empty() || before.ends_with(['-', '.', ',']) {
        return None;
    }
    Some(Labeled { number: number(digits, decimal)?, before, after })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read() {
        let point = |text| number(text, Decimal::Point);
        assert_eq!(point("380"), Some(380.0));
        assert_eq!(point("-1.5E-3"), Some(-0.0015));
        assert_eq!(point("1.5D-3"), Some(0.0015));
        assert_eq!(point("−2"), Some(-2.0));
        assert_eq!(point(".5"), Some(0.5));
        for text in
            ["", "nan", "inf", "1,5", "1e999", "380nm", "1 2", "0x10", "+", "1.2.3", "-", "e5", "infinity"]
        {
            assert_eq!(point(text), None, "{text}");
        }
        assert_eq!(number("0,5", Decimal::Comma), Some(0.5));
        assert_eq!(number("0.5", Decimal::Comma), None);
        // Both marks in a number leave no doubt which one groups.
        assert_eq!(point("1,234,567.5"), Some(1_234_567.5));
        assert_eq!(number("-1.234,5", Decimal::Comma), Some(-1234.5));
        assert_eq!(point("1,23,567.5"), None);
        assert_eq!(cell(" NaN ", Decimal::Point), Cell::Missing);
        assert_eq!(cell("lamp", Decimal::Point), Cell::Text("lamp"));
    }

    #[test]
    fn labels_are_split_off() {
        let split = |text| labeled(text, Decimal::Point).map(|l| (l.number, l.before, l.after));
        assert_eq!(split("380nm"), Some((380.0, "", "nm")));
        assert_eq!(split("Spectral Data 380[nm]"), Some((380.0, "Spectral Data", "[nm]")));
        assert_eq!(split("380(mW/m2/nm)"), Some((380.0, "", "(mW/m2/nm)")));
        assert_eq!(split("SPECTRAL_NM380.5"), Some((380.5, "SPECTRAL_NM", "")));
        assert_eq!(split("380"), None);
        assert_eq!(split("-380nm"), None);
        assert_eq!(split("lamp"), None);
    }
}
