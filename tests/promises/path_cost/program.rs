//! For tests/promises/path_cost.rs to count: a path of factors, and the loop that a hand would write.

use core::hint::black_box;
use nanospectra::observer::{CIE_1931, Curve, Observer};
use nanospectra::{Light, Power, Reflectance};

static EYE: Observer<3, 31, Power> = CIE_1931.fold(Curve::Spline);

struct Parts {
    sun: Light<31>,
    glass: Reflectance<31>,
    paper: Reflectance<31>,
}

fn main() {
    let parts = black_box(Parts {
        sun: Light::flat(1.0),
        glass: Reflectance::flat(0.8),
        paper: Reflectance::flat(0.5),
    });
    let by_path = (surface_by_path(&parts), glass_surface_by_path(&parts));
    let by_hand = (surface_by_hand(&parts), glass_surface_by_hand(&parts));
    assert_eq!(by_path, by_hand, "the same bits");
}

#[inline(never)]
fn surface_by_path(parts: &Parts) -> [f32; 3] {
    EYE.sees(parts.sun.onto(&parts.paper))
}

#[inline(never)]
fn surface_by_hand(parts: &Parts) -> [f32; 3] {
    let mut bins = Light::flat(0.0);
    let factors = parts.sun.values().iter().zip(parts.paper.values());
    for (bin, (sun, paper)) in bins.values_mut().iter_mut().zip(factors) {
        *bin = sun * paper;
    }
    EYE.sees(&bins)
}

#[inline(never)]
fn glass_surface_by_path(parts: &Parts) -> [f32; 3] {
    EYE.sees(parts.sun.through(&parts.glass).onto(&parts.paper))
}

#[inline(never)]
fn glass_surface_by_hand(parts: &Parts) -> [f32; 3] {
    let mut bins = Light::flat(0.0);
    let factors = parts.sun.values().iter().zip(parts.glass.values()).zip(parts.paper.values());
    for (bin, ((sun, glass), paper)) in bins.values_mut().iter_mut().zip(factors) {
        *bin = sun * glass * paper;
    }
    EYE.sees(&bins)
}
