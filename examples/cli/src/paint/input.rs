//! Reads colors from text. Whatever is not plainly a color is an error that says where it stands.

use crate::failure::{Failure, short};
use crate::input::text;
use std::path::Path;

/// A color as it was given: three numbers and where they come from.
#[derive(Clone, Debug)]
pub struct Color {
    /// Where it was read, for messages: `stdin:3`, or how the word on the command line begins.
    pub place: String,
    /// The name of the sample, if it is one of CES99.
    pub sample: Option<String>,
    pub numbers: [f32; 3],
    /// Whether it was a code such as #cc331a, which is encoded also with `--linear`.
    pub is_code: bool,
}

/// What messages say that one should write.
const SO: &str = "write 0.8,0.2,0.1 or #cc331a";

/// Reads every color of these words, in order. `-` stands for the colors of standard input.
pub fn colors(words: &[String]) -> Result<Vec<Color>, Failure> {
    let mut colors = Vec::new();
    for word in words {
        if word == "-" {
            stdin(&mut colors)?;
        } else {
            let place = format!("color {}", short(word));
            colors.push(color(word, place.clone()).map_err(|what| Failure::of(place, what))?);
        }
    }
    Ok(colors)
}

/// Adds the colors of standard input.
fn stdin(colors: &mut Vec<Color>) -> Result<(), Failure> {
    let (file, text) = text::read(Path::new("-"))?;
    let before = colors.len();
    for (line, number) in text.lines().zip(1..) {
        let at = |what: String| Failure::at(&file, number, what);
        // If lines ended with it, one comment would hide all the lines that follow.
        if line.contains('\r') {
            return Err(at(
                "there is a carriage return inside the line; save the file with LF or CRLF line ends".into(),
            ));
        }
        let line = without_comment(line);
        if !line.is_empty() {
            colors.push(color(line, format!("{file}:{number}")).map_err(at)?);
        }
    }
    if colors.len() == before {
        return Err(Failure::at(
            &file,
            1,
            format_args!("there is no color in it; give one on each line, and {SO}"),
        ));
    }
    Ok(())
}

/// Removes a comment. It begins with a '#' that has nothing but blanks on either side, so #cc331a is none.
fn without_comment(line: &str) -> &str {
    let blank = |c: Option<char>| c.is_none_or(char::is_whitespace);
    let start = line
        .match_indices('#')
        .map(|(at, _)| at)
        .find(|at| blank(line[..*at].chars().next_back()) && blank(line[at + 1..].chars().next()));
    line[..start.unwrap_or(line.len())].trim()
}

fn color(text: &str, place: String) -> Result<Color, String> {
    let text = text.trim();
    let (numbers, is_code) = match text.strip_prefix('#') {
        Some(digits) => {
            let what = || format!("'{}' is not a code of 6 or 3 hexadecimal digits; {SO}", short(text));
            (code(digits).ok_or_else(what)?, true)
        }
        None => (numbers(text)?, false),
    };
    Ok(Color { place, sample: None, numbers, is_code })
}

/// The numbers of a code without its '#': `cc331a`, or `c31`, which stands for `cc3311`.
fn code(digits: &str) -> Option<[f32; 3]> {
    if !digits.chars().all(|c| c.is_ascii_hexdigit()) {
        return None;
    }
    let value = u32::from_str_radix(digits, 16).ok()?;
    let [_, r, g, b] = match digits.len() {
        6 => value.to_be_bytes(),
        3 => [0, (value >> 8) as u8 * 17, (value >> 4 & 15) as u8 * 17, (value & 15) as u8 * 17],
        _ => return None,
    };
    Some([r, g, b].map(|code| f32::from(code) / 255.0))
}

/// Reads three numbers between commas, semicolons or blanks. If there are semicolons they are the separators,
/// since a comma may then be a decimal point, which is refused.
fn numbers(text: &str) -> Result<[f32; 3], String> {
    let mark = [';', ','].into_iter().find(|mark| text.contains(*mark));
    let cells: Vec<&str> = match mark {
        Some(mark) => text.split(mark).map(str::trim).collect(),
        None => text.split_whitespace().collect(),
    };
    let [r, g, b] = cells[..] else {
        return Err(match cells.len() {
            1 => format!("'{}' is not three numbers; {SO}", short(text)),
            0 => format!("the color is empty; {SO}"),
            count => format!("there are {count} cells, and a color has 3; {SO}"),
        });
    };
    Ok([number(r)?, number(g)?, number(b)?])
}

fn number(cell: &str) -> Result<f32, String> {
    let said = short(cell);
    match cell.parse::<f32>() {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(_) => Err(format!("{said} is not a finite number; {SO}")),
        Err(_) if cell.is_empty() => Err(format!("a cell is empty; {SO}")),
        Err(_) if cell.replacen(',', ".", 1).parse::<f32>().is_ok() => {
            Err(format!("'{said}' is not a number; write the decimal point as '.'"))
        }
        Err(_) => Err(format!("'{said}' is not a number; {SO}")),
    }
}
