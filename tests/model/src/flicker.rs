//! The stroboscopic visibility measure of IEC TR 63158, by the discrete Fourier transform as it is defined.

/// How much a sine has to swing, as a part of the mean, to be just visible.
pub fn threshold(hz: f64) -> f64 {
    1.0 / (1.0 + (-0.00518 * (hz - 306.6)).exp()) + 20.0 * (-hz / 10.0).exp()
}

/// Of readings that hold whole periods: every frequency of the transform counts, up to 2000 Hz.
pub fn svm(readings: &[f64], rate_hz: f64) -> f64 {
    let count = readings.len() as f64;
    let mean = readings.iter().sum::<f64>() / count;
    // The sine and the cosine of each part of a turn.
    let parts: Vec<(f64, f64)> =
        (0..readings.len()).map(|k| (std::f64::consts::TAU * k as f64 / count).sin_cos()).collect();
    let mut sum = 0.0;
    for bin in 1..readings.len().div_ceil(2) {
        let hz = rate_hz * bin as f64 / count;
        if hz > 2000.0 {
            break;
        }
        let (mut re, mut im) = (0.0, 0.0);
        for (k, value) in readings.iter().enumerate() {
            let (sin, cos) = parts[bin * k % readings.len()];
            re += value * cos;
            im += value * sin;
        }
        let swing = 2.0 * re.hypot(im) / count / mean;
        sum += (swing / threshold(hz)).powf(3.7);
    }
    sum.powf(1.0 / 3.7)
}
