// How the crate reduces an observer to few weights (src/observer/fold.rs), for any number of bands, and the errors of
// that over the 99 color evaluation samples. A WebAssembly module has its number of bands in its types, so this is
// written again in JavaScript; a test compares the results with those of the crate.

const FIRST = 360;
/** The weights of 1 nm are at the whole nanometers FIRST..830, and their cells reach half a nanometer to each side. */
const START = FIRST - 0.5;

/** Returns the sum of the 1 nm weights that fall into each bin, and their moments about the bin's center. */
function moments(row, from, width, bands, points) {
  const [mass, first, second] = [0, 1, 2].map(() => new Float64Array(bands));
  const add = (weight, at, half) => {
    const bin = Math.min(Math.max(Math.floor(at), 0), bands - 1),
      t = Math.min(Math.max(at, 0), bands) - bin - 0.5;
    mass[bin] += weight;
    first[bin] += weight * t;
    second[bin] += weight * (t * t + (half * half) / 3);
  };
  row.forEach((weight, k) => {
    const low = (START + k - from) / width,
      high = (START + k + 1 - from) / width;
    if (points) return add(weight, (low + high) / 2, 0);
    for (let at = low; at < high;) {
      const edge = at < 0 ? 0 : at >= bands ? high : Math.floor(at) + 1,
        to = Math.min(edge, high);
      add((weight * (to - at)) / (high - low), (at + to) / 2, at < 0 || at >= bands ? 0 : (to - at) / 2);
      at = to;
    }
  });
  return { mass, first, second };
}

/** Takes a spectrum as parabolas with the averages of a bin and its neighbors; an end bin continues its neighbor's. */
function parabola({ mass, first, second }) {
  const weights = mass.slice(),
    last = mass.length - 1;
  mass.forEach((m, k) => {
    const middle = Math.min(Math.max(k, 1), last - 1),
      shift = k - middle;
    const slope = (first[k] + shift * m) / 2,
      bend = (second[k] + 2 * shift * first[k] + shift * shift * m - m / 12) / 2;
    weights[k] -= m;
    weights[middle] += m - 2 * bend;
    weights[middle - 1] += bend - slope;
    weights[middle + 1] += bend + slope;
  });
  return weights;
}

/** Takes a spectrum as the histospline, the smoothest curve with the averages of all bins. */
function spline({ mass, first, second }) {
  const bands = mass.length,
    g = new Float64Array(bands + 1),
    pivot = new Float64Array(bands).fill(4);
  for (let i = 1; i < bands; i++) {
    g[i] = (second[i - 1] - second[i] + first[i - 1] + first[i]) / 2 + (mass[i] - mass[i - 1]) / 24;
    if (i === 1) continue;
    pivot[i] -= 1 / pivot[i - 1];
    g[i] -= g[i - 1] / pivot[i - 1];
  }
  const weights = mass.slice();
  for (let i = bands - 1; i > 0; i--) {
    g[i] = (g[i] - g[i + 1]) / pivot[i];
    weights[i] += 6 * g[i];
    weights[i - 1] -= 6 * g[i];
  }
  return weights;
}

/** Returns the averages over each bin of 1 nm cells that begin at `start`; beyond the ends they are `beyond(end value)`. */
function averages(values, start, from, width, bands, beyond) {
  const end = values.length - 1;
  return Array.from({ length: bands }, (_, k) => {
    const low = from + k * width,
      high = low + width;
    let sum = 0;
    for (let at = low; high - at > 1e-9;) {
      const cell = Math.floor(at - start + 1e-9),
        to = Math.min(start + cell + 1, high);
      sum += (to - at) * (cell < 0 ? beyond(values[0]) : cell > end ? beyond(values[end]) : values[cell]);
      at = to;
    }
    return sum / width;
  });
}

const sum = (row, values) => row.reduce((sum, weight, k) => sum + weight * values[k], 0);
const hold = (end) => end;

/**
 * Prepares the 99 samples and the observer.
 * @param {import('./nanospectra/nanospectra.js').Light} spectra the module for Lab, CIEDE2000 and the tables
 * @returns {(light: ArrayLike<number>) => (bands: number, range: [number, number], scheme: number) => number[]} a
 * function of a light at 360..830 nm, which returns a function that computes CIEDE2000 of each sample for a number of
 * bands, folded by step (0), parabola (1) or spline (2), or not folded (3)
 */
export function closely(spectra) {
  const { wasm, out, published } = spectra;
  const eye = [0, 1, 2].map((c) => Array.from(published.eye.subarray(471 * c, 471 * (c + 1)))),
    samples = Array.from({ length: 99 }, (_, k) => published.samples.subarray(401 * k, 401 * (k + 1)));
  const labs = (rows, surfaces) => {
    const white = rows.map((row) => row.reduce((sum, weight) => sum + weight));
    return surfaces.map((surface) => {
      wasm.lab(...rows.map((row) => sum(row, surface)), ...white);
      return out.slice(0, 3);
    });
  };
  // These are the same for every light.
  const known = new Map();
  const once = (key, make) => {
    if (!known.has(key)) known.set(key, make());
    return known.get(key);
  };
  const fine = samples.map((sample) => averages(sample, 379.5, START, 1, 471, hold));
  return (light) => {
    const under = eye.map((row) => row.map((weight, k) => weight * light[k])),
      truth = labs(under, fine);
    return (bands, [from, to], scheme) => {
      const width = (to - from) / bands,
        grid = `${from} ${to} ${bands}`;
      let rows;
      if (scheme === 3) {
        const power = averages(light, START, from, width, bands, () => 0),
          folded = once(`eye ${grid}`, () => eye.map((row) => moments(row, from, width, bands, false).mass));
        rows = folded.map((row) => row.map((weight, k) => weight * power[k]));
      } else {
        const fold = [({ mass }) => mass, parabola, spline][scheme];
        rows = under.map((row) => fold(moments(row, from, width, bands, scheme === 2 && width >= 2)));
      }
      const surfaces = once(grid, () => samples.map((sample) => averages(sample, 379.5, from, width, bands, hold)));
      return labs(rows, surfaces).map((lab, k) => wasm.difference(...lab, ...truth[k]));
    };
  };
}
