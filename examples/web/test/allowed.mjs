// How many bytes each file may have: the one table. Less than nine tenths of it fails as well: then lower the number.
import assert from 'node:assert/strict';

const MOST = {
  // Before compression.
  'core.wasm': 8192,
  'core.simd.wasm': 8192,
  'light.wasm': 24576,
  'light.simd.wasm': 24576,
  'paint.wasm': 23500,
  'paint.simd.wasm': 23500,
  'scene.wasm': 24576,
  'scene.simd.wasm': 24576,
  'bands.wasm': 1950,
  'bands.simd.wasm': 2400,
  'cie1931.tables': 2200,
  'light.tables': 21000,
  // By brotli: what measuring a spectrum takes, and all four tabs, without the bundled lamps.
  'first-tab.br': 61440,
  'page.br': 96000,
};

/** Is the size within what is allowed, and no less than nine tenths of it? @param {string} what @param {number} size */
export function stands(what, size) {
  const most = MOST[what];
  assert.ok(size <= most, `${what}: ${size} bytes, ${most} allowed`);
  assert.ok(size > 0.9 * most, `${what}: ${size} bytes, and ${most} allowed: too loose`);
}

/** The same, aloud. @param {string} what @param {number} size */
export function allowed(what, size) {
  console.log(`${what}: ${size} bytes`);
  stands(what, size);
}

/** The modules and tables of the package. */
export const FILES = Object.keys(MOST).filter((name) => !name.endsWith('.br'));
