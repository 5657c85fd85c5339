//! Turns the bytes of a file into text.

use crate::refusal::Refusal;
use std::borrow::Cow;

/// How the bytes of a text were read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// UTF-8, with or without a byte order mark.
    Utf8,
    /// UTF-16 with the low byte first.
    Utf16Le,
    /// UTF-16 with the high byte first.
    Utf16Be,
    /// Windows-1252, which holds Latin-1. It is taken when a text is not UTF-8.
    Windows1252,
}

/// The signs of Windows-1252 from 0x80 to 0x9f; those that it does not define are replaced.
const WINDOWS_1252: [char; 32] = [
    '€', '\u{fffd}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{fffd}', 'Ž', '\u{fffd}',
    '\u{fffd}', '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{fffd}', 'ž', 'Ÿ',
];

/// What files that are no text begin with, and what to do with them.
const OTHER_KINDS: [(&[u8], &str); 9] = [
    (b"PK\x03\x04", "this is a zipped file, such as .xlsx or .ods; save the sheet with the spectrum as CSV"),
    (
        b"\xd0\xcf\x11\xe0",
        "this is a document of an older Excel (.xls); save the sheet with the spectrum as CSV",
    ),
    (b"%PDF", "this is a PDF; export the spectrum as text"),
    (b"\x89PNG", "this is a picture; export the spectrum as text"),
    (b"\xff\xd8\xff", "this is a picture; export the spectrum as text"),
    (b"\x1f\x8b", "this file is compressed (gzip); unpack it first"),
    (b"BZh", "this file is compressed (bzip2); unpack it first"),
    (b"\x89HDF", "this is an HDF5 or MATLAB file; export the spectrum as text"),
    (b"MATLAB 5.0", "this is a MATLAB file; export the spectrum as text"),
];

/// Returns the text of a file, and how it was encoded.
pub fn decode(bytes: &[u8]) -> Result<(Cow<'_, str>, Encoding), Refusal> {
    if let Some((_, what)) = OTHER_KINDS.iter().find(|(start, _)| bytes.starts_with(start)) {
        return Err(Refusal::of(*what));
    }
    if let Some(rest) = bytes.strip_prefix(&[0xff, 0xfe]) {
        return Ok((utf16(rest, u16::from_le_bytes), Encoding::Utf16Le));
    }
    if let Some(rest) = bytes.strip_prefix(&[0xfe, 0xff]) {
        return Ok((utf16(rest, u16::from_be_bytes), Encoding::Utf16Be));
    }
    if let Some(encoding) = bare_utf16(bytes) {
        let order = if encoding == Encoding::Utf16Le { u16::from_le_bytes } else { u16::from_be_bytes };
        return Ok((utf16(bytes, order), encoding));
    }
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let (text, encoding) = match std::str::from_utf8(bytes) {
        Ok(text) => (Cow::Borrowed(text), Encoding::Utf8),
        Err(_) => (Cow::Owned(bytes.iter().map(|byte| windows_1252(*byte)).collect()), Encoding::Windows1252),
    };
    let control = text.chars().filter(|c| c.is_control() && !c.is_whitespace() && *c != '\0').count();
    if control > 8 && control * 50 > text.len() {
        return Err(Refusal::of("the file is not text; export the spectrum as text"));
    }
    // Some programs fill the end of a line or of the file with zeros.
    if text.contains('\0') {
        return Ok((Cow::Owned(text.replace('\0', " ")), encoding));
    }
    Ok((text, encoding))
}

fn utf16(bytes: &[u8], order: impl Fn([u8; 2]) -> u16) -> Cow<'_, str> {
    let units = bytes.chunks_exact(2).map(|pair| order([pair[0], pair[1]]));
    Cow::Owned(char::decode_utf16(units).map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER)).collect())
}

/// Recognizes UTF-16 without a mark: numbers and English have a zero in every other byte.
fn bare_utf16(bytes: &[u8]) -> Option<Encoding> {
    let start = &bytes[..bytes.len().min(256)];
    let zeros = |odd: usize| start.iter().skip(odd).step_by(2).filter(|byte| **byte == 0).count();
    let (first, second) = (zeros(0), zeros(1));
    let most = start.len() / 2 * 9 / 10;
    match (first, second) {
        _ if start.len() < 8 => None,
        (0, zeros) if zeros >= most => Some(Encoding::Utf16Le),
        (zeros, 0) if zeros >= most => Some(Encoding::Utf16Be),
        _ => None,
    }
}

fn windows_1252(byte: u8) -> char {
    match byte {
        0x80..=0x9f => WINDOWS_1252[usize::from(byte - 0x80)],
        _ => char::from(byte),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn encodings_are_recognized() {
        let le: Vec<u8> = "nm\tµ\r\n380\t1".encode_utf16().flat_map(u16::to_le_bytes).collect();
        let be: Vec<u8> = "nm\tm\r\n380\t1\r\n".encode_utf16().flat_map(u16::to_be_bytes).collect();
        let marked: Vec<u8> = [&[0xff, 0xfe][..], &le].concat();
        assert_eq!(decode(&marked).unwrap(), ("nm\tµ\r\n380\t1".into(), Encoding::Utf16Le));
        assert_eq!(decode(&be).unwrap(), ("nm\tm\r\n380\t1\r\n".into(), Encoding::Utf16Be));
        assert_eq!(decode(b"\xef\xbb\xbf380,1").unwrap(), ("380,1".into(), Encoding::Utf8));
        assert_eq!(decode(b"\xb5W/cm\xb2 \x80").unwrap(), ("µW/cm² €".into(), Encoding::Windows1252));
        assert_eq!(decode(b"380,1\0\0\0").unwrap(), ("380,1   ".into(), Encoding::Utf8));
        assert!(decode(b"PK\x03\x04").is_err());
        assert!(decode(&[1, 2, 3, 0x90, 5, 6, 7, 8, 9, 14, 15]).is_err());
    }
}
