//! Spectral lines of lasers and lamps, whose power lies at one wavelength.

use crate::grid::{Bands, Grid, Layout};
use crate::spectrum::{Power, Spectrum};

impl<const N: usize, G: Bands> Spectrum<Power, N, G> {
    /// Adds a spectral line of `power` at the wavelength `nm`, and returns the power that fell outside the
    /// grid.
    ///
    /// `power` is in W for a spectrum in W/nm. A line exactly on the edge between two bins gives half to
    /// each, so the order in which lines are added does not matter. On an outer edge half of the power is
    /// lost; outside the grid, or at a NaN, all of it.
    ///
    /// ```
    /// # use nanospectra::Light;
    /// let mut sodium = Light::<35>::flat(0.0);
    /// let lost = sodium.add_line(589.0, 1.0) + sodium.add_line(589.6, 0.5);
    /// assert_eq!((sodium.power(), lost), (1.5, 0.0));
    /// ```
    #[must_use = "the power that fell outside the grid"]
    pub fn add_line(&mut self, nm: f32, power: f32) -> f32
    where
        G: Grid,
    {
        if nm.is_nan() {
            return power;
        }
        // Find the nearest edge at or below `nm`. Beside an edge the division may be off by one bin.
        let mut k = ((nm - Layout::<G, N>::START as f32) / Self::WIDTH_NM) as usize;
        if k > 0 && nm < Self::edge_nm(k) {
            k -= 1;
        }
        if k < N && nm >= Self::edge_nm(k + 1) {
            k += 1;
        }
        if nm < Self::edge_nm(0) || nm > Self::edge_nm(N) {
            return power;
        }
        let density = power / Self::WIDTH_NM;
        if nm > Self::edge_nm(k) {
            if let Some(bin) = self.0.get_mut(k) {
                *bin += density;
            }
            return 0.0;
        }
        let mut lost = power;
        for bin in [k.checked_sub(1), Some(k)].into_iter().flatten() {
            if let Some(bin) = self.0.get_mut(bin) {
                *bin += density * 0.5;
                lost -= power * 0.5;
            }
        }
        lost
    }
}
