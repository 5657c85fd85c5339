//! How silicon sees: from counts to colors.

mod as7341;
mod auto_exposure;
mod calibration;
mod chips;
mod fixed;
mod light_flickermeter;
mod linearity;
mod measures;
mod readings;
mod reconstruction;
mod sensor_bits;
mod spectrometer;
mod stroboscopic;
mod tables;
mod worst_chips;
mod worst_priors;
mod worst_readings;

use nanospectra::sensor::Calibration;

/// What a fit gives for the AS7341 (lux), negative weights and all.
const TO_XYZ: Calibration<8> = Calibration::from_rows([
    [2.283, 18.13, 2.785, 1.332, 14.85, 43.1, 23.85, -0.2993],
    [-0.5321, 2.728, 0.4422, 26.31, 40.98, 26.91, 9.224, -0.1845],
    [11.87, 86.97, 37.38, -2.114, 2.34, -1.107, 0.37, -0.09507],
]);
