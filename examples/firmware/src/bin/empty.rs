//! A program that takes 16 bands and makes three numbers of them without computing a color. It is compared
//! with `fold16` to find how many bytes XYZ takes.
#![no_std]
#![no_main]

use core::hint::black_box;

#[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
#[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
fn main() -> ! {
    loop {
        let bands: [f32; 16] = black_box([0.5; 16]);
        black_box([bands[0], bands[1], bands[2]]);
    }
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {
        core::hint::spin_loop();
    }
}
