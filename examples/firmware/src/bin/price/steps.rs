//! Prints what each step of a reading costs, one `name number unit` per line: instructions and bytes of stack, of
//! the dearest of several inputs.
#![no_std]
#![no_main]

mod prices;

use nanospectra_firmware::clock::Clock;
use nanospectra_firmware::steps;
use prices::Prices;
use semihosting::process;

#[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
#[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
fn main() -> ! {
    steps::all(&mut Prices(Clock::start()));
    process::exit(0)
}
