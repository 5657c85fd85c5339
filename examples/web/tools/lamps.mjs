// The CIE's lamps for the page, from the crate's tables.
import { files, read } from './tables.mjs';

/**
 * Every lamp as published; of two tables of the same lamps the one every 5 nm.
 * @param {string[]} illuminants what `light::NAMES` lists
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
  // In the order of the crate. E has no table.
  const wanted = illuminants.filter((name) => name !== 'E' && !name.endsWith('_1NM'));
  const found = wanted.map((wanted) => lamps.find(({ name }) => name === wanted));
  if (found.includes(undefined) || lamps.length !== wanted.length)
    throw new Error(`tables/illuminants has ${lamps.map(({ name }) => name)}, and light::NAMES ${wanted}`);
  return found;
}
