// Many spectra of an instrument at once.

/** Up to 1024 spectra at 380, 385 .. 780 nm at once: write to `spectra`, call `measure`, read `xyz`; views, no copies. */
export class Bands {
  /** @param {Record<string, any>} wasm @param {boolean} simd */
  constructor(wasm, simd) {
    this.simd = simd;
    this.spectra = new Float32Array(wasm.memory.buffer, wasm.spectra(), 81 * 1024);
    this.xyz = new Float32Array(wasm.memory.buffer, wasm.xyz(), 3 * 1024);
    /** @type {(count: number) => void} sums with the CIE 1931 functions, for the first `count` */
    this.measure = wasm.measure;
  }
}
