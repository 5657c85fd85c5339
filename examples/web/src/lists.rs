//! The names that the library lists, of which `tools/lists.mjs` makes JavaScript. This module is not in the
//! package.

use nanospectra::{light, observer};

/// Returns item `index` of a list, or an empty text behind the last. List 0 has the names of illuminants, 1
/// has one text with them for messages, 2 the names of observers, and the others their titles.
fn item(list: u32, index: u32) -> &'static str {
    let index = index as usize;
    let observer = observer::ALL.get(index);
    let item = match list {
        0 => light::NAMES.get(index).copied(),
        1 => (index == 0).then_some(light::NAMES_IN_BRIEF),
        2 => observer.map(|observer| observer.name),
        _ => observer.map(|observer| observer.title),
    };
    item.unwrap_or("")
}

#[unsafe(no_mangle)]
extern "C" fn text(list: u32, index: u32) -> *const u8 {
    item(list, index).as_ptr()
}

#[unsafe(no_mangle)]
extern "C" fn length(list: u32, index: u32) -> usize {
    item(list, index).len()
}
