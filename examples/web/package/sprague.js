// Sprague's quintic interpolation between equally spaced values, in f64 and by the operations in f32 of the crate.

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

const f = Math.fround;

/** The weights of values beyond the ends, in f32. */
export const OUTER = BEYOND.map((weights) => weights.map((x) => f(x / 209)));

/** Returns the mean step in f32 between `n` wavelengths from the first to the last. */
const stepOf = (first, last, n) => f(f(f(last) - f(first)) / (n - 1));

/** Returns the place of the first wavelength that is off equal steps by more than a hundredth, or -1. @param {number[]} nms */
export function irregular(nms) {
  const step = stepOf(nms[0], nms.at(-1), nms.length);
  return nms.findIndex((nm, k) => Math.abs(f(f(nm) - f(f(nms[0]) + f(k * step)))) > f(f(0.01) * step));
}

/**
 * Interpolates to the nodes 360..830 nm by the same operations in f32 as the crate.
 * @param {number[]} v values in f32, of which there are six or more
 * @param {number} first the wavelength of the first value, which f32 holds @param {number} last that of the last
 * @param {boolean} hold whether the values at the ends go on outside, where zero is otherwise
 */
export function everyNanometerOf(v, first, last, hold) {
  const n = v.length,
    step = stepOf(first, last, n);
  return Array.from({ length: 471 }, (_, node) => {
    const nm = 360 + node;
    if (nm < first) return hold ? v[0] : 0;
    if (nm > last) return hold ? v[n - 1] : 0;
    const distance = f(nm - first);
    const cell = Math.min(Math.floor(f(distance / step)), n - 2);
    const t = f(f(distance - f(cell * step)) / step);
    // Horner's scheme with each step rounded; `c` goes from the innermost coefficient outwards.
    const horner = (c) => c.reduce((sum, x) => f(x + f(t * sum)));
    const q = [
      f(f(t * horner([f(13 - f(5 * t)), -9, -1, 2])) / 24),
      f(f(t * horner([f(-64 + f(25 * t)), 39, 16, -16])) / 24),
      f(1 + f(f(f(t * t) * horner([f(126 - f(50 * t)), -70, -30])) / 24)),
      f(f(t * horner([f(-124 + f(50 * t)), 66, 16, 16])) / 24),
      f(f(t * horner([f(61 - f(25 * t)), -33, -1, -2])) / 24),
      f(f(f(f(t * t) * t) * horner([f(-12 + f(5 * t)), 7])) / 24),
    ];
    const start = Math.min(Math.max(cell - 2, 0), n - 6);
    const w = [0, 0, 0, 0, 0, 0];
    for (let j = 0; j < 6; j++) {
      const k = cell + j;
      if (k < 2) {
        const outer = OUTER[k === 0 ? 1 : 0];
        for (let i = 0; i < 6; i++) w[i] = f(w[i] + f(q[j] * outer[i]));
      } else if (k - 2 >= n) {
        const outer = OUTER[k - 2 > n ? 1 : 0];
        for (let i = 0; i < 6; i++) w[5 - i] = f(w[5 - i] + f(q[j] * outer[i]));
      } else if (k - 2 - start < 6) w[k - 2 - start] = f(w[k - 2 - start] + q[j]);
    }
    let sum = 0;
    for (let j = 0; j < 6; j++) if (w[j] !== 0) sum = f(sum + f(w[j] * f(v[start + j] - v[cell])));
    return f(v[cell] + sum);
  });
}
