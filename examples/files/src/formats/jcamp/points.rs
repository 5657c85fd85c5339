//! Reads data that state the place and the value of each point.

use crate::refusal::Refusal;
use crate::text::lines::Line;
use crate::text::number::{Cell, Decimal, cell};

/// The points of a curve.
#[derive(Debug, Default, PartialEq)]
pub struct Points {
    pub places: Vec<f64>,
    pub values: Vec<f64>,
}

/// Reads pairs, of which a line may have several: `380, 0.5` or `380,0.5; 381,0.6`.
pub fn pairs(rows: &[Line]) -> Result<Points, Refusal> {
    let mut points = Points::default();
    for row in rows {
        let text = super::without_remark(row.text);
        let mut place = None;
        for part in text.split([',', ';', ' ', '\t']).filter(|part| !part.is_empty()) {
            let number = match cell(part, Decimal::Point) {
                Cell::Number(number) => number,
                Cell::Missing => f64::NAN,
                Cell::Text("?") => f64::NAN,
                Cell::Text(other) => {
                    let what = format!("'{other}' is not a number; each point has a place and a value");
                    return Err(Refusal::at(row.number, what));
                }
            };
            match place.take() {
                None => place = Some(number),
                Some(at) => {
                    points.places.push(at);
                    points.values.push(number);
                }
            }
        }
        if let Some(place) = place {
            let what = format!("the point at {place} has no value; each point has a place and a value");
            return Err(Refusal::at(row.number, what));
        }
    }
    Ok(points)
}
