// The module `paint`: the spectrum of a surface for an RGB color, and its color under lamps.
import { Instrument } from './instrument.js';
import { all, explained, hex, single, three } from './numbers.js';
import { wrong } from './samples.js';

const METHODS = ['sigmoid', 'basis', 'smits'];
const BEYOND = ['nearest', 'desaturate'];

/** The functions of the module `paint`. */
export class Paint extends Instrument {
  /**
   * Finds a reflectance at 380, 385 .. 780 nm that has this encoded sRGB color, and its color under other lights.
   * @param {[number, number, number]} rgb 0..1
   * @param {import('./nanospectra.d.ts').UpsampleOptions} [options]
   */
  upsample(rgb, { method = 'sigmoid', beyond = 'nearest', lights = [] } = {}) {
    const number = METHODS.indexOf(method);
    if (number < 0) throw new Error(`there is no method ${method}; use one of ${METHODS.join(', ')}`);
    if (!BEYOND.includes(beyond)) throw new Error(`beyond is ${beyond}; use one of ${BEYOND.join(', ')}`);
    if (!Array.isArray(lights)) throw new Error('lights is not a list; give an array of names and spectra');
    rgb = three(rgb, 'rgb');
    const state = this.wasm.upsample(...rgb, number, +(beyond === 'desaturate'));
    const out = this.out.slice(0, 86);
    if (!out.slice(0, 81).every(Number.isFinite) || !rgb.every(Number.isFinite)) {
      throw new Error('the numbers are too large, and the spectrum is not finite; give smaller numbers (0..1 for surfaces)');
    }
    const looks = ['D65', ...lights.filter((light) => String(light).toUpperCase() !== 'D65')].map((light) => {
      const source = this.lightOf(light);
      this.light.set(this.curve);
      if (this.wasm.paint_under()) throw wrong(source, this.dark(0));
      return {
        name: source.name,
        XYZ: all(this.out.slice(0, 3)),
        lab: all(this.out.slice(3, 6)),
        hex: hex(this.out.slice(6, 9)),
      };
    });
    const answer = {
      rgb: rgb.map((c) => single(Math.fround(c))),
      method,
      first_nm: 380,
      step_nm: 5,
      status: ['exact', 'unreachable', 'desaturated', 'unphysical', 'approximate'][state],
      spectrum: Array.from(out.slice(0, 81), single),
      roundtrip_rgb: all(out.slice(81, 84)),
      delta_e2000: single(out[84]),
      kept: single(out[85]),
      lights: looks,
      values_are: 'averages over bands',
      notes: [],
    };
    return explained(answer, { kept: 'the color is not desaturated' });
  }
}
