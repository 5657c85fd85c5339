//! Planck's law in f64.

pub const H: f64 = 6.626_070_15e-34;
pub const C: f64 = 299_792_458.0;
pub const K: f64 = 1.380_649e-23;
/// Second radiation constant of colorimetry (ITS-90), m K.
pub const C2_CIE: f64 = 1.4388e-2;
/// Second radiation constant of CODATA 2018, m K.
pub const C2_CODATA: f64 = H * C / K;
/// First radiation constant 2 pi h c^2, W m^2.
pub const C1: f64 = 2.0 * std::f64::consts::PI * H * C * C;

/// Relative spectral power of a Planckian radiator as colorimetry has it: lambda^-5 / (e^x - 1),
/// wavelength in units of 560 nm.
pub fn relative(nm: f64, kelvin: f64, c2: f64) -> f64 {
    (560.0 / nm).powi(5) / (c2 / (nm * 1e-9 * kelvin)).exp_m1()
}

/// A Planckian radiator at 360, 361, ..., 830 nm.
pub fn on_cie_grid(kelvin: f64) -> Vec<f64> {
    (360..=830).map(|nm| relative(f64::from(nm), kelvin, C2_CIE)).collect()
}

/// x = c2 / (lambda T), the only number Planck's curve depends on.
pub fn x(nm: f64, kelvin: f64) -> f64 {
    C2_CODATA / (nm * 1e-9 * kelvin)
}

/// Spectral radiance, W sr^-1 m^-3.
pub fn radiance(nm: f64, kelvin: f64) -> f64 {
    C1 / std::f64::consts::PI / (nm * 1e-9).powi(5) / x(nm, kelvin).exp_m1()
}

/// Spectral radiance with c1 = 3.741771e-16 and c2 = 1.4388e-2.
pub fn radiance_cie(nm: f64, kelvin: f64) -> f64 {
    let wavelength = nm * 1e-9;
    3.741771e-16 / std::f64::consts::PI / wavelength.powi(5) / (C2_CIE / (wavelength * kelvin)).exp_m1()
}

/// ln of the spectral radiance, finite where the radiance itself underflows.
pub fn ln_radiance(nm: f64, kelvin: f64) -> f64 {
    let x = x(nm, kelvin);
    let ln_expm1 = if x > 1.0 { x + (-(-x).exp()).ln_1p() } else { x.exp_m1().ln() };
    (C1 / std::f64::consts::PI).ln() - 5.0 * (nm * 1e-9).ln() - ln_expm1
}

/// Spectral photon radiance, s^-1 sr^-1 m^-3.
pub fn photon_radiance(nm: f64, kelvin: f64) -> f64 {
    2.0 * C / (nm * 1e-9).powi(4) / x(nm, kelvin).exp_m1()
}

/// dB/dT, W sr^-1 m^-3 K^-1.
pub fn radiance_per_kelvin(nm: f64, kelvin: f64) -> f64 {
    let x = x(nm, kelvin);
    radiance(nm, kelvin) * x / kelvin / -(-x).exp_m1()
}

/// Radiance per frequency, W sr^-1 m^-2 Hz^-1.
pub fn radiance_per_hertz(nm: f64, kelvin: f64) -> f64 {
    2.0 * H * C / (nm * 1e-9).powi(3) / x(nm, kelvin).exp_m1()
}

/// Stefan-Boltzmann constant, W m^-2 K^-4.
pub fn stefan_boltzmann() -> f64 {
    2.0 * std::f64::consts::PI.powi(5) * K.powi(4) / (15.0 * H.powi(3) * C * C)
}

/// x at the peak of x^n / (e^x - 1), the root of n (1 - e^-x) = x: n = 5 for the peak per
/// wavelength, 3 per frequency, 4 for photons per wavelength.
pub fn peak_x(n: f64) -> f64 {
    (0..200).fold(n, |x, _| -n * (-x).exp_m1())
}

/// Fraction of the total radiance between two wavelengths in nm, by the series in e^-nx.
pub fn fraction(from_nm: f64, to_nm: f64, kelvin: f64) -> f64 {
    let (near, far) = (x(to_nm, kelvin), x(from_nm, kelvin));
    let mut sum = 0.0;
    // the terms of a hot, long-wave band fall off slowly: go on until e^-nx is nothing
    let terms = (40.0 / near).ceil() as u32 + 1;
    for n in 1..=terms {
        let n = f64::from(n);
        let term =
            |x: f64| (-n * x).exp() / n * (x * x * x + 3.0 * x * x / n + 6.0 * x / (n * n) + 6.0 / n.powi(3));
        sum += term(near) - term(far);
    }
    15.0 / std::f64::consts::PI.powi(4) * sum
}
