//! Calls every public function of the library in one image, which does not link if one of them can panic.
//!
//! `tests/devices.sh` links it and looks for what is costly. Those that compute in f64 are in `constants`, an
//! image of its own. `cargo xtask check --only "every public function"` compares both with the documentation.
//! A new function takes one line in `of`, where it is named by its path.
#![no_std]
#![no_main]

#[path = "no_panic/call.rs"]
mod call;
#[path = "no_panic/of/mod.rs"]
mod of;
mod without_panic;

#[nanospectra_firmware::entry]
fn main() -> ! {
    loop {
        of::all();
    }
}
