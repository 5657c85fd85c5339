// What all tabs share: the module that measures, and the state that the link carries.
import { OBSERVERS } from './nanospectra/lists.js';
import { load } from './nanospectra/nanospectra.js';

/** The keys of a link and the values that each may have; anything else in a link is ignored. */
const POSSIBLE = {
  tab: /^(light|paint|scene|cost)$/,
  lamp: /./,
  drawn: /^(\d\d?|100)(,(\d\d?|100)){40}$/,
  data: /./,
  file: /./,
  column: /^\d+$/,
  observer: new RegExp(`^(${OBSERVERS.map(([name]) => name).join('|')})$`),
  interpolation: /^(auto|linear|sprague)$/,
  unit: /^(relative|absolute)$/,
  kind: /^(light|surface)$/,
  under: /./,
  diagram: /^(1931|1976)$/,
  rgb: /^#[0-9a-f]{6}$/i,
  method: /^(sigmoid|basis|smits)$/,
  paintlamp: /./,
  scene: /./,
  scenelamp: /./,
  off: /^\d+(,\d+)*$/,
  budget: /^(1?\d(\.5)?|20)$/,
  costlamp: /./,
  bands: /^\d+$/,
  range: /^[012]$/,
  scheme: /^[0-3]$/,
};

const said = new URLSearchParams(location.hash.slice(1));
/** The state that the link carries. @type {Record<string, string>} */
export const state = Object.fromEntries(
  Object.keys(POSSIBLE)
    .filter((key) => POSSIBLE[key].test(said.get(key) ?? ''))
    .map((key) => [key, said.get(key)]),
);
/** The defaults, which the link leaves out. */
const usual = {
  tab: 'light',
  lamp: 'LED-B3',
  observer: OBSERVERS[0][0],
  interpolation: 'auto',
  unit: 'relative',
  kind: 'light',
  under: 'D65',
  diagram: '1976',
  rgb: '#cc331a',
  method: 'sigmoid',
  scene: 'vest',
  off: '',
  budget: '',
  costlamp: 'all',
  bands: '16',
  range: '0',
  scheme: '2',
};
for (const [key, value] of Object.entries(usual)) state[key] ??= value;

/** Puts changes of the state into the address, without a new entry in the browser's history. @param {Record<string, string | undefined>} changes */
export function remember(changes) {
  for (const [key, value] of Object.entries(changes))
    value === undefined ? delete state[key] : (state[key] = value);
  const told = Object.entries(state).filter(([key, value]) => value !== usual[key]);
  history.replaceState(null, '', `#${new URLSearchParams(told)}`);
}

const base = new URL('nanospectra/', import.meta.url);
let lamps;

/** Loads a module and gives it the CIE's lamps. @param {'light' | 'paint' | 'scene'} module */
export async function fetched(module) {
  const instrument = await load({ module, base, tables: spectra?.tables });
  lamps ??= await instrument.loadLamps(base);
  instrument.lamps = lamps;
  for (const key of ['lamp', 'under', 'paintlamp', 'scenelamp'])
    if (state[key] && !lamps.has(state[key])) remember({ [key]: usual[key] });
  return instrument;
}

/** Returns the names of the CIE's lamps, with E first. */
export const lampNames = () => ['E', ...[...lamps.keys()].filter((name) => name !== 'E')];

/** The module that measures lights and surfaces, which is loaded before any tab is shown. @type {import('./nanospectra/nanospectra.js').Light} */
export let spectra;
export async function begin() {
  spectra = await fetched('light');
}
