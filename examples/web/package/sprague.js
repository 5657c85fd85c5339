// Sprague's quintic interpolation between equally spaced values, in f64.

/**
 * The weights, over 209, by which the last six values, nearest first, give a value one step beyond the end, and two
 * steps beyond it.
 */
export const BEYOND = [
  [508, -540, 488, -367, 144, -24],
  [884, -1960, 3033, -2648, 1080, -180],
];

/** Interpolates between the third and the fourth of six values, at 0..1. @param {number[]} p @param {number} t */
export function quintic(p, t) {
  const a1 = (2 * p[0] - 16 * p[1] + 16 * p[3] - 2 * p[4]) / 24;
  const a2 = (-p[0] + 16 * p[1] - 30 * p[2] + 16 * p[3] - p[4]) / 24;
  const a3 = (-9 * p[0] + 39 * p[1] - 70 * p[2] + 66 * p[3] - 33 * p[4] + 7 * p[5]) / 24;
  const a4 = (13 * p[0] - 64 * p[1] + 126 * p[2] - 124 * p[3] + 61 * p[4] - 12 * p[5]) / 24;
  const a5 = (-5 * p[0] + 25 * p[1] - 50 * p[2] + 50 * p[3] - 25 * p[4] + 5 * p[5]) / 24;
  return p[2] + t * (a1 + t * (a2 + t * (a3 + t * (a4 + t * a5))));
}
