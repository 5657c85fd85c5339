//! This program renders either in red, green and blue or in 31 bins of wavelengths. One line, which imports
//! the types, chooses between the two.
//!
//! ```text
//! cargo run --example one_alias
//! ```

use nanospectra::color::{Rgb, Srgb, Xyz};
use nanospectra::geometry::Direction;
use nanospectra::matter::{Brdf, Microfacet, OrenNayar, TrowbridgeReitz};
use nanospectra::radiometry::{Intensity, PerSr};

/// Three floats are fastest, but inaccurate where colored light meets colored surfaces.
#[allow(unused, reason = "the one that is not chosen")]
mod in_rgb {
    use nanospectra::color::{RgbBands, Srgb};
    pub type Light = nanospectra::Light<3, RgbBands<Srgb>>;
    pub type Reflectance = nanospectra::Reflectance<3, RgbBands<Srgb>>;
    pub type Eye = nanospectra::Observer<3, 3, nanospectra::Power, RgbBands<Srgb>>;
}

/// 31 bins of wavelengths are accurate there too, with ten times as many numbers.
#[allow(unused, reason = "the one that is not chosen")]
mod in_bins {
    pub type Light = nanospectra::Light<31>;
    pub type Reflectance = nanospectra::Reflectance<31>;
    pub type Eye = nanospectra::Observer<3, 31, nanospectra::Power>;
}

// This line chooses. Everything below it compiles for both.
use in_bins::{Eye, Light, Reflectance};

static EYE: Eye = Eye::standard();

fn main() {
    let color = Rgb::<Srgb>::new;
    let lamp = Intensity::new(Light::from_rgb(color(30.0, 20.0, 10.0)));
    let clay = OrenNayar::new(Reflectance::from_rgb(color(0.5, 0.15, 0.05)), 0.8);
    let glaze = Microfacet { facets: TrowbridgeReitz::new(0.4), boundary: Reflectance::flat(0.04) };
    let pane = Reflectance::from_rgb(color(0.6, 0.9, 0.7));

    println!("A clay tile under a warm lamp, seen through greenish glass from straight above:");
    for degrees in [0.0f32, 20.0, 40.0, 60.0, 80.0] {
        let (wo, wi) = (Direction::NORMAL, Direction::spherical(degrees.to_radians(), 0.0));
        let arriving = lamp.at_distance(2.0, wi.cos_theta());
        let leaving = arriving * PerSr(clay.f(wo, wi) + glaze.f(wo, wi));
        let xyz = Xyz::from(EYE.sees(leaving.value().through(&pane)));
        let [r, g, b] = Rgb::<Srgb>::from_xyz(xyz).to_array();
        println!("{degrees:>4} degrees: Y {:7.3}, sRGB {r:.4} {g:.4} {b:.4}", xyz.y);
    }
}
