//! Transparent layers thin enough to show colors: soap, oil on water, the coating of a lens.

#[cfg(feature = "libm")]
use crate::grid::Bins;
use crate::grid::Grid;
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::math::{Double, Math};
use crate::matter::PowerShares;
#[cfg(feature = "libm")]
use crate::matter::Reflector;
use crate::matter::film::airy::{Edge, Tilted};
use crate::matter::film::shares::bins;
use crate::spectrum::{Factor, Spectrum};
#[cfg(feature = "libm")]
use core::marker::PhantomData;

/// The refractive indices that describe a [`ThinFilm`]: three constants, or a function of the wavelength in
/// nm.
///
/// # Example
///
/// ```
/// use nanospectra::matter::FilmIndices;
/// // Water between air and air, by two terms of Cauchy's formula: 1.3328 in yellow.
/// let soap = |nm: f32| [1.0, 1.324 + 3046.0 / (nm * nm), 1.0];
/// assert!((soap.at(589.3)[1] - 1.3328).abs() < 1e-4);
/// assert_eq!([1.0, 1.38, 1.52].at(589.3), [1.0, 1.38, 1.52]);
/// ```
pub trait FilmIndices {
    /// Returns the indices at the wavelength `nm` of the medium that the light comes from, of the film, and
    /// of the medium behind it. See the [example](FilmIndices#example).
    fn at(&self, nm: f32) -> [f32; 3];
}

impl FilmIndices for [f32; 3] {
    fn at(&self, _nm: f32) -> [f32; 3] {
        *self
    }
}

impl<F: Fn(f32) -> [f32; 3]> FilmIndices for F {
    fn at(&self, nm: f32) -> [f32; 3] {
        self(nm)
    }
}

/// One layer that does not absorb, between two media that do not absorb either, with all of its reflections.
///
/// Make it by [`new`](Self::new); then [`reflectance`](Self::reflectance) gives a spectrum and
/// [`at`](Self::at) the shares at one wavelength. The formula is Airy's, which sums all beams that go to and
/// fro in the layer. For layers that absorb, or more than one, use a [`Stack`](crate::matter::Stack).
///
/// Each bin of a spectrum gets the mean over the bin. The value at the center of the bin would be wrong as
/// soon as fringes are as narrow as bins: 31 points on the spectrum of a film of 1 mm pick 31 of its
/// thousands of fringes and show a color that the film does not have.
///
/// # Example
///
/// ```
/// # #[cfg(feature = "libm")] {
/// use nanospectra::matter::ThinFilm;
/// // A quarter of a wave of MgF2 on a lens: 4.3 % reflected become 1.26 %.
/// let coating = ThinFilm::new([1.0, 1.38, 1.52], 550.0 / (4.0 * 1.38));
/// let [s, p] = coating.at(550.0, 1.0);
/// assert!((s.reflected - 0.01260).abs() < 1e-5 && (p.reflected - 0.01260).abs() < 1e-5);
/// // As a filter in 31 bins: with the least reflectance in green, and what is not reflected gets through.
/// let r = coating.reflectance::<31, nanospectra::Bins<400, 710>>(1.0);
/// let t = coating.transmittance::<31, nanospectra::Bins<400, 710>>(1.0);
/// assert!(r[15] < r[0] && r[15] < r[30] && (r[15] + t[15] - 1.0).abs() < 1e-6);
/// // A soap film about to burst is black.
/// let [s, _] = ThinFilm::new([1.0, 1.33, 1.0], 5.0).at(550.0, 1.0);
/// assert!(s.reflected < 0.002);
/// # }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThinFilm<I = [f32; 3]> {
    indices: I,
    thickness_nm: f32,
}

/// From this number of turns on, the 48 bits of the phase leave too little of the fraction of a turn.
const MANY_TURNS: f32 = 1e12;

impl<I: FilmIndices> ThinFilm<I> {
    /// Makes a film from the refractive indices before, in and behind it, and its thickness in nm.
    ///
    /// The indices, each 1e-3..=1e3, are three numbers or a function of the wavelength, such as
    /// `|nm| [1.0, 1.324 + 3046.0 / (nm * nm), 1.0]`. `thickness_nm` is 0 or more; an infinite one makes a
    /// plate without interference. Outside these ranges every result is NaN. See the [example](#example).
    pub const fn new(indices: I, thickness_nm: f32) -> Self {
        ThinFilm { indices, thickness_nm }
    }

    /// Computes the shares of s and of p polarized light of one wavelength that are reflected and
    /// transmitted.
    ///
    /// `nm`, above 0 and up to 1e9, is the wavelength in vacuum; `cos_theta` is the cosine of the angle of
    /// incidence, clamped to 0..=1. See the [example](#example).
    ///
    /// # Accuracy
    /// For a film that reflects almost nothing, the relative error is 12 units of 2^-24. For light from air
    /// and indices of 1 to 4 the absolute error is 7e-6 at cosines from 0.05 and 2e-6 from 0.2; the phase is
    /// kept to 48 bits, so this holds for a film of 10 cm too. If the light comes from a denser medium than
    /// the film, the error grows beside the critical angle with the thickness of the film: the largest that a
    /// search has found is 6e-4, at 7 cm.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn at(&self, nm: f32, cos_theta: f32) -> [PowerShares; 2] {
        self.at_with::<Portable>(nm, cos_theta)
    }

    /// Computes the reflectance for unpolarized light in each bin, as the mean over the bin.
    ///
    /// `cos_theta` is the cosine of the angle of incidence, clamped to 0..=1. See the [example](#example).
    ///
    /// # Accuracy
    /// Of the mean over a bin, absolute, for films of 1 nm to 0.1 mm in bins of 1 to 22 nm: 5e-6 for soap and
    /// for coated lenses, 1.5e-5 for n = 2.4 on glass, 3e-5 at grazing angles and for an air gap in silicon,
    /// where faces reflect 36 % (searched in `tests/matter/worst_layers.rs`). A soap film of 1 mm has its
    /// color within 0.02 CIEDE2000 in 16, 31 or 60 bins (points at their centers: 2 to 20), one of 20 um
    /// within 0.6, 0.2 and 0.14.
    ///
    /// # Cost
    /// Films of few fringes are read at three points in each bin, and at more where the phase runs through
    /// more than a part of a fringe: up to 768 if the faces reflect nearly all light. From a fringe and a
    /// quarter in a bin on, the fringes are integrated from the two ends of the bin, at the same cost for any
    /// thickness. On a Cortex-M4F 31 bands take 730 bytes of stack at opt-level 3, and 1,280 at "s".
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn reflectance<const N: usize, G: Grid>(&self, cos_theta: f32) -> Spectrum<Factor, N, G> {
        let [s, p] = self.reflectances::<N, G>(cos_theta);
        (s + p) * 0.5
    }

    /// Computes the transmittance for unpolarized light in each bin, as the mean over the bin. Otherwise as
    /// [`reflectance`](Self::reflectance); see the [example](#example).
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn transmittance<const N: usize, G: Grid>(&self, cos_theta: f32) -> Spectrum<Factor, N, G> {
        let [s, p] = self.transmittances::<N, G>(cos_theta);
        (s + p) * 0.5
    }

    /// Computes the reflectances for s and for p polarized light. Otherwise as
    /// [`reflectance`](Self::reflectance).
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn reflectances<const N: usize, G: Grid>(&self, cos_theta: f32) -> [Spectrum<Factor, N, G>; 2] {
        self.bins_with::<Portable, N, G>(cos_theta, |shares| shares.reflected)
    }

    /// Computes the transmittances for s and for p polarized light. Otherwise as
    /// [`reflectance`](Self::reflectance).
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn transmittances<const N: usize, G: Grid>(&self, cos_theta: f32) -> [Spectrum<Factor, N, G>; 2] {
        self.bins_with::<Portable, N, G>(cos_theta, |shares| shares.transmitted)
    }

    /// Makes a [`Reflector`] of this film, whose reflectance is computed in the bins of one grid.
    ///
    /// It can be the boundary of microfacets or of a mirror.
    ///
    /// # Example
    ///
    /// ```
    /// # use nanospectra::Bins;
    /// use nanospectra::geometry::Direction;
    /// use nanospectra::matter::{Brdf, Microfacet, ThinFilm, TrowbridgeReitz};
    /// // An oxide layer on rough titanium, in 31 bins.
    /// let oxide = ThinFilm::new([1.0, 2.2, 2.7], 60.0).on_grid::<31, Bins<400, 700>>();
    /// let rough = Microfacet { facets: TrowbridgeReitz::new(0.3), boundary: oxide };
    /// let f = rough.f(Direction::NORMAL, Direction::NORMAL);
    /// assert!(f[0] > 0.0 && f[0] != f[30]);
    /// ```
    #[cfg(feature = "libm")]
    #[must_use]
    pub const fn on_grid<const N: usize, G: Grid>(self) -> FilmOnGrid<N, G, I>
    where
        I: Copy,
    {
        FilmOnGrid { film: self, grid: PhantomData }
    }

    /// Computes the same as [`at`](Self::at), on the math backend `M`.
    #[must_use]
    pub fn at_with<M: Math>(&self, nm: f32, cos_theta: f32) -> [PowerShares; 2] {
        let Some(tilted) = self.tilted(nm, cos_theta) else { return [PowerShares::NAN; 2] };
        let Some([s, p]) = tilted.faces() else { return [PowerShares::MIRROR; 2] };
        if self.is_plate(&tilted, nm) {
            return [s.incoherent(), p.incoherent()];
        }
        let crossing = tilted.crossing::<M>(self.turns(&tilted, nm), nm, self.thickness_nm);
        [s.coherent(tilted.fades, crossing), p.coherent(tilted.fades, crossing)]
    }

    /// Computes the mean over each bin of one share, for s and for p polarized light, on the math backend
    /// `M`.
    ///
    /// `share` picks the share, for instance `|shares| shares.reflected`.
    #[must_use]
    pub fn bins_with<M: Math, const N: usize, G: Grid>(
        &self,
        cos_theta: f32,
        share: impl Fn(PowerShares) -> f32,
    ) -> [Spectrum<Factor, N, G>; 2] {
        bins(|low_nm, high_nm| self.between_with::<M>(low_nm, high_nm, cos_theta).map(&share))
    }

    /// Computes the mean shares over the wavelengths from `low_nm` to `high_nm`, all with the same weight,
    /// for s and for p polarized light.
    ///
    /// Where there are many fringes, their integral over the phase is taken in closed form (the sum over all
    /// beams is an arc tangent), with a correction of the next order for the changing pace of the phase.
    #[must_use]
    pub fn between_with<M: Math>(&self, low_nm: f32, high_nm: f32, cos_theta: f32) -> [PowerShares; 2] {
        let width = high_nm - low_nm;
        let (Some(low), Some(middle), Some(high)) = (
            self.tilted(low_nm, cos_theta),
            self.tilted(0.5 * (low_nm + high_nm), cos_theta),
            self.tilted(high_nm, cos_theta),
        ) else {
            return [PowerShares::NAN; 2];
        };
        let mut panels = 1;
        if let Some([s, p]) = middle.faces()
            && cos_theta > 0.0
            && !(low.fades || middle.fades || high.fades)
        {
            if self.is_plate(&low, low_nm) {
                return [s.incoherent(), p.incoherent()];
            }
            let (from, to) = (self.turns(&low, low_nm), self.turns(&high, high_nm));
            // Half of the range that the phase runs through, in radians.
            let reach = core::f32::consts::PI * from.minus(to).high.abs();
            // d(n cos) / d lambda: an index that varies with the wavelength changes the spacing of the
            // fringes.
            let drift = (high.film.high - low.film.high) / width;
            let slope = |turns: Double, nm: f32| (turns.high - 2.0 * self.thickness_nm * drift) / nm;
            let (steep, flat) = (slope(from, low_nm), slope(to, high_nm));
            if reach > FEW_FRINGES && steep > 0.0 && flat > 0.0 {
                let edges = [
                    Edge { nm: low_nm, turns: from, slope: steep },
                    Edge { nm: high_nm, turns: to, slope: flat },
                ];
                return [s.averaged::<M>(&edges, width), p.averaged::<M>(&edges, width)];
            }
            let sharpest = 1.0_f32.min(s.round_trip()[1]).min(p.round_trip()[1]);
            panels += ((4.0 * reach / sharpest) as u32).min(255);
        }
        PowerShares::averaged(low_nm, high_nm, panels, |nm| self.at_with::<M>(nm, cos_theta))
    }

    /// Returns the phase by which a beam that went once to and fro in the film lags behind the beam before
    /// it.
    ///
    /// It is the fraction of 2 n d cos(theta1) / lambda, in turns, -1/2..=1/2, or NaN where no light travels
    /// in the film. The arguments are those of [`at`](Self::at).
    ///
    /// # Accuracy
    /// 5e-8 turns, for a film of 10 cm as for one of 100 nm. Beside the critical angle (n0 / (n1 cos
    /// theta1))^2 is large, and this ratio times 4.5e-15 of the turns adds to the error.
    #[must_use]
    pub fn phase_turns(&self, nm: f32, cos_theta: f32) -> f32 {
        match self.tilted(nm, cos_theta) {
            Some(tilted) if !tilted.fades => self.turns(&tilted, nm).fraction(),
            _ => f32::NAN,
        }
    }

    fn tilted(&self, nm: f32, cos_theta: f32) -> Option<Tilted> {
        let n = self.indices.at(nm);
        let is_film = n.iter().all(|n| (1e-3..=1e3).contains(n))
            && self.thickness_nm >= 0.0
            && (0.0..=1e9).contains(&nm);
        (is_film && !cos_theta.is_nan()).then(|| Tilted::new(n, held(cos_theta)))
    }

    /// Whether the film is so thick that no fringe can be told from the next, or that the phase would
    /// overflow.
    fn is_plate(&self, tilted: &Tilted, nm: f32) -> bool {
        !tilted.fades && 2.0 * self.thickness_nm * (tilted.film.high / nm) > MANY_TURNS
    }

    /// The phase of a round trip, in turns.
    fn turns(&self, tilted: &Tilted, nm: f32) -> Double {
        tilted.film.times(Double::new(2.0 * self.thickness_nm)).over(nm)
    }
}

/// A film whose reflectance is computed in the bins of one grid, which makes it a [`Reflector`].
///
/// It is made by [`ThinFilm::on_grid`]; see the [example](ThinFilm::on_grid) there.
///
/// # Cost
/// Every call costs as much as [`ThinFilm::reflectance`]: use it for few directions, or to fill a table over
/// the angle.
#[cfg(feature = "libm")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FilmOnGrid<const N: usize, G = Bins<380, 730>, I = [f32; 3]> {
    film: ThinFilm<I>,
    grid: PhantomData<G>,
}

#[cfg(feature = "libm")]
impl<const N: usize, G: Grid, I: FilmIndices> Reflector for FilmOnGrid<N, G, I> {
    type Value = Spectrum<Factor, N, G>;

    fn reflectance(&self, cos_i: f32) -> Self::Value {
        self.film.reflectance(cos_i)
    }
}

/// The cosine of incidence clamped to 0..=1, and 0 where its square would be lost.
pub(super) fn held(cos_theta: f32) -> f32 {
    let cos = cos_theta.clamp(0.0, 1.0);
    if cos < 1e-8 { 0.0 } else { cos }
}

/// Half the range of the phase, in radians, beyond which the mean over a bin is computed from its two ends.
const FEW_FRINGES: f32 = 4.0;
