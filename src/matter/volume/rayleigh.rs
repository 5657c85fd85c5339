//! Light scattered by air: the blue of the sky and the red of the evening.

/// Molecules in a m3 of dry air at 288.15 K and 101325 Pa, in units of 1e31 (Bodhaine et al. 1999).
const MOLECULES_1E31_PER_M3: f32 = 2.546_899e-6;

/// n - 1 of dry air with 300 ppm CO2, at 288.15 K and 101325 Pa, for `nm` 185..=2000 (vacuum).
///
/// # Accuracy
/// 2e-7, relative, beside the formula in f64.
///
/// # Reference
/// Peck and Reeder 1972, as quoted by Bodhaine et al. 1999, eq. 4.
#[must_use]
pub const fn air_refractivity(nm: f32) -> f32 {
    let per_um2 = per_square_um(nm);
    1e-8 * (8060.51 + 2_480_990.0 / (132.274 - per_um2) + 17_455.7 / (39.329_57 - per_um2))
}

/// King's factor of dry air: what molecules scatter more for not being round. 1.0488 at 550 nm. `co2_ppm` is
/// the share of carbon dioxide by volume.
///
/// # Reference
/// Bates 1984; Bodhaine et al. 1999, eqs. 5, 6 and 23.
#[must_use]
pub const fn king_factor(nm: f32, co2_ppm: f32) -> f32 {
    let per_um2 = per_square_um(nm);
    let nitrogen = 1.034 + 3.17e-4 * per_um2;
    let oxygen = 1.096 + per_um2 * (1.385e-3 + 1.448e-4 * per_um2);
    let co2 = 1e-4 * co2_ppm;
    (78.084 * nitrogen + 20.946 * oxygen + 0.934 + co2 * 1.15) / (78.084 + 20.946 + 0.934 + co2)
}

/// Scattering cross-section of a molecule of dry air, in units of 1e-27 cm2 (1e-31 m2): 4.510 at 550 nm with
/// 300 ppm CO2. `nm` 200..=2000 is the wavelength in vacuum; `co2_ppm` 0..=1000.
///
/// # Accuracy
/// 1e-6, relative, beside the formula in f64.
///
/// # Reference
/// Bodhaine, Wood, Dutton and Slusser 1999, "On Rayleigh optical depth calculations", eqs. 2, 4, 23.
///
/// ```
/// # use nanospectra::matter::rayleigh_cross_section;
/// assert!((rayleigh_cross_section(550.0, 300.0) - 4.510).abs() < 5e-4);
/// ```
#[must_use]
pub const fn rayleigh_cross_section(nm: f32, co2_ppm: f32) -> f32 {
    // Carbon dioxide refracts 0.54 more than the air it replaces.
    let r = air_refractivity(nm) * (1.0 + 0.54e-6 * (co2_ppm - 300.0));
    // (n^2 - 1) / (n^2 + 2) over the number of molecules; n is too near 1 to be squared.
    let polarizability = r * (2.0 + r) / ((3.0 + r * (2.0 + r)) * MOLECULES_1E31_PER_M3);
    // 24 pi^3; the square below is in 1e-62 m6, and lambda^4 in 1e-24 m4.
    const TWENTY_FOUR_PI_CUBED: f32 = 744.150_7;
    let um = 1e-3 * nm;
    let square = um * um;
    TWENTY_FOUR_PI_CUBED * polarizability * polarizability / (square * square)
        * king_factor(nm, co2_ppm)
        * 1e-7
}

/// What air of 288.15 K, 101325 Pa and 360 ppm CO2 scatters out of a beam, in 1/m: 1.149e-5 at 550 nm.
/// Proportional to the density.
///
/// # Accuracy
/// As [`rayleigh_cross_section`], for `nm` 200..=2000; below 185 the formula has poles.
#[must_use]
pub const fn rayleigh_per_m(nm: f32) -> f32 {
    rayleigh_cross_section(nm, 360.0) * MOLECULES_1E31_PER_M3
}

/// How air's scattered light is spread over directions, per sr: its integral over the sphere is 1.
/// `cos_theta` -1..=1 is the cosine of the angle by which light turns; `king_factor` 1..=2.
///
/// # Reference
/// Chandrasekhar's phase function with the depolarization rho = 6 (F - 1) / (7 F + 3).
///
/// ```
/// # use nanospectra::matter::rayleigh_phase;
/// // Round molecules: 3 / (16 pi) (1 + cos^2).
/// assert!((rayleigh_phase(0.0, 1.0) - 0.059_683).abs() < 1e-6);
/// ```
#[must_use]
pub const fn rayleigh_phase(cos_theta: f32, king_factor: f32) -> f32 {
    let rho = 6.0 * (king_factor - 1.0) / (7.0 * king_factor + 3.0);
    let gamma = rho / (2.0 - rho);
    let scale = 3.0 / (16.0 * core::f32::consts::PI * (1.0 + 2.0 * gamma));
    scale * ((1.0 + 3.0 * gamma) + (1.0 - gamma) * cos_theta * cos_theta)
}

const fn per_square_um(nm: f32) -> f32 {
    let um = 1e-3 * nm;
    1.0 / (um * um)
}
