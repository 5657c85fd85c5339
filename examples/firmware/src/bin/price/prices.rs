//! Prints the instructions and the bytes of stack of a step as lines `name number unit`, for the input with
//! the highest cost. It is a module of the images that print and not of the library that they share, since
//! the panic handler of `semihosting` links.

use nanospectra_firmware::clock::Clock;
use nanospectra_firmware::{stack, steps};
use semihosting::println;

pub struct Prices(pub Clock);

impl steps::Meter for Prices {
    // Its results are on the stack only while it runs.
    #[inline(never)]
    fn step<A, R: Default>(&mut self, name: &str, f: fn(&A, &mut R), inputs: &[A]) {
        let (mut instructions, mut bytes) = (0, 0);
        for input in inputs {
            instructions = self.0.count(f, input, &mut R::default()).max(instructions);
            let needed = stack::needs(f, input, &mut R::default());
            bytes = needed.unwrap_or_else(|| panic!("{name}: more stack than can be measured")).max(bytes);
        }
        println!("{name} {instructions} instructions");
        println!("{name} {bytes} stack-bytes");
    }
}
