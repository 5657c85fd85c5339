//! Reports one hash for each group of results, as the firmware image `bits` prints them.

unsafe extern "C" {
    /// Takes the hash of one group of results, and its UTF-8 name by address and length in this module's
    /// memory.
    safe fn report(name: *const u8, length: usize, hash: u32);
}

/// Reports every hash.
#[unsafe(no_mangle)]
pub extern "C" fn bits() {
    let mut line = |group: &str, hash: u32| report(group.as_ptr(), group.len(), hash);
    nanospectra_bits::run(&mut line);
    nanospectra_bits::run_large(&mut line);
}
