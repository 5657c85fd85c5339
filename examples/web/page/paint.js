// The tab Paint: an RGB color, the spectra that have it, and their colors under other lamps.
import { ink } from './color.js';
import { copy, figure, h, onWidth, saving, select } from './dom.js';
import { spectrum as plot } from './plots.js';
import { fetched, lampNames, remember, state } from './session.js';

const METHODS = [
  ['sigmoid', 'Sigmoid (smooth, exact)'],
  ['basis', 'Basis (linear)'],
  ['smits', 'Smits 1999'],
];
const LAMPS = ['A', 'FL2', 'FL11', 'LED-B3', 'HP1'];
let module, view, answers;

const parts = (code) => [1, 3, 5].map((at) => Math.fround(parseInt(code.slice(at, at + 2), 16) / 255));
const points = (answer) => answer.spectrum.map((value, k) => [380 + 5 * k, value]);

function work() {
  const rgb = parts(state.rgb),
    lamp = state.paintlamp ?? 'FL11',
    lights = [...new Set([...LAMPS, lamp])];
  answers = METHODS.map(([method]) => module.upsample(rgb, { method, lights }));
  const chosen = answers[METHODS.findIndex(([method]) => method === state.method)] ?? answers[0];
  const others = answers.filter((answer) => answer !== chosen);
  view.color.value = state.rgb;
  view.rgb.forEach((input, k) => {
    if (document.activeElement !== input) input.value = parseInt(state.rgb.slice(1 + 2 * k, 3 + 2 * k), 16);
  });
  const size = [view.plot.width(), 300];
  view.plot.draw(
    plot(points(chosen), 'reflectance', {
      id: 'paint',
      top: 1,
      size,
      lines: others.map((answer, k) => ({
        samples: points(answer),
        plain: true,
        dashed: k === 1,
        name: answer.method,
      })),
    }).inside,
    `the reflectance by ${chosen.method}, with the other methods as lines`,
    size,
  );
  const shown = chosen.lights.find((look) => look.name === lamp);
  view.pair.replaceChildren(
    h(
      'div',
      { style: `background:${chosen.lights[0].hex};color:${ink(chosen.lights[0].hex)}` },
      'under D65',
      h('b', {}, chosen.lights[0].hex),
    ),
    h('div', { style: `background:${shown.hex};color:${ink(shown.hex)}` }, `under ${lamp}`, h('b', {}, shown.hex)),
  );
  view.methods.replaceChildren(
    ...answers.map((answer) =>
      h(
        'tr',
        {},
        h('th', { scope: 'row' }, answer.method),
        h('td', {}, answer.status),
        h('td', { class: 'n', 'data-delta': answer.method }, answer.delta_e2000.toPrecision(2)),
        h(
          'td',
          {},
          h(
            'button',
            { type: 'button', class: 'copy', onclick: () => copy(answer.roundtrip_rgb.join(', '), 'RGB') },
            answer.roundtrip_rgb.map((c) => c.toFixed(4)).join(', '),
          ),
        ),
      ),
    ),
  );
  view.lamps.replaceChildren(
    ...chosen.lights.map((look, k) =>
      h(
        'tr',
        {},
        h('th', { scope: 'row' }, look.name),
        ...answers.map((answer) =>
          h(
            'td',
            {},
            h('span', {
              class: 'chip',
              style: `background:${answer.lights[k].hex}`,
              role: 'img',
              'aria-label': answer.lights[k].hex,
            }),
          ),
        ),
        h(
          'td',
          {},
          h(
            'button',
            { type: 'button', class: 'copy', onclick: () => copy(look.lab.join(', '), 'L*, a*, b*') },
            look.lab.map((x) => x.toFixed(2)).join(', '),
          ),
        ),
      ),
    ),
  );
  const status = {
    exact: 'the spectrum has exactly this color',
    unreachable: 'no smooth reflectance was found for this color, and this is the nearest found',
    unphysical: 'the spectrum has this color but leaves 0..1, so it is no reflectance',
    approximate: 'the spectrum comes near this color',
  };
  view.status.textContent = `${chosen.method}: ${status[chosen.status]}. The round trip is off by ${chosen.delta_e2000.toPrecision(2)} CIEDE2000.`;
}

/** @param {HTMLElement} section */
export async function build(section) {
  module = await fetched('paint');
  const number = (name, k) =>
    h('input', {
      type: 'number',
      min: 0,
      max: 255,
      id: `rgb-${k}`,
      'aria-label': `${name}, 0 to 255`,
      oninput: () => {
        const codes = view.rgb.map((input) => Math.min(Math.max(Math.round(Number(input.value) || 0), 0), 255));
        remember({ rgb: `#${codes.map((c) => c.toString(16).padStart(2, '0')).join('')}` });
        work();
      },
      onblur: () => work(),
    });
  view = {
    color: h('input', {
      type: 'color',
      id: 'color',
      oninput: (event) => {
        remember({ rgb: event.target.value });
        work();
      },
    }),
    rgb: ['Red', 'Green', 'Blue'].map(number),
    plot: figure('Reflectance', 'reflectance', [640, 300]),
    pair: h('div', { class: 'pair' }),
    methods: h('tbody'),
    lamps: h('tbody'),
    status: h('p', { class: 'hint', 'aria-live': 'polite', id: 'paint-status' }),
  };
  const methods = h(
    'fieldset',
    {},
    h('legend', {}, 'Method'),
    ...METHODS.map(([method, name]) =>
      h(
        'label',
        { class: 'check' },
        h('input', {
          type: 'radio',
          name: 'method',
          value: method,
          checked: method === state.method,
          onchange: () => {
            remember({ method });
            work();
          },
        }),
        name,
      ),
    ),
  );
  view.plot.element.classList.add('second');
  const json = () => answers.map((answer) => JSON.stringify(answer)).join('\n') + '\n';
  const csv = () =>
    [
      'band-nm,sigmoid,basis,smits',
      ...answers[0].spectrum.map((_, k) => [380 + 5 * k, ...answers.map((answer) => answer.spectrum[k])].join(',')),
    ].join('\n') + '\n';
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
          h('h2', {}, 'Color to paint'),
          h(
            'div',
            { class: 'row' },
            h('label', { style: 'flex:0 0 auto' }, 'sRGB', view.color),
            ...view.rgb.map((input, k) => h('label', {}, ['R', 'G', 'B'][k], input)),
          ),
          h('div', { style: 'margin-top:.75rem' }, methods),
          view.status,
        ),
        view.plot.element,
      ),
      h(
        'div',
        { class: 'column' },
        h(
          'div',
          { class: 'card third' },
          h('h2', {}, 'Under another lamp'),
          view.pair,
          h(
            'div',
            { style: 'margin-top:.75rem' },
            select(
              'Lamp',
              lampNames(),
              state.paintlamp ?? 'FL11',
              (value) => {
                remember({ paintlamp: value });
                work();
              },
              'paint-lamp',
            ),
          ),
        ),
        h(
          'div',
          { class: 'card' },
          h('h2', {}, 'Round trip'),
          h(
            'div',
            { class: 'wide' },
            h(
              'table',
              {},
              h('caption', {}, 'The color that each spectrum has under D65'),
              h(
                'thead',
                {},
                h(
                  'tr',
                  {},
                  h('th', { scope: 'col' }, 'method'),
                  h('th', { scope: 'col' }, 'status'),
                  h('th', { scope: 'col', class: 'n' }, 'CIEDE2000'),
                  h('th', { scope: 'col' }, 'R, G, B'),
                ),
              ),
              view.methods,
            ),
          ),
        ),
        h(
          'div',
          { class: 'card' },
          h('h2', {}, 'The same paint under several lamps'),
          h(
            'div',
            { class: 'wide' },
            h(
              'table',
              {},
              h('caption', {}, 'The colors are adapted to each lamp (CAT16); L*, a*, b* are those of the chosen method'),
              h(
                'thead',
                {},
                h(
                  'tr',
                  {},
                  h('th', { scope: 'col' }, 'lamp'),
                  ...METHODS.map(([method]) => h('th', { scope: 'col' }, method)),
                  h('th', { scope: 'col' }, 'L*, a*, b*'),
                ),
              ),
              view.lamps,
            ),
          ),
          saving('paint', csv, json),
        ),
      ),
    ),
  );
  work();
  onWidth(section, work);
}
