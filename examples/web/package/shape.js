// Finds the peak, the centroid and the width of a spectrum, as `reading/shape.rs` of examples/cli/src/measure does.

/** Returns where the line from a sample to a farther one falls to `half`, or undefined. */
const crossing = (from, to, half) =>
  from[1] > half && to[1] <= half ? from[0] + ((to[0] - from[0]) * (from[1] - half)) / (from[1] - to[1]) : undefined;

/**
 * Returns the shape of samples, in nm, with straight lines between them: the wavelength of the highest sample, the mean
 * wavelength weighed by power, and the width of the peak at half its height.
 * @param {[number, number][]} samples of which there are at least two
 * @returns {{peak: number, centroid: number | null, width: number | null}}
 */
export function shapeOf(samples) {
  // Samples of any size stay finite in the sums.
  const height = samples.reduce((most, [, value]) => Math.max(most, value), -Infinity),
    peak = samples.findIndex(([, value]) => value === height);
  let power = 0,
    moment = 0;
  for (let k = 1; k < samples.length; k++) {
    const [a, p, b, q] = [samples[k - 1][0], samples[k - 1][1] / height, samples[k][0], samples[k][1] / height];
    power += (b - a) * ((p + q) / 2);
    // The integral of the wavelength times a straight line.
    moment += ((b - a) * (p * (2 * a + b) + q * (a + 2 * b))) / 6;
  }
  let above, below;
  for (let k = peak; above === undefined && k + 1 < samples.length; k++) above = crossing(samples[k], samples[k + 1], height / 2);
  for (let k = peak; below === undefined && k > 0; k--) below = crossing(samples[k], samples[k - 1], height / 2);
  const isKnown = height > 0 && above !== undefined && below !== undefined;
  return {
    peak: samples[peak][0],
    centroid: power > 0 && height > 0 ? moment / power : null,
    width: isKnown ? above - below : null,
  };
}
