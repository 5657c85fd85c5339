// Builds the package and the page: node tools/build.mjs
//
// Each module is built plain and with simd128. The measured tables are taken out of its data and packed into one file
// for both builds. A section `places` of the module says where in memory they belong.
import { execFileSync } from 'node:child_process';
import { cpSync, existsSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { unpack } from '../package/tables.js';
import { pack } from './pack.mjs';
import { cie1931, light } from './tables.mjs';
import { custom, dataSection, module, sections, segments } from './wasm.mjs';
import { lamps } from './lamps.mjs';
import { lists, source } from './lists.mjs';
import { scenes } from './scenes.mjs';

const here = (path) => fileURLToPath(new URL(`../${path}`, import.meta.url));
const target = process.env.CARGO_TARGET_DIR ?? here('target');

/** Installs what the build needs, and what makes its results smaller; without the latter they are used as they are. */
function ready() {
  const said = (command, args) => execFileSync(command, args, { cwd: here(''), encoding: 'utf8' });
  if (!said('rustup', ['target', 'list', '--installed']).includes('wasm32-unknown-unknown'))
    said('rustup', ['target', 'add', 'wasm32-unknown-unknown']);
  if (existsSync(here('node_modules'))) return;
  try {
    said('npm', ['ci', '--silent']);
  } catch (error) {
    console.log(`npm ci failed, so the modules and scripts are larger than necessary: ${error.message}`);
  }
}

/** The modules that are built for size, and the tables with which each is loaded. */
const MODULES = { core: 'cie1931', light: 'light', paint: 'cie1931', scene: null };

/** @param {string} feature @param {boolean} simd @returns {Uint8Array} */
function compile(feature, simd) {
  const directory = `${target}/${simd ? 'simd128' : 'plain'}`,
    profile = ['bands', 'bench'].includes(feature) ? 'fast' : 'small';
  // The feature `simd` computes all rows in one pass, which only pays for the modules that are built for speed.
  const features = simd && profile === 'fast' ? `${feature},simd` : feature;
  // The modules must not contain paths of this machine.
  const flags = [`--remap-path-prefix=${here('../../')}=`, ...(simd ? ['-Ctarget-feature=+simd128'] : [])];
  // Less inlining saves a tenth of the code. With a smaller stack the data lies below 1 MB, where an address takes a byte
  // less.
  if (feature in MODULES) flags.push('-Cllvm-args=-inline-threshold=10', '-Clink-arg=-zstack-size=131072');
  const env = { ...process.env, CARGO_TARGET_DIR: directory, CARGO_ENCODED_RUSTFLAGS: flags.join('\x1f') };
  execFileSync(
    'cargo',
    ['build', '--quiet', '--profile', profile, '--no-default-features', '--features', features],
    { cwd: here(''), stdio: 'inherit', env },
  );
  return readFileSync(`${directory}/wasm32-unknown-unknown/${profile}/nanospectra_web.wasm`);
}

/**
 * Takes tables out of the data of a module.
 * @param {Uint8Array} wasm @param {Iterable<[number, Float32Array]>} tables and their numbers
 * @returns {Uint8Array} the module, without what only debuggers read
 */
function without(wasm, tables) {
  const parts = sections(wasm).filter(({ id }) => id !== 0);
  const data = segments(parts.find(({ id }) => id === 11)?.body ?? [0]);
  const places = [...tables].flatMap(([k, table]) => {
    const bytes = Buffer.from(table.buffer, table.byteOffset, table.byteLength);
    for (const segment of data) {
      const at = Buffer.from(segment.bytes.buffer, segment.bytes.byteOffset, segment.bytes.length).indexOf(bytes);
      if (at >= 0) {
        segment.bytes.fill(0, at, at + bytes.length);
        return [k, segment.address + at];
      }
    }
    throw new Error(`table ${k} is not in the module's data: tools/tables.mjs and the crate disagree`);
  });
  const rest = parts.map((part) => (part.id === 11 ? dataSection(data) : part));
  return module(places.length ? [...rest, custom('places', new Uint8Array(Uint32Array.from(places).buffer))] : rest);
}

const OPTIMIZER = here('node_modules/binaryen/bin/wasm-opt');

/** Makes a module a tenth smaller by Binaryen, or leaves it as it is without `npm ci`. @param {Uint8Array} wasm */
function smaller(wasm) {
  if (!existsSync(OPTIMIZER)) return wasm;
  const enabled = ['simd', 'bulk-memory', 'sign-ext', 'mutable-globals', 'nontrapping-float-to-int'];
  // The option is allowed because nothing is in the first kilobyte of memory, which only a full stack would reach.
  const options = ['-Oz', '--flatten', '--rereloop', '-Oz', '-Oz', '--converge', '--low-memory-unused', ...enabled.map((feature) => `--enable-${feature}`)];
  const [before, after] = [here('dist/before.wasm'), here('dist/after.wasm')];
  writeFileSync(before, wasm);
  execFileSync(process.execPath, [OPTIMIZER, before, ...options, '-o', after], { stdio: 'inherit' });
  const small = readFileSync(after);
  rmSync(before);
  rmSync(after);
  return small;
}

/** Removes comments that have lines of their own, and indentation. */
const lean = (text) =>
  text
    .replace(/^\s*\/\*\*?[\s\S]*?\*\/\s*$/gm, '')
    .replace(/^\s*\/\/.*$/gm, '')
    .replace(/^\s+/gm, '');

/** Packs the scripts and the style of the page by esbuild, or leaves them as they are without `npm ci`. */
async function bundle() {
  const esbuild = await import('esbuild').catch(() => null);
  if (!esbuild) return;
  const outputs = esbuild.buildSync({
    entryPoints: ['app.js', 'style.css'].map((file) => here(`dist/page/${file}`)),
    bundle: true,
    splitting: true,
    minify: true,
    write: false,
    format: 'esm',
    target: 'es2022',
    legalComments: 'none',
    logLevel: 'error',
    // The page does not use these modules.
    external: ['./core.js', './bands.js'],
    chunkNames: '[name]-[hash]',
    outdir: here('dist/page'),
  }).outputFiles;
  for (const file of readdirSync(here('dist/page'), { recursive: true }))
    if (file.endsWith('.js')) rmSync(here(`dist/page/${file}`));
  for (const { path, contents } of outputs) writeFileSync(path, contents);
}

/** Returns the recorded instructions from N bands to X, Y, Z by target, whether folded or not, profile and N. */
function instructions() {
  const counts = {};
  for (const line of readFileSync(here('../../tests/data/instructions.txt'), 'utf8').split('\n')) {
    const found = /^(\S+) (\S+) (xyz|path-surface)-(\d+) (\d+) instructions$/.exec(line);
    if (!found) continue;
    const [, target, profile, what, bands, count] = found;
    const kind = what === 'xyz' ? 'folded' : 'walked';
    (((counts[target] ??= {})[kind] ??= {})[profile] ??= {})[bands] = Number(count);
  }
  return counts;
}

export async function build() {
  ready();
  rmSync(here('dist'), { recursive: true, force: true });
  cpSync(here('page'), here('dist/page'), { recursive: true });
  cpSync(here('package'), here('dist/nanospectra'), { recursive: true });
  for (const license of ['LICENSE-MIT', 'LICENSE-APACHE', 'LICENSE-CC-BY-SA-4.0'])
    cpSync(here(`../../${license}`), here(`dist/nanospectra/${license}`));
  const sizes = {};
  const save = (name, bytes) => {
    writeFileSync(here(`dist/nanospectra/${name}`), bytes);
    sizes[name] = bytes.length;
  };
  writeFileSync(here('dist/page/instructions.json'), JSON.stringify(instructions()));
  writeFileSync(here('dist/page/scenes.json'), JSON.stringify(scenes()));
  const names = lists(compile('lists', false));
  for (const [name, text] of Object.entries(source(names))) writeFileSync(here(`dist/nanospectra/${name}`), text);
  writeFileSync(here('dist/nanospectra/lamps.json'), JSON.stringify(lamps(names.illuminants)));
  const packed = Object.fromEntries(Object.entries({ cie1931, light }).map(([name, list]) => [name, pack(list)]));
  for (const [name, bytes] of Object.entries(packed)) save(`${name}.tables`, bytes);
  for (const [name, tables] of Object.entries(MODULES)) {
    const taken = tables ? [...unpack(packed[tables]).entries()] : [];
    for (const simd of [false, true])
      save(`${name}${simd ? '.simd' : ''}.wasm`, smaller(without(compile(name, simd), taken)));
  }
  for (const simd of [false, true]) save(`bands${simd ? '.simd' : ''}.wasm`, without(compile('bands', simd), []));
  cpSync(here('dist/nanospectra'), here('dist/page/nanospectra'), { recursive: true });
  for (const file of readdirSync(here('dist/page'), { recursive: true })) {
    const path = here(`dist/page/${file}`);
    if (/\.(js|css|html)$/.test(file)) writeFileSync(path, lean(readFileSync(path, 'utf8')));
    // All modules of the page have the tables of the module `light`.
    else if (/\.d\.ts$|README|LICENSE|package\.json|core\.(js|wasm|simd)|bands\.|cie1931\.tables/.test(file)) rmSync(path);
  }
  await bundle();
  const files = readdirSync(here('dist/page'), { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile() && entry.name !== 'worker.js')
    .map((entry) => `${entry.parentPath ?? entry.path}/${entry.name}`.slice(here('dist/page/').length));
  const worker = readFileSync(here('page/worker.js'), 'utf8');
  writeFileSync(here('dist/page/worker.js'), `const FILES=${JSON.stringify(['./', ...files])};\n${lean(worker)}`);
  return sizes;
}

/** Builds the modules with which speeds and the errors of the tab Cost are compared. */
export function buildBench() {
  for (const simd of [false, true])
    writeFileSync(here(`dist/bench${simd ? '.simd' : ''}.wasm`), compile('bench', simd));
  writeFileSync(here('dist/cost.wasm'), compile('cost', false));
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  console.table(await build());
  if (process.argv.includes('--bench')) buildBench();
}
