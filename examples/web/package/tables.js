// Unpacks the measured tables. They are packed by tools/pack.mjs as decimal integers, each of which is predicted from
// those before it, and the differences are Rice coded. That takes a tenth of the size of f32 and gives the same bits.
//
// A table begins with 6 bytes: the rule with the order of the prediction, the number of columns, the number of rows in
// two bytes, and the zeros in front of and behind each column. Its columns follow as one stream of bits, in which 16
// numbers share a number of decimals and a parameter of the code.

import { OUTER, everyNanometerOf, quintic } from './sprague.js';

/** The rules by which columns become numbers. */
export const RULES = { plain: 0, sample: 1, test: 2, copy: 3, lights: 4, daylight: 5 };

export const BLOCK = 16;
export const POWERS = Array.from({ length: 16 }, (_, k) => 10 ** k);

/** Predicts a number by a polynomial through the `order` numbers before it, in units of 1 / scale. */
export function predicted(values, at, order, scale) {
  const before = (j) => (at >= j ? Math.round(values[at - j] * scale) : 0);
  if (order === 0) return 0;
  if (order === 1) return before(1);
  if (order === 2) return 2 * before(1) - before(2);
  if (order === 3) return 3 * before(1) - 3 * before(2) + before(3);
  return 4 * before(1) - 6 * before(2) + 4 * before(3) - before(4);
}

/**
 * @param {Uint8Array} bytes
 * @returns {Float32Array[]} for each table its columns, one after the other, as they lie in a module's memory
 */
export function unpack(bytes) {
  let at = 0,
    bit = 0;
  const next = () => {
    const value = (bytes[at] >> (7 - bit)) & 1;
    if (++bit === 8) {
      bit = 0;
      at++;
    }
    return value;
  };
  const number = (n) => {
    let x = 0;
    while (n-- > 0) x = x * 2 + next();
    return x;
  };
  const tables = [],
    published = [];
  for (let left = bytes[at++]; left > 0; left--) {
    const [kind, columns, low, high, before, behind] = bytes.subarray(at, (at += 6));
    const rows = low + 256 * high,
      order = kind >> 3;
    const read = Array.from({ length: columns }, () => {
      const values = [];
      for (let k = 0, scale = 1; values.length < rows;) {
        if (values.length % BLOCK === 0) {
          scale = POWERS[number(4)];
          k = number(5);
        }
        let q = 0;
        while (next()) q++;
        const z = q * 2 ** k + number(k);
        values.push((predicted(values, values.length, order, scale) + (z % 2 ? -(z + 1) / 2 : z / 2)) / scale);
      }
      return values;
    });
    if (bit) {
      bit = 0;
      at++;
    }
    published.push(read);
    tables.push(numbers(kind & 7, read, before, behind, tables, published));
  }
  return tables;
}

/** Turns published digits into the f32 that the crate's build script makes of them. */
function numbers(rule, columns, before, behind, tables, published) {
  if (rule === RULES.copy) {
    const [[table, column, length]] = columns;
    return tables[table].slice(column * length, (column + 1) * length);
  }
  if (rule === RULES.lights || rule === RULES.daylight) {
    const [[eye, samples, ...parts]] = columns;
    const lights =
      rule === RULES.lights
        ? [
            [350, 150],
            [750.5, 250.5],
          ].flatMap((half) => blackBodies(...half, published[eye][1]))
        : parts.map((part) => linear(tables[part]));
    return colors(lights, tables[eye], testColors(published[samples]));
  }
  if (rule === RULES.test) return Float32Array.from(nodes(columns));
  const whole = columns.map((values) => {
    if (rule === RULES.sample) return everyNanometer(values);
    return [...Array(before).fill(0), ...values, ...Array(behind).fill(0)];
  });
  return Float32Array.from(whole.flat());
}

/** Interpolates from 5 nm to 1 nm as CIE 224 did, by Sprague's quintic with the end values held. */
function everyNanometer(v) {
  const at = (i) => v[Math.min(Math.max(i, 0), v.length - 1)];
  const out = [];
  for (let i = 0; i <= 5 * (v.length - 1); i++) {
    const cell = Math.min(Math.floor(i / 5), v.length - 2),
      t = (i - 5 * cell) / 5;
    const p = [-2, -1, 0, 1, 2, 3].map((j) => at(cell + j));
    // Nine decimals are published, and further ones are only rounding errors of these sums.
    out.push(Math.round(quintic(p, t) * 1e9) / 1e9);
  }
  return out;
}

/** Arranges the 15 test colors and a white node after node, with two nodes beyond each end, as the crate sums them. */
function nodes(columns) {
  const inside = columns.map((values) => values.map(Math.fround));
  const beyond = (at) => OUTER.map((weights) => weights.reduce((sum, x, i) => sum + x * at(i), 0));
  const whole = inside.map((v) => [...beyond((i) => v[i]).reverse(), ...v, ...beyond((i) => v[v.length - 1 - i])]);
  return whole[0].flatMap((_, node) => [...whole.map((column) => column[node]), 1]);
}

/** Returns X, Y, Z of the samples and of a white under each of the lights, as sums in f64. */
function colors(lights, eye, samples) {
  const whole = [...samples, new Float32Array(471).fill(1)];
  return Float32Array.from(
    lights.flatMap((light) =>
      [0, 471, 942].flatMap((row) => {
        const seen = light.map((power, k) => power * eye[row + k]);
        return whole.map((sample) => seen.reduce((sum, power, k) => sum + power * sample[k], 0));
      }),
    ),
  );
}

const counted = (n, what) => Array.from({ length: n }, (_, k) => what(k));

/** Returns the terms of a Chebyshev series for black bodies with Y = 100, by the same operations as tables/reference.rs. */
function blackBodies(middle, half, ybar) {
  const exp = (x) => {
    let sum = 1;
    for (let n = 14; n > 0; n--) sum = 1 + (x / 1024 / n) * sum;
    for (let n = 0; n < 10; n++) sum *= sum;
    return sum;
  };
  const places = counted(10, (k) => {
    const angle = Math.PI * ((k + 0.5) / 10);
    let sum = 1;
    for (let n = 20; n > 0; n--) sum = 1 - ((angle * angle) / (2 * n * (2 * n - 1))) * sum;
    return sum;
  });
  const lights = places.map((place) => {
    const light = counted(471, (k) => {
      const ratio = 560 / (360 + k),
        a = (1.4388e7 * 1e-6) / (360 + k),
        x = a * (middle + half * place);
      return (ratio * ratio * ratio * ratio * ratio * (x / (exp(x) - 1))) / a;
    });
    const y = light.reduce((sum, value, k) => sum + value * ybar[k], 0);
    return light.map((value) => (value * 100) / y);
  });
  let [before, now] = [places, places.map(() => 1)];
  return counted(10, (n) => {
    const shares = now.map((term) => ((n ? 2 : 1) / 10) * term);
    [before, now] = [now, now.map((term, k) => (n ? 2 * places[k] * term - before[k] : places[k]))];
    return counted(471, (k) => shares.reduce((sum, share, j) => sum + share * lights[j][k], 0));
  });
}

const f = Math.fround;

/** Interpolates values at every 5 nm from 300 nm linearly to 360..830 nm, in f32. */
const linear = (v) =>
  counted(471, (k) => {
    const cell = Math.min(Math.floor((60 + k) / 5), v.length - 2);
    return f(v[cell] + f(f((60 + k - 5 * cell) / 5) * f(v[cell + 1] - v[cell])));
  });

/** Returns the test colors at every nanometer; the last is tabulated at 380..780 nm and held beyond. */
const testColors = (columns) =>
  columns.map((values, k) =>
    k < 14 ? everyNanometerOf(values.map(f), 360, 830, true) : everyNanometerOf(values.slice(4, 85).map(f), 380, 780, true),
  );
