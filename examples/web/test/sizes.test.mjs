// Tests the sizes of all files against the limits and the record.
import assert from 'node:assert/strict';
import { existsSync, readFileSync, readdirSync, statSync } from 'node:fs';
import test from 'node:test';
import { brotliCompressSync } from 'node:zlib';
import { FILES, allowed, stated } from './allowed.mjs';

const unpacked = existsSync(new URL('../dist/page/light.js', import.meta.url));
const skip = unpacked && 'not packed: npm ci brings what packs the modules and the page';

test('sizes of the modules and their tables, before compression', { skip }, () => {
  for (const name of FILES) allowed(name, statSync(new URL(`../dist/nanospectra/${name}`, import.meta.url)).size);
});

test('the READMEs state the sizes on record', stated);

test('what a browser fetches for all of the page, compressed, without the bundled lamps', { skip }, () => {
  const sizes = readdirSync(new URL('../dist/page/', import.meta.url), { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => `${entry.parentPath ?? entry.path}/${entry.name}`)
    // A browser fetches either the build with vectors or the one without.
    .filter((path) => !/lamps\.json|\/(light|paint|scene)\.wasm/.test(path))
    .map((path) => brotliCompressSync(readFileSync(path)).length);
  allowed(
    'page.br',
    sizes.reduce((sum, size) => sum + size, 0),
  );
});

test('no module carries the text of a panic or a path of the machine that built it', () => {
  for (const name of FILES.filter((name) => name.endsWith('.wasm'))) {
    const text = readFileSync(new URL(`../dist/nanospectra/${name}`, import.meta.url), 'latin1');
    assert.doesNotMatch(text, /panicked|index out of|unwrap|\/(home|root|tmp|usr|Users)\//, name);
  }
});
