//! Finds the places of values on the axis.

use super::keys::{self, Step};
use super::node::{Node, number};
use crate::refusal::Refusal;
use crate::unit::AxisUnit;
use std::borrow::Cow;
use std::rc::Rc;

/// Where the values of a spectrum stand on the axis.
#[derive(Clone)]
pub enum Places {
    Given { key: String, places: Rc<Vec<f64>> },
    Steps { key: String, start: f64, step: Option<f64>, end: Option<f64> },
}

/// Returns the array of a node, also of one with the keys 0, 1, 2, .. that pandas writes.
pub fn column(node: &Node) -> Option<Cow<'_, [f64]>> {
    match node {
        Node::Numbers(numbers) => Some(Cow::Borrowed(numbers)),
        Node::Object(members) if members.len() > 1 => {
            let is_place = |(place, (key, _)): (usize, &(String, Node))| key.parse() == Ok(place);
            if !members.iter().enumerate().all(is_place) {
                return None;
            }
            members.iter().map(|(_, node)| number(node)).collect::<Option<Vec<f64>>>().map(Cow::Owned)
        }
        _ => None,
    }
}

/// Returns the member of an object that is the axis of the others.
pub fn axis(members: &[(String, Node)]) -> Option<(&str, Cow<'_, [f64]>)> {
    let of = |accept: &dyn Fn(&str) -> bool| {
        members.iter().filter(|(key, _)| keys::is_axis(key) && accept(key)).find_map(|(key, node)| {
            let places = column(node).filter(|places| places.len() > 1)?;
            Some((key.as_str(), places))
        })
    };
    of(&|key| !matches!(key, "x" | "w")).or_else(|| of(&|_| true))
}

/// Returns the steps that an object states.
pub fn steps(members: &[(String, Node)]) -> Option<Places> {
    let find = |wanted: Step| {
        members.iter().find(|(key, _)| keys::step(key) == Some(wanted)).and_then(|(key, node)| {
            number(node).filter(|number| number.is_finite()).map(|number| (key.as_str(), number))
        })
    };
    let (key, start) = find(Step::Start)?;
    let (step, end) = (find(Step::Size).map(|step| step.1), find(Step::End).map(|end| end.1));
    // The unit may be in the key, as in `start_nm`.
    let unit =
        AxisUnit::in_heading(key).map_or("wavelength".into(), |unit| format!("wavelength ({})", unit.sign()));
    (step.is_some() || end.is_some()).then_some(Places::Steps { key: unit, start, step, end })
}

/// Returns places in equal steps.
pub fn steady(
    start: f64,
    step: Option<f64>,
    end: Option<f64>,
    count: usize,
    place: &str,
) -> Result<Vec<f64>, Refusal> {
    let intervals = (count - 1) as f64;
    let step = match (step, end) {
        (Some(step), Some(end)) if (start + step * intervals - end).abs() > step.abs() / 2.0 => {
            let what = format!(
                "{place} has {count} values, which does not fit from {start} to {end} in steps of {step}; correct the \
                 one that is wrong"
            );
            return Err(Refusal::of(what));
        }
        (Some(step), _) => step,
        (None, Some(end)) => (end - start) / intervals,
        (None, None) => 1.0,
    };
    Ok((0..count).map(|index| start + index as f64 * step).collect())
}
