//! The light that air scatters, which makes the sky blue and the evening red.

/// The number of molecules in 1 m3 of dry air at 288.15 K and 101325 Pa, in units of 1e31 (Bodhaine et al.
/// 1999).
const MOLECULES_1E31_PER_M3: f32 = 2.546_899e-6;

/// Computes the refractivity n - 1 of dry air with 300 ppm CO2, at 288.15 K and 101325 Pa.
///
/// `nm` 185..=2000 is the wavelength in vacuum.
///
/// # Example
///
/// ```
/// use nanospectra::matter::air_refractivity;
/// // The refractive index of air is 1.000278 in green light.
/// assert!((air_refractivity(550.0) - 2.78e-4).abs() < 1e-6);
/// ```
///
/// # Accuracy
/// 2e-7, relative, compared with the formula in f64.
///
/// # Reference
/// Peck and Reeder 1972, as quoted by Bodhaine et al. 1999, eq. 4.
#[must_use]
pub const fn air_refractivity(nm: f32) -> f32 {
    let per_um2 = per_square_um(nm);
    1e-8 * (8060.51 + 2_480_990.0 / (132.274 - per_um2) + 17_455.7 / (39.329_57 - per_um2))
}

/// Computes the King factor of dry air, by which molecules scatter more light because they are not spheres.
///
/// `nm` is the wavelength in vacuum, and `co2_ppm` the share of carbon dioxide by volume.
///
/// # Example
///
/// ```
/// use nanospectra::matter::king_factor;
/// assert!((king_factor(550.0, 360.0) - 1.0488).abs() < 1e-4);
/// ```
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

/// Computes the scattering cross-section of a molecule of dry air, in units of 1e-27 cm2 (1e-31 m2).
///
/// `nm` 200..=2000 is the wavelength in vacuum, and `co2_ppm` 0..=1000 the share of carbon dioxide by volume.
///
/// # Accuracy
/// 1.5e-6, relative, compared with the formula in f64.
///
/// # Reference
/// Bodhaine, Wood, Dutton and Slusser 1999, "On Rayleigh optical depth calculations", eqs. 2, 4, 23.
///
/// # Example
///
/// ```
/// use nanospectra::matter::rayleigh_cross_section;
/// assert!((rayleigh_cross_section(550.0, 300.0) - 4.510).abs() < 5e-4);
/// ```
#[must_use]
pub const fn rayleigh_cross_section(nm: f32, co2_ppm: f32) -> f32 {
    // The refractivity of carbon dioxide is 54 % higher than that of the air that it replaces.
    let r = air_refractivity(nm) * (1.0 + 0.54e-6 * (co2_ppm - 300.0));
    // (n^2 - 1) / (n^2 + 2) divided by the number of molecules, from n - 1, since n is too close to 1 to be
    // squared.
    let polarizability = r * (2.0 + r) / ((3.0 + r * (2.0 + r)) * MOLECULES_1E31_PER_M3);
    // 24 pi^3. The square below is in 1e-62 m6, and lambda^4 in 1e-24 m4.
    const TWENTY_FOUR_PI_CUBED: f32 = 744.150_7;
    let um = 1e-3 * nm;
    let square = um * um;
    TWENTY_FOUR_PI_CUBED * polarizability * polarizability / (square * square)
        * king_factor(nm, co2_ppm)
        * 1e-7
}

/// Computes the scattering coefficient of air at 288.15 K and 101325 Pa with 360 ppm CO2, in 1/m.
///
/// `nm` 200..=2000 is the wavelength in vacuum; below 185 the formula has poles. The coefficient is
/// proportional to the density of the air. [`Absorber::air`](crate::matter::Absorber::air) holds it for each
/// bin of a grid.
///
/// # Example
///
/// ```
/// use nanospectra::matter::rayleigh_per_m;
/// assert!((rayleigh_per_m(550.0) - 1.149e-5).abs() < 1e-8);
/// ```
///
/// # Accuracy
/// As [`rayleigh_cross_section`].
#[must_use]
pub const fn rayleigh_per_m(nm: f32) -> f32 {
    rayleigh_cross_section(nm, 360.0) * MOLECULES_1E31_PER_M3
}

/// Computes the phase function of air, which tells how the scattered light is spread over directions, in
/// 1/sr.
///
/// `cos_theta` -1..=1 is the cosine of the angle by which light turns, and `king_factor` 1..=2 as
/// [`king_factor`] returns it. The integral over the sphere is 1.
///
/// # Reference
/// Chandrasekhar's phase function with the depolarization rho = 6 (F - 1) / (7 F + 3).
///
/// # Example
///
/// ```
/// use nanospectra::matter::rayleigh_phase;
/// // For spherical molecules it is 3 / (16 pi) (1 + cos^2).
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
