// The sizes that each file has on record and may have. NANOSPECTRA_BLESS=1 records the measured sizes in sizes.json and
// in both READMEs.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';

// The limits, which hold whatever is on record.
const MOST = {
  // These are sizes before compression.
  'core.wasm': 8192,
  'core.simd.wasm': 8192,
  'light.wasm': 26624,
  'light.simd.wasm': 26624,
  'paint.wasm': 30720,
  'paint.simd.wasm': 30720,
  'scene.wasm': 26112,
  'scene.simd.wasm': 26112,
  'bands.wasm': 1950,
  'bands.simd.wasm': 2400,
  'cie1931.tables': 2200,
  'light.tables': 21000,
  // These are compressed by brotli, without the bundled lamps: the files to measure a spectrum, and those of all tabs.
  'first-tab.br': 61440,
  'page.br': 102400,
};

const RECORD = new URL('sizes.json', import.meta.url);
const READMES = ['../README.md', '../package/README.md'].map((path) => new URL(path, import.meta.url));
const ROW = /^(\| `([a-z.0-9-]+\.(?:wasm|tables|br))`.*\| )([\d.]+)( \|)$/gm;

const read = (url) => readFileSync(url, 'utf8');
const recorded = () => JSON.parse(read(RECORD));
const kilobytes = (size) => (size / 1000).toFixed(1);

/** Checks that a size is within the limits and within 2 % of the record. @param {string} what @param {number} size */
export function allowed(what, size) {
  console.log(`${what}: ${size} bytes`);
  assert.ok(size <= MOST[what], `${what}: ${size} bytes, ${MOST[what]} allowed`);
  if (process.env.NANOSPECTRA_BLESS) return record(what, size);
  const was = recorded()[what];
  assert.ok(Math.abs(size / was - 1) < 0.02, `${what}: ${size} bytes, ${was} on record; cargo xtask bless records`);
}

/** @param {string} what @param {number} size */
function record(what, size) {
  writeFileSync(RECORD, `${JSON.stringify({ ...recorded(), [what]: size }, null, 2)}\n`);
  const renewed = (row, before, name, _, after) => (name === what ? before + kilobytes(size) + after : row);
  for (const readme of READMES) writeFileSync(readme, read(readme).replace(ROW, renewed));
}

/** Checks that the READMEs state the sizes on record, to a tenth of a KB. */
export function stated() {
  if (process.env.NANOSPECTRA_BLESS) return;
  const record = recorded();
  for (const readme of READMES) {
    const rows = [...read(readme).matchAll(ROW)];
    assert.ok(rows.length >= 7, `${readme}: ${rows.length} rows`);
    for (const [, , name, size] of rows) assert.equal(size, kilobytes(record[name]), `${readme}: ${name}`);
  }
}

/** The modules and tables of the package. */
export const FILES = Object.keys(MOST).filter((name) => !name.endsWith('.br'));
