//! Draws a spectrum with block characters.

use super::tint;
use nanospectra::{Bins, Fine, Light, Power};

const ROWS: usize = 8;
/// The blocks, from empty to full.
pub const BLOCKS: [char; 9] = [' ', '▁', '▂', '▃', '▄', '▅', '▆', '▇', '█'];

/// The columns of the plot, each 6.25 nm wide, over 380..780 nm.
type Columns = Light<64, Bins<380, 780>>;

/// Returns the lines of the plot from top to bottom, without line ends.
///
/// With `truecolor` they are in the colors of the wavelengths.
pub fn lines(curve: &Fine<Power>, truecolor: bool) -> Vec<String> {
    let columns: Columns = curve.resample();
    let top = columns.values().iter().copied().fold(0.0, f32::max);
    let mut lines: Vec<String> = (0..ROWS)
        .map(|row| {
            let below = (ROWS - 1 - row) as f32;
            let cells = columns.iter().map(|(nm, value)| {
                let height = if top > 0.0 { value / top * ROWS as f32 - below } else { 0.0 };
                let block = BLOCKS[(height.clamp(0.0, 1.0) * 8.0).round() as usize];
                if truecolor && block != ' ' { paint(block, tint::of_wavelength(nm)) } else { block.into() }
            });
            let line = cells.collect::<String>();
            if truecolor { format!("{line}\x1b[0m") } else { line.trim_end().to_owned() }
        })
        .collect();
    lines.push(scale());
    lines
}

fn paint(block: char, [r, g, b]: [u8; 3]) -> String {
    format!("\x1b[38;2;{r};{g};{b}m{block}")
}

/// Returns the scale under the columns, with a number every 50 nm.
fn scale() -> String {
    let mut scale = String::new();
    for nm in (400..=750).step_by(50) {
        let column = (nm - 380) as f32 / Columns::WIDTH_NM;
        let start = column.round() as usize - 1;
        scale.push_str(&" ".repeat(start.saturating_sub(scale.len())));
        scale.push_str(&nm.to_string());
    }
    scale + " nm"
}
