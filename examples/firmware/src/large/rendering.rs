//! Color rendering, whose samples take most of the flash of the smallest part.

use crate::steps::Meter;
use nanospectra::color::{Cri, Tm30, cri, tm30};
use nanospectra::light::{A, D65, FL2};
use nanospectra::{Fine, Power};

/// One light for each kind of reference: a black body, daylight, and a mixture of both.
static LIGHTS: [Fine<Power>; 3] = [A.fine(), D65.fine(), FL2.fine()];

/// Measures every call of this group.
pub fn all(meter: &mut impl Meter) {
    meter.step("tm30", of_99_samples, &LIGHTS);
    meter.step("cri", of_15_samples, &LIGHTS);
}

#[inline(never)]
fn of_99_samples(light: &Fine<Power>, out: &mut Option<Tm30>) {
    *out = tm30(light).ok();
}

#[inline(never)]
fn of_15_samples(light: &Fine<Power>, out: &mut Option<Cri>) {
    *out = cri(light).ok();
}
