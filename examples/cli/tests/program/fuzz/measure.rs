//! Generates command lines of the command `measure`, with files as instruments write them.

use crate::fuzz::dice::Dice;
use crate::fuzz::input::{LIGHTS, Run, table, wavelengths};

const UNITS: [&str; 12] = [
    "absolute",
    "relative",
    "mW/m2/nm",
    "uW/cm2/nm",
    "umol/m2/s/nm",
    "W/m2/sr/nm",
    "W/nm",
    "mW/sr/nm",
    "counts",
    "absorbance",
    "W/m2/THz",
    "furlong",
];

pub fn measure(dice: &mut Dice, run: &mut Run) {
    for k in 0..dice.below(3) {
        let text = file(dice);
        run.file(&format!("a{k}.csv"), text);
        run.give(&[&format!("a{k}.csv")]);
    }
    if dice.once_in(3) {
        run.stdin = file(dice);
        run.give(&["-"]);
    }
    if dice.once_in(2) {
        run.give(&["--reflectance"]);
        if dice.once_in(2) {
            run.give(&["--light", dice.of(&LIGHTS)]);
        } else if dice.once_in(2) {
            run.file("light.csv", table(dice, 1));
            run.give(&["--light", "light.csv"]);
        }
    } else if dice.once_in(2) {
        run.give(&["--unit", dice.of(&UNITS)]);
    }
    if dice.once_in(3) {
        let observer = nanospectra::observer::ALL[dice.below(nanospectra::observer::ALL.len())].name;
        run.give(&["--observer", observer]);
    }
    if dice.once_in(3) {
        run.give(&["--interpolation", dice.of(&["auto", "linear", "sprague"])]);
    }
    if dice.once_in(4) {
        run.file("b.csv", table(dice, 1));
        run.give(&["--compare", "b.csv"]);
    }
    options(dice, run);
    run.report(dice);
}

/// Gives options that say what a file does not.
fn options(dice: &mut Dice, run: &mut Run) {
    for (option, values) in [
        ("--column", &["2", "3", "s0", "s1", "99", ""][..]),
        ("--wavelength-unit", &["nm", "um", "angstrom", "THz", "eV", "cm-1"]),
        ("--lux", &["500", "1e-300", "1e300"]),
        ("--ppfd", &["100", "1e-45", "3.4e38"]),
        ("--missing", &["-999", "0", "1e31"]),
    ] {
        if dice.once_in(20) {
            run.give(&[option, dice.of(values)]);
        }
    }
    for option in ["--percent", "--strict", "--fail-fast", "--csv"] {
        if dice.once_in(20) {
            run.give(&[option]);
        }
    }
}

/// Returns a file: a plain table, or one with a heading of units, a preamble, a footer and a separator of its own.
fn file(dice: &mut Dice) -> String {
    if dice.once_in(2) {
        let columns = 1 + dice.below(3);
        return table(dice, columns);
    }
    let columns = 1 + dice.below(3);
    let mark = dice.of(&[",", ";", "\t", " "]);
    let mood = dice.mood();
    let comma = mark != "," && dice.once_in(3);
    let axis = dice.of(&["nm", "wavelength", "Wavelength (nm)", "um", "THz", "Pixel"]);
    let unit = dice.of(&[
        "",
        " (mW/m2/nm)",
        " [counts]",
        " (%)",
        " (W/m2)",
        " (umol/m2/s)",
        " Absorbance",
        " (W/m2/sr/nm)",
    ]);
    let mut text = String::new();
    if dice.once_in(2) {
        text += &format!("Model{mark}X-1\nCCT(K){mark}3000\n\n");
    }
    let names: Vec<String> = (0..columns).map(|k| format!("s{k}{unit}")).collect();
    let mut rows: Vec<Vec<String>> = vec![[vec![axis.to_owned()], names].concat()];
    let has_gaps = dice.once_in(4);
    for nm in wavelengths(dice) {
        let mut row = vec![if axis == "um" { nm.replace('.', "") } else { nm }];
        for _ in 0..columns {
            let gap = has_gaps && dice.once_in(60);
            row.push(if gap { dice.of(&["", "NaN", "-999", "x"]).to_owned() } else { dice.number(mood) });
        }
        rows.push(row);
    }
    if dice.once_in(4) {
        rows[1..].reverse();
    }
    // One spectrum a row.
    if dice.once_in(6) {
        rows = (0..=columns).map(|k| rows.iter().map(|row| row[k].clone()).collect()).collect();
    }
    for row in rows {
        let row = row.join(mark);
        text += &(if comma { row.replace('.', ",") } else { row });
        text.push('\n');
    }
    if dice.once_in(4) {
        text += ">>>>>End<<<<<\n";
    }
    text
}
