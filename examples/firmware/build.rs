//! The memory map and linker scripts that go with the target: QEMU's boards, one per target.

use std::{env, error::Error, fs, path::Path};

/// MPS2 with the AN386 image: a Cortex-M4F.
const AN386: &str = "\
MEMORY {
  FLASH : ORIGIN = 0x00000000, LENGTH = 4M
  RAM : ORIGIN = 0x20000000, LENGTH = 4M
}
";

/// BBC micro:bit, nRF51822: a Cortex-M0 with what the real part has.
const MICROBIT: &str = "\
MEMORY {
  FLASH : ORIGIN = 0x00000000, LENGTH = 256K
  RAM : ORIGIN = 0x20000000, LENGTH = 16K
}
";

/// QEMU's RISC-V `virt`: everything in RAM, in two halves so that flash and RAM stay apart in the map.
const VIRT: &str = "\
MEMORY {
  FLASH : ORIGIN = 0x80000000, LENGTH = 4M
  RAM : ORIGIN = 0x80400000, LENGTH = 4M
}
REGION_ALIAS(\"REGION_TEXT\", FLASH);
REGION_ALIAS(\"REGION_RODATA\", FLASH);
REGION_ALIAS(\"REGION_DATA\", RAM);
REGION_ALIAS(\"REGION_BSS\", RAM);
REGION_ALIAS(\"REGION_HEAP\", RAM);
REGION_ALIAS(\"REGION_STACK\", RAM);
";

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo:rerun-if-changed=build.rs");
    // Set where the largest tables do not fit.
    println!("cargo:rustc-check-cfg=cfg(small_flash)");
    let target = env::var("TARGET")?;
    let map = match target.split('-').next() {
        Some("thumbv7em") => AN386,
        Some("thumbv6m") => {
            println!("cargo:rustc-cfg=small_flash");
            MICROBIT
        }
        Some("riscv32imac") => VIRT,
        // A host builds `bits` only, with its own linker.
        _ => return Ok(()),
    };
    let out = env::var("OUT_DIR")?;
    fs::write(Path::new(&out).join("memory.x"), map)?;
    println!("cargo:rustc-link-search={out}");
    if target.starts_with("riscv32") {
        println!("cargo:rustc-link-arg-bins=-Tmemory.x");
    } else {
        // Small images start on no page boundary.
        println!("cargo:rustc-link-arg-bins=--nmagic");
    }
    println!("cargo:rustc-link-arg-bins=-Tlink.x");
    Ok(())
}
