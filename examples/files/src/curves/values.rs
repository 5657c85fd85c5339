//! Brings the values of a column to the unit of their quantity and to increasing wavelengths.

use super::axis::Axis;
use crate::grid::{Column, Grid, Said, quoted};
use crate::options::Options;
use crate::reading::{By, Curve, Part};
use crate::refusal::{Note, Refusal, Setting};
use crate::unit::{AxisUnit, Quantity, Unit, brackets};
use std::sync::Arc;

/// Numbers that programs write where nothing was measured.
const FILLS: [f64; 7] = [-999.0, -9999.0, -99_999.0, -1.23e34, 1e31, 9.969_209_968_386_87e36, 1e30];

/// What all curves of a grid share.
pub struct Context<'a> {
    /// The lines of the rows.
    pub lines: Arc<[usize]>,
    /// The last place of a column.
    pub last: usize,
    /// The words that the cells of the axis have, which hold for all columns.
    pub labels: Option<&'a Said>,
}

/// Returns the curve of a column, which has at least one value.
pub fn curve(
    grid: &Grid,
    axis: &Axis,
    place: usize,
    context: &Context,
    options: &Options,
    notes: &mut Vec<Note>,
) -> Result<Curve, Refusal> {
    let title = &grid.columns[place].title();
    let column = &grid.columns[place];
    let (unit, unit_by) = unit(column, grid, context, title, options)?;
    if unit.is_none() && !grid.is_known {
        unknown_unit(column, notes);
    }
    let places = &grid.columns[axis.column].values;
    let mut samples: Vec<(f64, f64)> = Vec::with_capacity(places.len());
    let mut kept: Vec<usize> = Vec::with_capacity(places.len());
    let (mut missing, mut dark) = (0, 0);
    for (row, (&at, &value)) in places.iter().zip(&column.values).enumerate() {
        let line = line_of(column, grid, row);
        if at.is_nan() && value.is_nan() {
            continue;
        }
        if value.is_nan() || options.missing == Some(value) {
            missing += 1;
            continue;
        }
        if FILLS.contains(&value) {
            let rows = column.values.iter().filter(|other| **other == value).count();
            let what =
                format!("{title} is {value} in {rows} rows, which programs write where nothing was measured");
            return Err(Refusal::at(line, what).settled_by(Setting::Missing));
        }
        if at.is_nan() {
            return Err(Refusal::at(line, "the wavelength is missing; complete the row"));
        }
        let nm = axis.unit.nm(at);
        if at <= 0.0 || !nm.is_finite() {
            dark += 1;
            continue;
        }
        samples.push((nm, value));
        kept.push(line);
    }
    if missing > 0 {
        let gaps = format!("{title} has no value in {missing} of {} rows", places.len());
        notes.push(Note::left_out(gaps));
    }
    if dark > 0 {
        notes.push(Note::left_out(format!("{dark} rows at or below 0 {}", axis.unit.sign())));
    }
    order(&mut samples, &mut kept, title)?;
    // Numbers that the user calls relative are as they are.
    let is_settled = unit_by == By::User && unit.is_some_and(|unit| unit.quantity == Quantity::Relative);
    if !is_settled {
        check_density(&samples, axis, unit, title, notes)?;
    }
    let convert = |(nm, value): &(f64, f64)| unit.map_or(*value, |unit| unit.convert(*value, *nm));
    // Most curves of a table have all of its lines.
    let lines = if kept[..] == context.lines[..] { Arc::clone(&context.lines) } else { kept.into() };
    let edges = edges(grid, axis, &samples, missing + dark, title, notes)?;
    Ok(Curve {
        name: column.name.clone().filter(|name| !is_unit(name)),
        values: samples.iter().map(convert).collect(),
        wavelengths: samples.into_iter().map(|(nm, _)| nm).collect(),
        lines,
        unit,
        unit_by,
        edges,
        axis: axis.unit,
        place: (column.place, context.last),
        part: match column.line {
            _ if grid.is_known => Part::Spectrum,
            Some(_) => Part::Row,
            None => Part::Column,
        },
    })
}

/// The heading of wavelengths around which the values are averages over bands whose edges lie half way between.
const BANDS: &str = "band-nm";

/// Returns the edges of bands, in increasing order, if the values are averages over such.
fn edges(
    grid: &Grid,
    axis: &Axis,
    samples: &[(f64, f64)],
    left_out: usize,
    title: &str,
    notes: &mut Vec<Note>,
) -> Result<Option<Vec<f64>>, Refusal> {
    let name = grid.columns[axis.column].name.as_deref().unwrap_or("");
    if name.eq_ignore_ascii_case(BANDS) {
        notes
            .push(Note::stated(format!("{title} has averages over bands, whose edges lie half way between")));
        return Ok(Some(half_way(samples)));
    }
    let Some(edges) = &grid.edges else { return Ok(None) };
    if left_out > 0 {
        return Err(Refusal::of(format!(
            "{title} has bands without a value; complete them or take their rows out"
        )));
    }
    let mut edges: Vec<f64> = edges.iter().map(|edge| axis.unit.nm(*edge)).collect();
    if edges[0] > edges[edges.len() - 1] {
        edges.reverse();
    }
    Ok(Some(edges))
}

/// Returns edges half way between samples, where the first and the last band reach as far to the outside as to the
/// inside.
fn half_way(samples: &[(f64, f64)]) -> Vec<f64> {
    let mut edges: Vec<f64> = samples.windows(2).map(|pair| f64::midpoint(pair[0].0, pair[1].0)).collect();
    let last = samples.len() - 1;
    let (low, high) = (2.0 * samples[0].0 - edges[0], 2.0 * samples[last].0 - edges[last - 1]);
    edges.insert(0, low);
    edges.push(high);
    edges
}

/// Returns the line of a row. A spectrum that has lines of its own is spread over them evenly.
fn line_of(column: &Column, grid: &Grid, row: usize) -> usize {
    match (&column.lines, column.line) {
        (Some(lines), _) => {
            let last = column.values.len().saturating_sub(1).max(1);
            lines.start() + (lines.end() - lines.start()) * row / last
        }
        (None, Some(line)) => line,
        (None, None) => grid.lines.get(row).copied().unwrap_or(0),
    }
}

/// Brings the samples and their lines to increasing wavelengths.
fn order(samples: &mut [(f64, f64)], lines: &mut [usize], title: &str) -> Result<(), Refusal> {
    if samples.len() < 2 {
        let what = format!("{title} has too few samples ({}); a spectrum has two or more", samples.len());
        return Err(Refusal { line: lines.first().copied(), ..Refusal::of(what) });
    }
    if samples[0].0 > samples[samples.len() - 1].0 {
        samples.reverse();
        lines.reverse();
    }
    let Some(row) = (1..samples.len()).find(|row| samples[*row].0 <= samples[row - 1].0) else {
        return Ok(());
    };
    let (before, after) = (samples[row - 1].0, samples[row].0);
    let what = if before == after {
        format!("{title} has {before} nm twice; keep one of the two rows")
    } else {
        format!("{after} nm of {title} comes after {before} nm; sort the rows by wavelength")
    };
    Err(Refusal::at(lines[row].max(lines[row - 1]), what))
}

/// Returns what the values are and who says so: the user, or the file.
fn unit(
    column: &Column,
    grid: &Grid,
    context: &Context,
    title: &str,
    options: &Options,
) -> Result<(Option<Unit>, By), Refusal> {
    let said = stated(column, grid, context);
    if options.unit.is_none() && (options.percent || options.is_ratio) {
        return share(said, title, options.percent);
    }
    match (options.unit, said) {
        (None, Some((unit, _))) if unit.quantity == Quantity::Absorbance => {
            let what = format!("{title} is an absorbance A, which is neither a light nor a share of one");
            Err(Refusal::of(what).settled_by(Setting::Absorbance))
        }
        // Whatever the file says stays the shape of a relative spectrum.
        (Some(wanted), Some((said, _))) if wanted.quantity == Quantity::Relative => {
            Ok((Some(Unit { quantity: Quantity::Relative, ..said }), By::User))
        }
        (Some(wanted), Some((said, text))) if !wanted.agrees_with(&said) => {
            let what = format!(
                "the file says {} of {title}, which is {}, and the option says {}",
                quoted(text),
                said.written(),
                wanted.written()
            );
            Err(Refusal::of(what).settled_by(Setting::Unit))
        }
        (Some(wanted), _) => Ok((Some(wanted), By::User)),
        (None, Some((said, text))) => Ok((Some(said), By::File(text.to_owned()))),
        (None, None) => Ok((None, By::Nobody)),
    }
}

/// Returns the unit of values of which the user says that they are shares of light.
fn share(said: Option<(Unit, &str)>, title: &str, percent: bool) -> Result<(Option<Unit>, By), Refusal> {
    let factor = if percent { 0.01 } else { 1.0 };
    match said {
        None => Ok((Some(Unit::of(Quantity::Reflectance, factor)), By::User)),
        Some((said, text)) if !said.is_ratio() || said.quantity == Quantity::Absorbance => {
            let what =
                format!("the file says {} of {title}, which is no share of light from 0 to 1", quoted(text));
            Err(Refusal::of(what).settled_by(Setting::Unit))
        }
        Some((said, _)) if percent => Ok((Some(Unit::of(said.quantity, factor)), By::User)),
        Some((said, text)) => Ok((Some(said), By::File(text.to_owned()))),
    }
}

/// Returns what the file says of a column, with its words.
fn stated<'a>(column: &'a Column, grid: &'a Grid, context: &Context<'a>) -> Option<(Unit, &'a str)> {
    let texts = [
        column.unit.as_ref().map(|said| said.text.as_str()),
        // A name such as `D50, 300% U.V.` is no heading.
        column.name.as_deref().filter(|_| !grid.is_known),
        context.labels.map(|said| said.text.as_str()),
        grid.unit.as_ref().map(|said| said.text.as_str()),
    ];
    texts.into_iter().flatten().find_map(|text| Some((Unit::in_heading(text)?, text)))
}

/// Returns whether a heading is the unit of the values and names nothing.
fn is_unit(name: &str) -> bool {
    name.starts_with(['[', '(']) && Unit::parse(name.trim_matches(['[', ']', '(', ')', ' '])).is_some()
}

/// Says that a heading has something in brackets, or with a fraction, that no unit here is.
fn unknown_unit(column: &Column, notes: &mut Vec<Note>) {
    let texts = column.unit.iter().map(|said| said.text.as_str()).chain(column.name.as_deref());
    let in_brackets = texts.clone().flat_map(brackets);
    let fraction = texts.filter(|text| text.contains('/') && !text.contains(['(', '[']));
    let unknown = in_brackets.chain(fraction).map(str::trim).find(|text| text.contains(char::is_alphabetic));
    if let Some(unknown) = unknown {
        let what = format!(
            "{} of the heading is no unit that is known here, so the values are relative",
            quoted(unknown)
        );
        notes.push(Note { setting: Some(Setting::Unit), ..Note::left_out(what) });
    }
}

/// Refuses a density per frequency of which that is not said, and says what is assumed of a power without one.
fn check_density(
    samples: &[(f64, f64)],
    axis: &Axis,
    unit: Option<Unit>,
    title: &str,
    notes: &mut Vec<Note>,
) -> Result<(), Refusal> {
    if unit.is_some_and(|unit| unit.is_ratio()) || unit.is_some_and(|unit| unit.per.is_some()) {
        return Ok(());
    }
    if !axis.unit.is_wavelength() {
        let what = format!(
            "the axis is in {}, and whether {title} is per nm or per {} is not said",
            axis.unit.sign(),
            axis.unit.sign()
        );
        return Err(Refusal::of(what).settled_by(Setting::Density));
    }
    let Some(unit) = unit.filter(|unit| !matches!(unit.quantity, Quantity::Relative | Quantity::Counts))
    else {
        return Ok(());
    };
    let is_one = samples.windows(2).all(|pair| (pair[1].0 - pair[0].0 - 1.0).abs() < 0.01);
    if is_one || axis.unit != AxisUnit::Nanometer {
        notes.push(Note::assumed(format!("{title} is per nm, as {}", unit.sign()), Some(Setting::Unit)));
        return Ok(());
    }
    let what = format!("{title} is a power, and whether it is per nm or that of each row is not said");
    Err(Refusal::of(what).settled_by(Setting::Unit))
}
