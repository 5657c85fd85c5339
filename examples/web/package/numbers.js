// Numbers in the form in which the program `nanospectra` prints them.

/** Returns an f32 with the fewest digits that identify it, as 0.3127 for 0.3127000033855438; null for NaN. @param {number} x */
export function single(x) {
  if (!Number.isFinite(x)) return null;
  for (let digits = 1; digits < 10; digits++) {
    const short = Number(x.toPrecision(digits));
    if (Math.fround(short) === x) return short;
  }
  return x;
}

/** Returns each f32 with the fewest digits. @param {ArrayLike<number>} values */
export const singles = (values) => Array.from(values, single);

/** Returns several numbers with the fewest digits, or null if they are not defined. @param {ArrayLike<number>} values */
export const all = (values) => (Number.isNaN(values[0]) ? null : singles(values));

/**
 * Returns a number with the fewest digits if it is an f32, and with all its digits otherwise. Below the smallest normal
 * f32 the fewest digits would be another number.
 * @param {number} x
 */
export const double = (x) => (Math.fround(x) === x && (x === 0 || Math.abs(x) >= 2 ** -126) ? single(x) : x);

/** Returns exactly three numbers, or throws. @param {Iterable<number>} given @param {string} what */
export function three(given, what) {
  const numbers = Array.from(given ?? []);
  if (numbers.length !== 3) throw new Error(`${what} has ${numbers.length} numbers; give 3`);
  return numbers;
}

/** Returns a color as `#rrggbb`. @param {ArrayLike<number>} codes */
export const hex = (codes) => `#${Array.from(codes, (c) => c.toString(16).padStart(2, '0')).join('')}`;

/** Returns a number with all its digits and no exponent, as Rust prints it. @param {number} x */
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

/** Returns a number with all its digits, or with an exponent if it is tiny or long. @param {number} x */
export const shortest = (x) =>
  x === 0 || (Math.abs(x) >= 1e-6 && Math.abs(x) < 1e9) ? plain(x) : x.toExponential().replace('+', '');

/** Returns at most forty characters of a text, for a message. @param {string} text */
export function short(text) {
  const all = [...text];
  return all.length > 40 ? `${all.slice(0, 40).join('')}..` : text;
}

/** Encodes a linear number of 0..1 by the curve of sRGB. @param {number} x linear */
export const encoded = (x) => (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055);
/** Decodes an encoded number; negative numbers mirror positive ones. @param {number} x encoded */
export const decoded = (x) =>
  Math.abs(x) <= 0.04045 ? x / 12.92 : Math.sign(x) * ((Math.abs(x) + 0.055) / 1.055) ** 2.4;

/**
 * Adds to `notes` of an answer why its values are null, unless a note about the path of the value, such as
 * `absolute.luminance_cd_m2`, tells it already. Paths with the same reason share a note. `why` has the reasons for paths.
 * @template T @param {T} answer @param {Record<string, string>} [why] @returns {T}
 */
export function explained(answer, why = {}) {
  const told = answer.notes.flatMap((note) => note.split(': ')[0].split(', '));
  /** @type {Map<string, Set<string>>} */
  const reasons = new Map();
  const find = (value, path) => {
    if (value === null && !told.includes(path)) {
      const reason = why[path] ?? 'the numbers that it follows from are too large, too small or not those of a light';
      reasons.set(reason, (reasons.get(reason) ?? new Set()).add(path));
    } else if (Array.isArray(value)) value.forEach((one) => find(one, path));
    else if (value !== null && typeof value === 'object') {
      for (const [key, one] of Object.entries(value)) find(one, path ? `${path}.${key}` : key);
    }
  };
  find(answer, '');
  for (const [reason, paths] of reasons) answer.notes.push(`${[...paths].join(', ')}: ${reason}`);
  return answer;
}
