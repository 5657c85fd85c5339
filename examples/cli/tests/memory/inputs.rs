//! Inputs of any size.

const CHANNELS: &str = "f1,f2,f3,f4,f5,f6,f7,f8";
const SETTINGS: &str = "gain,atime,astep";

/// A matrix for a sensor with two channels.
pub const CALIBRATION: &str = "row,a,b\nX,1,2\nY,2,1\nZ,1,1\n";
/// A log of that sensor, with an exposure that every log of [`dark_readings`] has.
pub const DARK_LOG: &str = "gain,time_ms,full_scale,a,b\n1,1,1000,100,200\n";

fn counts(k: usize) -> String {
    (0..8).map(|channel| (500 + (k * 37 + channel * 101) % 4000).to_string()).collect::<Vec<_>>().join(",")
}

/// Readings with a time, without a label: one run.
pub fn one_run(rows: usize) -> String {
    let row = |k| format!("{}.{:03},8,29,599,{}\n", k / 1000, k % 1000, counts(k));
    format!("time,{SETTINGS},{CHANNELS}\n{}", (0..rows).map(row).collect::<String>())
}

pub fn readings(rows: usize) -> String {
    let row = |k| format!("8,29,599,{}\n", counts(k));
    format!("{SETTINGS},{CHANNELS}\n{}", (0..rows).map(row).collect::<String>())
}

/// Readings of which two at a time have a label of their own.
pub fn short_runs(rows: usize) -> String {
    let row = |k| format!("{k},lamp {},8,29,599,{}\n", k / 2, counts(k));
    format!("time,label,{SETTINGS},{CHANNELS}\n{}", (0..rows).map(row).collect::<String>())
}

pub fn wide_readings(rows: usize) -> String {
    let unused: String = (0..500).map(|k| format!(",unused{k}")).collect();
    let ones = ",1".repeat(500);
    let row = |k| format!("8,29,599,{}{ones}\n", counts(k));
    format!("{SETTINGS},{CHANNELS}{unused}\n{}", (0..rows).map(row).collect::<String>())
}

/// One reading, beside columns that are not used.
pub fn columns_of_a_log(columns: usize) -> String {
    let unused: String = (0..columns).map(|k| format!(",unused{k}")).collect();
    format!("{SETTINGS},{CHANNELS}{unused}\n8,29,599,{}{}\n", counts(0), ",1".repeat(columns))
}

/// Readings of the dark, each at an exposure of its own.
pub fn dark_readings(rows: usize) -> String {
    let row = |k| format!("{},1,1000,5,5\n", k + 1);
    format!("gain,time_ms,full_scale,a,b\n{}", (0..rows).map(row).collect::<String>())
}

fn table(names: &str, columns: usize) -> String {
    let row = |nm| format!("{nm}{}\n", ",0.5".repeat(columns));
    format!("nm{names}\n{}", (380..=780).step_by(10).map(row).collect::<String>())
}

/// A spectrum of many wavelengths, in rows of 15 bytes.
pub fn rows(rows: usize) -> String {
    let row = |k: usize| format!("{:08.4},{:.3}\n", 400.0 + k as f64 / 1000.0, 0.5 + (k % 17) as f64 / 100.0);
    format!("nm,lamp\n{}", (0..rows).map(row).collect::<String>())
}

/// A spectrum in each row.
pub fn transposed(spectra: usize) -> String {
    let heading: String = (380..=780).step_by(10).map(|nm| format!(",{nm}")).collect();
    let row = |k| format!("lamp {k}{}\n", ",0.5".repeat(41));
    format!("name{heading}\n{}", (0..spectra).map(row).collect::<String>())
}

/// Spectra at 41 wavelengths.
pub fn columns(columns: usize) -> String {
    table(&(0..columns).map(|k| format!(",lamp {k}")).collect::<String>(), columns)
}

pub fn columns_of_one_name(columns: usize) -> String {
    table(&",lamp".repeat(columns), columns)
}

pub fn colors(lines: usize) -> String {
    (0..lines).map(|k| format!("0.{},0.{},0.{}\n", 1 + k % 8, 1 + k / 8 % 8, 1 + k / 64 % 8)).collect()
}

pub fn waveform(readings: usize) -> String {
    (0..readings).map(|k| format!("{}\n", 2000 + k % 17)).collect()
}
