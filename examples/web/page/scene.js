// The tab Scene: the parts that light meets, each with a switch, the color, and the price of each part.
import { ink } from './color.js';
import { figure, h, onWidth, saving, select } from './dom.js';
import { spectrum as plot } from './plots.js';
import { fetched, lampNames, remember, state } from './session.js';

let module, scenes, view, scene, answer;

/** Returns the parts that are switched off; a link may name parts that this scene does not have. */
const switchedOff = () => (state.off ? state.off.split(',').map(Number).filter((k) => k < scene.parts.length) : []);

function open() {
  const recipe = structuredClone(scenes[state.scene]);
  if (state.scenelamp) recipe.lamp.cie = state.scenelamp;
  scene = module.scene(recipe);
  view.lamp.value = recipe.lamp.cie;
  const off = switchedOff();
  view.bill.replaceChildren(
    ...scene.parts.map(({ name, effect }, k) =>
      h(
        'tr',
        {},
        h(
          'td',
          {},
          h(
            'label',
            { class: 'check' },
            h('input', {
              type: 'checkbox',
              role: 'switch',
              id: `part-${k}`,
              checked: !off.includes(k),
              onchange: (event) => {
                const now = new Set(switchedOff());
                event.target.checked ? now.delete(k) : now.add(k);
                remember({ off: [...now].sort().join(',') });
                work();
              },
            }),
            h('span', {}, name, h('br'), h('small', {}, effect)),
          ),
        ),
        h('td', { class: 'n' }),
        h('td'),
        h('td', { class: 'n' }),
        h('td', { class: 'n' }),
      ),
    ),
  );
  work();
}

const points = (values) => values.map((value, k) => [380 + 5 * k, value]);

function work() {
  const budget = state.budget === '' ? null : Number(state.budget);
  answer = scene.answer({ off: switchedOff(), budget });
  const whole = scene.answer({ budget });
  const { shown } = answer;
  view.pair.replaceChildren(
    h(
      'div',
      { style: `background:${whole.hex};color:${ink(whole.hex)}` },
      'with every effect',
      h('b', {}, whole.hex),
    ),
    h(
      'div',
      { style: `background:${answer.hex};color:${ink(answer.hex)}` },
      'with the chosen effects',
      h('b', {}, answer.hex),
    ),
  );
  view.verdict.textContent =
    switchedOff().length === 0
      ? `Following the light through all parts takes ${whole.walked.multiply_adds} multiply-adds; with all parts and the observer combined into one matrix it takes ${whole.folded.multiply_adds}.`
      : `Leaving this out costs ${shown.delta_e2000.toFixed(2)} CIEDE2000 and saves ${whole.walked.multiply_adds - shown.multiply_adds} of ${whole.walked.multiply_adds} multiply-adds.`;
  answer.bill.forEach((line, k) => {
    const cells = view.bill.rows[k].cells;
    cells[1].textContent = line.without_delta_e2000 === null ? 'none' : line.without_delta_e2000.toFixed(2);
    cells[2].replaceChildren(
      h('span', {
        class: 'chip',
        style: `background:${line.without_hex}`,
        role: 'img',
        'aria-label': `without it ${line.without_hex}`,
      }),
    );
    cells[3].textContent = line.multiply_adds;
    cells[4].textContent = line.bytes;
  });
  const size = [view.plot.width(), 300],
    peak = Math.max(...answer.lamp_spectrum);
  view.plot.draw(
    plot(points(answer.leaving_spectrum), answer.absolute ? 'W/m²/nm' : 'relative power', {
      id: 'scene',
      size,
      lines: [
        { samples: points(answer.lamp_spectrum), plain: true, name: answer.lamp },
        ...(switchedOff().length
          ? [{ samples: points(whole.leaving_spectrum), plain: true, dashed: true, name: 'with every effect' }]
          : []),
      ],
    }).inside,
    `the light that reaches the observer, and the lamp ${answer.lamp} with its peak at ${380 + 5 * answer.lamp_spectrum.indexOf(peak)} nm`,
    size,
  );
  const rows = [
    ['X, Y, Z', answer.XYZ],
    ['x, y', answer.xy],
    ['L*, a*, b*', answer.lab],
    ['Luminous factor, %', answer.luminous_factor_percent],
  ];
  const units = {
    illuminance_lx: 'Illuminance, lx',
    irradiance_w_m2: 'Irradiance, W/m²',
    exitance_lm_m2: 'Exitance, lm/m²',
    luminance_cd_m2: 'Luminance, cd/m²',
    radiance_w_m2_sr: 'Radiance, W/m²/sr',
  };
  for (const [key, name] of Object.entries(units))
    if (answer.absolute?.[key] != null) rows.push([name, answer.absolute[key]]);
  view.numbers.replaceChildren(
    ...rows.map(([name, value]) =>
      h(
        'tr',
        {},
        h('th', { scope: 'row' }, name),
        h('td', {}, Array.isArray(value) ? value.join(', ') : value === null ? 'none' : String(value)),
      ),
    ),
  );
  view.budgetSaid.textContent =
    answer.budget === null
      ? 'Nothing is left out.'
      : answer.budget.left_out.length === 0
        ? `Within ${budget} CIEDE2000 nothing can be left out.`
        : `Within ${budget} CIEDE2000 one can leave out ${answer.budget.left_out.map((k) => scene.parts[k].name).join(' and ')}. That costs ${answer.budget.cost_delta_e2000.toFixed(2)} CIEDE2000, and ${answer.budget.multiply_adds} multiply-adds remain.`;
}

/** @param {HTMLElement} section */
export async function build(section) {
  module = await fetched('scene');
  scenes = await (await fetch(new URL('scenes.json', import.meta.url))).json();
  if (!Object.hasOwn(scenes, state.scene)) remember({ scene: 'vest', off: '' });
  const lamp = select(
    'Lamp',
    lampNames(),
    state.scenelamp ?? 'D65',
    (value) => {
      remember({ scenelamp: value });
      open();
    },
    'scene-lamp',
  );
  const budget = h('input', {
    type: 'range',
    id: 'budget',
    min: 0,
    max: 20,
    step: 0.5,
    value: state.budget || 0,
    oninput: (event) => {
      remember({ budget: event.target.value === '0' ? '' : event.target.value });
      work();
    },
  });
  view = {
    lamp: lamp.querySelector('select'),
    bill: h('tbody', { id: 'bill' }),
    pair: h('div', { class: 'pair' }),
    verdict: h('p', { class: 'hint', 'aria-live': 'polite', id: 'verdict' }),
    plot: figure('Light of the lamp and of the scene', 'scene', [640, 300]),
    numbers: h('tbody'),
    budgetSaid: h('p', { class: 'hint', 'aria-live': 'polite' }),
  };
  view.plot.element.classList.add('third');
  const json = () => `${JSON.stringify(answer)}\n`;
  const csv = () =>
    [
      'band-nm,lamp,leaving',
      ...answer.lamp_spectrum.map((value, k) => [380 + 5 * k, value, answer.leaving_spectrum[k]].join(',')),
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
          h('h2', {}, 'Scene'),
          h(
            'div',
            { class: 'row' },
            select(
              'Scene',
              Object.entries(scenes).map(([key, { title }]) => [key, title]),
              state.scene,
              (value) => {
                remember({ scene: value, off: '', scenelamp: undefined });
                open();
              },
              'scene-name',
            ),
            lamp,
          ),
          h(
            'div',
            { class: 'wide', style: 'margin-top:1rem' },
            h(
              'table',
              {},
              h('caption', {}, 'The parts, in the order in which light meets them'),
              h(
                'thead',
                {},
                h(
                  'tr',
                  {},
                  ...['part and effect', 'without it, ΔE', 'color', 'multiply-adds', 'bytes'].map((name, k) =>
                    h('th', { scope: 'col', class: k % 2 || k > 3 ? 'n' : '' }, name),
                  ),
                ),
              ),
              view.bill,
            ),
          ),
        ),
        view.plot.element,
      ),
      h(
        'div',
        { class: 'column' },
        h('div', { class: 'card second' }, h('h2', {}, 'What it looks like'), view.pair, view.verdict),
        h(
          'div',
          { class: 'card' },
          h('h2', {}, 'Color budget'),
          h(
            'label',
            { for: 'budget' },
            'Leave effects out as long as the color changes by no more than this (CIEDE2000)',
          ),
          budget,
          view.budgetSaid,
        ),
        h(
          'div',
          { class: 'card' },
          h('h2', {}, 'Numbers'),
          h('div', { class: 'wide' }, h('table', {}, h('caption', {}, 'The light that reaches the observer, with the chosen effects'), view.numbers)),
          saving('scene', csv, json),
        ),
      ),
    ),
  );
  open();
  onWidth(section, work);
}
