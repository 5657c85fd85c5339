//! Prints one hash for each group of results. On a host (`cargo run --bin bits`) it prints the hashes that
//! every device must print, too.
#![cfg_attr(target_os = "none", no_std, no_main)]

use nanospectra_firmware::bits;
#[cfg(target_os = "none")]
use semihosting::{println, process};

#[cfg(not(target_os = "none"))]
fn main() {
    print();
}

#[cfg(target_os = "none")]
#[nanospectra_firmware::entry]
fn main() -> ! {
    print();
    process::exit(0)
}

fn print() {
    let mut line = |group: &str, hash: u32| println!("{group} {hash:08x}");
    bits::run(&mut line);
    if cfg!(not(small_flash)) {
        bits::run_large(&mut line);
    }
}
