//! Calls every run-time step of a sensor in one image, which does not link if one of them can panic, as
//! `no_panic` does for the rest of the crate. `tests/devices.sh` links it for every core and checks that it
//! has no software f64 and no 1 nm table.
#![no_std]
#![no_main]

mod without_panic;

use core::hint::black_box;
use nanospectra::Light;
use nanospectra::observer::{CIE_1931, Curve, Observer};
use nanospectra::sensor::{
    AutoExposure, BasicCounts, Calibration, DarkCounts, Drift, FirstPixel, Fit, Flicker, Noise,
    PixelWavelengths, Reconstruction, Window, above_dark_pixels, amplitude_at, chip::as7341,
    mean_over_periods, nonnegative_spectrum,
};
use nanospectra::{Nodes, Power};
use nanospectra_firmware::pipeline::measure;

type TenNm = Nodes<400, 700>;
static CHIP: Observer<8, 31, Power, TenNm> = as7341::NOMINAL.fold(Curve::Step);
static EYE: Observer<3, 31, Power, TenNm> = CIE_1931.fold(Curve::Step);

#[nanospectra_firmware::entry]
fn main() -> ! {
    loop {
        let _ = black_box(measure(&black_box([1000; 8])));
        let basic = readings();
        calibrations(&basic);
        spectra(&basic);
        time();
    }
}

fn readings() -> BasicCounts<8> {
    let (counts, wide): ([u16; 8], [u32; 8]) = black_box(([1000; 8], [70_000; 8]));
    let mut exposure = as7341::exposure(black_box(16.0), 29, 599);
    if let Ok(exposures) = AutoExposure::new(&as7341::LADDER) {
        exposure = exposures.exposure(black_box(exposures.advise(black_box(3), &counts)).next);
    }
    let dark =
        black_box(DarkCounts { offset: [1.0; 8], rate: [0.1; 8], measured_at_c: 25.0, doubles_every_k: 8.0 });
    let levels = dark.levels_at_with::<nanospectra::math::Fast>(&exposure, black_box(40.0));
    let drift = black_box(Drift { per_k: [1e-3; 8], calibrated_at_c: 25.0 });
    let _ = black_box(exposure.basic_counts(&wide));
    let basic = exposure.basic_counts_above(&levels, &counts).unwrap_or(BasicCounts::new([1.0; 8]));
    basic.without(&drift, black_box(40.0)).scaled(&black_box([1.1; 8]))
}

fn calibrations(basic: &BasicCounts<8>) {
    let mut fit = Fit::<8>::new();
    for target in black_box([[95.0, 100.0, 108.0]; 12]) {
        fit.add(&black_box(*basic), target, black_box(1.0));
    }
    let to_xyz = black_box(fit.solve()).unwrap_or(Calibration::from_rows([[1.0; 8]; 3]));
    black_box((fit.residual_rms(), fit.patches(), fit.condition().ok()));
    black_box(fit.leave_one_out(&black_box(BasicCounts::new([1.0; 8])), black_box([1.0; 3]), 1.0).ok());
    if let Ok(wavelengths) =
        PixelWavelengths::<288>::new(black_box([310.0, 2.7, 1e-4, 0.0, 0.0, 0.0]), FirstPixel::One)
    {
        let pixels = above_dark_pixels(&black_box([100_u16; 288]), black_box(0..10)).unwrap_or([0.0; 288]);
        black_box(wavelengths.rebinned::<41, Nodes<380, 780>>(&pixels).counts.density());
    }
    let to_xyz = to_xyz.without_crosstalk(&black_box([[0.1; 8]; 8])).unwrap_or(to_xyz);
    let to_xyz = to_xyz.behind_glass(black_box(0.9)).corrected(&black_box([1.0; 8]));
    let noise = black_box(Noise { electrons_per_count: 20.0, read_counts: 2.0 });
    let exposure = black_box(as7341::exposure(16.0, 29, 599));
    let covariance = to_xyz.covariance(&noise.variances(&exposure, &black_box([1000_u16; 8])));
    if let Ok(xyz) = to_xyz.xyz(basic) {
        black_box((covariance.uncertainty(), covariance.cct(xyz)));
    }
}

fn spectra(basic: &BasicCounts<8>) {
    if let Ok(smooth) = Reconstruction::smooth(&CHIP, black_box(0.95), black_box(0.01)) {
        let light: Light<31, TenNm> = smooth.spectrum(basic);
        black_box((light, smooth.seen_by(&EYE)));
    }
    let _ = black_box(nonnegative_spectrum(&CHIP, basic, black_box(0.01), black_box(30)));
}

fn time() {
    let mut window = Window::<9>::new();
    for reading in black_box([1.0; 12]) {
        window.push(reading);
    }
    let (rate, hz) = black_box((1000.0, 100.0));
    black_box((window.median(), window.mean(), Flicker::of(window.iter(), rate, hz)));
    black_box((mean_over_periods(window.iter(), rate, hz), amplitude_at(window.iter(), rate, hz)));
    black_box(as7341::exposure(black_box(16.0), 29, 599).residual_modulation(hz));
}
