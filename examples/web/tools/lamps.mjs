// Makes lamps.json, the CIE's lamps, from the tables of the crate.
import { files, read } from './tables.mjs';

/**
 * Returns every lamp as published. Of two tables of the same lamps it takes the one with steps of 5 nm.
 * @param {string[]} illuminants the names of `light::NAMES`
 * @returns {{name: string, first: number, step: number, values: number[]}[]}
 */
export function lamps(illuminants) {
  const all = files('illuminants', ''),
    isSecond = (file) => file.endsWith('_1nm') && all.includes(file.replace('_1nm', '_5nm'));
  const lamps = all
    .filter((file) => !isSecond(file) && !file.endsWith('daylight_components_5nm'))
    .flatMap((file) => {
      const { nm, names, columns } = read(file);
      return names.map((name, k) => ({ name, first: nm[0], step: nm[1] - nm[0], values: columns[k] }));
    });
  // The lamps stand in the order of the crate. E has no table.
  const wanted = illuminants.filter((name) => name !== 'E' && !name.endsWith('_1NM'));
  const found = wanted.map((wanted) => lamps.find(({ name }) => name === wanted));
  if (found.includes(undefined) || lamps.length !== wanted.length)
    throw new Error(`tables/illuminants has ${lamps.map(({ name }) => name)}, and light::NAMES ${wanted}`);
  return found;
}
