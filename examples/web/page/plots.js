// The contents of the plots, as SVG text.
import { rgbOf, tint, uvOf, xyOf, xyOfUv } from './color.js';

const n = (x) => Number(x.toFixed(2));
const path = (points, close = false) =>
  points.length ? `M${points.map(([x, y]) => `${n(x)} ${n(y)}`).join('L')}${close ? 'Z' : ''}` : '';
export const escape = (text) =>
  String(text).replace(/[&<>"]/g, (c) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[c]);

/** Makes the axes of a plot: the scales from values to pixels, and their drawing. */
export function frame(
  [left, top, right, bottom],
  [x0, x1, xStep],
  [y0, y1, yStep],
  [xName, yName],
  digits = [0, 1],
  number = (value, digits) => value.toFixed(digits),
) {
  const x = (value) => left + ((value - x0) / (x1 - x0)) * (right - left);
  const y = (value) => bottom - ((value - y0) / (y1 - y0)) * (bottom - top);
  const ticks = (from, to, step) =>
    Array.from({ length: Math.floor((to - from) / step + 1.0001) }, (_, k) => from + k * step);
  let svg = '';
  // The lines are at multiples of the step, wherever the axis begins.
  for (const value of ticks(Math.ceil(y0 / yStep - 1e-9) * yStep, y1, yStep)) {
    svg +=
      `<path class="rule" d="M${left} ${n(y(value))}H${right}"/>` +
      `<text class="label" x="${left - 6}" y="${n(y(value) + 4)}" text-anchor="end">${number(value, digits[1])}</text>`;
  }
  for (const value of ticks(x0, x1, xStep)) {
    svg +=
      `<path class="axis" d="M${n(x(value))} ${bottom}v4"/>` +
      `<text class="label" x="${n(x(value))}" y="${bottom + 17}" text-anchor="middle">${value.toFixed(digits[0])}</text>`;
  }
  svg +=
    `<path class="axis" d="M${left} ${bottom}H${right}"/>` +
    `<text class="label" x="${right}" y="${bottom + 33}" text-anchor="end">${xName}</text>` +
    `<text class="label" x="${left - 6}" y="${top - 8}" text-anchor="start">${yName}</text>`;
  return { x, y, svg };
}

/** Makes the color gradient of the spectrum between two wavelengths. */
function rainbow(id, from, to) {
  const stops = [];
  for (let nm = from; nm <= to; nm += 5)
    stops.push(`<stop offset="${n((nm - from) / (to - from))}" stop-color="${tint(nm)}"/>`);
  return `<linearGradient id="${id}" x1="0" x2="1" y1="0" y2="0">${stops.join('')}</linearGradient>`;
}

/**
 * Returns the axis of any finite range: the number by which values are divided, its exponent of ten (0 if none is
 * written), the ends, and a round step for about four lines up to the larger end.
 */
export function axis(low, high) {
  const largest = Math.max(-low, high) || 1,
    power = Math.floor(Math.log10(largest)),
    exponent = power < -4 || power > 4 ? power : 0;
  // The power of ten may itself be too large or too small for a number.
  const half = Math.trunc(exponent / 2),
    scaled = (value) => value / 10 ** half / 10 ** (exponent - half);
  const [from, to] = [scaled(low), scaled(high > low ? high : low + largest)],
    size = 10 ** Math.floor(Math.log10(scaled(largest) / 4)),
    part = scaled(largest) / 4 / size;
  return { scaled, exponent, from, to, step: size * (part < 1.5 ? 1 : part < 3.5 ? 2 : part < 7.5 ? 5 : 10) };
}

/**
 * Draws a spectrum, filled with the colors of its wavelengths.
 * @param {[number, number][]} samples @param {string} yName
 */
export function spectrum(
  samples,
  yName,
  { id = 'spectrum', from = 380, to = 780, size = [640, 300], top, cursor, lines = [] } = {},
) {
  const inside = samples.filter(([nm]) => nm >= from && nm <= to);
  const all = [...inside, ...lines.flatMap((line) => line.samples)];
  const highest = top ?? Math.max(0, ...all.map(([, value]) => value)),
    lowest = Math.min(0, ...all.map(([, value]) => value));
  const { scaled, exponent, from: low, to: peak, step } = axis(lowest, highest),
    digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const drawing = frame(
    [44, 24, size[0] - 12, size[1] - 38],
    [from, to, size[0] < 500 ? 100 : 50],
    [low, peak * (top ? 1 : 1.06), step],
    ['nm', yName],
    [0, digits],
    (value, digits) => value.toFixed(digits) + (exponent && value ? `e${exponent}` : ''),
  );
  const { x, svg } = drawing,
    y = (value) => drawing.y(scaled(value));
  const outline = inside.map(([nm, value]) => [x(nm), y(value)]);
  let drawn = `<defs>${rainbow(`${id}-colors`, from, to)}</defs>`;
  if (outline.length > 1) {
    const area = [[outline[0][0], y(0)], ...outline, [outline.at(-1)[0], y(0)]];
    // A gradient spans its shape, so it fills a rectangle over the whole axis that is clipped to the area.
    drawn +=
      `<clipPath id="${id}-clip"><path d="${path(area, true)}"/></clipPath>` +
      `<rect x="${x(from)}" y="${drawing.y(peak * 1.06)}" width="${n(x(to) - x(from))}" height="${n(drawing.y(low) - drawing.y(peak * 1.06))}" ` +
      `fill="url(#${id}-colors)" opacity=".85" clip-path="url(#${id}-clip)"/><path class="ink" d="${path(outline)}"/>`;
  }
  let legend = size[0] - 12;
  lines.forEach((line) => {
    drawn += `<path class="${line.plain ? 'thin' : 'ink'}${line.dashed ? ' dashed' : ''}" d="${path(line.samples.map(([nm, value]) => [x(nm), y(value)]))}"/>`;
    if (line.name) {
      // The legend stands above the plot and grows from the right.
      drawn +=
        `<path class="${line.plain ? 'thin' : 'ink'}${line.dashed ? ' dashed' : ''}" d="M${legend - 20} 12H${legend}"/>` +
        `<text class="text" x="${legend - 25}" y="16" text-anchor="end">${escape(line.name)}</text>`;
      legend -= 40 + 7.2 * line.name.length;
    }
  });
  if (cursor)
    drawn += `<path class="thin dashed" d="M${n(x(cursor[0]))} ${drawing.y(peak)}V${y(0)}"/><circle cx="${n(x(cursor[0]))}" cy="${n(y(cursor[1]))}" r="6" class="ink"/>`;
  return { inside: svg + drawn, x, y };
}

const GAMUTS = {
  sRGB: [
    [0.64, 0.33],
    [0.3, 0.6],
    [0.15, 0.06],
  ],
  P3: [
    [0.68, 0.32],
    [0.265, 0.69],
    [0.15, 0.06],
  ],
  'BT.2020': [
    [0.708, 0.292],
    [0.17, 0.797],
    [0.131, 0.046],
  ],
};
const DIAGRAMS = {
  1931: { to: (xy) => xy, from: (p) => p, x: [0, 0.8, 0.1], y: [0, 0.9, 0.1], names: ['x', 'y'] },
  1976: { to: uvOf, from: xyOfUv, x: [0, 0.7, 0.1], y: [0, 0.6, 0.1], names: ['u′', 'v′'] },
};
const fills = new Map();

/** Returns the colors inside the locus as an image, which is made once for each diagram. */
function fill(diagram) {
  if (fills.has(diagram)) return fills.get(diagram);
  const {
      from,
      x: [x0, x1],
      y: [y0, y1],
    } = DIAGRAMS[diagram],
    canvas = document.createElement('canvas');
  canvas.width = 160;
  canvas.height = 160;
  const context = canvas.getContext('2d'),
    image = context.createImageData(160, 160);
  for (let j = 0; j < 160; j++) {
    for (let i = 0; i < 160; i++) {
      const [x, y] = from([x0 + ((i + 0.5) / 160) * (x1 - x0), y1 - ((j + 0.5) / 160) * (y1 - y0)]);
      image.data.set([...rgbOf(x, Math.max(y, 0.01)), 255], 4 * (160 * j + i));
    }
  }
  context.putImageData(image, 0, 0);
  fills.set(diagram, canvas.toDataURL());
  return fills.get(diagram);
}

/**
 * Draws a chromaticity diagram with its locus, gamuts, black bodies and points.
 * @param {'1931' | '1976'} diagram @param {[number, number][]} planck x, y @param {{xy: [number, number], name?: string}[]} points
 * @param {[number, number]} size
 */
export function chromaticity(diagram, planck, points, [width, height]) {
  const { to, x: xs, y: ys, names } = DIAGRAMS[diagram];
  const [right, bottom] = [width - 12, height - 36];
  const { x, y, svg } = frame([44, 24, right, bottom], xs, ys, names, [1, 1]);
  const at = (xy) => {
    const [a, b] = to(xy);
    return [x(a), y(b)];
  };
  const locus = [];
  for (let nm = 390; nm <= 700; nm += 1) locus.push(at(xyOf(nm)));
  const outline = path(locus, true);
  let drawn =
    `<clipPath id="locus-${diagram}"><path d="${outline}"/></clipPath>` +
    `<image href="${fill(diagram)}" x="44" y="24" width="${right - 44}" height="${bottom - 24}" preserveAspectRatio="none" clip-path="url(#locus-${diagram})" opacity=".8"/>` +
    `<path class="ink" d="${outline}"/>`;
  for (const nm of [460, 480, 490, 500, 510, 520, 540, 560, 580, 600, 620, 700]) {
    const [px, py] = at(xyOf(nm)),
      [cx, cy] = at([1 / 3, 1 / 3]),
      d = Math.hypot(px - cx, py - cy);
    const [ux, uy] = [(px - cx) / d, (py - cy) / d];
    // Near the axis there is room for the number only inside the locus.
    const inside = px + 16 * ux < 60;
    drawn +=
      `<path class="ink" d="M${n(px)} ${n(py)}l${n(5 * ux)} ${n(5 * uy)}"/><text ${inside ? 'fill="#000"' : 'class="label"'} ` +
      `x="${n(px + (inside ? -14 : 16) * ux)}" y="${n(py + (inside ? -8 : 12) * uy + 4)}" text-anchor="middle" font-size="11">${nm}</text>`;
  }
  // The legend stands where the locus does not reach.
  const legend = diagram === '1931' ? 48 : bottom - 72;
  let row = 0;
  for (const [name, primaries] of Object.entries(GAMUTS)) {
    const dash = ['', ' stroke-dasharray="5 3"', ' stroke-dasharray="2 2"'][row];
    drawn += `<path d="${path(primaries.map(at), true)}" fill="none" stroke="#000" stroke-opacity=".55"${dash}/>`;
    const ly = legend + 17 * row++;
    drawn += `<path class="ink"${dash} d="M${right - 90} ${ly - 4}h26"/><text class="text" x="${right - 58}" y="${ly}">${name}</text>`;
  }
  drawn += `<path d="${path(planck.map(at))}" fill="none" stroke="#000" stroke-width="1.2"/>`;
  for (const { xy, name } of points) {
    const [px, py] = at(xy);
    drawn +=
      `<circle cx="${n(px)}" cy="${n(py)}" r="6" fill="none" stroke="#fff" stroke-width="4"/>` +
      `<circle cx="${n(px)}" cy="${n(py)}" r="6" fill="none" stroke="#000" stroke-width="2"/>`;
    if (name) drawn += `<text x="${n(px + 10)}" y="${n(py + 4)}" fill="#000">${escape(name)}</text>`;
  }
  return svg + drawn;
}

/** Draws R1..R15 as bars in the colors of the samples. @param {(number | null)[]} r @param {string[]} colors */
export function bars(r, colors, width) {
  const each = (width - 62) / 15,
    low = Math.min(0, Math.max(-100, Math.floor(Math.min(...r) / 25) * 25));
  const { y, svg } = frame([44, 24, width - 12, 202], [0, 15, 100], [low, 100, 25], ['', 'R'], [0, 0]);
  let drawn = '';
  r.forEach((value, k) => {
    const x = 50 + k * each,
      shown = Math.max(value, low),
      [a, b] = [y(Math.max(shown, 0)), y(Math.min(shown, 0))];
    drawn +=
      `<rect x="${n(x)}" y="${n(a)}" width="${n(0.72 * each)}" height="${n(Math.max(b - a, 1))}" fill="${colors[k]}"/>` +
      `<text class="text" x="${n(x + 0.36 * each)}" y="${n(a - 4)}" text-anchor="middle" font-size="10">${value.toFixed(0)}</text>` +
      `<text class="label" x="${n(x + 0.36 * each)}" y="219" text-anchor="middle" font-size="11">${each < 30 ? '' : 'R'}${k + 1}</text>`;
  });
  return svg.replace(/<text class="label"[^>]*>0<\/text>(?=<path class="axis" d="M44)/, '') + drawn;
}

/** The colors of the 16 hue bins of TM-30. */
const HUES = [
  '#e62828',
  '#e74b4b',
  '#fb812e',
  '#ffb529',
  '#cbca46',
  '#7eb94c',
  '#41c06d',
  '#009c7c',
  '#16bcb0',
  '#00a4bf',
  '#0085c3',
  '#3b62aa',
  '#4568ae',
  '#6a4e85',
  '#9d69a1',
  '#a74f81',
];

/** Draws the color vector graphic of TM-30, in which the reference is the circle. @param {import('./nanospectra/nanospectra.d.ts').Fidelity} tm30 */
export function vectors({ rf, rg, bins }) {
  const [cx, cy, r] = [210, 210, 140];
  let drawn = '';
  for (const share of [0.8, 0.9, 1.1, 1.2])
    drawn += `<circle class="rule" cx="${cx}" cy="${cy}" r="${n(r * share)}"/>`;
  for (let k = 0; k < 16; k++) {
    const turn = (k / 16) * 2 * Math.PI,
      [c, s] = [Math.cos(turn), Math.sin(turn)];
    drawn += `<path class="rule dashed" d="M${n(cx + 0.2 * r * c)} ${n(cy - 0.2 * r * s)}L${n(cx + 1.28 * r * c)} ${n(cy - 1.28 * r * s)}"/>`;
  }
  drawn += `<circle class="axis" cx="${cx}" cy="${cy}" r="${r}" stroke-width="1.5"/>`;
  const tips = [];
  bins.forEach((bin, k) => {
    const turn = ((k + 0.5) / 16) * 2 * Math.PI,
      [c, s] = [Math.cos(turn), Math.sin(turn)];
    drawn += `<text class="label" x="${n(cx + 1.36 * r * c)}" y="${n(cy - 1.36 * r * s + 4)}" text-anchor="middle" font-size="11">${k + 1}</text>`;
    if (!bin) return;
    const [along, around] = [1 + bin.chroma_shift, bin.hue_shift];
    const tip = [cx + r * (along * c - around * s), cy - r * (along * s + around * c)];
    tips.push(tip);
    drawn +=
      `<path d="M${n(cx + r * c)} ${n(cy - r * s)}L${n(tip[0])} ${n(tip[1])}" stroke="${HUES[k]}" stroke-width="4"/>` +
      `<circle cx="${n(tip[0])}" cy="${n(tip[1])}" r="3.5" fill="${HUES[k]}"/>`;
  });
  drawn += `<path class="ink" d="${path(tips, true)}"/>`;
  const label = (x, y, name, value, anchor) =>
    `<text class="label" x="${x}" y="${y}" text-anchor="${anchor}">${name}</text>` +
    `<text class="text" x="${x}" y="${y + 24}" text-anchor="${anchor}" font-size="22">${value.toFixed(0)}</text>`;
  return drawn + label(8, 18, 'Rf', rf, 'start') + label(412, 18, 'Rg', rg, 'end');
}

/** Draws errors against the number of bands, both on logarithmic scales. @param {{name: string, points: [number, number][], chosen: boolean}[]} lines */
export function cost(lines, [bands, value], counts, width) {
  const [left, top, right, bottom] = [52, 24, width - 12, 262],
    x = (N) => left + (Math.log(N / 8) / Math.log(81 / 8)) * (right - left);
  const y = (error) => bottom - ((Math.log10(Math.max(error, 1e-3)) + 3) / 4) * (bottom - top);
  let drawn = '';
  for (const error of [0.001, 0.01, 0.1, 1, 10]) {
    drawn += `<path class="rule" d="M${left} ${n(y(error))}H${right}"/><text class="label" x="${left - 6}" y="${n(y(error) + 4)}" text-anchor="end">${error}</text>`;
  }
  for (const N of counts) {
    drawn += `<path class="axis" d="M${n(x(N))} ${bottom}v4"/><text class="label" x="${n(x(N))}" y="${bottom + 17}" text-anchor="middle" font-size="11">${N}</text>`;
  }
  drawn +=
    `<path class="axis" d="M${left} ${bottom}H${right}"/><text class="label" x="${right}" y="${bottom + 33}" text-anchor="end">bands</text>` +
    `<text class="label" x="6" y="14">mean CIEDE2000</text>`;
  lines.forEach(({ name, points, chosen }, k) => {
    const dash = ['1 3', '5 3', '', '8 3 2 3'][k];
    drawn +=
      `<path class="${chosen ? 'ink' : 'thin'}" stroke-dasharray="${dash}" d="${path(points.map(([N, error]) => [x(N), y(error)]))}"/>` +
      `<path class="${chosen ? 'ink' : 'thin'}" stroke-dasharray="${dash}" d="M${right - 30} ${34 + 17 * k}h28"/>` +
      `<text class="${chosen ? 'text' : 'label'}" x="${right - 36}" y="${38 + 17 * k}" text-anchor="end">${name}</text>`;
  });
  return `${drawn}<circle cx="${n(x(bands))}" cy="${n(y(value))}" r="5" class="ink" fill="none"/>`;
}
