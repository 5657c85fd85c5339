//! Brings the values of a column to the unit of their quantity and to increasing wavelengths.

use super::axis::Axis;
use crate::grid::{Column, Grid};
use crate::options::Options;
use crate::reading::Curve;
use crate::refusal::{Note, Refusal, Setting};
use crate::unit::{AxisUnit, Quantity, Unit};

/// Numbers that programs write where nothing was measured.
const FILLS: [f64; 7] = [-999.0, -9999.0, -99_999.0, -1.23e34, 1e31, 9.969_209_968_386_87e36, 1e30];

/// Returns the curve of a column, which has at least one value.
pub fn curve(
    grid: &Grid,
    axis: &Axis,
    place: usize,
    title: &str,
    options: &Options,
    notes: &mut Vec<Note>,
) -> Result<Curve, Refusal> {
    let column = &grid.columns[place];
    let unit = unit(column, grid, title, options, notes)?;
    let places = &grid.columns[axis.column].values;
    let mut samples: Vec<(f64, f64)> = Vec::with_capacity(places.len());
    let (mut missing, mut dark) = (0, 0);
    for ((&at, &value), &line) in places.iter().zip(&column.values).zip(&grid.lines) {
        if at.is_nan() && value.is_nan() {
            continue;
        }
        if value.is_nan() || options.missing == Some(value) {
            missing += 1;
            continue;
        }
        if FILLS.contains(&value) {
            let what = format!("{title} is {value}, which programs write where nothing was measured");
            let line = column.lines.as_ref().map_or(line, |lines| *lines.start());
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
    }
    if missing > 0 {
        let gaps = format!("{title} has no value in {missing} of {} rows", places.len());
        notes.push(Note::left_out(gaps));
    }
    if dark > 0 {
        notes.push(Note::left_out(format!("{dark} rows at or below 0 {}", axis.unit.sign())));
    }
    order(&mut samples, title)?;
    check_density(&samples, axis, unit, title, notes)?;
    let convert = |(nm, value): &(f64, f64)| unit.map_or(*value, |unit| unit.convert(*value, *nm));
    let (first, last) = (grid.lines.first().copied().unwrap_or(1), grid.lines.last().copied().unwrap_or(1));
    Ok(Curve {
        name: column.name.clone(),
        values: samples.iter().map(convert).collect(),
        wavelengths: samples.into_iter().map(|(nm, _)| nm).collect(),
        unit,
        are_averages: false,
        axis: axis.unit,
        lines: column.lines.clone().unwrap_or(first.min(last)..=first.max(last)),
        column: (place + 1, grid.columns.len()),
    })
}

/// Brings the samples to increasing wavelengths.
fn order(samples: &mut [(f64, f64)], title: &str) -> Result<(), Refusal> {
    if samples.len() < 2 {
        return Err(Refusal::of(format!(
            "{title} has {} samples; a spectrum has two or more",
            samples.len()
        )));
    }
    if samples[0].0 > samples[samples.len() - 1].0 {
        samples.reverse();
    }
    match samples.windows(2).find(|pair| pair[1].0 <= pair[0].0) {
        Some(pair) => Err(Refusal::of(format!(
            "the wavelengths of {title} are not in order: {} nm comes beside {} nm",
            pair[0].0, pair[1].0
        ))),
        None => Ok(()),
    }
}

/// Returns what the values are: what the user says, or what the file says.
fn unit(
    column: &Column,
    grid: &Grid,
    title: &str,
    options: &Options,
    notes: &mut Vec<Note>,
) -> Result<Option<Unit>, Refusal> {
    let said = column
        .unit
        .as_ref()
        .and_then(|said| Unit::in_heading(&said.text).map(|unit| (unit, said.text.as_str())));
    let name = column.name.as_deref().filter(|_| !grid.is_known);
    let said = said.or_else(|| name.and_then(|name| Some((Unit::in_heading(name)?, name))));
    let label = || {
        grid.columns.iter().filter_map(|column| column.unit.as_ref()).find_map(|said| {
            said.text
                .starts_with(|c: char| c.is_ascii_digit())
                .then(|| Some((Unit::in_heading(&said.text)?, said.text.as_str())))?
        })
    };
    let said = said.or_else(label);
    let said = said.or_else(|| {
        grid.unit.as_ref().and_then(|said| Some((Unit::in_heading(&said.text)?, said.text.as_str())))
    });
    let unit = match (options.unit, said) {
        (Some(wanted), Some((said, text))) if wanted != said && wanted.quantity != Quantity::Relative => {
            let what =
                format!("the file says '{}' of {title}, and the option says something else", text.trim());
            return Err(Refusal::of(what).settled_by(Setting::Unit));
        }
        (Some(wanted), _) => Some(wanted),
        (None, Some((said, text))) => {
            notes.push(Note::stated(format!("{title} is in {} by '{}'", said.sign(), text.trim())));
            Some(said)
        }
        (None, None) => None,
    };
    Ok(match unit {
        None if options.percent => Some(Unit::of(Quantity::Reflectance, 0.01)),
        Some(unit) if options.percent && unit.factor == 1.0 => Some(Unit { factor: 0.01, ..unit }),
        unit => unit,
    })
}

/// Refuses a density per frequency of which that is not said, and says what is assumed of a power without one.
fn check_density(
    samples: &[(f64, f64)],
    axis: &Axis,
    unit: Option<Unit>,
    title: &str,
    notes: &mut Vec<Note>,
) -> Result<(), Refusal> {
    let is_ratio = unit.is_some_and(|unit| {
        matches!(unit.quantity, Quantity::Reflectance | Quantity::Transmittance | Quantity::Absorbance)
    });
    if is_ratio || unit.is_some_and(|unit| unit.per.is_some()) {
        return Ok(());
    }
    if !axis.unit.is_wavelength() {
        let what = format!(
            "the axis is in {}, and whether {title} is per nm or per {} is not said",
            axis.unit.sign(),
            axis.unit.sign()
        );
        return Err(Refusal::of(what).settled_by(Setting::Unit));
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
