//! Colors at which a search that is a little worse is seen: those of the cubes of 17^3 that it calls
//! unreachable although a sigmoid has them, that it calls exact although none has, or to which it comes less
//! near.
//!
//! They were collected by changes of the search, one at a time, that looked at whole cubes: fewer starts and
//! steps, wrong signs, other limits of coefficients, of damping and of acceptance, other measures than
//! CIEDE2000.

/// The name of a cube, its bands, and the 16ths of the codes of the colors.
const HARD: &[(&str, usize, &[[u8; 3]])] = &[
    ("Display P3", 31, &[[0, 2, 16], [1, 0, 0], [11, 16, 16], [14, 16, 16], [15, 16, 16], [16, 4, 2]]),
    ("BT.2020", 31, &[[1, 8, 0], [6, 5, 16], [8, 5, 16], [10, 16, 6]]),
    ("BT.2020, BT.1886", 31, &[[0, 1, 8], [4, 1, 0], [7, 0, 0], [13, 1, 10], [13, 2, 2], [15, 6, 2]]),
    ("ACEScg", 31, &[[0, 0, 4], [0, 3, 0], [1, 4, 0], [6, 15, 7]]),
    (
        "ProPhoto",
        31,
        &[
            [0, 0, 1],
            [0, 0, 16],
            [0, 1, 2],
            [0, 2, 0],
            [1, 0, 16],
            [2, 2, 11],
            [4, 4, 12],
            [4, 13, 11],
            [7, 1, 0],
        ],
    ),
    ("Display P3", 81, &[[1, 0, 0], [14, 16, 16], [15, 16, 16]]),
    ("BT.2020", 81, &[[2, 10, 0], [16, 16, 15]]),
    ("BT.2020, BT.1886", 81, &[[0, 0, 7], [1, 0, 0], [1, 5, 16], [1, 6, 0], [4, 0, 16], [16, 15, 16]]),
    ("ACEScg", 81, &[[1, 0, 0], [1, 8, 16], [13, 14, 0]]),
    ("ProPhoto", 81, &[[0, 0, 1], [0, 0, 16], [0, 1, 0], [1, 0, 0], [1, 0, 16], [2, 0, 0], [11, 2, 9]]),
];

/// Returns the codes of the hard colors of a cube.
pub fn hard(cube: &str, bands: usize) -> impl Iterator<Item = [f32; 3]> {
    let here = HARD.iter().filter(move |(name, count, _)| *name == cube && *count == bands);
    here.flat_map(|(_, _, codes)| *codes).map(|code| code.map(|k| f32::from(k) / 16.0))
}
