//! nanospectra as WebAssembly modules, with plain exports over fixed memory and without an allocator or
//! generated glue code.
//!
//! Each feature makes a module of its own, which `tools/build.mjs` builds: `light`, `paint`, `scene`, `core`
//! and `bands` for the package; `cost` and `bench` for tests; `lists` for the build; and `bits` for
//! `tests/devices.sh`. JavaScript writes numbers into the buffers of [`board`], calls a function and reads
//! numbers from a buffer. That JavaScript begins in `package/nanospectra.js`.
#![no_std]

#[cfg(feature = "bands")]
mod bands;
#[cfg(feature = "bits")]
mod bit_check;
#[cfg(not(any(feature = "bits", feature = "bands", feature = "lists")))]
mod board;
#[cfg(feature = "cost")]
mod cost;
#[cfg(any(feature = "paint", feature = "scene"))]
mod display;
#[cfg(not(any(feature = "bits", feature = "lists")))]
mod fixed;
#[cfg(feature = "light")]
mod lamp;
#[cfg(feature = "lists")]
mod lists;
#[cfg(any(feature = "core", feature = "light"))]
mod measure;
#[cfg(any(feature = "core", feature = "paint"))]
mod paint;
#[cfg(feature = "scene")]
mod scene;
#[cfg(feature = "light")]
mod surface;

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    core::arch::wasm32::unreachable()
}
