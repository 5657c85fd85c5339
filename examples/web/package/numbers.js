// Numbers as the crate's examples print them.

/** An f32 with the fewest digits that bring it back: 0.3127 rather than 0.3127000033855438; null for NaN. @param {number} x */
export function single(x) {
  if (!Number.isFinite(x)) return null;
  for (let digits = 1; digits < 10; digits++) {
    const short = Number(x.toPrecision(digits));
    if (Math.fround(short) === x) return short;
  }
  return x;
}

/** @param {ArrayLike<number>} values */
export const singles = (values) => Array.from(values, single);

/** Several numbers, or null if they have no value. @param {ArrayLike<number>} values */
export const all = (values) => (Number.isNaN(values[0]) ? null : singles(values));

/** The same for an f32 that went through f64; all digits for an f64 that is none. @param {number} x */
export const double = (x) => (Math.fround(x) === x ? single(x) : x);

/** Three numbers, no fewer and no more. @param {Iterable<number>} given @param {string} what */
export function three(given, what) {
  const numbers = Array.from(given ?? []);
  if (numbers.length !== 3) throw new Error(`${what}: ${numbers.length} numbers; give 3`);
  return numbers;
}

/** `#rrggbb` @param {ArrayLike<number>} codes */
export const hex = (codes) => `#${Array.from(codes, (c) => c.toString(16).padStart(2, '0')).join('')}`;

/** A number with all its digits and no exponent, as Rust prints it. @param {number} x */
export function plain(x) {
  const text = String(x);
  const [mantissa, exponent] = text.split('e');
  if (exponent === undefined || !Number.isFinite(x)) return text;
  const sign = mantissa.startsWith('-') ? '-' : '',
    [whole, part = ''] = mantissa.replace('-', '').split('.');
  const shift = Number(exponent);
  if (shift > 0) return sign + whole + part.padEnd(shift, '0').slice(0, shift);
  return `${sign}0.${'0'.repeat(-shift - 1)}${whole}${part}`;
}

/** sRGB's curve, 0..1. @param {number} x linear */
export const encoded = (x) => (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055);
/** And back; odd about 0. @param {number} x encoded */
export const decoded = (x) =>
  Math.abs(x) <= 0.04045 ? x / 12.92 : Math.sign(x) * ((Math.abs(x) + 0.055) / 1.055) ** 2.4;
