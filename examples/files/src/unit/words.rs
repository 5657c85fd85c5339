//! Brings the many spellings of a unit to one.

/// Returns the text in lower case, with plain letters and digits for signs such as µ and ².
pub fn plain(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    for character in text.trim().chars() {
        match character {
            'µ' | 'μ' => plain.push('u'),
            '²' => plain.push('2'),
            '³' => plain.push('3'),
            '¹' => plain.push('1'),
            '⁻' | '−' | '–' => plain.push('-'),
            '·' | '⋅' | '×' | '*' | '_' | '\u{a0}' | '\t' => plain.push(' '),
            '^' => {}
            'Å' => plain.push_str("angstrom"),
            _ => plain.extend(character.to_lowercase()),
        }
    }
    plain
}

/// Returns what stands in round or square brackets, the outermost only.
pub fn brackets(text: &str) -> impl Iterator<Item = &str> {
    let mut rest = text;
    std::iter::from_fn(move || {
        let start = rest.find(['(', '['])?;
        let (open, close) = if rest[start..].starts_with('(') { ('(', ')') } else { ('[', ']') };
        let mut depth = 0;
        let mut end = rest.len();
        for (at, character) in rest[start..].char_indices() {
            depth += i32::from(character == open) - i32::from(character == close);
            if depth == 0 {
                end = start + at;
                break;
            }
        }
        let inside = &rest[start + 1..end];
        rest = rest.get(end + 1..).unwrap_or("");
        Some(inside)
    })
}

/// Returns the words of a plain text: runs of letters, digits and percent signs.
pub fn of(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_alphanumeric() && c != '%').filter(|word| !word.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn brackets_are_found() {
        assert_eq!(brackets("a (b (c)) [d] (e").collect::<Vec<_>>(), ["b (c)", "d", "e"]);
        assert_eq!(brackets("none").count(), 0);
        assert_eq!(plain("µW·cm⁻²·nm⁻¹"), "uw cm-2 nm-1");
    }
}
