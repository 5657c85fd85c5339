//! The CIE 1931 functions as sums of lobes, which need no table but seven exponentials for each wavelength.

use nanospectra::math::Math;

/// Returns x, y and z bar at a wavelength in nm, by the fit of seven piecewise Gaussian lobes.
///
/// # Reference
/// C. Wyman, P.-P. Sloan, P. Shirley, "Simple Analytic Approximations to the CIE XYZ Color Matching
/// Functions", Journal of Computer Graphics Techniques 2(2), 2013; section 2.2.
#[must_use]
pub fn color_matching<M: Math>(nm: f32) -> [f32; 3] {
    let lobe = |height: f32, center_nm: f32, below: f32, above: f32| {
        let away = nm - center_nm;
        let t = away * if away < 0.0 { below } else { above };
        height * M::exp(-0.5 * t * t)
    };
    [
        lobe(1.056, 599.8, 0.0264, 0.0323)
            + lobe(0.362, 442.0, 0.0624, 0.0374)
            + lobe(-0.065, 501.1, 0.0490, 0.0382),
        lobe(0.821, 568.8, 0.0213, 0.0247) + lobe(0.286, 530.9, 0.0613, 0.0322),
        lobe(1.217, 437.0, 0.0845, 0.0278) + lobe(0.681, 459.0, 0.0385, 0.0725),
    ]
}
