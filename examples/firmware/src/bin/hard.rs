//! Prints the bits of the results of every hard case, as lines `row input naive ours`. With an FPU, a line
//! `flush-to-zero` follows, and then the same lines again with subnormal numbers flushed to zero.
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

/// Makes the FPU flush subnormal numbers to zero, which it does not do after a reset.
#[cfg(target_abi = "eabihf")]
fn flush_to_zero() {
    let mut control = cortex_m::register::fpscr::read();
    control.set_fz(true);
    // SAFETY: the bit changes the results of arithmetic, and no code here relies on subnormal numbers.
    unsafe { cortex_m::register::fpscr::write(control) };
}

/// Runs every case. This must not be inlined, or arithmetic could move across the write to the control
/// register.
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
            // The compiler must not compute any of this.
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
