//! What a spectrum means: chromaticity, colour temperature, colour spaces, differences, rendering.

mod cct;
mod differences;
mod rendering;
mod rgb_and_adaptation;
mod spaces;
mod textbook_slips;
mod transfer;
