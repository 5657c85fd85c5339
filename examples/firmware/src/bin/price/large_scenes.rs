//! Prints the cost of the large calls of `large::scenes` as lines `name number unit`, as `price` does for the
//! steps of a reading.
#![no_std]
#![no_main]

mod prices;

use nanospectra_firmware::clock::Clock;
use nanospectra_firmware::large::scenes;
use prices::Prices;
use semihosting::process;

#[nanospectra_firmware::entry]
fn main() -> ! {
    scenes::all(&mut Prices(Clock::start()));
    process::exit(0)
}
