//! Where `defmt` writes: the standard output of whoever runs the emulator or holds the debugger, on Arm and
//! RISC-V alike. (`defmt-semihosting` wants a critical section as well; these images have one thread and no
//! interrupts.)

use core::cell::UnsafeCell;
use defmt::{Encoder, Logger};
use semihosting::io::{Stdout, Write, stdout};

#[defmt::global_logger]
struct Semihosting;

struct Channel {
    encoder: Encoder,
    output: Option<Stdout>,
}

struct OneThread(UnsafeCell<Channel>);

// SAFETY: one core, one thread, no interrupts.
unsafe impl Sync for OneThread {}

static CHANNEL: OneThread = OneThread(UnsafeCell::new(Channel { encoder: Encoder::new(), output: None }));

/// Hands the encoder to `f`, and what it encodes to the output.
fn encode(f: impl FnOnce(&mut Encoder, &mut dyn FnMut(&[u8]))) {
    // SAFETY: nothing that `f` does comes back here.
    let Channel { encoder, output } = unsafe { &mut *CHANNEL.0.get() };
    if output.is_none() {
        *output = stdout().ok();
    }
    f(encoder, &mut |bytes| {
        // A log that nobody takes is lost, and the measurement goes on.
        let _ = output.as_mut().map(|output| output.write_all(bytes));
    });
}

// SAFETY: `defmt` calls `write` and `release` after `acquire` only, and there is no one else to call it.
unsafe impl Logger for Semihosting {
    fn acquire() {
        encode(|encoder, output| encoder.start_frame(output));
    }

    unsafe fn flush() {}

    unsafe fn release() {
        encode(|encoder, output| encoder.end_frame(output));
    }

    unsafe fn write(bytes: &[u8]) {
        encode(|encoder, output| encoder.write(bytes, output));
    }
}
