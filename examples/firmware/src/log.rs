//! The logger of `defmt`, which writes to the standard output of the emulator or debugger, on Arm and RISC-V
//! alike. The crate `defmt-semihosting` would also need a critical section, but these images have one thread
//! and no interrupts.

use core::cell::RefCell;
use defmt::{Encoder, Logger};
use semihosting::io::{Stdout, Write, stdout};

#[defmt::global_logger]
struct Semihosting;

struct Channel {
    encoder: Encoder,
    output: Option<Stdout>,
}

struct OneThread(RefCell<Channel>);

// SAFETY: there is one core with one thread and no interrupts.
unsafe impl Sync for OneThread {}

static CHANNEL: OneThread = OneThread(RefCell::new(Channel { encoder: Encoder::new(), output: None }));

/// Gives the encoder to `f` and writes what it encodes to the output.
fn encode(f: impl FnOnce(&mut Encoder, &mut dyn FnMut(&[u8]))) {
    // (It is always free, since `f` never calls this function.)
    let Ok(mut channel) = CHANNEL.0.try_borrow_mut() else { return };
    let Channel { encoder, output } = &mut *channel;
    if output.is_none() {
        *output = stdout().ok();
    }
    f(encoder, &mut |bytes| {
        // If the log cannot be written it is lost, and the measurement goes on.
        let _ = output.as_mut().map(|output| output.write_all(bytes));
    });
}

// SAFETY: `defmt` calls `write` and `release` only after `acquire`, and nothing else calls them.
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
