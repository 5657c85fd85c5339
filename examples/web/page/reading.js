// Shows a reading of the colorimeter on the page: plots, numbers and notes.
import { shortest } from './nanospectra/numbers.js';
import { copy, h, inPage } from './dom.js';
import { DRAWN, asSlider, hand } from './drawing.js';
import { bars, chromaticity, spectrum as plot, vectors } from './plots.js';
import { spectra, state } from './session.js';

/**
 * The rows of the table in the order of the report of `nanospectra measure`: how strong a light is, what it does, its
 * color, its photons and what the receptors of the eye get of it. Each has a key of the report, a name and a unit. The
 * part of a key behind a point is a key of each of several things.
 */
const ROWS = [
  ['irradiance_w_m2', 'Irradiance', 'W/m²'],
  ['lux', 'Illuminance', 'lx'],
  ['cct_k', 'CCT', 'K'],
  ['duv', 'Duv'],
  ['cri_ra', 'CRI Ra'],
  ['cri_r9', 'CRI R9'],
  ['tm30_rf', 'TM-30 Rf'],
  ['tm30_rg', 'TM-30 Rg'],
  ['ler_lm_per_w', 'Luminous efficacy', 'lm/W'],
  ['XYZ', 'X, Y, Z'],
  ['xy', 'x, y'],
  ['uv1960', 'u, v (1960)'],
  ['uv1976', 'u′, v′ (1976)'],
  ['lab', 'L*, a*, b*'],
  ['delta_e2000_to_white', 'CIEDE2000 to white'],
  ['hex', 'sRGB'],
  ['dominant_wavelength_nm', 'Dominant wavelength', 'nm'],
  ['purity', 'Purity'],
  ['ppfd', 'PPFD', 'µmol/m²/s'],
  ['epar', 'ePAR', 'µmol/m²/s'],
  ['photons', 'Photons: blue, green, red, far red', 'µmol/m²/s'],
  ['photon_shares', 'Blue, green, red, far red, as shares of 400..700 nm'],
  ['r_fr', 'R:FR'],
  ['peak_nm', 'Peak', 'nm'],
  ['centroid_nm', 'Centroid', 'nm'],
  ['fwhm_nm', 'Width at half the peak', 'nm'],
  ['melanopic_edi_ratio', 'Melanopic ratio'],
  ['alpha_opic.der', 'DER: S, M, L, rods, melanopsin'],
  ['alpha_opic.edi_lx', 'EDI: S, M, L, rods, melanopsin', 'lx'],
  ['alpha_opic.irradiance_w_m2', 'α-opic irradiances: the same', 'W/m²'],
  ['interpolation', 'Brought to 1 nm by'],
];

let planck, tcs;

/** Returns the chromaticities of black bodies, for the diagrams. */
function blackBodies() {
  return [1000, 1300, 1600, 2000, 2500, 3000, 3500, 4000, 5000, 6000, 7000, 8500, 10000, 15000, 25000, 100000].map(
    (kelvin) => {
      spectra.wasm.black_body(kelvin);
      spectra.wasm.see_light(0);
      return Array.from(spectra.out.slice(6, 8));
    },
  );
}

/** Returns the display colors of the test color samples under D65, for the bars. */
function sampleColors() {
  // The table has 15 samples and a white at each step of 5 nm, and begins two steps below 360 nm.
  const table = spectra.published.testColors;
  spectra.named('D65', '');
  spectra.light.set(spectra.curve);
  return Array.from({ length: 15 }, (_, k) => {
    const samples = Array.from({ length: 95 }, (_, node) => [360 + 5 * node, table[16 * (node + 2) + k]]);
    spectra.read({ samples, file: '', name: '', lines: [] });
    spectra.wasm.see_surface(0);
    return `rgb(${spectra.out.slice(18, 21)})`;
  });
}

/** Computes the parts of the plots that are the same for every reading. */
export function prepare() {
  planck = blackBodies();
  tcs = sampleColors();
}

const text = (value) => (value === null ? 'none' : Array.isArray(value) ? value.join(', ') : String(value));
const rounded = (value, digits) => (value === null ? 'none' : value.toFixed(digits));
const significant = (value, unit) => (value === null ? 'none' : `${shortest(Number(value.toPrecision(4)))} ${unit}`);

/** Returns the value of a key of `ROWS`, which is a list for the parts of an object, or null where one is missing. */
function valueOf(reading, key) {
  const [first, second] = key.split('.'),
    value = reading[first];
  if (value === null || typeof value !== 'object' || Array.isArray(value)) return value ?? null;
  const parts = Object.values(value).map((part) => (second ? part[second] : part) ?? null);
  return parts.includes(null) ? null : parts;
}

const isAbsolute = (reading) => reading.unit === 'W/m2/nm';

/** Shows a reading in the plots and the table. */
export function show(view, source, reading) {
  const { curve, scale = 1 } = reading,
    live = Boolean(state.drawn);
  const samples = Array.from(curve, (value, k) => [360 + k, value * scale]).filter(
    ([nm]) => nm >= 380 && nm <= 780,
  );
  const unit = reading.light !== undefined ? 'reflectance' : isAbsolute(reading) ? 'W/m²/nm' : 'relative power';
  const size = [view.spd.width(), 300];
  const spd = plot(samples, unit, {
    id: 'spd',
    size,
    top: live ? 1 : undefined,
    cursor: live ? [DRAWN[hand.cursor], hand.values[hand.cursor]] : undefined,
  });
  view.spd.svg.scale = spd;
  const peak = samples.reduce((best, sample) => (sample[1] > best[1] ? sample : best));
  view.spd.draw(spd.inside, `${source.name}, highest at ${peak[0]} nm`, size);
  asSlider(view.spd.svg, live);
  view.hint.hidden = !live;

  const { xy } = reading;
  for (const [diagram, drawing] of Object.entries(view.diagrams)) {
    drawing.element.hidden = state.diagram !== diagram && !matchMedia('(min-width: 62rem)').matches;
    const width = drawing.width(),
      size = [width, Math.round((width * 46) / 42)];
    drawing.draw(
      chromaticity(diagram, planck, xy ? [{ xy }] : [], size),
      xy ? `the point is at x = ${xy[0].toFixed(4)}, y = ${xy[1].toFixed(4)}` : 'no chromaticity',
      size,
    );
  }
  view.cri.element.hidden = reading.cri_r === null;
  if (reading.cri_r)
    view.cri.draw(
      bars(reading.cri_r, tcs, view.cri.width()),
      `Ra ${reading.cri_ra.toFixed(1)}; ${reading.cri_r.map((r, k) => `R${k + 1} ${r.toFixed(0)}`).join(', ')}`,
      [view.cri.width(), 228],
    );
  view.tm30.element.hidden = !reading.tm30;
  if (reading.tm30)
    view.tm30.draw(
      vectors(reading.tm30),
      `Rf ${reading.tm30.rf.toFixed(1)}, Rg ${reading.tm30.rg.toFixed(1)}; shifts of 16 hues against the reference circle`,
    );
  // A screen reader must not hear the results again only because the window was resized.
  if (view.told !== reading) tell(view, reading);
  view.told = reading;
}

/** Shows the numbers and the notes of a reading. */
function tell(view, reading) {
  // While a spectrum is drawn, the plot tells screen readers where the pen is, and the results stay silent.
  view.big.parentElement.setAttribute('aria-live', state.drawn ? 'off' : 'polite');
  view.swatch.style.background = reading.hex ?? 'transparent';
  view.swatch.setAttribute('aria-label', `Color ${reading.hex ?? 'none'}`);
  const big =
    reading.light !== undefined
      ? [
          ['L*', rounded(reading.lab?.[0] ?? null, 1)],
          ['a*', rounded(reading.lab?.[1] ?? null, 1)],
          ['b*', rounded(reading.lab?.[2] ?? null, 1)],
          ['sRGB', reading.hex],
        ]
      : [
          ...(isAbsolute(reading)
            ? [
                ['Irradiance', significant(reading.irradiance_w_m2, 'W/m²')],
                ['Illuminance', significant(reading.lux, 'lx')],
              ]
            : []),
          ['CCT', reading.cct_k === null ? 'none' : `${Math.round(reading.cct_k)} K`],
          ['Duv', rounded(reading.duv, 4)],
          ['Ra', rounded(reading.cri_ra, 1)],
          ['Rf', rounded(reading.tm30_rf, 1)],
          ['Rg', rounded(reading.tm30_rg, 1)],
          ['sRGB', reading.hex],
        ];
  view.big.replaceChildren(
    ...big.map(([name, value]) => h('div', {}, h('dt', {}, name), h('dd', {}, value ?? 'none'))),
  );
  view.rows.replaceChildren(
    ...ROWS.filter(([key]) => valueOf(reading, key) !== null).map(([key, name, ownUnit]) => {
      const value = text(valueOf(reading, key)),
        unit = key === 'XYZ' && isAbsolute(reading) ? 'lx' : ownUnit;
      return h(
        'tr',
        {},
        h('th', { scope: 'row' }, name),
        h(
          'td',
          {},
          h(
            'button',
            {
              type: 'button',
              class: 'copy',
              'aria-label': `Copy ${name}: ${value}`,
              'data-key': key,
              title: 'Copy',
              onclick: () => copy(value, name),
            },
            value,
          ),
          unit ? ` ${unit}` : '',
        ),
      );
    }),
  );
  const notes = new Map();
  for (const note of reading.notes) {
    const [, key, words] = /^(.*?): (.*)$/s.exec(inPage(note));
    notes.set(words, [...(notes.get(words) ?? []), key]);
  }
  view.notes.replaceChildren(...[...notes].map(([words, keys]) => h('li', {}, `${keys.join(', ')}: ${words}`)));
}
