// Checks one measured spectrum, notes how it was used, and interpolates it in f64. The same code in Rust is in `source.rs`
// and `exact.rs` of examples/cli/src/measure.
import { plain, shortest } from './numbers.js';
import { BEYOND, quintic } from './sprague.js';

const FIRST = 360,
  LAST = 830;
const f = Math.fround;

/** @typedef {import('./csv.js').Source} Source */

/** Makes an error about the spectrum as a whole, which names its first row. @param {Source} source @param {string} what */
export const wrong = (source, what) => new Error(`${source.file}:${source.lines[0]}: '${source.name}': ${what}`);

/**
 * Turns samples of any accepted shape into a source. Messages have the words of the crate.
 * @param {Source | Iterable<[number, number]> | {nm: ArrayLike<number>, values: ArrayLike<number>}} samples
 * @param {string} name @returns {Source}
 */
export function sourceOf(samples, name) {
  const has = (key) => typeof samples === 'object' && samples !== null && key in samples;
  if (has('samples')) return samples;
  const pairs = has('nm')
    ? Array.from(samples.nm, (nm, k) => [nm, samples.values?.[k]])
    : Array.from(samples ?? []);
  if (pairs.length < 2) throw new Error('fewer than 2 samples');
  pairs.forEach((pair, k) => {
    const [nm, value] = pair?.length === 2 ? pair : [NaN, NaN];
    if (!(Number.isFinite(nm) && Number.isFinite(f(nm)) && Number.isFinite(value)))
      throw new Error(`sample ${k} is not a finite number`);
    if (k > 0 && f(nm) <= f(pairs[k - 1][0])) {
      throw new Error(`the wavelength of sample ${k} is not above the one before it`);
    }
  });
  return { file: name, name, lines: pairs.map((_, k) => k + 1), samples: pairs };
}

/** Refuses data outside the visible range, which is often in another unit. @param {Source} source */
export function checkReach(source) {
  const first = source.samples[0][0],
    last = source.samples.at(-1)[0];
  if (first <= LAST && last >= FIRST) return;
  const unit = [
    ['micrometers', 1e3],
    ['ångströms', 0.1],
    ['meters', 1e9],
  ].find(([, nm]) => first * nm <= LAST && last * nm >= FIRST);
  const advice = unit
    ? `if the wavelengths are in ${unit[0]}, multiply them by ${plain(unit[1])}`
    : 'give a spectrum that reaches into this range';
  throw wrong(
    source,
    `${shortest(first)}..${shortest(last)} nm is outside 360..830 nm, so nothing is visible; ${advice}`,
  );
}

/** Returns the notes about how the samples were used. @param {Source} source */
export function remarks(source, sprague, hold) {
  const { samples } = source,
    first = samples[0][0],
    last = samples.at(-1)[0],
    said = [];
  if (source.averages) said.push('the values are averages over bands, and the spectrum is constant within each');
  if (first > 380 || last < 780) {
    const fate = hold ? 'has the value of the nearest end' : 'counts as zero';
    said.push(`the samples cover ${shortest(first)}..${shortest(last)} nm; what is outside ${fate}`);
  }
  const inside = samples.filter(([nm]) => nm >= FIRST && nm <= LAST).length;
  const unread = samples.filter(([nm], k) => {
    const before = k > 0 ? samples[k - 1][0] : nm,
      after = k + 1 < samples.length ? samples[k + 1][0] : nm;
    return !Number.isInteger(nm) && Math.floor(before) + 1 >= after && nm >= FIRST && nm <= LAST;
  }).length;
  if (unread > 0 && !sprague && !source.averages) {
    said.push(
      `the steps are finer than 1 nm, but the sum reads whole nanometers: ${unread} of ${inside} samples ` +
        'do not count, and narrow lines between whole nanometers are missed',
    );
  }
  const beyond = samples.length - inside;
  if (beyond > 0) said.push(`${beyond} samples outside 360..830 nm are not part of any sum`);
  const negative = samples.filter(([, value]) => value < 0).length;
  if (negative > 0) said.push(`${negative} negative values are used as they are`);
  let widest = 0;
  for (let k = 1; k < samples.length; k++) widest = Math.max(widest, samples[k][0] - samples[k - 1][0]);
  if (widest > 20 && !source.averages) {
    said.push(`the steps are up to ${shortest(widest)} nm wide; what lies between the samples is unknown`);
  }
  return said;
}

/**
 * Returns the mean of averages over bands around a whole nanometer. The edges of the bands lie half way between the
 * wavelengths, and `hold` says whether the end values go on outside.
 * @param {[number, number][]} samples @param {number} nm @param {boolean} hold
 */
export function meanOf(samples, nm, hold) {
  const n = samples.length,
    edge = (k) => (k < 1 ? (3 * samples[0][0] - samples[1][0]) / 2 : k < n ? (samples[k - 1][0] + samples[k][0]) / 2 : (3 * samples[n - 1][0] - samples[n - 2][0]) / 2);
  const overlap = (low, high) => Math.max(Math.min(high, nm + 0.5) - Math.max(low, nm - 0.5), 0);
  const outside = hold ? samples[0][1] * overlap(-Infinity, edge(0)) + samples[n - 1][1] * overlap(edge(n), Infinity) : 0;
  return samples.reduce((sum, [, value], k) => sum + value * overlap(edge(k), edge(k + 1)), outside);
}

/** Returns whether f32 rounds one of the wavelengths. @param {[number, number][]} samples */
export const needsExact = (samples) => samples.some(([nm]) => f(nm) !== nm);

/** Returns the value at `nm` in f64, or undefined outside the samples. @param {[number, number][]} samples */
export function exactly(samples, nm, sprague) {
  const n = samples.length,
    first = samples[0],
    last = samples[n - 1];
  if (!(nm >= first[0] && nm <= last[0])) return undefined;
  let above = samples.findIndex((sample) => sample[0] > nm);
  if (above < 0) above = n - 1;
  const a = samples[above - 1],
    b = samples[above];
  if (!sprague) return a[1] + (b[1] - a[1]) * ((nm - a[0]) / (b[0] - a[0]));
  const step = (last[0] - first[0]) / (n - 1),
    cell = above - 1,
    t = (nm - first[0]) / step - cell;
  const beyond = (steps, inside) => BEYOND[steps].reduce((sum, weight, k) => sum + weight * inside(k), 0) / 209;
  const p = [0, 1, 2, 3, 4, 5].map((j) => {
    const k = cell + j - 2;
    if (k < 0) return beyond(-1 - k, (i) => samples[i][1]);
    return k >= n ? beyond(k - n, (i) => samples[n - 1 - i][1]) : samples[k][1];
  });
  return quintic(p, t);
}
