//! One hash for each group of results, as the firmware image `bits` prints them.

unsafe extern "C" {
    /// Takes one result: a UTF-8 name (address and length in this module's memory) and its hash.
    safe fn report(name: *const u8, length: usize, hash: u32);
}

/// Tells the page every hash.
#[unsafe(no_mangle)]
pub extern "C" fn bits() {
    let mut line = |group: &str, hash: u32| report(group.as_ptr(), group.len(), hash);
    nanospectra_bits::run(&mut line);
    nanospectra_bits::run_large(&mut line);
}
