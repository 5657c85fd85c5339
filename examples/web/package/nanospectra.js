// nanospectra in JavaScript, a typed wrapper around WebAssembly modules. It has no dependencies and fetches nothing but
// the package's own files. Here the plain build or the one for vectors (simd128) is chosen.
import { read } from './read.js';
import { unpack } from './tables.js';

/** The CIE 1931 functions, which are also the first table of `light`. */
const CIE_1931 = 'cie1931.tables';
/** The class and the tables of each module; some only need the CIE 1931 functions, and `light` needs every table. */
const MODULES = {
  light: { of: async () => (await import('./light.js')).Light, tables: 'light.tables' },
  paint: { of: async () => (await import('./paint.js')).Paint, tables: CIE_1931 },
  scene: { of: async () => (await import('./scene.js')).Scenes },
  core: { of: async () => (await import('./core.js')).Core, tables: CIE_1931 },
  bands: { of: async () => (await import('./bands.js')).Bands },
};

/** A tiny module with one v128.const in it, to find out whether vectors are supported. */
const SIMD = Uint8Array.from('0061736d010000000105016000017b030201000a0a0108004100fd0ffd620b'.match(/../g), (byte) => parseInt(byte, 16));

/**
 * Returns the exports of a module whose measured tables are in place. The tables come packed, and are written into the
 * memory that the module leaves free for them before anything runs.
 * @param {URL} wasm @param {URL | Float32Array[]} [tables] where they are, or what they are
 * @returns {Promise<{exports: Record<string, any>, tables: Float32Array[]}>}
 */
async function instantiate(wasm, tables) {
  const [code, packed] = await Promise.all([read(wasm), tables instanceof URL ? read(tables) : Uint8Array.of(0)]);
  const module = await WebAssembly.compile(code),
    { exports } = await WebAssembly.instantiate(module, {});
  const unpacked = Array.isArray(tables) ? tables : unpack(packed),
    [places] = WebAssembly.Module.customSections(module, 'places');
  const pairs = new Uint32Array(places);
  for (let k = 0; k < pairs.length; k += 2) {
    const table = unpacked[pairs[k]];
    new Float32Array(exports.memory.buffer, pairs[k + 1], table.length).set(table);
  }
  return { exports, tables: unpacked };
}

/**
 * Loads a module: `light` (every number about a spectrum), `paint` (spectra for RGB colors), `scene` (light through
 * filters, surfaces and other parts), `core` (the smallest: a spectrum to XYZ, CCT, Lab and sRGB, and a spectrum for an
 * RGB color) or `bands` (many spectra of one instrument to XYZ). Each is a WebAssembly module of its own, which is
 * fetched when it is loaded. `tables` are those of a module that is loaded already; then `paint` and `core` fetch none.
 * @param {{module?: 'light' | 'paint' | 'scene' | 'core' | 'bands', base?: string | URL, simd?: boolean, tables?: Float32Array[]}} [options]
 */
export async function load({ module = 'light', base = import.meta.url, simd = WebAssembly.validate(SIMD), tables: known } = {}) {
  const chosen = Object.hasOwn(MODULES, module) && MODULES[module];
  if (!chosen) throw new Error(`there is no module ${module}; use one of ${Object.keys(MODULES).join(', ')}`);
  const [Module, { exports, tables }] = await Promise.all([
    chosen.of(),
    instantiate(
      new URL(`${module}${simd ? '.simd' : ''}.wasm`, base),
      chosen.tables === CIE_1931 && known?.length ? known.slice(0, 1) : chosen.tables && new URL(chosen.tables, base),
    ),
  ]);
  return new Module(exports, simd, tables, base);
}
