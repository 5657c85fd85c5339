//! Draws the chromaticity diagram of the observer, with the spectrum locus, the black bodies and the reading.

use crate::measure::level::Kind;
use crate::measure::reading::{Bench, Reading};
use crate::output::{number, tint};
use crate::picture::axis::{Axis, Frame};
use crate::picture::spectrum::{gradient, stop};
use crate::picture::{Area, FAINT, INK, label};
use nanospectra::color::{Xy, Xyz};
use nanospectra::light::blackbody_relative;
use nanospectra::{Fine, FineObserver, Power};
use svg::node::element::path::Data;
use svg::node::element::{Circle, Definitions, Group, LinearGradient, Path, Polygon};

/// The ends of the drawn locus, in nm. Beyond them, the observer's tables are too noisy to draw.
const FIRST: usize = 400;
const LAST: usize = 700;
/// The wavelengths that are written beside the locus, in nm.
const NUMBERED: [usize; 13] = [460, 470, 480, 490, 500, 510, 520, 540, 560, 580, 600, 620, 700];
/// The temperatures that are written beside the line of black bodies, in K.
const HOT: [f32; 4] = [2000.0, 3000.0, 5000.0, 10_000.0];
/// The chromaticity at which all wedges of color meet.
const WHITE: Xy = Xy { x: 1.0 / 3.0, y: 1.0 / 3.0 };
/// The number of colors along a ray from white, and of wedges along the purple line.
const STOPS: usize = 6;
const PURPLES: usize = 40;

pub fn draw(area: Area, bench: &Bench, reading: &Reading) -> Group {
    let eye = bench.eye.functions;
    let frame = Frame { area, x: Axis::between(0.0, 0.8, 0.2), y: Axis::between(0.0, 0.9, 0.2) };
    let locus: Vec<Xy> = (FIRST..=LAST).filter_map(|nm| spectral(eye, nm)).collect();
    let mut group = Group::new()
        .add(frame.draw("x", "y"))
        .add(colors(&frame, &locus))
        .add(outline(&frame, &locus))
        .add(wavelengths(&frame, eye))
        .add(black_bodies(&frame, eye));
    if reading.kind == Kind::Surface
        && let Some(white) = bench.room.white().xy()
    {
        group = group.add(cross(&frame, white));
    }
    if let Some(xy) = reading.xy {
        group = group.add(point(&frame, xy));
    }
    group.add(frame.border())
}

/// Returns the chromaticity of one wavelength.
fn spectral(eye: &FineObserver<3>, nm: usize) -> Option<Xy> {
    Xyz::from(eye.weights().map(|row| row[nm - 360])).xy()
}

/// Fills the locus with colors, by wedges from white to the edge.
fn colors(frame: &Frame, locus: &[Xy]) -> Group {
    let (Some(blue), Some(red)) = (locus.first(), locus.last()) else { return Group::new() };
    let mut edge: Vec<Xy> = locus.iter().step_by(2).copied().collect();
    edge.extend((1..=PURPLES).map(|k| between(*red, *blue, k as f32 / PURPLES as f32)));
    let mut definitions = Definitions::new();
    let mut wedges = Group::new();
    for (k, pair) in edge.windows(2).enumerate() {
        let id = format!("wedge{k}");
        let corners = [WHITE, pair[0], pair[1]].map(|xy| frame.place(xy.x, xy.y));
        let corners =
            corners.map(|(x, y)| format!("{},{}", number::fixed(x, 2), number::fixed(y, 2))).join(" ");
        definitions = definitions.add(ray(frame, &id, between(pair[0], pair[1], 0.5)));
        let paint = format!("url(#{id})");
        // The stroke closes the hair lines that antialiasing leaves between wedges.
        let wedge = Polygon::new().set("points", corners).set("fill", paint.clone()).set("stroke", paint);
        wedges = wedges.add(wedge.set("stroke-width", 0.7));
    }
    Group::new().add(definitions).add(wedges)
}

/// Returns the gradient of colors from white to a point of the edge.
fn ray(frame: &Frame, id: &str, edge: Xy) -> LinearGradient {
    let gradient = gradient(id, frame.place(WHITE.x, WHITE.y), frame.place(edge.x, edge.y));
    (0..=STOPS).fold(gradient, |gradient, k| {
        let share = k as f32 / STOPS as f32;
        gradient.add(stop(share, tint::of_chromaticity(between(WHITE, edge, share))))
    })
}

fn between(a: Xy, b: Xy, share: f32) -> Xy {
    Xy { x: a.x + share * (b.x - a.x), y: a.y + share * (b.y - a.y) }
}

fn outline(frame: &Frame, locus: &[Xy]) -> Path {
    path(frame, locus.iter().copied(), true).set("stroke", INK)
}

fn path(frame: &Frame, points: impl Iterator<Item = Xy>, closed: bool) -> Path {
    let mut data = Data::new();
    for (k, xy) in points.enumerate() {
        let at = frame.place(xy.x, xy.y);
        data = if k == 0 { data.move_to(at) } else { data.line_to(at) };
    }
    Path::new().set("d", if closed { data.close() } else { data }).set("fill", "none")
}

/// Draws the numbers outside the locus, away from white.
fn wavelengths(frame: &Frame, eye: &FineObserver<3>) -> Group {
    NUMBERED.into_iter().filter_map(|nm| Some((nm, spectral(eye, nm)?))).fold(
        Group::new(),
        |group, (nm, xy)| {
            let (x, y) = frame.place(xy.x, xy.y);
            let (white_x, white_y) = frame.place(WHITE.x, WHITE.y);
            let (dx, dy) = (x - white_x, y - white_y);
            let length = dx.hypot(dy).max(1.0);
            let (x2, y2) = (x + 4.0 * dx / length, y + 4.0 * dy / length);
            let tick = Path::new().set("d", Data::new().move_to((x, y)).line_to((x2, y2))).set("stroke", INK);
            let anchor = if dx > 0.3 * length {
                "start"
            } else if dx < -0.3 * length {
                "end"
            } else {
                "middle"
            };
            let text = label(x + 7.0 * dx / length, y + 11.0 * dy / length + 3.5, &nm.to_string())
                .set("text-anchor", anchor)
                .set("font-size", 10)
                .set("fill", FAINT);
            group.add(tick).add(text)
        },
    )
}

/// Draws the line of black bodies from 1500 K to 100,000 K, in equal steps of mired.
fn black_bodies(frame: &Frame, eye: &FineObserver<3>) -> Group {
    let at = |kelvin: f32| {
        let light = Fine::<Power>::at_centers(|nm| blackbody_relative(nm, kelvin));
        Xyz::from(eye.sees(&light)).xy()
    };
    let line = (10..=660).step_by(10).filter_map(|mired| at(1e6 / mired as f32));
    let group = Group::new().add(path(frame, line, false).set("stroke", INK).set("stroke-width", 1.2));
    HOT.into_iter().filter_map(|kelvin| Some((kelvin, at(kelvin)?))).fold(group, |group, (kelvin, xy)| {
        let (x, y) = frame.place(xy.x, xy.y);
        let text = label(x + 2.0, y + 13.0, &format!("{kelvin} K")).set("font-size", 9);
        group.add(Circle::new().set("cx", x).set("cy", y).set("r", 1.8).set("fill", INK)).add(text)
    })
}

/// Draws a cross at the white of the light on a surface.
fn cross(frame: &Frame, white: Xy) -> Path {
    let (x, y) = frame.place(white.x, white.y);
    let data =
        Data::new().move_to((x - 6.0, y)).line_to((x + 6.0, y)).move_to((x, y - 6.0)).line_to((x, y + 6.0));
    Path::new().set("d", data).set("stroke", INK).set("stroke-width", 1.5)
}

fn point(frame: &Frame, xy: Xy) -> Group {
    let (x, y) = frame.place(xy.x, xy.y);
    let ring = Circle::new().set("cx", x).set("cy", y).set("r", 6).set("fill", "none");
    Group::new()
        .add(ring.clone().set("stroke", "#ffffff").set("stroke-width", 4))
        .add(ring.set("stroke", "#000000").set("stroke-width", 2))
}
