//! Chromatic adaptation of the von Kries kind.

use super::linear::{Matrix3, apply, diagonal, inverse, product};

/// XYZ to cone-like responses, by the names of golden 09.
pub fn cone_matrix(name: &str) -> Matrix3 {
    match name {
        "XYZ Scaling" => [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        "Von Kries" => [[0.40024, 0.70760, -0.08081], [-0.22630, 1.16532, 0.04570], [0.0, 0.0, 0.91822]],
        "Bradford" => [[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367], [0.0389, -0.0685, 1.0296]],
        "CAT02" => [[0.7328, 0.4296, -0.1624], [-0.7036, 1.6975, 0.0061], [0.0030, 0.0136, 0.9834]],
        "CAT02 Brill 2008" => [[0.7328, 0.4296, -0.1624], [-0.7036, 1.6975, 0.0061], [0.0, 0.0, 1.0]],
        "CAT16" => [
            [0.401288, 0.650173, -0.051461],
            [-0.250268, 1.204414, 0.045854],
            [-0.002079, 0.048952, 0.953127],
        ],
        "CMCCAT2000" => [[0.7982, 0.3389, -0.1371], [-0.5918, 1.5512, 0.0406], [0.0008, 0.0239, 0.9753]],
        // as the golden has it: Bradford transposed, and with one sign lost
        "CMCCAT97" => [[0.8951, -0.7502, 0.0389], [0.2664, 1.7135, 0.0685], [-0.1614, 0.0367, 1.0296]],
        "Fairchild" => [[0.8562, 0.3372, -0.1934], [-0.8360, 1.8327, 0.0033], [0.0357, -0.0469, 1.0112]],
        "Sharp" => [[1.2694, -0.0988, -0.1706], [-0.8364, 1.8006, 0.0357], [0.0297, -0.0315, 1.0018]],
        "Bianco 2010" => [[0.8752, 0.2787, -0.1539], [-0.8904, 1.8709, 0.0195], [-0.0061, 0.0162, 0.9899]],
        "Bianco PC 2010" => [[0.6489, 0.3915, -0.0404], [-0.3775, 1.3055, 0.0720], [-0.0271, 0.0888, 0.9383]],
        _ => panic!("no adaptation transform called {name}"),
    }
}

/// Complete adaptation from one white to another: M^-1 diag(M to / M from) M.
pub fn matrix(name: &str, from: [f64; 3], to: [f64; 3]) -> Matrix3 {
    partial_matrix(name, from, to, 1.0)
}

/// Incomplete adaptation, D from 0 (none) to 1; both whites at the same Y.
pub fn partial_matrix(name: &str, from: [f64; 3], to: [f64; 3], d: f64) -> Matrix3 {
    let m = cone_matrix(name);
    let (from, to) = (apply(m, from), apply(m, to));
    let gain = [0, 1, 2].map(|c| d * to[c] / from[c] + 1.0 - d);
    product(inverse(m), product(diagonal(gain), m))
}

/// Zhai and Luo 2018: CAT16 in two steps through the equal-energy white, each incomplete.
pub fn zhai(xyz: [f64; 3], from: [f64; 3], to: [f64; 3], d_from: f64, d_to: f64) -> [f64; 3] {
    let m = cone_matrix("CAT16");
    let (from, to, middle) = (apply(m, from), apply(m, to), apply(m, [1.0; 3]));
    let gain = [0, 1, 2]
        .map(|c| (d_from * middle[c] / from[c] + 1.0 - d_from) / (d_to * middle[c] / to[c] + 1.0 - d_to));
    apply(product(inverse(m), product(diagonal(gain), m)), xyz)
}

/// D of CMCCAT2000 for an average surround and equal adapting luminances in cd/m2.
pub fn cmccat2000_degree(la: f64) -> f64 {
    (0.08 * la.log10() + 0.76).clamp(0.0, 1.0)
}
