//! The memory map and linker scripts that go with the target: QEMU's boards, one per target.

use std::{env, error::Error, fs, path::Path};

/// MPS2 with the AN386 image: a Cortex-M4F.
const AN386: &str = "\
MEMORY {
  FLASH : ORIGIN = 0x00000000, LENGTH = 4M
  RAM : ORIGIN = 0x20000000, LENGTH = 4M
}
";

/// MPS2 with the AN505 image: a Cortex-M33, in its Secure state.
const AN505: &str = "\
MEMORY {
  FLASH : ORIGIN = 0x10000000, LENGTH = 4M
  RAM : ORIGIN = 0x38000000, LENGTH = 4M
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
        Some("thumbv8m.main") => AN505,
        Some("thumbv6m") => {
            println!("cargo:rustc-cfg=small_flash");
            MICROBIT
        }
        Some("riscv32imac") => VIRT,
        // A host has a linker script of its own.
        _ => return Ok(()),
    };
    let out = env::var("OUT_DIR")?;
    fs::write(Path::new(&out).join("memory.x"), map)?;
    println!("cargo:rustc-link-search={out}");
    // Small images start on no page boundary.
    let first = if target.starts_with("riscv32") { "-Tmemory.x" } else { "--nmagic" };
    for images in ["bins", "tests"] {
        println!("cargo:rustc-link-arg-{images}={first}");
        println!("cargo:rustc-link-arg-{images}=-Tlink.x");
    }
    // The words of its log stay in the file and out of flash.
    if env::var_os("CARGO_FEATURE_INSTRUMENT").is_some() {
        println!("cargo:rustc-link-arg-bin=sensor=-Tdefmt.x");
    }
    Ok(())
}
