// The crate's command-line examples, to compare with.
import { execFileSync, spawnSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../../../', import.meta.url));
const target = process.env.CARGO_TARGET_DIR ?? `${root}target`;

/** Builds them, once. */
export function build() {
  execFileSync(
    'cargo',
    ['build', '--quiet', '--release', '--example', 'colorimeter', '--example', 'scene', '--example', 'paint'],
    { cwd: root, stdio: 'inherit' },
  );
}

/** @param {string} example @param {string[]} args @param {string} [input] @returns {object[]} the JSON of each line */
export function json(example, args, input = '') {
  const done = run(example, ['--json', ...args], input);
  if (done.status !== 0) throw new Error(done.stderr);
  return done.stdout
    .trim()
    .split('\n')
    .map((line) => JSON.parse(line));
}

/** @returns {{status: number, stdout: string, stderr: string}} */
export function run(example, args, input = '') {
  return spawnSync(`${target}/release/examples/${example}`, args, { input, encoding: 'utf8', maxBuffer: 1 << 28 });
}
