// The CIE's lamps for the page, from the crate's tables.
import { read } from './tables.mjs';

const FILES = [
  'A_1nm',
  'C_5nm',
  'D50_1nm',
  'D55_5nm',
  'D65_1nm',
  'D75_5nm',
  'ID50_5nm',
  'ID65_5nm',
  'FL_5nm',
  'HP_5nm',
  'LED_5nm',
  'L41_1nm',
];

/** @returns {{name: string, first: number, step: number, values: number[]}[]} as `light::named` has them */
export function lamps() {
  return FILES.flatMap((file) => {
    const { nm, names, columns } = read(`illuminants/${file}`);
    return names.map((name, k) => ({ name, first: nm[0], step: nm[1] - nm[0], values: columns[k] }));
  });
}
