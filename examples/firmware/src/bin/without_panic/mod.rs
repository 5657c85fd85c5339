//! The panic handler of an image that does not link if a panic can be reached. (Part of the images, since
//! most of them are measured to the byte without the library of images.)

unsafe extern "C" {
    /// Defined nowhere.
    safe fn this_image_can_panic() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    this_image_can_panic()
}
