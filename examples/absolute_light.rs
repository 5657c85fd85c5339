//! What a light on a desk or on a leaf does, from its spectral irradiance in W/(m2 nm): illuminance for the
//! eye, photons for plants (PPFD), melanopic light for the body's clock (CIE S 026). For lighting designers
//! and growers.
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

/// The CIE illuminant of this name, so bright that it gives 500 lx.
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

    // The deep red LED of a grow light, 10 W/m2 at 660 nm.
    let mut red = Fine::<Power>::flat(0.0);
    let lost = red.add_line(660.0, 10.0);
    show("grow light", &red);

    // CIE S 026: 1.3262 mW/lm of daylight D65 are melanopic, and the equivalent daylight illuminance of D65
    // is its illuminance; an incandescent lamp (A) has 0.496 of that.
    let melanopic = AlphaOpic::new(&daylight);
    assert!((melanopic.melanopic / 500.0 - 1.3262e-3).abs() < 1e-7);
    assert!((melanopic.edi().melanopic - 500.0).abs() < 0.1);
    assert!((AlphaOpic::new(&incandescent).edi().melanopic / 500.0 - 0.496).abs() < 5e-4);
    // A mole of photons of 660 nm carries h c N_A / 660 nm = 0.11963 J m / 660 nm = 181.25 kJ. CIE 18: the
    // eye's sensitivity V(660 nm) is 0.061, and 683 lm/W at 555 nm.
    assert!((ppfd(&red) - 10.0 / 0.181_25).abs() < 0.01 && lost == 0.0);
    assert!((illuminance(&red) - 10.0 * 683.0 * 0.061).abs() < 0.1);
    Ok(())
}
