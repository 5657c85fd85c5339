//! Brings the values of a column to the unit of their quantity and to increasing wavelengths.

use super::axis::Axis;
use crate::grid::{Column, Grid};
use crate::options::Options;
use crate::reading::Curve;
use crate::refusal::{Note, Refusal, Setting};
use crate::unit::{AxisUnit, Quantity, Unit, brackets};

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
    }
    if missing > 0 {
        let gaps = format!("{title} has no value in {missing} of {} rows", places.len());
        notes.push(Note::left_out(gaps));
    }
    if dark > 0 {
        notes.push(Note::left_out(format!("{dark} rows at or below 0 {}", axis.unit.sign())));
    }
    order(&mut samples, title).map_err(|refusal| {
        // The first row of the two is where the axis stops to go on.
        let at = |nm: f64| places.iter().position(|at| axis.unit.nm(*at) == nm);
        let line = refusal.1.and_then(at).and_then(|row| grid.lines.get(row)).copied();
        Refusal { line, ..refusal.0 }
    })?;
    check_density(&samples, axis, unit, title, notes)?;
    let convert = |(nm, value): &(f64, f64)| unit.map_or(*value, |unit| unit.convert(*value, *nm));
    let ends = [grid.lines.first(), grid.lines.last()].map(|line| line.copied().unwrap_or(1));
    let [first, last] = column.line.map_or(ends, |line| [line, line]);
    let edges = edges(grid, axis, &samples, missing + dark, title, notes)?;
    Ok(Curve {
        name: column.name.clone(),
        values: samples.iter().map(convert).collect(),
        wavelengths: samples.into_iter().map(|(nm, _)| nm).collect(),
        unit,
        edges,
        axis: axis.unit,
        lines: first.min(last)..=first.max(last),
        place: (column.place, grid.columns.iter().map(|column| column.place).max().unwrap_or(1)),
        is_row: column.line.is_some(),
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
        notes.push(Note::stated(format!("{title} has averages over bands, whose edges lie half way between")));
        return Ok(Some(half_way(samples)));
    }
    let Some(edges) = &grid.edges else { return Ok(None) };
    if left_out > 0 {
        return Err(Refusal::of(format!("{title} has bands without a value; complete them or take their rows out")));
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

/// Brings the samples to increasing wavelengths, or returns the wavelength where that fails.
fn order(samples: &mut [(f64, f64)], title: &str) -> Result<(), (Refusal, Option<f64>)> {
    if samples.len() < 2 {
        let what = format!("{title} has too few samples ({}); a spectrum has two or more", samples.len());
        return Err((Refusal::of(what), None));
    }
    if samples[0].0 > samples[samples.len() - 1].0 {
        samples.reverse();
    }
    let Some(pair) = samples.windows(2).find(|pair| pair[1].0 <= pair[0].0) else { return Ok(()) };
    let (before, after) = (pair[0].0, pair[1].0);
    let what = if before == after {
        format!("{title} has {before} nm twice; keep one of the two rows")
    } else {
        format!("{after} nm of {title} comes after {before} nm; sort the rows by wavelength")
    };
    Err((Refusal::of(what), Some(after)))
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
    let said = said.or_else(|| column.name.as_deref().and_then(|name| Some((Unit::in_heading(name)?, name))));
    let label = || {
        let labeled = grid.columns.iter().find(|column| column.labeled)?.unit.as_ref()?;
        Some((Unit::in_heading(&labeled.text)?, labeled.text.as_str()))
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
        (None, None) => {
            unknown_unit(column, notes);
            None
        }
    };
    Ok(match unit {
        None if options.percent => Some(Unit::of(Quantity::Reflectance, 0.01)),
        Some(unit) if options.percent && unit.factor == 1.0 => Some(Unit { factor: 0.01, ..unit }),
        unit => unit,
    })
}

/// Says that a heading has something in brackets, or with a fraction, that no unit here is.
fn unknown_unit(column: &Column, notes: &mut Vec<Note>) {
    let texts = column.unit.iter().map(|said| said.text.as_str()).chain(column.name.as_deref());
    let in_brackets = texts.clone().flat_map(brackets);
    let fraction = texts.filter(|text| text.contains('/') && !text.contains(['(', '[']));
    let unknown = in_brackets.chain(fraction).map(str::trim).find(|text| text.contains(char::is_alphabetic));
    if let Some(unknown) = unknown {
        let what = format!("'{unknown}' of the heading is no unit that is known here, so the values are relative");
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
