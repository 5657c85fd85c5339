//! Constants made from the files in `tables/upsample`; `tests/upsample_fit.rs` makes these files.

include!(concat!(env!("OUT_DIR"), "/upsample.rs"));
