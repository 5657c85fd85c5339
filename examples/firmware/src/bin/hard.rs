//! Prints the bits of every hard case, of the naive form and of the crate's: `row input naive ours`. Where
//! there is an FPU all of it follows again, after a line `flush-to-zero`, as it is where subnormal numbers
//! count as zero.
#![no_std]
#![no_main]

use core::fmt::{self, Display, Formatter};
use core::hint::black_box;
use nanospectra_hard::cases::{self, Cases};
use semihosting::{println, process};

#[nanospectra_firmware::entry]
fn main() -> ! {
    run();
    #[cfg(target_abi = "eabihf")]
    {
        println!("flush-to-zero");
        flush_to_zero();
        run();
    }
    process::exit(0)
}

/// Off at reset.
#[cfg(target_abi = "eabihf")]
fn flush_to_zero() {
    let mut control = cortex_m::register::fpscr::read();
    control.set_fz(true);
    // SAFETY: the bit changes what arithmetic gives, and no code here relies on subnormal numbers.
    unsafe { cortex_m::register::fpscr::write(control) };
}

/// Not inlined: arithmetic must not move to the other side of the write to the control register.
#[inline(never)]
fn run() {
    cases::all(&mut Printer);
}

struct Printer;

impl Cases for Printer {
    fn row<const A: usize, const K: usize>(
        &mut self,
        row: &str,
        inputs: &[[f32; A]],
        naive: fn(&[f32; A]) -> [f32; K],
        ours: fn(&[f32; A]) -> [f32; K],
    ) {
        for (k, input) in inputs.iter().enumerate() {
            // Nothing may be computed by the compiler.
            let input = black_box(input);
            println!("{row} {k} {} {}", Bits(black_box(naive)(input)), Bits(black_box(ours)(input)));
        }
    }
}

struct Bits<const K: usize>([f32; K]);

impl<const K: usize> Display for Bits<K> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        for (k, number) in self.0.iter().enumerate() {
            let comma = if k > 0 { "," } else { "" };
            write!(f, "{comma}{:08x}", number.to_bits())?;
        }
        Ok(())
    }
}
