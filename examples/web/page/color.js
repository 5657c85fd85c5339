// The display colors of wavelengths and chromaticities, for plots. The same code in Rust is in
// examples/cli/src/output/tint.rs.

/** @type {Float32Array} x, y, z of CIE 1931 at 360..830 nm, one row after the other */
let eye = new Float32Array(3 * 471);
/** @param {Float32Array} table */
export const setEye = (table) => {
  eye = table;
};

/** @param {number} nm 360..830 */
export function xyzOf(nm) {
  const k = Math.min(Math.max(Math.round(nm) - 360, 0), 470);
  return [eye[k], eye[471 + k], eye[942 + k]];
}

export function xyOf(nm) {
  const [x, y, z] = xyzOf(nm),
    sum = x + y + z;
  return [x / sum, y / sum];
}

const encode = (c) => (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055);
const code = (c) => Math.round(255 * Math.min(Math.max(c, 0), 1));

/** Returns about the brightest color of a chromaticity that a display can show, as codes of 0..255. */
export function rgbOf(x, y, dim = 1) {
  const [X, Y, Z] = [x / y, 1, (1 - x - y) / y];
  const linear = [
    3.2406 * X - 1.5372 * Y - 0.4986 * Z,
    -0.9689 * X + 1.8758 * Y + 0.0415 * Z,
    0.0557 * X - 0.204 * Y + 1.057 * Z,
  ];
  const top = Math.max(...linear, 1e-9);
  return linear.map((c) => code(encode((Math.max(c, 0) / top) * dim)));
}

/** Returns the CSS color of light of one wavelength, which gets darker towards both ends of the spectrum. */
export function tint(nm) {
  const [x, y, z] = xyzOf(nm),
    sum = x + y + z;
  return `rgb(${rgbOf(x / sum, y / sum, Math.min(2 * sum, 1) ** 0.35)})`;
}

/** Returns black or white, whichever can be read on a color; they change at a luminance of 0.18. @param {string} hex */
export function ink(hex) {
  const [r, g, b] = [1, 3, 5].map((at) => (parseInt(hex.slice(at, at + 2), 16) / 255) ** 2.2);
  return 0.2126 * r + 0.7152 * g + 0.0722 * b > 0.18 ? '#000' : '#fff';
}

export const uvOf = ([x, y]) => [(4 * x) / (-2 * x + 12 * y + 3), (9 * y) / (-2 * x + 12 * y + 3)];
export const xyOfUv = ([u, v]) => [(9 * u) / (6 * u - 16 * v + 12), (4 * v) / (6 * u - 16 * v + 12)];
