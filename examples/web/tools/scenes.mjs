// Reads the scenes of examples/cli for the page.
import { readdirSync, readFileSync } from 'node:fs';
import { toml } from './toml.mjs';

const folder = new URL('../../cli/data/scenes/', import.meta.url);

/** @returns {Record<string, object>} the scenes by name */
export function scenes() {
  return Object.fromEntries(
    readdirSync(folder)
      .filter((file) => file.endsWith('.toml'))
      .sort()
      .map((file) => [file.replace('.toml', ''), toml(readFileSync(new URL(file, folder), 'utf8'))]),
  );
}
