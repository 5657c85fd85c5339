//! Writes the memory map of QEMU's board for the target, and passes the linker scripts.

use std::{env, error::Error, fs, path::Path};

/// The memory of MPS2 with the AN386 image, which has a Cortex-M4F.
const AN386: &str = "\
MEMORY {
  FLASH : ORIGIN = 0x00000000, LENGTH = 4M
  RAM : ORIGIN = 0x20000000, LENGTH = 4M
}
";

/// The memory of MPS2 with the AN505 image, which has a Cortex-M33, in its Secure state.
const AN505: &str = "\
MEMORY {
  FLASH : ORIGIN = 0x10000000, LENGTH = 4M
  RAM : ORIGIN = 0x38000000, LENGTH = 4M
}
";

/// The memory of the BBC micro:bit, whose nRF51822 has a Cortex-M0. It is that of the real part.
const MICROBIT: &str = "\
MEMORY {
  FLASH : ORIGIN = 0x00000000, LENGTH = 256K
  RAM : ORIGIN = 0x20000000, LENGTH = 16K
}
";

/// The memory of QEMU's RISC-V board `virt`. All of it is RAM, in two halves that stand for flash and RAM.
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
    // This is set for boards whose flash is too small for the largest tables.
    println!("cargo:rustc-check-cfg=cfg(small_flash)");
    let target = env::var("TARGET")?;
    let map = match target.split('-').next() {
        Some("thumbv7em") => AN386,
        Some("thumbv8m.main") => AN505,
        Some("thumbv6m") => {
            println!("cargo:rustc-cfg=small_flash");
            // An image that is linked but not run may be larger than the part.
            if env::var_os("CARGO_FEATURE_NO_PANIC").is_some() { AN386 } else { MICROBIT }
        }
        Some("riscv32imac") => VIRT,
        // On a host the linker needs no script from here.
        _ => return Ok(()),
    };
    let out = env::var("OUT_DIR")?;
    fs::write(Path::new(&out).join("memory.x"), map)?;
    println!("cargo:rustc-link-search={out}");
    // With --nmagic, small images need not start on a page boundary.
    let first = if target.starts_with("riscv32") { "-Tmemory.x" } else { "--nmagic" };
    for images in ["bins", "tests"] {
        println!("cargo:rustc-link-arg-{images}={first}");
        println!("cargo:rustc-link-arg-{images}=-Tlink.x");
    }
    // With this script the texts of the log stay in the file and out of flash.
    if env::var_os("CARGO_FEATURE_INSTRUMENT").is_some() {
        println!("cargo:rustc-link-arg-bin=sensor=-Tdefmt.x");
    }
    Ok(())
}
