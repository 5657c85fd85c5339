// The small module `core`: a light to XYZ, CCT and sRGB; Lab; an sRGB color to a spectrum.
import { Instrument, labOf } from './instrument.js';
import { all, decoded, encoded, hex, single, three } from './numbers.js';
import { ruleOf, sourceOf, wrong } from './samples.js';

/** The functions of the module `core`. */
export class Core extends Instrument {
  /**
   * Computes XYZ (with Y = 100), chromaticities, CCT, Duv and the display color of a light.
   * @param {Parameters<typeof sourceOf>[0]} samples
   */
  spectrum(samples, { name = 'samples' } = {}) {
    const source = sourceOf(samples, name);
    this.readLight(source, ruleOf(source, 'auto'));
    if (this.wasm.see_light(0)) throw wrong(source, this.dark(0));
    const { out } = this;
    return {
      XYZ: all(out.slice(0, 3)),
      xy: all(out.slice(6, 8)),
      uv1960: all(out.slice(8, 10)),
      uv1976: all(out.slice(10, 12)),
      cct_k: single(out[12]),
      duv: single(out[13]),
      hex: hex(Array.from(out.slice(15, 18), (x) => Math.round(255 * encoded(x)))),
    };
  }

  /** Returns L*, a*, b* relative to a white, or null if that is not a white. @param {number[]} xyz @param {number[]} white */
  lab(xyz, white) {
    return labOf(this, xyz, white);
  }

  /**
   * Returns a reflectance at 400, 410 .. 700 nm that has this encoded sRGB color, or null if no smooth one has it.
   * @param {[number, number, number]} rgb 0..1
   */
  upsample(rgb) {
    rgb = three(rgb, 'rgb');
    if (!rgb.every(Number.isFinite))
      throw new Error('the numbers are too large, and the spectrum is not finite; give smaller numbers (0..1 for surfaces)');
    if (this.wasm.upsample(...rgb.map(decoded))) return null;
    return { first_nm: 400, step_nm: 10, values: Array.from(this.out.slice(0, 31), single) };
  }
}
