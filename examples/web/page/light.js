// The tab Colorimeter: a spectrum from a file, of a lamp or drawn by hand, and every number about it.
import { cell, parse } from './nanospectra/csv.js';
import { OBSERVERS } from './nanospectra/lists.js';
import { figure, h, inPage, onWidth, options, saving, say, select } from './dom.js';
import { drawing, drawnSource, hand } from './drawing.js';
import { prepare, show } from './reading.js';
import { lampNames, remember, spectra, state } from './session.js';

/** @type {import('./nanospectra/csv.js').Source[]} */
let sources = [];
let chosen = 0;
let reading, view;
/** The keys of the link that describe the spectrum. */
const OF_THE_SPECTRUM = ['lamp', 'drawn', 'data', 'file', 'column'];
/** The spectrum that was measured last, to which the page returns if the next one cannot be measured. */
let good = null;

/** Brings the spectra that the state names. */
function restore() {
  if (state.drawn) {
    hand.values = state.drawn.split(',').map((code) => Number(code) / 100);
    sources = [drawnSource()];
  } else if (state.data) {
    sources = parse(state.data.replaceAll(';', '\n').replaceAll('_', ','), state.file ?? 'link.csv');
  } else sources = [spectra.lamps.get(state.lamp) ?? spectra.lamps.get('LED-B3')];
  chosen = Math.min(Number(state.column ?? 0), sources.length - 1);
}

/** Takes a text with spectra, and keeps it in the link if it is short enough. */
function take(text, file) {
  const found = parse(text, file);
  sources = found;
  chosen = 0;
  const rows = found[0].samples.map(([nm], k) => [nm, ...found.map((source) => source.samples[k][1])].join('_'));
  const heading = [first(found[0]), ...found.map((source) => source.name.replace(/[_;,"]/g, ' '))].join('_');
  const packed = [heading, ...rows].join(';');
  remember({
    drawn: undefined,
    column: undefined,
    data: packed.length < 6000 ? packed : undefined,
    file: packed.length < 6000 ? file : undefined,
    lamp: undefined,
  });
  const what = found.length === 1 ? 'spectrum' : 'spectra';
  say(`${file}: ${found.length} ${what}${packed.length < 6000 ? '' : ', too long for a link'}`);
}

/** Does work that may fail, and shows the message if it does. */
async function attempt(work) {
  try {
    await work();
    measure();
    view.failure.textContent = '';
  } catch (error) {
    view.failure.textContent = inPage(error.message);
    if (good) {
      ({ sources, chosen } = good);
      remember(good.told);
    }
  }
  choices();
}

/** Updates the controls: their options and the chosen ones. */
function choices() {
  if (view.among !== sources) {
    view.among = sources;
    view.column.replaceChildren(...options(sources.map((source, k) => [String(k), source.name])));
  }
  view.column.value = chosen;
  view.columns.hidden = sources.length < 2;
  view.lamp.value = state.drawn || !state.lamp ? '' : state.lamp;
  view.under.hidden = state.kind !== 'surface';
  view.draw.setAttribute('aria-pressed', Boolean(state.drawn));
}

const open = (file) =>
  attempt(async () => {
    const bytes = new Uint8Array(await file.arrayBuffer());
    if ((bytes[0] === 0xff && bytes[1] === 0xfe) || (bytes[0] === 0xfe && bytes[1] === 0xff)) {
      throw new Error(`${file.name}:1: the text is UTF-16; save it as UTF-8`);
    }
    let text;
    try {
      text = new TextDecoder('utf-8', { fatal: true }).decode(bytes);
    } catch {
      throw new Error(`${file.name}: the file is not text in UTF-8; save it as UTF-8, or name another file if it is binary`);
    }
    take(text, file.name);
  });

function measure() {
  const source = sources[chosen],
    reflectance = state.kind === 'surface';
  reading = spectra.spectrum(source, {
    observer: state.observer,
    interpolation: state.interpolation,
    unit: state.unit,
    reflectance,
    light: state.under,
  });
  good = { sources, chosen, told: Object.fromEntries(OF_THE_SPECTRUM.map((key) => [key, state[key]])) };
  show(view, source, reading);
}

function redraw() {
  attempt(() => {
    sources = [drawnSource()];
    chosen = 0;
    remember({
      drawn: hand.values.map((value) => Math.round(100 * value)).join(','),
      data: undefined,
      file: undefined,
      column: undefined,
      lamp: undefined,
    });
  });
}

const change = (key) => (value) => attempt(() => remember({ [key]: value }));

/** The exports: the data as two columns, and all results. */
const first = (source) => (source.averages ? 'band-nm' : 'nm');
const csv = () => [`${first(sources[chosen])},${cell(sources[chosen].name)}`, ...sources[chosen].samples.map((sample) => sample.join(','))].join('\n') + '\n';
const json = () => {
  const { curve, tm30, scale, ...report } = reading;
  return `${JSON.stringify(report)}\n`;
};

/** @param {HTMLElement} section */
export async function build(section) {
  prepare();
  const file = h('input', {
    type: 'file',
    id: 'file',
    accept: '.csv,.txt,.tsv,text/*',
    hidden: true,
    onchange: (event) => {
      if (event.target.files[0]) open(event.target.files[0]);
      event.target.value = '';
    },
  });
  const pasted = h('textarea', {
    id: 'paste',
    'aria-label': 'Spectrum as text: wavelength in nm and value on each line',
    placeholder: 'nm, value\n380, 0.02\n385, 0.03\n…',
    spellcheck: false,
  });
  view = {
    failure: h('p', { class: 'failure', role: 'alert', id: 'failure' }),
    columns: select(
      'Spectrum',
      [],
      '',
      (value) => {
        attempt(() => {
          chosen = Number(value);
          remember({ column: value });
        });
      },
      'column',
    ),
    lamp: h(
      'select',
      {
        id: 'lamp',
        onchange: (event) =>
          attempt(() => {
            if (!event.target.value) return;
            remember({
              lamp: event.target.value,
              drawn: undefined,
              data: undefined,
              file: undefined,
              column: undefined,
            });
            restore();
          }),
      },
      h('option', { value: '' }, 'your own'),
      ...lampNames().map((name) => h('option', { value: name }, name)),
    ),
    draw: h(
      'button',
      {
        type: 'button',
        id: 'draw',
        'aria-pressed': 'false',
        onclick: () => {
          redraw();
          view.spd.svg.focus();
          say('Draw with the pointer or the arrow keys');
        },
      },
      'Draw a spectrum',
    ),
    spd: figure('Spectrum', 'spectrum', [640, 300]),
    hint: h(
      'p',
      { class: 'hint', hidden: true },
      'Drag across the plot. With the keyboard, the left and right arrows choose a wavelength, up and down change its power, and Shift makes larger steps.',
    ),
    diagrams: {
      1931: figure('Chromaticity, CIE 1931', 'chromaticity-1931', [420, 460]),
      1976: figure('Chromaticity, CIE 1976', 'chromaticity-1976', [420, 460]),
    },
    swatch: h('div', { class: 'swatch', role: 'img', id: 'swatch' }),
    big: h('dl', { id: 'big' }),
    rows: h('tbody'),
    cri: figure('Color rendering index', 'cri', [640, 228]),
    tm30: figure('TM-30 color vectors', 'tm30', [420, 420]),
    notes: h('ul', { class: 'notes' }),
    under: select('Under the lamp', lampNames(), state.under, change('under'), 'under'),
  };
  view.column = view.columns.querySelector('select');
  view.spd.element.append(view.hint);
  view.spd.element.classList.add('second');
  drawing(view.spd.svg, () => Boolean(state.drawn), redraw);
  const drop = h(
    'div',
    { class: 'drop', id: 'drop' },
    h(
      'div',
      { class: 'row' },
      h('button', { type: 'button', onclick: () => file.click() }, 'Open a CSV'),
      file,
      h('span', {}, 'or drop one here'),
      view.draw,
      h('label', { style: 'flex:1 1 9rem' }, 'Bundled lamp', view.lamp),
    ),
    h(
      'details',
      {},
      h('summary', {}, 'Paste numbers'),
      pasted,
      h(
        'p',
        { style: 'margin:.4rem 0 0' },
        h(
          'button',
          { type: 'button', id: 'measure', onclick: () => attempt(() => take(pasted.value, 'pasted')) },
          'Measure',
        ),
      ),
    ),
    view.failure,
  );
  for (const name of ['dragover', 'dragleave', 'drop']) {
    addEventListener(name, (event) => {
      if (section.hidden) return;
      drop.classList.toggle('over', name === 'dragover');
      if (name === 'drop' && event.dataTransfer.files[0]) open(event.dataTransfer.files[0]);
    });
  }
  addEventListener('paste', (event) => {
    if (section.hidden || event.target.closest('textarea, input')) return;
    attempt(() => take(event.clipboardData.getData('text'), 'pasted'));
  });
  const kind = select(
    'The numbers are of',
    [
      ['light', 'a light'],
      ['surface', 'a surface (0..1)'],
    ],
    state.kind,
    change('kind'),
    'kind',
  );
  const settings = h(
    'div',
    { class: 'row', style: 'margin-top:.75rem' },
    kind,
    view.under,
    select(
      'Observer',
      OBSERVERS,
      state.observer,
      change('observer'),
      'observer',
    ),
    select(
      'Between samples',
      [
        ['auto', 'by spacing'],
        ['linear', 'linear'],
        ['sprague', 'Sprague'],
      ],
      state.interpolation,
      change('interpolation'),
      'interpolation',
    ),
    select(
      'Unit',
      [
        ['relative', 'relative'],
        ['absolute', 'W/m²/nm'],
      ],
      state.unit,
      change('unit'),
      'unit',
    ),
    view.columns,
  );
  const which = select(
    'Diagram',
    [
      ['1931', 'CIE 1931'],
      ['1976', 'CIE 1976'],
    ],
    state.diagram,
    (value) => {
      remember({ diagram: value });
      show(view, sources[chosen], reading);
    },
    'diagram',
  );
  which.className = 'narrow';
  section.append(
    h(
      'div',
      { class: 'grid' },
      h(
        'div',
        { class: 'column' },
        h('div', { class: 'card first' }, h('h2', {}, 'Spectrum to measure'), drop, settings),
        view.spd.element,
        which,
        h('div', { class: 'half' }, view.diagrams[1931].element, view.diagrams[1976].element),
        view.cri.element,
      ),
      h(
        'div',
        { class: 'column' },
        h(
          'div',
          { class: 'card third' },
          h('h2', {}, 'Color'),
          h('div', { class: 'answer', 'aria-live': 'polite' }, view.swatch, view.big),
          h(
            'div',
            { class: 'wide' },
            h('table', { id: 'numbers' }, h('caption', {}, 'Press a number to copy it with all its digits'), view.rows),
          ),
          h('h3', {}, 'Notes'),
          view.notes,
          h('h3', {}, 'Save'),
          saving('spectrum', csv, json),
        ),
        view.tm30.element,
      ),
    ),
  );
  onWidth(section, () => show(view, sources[chosen], reading));
  await attempt(restore);
  if (view.failure.textContent) {
    const said = view.failure.textContent;
    remember({ ...Object.fromEntries(OF_THE_SPECTRUM.map((key) => [key, undefined])), lamp: 'LED-B3', kind: 'light' });
    kind.querySelector('select').value = 'light';
    await attempt(restore);
    view.failure.textContent = said;
  }
}
