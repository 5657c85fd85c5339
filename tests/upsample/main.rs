//! From RGB to spectra.

mod all;
mod digits;
mod displays;
mod fit;
mod properties;
mod single_colors;
mod tables;
