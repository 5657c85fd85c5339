// Small helpers of all tabs: elements, messages, downloads, and figures that can be saved.

/** Makes an element. @param {string} tag @param {Record<string, any>} [props] @param {...(Node | string | null | undefined)} children */
export function h(tag, props = {}, ...children) {
  const element = document.createElement(tag);
  for (const [key, value] of Object.entries(props)) {
    if (value === undefined || value === null || value === false) continue;
    if (key.startsWith('on')) element.addEventListener(key.slice(2), value);
    else if (key === 'style') element.style.cssText = value;
    else if (key in element && typeof value !== 'string') element[key] = value;
    else element.setAttribute(key, value === true ? '' : value);
  }
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
}

let timer = 0;
/** Shows a message for five seconds, and tells it to screen readers. @param {string} text */
export function say(text) {
  const status = document.getElementById('status');
  status.textContent = text;
  clearTimeout(timer);
  timer = setTimeout(() => {
    status.textContent = '';
  }, 5000);
}

/** @param {string} text @param {string} what */
export async function copy(text, what) {
  try {
    await navigator.clipboard.writeText(text);
    say(`${what} copied`);
  } catch {
    say(`Copying is not allowed here: ${text}`);
  }
}

/** @param {string} name @param {Blob | string} content @param {string} [type] */
export function download(name, content, type = 'text/plain') {
  const url = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  h('a', { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

/** Returns a plot as a file of its own: the colors that its classes have in the theme are written into it. */
function standalone(svg) {
  const copy = svg.cloneNode(true),
    probe = h('i');
  document.body.append(probe);
  const color = (name) => {
    probe.style.color = `var(--${name})`;
    return getComputedStyle(probe).color;
  };
  const rules =
    `svg{font:12px sans-serif}.axis{stroke:${color('soft')};fill:none}.rule{stroke:${color('line')};fill:none}` +
    `.label{fill:${color('soft')}}.ink{stroke:${color('ink')};fill:none;stroke-width:1.5}.thin{stroke:${color('soft')};fill:none}` +
    `.dashed{stroke-dasharray:4 3}.text{fill:${color('ink')}}`;
  const back = color('plot'),
    { width, height } = svg.viewBox.baseVal;
  probe.remove();
  copy.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  copy.setAttribute('width', width);
  copy.setAttribute('height', height);
  copy.insertAdjacentHTML('afterbegin', `<style>${rules}</style><rect width="100%" height="100%" fill="${back}"/>`);
  // The name of a spectrum may have characters that XML forbids.
  return new XMLSerializer().serializeToString(copy).replace(/[^\t\n\r -\uFFFD]/g, '');
}

async function png(svg, name) {
  const { width, height } = svg.viewBox.baseVal,
    image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(standalone(svg))}`;
  await image.decode();
  const canvas = h('canvas', { width: 2 * width, height: 2 * height });
  canvas.getContext('2d').drawImage(image, 0, 0, 2 * width, 2 * height);
  canvas.toBlob((blob) => download(`${name}.png`, blob));
}

/**
 * Makes a plot with its heading and buttons to save it. `draw` sets the inside of the SVG and a text that describes it.
 * @param {string} title @param {string} name of the file @param {[number, number]} size
 */
export function figure(title, name, [width, height]) {
  const holder = h('div');
  holder.innerHTML = `<svg viewBox="0 0 ${width} ${height}" role="img" id="plot-${name}"><title></title><desc></desc><g></g></svg>`;
  const svg = holder.firstElementChild;
  const save = h(
    'span',
    { class: 'save' },
    h(
      'button',
      {
        type: 'button',
        onclick: () => download(`${name}.svg`, standalone(svg), 'image/svg+xml'),
        'aria-label': `Save ${title} as SVG`,
      },
      'SVG',
    ),
    h('button', { type: 'button', onclick: () => png(svg, name), 'aria-label': `Save ${title} as PNG` }, 'PNG'),
  );
  const element = h('figure', { class: 'card' }, h('figcaption', {}, h('h2', {}, title), save), svg);
  svg.querySelector('title').textContent = title;
  return {
    element,
    svg,
    /** Returns the width to draw at; on a narrow screen it is the plot's own width, so that letters stay readable. */
    width: () => Math.round(Math.min(Math.max(svg.clientWidth || width, 320), width)),
    /** @param {string} inside @param {string} text */
    draw(inside, text, size = [width, height]) {
      svg.setAttribute('viewBox', `0 0 ${size.join(' ')}`);
      svg.querySelector('g').innerHTML = inside;
      svg.querySelector('desc').textContent = text;
      svg.setAttribute('aria-label', `${title}: ${text}`);
    },
  };
}

/** Draws again when the width of an element changes, also when its tab is opened. @param {HTMLElement} element */
export function onWidth(element, draw) {
  let width = 0;
  new ResizeObserver(() => {
    if (element.clientWidth === width) return;
    width = element.clientWidth;
    if (width) requestAnimationFrame(draw);
  }).observe(element);
}

/** Makes the options of a select. @param {Iterable<string | [string, string]>} list @param {string} chosen */
export const options = (list, chosen) =>
  Array.from(list, (item) => {
    const [value, text] = Array.isArray(item) ? item : [item, item];
    return h('option', { value, selected: value === chosen }, text);
  });

/** Makes a select with a label. */
export const select = (label, list, chosen, onchange, id) =>
  h(
    'label',
    {},
    label,
    h('select', { id, onchange: (event) => onchange(event.target.value) }, ...options(list, chosen)),
  );

/** Replaces the words of a message that name options of the command line by those of the page. @param {string} text */
export const inPage = (text) =>
  text
    .replace('give --unit such as absolute (W/m2/nm) or mW/m2/nm, or --lux or --ppfd', 'for W/m²/nm choose that unit')
    .replace('give --percent if it is percent, or shares of 0..1', 'give shares of 0..1, and divide percent by 100')
    .replace('use --interpolation linear', 'choose linear between samples')
    .replace('--light: ', '');

/** Makes buttons that save the results as `name`.csv and `name`.json. @param {string} name @param {() => string} csv @param {() => string} json */
export const saving = (name, csv, json) =>
  h(
    'div',
    { class: 'export' },
    h('button', { type: 'button', id: `${name}-csv`, onclick: () => download(`${name}.csv`, csv(), 'text/csv') }, 'CSV'),
    h(
      'button',
      { type: 'button', id: `${name}-json`, onclick: () => download(`${name}.json`, json(), 'application/json') },
      'JSON',
    ),
  );
