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
  return reports(done.stdout);
}

/**
 * Returns the reports of an output in JSON, without the keys `read` and `stated`: they say where in a file the numbers
 * stand and what else it says, and the package is given numbers and not files. Its parser assumes nothing, which is the option `--strict` of `measure`.
 * @param {string} stdout @returns {object[]}
 */
export const reports = (stdout) =>
  stdout
    .trim()
    .split('\n')
    .map((line) => JSON.parse(line))
    .map(({ read, stated, ...report }) => report);

/** @param {string[]} args @param {string} [input] @returns {object[]} what `measure` reports about spectra */
export const measured = (args, input) => json('measure', ['--strict', ...args], input);

/** @returns {{status: number, stdout: string, stderr: string}} */
export function run(command, args, input = '') {
  const options = { input, encoding: 'utf8', maxBuffer: 1 << 28 };
  return spawnSync(`${target}/release/nanospectra`, [command, ...args], options);
}
