//! Counts instructions: exact under QEMU with `-icount` (see run.sh), where time is nothing but instructions.

use core::arch::asm;
use core::hint::black_box;
use core::mem::transmute;

/// Counter periods per 1000 instructions, measured.
pub struct Clock {
    per_1000: u32,
    empty: u32,
}

impl Clock {
    /// Starts the counter and calibrates it: 1000 nops for its rate, an empty call for the overhead.
    pub fn start() -> Self {
        counter::start();
        let none = span(nothing, &(), &mut ());
        let nops = span(thousand_nops, &(), &mut ());
        Clock { per_1000: nops.wrapping_sub(none), empty: none }
    }

    /// Instructions that `f` takes to get from `input` to `output`, both in memory.
    ///
    /// What a call costs in itself (passing two addresses, branching there and back, reading the counter) is
    /// taken off, as measured with a function that does nothing.
    pub fn count<A, R>(&self, f: fn(&A, &mut R), input: &A, output: &mut R) -> u32 {
        let periods = u64::from(span(f, input, output).wrapping_sub(self.empty));
        let per_1000 = u64::from(self.per_1000.max(1));
        ((periods * 1000 + per_1000 / 2) / per_1000) as u32
    }

    /// Instructions of the longest of the calls. (`inputs` go through a `black_box`, so the compiler knows
    /// nothing of them.)
    pub fn longest<A, R: Default>(&self, f: fn(&A, &mut R), inputs: &[A]) -> u32 {
        inputs.iter().map(|input| self.count(f, input, &mut R::default())).max().unwrap_or(0)
    }
}

/// Counter periods of one call.
fn span<A, R>(f: fn(&A, &mut R), input: &A, output: &mut R) -> u32 {
    erased(erase(f), (&raw const *input).cast(), (&raw mut *output).cast())
}

/// A function that has forgotten its types, to be called with pointers to what it takes.
pub(crate) type Erased = fn(*const (), *mut ());

pub(crate) fn erase<A, R>(f: fn(&A, &mut R)) -> Erased {
    // SAFETY: a reference to a sized value and a raw pointer have the same ABI; who calls it hands over the
    // two that `f` takes.
    unsafe { transmute::<fn(&A, &mut R), Erased>(f) }
}

/// One piece of code for every call that is measured, so that all have the same overhead.
#[inline(never)]
fn erased(f: Erased, input: *const (), output: *mut ()) -> u32 {
    let (f, input) = black_box((f, input));
    let start = counter::now();
    f(input, output);
    let end = counter::now();
    counter::between(start, end)
}

#[inline(never)]
fn nothing(_: &(), _: &mut ()) {}

#[inline(never)]
fn thousand_nops(_: &(), _: &mut ()) {
    // SAFETY: nops touch nothing.
    unsafe { asm!(".rept 1000", "nop", ".endr", options(nomem, nostack, preserves_flags)) }
}

/// SysTick: 24 bits, counts down with the core's clock; spans of up to 650 000 instructions.
#[cfg(target_arch = "arm")]
mod counter {
    use cortex_m::Peripherals;
    use cortex_m::peripheral::{SYST, syst::SystClkSource};

    const BITS: u32 = 0x00ff_ffff;

    pub fn start() {
        // SAFETY: nothing else in these images touches a peripheral.
        let mut systick = unsafe { Peripherals::steal() }.SYST;
        systick.set_clock_source(SystClkSource::Core);
        systick.set_reload(BITS);
        systick.clear_current();
        systick.enable_counter();
    }

    #[inline(always)]
    pub fn now() -> u32 {
        SYST::get_current()
    }

    pub fn between(start: u32, end: u32) -> u32 {
        start.wrapping_sub(end) & BITS
    }
}

/// `minstret`, of which QEMU makes virtual nanoseconds; the calibration does not mind.
#[cfg(target_arch = "riscv32")]
mod counter {
    pub fn start() {}

    #[inline(always)]
    pub fn now() -> u32 {
        riscv::register::minstret::read() as u32
    }

    pub fn between(start: u32, end: u32) -> u32 {
        end.wrapping_sub(start)
    }
}
