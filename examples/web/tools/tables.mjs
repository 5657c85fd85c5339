// Reads the published tables that the modules hold, as numbers for package/tables.js.
import { readFileSync, readdirSync } from 'node:fs';
import { RULES } from '../package/tables.js';

const folder = new URL('../../../tables/', import.meta.url);

/** Returns the tables of a folder whose names have this end. @param {string} place @param {string} end @returns {string[]} */
export const files = (place, end) =>
  readdirSync(new URL(place, folder))
    .filter((file) => file.endsWith(`${end}.csv`))
    .map((file) => `${place}/${file.slice(0, -4)}`)
    .sort();

/** @param {string} path @returns {{nm: number[], names: string[], columns: number[][]}} */
export function read(path) {
  const text = readFileSync(new URL(`${path}.csv`, folder), 'utf8');
  const rows = text
    .trim()
    .split('\n')
    .filter((line) => !line.startsWith('#'))
    .map((line) => line.split(','));
  const names = rows.shift().slice(1);
  const cell = (text) => (Math.abs(Number(text)) < 1e-30 ? 0 : Number(text));
  return {
    nm: rows.map((row) => Number(row[0])),
    names,
    columns: names.map((_, k) => rows.map((row) => cell(row[k + 1]))),
  };
}

/** Returns the 1 nm table of an observer, with zeros up to 360..830 nm. */
function eye(path) {
  const { nm, columns } = read(path);
  return { rule: RULES.plain, before: nm[0] - 360, behind: 830 - nm.at(-1), columns };
}

/** Returns the test color samples every 5 nm of 360..830 nm; the last file has fewer, and its end values are held. */
function test(path, last) {
  const { nm, columns } = read(path),
    further = read(last);
  const held = further.columns.map((column) =>
    nm.map((nm) => column[further.nm.indexOf(Math.min(Math.max(nm, further.nm[0]), further.nm.at(-1)))]),
  );
  return { rule: RULES.test, before: 0, behind: 0, columns: [...columns, ...held] };
}

/** Returns every fifth row of the 1 nm table of color evaluation samples. */
function samples(path) {
  const every = read(path).columns.map((column) => column.filter((_, k) => k % 5 === 0));
  return { rule: RULES.sample, before: 0, behind: 0, columns: every };
}

function daylight() {
  const { columns } = read('illuminants/daylight_components_5nm');
  return columns.map((column) => ({ rule: RULES.plain, before: 0, behind: 0, columns: [column] }));
}

/** Makes a table that copies column `column` of table `table`. */
const copy = (table, column, rows) => ({
  rule: RULES.copy,
  before: 0,
  behind: 0,
  columns: [[table, column, rows]],
});

const FIRST_EYE = 'cmf/cie_1931_2deg_xyz_1nm',
  eye1931 = eye(FIRST_EYE);

/** The table of the CIE 1931 functions alone. */
export const cie1931 = [eye1931];

/** The tables of the module `light`, in which V(lambda) is a copy of y-bar. */
export const light = [
  eye1931,
  copy(0, 1, 471),
  eye('cmf/alpha_opic_s026_1nm'),
  ...daylight(),
  test('samples/cri_tcs14_5nm', 'samples/cri_tcs15_5nm'),
  { rule: RULES.lights, before: 0, behind: 0, columns: [[0, 6]] },
  { rule: RULES.daylight, before: 0, behind: 0, columns: [[0, 6, 3, 4, 5]] },
  samples('samples/cie224_ces99_1nm'),
  // All other observers.
  ...files('cmf', '_xyz_1nm').filter((file) => file !== FIRST_EYE).map(eye),
];
