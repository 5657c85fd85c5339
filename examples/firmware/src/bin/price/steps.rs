//! Prints what each step of a reading costs, one `name number unit` per line: instructions and bytes of
//! stack, of the dearest of several inputs.
#![no_std]
#![no_main]

mod prices;

use nanospectra_firmware::clock::Clock;
use nanospectra_firmware::steps;
use prices::Prices;
use semihosting::process;

#[nanospectra_firmware::entry]
fn main() -> ! {
    steps::all(&mut Prices(Clock::start()));
    process::exit(0)
}
