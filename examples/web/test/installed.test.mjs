// Tests the package as a user gets it: packs it, installs it elsewhere, runs the example of its README and compiles its
// types.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';

const here = (path) => fileURLToPath(new URL(`../${path}`, import.meta.url));
const compiler = here('node_modules/.bin/tsc'),
  bundler = here('node_modules/.bin/esbuild');
const npmIsHere = spawnSync('npm', ['--version']).status === 0;

test('what npm packs is installed elsewhere, and its README is right', { skip: !npmIsHere && 'npm is not here' }, () => {
  const folder = mkdtempSync(join(tmpdir(), 'nanospectra-package-'));
  try {
    const npm = (...args) => execFileSync('npm', [...args, '--silent'], { cwd: folder, encoding: 'utf8' });
    const packed = npm('pack', here('dist/nanospectra')).trim();
    writeFileSync(join(folder, 'package.json'), '{ "type": "module", "private": true }');
    npm('install', '--offline', `./${packed}`);
    const [, example] = /```js\n([\s\S]*?)```/.exec(readFileSync(here('package/README.md'), 'utf8'));
    const told = 'console.log(JSON.stringify([reading.cct_k, batch.results[3], red.lights[1].name, XYZ[1], bill.length]));';
    writeFileSync(join(folder, 'example.js'), example + told);
    const [kelvin, ra, lamp, y, parts] = JSON.parse(
      execFileSync(process.execPath, ['example.js'], { cwd: folder, encoding: 'utf8' }),
    );
    assert.ok(kelvin > 4000 && kelvin < 6000 && ra > 50 && ra < 90, `${kelvin} K, Ra ${ra}`);
    assert.deepEqual([lamp, parts], ['A', 2]);
    assert.ok(y > 10 && y < 70, `Y ${y}`);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
});

test('a bundler for browsers takes it as it is', { skip: !existsSync(bundler) && 'npm ci brings the bundler' }, () => {
  const options = ['--bundle', '--format=esm', '--platform=browser', '--log-level=error'];
  const bundle = execFileSync(bundler, [here('dist/nanospectra/nanospectra.js'), ...options], { encoding: 'utf8' });
  assert.match(bundle, /WebAssembly/);
});

test('its types are those of what it does', { skip: !existsSync(compiler) && 'npm ci brings the compiler' }, () => {
  const options = ['--noEmit', '--strict', '--module', 'nodenext', '--target', 'es2022'];
  execFileSync(compiler, [...options, here('test/types.ts')], { stdio: ['ignore', 'inherit', 'inherit'] });
});
