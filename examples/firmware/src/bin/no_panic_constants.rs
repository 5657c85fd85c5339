//! Calls the functions that compute in f64, most of which are meant for constants, in one image.
//!
//! Like `no_panic`, which has all others, it does not link if one of them can panic.
#![no_std]
#![no_main]

#[path = "no_panic/call.rs"]
mod call;
#[path = "no_panic/constants.rs"]
mod constants;
mod without_panic;

#[nanospectra_firmware::entry]
fn main() -> ! {
    loop {
        constants::all();
    }
}
