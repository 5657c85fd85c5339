// Measures the speed of the modules: node examples/web/tools/build.mjs --bench && node examples/web/bench.mjs
//
// It prints wall time on one machine, the best of many runs. No test depends on it.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { load } from './dist/nanospectra/nanospectra.js';

const BUILDS = [
  ['plain', false],
  ['simd128', true],
];

/** Returns the best of three hundred runs, in ms, since other work of the machine can only add to it. */
function time(work) {
  let best = Infinity;
  for (let k = 0; k < 300; k++) {
    const start = performance.now();
    work();
    best = Math.min(best, performance.now() - start);
  }
  return best;
}

/** Times 318 lights with CRI, to compare with the 16 ms of a frame. */
async function batches(name, simd) {
  const spectra = await load({ simd }),
    lamps = [...(await spectra.loadLamps()).values()],
    batch = spectra.batch(318);
  const readings = lamps.map((lamp) => spectra.spectrum(lamp));
  for (let k = 0; k < 318; k++) batch.lights.set(readings[k % lamps.length].curve, 471 * k);
  batch.measure();
  readings.forEach(({ cri_ra }, k) => assert.equal(batch.results[20 * k + 3], Math.fround(cri_ra ?? NaN)));
  console.log(`318 lights with CRI, ${name}: ${time(batch.measure).toFixed(1)} ms`);
}

/** Times three sums over 81 bands, and a plain loop over the same. */
async function sums(name, simd) {
  const wasm = readFileSync(new URL(`dist/bench${simd ? '.simd' : ''}.wasm`, import.meta.url));
  const { exports } = (await WebAssembly.instantiate(wasm)).instance;
  const spectra = new Float32Array(exports.memory.buffer, exports.spectra(), 81 * 1024),
    xyz = new Float32Array(exports.memory.buffer, exports.xyz(), 3 * 1024);
  spectra.forEach((_, k) => {
    spectra[k] = ((k * 7919) % 1024) / 1024;
  });
  exports.measure_plainly(1024);
  const plainly = xyz.slice();
  exports.measure(1024);
  xyz.forEach((sum, k) => assert.ok(Math.abs(sum - plainly[k]) <= 1e-5 * plainly[k], `sum ${k}`));
  const rounds = 10;
  const ns = (work) =>
    (time(() => {
      for (let k = 0; k < rounds; k++) work(1024);
    }) *
      1e6) /
    (rounds * 1024);
  const [eight, plain] = [ns(exports.measure), ns(exports.measure_plainly)];
  console.log(`3 x 81 sums, ${name}: ${eight.toFixed(1)} ns, a plain loop ${plain.toFixed(1)} ns`);
}

for (const [name, simd] of BUILDS) {
  await batches(name, simd);
  await sums(name, simd);
}
