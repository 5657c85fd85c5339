// The module `light`: every number about a light or a surface, for one spectrum or for batches.
import { FIRST, Instrument, NODES, labOf } from './instrument.js';
import { OBSERVERS } from './lists.js';
import { all, double, hex, plain, shortest, single } from './numbers.js';
import { checkReach, remarks, sourceOf, wrong } from './samples.js';

const EYES = OBSERVERS.map(([name]) => name);
const RULES = ['linear', 'sprague'];
const UNITS = ['relative', 'absolute'];
/** By CIE 13.3, the Ra of a light that is further than this from its reference means little. */
const MAX_DC = 5.4e-3;

const NO_WHITE = [
  '',
  'redder than a black body of 1000 K',
  'bluer than a black body of a million K',
  'not a white: more than 0.05 from the Planckian locus',
  'there is no chromaticity for the 1931 observer',
];
const NO_RENDERING = [
  '',
  'the light has no visible power',
  'under this light a sample has no real color (negative values?)',
  `there is no reference: the light is ${NO_WHITE[1]}`,
  `there is no reference: the light is ${NO_WHITE[2]}`,
  `there is no reference: the light is ${NO_WHITE[3]}`,
];
const OF_THE_LIGHT = [
  'cct_k',
  'duv',
  'lux',
  'ler_lm_per_w',
  'cri_ra',
  'cri_r',
  'tm30_rf',
  'tm30_rg',
  'melanopic_edi_ratio',
  'ppfd',
];

/** The functions of the module `light`. */
export class Light extends Instrument {
  /**
   * The CIE's tables that it measures with, which stand in the order of tools/tables.mjs: x, y, z of 1931 at 360..830 nm
   * and the 99 samples of CIE 224 at 380..780 nm, row after row; and for every 5 nm from 350 nm the test colors and a
   * white.
   */
  get published() {
    const { tables } = this;
    return { eye: tables[0], testColors: tables[6], samples: tables[9] };
  }

  /**
   * Computes every number about a spectrum, with the keys of `nanospectra measure --json`. A number that is not defined
   * is null, and a note says why.
   * @param {Parameters<typeof sourceOf>[0]} samples
   * @param {import('./nanospectra.d.ts').SpectrumOptions} [options]
   */
  spectrum(samples, options = {}) {
    const {
      name = 'samples',
      reflectance = false,
      observer = '1931',
      interpolation = 'linear',
      unit = 'relative',
    } = options;
    const eye = EYES.indexOf(observer);
    if (eye < 0) throw new Error(`there is no observer ${observer}; use one of ${EYES.join(', ')}`);
    if (!RULES.includes(interpolation))
      throw new Error(`there is no interpolation ${interpolation}; use one of ${RULES.join(', ')}`);
    if (!UNITS.includes(unit)) throw new Error(`there is no unit ${unit}; use one of ${UNITS.join(', ')}`);
    const source = sourceOf(samples, name),
      sprague = interpolation === 'sprague';
    const reading = {
      name: source.name,
      XYZ: null,
      xy: null,
      uv1960: null,
      uv1976: null,
      cct_k: null,
      duv: null,
      lux: null,
      ler_lm_per_w: null,
      lab: null,
      srgb: null,
      hex: null,
      dominant_wavelength_nm: null,
      purity: null,
      cri_ra: null,
      cri_r: null,
      tm30_rf: null,
      tm30_rg: null,
      melanopic_edi_ratio: null,
      ppfd: null,
      notes: [],
      delta_e2000: null,
      observer,
      interpolation: source.averages ? 'averages' : interpolation,
      unit: reflectance ? 'relative' : unit,
      file: source.file,
    };
    const note = (key, text) => reading.notes.push(`${key}: ${text}`);
    const missing = (keys, text) => keys.forEach((key) => note(key, text));
    const work = { source, sprague, eye, unit, note, missing };
    const extra = reflectance ? this.surface(reading, work, options.light ?? 'D65') : this.lamp(reading, work);
    // What ended in NaN or an infinity is null.
    for (const [key, value] of Object.entries(reading)) {
      const lost = Array.isArray(value) ? value.includes(null) : typeof value === 'number' && !Number.isFinite(value);
      if (lost && key !== 'XYZ') reading[key] = null;
      if (reading[key] === null && !reading.notes.some((text) => text.startsWith(`${key}: `))) {
        note(key, 'it is not defined for values that are so large or so negative');
      }
    }
    if (reading.srgb === null) reading.hex = null;
    if (!reading.XYZ.every(Number.isFinite)) {
      throw wrong(source, 'its sums are too large for any number; check the values and the unit');
    }
    return { ...reading, ...extra, curve: this.curve.slice() };
  }

  /** Takes XYZ and chromaticities from `out`, and adds the dominant wavelength. */
  color(reading, { eye, missing }, white) {
    const out = this.out.slice(0, 26);
    reading.XYZ = Array.from(out.slice(0, 3), (x) => double(x) ?? NaN);
    reading.xy = all(out.slice(6, 8));
    reading.uv1960 = all(out.slice(8, 10));
    reading.uv1976 = all(out.slice(10, 12));
    if (!reading.xy) {
      missing(
        ['xy', 'uv1960', 'uv1976', 'dominant_wavelength_nm', 'purity'],
        'black has no chromaticity (X + Y + Z is not above zero)',
      );
      return out;
    }
    this.wasm.dominant(eye, ...white);
    reading.dominant_wavelength_nm = single(this.out[0]);
    reading.purity = single(this.out[1]);
    if (reading.dominant_wavelength_nm === null) {
      missing(['dominant_wavelength_nm'], 'the color is within 0.00001 of the white');
    }
    return out;
  }

  lamp(reading, work) {
    const { source, sprague, eye, unit, note, missing } = work;
    const scale = this.readLight(source, sprague),
      absolute = unit === 'absolute';
    if (this.wasm.see_light(eye)) throw wrong(source, this.dark(eye));
    const out = this.color(reading, work, [1 / 3, 1 / 3]);
    if (absolute) reading.XYZ = Array.from(out.slice(3, 6), (x) => double(x * scale));
    reading.cct_k = single(out[12]);
    reading.duv = single(out[13]);
    if (out[14]) missing(['cct_k', 'duv'], NO_WHITE[out[14]]);

    const no = this.wasm.rendering();
    if (no) missing(['cri_ra', 'cri_r'], NO_RENDERING[no]);
    else {
      reading.cri_ra = single(this.out[0]);
      reading.cri_r = Array.from(this.out.slice(2, 17), single);
      if (this.out[1] > Math.fround(MAX_DC)) {
        note(
          'cri_ra',
          `the light is ${this.out[1].toFixed(4)} from its reference in uv, where CIE 13.3 allows 0.0054, ` +
            'so that Ra means little',
        );
      }
    }
    const tm30 = this.fidelity();
    if (typeof tm30 === 'string') missing(['tm30_rf', 'tm30_rg'], tm30);
    else [reading.tm30_rf, reading.tm30_rg] = [tm30.rf, tm30.rg];

    this.wasm.photometry();
    const [ler, melanopic, lux, ppfd] = this.out;
    reading.ler_lm_per_w = single(ler);
    reading.melanopic_edi_ratio = single(melanopic);
    if (reading.ler_lm_per_w === null)
      missing(['ler_lm_per_w'], 'the power over 360..830 nm does not sum to more than zero');
    if (reading.melanopic_edi_ratio === null) missing(['melanopic_edi_ratio'], 'there is no luminance to compare with');
    if (absolute) [reading.lux, reading.ppfd] = [double(lux * scale), double(ppfd * scale)];
    else missing(['lux', 'ppfd'], 'the input is relative; give W/m2/nm and --unit absolute');

    this.show(reading, out);
    note('srgb', "this and hex are the light's chromaticity at Y = 100, clipped to the gamut");
    missing(['lab', 'delta_e2000'], 'a light has none, because it takes a surface and a white');
    if (eye) {
      note(
        'observer',
        `${OBSERVERS[eye][1]} is used for XYZ, chromaticity, dominant wavelength and sRGB, ` +
          'and CIE 1931 for CCT, Duv, CRI and photometry',
      );
    }
    for (const remark of remarks(source, sprague, false)) note('data', remark);
    return { tm30: typeof tm30 === 'string' ? null : tm30, scale };
  }

  /** Computes TM-30 of `curve`, or returns the reason why there is none. */
  fidelity() {
    const no = this.wasm.fidelity();
    if (no) return NO_RENDERING[no];
    const bins = Array.from({ length: 16 }, (_, k) => {
      const [rf, chroma_shift, hue_shift, count] = this.out.slice(2 + 4 * k, 6 + 4 * k);
      return count
        ? { rf: single(rf), chroma_shift: single(chroma_shift), hue_shift: single(hue_shift), count }
        : null;
    });
    return {
      rf: single(this.out[0]),
      rg: single(this.out[1]),
      bins,
      rf_ces: Array.from(this.out.slice(66, 165), single),
    };
  }

  surface(reading, work, light) {
    const { source, sprague, eye, note, missing } = work;
    const lamp = this.lightOf(light, sprague);
    if (this.wasm.see_light(eye)) throw wrong(lamp, this.dark(eye));
    reading.light = lamp.name;
    this.light.set(this.curve);
    checkReach(source);
    source.samples.forEach(([, value], k) => {
      if (value > 2) {
        throw new Error(
          `${source.file}:${source.lines[k]}: '${source.name}' is ${shortest(value)}, which is not a reflectance; ` +
            'give shares of 0..1, not percent or power',
        );
      }
    });
    this.read(source, { sprague, hold: true });
    const status = this.wasm.see_surface(eye);
    const [x, y, z] = this.out.slice(3, 6),
      sum = Math.fround(Math.fround(x + y) + z);
    const white = sum > 0 ? [x / sum, y / sum] : [1 / 3, 1 / 3];
    const out = this.color(reading, work, white);
    if (status & 1) missing(['lab', 'delta_e2000'], 'X, Y or Z of the light is not above zero, so it has no white');
    else [reading.lab, reading.delta_e2000] = [all(out.slice(22, 25)), single(out[25])];
    if (status & 2) missing(['srgb', 'hex'], 'the light is not a white that can be adapted to D65');
    else {
      this.show(reading, out);
      if (!out[21]) note('srgb', 'the color is outside the gamut; this and hex are clipped');
    }
    missing(OF_THE_LIGHT, 'only a light has this number, and a surface has not');
    for (const remark of remarks(source, sprague, true)) note('data', remark);
    const above = source.samples.filter(([, value]) => value > 1).length;
    if (above) note('data', `${above} values are above 1: more light leaves than arrives (fluorescence or gloss?)`);
    return {};
  }

  show(reading, out) {
    reading.srgb = all(out.slice(15, 18));
    reading.hex = hex(out.slice(18, 21));
  }

  /**
   * Returns the spectrum of a black body of 500 to 1000000 K as samples, scaled to 1 at 560 nm.
   * @param {number} kelvin
   */
  blackBody(kelvin) {
    if (!(kelvin >= 500 && kelvin <= 1e6))
      throw new Error(`${plain(kelvin)} K is out of range; give 500 to 1000000 K`);
    this.wasm.black_body(kelvin);
    return Array.from(this.curve, (value, k) => [FIRST + k, value]);
  }

  /** Returns L*, a*, b* relative to a white, or null if that is not a white. @param {number[]} xyz @param {number[]} white */
  lab(xyz, white) {
    return labOf(this, xyz, white);
  }

  /**
   * Returns the module's memory for many lights at every nanometer of 360..830: write to `lights`, call `measure` and
   * read `results`. Both are views, so nothing is copied. The results of each light are X, Y, Z, Ra, the distance to its
   * reference and R1..R15.
   * @param {number} count at most 512
   */
  batch(count) {
    if (!(Number.isInteger(count) && count >= 0 && count <= 512)) throw new Error(`a batch cannot have ${count} lights; give a whole number up to 512`);
    const { wasm } = this;
    return {
      lights: new Float32Array(wasm.memory.buffer, wasm.batch_lights(), NODES * count),
      results: new Float32Array(wasm.memory.buffer, wasm.batch_results(), 20 * count),
      measure: () => wasm.measure_batch(count),
    };
  }
}
