// The tab Cost: the color error of a number of bands under chosen lamps, computed here, beside recorded instructions.
import { closely } from './fold.js';
import { figure, h, onWidth, saving, select } from './dom.js';
import { cost as plot } from './plots.js';
import { lampNames, remember, spectra, state } from './session.js';

/** The numbers of bands whose instructions tests/devices.sh counts. */
const BANDS = [8, 12, 16, 20, 24, 31, 36, 40, 60, 81];
const SCHEMES = ['step', 'parabola', 'spline', 'not folded'];
const RANGES = [
  [380, 730],
  [400, 700],
  [360, 830],
];
const TARGETS = {
  'thumbv7em-none-eabihf': 'Cortex-M4F',
  'thumbv8m.main-none-eabihf': 'Cortex-M33',
  'thumbv6m-none-eabi': 'Cortex-M0',
  'riscv32imac-unknown-none-elf': 'RV32IMAC',
};
/** Lamps by the kind of their spectra, since smooth spectra need fewer bands than spectra with lines. */
const KINDS = {
  all: ['all lamps', () => true],
  smooth: ['daylight and filaments', (name) => /^(E|A|C|D\d|ID)/.test(name)],
  halophosphate: ['fluorescent, broad phosphors', (name) => /^FL([1-9]|3\.[1-6])$/.test(name)],
  triphosphor: ['fluorescent, narrow phosphors', (name) => /^FL(1[0-2]|3\.([7-9]|1\d))$/.test(name)],
  led: ['LED', (name) => /^(LED|L41)/.test(name)],
  hid: ['discharge', (name) => /^HP/.test(name)],
};
let under, lamps, view, counts, results;

/** Returns the mean, the 95th percentile and the largest error over all chosen lamps and all samples. */
function errors(bands, scheme) {
  const all = lamps.flatMap((coarsely) => coarsely(bands, RANGES[state.range], scheme)).sort((a, b) => a - b);
  return {
    mean: all.reduce((sum, error) => sum + error, 0) / all.length,
    p95: all[Math.ceil(0.95 * all.length) - 1],
    max: all.at(-1),
  };
}

/** Prepares the chosen lamps and computes every point of the plot for them. */
function look() {
  const [, belongs] = KINDS[state.costlamp] ?? [null, (name) => name === state.costlamp];
  lamps = lampNames()
    .filter(belongs)
    .map((name) => {
      spectra.named(name, 'lamp');
      return under(spectra.curve.slice());
    });
  return sweep();
}

let turn = 0;
/** Computes the chosen scheme at once and the others point by point, so that the page stays responsive. */
function sweep() {
  const mine = ++turn,
    first = Number(state.scheme);
  results = SCHEMES.map((name) => ({ name, points: [] }));
  const todo = [first, ...SCHEMES.keys()].flatMap((k, j) => (j && k === first ? [] : BANDS.map((N) => [N, k])));
  const next = () => {
    const [N, k] = todo.shift();
    results[k].points.push([N, errors(N, k)]);
  };
  for (const _ of BANDS) next();
  work();
  const later = () => {
    if (mine !== turn) return;
    next();
    if (todo.length % BANDS.length === 0) work();
    if (todo.length) setTimeout(later);
  };
  setTimeout(later);
}

function work() {
  const bands = Number(state.bands),
    scheme = Number(state.scheme);
  const found = results[scheme].points.find(([N]) => N === bands);
  if (!found) return sweep();
  const [, here] = found;
  view.bandsSaid.textContent = bands;
  view.slider.setAttribute('aria-valuetext', `${bands} bands`);
  const size = [view.plot.width(), 300];
  view.plot.draw(
    plot(
      results.map(({ name, points }, k) => ({
        name,
        chosen: k === scheme,
        points: points.map(([N, { mean }]) => [N, mean]),
      })),
      [bands, here.mean],
      size[0] < 500 ? BANDS.filter((_, k) => k % 2 === 0) : BANDS,
      size[0],
    ),
    `mean error of four methods against the number of bands; ${SCHEMES[scheme]} with ${bands} bands has an error of ${here.mean.toPrecision(2)}`,
    size,
  );
  const bytes = 12 * bands + (scheme === 3 ? 4 * bands : 0);
  view.big.replaceChildren(
    ...[
      ['mean', here.mean],
      ['95 %', here.p95],
      ['worst', here.max],
    ].map(([name, value]) => h('div', {}, h('dt', {}, `${name} CIEDE2000`), h('dd', {}, value.toPrecision(2)))),
    h('div', {}, h('dt', {}, 'multiply-adds'), h('dd', {}, String(3 * bands + (scheme === 3 ? bands : 0)))),
    h('div', {}, h('dt', {}, 'table, bytes'), h('dd', {}, String(bytes))),
  );
  const kind = scheme === 3 ? 'walked' : 'folded';
  view.counted.textContent = `From ${bands} bands to X, Y, Z, counted exactly by an emulator`;
  view.rows.replaceChildren(
    ...Object.entries(TARGETS)
      .filter(([target]) => counts[target])
      .map(([target, name]) =>
        h(
          'tr',
          {},
          h('th', { scope: 'row' }, name),
          ...['release', 'small'].map((profile) =>
            h('td', { class: 'n' }, counts[target][kind]?.[profile]?.[bands]?.toLocaleString('en') ?? ''),
          ),
        ),
      ),
  );
}

/** @param {HTMLElement} section */
export async function build(section) {
  counts = await (await fetch(new URL('instructions.json', import.meta.url))).json();
  under = closely(spectra);
  if (!BANDS.includes(Number(state.bands))) remember({ bands: '16' });
  if (!Object.hasOwn(KINDS, state.costlamp) && !lampNames().includes(state.costlamp)) remember({ costlamp: 'all' });
  view = {
    slider: h('input', {
      type: 'range',
      id: 'bands',
      min: 0,
      max: BANDS.length - 1,
      value: BANDS.indexOf(Number(state.bands)),
      oninput: (event) => {
        remember({ bands: String(BANDS[Number(event.target.value)]) });
        work();
      },
    }),
    bandsSaid: h('output', { for: 'bands' }),
    plot: figure('Color error by number of bands', 'cost', [640, 300]),
    big: h('dl', { 'aria-live': 'polite' }),
    counted: h('caption'),
    rows: h('tbody'),
  };
  view.plot.element.classList.add('third');
  const range = () => RANGES[state.range].join('..');
  const csv = () =>
    [
      'lamps,range_nm,bands,scheme,mean,p95,max',
      ...results.flatMap(({ name, points }) =>
        points.map(([N, { mean, p95, max }]) => [state.costlamp, range(), N, name, mean, p95, max].join(',')),
      ),
    ].join('\n') + '\n';
  const json = () => `${JSON.stringify({ lamps: state.costlamp, range_nm: range(), schemes: results })}\n`;
  section.append(
    h(
      'div',
      { class: 'grid' },
      h(
        'div',
        { class: 'column' },
        h(
          'div',
          { class: 'card first' },
          h('h2', {}, 'How many bands are enough?'),
          h('label', { for: 'bands' }, 'Number of bands: ', view.bandsSaid),
          view.slider,
          h(
            'div',
            { class: 'row' },
            select(
              'Lamps',
              [...Object.entries(KINDS).map(([key, [name]]) => [key, name]), ...lampNames()],
              state.costlamp,
              (value) => {
                remember({ costlamp: value });
                look();
              },
              'cost-lamp',
            ),
            select(
              'Range',
              RANGES.map(([from, to], k) => [String(k), `${from}..${to} nm`]),
              state.range,
              (value) => {
                remember({ range: value });
                sweep();
              },
              'range',
            ),
          ),
          h(
            'fieldset',
            { style: 'margin-top:.75rem' },
            h('legend', {}, 'How lamp and observer become weights'),
            ...SCHEMES.map((name, k) =>
              h(
                'label',
                { class: 'check' },
                h('input', {
                  type: 'radio',
                  name: 'scheme',
                  checked: k === Number(state.scheme),
                  onchange: () => {
                    remember({ scheme: String(k) });
                    work();
                  },
                }),
                name,
              ),
            ),
          ),
        ),
        view.plot.element,
      ),
      h(
        'div',
        { class: 'column' },
        h(
          'div',
          { class: 'card second' },
          h('h2', {}, 'Error and cost'),
          h('div', { class: 'answer' }, view.big),
          h(
            'p',
            { class: 'hint' },
            'The error is the difference to the sum at 1 nm, over the 99 color evaluation samples of CIE 224 under each lamp. The methods step, parabola and spline turn lamp and observer into one weight per band ahead of time. The method not folded multiplies the averages of both in each band.',
          ),
        ),
        h(
          'div',
          { class: 'card' },
          h('h2', {}, 'Instructions'),
          h(
            'div',
            { class: 'wide' },
            h(
              'table',
              {},
              view.counted,
              h(
                'thead',
                {},
                h('tr', {}, ...['', 'opt-level 3', 'opt-level s'].map((name) => h('th', { scope: 'col', class: 'n' }, name))),
              ),
              view.rows,
            ),
          ),
          saving('cost', csv, json),
        ),
      ),
    ),
  );
  look();
  onWidth(section, work);
}
