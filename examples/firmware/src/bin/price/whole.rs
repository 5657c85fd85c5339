//! Prints the cost of a whole reading, as `price` does for its steps. It is an image of its own because the
//! compiler calls a step that two functions share, and in an instrument nothing is shared.
#![no_std]
#![no_main]

mod prices;

use nanospectra_firmware::clock::Clock;
use nanospectra_firmware::steps;
use prices::Prices;
use semihosting::process;

#[nanospectra_firmware::entry]
fn main() -> ! {
    steps::whole(&mut Prices(Clock::start()));
    process::exit(0)
}
