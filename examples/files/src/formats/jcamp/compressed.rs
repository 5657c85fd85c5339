//! Decodes lines of a place and many values, in plain numbers or in the compressed forms PAC, SQZ, DIF and DUP.
//!
//! In PAC the sign of a number separates it from the one before it. In SQZ a letter stands for the sign and the first
//! digit: `@ABC..I` for 0 to 9, and `abc..i` for -1 to -9. In DIF the letters `%JKL..R` and `jkl..r` do the same for
//! the difference to the value before it. In DUP the letters `STU..Z` and `s` say how often a value, or a difference,
//! comes in a row. A line that ends with a difference is checked by the next line, which repeats its last value.

use crate::refusal::Refusal;
use crate::text::lines::Line;

/// A line of data.
#[derive(Debug, PartialEq)]
pub struct Row {
    pub line: usize,
    /// Where it begins on the axis, before any factor.
    pub place: f64,
    /// How many values stand above it.
    pub index: usize,
    pub values: Vec<f64>,
}

/// The most values that a file may have, so that few letters do not fill the memory.
const MOST: usize = 10_000_000;

/// What a number is.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Form {
    Value,
    Difference,
    Repeat,
    Missing,
}

/// Decodes the lines of data.
pub fn decode(lines: &[Line]) -> Result<Vec<Row>, Refusal> {
    let is_compressed = lines.iter().any(|line| super::without_remark(line.text).chars().any(is_letter));
    let mut rows: Vec<Row> = Vec::new();
    let mut count = 0;
    // The last value, if the next line repeats it.
    let mut check: Option<f64> = None;
    for line in lines {
        let text = super::without_remark(line.text);
        let mut numbers = Numbers { rest: text, line: line.number, is_compressed };
        let Some((_, place)) = numbers.next()? else { continue };
        let mut row = Row { line: line.number, place, index: count, values: Vec::new() };
        let mut difference: Option<f64> = None;
        while let Some((form, number)) = numbers.next()? {
            let last = row.values.last().copied();
            match (form, last) {
                (Form::Value | Form::Missing, _) => {
                    row.values.push(number);
                    difference = None;
                }
                (Form::Difference, Some(last)) => {
                    row.values.push(last + number);
                    difference = Some(number);
                }
                (Form::Repeat, Some(mut last)) => {
                    let more = number.max(1.0) as usize - 1;
                    if count + row.values.len() + more > MOST {
                        let what =
                            "the repetitions of this line make more than 10 million values; correct it";
                        return Err(Refusal::at(line.number, what));
                    }
                    for _ in 0..more {
                        last += difference.unwrap_or(0.0);
                        row.values.push(last);
                    }
                }
                (Form::Difference | Form::Repeat, None) => {
                    let what =
                        "the first value of this line is a difference or a repetition of nothing; correct it";
                    return Err(Refusal::at(line.number, what));
                }
            }
        }
        let end = row.values.last().copied().filter(|_| difference.is_some());
        if let Some(expected) = check.take()
            && let Some(&found) = row.values.first()
        {
            if found != expected {
                let what = format!(
                    "this line repeats the last value of the line above as {found}, which was {expected}; a line was \
                     changed or lost, so export the file again"
                );
                return Err(Refusal::at(line.number, what));
            }
            row.values.remove(0);
            // The place is that of the value that is repeated.
            row.index -= 1;
        }
        check = end;
        count += row.values.len();
        rows.push(row);
    }
    Ok(rows)
}

/// Returns whether a letter is one of the compressed forms and not the exponent of a plain number.
fn is_letter(c: char) -> bool {
    matches!(c, '@' | '%' | 'A'..='Z' | 'a'..='s') && !matches!(c, 'E' | 'e')
}

/// Splits a line into numbers.
struct Numbers<'a> {
    rest: &'a str,
    line: usize,
    is_compressed: bool,
}

impl Numbers<'_> {
    fn next(&mut self) -> Result<Option<(Form, f64)>, Refusal> {
        self.rest = self.rest.trim_start_matches([' ', '\t', ',', ';']);
        let Some(first) = self.rest.chars().next() else { return Ok(None) };
        let (form, digit) = match first {
            '0'..='9' | '+' | '-' | '.' => (Form::Value, None),
            '@' => (Form::Value, Some(0)),
            'A'..='I' => (Form::Value, Some(first as i32 - 'A' as i32 + 1)),
            'a'..='i' => (Form::Value, Some('a' as i32 - 1 - first as i32)),
            '%' => (Form::Difference, Some(0)),
            'J'..='R' => (Form::Difference, Some(first as i32 - 'J' as i32 + 1)),
            'j'..='r' => (Form::Difference, Some('j' as i32 - 1 - first as i32)),
            'S'..='Z' => (Form::Repeat, Some(first as i32 - 'S' as i32 + 1)),
            's' => (Form::Repeat, Some(9)),
            '?' => {
                self.rest = &self.rest[1..];
                return Ok(Some((Form::Missing, f64::NAN)));
            }
            _ => return Err(self.refusal(&first.to_string())),
        };
        let end = self.end();
        let text = &self.rest[..end];
        let number = match digit {
            None => text.parse::<f64>(),
            Some(digit) => {
                format!("{}{}{}", if digit < 0 { "-" } else { "" }, digit.abs(), &text[1..]).parse()
            }
        };
        let number = number.ok().filter(|number| number.is_finite()).ok_or_else(|| self.refusal(text))?;
        self.rest = &self.rest[end..];
        Ok(Some((form, number)))
    }

    /// Returns where the number ends that the rest begins with.
    fn end(&self) -> usize {
        let bytes = self.rest.as_bytes();
        let mut end = 1;
        while let Some(byte) = bytes.get(end) {
            let signed = matches!(bytes.get(end + 1), Some(b'+' | b'-'));
            let exponent = matches!(byte, b'E' | b'e') && (!self.is_compressed || signed);
            if exponent {
                end += if signed { 2 } else { 1 };
            } else if byte.is_ascii_digit() || *byte == b'.' {
                end += 1;
            } else {
                break;
            }
        }
        end
    }

    fn refusal(&self, text: &str) -> Refusal {
        let what = format!("'{text}' is not a number in any form of JCAMP-DX; export the file again");
        Refusal::at(self.line, what)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::lines::lines;

    fn values(text: &str) -> Vec<f64> {
        let lines: Vec<Line> = lines(text).collect();
        decode(&lines).unwrap().into_iter().flat_map(|row| row.values).collect()
    }

    #[test]
    fn all_forms_say_the_same() {
        let expected = [1.0, 2.0, 3.0, 3.0, 2.0, 1.0, 0.0, -1.0, -2.0, -3.0];
        for text in [
            "100 1 2 3 3 2 1 0 -1 -2 -3",
            "100, 1, 2, 3, 3, 2\n105, 1, 0, -1, -2, -3",
            "100+1+2+3+3+2+1+0-1-2-3",
            "100ABCCBA@abc",
            "100AJJ%jjjjjj",
            "100AJT%jX",
            "100AJJ\n102C%jj\n105AjV",
            "100ABCTBA@abc",
            "100 1.0E+0 2.0E0 3e0 3 2 1 0 -1 -2 -30E-1",
        ] {
            assert_eq!(values(text), expected, "{text}");
        }
        assert_eq!(values("100A23f5?1E5")[..2], [123.0, -65.0]);
        assert!(values("100A?B")[1].is_nan());
        // A letter E is a digit among compressed numbers, and an exponent among plain ones.
        assert_eq!(values("100A5E7"), [15.0, 57.0]);
        assert_eq!(values("100 5E1"), [50.0]);
    }

    #[test]
    fn the_place_of_a_line_that_repeats_a_value_is_that_of_the_value() {
        let lines: Vec<Line> = lines("100AJ\n101BJ").collect();
        let rows = decode(&lines).unwrap();
        assert_eq!((rows[1].index, &rows[1].values[..]), (1, &[3.0][..]));
    }

    #[test]
    fn faults_are_refused_with_their_lines() {
        let line = |text: &str| decode(&lines(text).collect::<Vec<_>>()).unwrap_err().line;
        assert_eq!(line("100AJ\n101CJ"), Some(2));
        assert_eq!(line("100J"), Some(1));
        assert_eq!(line("100S"), Some(1));
        assert_eq!(line("100A\n101*"), Some(2));
        assert_eq!(line("100AZ99999999"), Some(1));
        assert_eq!(line("100 1.2.3"), Some(1));
    }
}
