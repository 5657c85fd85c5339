//! Reads averages over bands, which are not points of a curve.
//!
//! A spectrum of few bands, such as those that `nanospectra paint` prints, has in each band the average over
//! the band. A heading that begins with [`HEADING`] says so. Such a spectrum is constant within each band,
//! whose edges lie half way between the wavelengths; that keeps every average.

/// The heading above the wavelengths of averages.
pub const HEADING: &str = "band-nm";

/// Returns the edges of the bands around these wavelengths, of which there are at least two: one more than
/// these.
///
/// The first and the last band reach as far to the outside as to the inside.
pub fn edges(wavelengths: &[f64]) -> Vec<f64> {
    let mut edges: Vec<f64> = wavelengths.windows(2).map(|pair| f64::midpoint(pair[0], pair[1])).collect();
    let last = wavelengths.len() - 1;
    let (low, high) = (2.0 * wavelengths[0] - edges[0], 2.0 * wavelengths[last] - edges[last - 1]);
    edges.insert(0, low);
    edges.push(high);
    edges
}

/// Returns the mean of averages over the nanometer around `nm`, where the spectrum is `below` and `above`
/// outside the bands.
pub fn mean(edges: &[f64], averages: &[f64], nm: f64, [below, above]: [f64; 2]) -> f64 {
    let (from, to) = (nm - 0.5, nm + 0.5);
    let overlap = |low: f64, high: f64| (high.min(to) - low.max(from)).max(0.0);
    let inside = edges.windows(2).zip(averages).map(|(edges, average)| average * overlap(edges[0], edges[1]));
    let (first, last) = (edges[0], edges[edges.len() - 1]);
    below * overlap(f64::NEG_INFINITY, first) + inside.sum::<f64>() + above * overlap(last, f64::INFINITY)
}

/// Returns the corners of the steps that averages are, as pairs of a wavelength in nm and a value.
pub fn steps(wavelengths: &[f64], averages: &[f64]) -> Vec<(f32, f32)> {
    let edges = edges(wavelengths);
    let corners = edges.windows(2).zip(averages).flat_map(|(edges, average)| {
        let [from, to] = [edges[0], edges[1]].map(|edge| edge as f32);
        [(from.next_up(), *average as f32), (to, *average as f32)]
    });
    corners.collect()
}
