//! Reads values that are given wavelength by wavelength.

use super::find::{Context, Finder};
use super::keys;
use super::node::{Node, number};
use crate::formats::too_large;
use crate::refusal::Refusal;

/// The most cells of a table of records.
const MOST_CELLS: usize = 20_000_000;

/// The columns of records, with their names.
type Columns<'a> = Vec<(&'a str, Vec<f64>)>;

impl Finder {
    /// Reads an object whose keys are wavelengths. Returns whether it is one.
    pub fn bins(&mut self, members: &[(String, Node)], context: &Context) -> bool {
        let mut points: Vec<(f64, f64)> =
            members.iter().filter_map(|(key, node)| Some((keys::wavelength(key)?, number(node)?))).collect();
        if points.len() < 2 || counts(&points) || points.len() * 2 < members.len() {
            return false;
        }
        points.sort_by(|one, other| one.0.total_cmp(&other.0));
        let axis = axis(members);
        let (places, values): (Vec<f64>, Vec<f64>) = points.into_iter().unzip();
        self.add(context, context.name.clone(), "", &axis, places, values);
        true
    }

    /// Reads an object whose keys are wavelengths with several values each, or places of records. Returns whether it
    /// is one.
    pub fn keyed(&mut self, members: &[(String, Node)], context: &Context) -> Result<bool, Refusal> {
        let mut rows: Vec<(f64, &Node)> = members
            .iter()
            .filter(|(_, node)| matches!(node, Node::Object(_) | Node::Numbers(_)))
            .filter_map(|(key, node)| Some((keys::wavelength(key)?, node)))
            .collect();
        if rows.len() < 2 || rows.len() * 2 < members.len() {
            return Ok(false);
        }
        if counts(&rows) {
            return self.records(rows.iter().map(|row| row.1), context);
        }
        rows.sort_by(|one, other| one.0.total_cmp(&other.0));
        let mut columns = Columns::new();
        let mut unnamed: Vec<Vec<f64>> = Vec::new();
        for (row, (_, node)) in rows.iter().enumerate() {
            match node {
                Node::Object(members) => fill(&mut columns, members, "", row, rows.len())?,
                Node::Numbers(values) => {
                    if values.len().saturating_mul(rows.len()) > MOST_CELLS {
                        return Err(too_large());
                    }
                    unnamed.resize(unnamed.len().max(values.len()), Vec::new());
                    for (column, value) in unnamed.iter_mut().zip(values) {
                        column.resize(row, f64::NAN);
                        column.push(*value);
                    }
                }
                _ => {}
            }
        }
        unnamed.iter_mut().for_each(|column| column.resize(rows.len(), f64::NAN));
        let names: Vec<String> = (1..=unnamed.len()).map(|place| place.to_string()).collect();
        columns.extend(names.iter().map(String::as_str).zip(unnamed));
        let places: Vec<f64> = rows.iter().map(|row| row.0).collect();
        self.columns(columns, &places, &axis(members), context);
        Ok(true)
    }

    /// Reads records that state one wavelength each. Returns whether there are such.
    pub fn records<'a>(
        &mut self,
        nodes: impl ExactSizeIterator<Item = &'a Node> + Clone,
        context: &Context,
    ) -> Result<bool, Refusal> {
        let Some(Node::Object(first)) = nodes.clone().next() else { return Ok(false) };
        let is_axis = |(key, node): &&(String, Node)| keys::is_axis(key) && number(node).is_some();
        let named = |(key, _): &&(String, Node)| !matches!(key.as_str(), "x" | "w");
        let axis = first.iter().find(|member| is_axis(member) && named(member));
        let Some((axis, _)) = axis.or_else(|| first.iter().find(is_axis)) else { return Ok(false) };
        let count = nodes.len();
        let mut places = Vec::with_capacity(count);
        let mut columns = Columns::new();
        for (row, node) in nodes.enumerate() {
            let Node::Object(members) = node else { return Ok(false) };
            let place = members.iter().find(|(key, _)| key == axis).and_then(|(_, node)| number(node));
            let Some(place) = place else {
                let what =
                    format!("{}[{row}] has no number as its '{axis}', as the others have", context.path);
                return Err(Refusal::of(what + "; complete it or take it out"));
            };
            places.push(place);
            fill(&mut columns, members, axis, row, count)?;
        }
        self.columns(columns, &places, axis, context);
        Ok(true)
    }

    /// Adds the columns of records.
    fn columns(&mut self, mut columns: Columns, places: &[f64], axis: &str, context: &Context) {
        columns.retain(|(_, values)| values.iter().any(|value| !value.is_nan()));
        if columns.is_empty() || places.len() < 2 {
            self.problems.push(format!("the records of {} have no values beside '{axis}'", context.place()));
            return;
        }
        let several = columns.len() > 1;
        for (key, values) in columns {
            let name = match &context.name {
                Some(name) if several => format!("{name} {key}"),
                Some(name) => name.clone(),
                None => key.to_owned(),
            };
            self.add(context, Some(name), key, axis, places.to_vec(), values);
        }
    }
}

/// Takes the numbers of a record, whose axis is `axis`, into the columns, which have `count` rows.
fn fill<'a>(
    columns: &mut Columns<'a>,
    members: &'a [(String, Node)],
    axis: &str,
    row: usize,
    count: usize,
) -> Result<(), Refusal> {
    for (key, node) in members.iter().filter(|(key, _)| key != axis) {
        let Some(value) = number(node) else { continue };
        let column = match columns.iter().position(|(name, _)| name == key) {
            Some(column) => column,
            None if (columns.len() + 1).saturating_mul(count) > MOST_CELLS => return Err(too_large()),
            None => {
                columns.push((key, vec![f64::NAN; count]));
                columns.len() - 1
            }
        };
        columns[column].1[row] = value;
    }
    Ok(())
}

/// Returns whether places count 0, 1, 2, .. or 1, 2, 3, .., as those of an array do.
fn counts<T>(rows: &[(f64, T)]) -> bool {
    rows.first().is_some_and(|row| row.0 == 0.0 || row.0 == 1.0)
        && rows.windows(2).all(|pair| pair[1].0 - pair[0].0 == 1.0)
}

/// Returns what the keys of an object are, which are wavelengths with or without their unit.
fn axis(members: &[(String, Node)]) -> String {
    let named = members.iter().find(|(key, _)| keys::wavelength(key).is_some());
    match named.map_or("", |(key, _)| key.trim_start_matches(|c: char| !c.is_alphabetic())) {
        "" => "wavelength".to_owned(),
        unit => format!("wavelength ({unit})"),
    }
}
