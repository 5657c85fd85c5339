//! Constants made from the files in `tables/upsample`; `tests/upsample/tables.rs` makes these files.

include!(concat!(env!("OUT_DIR"), "/upsample.rs"));
