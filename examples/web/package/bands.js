// The module `bands`, which turns many spectra of one instrument into XYZ at once.

/**
 * Up to 1024 spectra at 380, 385 .. 780 nm: write to `spectra`, call `measure` and read `xyz`. Both arrays are views of
 * the module's memory, so nothing is copied.
 */
export class Bands {
  /** @param {Record<string, any>} wasm @param {boolean} simd */
  constructor(wasm, simd) {
    this.simd = simd;
    this.spectra = new Float32Array(wasm.memory.buffer, wasm.spectra(), 81 * 1024);
    this.xyz = new Float32Array(wasm.memory.buffer, wasm.xyz(), 3 * 1024);
    /** @type {(count: number) => void} computes `xyz` of the first `count` spectra by sums with the CIE 1931 functions */
    this.measure = wasm.measure;
  }
}
