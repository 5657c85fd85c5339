//! Reads spectra from files, from standard input or from the lamp that comes with the program.

use crate::failure::Failure;
use crate::input::{bands, table, text};
use crate::measure::args::{ABSOLUTE, Args};
use crate::measure::level::Kind;
use crate::measure::source::Source;
use nanospectra_files::{Curve, Kind as NoteKind, Note, Options, Refusal, Setting, Unit};
use std::path::Path;
use std::rc::Rc;
use std::sync::Arc;

/// The CIE reference spectrum L41, a measured phosphor-converted white LED, whose header names the source.
const LAMP: &str = include_str!("../../data/l41_white_led.csv");

/// How many of the names and values that a file has beside its spectra are kept.
const MOST_STATED: usize = 200;

/// The spectra of a file, each of which is made when it is its turn.
pub type Sources = Box<dyn ExactSizeIterator<Item = Source>>;

/// Returns the lamp that is measured if no file is given.
pub fn bundled(args: &Args) -> Result<Sources, Failure> {
    strict("l41_white_led.csv", "l41_white_led", LAMP, args)
}

/// Returns all spectra of a file, or of standard input for `-`.
pub fn read(path: &Path, args: &Args) -> Result<Sources, Failure> {
    sources(path, args, &args.options())
}

/// Returns the only spectrum of a file, where `option` is the option that names the file.
pub fn read_one(path: &Path, option: &str, args: &Args, options: &Options) -> Result<Source, Failure> {
    let mut sources = sources(path, args, options)?;
    match (sources.len(), sources.next()) {
        (1, Some(only)) => Ok(only),
        (count, _) => Err(Failure::of(
            path.display(),
            format!(
                "the file has {count} spectra, but {option} takes one; save that one to a file of its own"
            ),
        )),
    }
}

fn sources(path: &Path, args: &Args, options: &Options) -> Result<Sources, Failure> {
    if args.strict {
        let (file, text) = text::read(path)?;
        return strict(&file, &stem(&file), &text, args);
    }
    let (file, bytes) = text::read_bytes(path)?;
    let reading = nanospectra_files::read(&bytes, options).map_err(|refusal| refused(&file, &refusal))?;
    let (name, file): (String, Rc<str>) = (stem(&file), file.into());
    let several = reading.curves.len() > 1;
    let notes: Rc<[String]> = reading.notes.iter().map(said).collect();
    let stated: Rc<[(String, String)]> =
        reading.facts.into_iter().take(MOST_STATED).map(|fact| (fact.name, fact.value)).collect();
    Ok(Box::new(reading.curves.into_iter().enumerate().map(move |(k, curve)| {
        let origin = curve.origin();
        let Curve { wavelengths, values, lines, edges, unit, name: own, .. } = curve;
        Source {
            file: Rc::clone(&file),
            name: own.unwrap_or_else(|| if several { format!("{name}:{}", k + 1) } else { name.clone() }),
            origin: Some(origin),
            kind: Kind::of(unit.unwrap_or(Unit::RELATIVE)),
            notes: Rc::clone(&notes),
            stated: Rc::clone(&stated),
            lines,
            edges,
            samples: wavelengths.into_iter().zip(values).collect(),
        }
    })))
}

/// Reads a table of which nothing is assumed.
fn strict(file: &str, stem: &str, text: &str, args: &Args) -> Result<Sources, Failure> {
    let table = table::parse(file, text)?;
    let (file, stem): (Rc<str>, _) = (file.into(), stem.to_owned());
    let lines: Arc<[usize]> = table.lines.into();
    let several = table.columns.len() > 1;
    let edges = table.are_averages.then(|| bands::edges(&table.wavelengths));
    let kind = match args.unit {
        _ if args.reflectance => Kind::Surface,
        Some(ABSOLUTE) => Kind::of(ABSOLUTE),
        _ => Kind::of(Unit::RELATIVE),
    };
    Ok(Box::new(table.columns.into_iter().enumerate().map(move |(k, column)| Source {
        file: Rc::clone(&file),
        name: column.name.unwrap_or_else(|| if several { format!("{stem}:{}", k + 1) } else { stem.clone() }),
        origin: None,
        kind,
        notes: Rc::new([]),
        stated: Rc::new([]),
        lines: Arc::clone(&lines),
        edges: edges.clone(),
        samples: table.wavelengths.iter().copied().zip(column.values).collect(),
    })))
}

fn stem(file: &str) -> String {
    text::stem(Path::new(file)).unwrap_or_else(|| file.to_owned())
}

/// Returns the failure of a file that is not read, with the option that helps.
fn refused(file: &str, refusal: &Refusal) -> Failure {
    let help = refusal.setting.map_or(String::new(), |setting| format!("; {}", advice(setting)));
    let what = format!("{}{help}", refusal.what);
    match refusal.line {
        Some(line) => Failure::at(file, line, what),
        None => Failure::of(file, what),
    }
}

fn advice(setting: Setting) -> &'static str {
    match setting {
        Setting::Column => "give --column NAME or --column NUMBER for what to measure, where 1 is the axis",
        Setting::Unit => {
            "give --unit, such as relative, absolute (W/m2/nm), mW/m2/nm, umol/m2/s/nm or counts"
        }
        Setting::Absorbance => "give --unit absorbance to take 10^-A as the share of the light",
        Setting::Density => {
            "give --unit relative for numbers per nm, or --unit such as W/m2/nm or W/m2/THz; --wavelength-unit says \
             what the axis is"
        }
        Setting::AxisUnit => "give --wavelength-unit, such as nm, um, angstrom, cm-1, THz or eV",
        Setting::Percent => "give --percent, or --unit reflectance if they are shares of 0..1",
        Setting::Missing => "give --missing with this number to leave its rows out",
    }
}

/// Returns a note of the reader as a note of the report.
fn said(note: &Note) -> String {
    let option = match note.setting {
        Some(Setting::Column) => " (--column)",
        Some(Setting::Unit | Setting::Absorbance | Setting::Density) => " (--unit)",
        Some(Setting::AxisUnit) => " (--wavelength-unit)",
        Some(Setting::Percent) => " (--percent)",
        Some(Setting::Missing) => " (--missing)",
        None => "",
    };
    let kind = match note.kind {
        NoteKind::Stated => "stated",
        NoteKind::Assumed => "assumed",
        NoteKind::LeftOut => "left out",
    };
    format!("{kind}: {}{option}", note.what)
}
