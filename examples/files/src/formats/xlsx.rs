//! Reads the sheets of `.xlsx` workbooks: each becomes a text that is read as any other table.

use super::{Contents, LARGEST, too_large};
use crate::refusal::{Note, Refusal};
use crate::table;
use calamine::{DataRef, Reader, Xlsx};
use std::fmt::Write as _;
use std::io::{Cursor, Read as _};

/// Reads the tables of all sheets, and returns `None` if the bytes are no such workbook.
pub fn read(bytes: &[u8]) -> Option<Result<Contents, Refusal>> {
    if !bytes.starts_with(b"PK\x03\x04") {
        return None;
    }
    let mut archive = match zip::ZipArchive::new(Cursor::new(bytes)) {
        Ok(archive) => archive,
        Err(error) => return Some(Err(broken(&error))),
    };
    if !archive.file_names().any(|name| name.is_ok_and(|name| name.starts_with("xl/"))) {
        return None;
    }
    Some(check_size(&mut archive).and_then(|()| sheets(bytes)))
}

fn broken(error: &dyn std::fmt::Display) -> Refusal {
    Refusal::of(format!("the workbook is broken ({error}); save it again, or save the sheet as CSV"))
}

/// Refuses an archive that unpacks to more than fits, whatever it says of its sizes.
fn check_size(archive: &mut zip::ZipArchive<Cursor<&[u8]>>) -> Result<(), Refusal> {
    let mut left = LARGEST as u64;
    for place in 0..archive.len() {
        let file = archive.by_index(place).map_err(|error| broken(&error))?;
        let mut file = file.take(left + 1);
        let size = std::io::copy(&mut file, &mut std::io::sink()).map_err(|error| broken(&error))?;
        left = left.checked_sub(size).ok_or_else(too_large)?;
    }
    Ok(())
}

fn sheets(bytes: &[u8]) -> Result<Contents, Refusal> {
    let mut book: Xlsx<_> = Xlsx::new(Cursor::new(bytes)).map_err(|error| broken(&error))?;
    let mut contents = Contents::default();
    let mut refusals = Vec::new();
    let names = book.sheet_names();
    let several = names.len() > 1;
    for name in names {
        let tables = text(&mut book, &name).and_then(|text| table::read(&text));
        match tables {
            Ok(tables) => {
                if several {
                    let what = format!("the sheet '{name}' has {} of the tables", tables.grids.len());
                    contents.notes.push(Note::stated(what));
                }
                contents.grids.extend(tables.grids);
                contents.facts.extend(tables.facts);
            }
            Err(refusal) => refusals.push((name, refusal)),
        }
    }
    if contents.grids.is_empty() {
        return Err(match refusals.into_iter().next() {
            Some((name, refusal)) => {
                Refusal { what: format!("{}, in the sheet '{name}'", refusal.what), ..refusal }
            }
            None => Refusal::of("the workbook has no sheet; save the sheet with the spectrum as CSV"),
        });
    }
    for (name, refusal) in refusals {
        contents.notes.push(Note::left_out(format!("the sheet '{name}': {refusal}")));
    }
    Ok(contents)
}

/// Writes a sheet as lines with tabs, in which numbers have all of their digits and rows keep their numbers.
fn text(book: &mut Xlsx<Cursor<&[u8]>>, name: &str) -> Result<String, Refusal> {
    let mut cells = book.worksheet_cells_reader(name).map_err(|error| broken(&error))?;
    let mut text = String::new();
    let (mut row, mut column) = (0, 0);
    while let Some(cell) = cells.next_cell().map_err(|error| broken(&error))? {
        let (to_row, to_column) = cell.get_position();
        if matches!(cell.get_value(), DataRef::Empty) || to_row < row {
            continue;
        }
        if to_row > row {
            text.extend(std::iter::repeat_n('\n', (to_row - row) as usize));
            (row, column) = (to_row, 0);
        }
        text.extend(std::iter::repeat_n('\t', to_column.saturating_sub(column) as usize));
        column = column.max(to_column);
        value(cell.get_value(), &mut text);
        if text.len() > LARGEST {
            return Err(too_large());
        }
    }
    Ok(text)
}

/// Writes a cell. What would separate cells or lines becomes a blank.
fn value(value: &DataRef, text: &mut String) {
    let mut words = |words: &str| {
        text.extend(words.chars().map(|c| match c {
            '\t' | '\n' | '\r' => ' ',
            '"' => '\'',
            other => other,
        }));
    };
    match value {
        DataRef::Int(number) => words(&number.to_string()),
        DataRef::Float(number) => {
            let _ = write!(text, "{number:?}");
        }
        DataRef::DateTime(time) => words(&time.as_f64().to_string()),
        DataRef::String(other) | DataRef::DateTimeIso(other) | DataRef::DurationIso(other) => words(other),
        DataRef::SharedString(other) => words(other),
        DataRef::Bool(other) => words(if *other { "yes" } else { "no" }),
        DataRef::Error(other) => words(&other.to_string()),
        DataRef::Empty => {}
    }
}

#[cfg(test)]
mod tests {
    use crate::{Kind, Options, read};
    use std::io::{Cursor, Write as _};
    use zip::write::{SimpleFileOptions, ZipWriter};

    /// A workbook of sheets whose rows are given as XML.
    fn workbook(sheets: &[(&str, &str)]) -> Vec<u8> {
        let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
        let mut file = |name: &str, text: &str| {
            zip.start_file(name, SimpleFileOptions::default()).unwrap();
            zip.write_all(text.as_bytes()).unwrap();
        };
        let of = |make: &dyn Fn(usize, &str) -> String| -> String {
            sheets.iter().enumerate().map(|(place, sheet)| make(place + 1, sheet.0)).collect()
        };
        let office = "http://schemas.openxmlformats.org";
        let main = format!("xmlns=\"{office}/spreadsheetml/2006/main\"");
        let relations = format!("{office}/officeDocument/2006/relationships");
        let packages = format!("xmlns=\"{office}/package/2006/relationships\"");
        let list = of(&|id, name| format!("<sheet name=\"{name}\" sheetId=\"{id}\" r:id=\"r{id}\"/>"));
        file(
            "xl/workbook.xml",
            &format!("<workbook {main} xmlns:r=\"{relations}\"><sheets>{list}</sheets></workbook>"),
        );
        file(
            "_rels/.rels",
            &format!(
                "<Relationships {packages}><Relationship Id=\"r1\" Type=\"{relations}/officeDocument\" \
                 Target=\"xl/workbook.xml\"/></Relationships>"
            ),
        );
        let list = of(&|id, _| {
            format!(
                "<Relationship Id=\"r{id}\" Type=\"{relations}/worksheet\" Target=\"worksheets/sheet{id}.xml\"/>"
            )
        });
        file("xl/_rels/workbook.xml.rels", &format!("<Relationships {packages}>{list}</Relationships>"));
        for (place, (_, rows)) in sheets.iter().enumerate() {
            file(
                &format!("xl/worksheets/sheet{}.xml", place + 1),
                &format!("<worksheet {main}><sheetData>{rows}</sheetData></worksheet>"),
            );
        }
        zip.finish().unwrap().into_inner()
    }

    const ROWS: &str = "<row r=\"2\"><c r=\"B2\" t=\"inlineStr\"><is><t>nm</t></is></c><c r=\"C2\" \
                        t=\"inlineStr\"><is><t>mW/m2/nm</t></is></c></row><row r=\"3\"><c r=\"B3\"><v>380</v></c><c \
                        r=\"C3\"><v>0.1234567890123456</v></c></row><row r=\"5\"><c r=\"B5\"><v>385</v></c><c \
                        r=\"C5\"><v>2E-7</v></c></row><row r=\"6\"><c r=\"B6\"><v>390</v></c><c r=\"C6\"><v>3</v></c></row>";

    #[test]
    fn sheets_become_tables() {
        let words = "<row r=\"1\"><c r=\"A1\" t=\"inlineStr\"><is><t>About</t></is></c></row>";
        let reading = read(&workbook(&[("Notes", words), ("Data", ROWS)]), &Options::default()).unwrap();
        let curve = &reading.curves[0];
        assert_eq!(curve.wavelengths, [380.0, 385.0, 390.0]);
        assert_eq!(curve.values[0], 0.1234567890123456 * 1e-3);
        assert_eq!(curve.line_range(), 3..=6);
        assert!(reading.notes.iter().any(|note| note.kind == Kind::Stated && note.what.contains("'Data'")));
        assert!(reading.notes.iter().any(|note| note.kind == Kind::LeftOut && note.what.contains("'Notes'")));
    }

    #[test]
    fn broken_and_huge_workbooks_are_refused() {
        let whole = workbook(&[("Data", ROWS)]);
        for end in 0..whole.len() {
            assert!(read(&whole[..end], &Options::default()).is_err());
        }
        let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
        zip.start_file("xl/workbook.xml", SimpleFileOptions::default()).unwrap();
        for _ in 0..201 {
            zip.write_all(&vec![b' '; 1_000_000]).unwrap();
        }
        let huge = zip.finish().unwrap().into_inner();
        assert!(read(&huge, &Options::default()).unwrap_err().what.contains("200 MB"));
        let empty = workbook(&[("Data", "")]);
        assert!(read(&empty, &Options::default()).unwrap_err().what.contains("'Data'"));
    }
}
