//! How silicon sees: from counts to colours.

mod as7341;
mod auto_exposure;
mod calibration;
mod fixed;
mod linearity;
mod measures;
mod readings;
mod reconstruction;
mod spectrometer;
mod tables;
