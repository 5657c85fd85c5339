//! Counts the instructions of a call. The counts are exact under QEMU with `-icount` (see run.sh), where each
//! instruction takes the same time.

use core::arch::asm;
use core::hint::black_box;
use core::mem::transmute;

/// A counter of instructions, which measures its own rate and overhead when it is started.
pub struct Clock {
    per_1000: u32,
    empty: u32,
}

impl Clock {
    /// Starts the counter and calibrates it by 1000 nops for its rate and by an empty call for the overhead.
    pub fn start() -> Self {
        counter::start();
        let none = span(nothing, &(), &mut ());
        let nops = span(thousand_nops, &(), &mut ());
        Clock { per_1000: nops.wrapping_sub(none), empty: none }
    }

    /// Returns the instructions that `f` takes to get from `input` to `output`, which are both in memory.
    ///
    /// The cost of the call itself (passing two addresses, branching there and back, reading the counter) is
    /// measured with a function that does nothing, and subtracted.
    pub fn count<A, R>(&self, f: fn(&A, &mut R), input: &A, output: &mut R) -> u32 {
        let periods = u64::from(span(f, input, output).wrapping_sub(self.empty));
        let per_1000 = u64::from(self.per_1000.max(1));
        ((periods * 1000 + per_1000 / 2) / per_1000) as u32
    }

    /// Returns the instructions of the longest call over all inputs. The inputs go through a `black_box`, so
    /// the compiler cannot use their values.
    pub fn longest<A, R: Default>(&self, f: fn(&A, &mut R), inputs: &[A]) -> u32 {
        inputs.iter().map(|input| self.count(f, input, &mut R::default())).max().unwrap_or(0)
    }
}

/// Returns the counter periods of one call.
fn span<A, R>(f: fn(&A, &mut R), input: &A, output: &mut R) -> u32 {
    erased(erase(f), (&raw const *input).cast(), (&raw mut *output).cast())
}

/// A function without the types of its parameters, which is called with pointers to them.
pub(crate) type Erased = fn(*const (), *mut ());

pub(crate) fn erase<A, R>(f: fn(&A, &mut R)) -> Erased {
    // SAFETY: a reference to a sized value and a raw pointer have the same ABI, and callers pass pointers to
    // the types that `f` takes.
    unsafe { transmute::<fn(&A, &mut R), Erased>(f) }
}

/// Calls a function and returns the counter periods. All measured calls go through this one piece of code, so
/// that all have the same overhead.
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

/// The counter on Arm is SysTick, which has 24 bits and counts down with the core's clock. It can measure up
/// to 650 000 instructions.
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

/// The counter on RISC-V is `minstret`. QEMU lets it count virtual nanoseconds, which the calibration takes
/// into account.
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
