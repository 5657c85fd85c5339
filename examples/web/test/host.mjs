// Runs the program `nanospectra`, with whose results those of the package and the page are compared.
import { execFileSync, spawnSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../../../', import.meta.url));
const target = process.env.CARGO_TARGET_DIR ?? `${root}target`;

/** Builds the program. */
export function build() {
  execFileSync('cargo', ['build', '--quiet', '--release', '-p', 'nanospectra-cli'], { cwd: root, stdio: 'inherit' });
}

/** @param {string} command @param {string[]} args @param {string} [input] @returns {object[]} the JSON of each line */
export function json(command, args, input = '') {
  const done = run(command, ['--json', ...args], input);
  if (done.status !== 0) throw new Error(done.stderr);
  return done.stdout
    .trim()
    .split('\n')
    .map((line) => JSON.parse(line));
}

/** @returns {{status: number, stdout: string, stderr: string}} */
export function run(command, args, input = '') {
  const options = { input, encoding: 'utf8', maxBuffer: 1 << 28 };
  return spawnSync(`${target}/release/nanospectra`, [command, ...args], options);
}
