// nanospectra in JavaScript: a typed wrapper around a WebAssembly module of a few KB. No dependencies, no network but for
// the module's own files; the plain or the simd128 build is chosen here.
import { read } from './read.js';
import { unpack } from './tables.js';

/** What each module does, and the tables that it needs: the eye of 1931, or all that measuring takes. */
const MODULES = {
  light: { of: async () => (await import('./light.js')).Light, tables: 'light.tables' },
  paint: { of: async () => (await import('./paint.js')).Paint, tables: 'cie1931.tables' },
  scene: { of: async () => (await import('./scene.js')).Scenes },
  core: { of: async () => (await import('./core.js')).Core, tables: 'cie1931.tables' },
  bands: { of: async () => (await import('./bands.js')).Bands },
};

/** An empty module with one v128.const in it. */
const SIMD = Uint8Array.from('0061736d010000000105016000017b030201000a0a0108004100fd0ffd620b'.match(/../g), (byte) => parseInt(byte, 16));

/**
 * A module's exports, its measured tables in place: they come packed, and go where the module has room for them before
 * anything runs.
 * @param {URL} wasm @param {URL} [tables]
 * @returns {Promise<{exports: Record<string, any>, tables: Float32Array[]}>}
 */
async function instantiate(wasm, tables) {
  const [code, packed] = await Promise.all([read(wasm), tables ? read(tables) : Uint8Array.of(0)]);
  const module = await WebAssembly.compile(code),
    { exports } = await WebAssembly.instantiate(module, {});
  const unpacked = unpack(packed),
    [places] = WebAssembly.Module.customSections(module, 'places');
  const pairs = new Uint32Array(places);
  for (let k = 0; k < pairs.length; k += 2) {
    const table = unpacked[pairs[k]];
    new Float32Array(exports.memory.buffer, pairs[k + 1], table.length).set(table);
  }
  return { exports, tables: unpacked };
}

/**
 * Loads a module: `light` (every number about a spectrum), `paint` (RGB to spectra), `scene` (light through what it
 * meets), `core` (a small one: spectrum to XYZ, CCT, Lab, sRGB; RGB to spectrum) or `bands` (many spectra of an instrument
 * to XYZ). Each is one WebAssembly module; what is not loaded is not fetched.
 * @param {{module?: 'light' | 'paint' | 'scene' | 'core' | 'bands', base?: string | URL, simd?: boolean}} [options]
 */
export async function load({ module = 'light', base = import.meta.url, simd = WebAssembly.validate(SIMD) } = {}) {
  const chosen = Object.hasOwn(MODULES, module) && MODULES[module];
  if (!chosen) throw new Error(`no module ${module}; use ${Object.keys(MODULES).join(', ')}`);
  const [Module, { exports, tables }] = await Promise.all([
    chosen.of(),
    instantiate(
      new URL(`${module}${simd ? '.simd' : ''}.wasm`, base),
      chosen.tables && new URL(chosen.tables, base),
    ),
  ]);
  return new Module(exports, simd, tables, base);
}
