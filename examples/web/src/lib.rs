//! nanospectra as wasm modules: plain exports over fixed memory, no allocator, no glue code.
//!
//! Each feature is a module of its own (`tools/build.mjs` builds them): `light`, `paint`, `scene`, `core`,
//! `bands`, `cost`, `lists` for the build, and `bits` for `tests/devices.sh`. JavaScript writes numbers into
//! the buffers of [`board`], calls a function, and reads numbers from a buffer; `package/nanospectra.js` is
//! that JavaScript.
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
