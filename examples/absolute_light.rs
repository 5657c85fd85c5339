//! From the spectral irradiance of a light on a desk or on a leaf, in W/(m2 nm), this example computes the
//! illuminance for the eye, the photons for plants (PPFD) and the melanopic light for the body's clock
//! (CIE S 026). It is for lighting designers and growers.
//!
//! `cargo run --release --example absolute_light`

use nanospectra::radiometry::{AlphaOpic, illuminance, ppfd};
use nanospectra::{Fine, Power, light};

fn show(name: &str, light: &Fine<Power>) {
    println!(
        "{name}: {:.2} W/m2, {:.0} lx, PPFD {:.2} umol/(m2 s), melanopic {:.3} W/m2, EDI {:.0} lx",
        light.power(),
        illuminance(light),
        ppfd(light),
        AlphaOpic::new(light).melanopic,
        AlphaOpic::new(light).edi().melanopic,
    );
}

/// Returns the CIE illuminant of this name, scaled to 500 lx.
fn at_500_lx(name: &str) -> Option<Fine<Power>> {
    let relative = light::named(name)?;
    Some(relative * (500.0 / illuminance(&relative)))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let daylight = at_500_lx("D65").ok_or("no such light")?;
    let incandescent = at_500_lx("A").ok_or("no such light")?;
    let office = at_500_lx("LED-B3").ok_or("no such light")?;
    show("daylight", &daylight);
    show("incandescent", &incandescent);
    show("white LED", &office);

    // A grow light has a deep red LED, which gives 10 W/m2 at 660 nm.
    let mut red = Fine::<Power>::flat(0.0);
    let lost = red.add_line(660.0, 10.0);
    show("grow light", &red);

    // By CIE S 026, daylight D65 has 1.3262 mW/lm of melanopic light, and its melanopic equivalent daylight
    // illuminance is its illuminance. An incandescent lamp (A) has 0.496 of that.
    let melanopic = AlphaOpic::new(&daylight);
    assert!((melanopic.melanopic / 500.0 - 1.3262e-3).abs() < 1e-7);
    assert!((melanopic.edi().melanopic - 500.0).abs() < 0.1);
    assert!((AlphaOpic::new(&incandescent).edi().melanopic / 500.0 - 0.496).abs() < 5e-4);
    // A mole of photons of 660 nm carries h c N_A / 660 nm = 0.11963 J m / 660 nm = 181.25 kJ. By CIE 18, the
    // eye has 683 lm/W at 555 nm, and V(660 nm) = 0.061 of that at 660 nm.
    assert!((ppfd(&red) - 10.0 / 0.181_25).abs() < 0.01 && lost == 0.0);
    assert!((illuminance(&red) - 10.0 * 683.0 * 0.061).abs() < 0.1);
    Ok(())
}
