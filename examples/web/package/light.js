// The module `light`: every number about a light or a surface, for one spectrum or for batches.
import { FIRST, Instrument, NODES, labOf } from './instrument.js';
import { OBSERVERS } from './lists.js';
import { all, double, explained, hex, plain, single } from './numbers.js';
import { checkReach, checkShares, powerOf, remarks, ruleOf, sourceOf, wrong } from './samples.js';
import { shapeOf } from './shape.js';

const EYES = OBSERVERS.map(([name]) => name);
const RULES = ['auto', 'linear', 'sprague'];
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
const OF_THE_LIGHT =
  'cct_k duv lux ler_lm_per_w cri_ra cri_r cri_r9 cri_is_valid tm30_rf tm30_rg melanopic_edi_ratio ppfd epar photons ' +
  'photon_shares r_fr alpha_opic peak_nm centroid_nm fwhm_nm';
/** The keys of numbers that are left out, with a note, if their formula ended in NaN or an infinity. */
const FINITE =
  'xy uv1960 uv1976 cct_k duv lux ppfd ler_lm_per_w lab delta_e2000_to_white srgb dominant_wavelength_nm purity cri_ra ' +
  'cri_r tm30_rf tm30_rg melanopic_edi_ratio';
/** The keys of numbers that have the same note if they are missing and no other note says why. */
const EXPLAINED = 'xy uv1960 uv1976 cct_k duv lab srgb purity cri_ra tm30_rf delta_e2000_to_white';
const EXTREME = 'it is not defined for values that are so large or so negative';
/**
 * The excitation purity above which a chromaticity is outside of the spectrum locus by more than noise, and the one above
 * which no noise explains it.
 */
const NOISY_PURITY = 1.01,
  MOST_PURITY = 1.2;
/** The illuminance above which no daylight is: the sun at the zenith gives some 130,000 lx. */
const MOST_DAYLIGHT = 200_000;
const RECEPTORS = ['s_cone', 'm_cone', 'l_cone', 'rhodopic', 'melanopic'];
/** The bands of photons, in the order of the module. */
const BANDS = ['blue', 'green', 'red', 'far_red'];

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
   * Computes every number about a spectrum, with the keys of `nanospectra measure --json`, except those about files. A
   * number that is not defined is null, and a note says why.
   * @param {Parameters<typeof sourceOf>[0]} samples
   * @param {import('./nanospectra.d.ts').SpectrumOptions} [options]
   */
  spectrum(samples, options = {}) {
    const {
      name = 'samples',
      reflectance = false,
      observer = '1931',
      interpolation = 'auto',
      unit = 'relative',
    } = options;
    const eye = EYES.indexOf(observer);
    if (eye < 0) throw new Error(`there is no observer ${observer}; use one of ${EYES.join(', ')}`);
    if (!RULES.includes(interpolation))
      throw new Error(`there is no interpolation ${interpolation}; use one of ${RULES.join(', ')}`);
    if (!UNITS.includes(unit)) throw new Error(`there is no unit ${unit}; use one of ${UNITS.join(', ')}`);
    const source = sourceOf(samples, name),
      rule = ruleOf(source, interpolation),
      kind = reflectance ? 'reflectance' : unit === 'absolute' ? 'W/m2/nm' : unit;
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
      delta_e2000_to_white: null,
      observer,
      interpolation: rule,
      unit: kind,
      file: source.file,
      cri_r9: null,
      cri_is_valid: null,
      tm30_edition: 'ANSI/IES TM-30-20',
    };
    const note = (key, text) => reading.notes.push(`${key}: ${text}`);
    const missing = (keys, text) => keys.forEach((key) => note(key, text));
    const work = { source, rule, interpolation, eye, note, missing };
    const extra = reflectance ? this.surface(reading, work, options.light ?? 'D65') : this.lamp(reading, work);
    const isLost = (value) => (Array.isArray(value) ? value.includes(null) : value !== null && !Number.isFinite(value));
    for (const key of FINITE.split(' ').filter((key) => isLost(reading[key]))) {
      reading[key] = null;
      note(key, EXTREME);
    }
    if (reading.srgb === null) reading.hex = null;
    if (reading.cri_r === null) reading.cri_r9 = null;
    for (const key of EXPLAINED.split(' ')) {
      if (reading[key] === null && !reading.notes.some((text) => text.startsWith(`${key}: `))) note(key, EXTREME);
    }
    if (!reading.XYZ.every(Number.isFinite)) {
      throw wrong(source, 'its sums are too large for any number; check the values and the unit');
    }
    return { ...explained(reading), ...extra, curve: this.curve.slice() };
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
    const { source, rule, eye, note, missing } = work;
    const scale = this.readLight(source, rule);
    if (this.wasm.see_light(eye)) throw wrong(source, this.dark(eye));
    const out = this.color(reading, work, [1 / 3, 1 / 3]);
    if (reading.unit !== 'relative') reading.XYZ = Array.from(out.slice(3, 6), (x) => double(x * scale));
    this.checkPurity(reading, work);
    reading.cct_k = single(out[12]);
    reading.duv = single(out[13]);
    if (out[14]) missing(['cct_k', 'duv'], NO_WHITE[out[14]]);

    const no = this.wasm.rendering();
    if (no) missing(['cri_ra', 'cri_r', 'cri_r9', 'cri_is_valid'], NO_RENDERING[no]);
    else {
      reading.cri_ra = single(this.out[0]);
      reading.cri_r = Array.from(this.out.slice(2, 17), single);
      reading.cri_r9 = reading.cri_r[8];
      reading.cri_is_valid = !(this.out[1] > Math.fround(MAX_DC));
      if (!reading.cri_is_valid) {
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

    this.strength(reading, work, scale);
    const { peak, centroid, width } = shapeOf(source.samples);
    [reading.peak_nm, reading.centroid_nm, reading.fwhm_nm] = [peak, centroid, width].map((nm) => nm && double(nm));
    if (centroid === null) note('centroid_nm', 'the power of the samples does not sum to more than zero');
    if (width === null) note('fwhm_nm', 'the samples end before they fall to half of the peak on both sides');

    this.show(reading, out);
    note('srgb', "this and hex are the light's chromaticity at Y = 100, clipped to the gamut");
    missing(['lab', 'delta_e2000_to_white'], 'a light has none, because it takes a surface and a white');
    if (eye) {
      note(
        'observer',
        `${OBSERVERS[eye][1]} is used for XYZ, chromaticity, dominant wavelength and sRGB, ` +
          'and CIE 1931 for CCT, Duv, CRI and photometry',
      );
    }
    for (const remark of remarks(source, rule, false)) note('data', remark);
    return { tm30: typeof tm30 === 'string' ? null : tm30, scale };
  }

  /** Looks whether any light can have the chromaticity. */
  checkPurity({ purity }, { source, note }) {
    if (purity > Math.fround(MOST_PURITY)) {
      throw wrong(
        source,
        'its chromaticity is far outside the spectrum locus, which no light has; look for numbers that stand for missing ' +
          'values, and subtract the dark reading',
      );
    }
    if (purity > Math.fround(NOISY_PURITY)) {
      note('xy', 'the chromaticity is outside the spectrum locus, which no light has; is the dark reading right?');
    }
  }

  /** Adds how strong the light in `curve`, times `scale`, is: for instruments, the eye, the body's clock and plants. */
  strength(reading, { source, note, missing }, scale) {
    this.wasm.photometry();
    const out = Array.from(this.out.slice(0, 25)),
      known = reading.unit !== 'relative';
    const [ler] = out,
      ders = out.slice(1, 6),
      luminous = out[16],
      [par, epar, ...photons] = out.slice(17);
    const absolute = (x) => (known ? double(x * scale) : null);
    const each = (names, value) => Object.fromEntries(names.map((name, k) => [name, value(k)]));
    reading.ler_lm_per_w = single(ler);
    if (reading.ler_lm_per_w === null)
      missing(['ler_lm_per_w'], 'the power over 360..830 nm does not sum to more than zero');
    reading.melanopic_edi_ratio = single(ders[4]);
    if (reading.melanopic_edi_ratio === null) missing(['melanopic_edi_ratio'], 'there is no luminance to compare with');
    if (known) reading.irradiance_w_m2 = double(powerOf(source));
    [reading.lux, reading.ppfd, reading.epar] = [luminous, par, epar].map(absolute);
    reading.photons = known ? each(BANDS, (k) => absolute(photons[k])) : null;
    reading.photon_shares = each(BANDS, (k) => (par > 0 ? double(photons[k] / par) : null));
    const [red, farRed] = photons.slice(4);
    reading.r_fr = farRed > 0 ? double(red / farRed) : null;
    reading.alpha_opic = each(RECEPTORS, (k) => ({
      der: single(ders[k]),
      ...(known && { irradiance_w_m2: absolute(out[6 + k]), edi_lx: absolute(out[11 + k]) }),
    }));
    if (!known) {
      const why = 'the input is relative; give --unit such as absolute (W/m2/nm) or mW/m2/nm, or --lux or --ppfd';
      missing(['lux', 'ppfd', 'epar', 'photons'], why);
    }
    if (reading.r_fr === null) note('r_fr', 'there are no photons of 725..735 nm to compare with');
    if (reading.lux > MOST_DAYLIGHT)
      note('lux', 'this is brighter than the sun on the ground (130,000 lx); is the unit right?');
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
    const { source, rule, interpolation, eye, note, missing } = work;
    const lamp = this.lightOf(light, interpolation);
    if (this.wasm.see_light(eye)) throw wrong(lamp, this.dark(eye));
    reading.light = lamp.name;
    this.light.set(this.curve);
    checkReach(source);
    checkShares(source);
    this.read(source, { rule, hold: true });
    const status = this.wasm.see_surface(eye);
    const [x, y, z] = this.out.slice(3, 6),
      sum = Math.fround(Math.fround(x + y) + z);
    const white = sum > 0 ? [x / sum, y / sum] : [1 / 3, 1 / 3];
    const out = this.color(reading, work, white);
    if (status & 1) missing(['lab', 'delta_e2000_to_white'], 'X, Y or Z of the light is not above zero, so it has no white');
    else [reading.lab, reading.delta_e2000_to_white] = [all(out.slice(22, 25)), single(out[25])];
    if (status & 2) missing(['srgb', 'hex'], 'the light is not a white that can be adapted to D65');
    else {
      this.show(reading, out);
      if (!out[21]) note('srgb', 'the color is outside the gamut; this and hex are clipped');
    }
    for (const key of OF_THE_LIGHT.split(' ')) reading[key] ??= null;
    missing(OF_THE_LIGHT.split(' '), 'only a light has this number, and a surface has not');
    for (const remark of remarks(source, rule, true)) note('data', remark);
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
