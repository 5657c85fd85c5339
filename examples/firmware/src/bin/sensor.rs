//! An example of an instrument. It turns readings of a chip into color, smooths the last ones by a window,
//! measures flicker, and logs all of it.
//!
//! `cargo run --release --target <triple> --bin sensor` boots it in QEMU and prints the log as text (see
//! `run.sh`).
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(not(target_os = "none"))]
fn main() {
    println!("this image logs by a debugger and not on a host; run it with --target thumbv7em-none-eabihf");
}

#[cfg(target_os = "none")]
mod image {
    use defmt::{info, warn};
    use nanospectra::sensor::{Flicker, Window};
    use nanospectra_firmware::pipeline::measure;
    use nanospectra_firmware::readings::{BREATH_HZ, RATE_HZ, RECORDING};
    use semihosting::process;

    #[nanospectra_firmware::entry]
    fn main() -> ! {
        let (mut lux, mut kelvins) = (Window::<5>::new(), Window::<5>::new());
        for counts in &RECORDING {
            match measure(counts) {
                Ok(color) => {
                    info!("{} lx, {}, {}", color.xyz.y, color.cct, color.lab);
                    lux.push(color.xyz.y);
                    if let Some((cct_k, _)) = color.cct.near() {
                        kelvins.push(cct_k);
                    }
                }
                Err(why) => {
                    warn!("{}", why);
                    lux.clear();
                    kelvins.clear();
                }
            }
            if let Some(flicker) = Flicker::of(lux.iter(), RATE_HZ, BREATH_HZ) {
                info!("    of the last five: {} K, {} % flicker", kelvins.median(), flicker.percent);
            }
        }
        process::exit(0)
    }
}
