//! ICtCp of BT.2100 and Jzazbz of Safdar et al., as they are printed.

use super::linear::{Matrix3, apply};
use super::transfer::{hlg_encode, pq_encode};

/// Linear BT.2020, 1 for 10 000 cd/m2.
pub fn ictcp_pq(rgb: [f64; 3]) -> [f64; 3] {
    let signals = cones(rgb).map(pq_encode);
    apply([[2048.0, 2048.0, 0.0], [6610.0, -13613.0, 7003.0], [17933.0, -17390.0, -543.0]], signals)
        .map(|v| v / 4096.0)
}

/// Linear BT.2020 of the scene, 1 for its peak.
pub fn ictcp_hlg(rgb: [f64; 3]) -> [f64; 3] {
    let signals = cones(rgb).map(hlg_encode);
    apply([[2048.0, 2048.0, 0.0], [3625.0, -7465.0, 3840.0], [9500.0, -9212.0, -288.0]], signals)
        .map(|v| v / 4096.0)
}

fn cones(rgb: [f64; 3]) -> [f64; 3] {
    apply([[1688.0, 2146.0, 262.0], [683.0, 2951.0, 462.0], [99.0, 309.0, 3688.0]], rgb).map(|v| v / 4096.0)
}

const CONES: Matrix3 =
    [[0.41478972, 0.579999, 0.0146480], [-0.2015100, 1.120649, 0.0531008], [-0.0166008, 0.264800, 0.6684799]];
const OPPONENTS: Matrix3 =
    [[0.5, 0.5, 0.0], [3.524000, -4.066708, 0.542708], [0.199076, 1.096799, -1.295875]];

/// X, Y, Z in cd/m2 under D65.
pub fn jzazbz([x, y, z]: [f64; 3]) -> [f64; 3] {
    let (b, g, d, d0) = (1.15, 0.66, -0.56, 1.629_549_953_282_156_6e-11);
    let straight = [b * x - (b - 1.0) * z, g * y - (g - 1.0) * x, z];
    let encoded = apply(CONES, straight).map(|v| {
        let p = (v / 10_000.0).max(0.0).powf(2610.0 / 16384.0);
        let (c1, c2, c3) = (3424.0 / 4096.0, 2413.0 / 128.0, 2392.0 / 128.0);
        ((c1 + c2 * p) / (1.0 + c3 * p)).powf(1.7 * 2523.0 / 32.0)
    });
    let [iz, az, bz] = apply(OPPONENTS, encoded);
    [(1.0 + d) * iz / (1.0 + d * iz) - d0, az, bz]
}
