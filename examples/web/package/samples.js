// Checks one measured spectrum, notes how it was used, and brings it to 1 nm in f64. The same code in Rust is in
// `source.rs` and `exact.rs` of examples/cli/src/measure.
import { plain, short, shortest } from './numbers.js';
import { BEYOND, irregular, quintic } from './sprague.js';

const FIRST = 360,
  LAST = 830;
const NODES = LAST - FIRST + 1;
/** The step below which samples are averaged over each nanometer. (A step of 1 nm may be rounded.) */
const FINE_NM = 0.999;
/** The steps for which Sprague's rule is nearer to spectra at 1 nm than straight lines are. */
const SPRAGUE_NM = [4.999, 20.001];
/** How far a sample may be from its place, as a share of the step, if steps are equal. */
const EQUAL = 1e-4;
/** The value above which a number is a percentage or not a reflectance at all. */
const MOST_REFLECTANCE = 2;
const f = Math.fround;

/** @typedef {import('./csv.js').Source} Source */

/** Makes an error about the spectrum, at a sample or, for the spectrum as a whole, at its first row. @param {Source} source @param {string} what */
export const wrong = (source, what, k = 0) => new Error(`${source.file}:${source.lines[k]}: '${short(source.name)}': ${what}`);

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

/** Refuses numbers that are no shares of light. @param {Source} source */
export function checkShares(source) {
  const { samples } = source,
    above = samples.findIndex(([, value]) => value > MOST_REFLECTANCE);
  // A white that is shinier than its standard exceeds 1 here and there, but not everywhere.
  const k = above < 0 && samples.every(([, value]) => value > 1) ? 0 : above;
  if (k < 0) return;
  const what = `${shortest(samples[k][1])} is not a reflectance; give --percent if it is percent, or shares of 0..1`;
  throw wrong(source, what, k);
}

/**
 * Returns the rule by which samples become a spectrum at 1 nm. 'auto' takes Sprague's for equal steps of 5 to 20 nm,
 * means of straight lines over each nanometer for finer data, and else straight lines.
 * @param {Source} source @param {'auto' | 'linear' | 'sprague'} interpolation
 * @returns {'averages' | 'linear' | 'sprague' | 'means'}
 */
export function ruleOf({ samples, averages }, interpolation) {
  if (averages) return 'averages';
  if (interpolation !== 'auto') return interpolation;
  const n = samples.length,
    first = samples[0][0],
    step = (samples[n - 1][0] - first) / (n - 1);
  if (samples.some(([nm], k) => k > 0 && nm > FIRST && samples[k - 1][0] < LAST && nm - samples[k - 1][0] < FINE_NM)) return 'means';
  const isRegular =
    n >= 6 && step >= SPRAGUE_NM[0] && step <= SPRAGUE_NM[1] && samples.every(([nm], k) => Math.abs(nm - (first + step * k)) <= EQUAL * step);
  return isRegular ? 'sprague' : 'linear';
}

/** Refuses samples through which Sprague's rule draws no curve. @param {Source} source */
export function checkRegular(source) {
  const { samples } = source;
  if (samples.length < 6) throw wrong(source, 'there are fewer than 6 samples; use --interpolation linear');
  const off = irregular(samples.map(([nm]) => nm));
  if (off >= 0) throw wrong(source, 'this row is off the regular step that sprague needs; use --interpolation linear', off);
}

/** Returns the notes about how the samples were used. @param {Source} source @param {string} rule @param {boolean} hold */
export function remarks(source, rule, hold) {
  const { samples } = source,
    first = samples[0][0],
    last = samples.at(-1)[0],
    said = [];
  if (rule === 'averages') said.push('the values are averages over bands, and the spectrum is constant within each');
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
  // The other rules read all samples, or nearly all.
  if (unread > 0 && rule === 'linear') {
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
  if (widest > 20 && rule !== 'averages') {
    said.push(`the steps are up to ${shortest(widest)} nm wide; what lies between the samples is unknown`);
  }
  return said;
}

/** Returns the mean of two numbers of any size. */
const midpoint = (a, b) => {
  const most = Number.MAX_VALUE / 2;
  return Math.abs(a) <= most && Math.abs(b) <= most ? (a + b) / 2 : a / 2 + b / 2;
};

/**
 * Returns the edges of the bands around samples, which lie half way between the wavelengths. The first and the last band
 * reach as far to the outside as to the inside.
 */
function edgesOf(samples) {
  const inside = samples.slice(1).map(([nm], k) => midpoint(samples[k][0], nm));
  return [2 * samples[0][0] - inside[0], ...inside, 2 * samples.at(-1)[0] - inside.at(-1)];
}

/** Returns what lies outside of samples: zero, or the values at the ends if these go on. */
const outsideOf = (samples, hold) => (hold ? [samples[0][1], samples.at(-1)[1]] : [0, 0]);

/** Returns averages over bands at 1 nm: each nanometer has the mean of the bands that it lies in. @param {[number, number][]} samples @param {boolean} hold */
export function stepsOf(samples, hold) {
  const edges = edgesOf(samples),
    [below, above] = outsideOf(samples, hold);
  return Array.from({ length: NODES }, (_, node) => {
    const nm = FIRST + node;
    const overlap = (low, high) => Math.max(Math.min(high, nm + 0.5) - Math.max(low, nm - 0.5), 0);
    const inside = samples.reduce((sum, [, value], k) => sum + value * overlap(edges[k], edges[k + 1]), 0);
    return below * overlap(-Infinity, edges[0]) + inside + above * overlap(edges.at(-1), Infinity);
  });
}

/**
 * Returns the means over each nanometer of straight lines between the samples, so that the power of a line counts wherever
 * it lies.
 * @param {[number, number][]} samples @param {boolean} hold
 */
export function meansOf(samples, hold) {
  const means = Array(NODES).fill(0),
    [below, above] = outsideOf(samples, hold);
  const cell = (nm) => Math.min(Math.max(Math.floor(nm - FIRST + 0.5), 0), NODES - 1);
  const add = (from, to, value) => {
    for (let k = cell(from); k <= cell(to); k++) {
      const low = Math.max(from, FIRST + k - 0.5),
        high = Math.min(to, FIRST + k + 0.5);
      if (high > low) means[k] += (high - low) * value((low + high) / 2);
    }
  };
  add(-Infinity, samples[0][0], () => below);
  for (let k = 1; k < samples.length; k++) {
    const a = samples[k - 1],
      b = samples[k];
    add(a[0], b[0], (nm) => a[1] + (b[1] - a[1]) * ((nm - a[0]) / (b[0] - a[0])));
  }
  add(samples.at(-1)[0], Infinity, () => above);
  return means;
}

/** Returns the power of all samples, visible or not. @param {Source} source */
export function powerOf({ samples, averages }) {
  if (averages) {
    const edges = edgesOf(samples);
    return samples.reduce((sum, [, value], k) => sum + value * (edges[k + 1] - edges[k]), 0);
  }
  return samples.slice(1).reduce((sum, [nm, value], k) => sum + (nm - samples[k][0]) * midpoint(samples[k][1], value), 0);
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
