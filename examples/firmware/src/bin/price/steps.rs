//! Prints the cost of each step of a reading as lines `name number unit`: instructions and bytes of stack,
//! for the input with the highest cost.
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
