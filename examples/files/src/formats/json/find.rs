//! Finds the spectra in a tree.

use super::keys::{self, About};
use super::node::Node;
use super::places::{self, Places};
use crate::formats::contents::{Contents, Spectrum, TWICE, highest, part};
use crate::grid::{Column, Said};
use crate::refusal::{Note, Refusal, Setting};
use crate::unit::{AxisUnit, Quantity, Unit};
use std::ops::RangeInclusive;
use std::rc::Rc;

/// The most levels that are searched.
const DEEPEST: usize = 12;

/// The most notes of arrays that are no spectra.
const MOST_NOTES: usize = 5;

/// What the parts of the tree above a part say of it.
#[derive(Clone, Default)]
pub struct Context {
    pub name: Option<String>,
    /// Where the part is, such as `spectra[2].values`.
    pub path: String,
    unit: Option<String>,
    axis_unit: Option<String>,
    places: Option<Places>,
}

/// Collects spectra.
pub struct Finder {
    lines: RangeInclusive<usize>,
    contents: Contents,
    /// What was found that is no spectrum.
    pub problems: Vec<String>,
}

impl Context {
    fn at(&self, key: &str) -> Self {
        let path = if self.path.is_empty() { key.to_owned() } else { format!("{}.{key}", self.path) };
        Context { path, ..self.clone() }
    }

    pub fn place(&self) -> &str {
        if self.path.is_empty() { "the outermost array" } else { &self.path }
    }
}

impl Finder {
    pub fn new(lines: RangeInclusive<usize>) -> Self {
        Finder { lines, contents: Contents::default(), problems: Vec::new() }
    }

    pub fn finish(mut self) -> Result<Contents, Refusal> {
        if !self.contents.grids.is_empty() {
            let notes = self.problems.into_iter().take(MOST_NOTES).map(Note::left_out);
            self.contents.notes.extend(notes);
            return Ok(self.contents);
        }
        let problem = self.problems.into_iter().next().map(|what| what + "; ").unwrap_or_default();
        let what = format!(
            "{problem}no spectrum was found: it is read from arrays such as {{\"wavelength\": [380, 381], \"value\": \
             [0.1, 0.2]}}, from pairs [[380, 0.1], [381, 0.2]], or from records [{{\"wavelength\": 380, \"value\": 0.1}}]"
        );
        Err(Refusal::of(what))
    }

    pub fn search(&mut self, root: &Node) -> Result<(), Refusal> {
        self.node(root, &Context::default(), 0)
    }

    fn node(&mut self, node: &Node, context: &Context, depth: usize) -> Result<(), Refusal> {
        if depth > DEEPEST {
            let what =
                format!("{} is nested more than {DEEPEST} levels deep; move the spectra up", context.path);
            return Err(Refusal::of(what));
        }
        match node {
            Node::Object(members) => self.object(members, context, depth),
            Node::Array(nodes) => self.array(nodes, context, depth),
            Node::Numbers(values) => {
                let name = context.name.clone();
                self.curve(context, name, "", values)
            }
            Node::Number(_) | Node::Text(_) | Node::Empty => Ok(()),
        }
    }

    fn object(&mut self, members: &[(String, Node)], outer: &Context, depth: usize) -> Result<(), Refusal> {
        let mut context = self.stated(members, outer);
        if self.bins(members, &context) || self.keyed(members, &context)? {
            return Ok(());
        }
        let axis = places::axis(members);
        if let Some((key, places)) = &axis {
            let (key, places) = ((*key).to_owned(), Rc::new(places.to_vec()));
            context.places = Some(Places::Given { key, places });
        } else if let Some(steps) = places::steps(members) {
            context.places = Some(steps);
        }
        let is_curve = |key: &str, node: &Node| {
            axis.as_ref().is_none_or(|axis| axis.0 != key)
                && places::column(node).is_some_and(|column| column.len() > 1)
        };
        let count = members.iter().filter(|(key, node)| is_curve(key, node)).count();
        for (key, node) in members {
            let mut inner = context.at(key);
            if is_curve(key, node)
                && let Some(values) = places::column(node)
            {
                let name = match &context.name {
                    Some(name) if count > 1 && !keys::is_common(key) => format!("{name} {key}"),
                    Some(name) => name.clone(),
                    None => key.clone(),
                };
                self.curve(&inner, Some(name), key, &values)?;
            } else if axis.as_ref().is_none_or(|axis| axis.0 != key) {
                if !keys::is_common(key) && matches!(node, Node::Object(_) | Node::Array(_)) {
                    inner.name = Some(key.clone());
                }
                self.node(node, &inner, depth + 1)?;
            }
        }
        Ok(())
    }

    /// Returns what an object says of the spectra inside it, and takes its facts.
    fn stated(&mut self, members: &[(String, Node)], outer: &Context) -> Context {
        let mut context = outer.clone();
        let name = members.iter().filter_map(|(key, node)| match node {
            Node::Text(text) if !text.trim().is_empty() => Some((keys::name_rank(key)?, text)),
            _ => None,
        });
        if let Some((_, name)) = name.min_by_key(|(rank, _)| *rank) {
            context.name = Some(name.clone());
        }
        for (key, node) in members {
            match (keys::unit(key), node) {
                (Some(about), Node::Text(text)) => self.unit(key, about, text, &mut context),
                (Some(About::Values), Node::Object(units)) => {
                    for (key, node) in units {
                        let about = if keys::is_axis(key) { About::Axis } else { About::Values };
                        if let Node::Text(text) = node {
                            self.unit(key, about, text, &mut context);
                        }
                    }
                }
                _ => {}
            }
            let path = context.at(key).path;
            match node {
                _ if keys::wavelength(key).is_some() => {}
                Node::Text(text) => self.contents.fact(*self.lines.start(), &path, text),
                Node::Number(number) => self.contents.fact(*self.lines.start(), &path, &number.to_string()),
                _ => {}
            }
        }
        context
    }

    fn unit(&mut self, key: &str, about: About, text: &str, context: &mut Context) {
        if about == About::Axis {
            context.axis_unit = Some(text.to_owned());
        } else if Unit::in_heading(text).is_some() {
            context.unit = Some(text.to_owned());
        } else if key.to_lowercase().contains("unit") && AxisUnit::parse(text).is_none() {
            self.contents.notes.push(Note::assumed(
                format!(
                    "the values are taken as they are, because '{key}' says '{text}', which is not known"
                ),
                Some(Setting::Unit),
            ));
        }
    }

    fn array(&mut self, nodes: &[Node], context: &Context, depth: usize) -> Result<(), Refusal> {
        if self.records(nodes.iter(), context)? || self.table(nodes, context)? {
            return Ok(());
        }
        for (place, node) in nodes.iter().enumerate() {
            let mut inner = Context { path: format!("{}[{place}]", context.path), ..context.clone() };
            if nodes.len() > 1 {
                let name = inner.name.as_deref().unwrap_or("spectrum");
                inner.name = Some(format!("{name} {}", place + 1));
            }
            self.node(node, &inner, depth + 1)?;
        }
        Ok(())
    }

    /// Reads rows of numbers of equal length, with or without a row of names above them. Returns whether there are
    /// such.
    fn table(&mut self, nodes: &[Node], context: &Context) -> Result<bool, Refusal> {
        let names: Vec<&str> = match nodes.first() {
            Some(Node::Array(names)) => names
                .iter()
                .map_while(|name| if let Node::Text(name) = name { Some(&**name) } else { None })
                .collect(),
            _ => Vec::new(),
        };
        let rows = &nodes[usize::from(!names.is_empty())..];
        let rows: Option<Vec<&[f64]>> = rows
            .iter()
            .map(|row| if let Node::Numbers(row) = row { Some(row.as_slice()) } else { None })
            .collect();
        let Some(rows) = rows.filter(|rows| rows.len() > 1) else { return Ok(false) };
        let width = rows[0].len();
        if width < 2 || rows.iter().any(|row| row.len() != width) {
            return Ok(false);
        }
        let turned = || (0..width).map(|place| rows.iter().map(|row| row[place]).collect()).collect();
        let as_they_are = || rows.iter().map(|row| row.to_vec()).collect();
        let mut columns: Vec<Vec<f64>> = match &context.places {
            Some(Places::Given { places, .. }) if places.len() != width && places.len() == rows.len() => {
                turned()
            }
            Some(_) => as_they_are(),
            None => {
                let first = Column { values: rows[0].to_vec(), ..Column::default() };
                if rows.len() < width && first.is_monotone() { as_they_are() } else { turned() }
            }
        };
        let axis = if context.places.is_none() { Some(columns.remove(0)) } else { None };
        let skipped = usize::from(axis.is_some());
        let count = columns.len();
        for (place, values) in columns.into_iter().enumerate() {
            let key = names.get(place + skipped).copied().unwrap_or("");
            let name = match (&context.name, key) {
                (name, "") if count > 1 => {
                    Some(format!("{} {}", name.as_deref().unwrap_or("spectrum"), place + 1))
                }
                (name, "") => name.clone(),
                (_, key) => Some(key.to_owned()),
            };
            match &axis {
                Some(axis) => {
                    let title = names.first().copied().unwrap_or("wavelength");
                    self.add(context, name, key, title, axis.clone(), values);
                }
                None => self.curve(context, name, key, &values)?,
            }
        }
        Ok(true)
    }

    /// Adds a curve at the places that its surroundings state.
    fn curve(
        &mut self,
        context: &Context,
        name: Option<String>,
        key: &str,
        values: &[f64],
    ) -> Result<(), Refusal> {
        if values.len() < 2 {
            return Ok(());
        }
        let (axis, places) = match &context.places {
            None => {
                self.problems.push(format!(
                    "{} has {} numbers and no wavelengths",
                    context.place(),
                    values.len()
                ));
                return Ok(());
            }
            Some(Places::Given { key, places }) if places.len() != values.len() => {
                self.problems.push(format!(
                    "{} has {} numbers, and {key} has {}",
                    context.place(),
                    values.len(),
                    places.len()
                ));
                return Ok(());
            }
            Some(Places::Given { key, places }) => (key.clone(), places.to_vec()),
            Some(Places::Steps { key, start, step, end }) => {
                (key.clone(), places::steady(*start, *step, *end, values.len(), context.place())?)
            }
        };
        self.add(context, name, key, &axis, places, values.to_vec());
        Ok(())
    }

    pub fn add(
        &mut self,
        context: &Context,
        name: Option<String>,
        key: &str,
        axis: &str,
        places: Vec<f64>,
        values: Vec<f64>,
    ) {
        let axis = match &context.axis_unit {
            Some(unit) => format!("wavelength ({unit})"),
            None => axis.to_owned(),
        };
        let stated = Some(key).filter(|key| Unit::in_heading(key).is_some()).or(context.unit.as_deref());
        let unit = stated.and_then(|text| {
            let unit = Unit::in_heading(text)?;
            let high = highest(&values);
            Some(match unit.quantity {
                Quantity::Reflectance if unit.factor == 1.0 && high > TWICE => {
                    part("reflectance", high, TWICE, &mut self.contents.notes)
                }
                Quantity::Transmittance if unit.factor == 1.0 && high > TWICE => {
                    part("transmittance", high, TWICE, &mut self.contents.notes)
                }
                _ => text.to_owned(),
            })
        });
        let line = *self.lines.start();
        let unit = unit.map(|text| Said { text, line });
        self.contents.add(Spectrum { name, axis, places, values, unit, lines: self.lines.clone() });
    }
}
