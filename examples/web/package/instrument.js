// The base of all modules that measure spectra: shared memory, a spectrum at every nanometer, and the CIE's lamps.
import { ILLUMINANTS, OBSERVERS } from './lists.js';
import { all, three } from './numbers.js';
import { read } from './read.js';
import { checkReach, checkRegular, exactly, meansOf, needsExact, ruleOf, sourceOf, stepsOf, wrong } from './samples.js';
import { everyNanometerOf } from './sprague.js';

export const FIRST = 360,
  NODES = 471;
const CAPACITY = 4096;

/** Returns the words for an error code of the exports that read samples. */
function refusal(code) {
  const index = code >> 3;
  return (
    [
      '',
      `fewer than ${index} samples`,
      `sample ${index} is not a finite number`,
      `the wavelength of sample ${index} is not above the one before it`,
    ][code & 7] ?? 'not a spectrum'
  );
}

/** The base class of modules that measure spectra at 360..830 nm. */
export class Instrument {
  /** @param {Record<string, any>} wasm @param {boolean} simd @param {Float32Array[]} tables the CIE's, the first is x, y, z of 1931 @param {string | URL} base where the package's files are */
  constructor(wasm, simd, tables, base) {
    const view = (address, length) => new Float32Array(wasm.memory.buffer, address, length);
    this.wasm = wasm;
    this.simd = simd;
    this.tables = tables;
    this.base = base;
    this.pairs = view(wasm.samples(), 2 * CAPACITY);
    this.curve = view(wasm.curve(), NODES);
    this.light = view(wasm.light(), NODES);
    this.out = view(wasm.out(), 512);
    /** @type {Map<string, import('./csv.js').Source> | null} */
    this.lamps = null;
  }

  /** Writes samples to the module's `samples`. @returns {number} how many there are */
  write(samples, at = 0) {
    if (at + samples.length > CAPACITY) {
      throw new Error(`there are ${at + samples.length} samples, and ${CAPACITY} have room; average neighbors`);
    }
    samples.forEach(([nm, value], k) => {
      this.pairs[2 * (at + k)] = nm;
      this.pairs[2 * (at + k) + 1] = value;
    });
    return samples.length;
  }

  /**
   * Brings a spectrum to every nanometer in the module's `curve`, by a rule of `ruleOf`.
   * @param {import('./csv.js').Source} source @param {{rule?: string, hold?: boolean, scaled?: (x: number) => number}} how
   */
  read(source, { rule = ruleOf(source, 'linear'), hold = false, scaled = (x) => x } = {}) {
    const { samples } = source,
      ordinary = samples.map(([nm, value]) => [nm, scaled(value)]);
    if (rule === 'averages') return this.curve.set(stepsOf(ordinary, hold));
    if (rule === 'means') return this.curve.set(meansOf(ordinary, hold));
    const status = this.wasm.interpolate(this.write(ordinary), +hold);
    if ((status & 7) === 3) throw wrong(source, 'this row is less than 0.0001 nm above the one before; merge the two', status >> 3);
    if (status) throw wrong(source, `${refusal(status)}; correct the file`);
    const sprague = rule === 'sprague',
      [first, last] = [samples[0], samples.at(-1)];
    if (sprague) checkRegular(source);
    if (needsExact(samples)) {
      for (let k = 0; k < NODES; k++) {
        const nm = FIRST + k,
          value = exactly(samples, nm, sprague);
        const end = nm < first[0] ? first[1] : last[1];
        this.curve[k] = value !== undefined ? scaled(value) : hold ? scaled(end) : 0;
      }
    } else if (sprague) {
      const values = ordinary.map(([, value]) => Math.fround(value));
      this.curve.set(everyNanometerOf(values, first[0], last[0], hold));
    }
  }

  /**
   * Reads a light into `curve`, scaled by a power of two so that its numbers are of ordinary size.
   * @param {import('./csv.js').Source} source @param {string} [rule]
   * @returns {number} the number by which the curve is multiplied to get the samples
   */
  readLight(source, rule) {
    checkReach(source);
    const peak = source.samples.reduce((peak, [, value]) => Math.max(peak, Math.abs(value)), 0);
    if (peak === 0) throw wrong(source, 'every value is zero; measure again with the lamp on');
    const half = Math.floor(Math.log2(peak) / 2),
      up = 2 ** -half;
    this.read(source, { rule, scaled: (value) => value * up * up });
    if (this.curve.every((value) => value === 0)) {
      throw wrong(
        source,
        'there is no power at any whole nanometer of 360..830, so nothing is visible; give a spectrum that has some',
      );
    }
    return 2 ** (2 * half);
  }

  /** Loads the CIE's lamps from lamps.json, by name. @param {string | URL} [base] */
  async loadLamps(base = this.base) {
    const lamps = JSON.parse(new TextDecoder().decode(await read(new URL('lamps.json', base))));
    this.lamps = new Map(
      lamps.map(({ name, first, step, values }) => [
        name,
        {
          file: name,
          name,
          lines: values.map((_, k) => k + 1),
          samples: values.map((value, k) => [first + k * step, value]),
        },
      ]),
    );
    const flat = Array.from({ length: NODES }, (_, k) => [FIRST + k, 1]);
    this.lamps.set('E', { file: 'E', name: 'E', lines: flat.map((_, k) => k + 1), samples: flat });
    return this.lamps;
  }

  /** Reads the lamp of a name into `curve`, by straight lines unless a rule is given. */
  named(name, place, rule) {
    if (!this.lamps)
      throw new Error(`${place}: '${name}' names a lamp, but there are no lamps yet; await loadLamps() first`);
    const lamp = this.lamps.get(String(name).toUpperCase());
    if (!lamp) {
      throw new Error(`${place}: '${name}' is no CIE illuminant; use one of ${ILLUMINANTS}`);
    }
    this.read(lamp, { rule });
    return lamp;
  }

  /**
   * Reads a light into `curve`, by name or from samples. Tables of the CIE are joined by straight lines by 'auto', too.
   * @param {string | Parameters<typeof sourceOf>[0]} light @param {'auto' | 'linear' | 'sprague'} [interpolation]
   * @returns {import('./csv.js').Source}
   */
  lightOf(light, interpolation = 'linear') {
    if (typeof light === 'string') return this.named(light, '--light', interpolation === 'sprague' ? 'sprague' : 'linear');
    const source = sourceOf(light, 'light');
    this.readLight(source, ruleOf(source, interpolation));
    return source;
  }

  dark(eye) {
    return (
      `nothing is visible, since Y is not above zero for ${OBSERVERS[eye][1]}; ` +
      'check the range and the dark reading'
    );
  }
}

/** Returns L*, a*, b* by a module that computes them, or null if the white is not a white. @param {Instrument} instrument @param {number[]} xyz @param {number[]} white */
export function labOf({ wasm, out }, xyz, white) {
  const numbers = [...three(xyz, 'xyz'), ...three(white, 'white')];
  if (!numbers.every(Number.isFinite)) throw new Error('X, Y or Z is not finite; give finite numbers');
  return wasm.lab(...numbers) ? null : all(out.slice(0, 3));
}
