//! The panic handler of an image that does not link if a panic can be reached. It is a module of the images
//! and not of the library that they share, since most of them are measured to the byte without that library.

unsafe extern "C" {
    /// A function that is defined nowhere, so that linking fails if it is called.
    safe fn this_image_can_panic() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    this_image_can_panic()
}
