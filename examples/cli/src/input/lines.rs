//! Splits a CSV text into lines and cells.

/// Returns the lines that are neither empty nor comments, with their numbers counted from 1.
pub fn rows(text: &str) -> impl Iterator<Item = (&str, usize)> + Clone {
    text.lines().zip(1..).filter(|(line, _)| is_row(line))
}

/// Returns whether a line is neither empty nor a comment.
pub fn is_row(line: &str) -> bool {
    let line = line.trim_start();
    !line.is_empty() && !line.starts_with('#')
}

/// Checks that a line has no stray carriage return, and that its quotes are closed.
///
/// Quotes must be closed on the line where they were opened, because an open one would swallow the rest of
/// the file.
pub fn check(line: &str) -> Result<(), String> {
    if line.contains('\r') {
        return Err(
            "there is a carriage return inside the line; save the file with LF or CRLF line ends".into()
        );
    }
    if !line.matches('"').count().is_multiple_of(2) {
        return Err("a quote is opened but not closed; close it on the same line".into());
    }
    Ok(())
}

/// Returns the cells of a line by the rules of CSV, without blanks around them.
pub fn cells(line: &str, delimiter: char) -> Result<Vec<String>, String> {
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .delimiter(delimiter as u8)
        .trim(csv::Trim::All)
        .from_reader(line.as_bytes());
    let mut record = csv::StringRecord::new();
    reader.read_record(&mut record).map_err(|error| format!("{error}; correct the quotes"))?;
    Ok(record.iter().map(str::to_owned).collect())
}
