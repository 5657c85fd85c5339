//! Prints what a whole reading costs, as `price` does for its steps. An image of its own: where two functions
//! share a step, the compiler calls it, and here nothing is shared, as in an instrument.
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
