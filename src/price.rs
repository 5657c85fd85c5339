//! What a path costs, known while compiling.

/// A set of optical effects that a factor per bin cannot express: fluorescence, phosphorescence,
/// polarization.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Effects(u8);

impl Effects {
    /// No effect: the light of each bin is multiplied by a factor, and stays unpolarized.
    pub const NONE: Effects = Effects(0);
    /// Light absorbed at one wavelength and emitted at another.
    pub const FLUORESCENCE: Effects = Effects(1);
    /// Light emitted later than it was absorbed.
    pub const PHOSPHORESCENCE: Effects = Effects(2);
    /// Light that oscillates more in one direction than in another, followed as Stokes vectors.
    pub const POLARIZATION: Effects = Effects(4);

    const NAMES: [(Effects, &str); 3] = [
        (Effects::FLUORESCENCE, "fluorescence"),
        (Effects::PHOSPHORESCENCE, "phosphorescence"),
        (Effects::POLARIZATION, "polarization"),
    ];

    /// The effects that are in this set or in `other`.
    #[must_use]
    pub const fn and(self, other: Effects) -> Effects {
        Effects(self.0 | other.0)
    }

    /// Whether all effects of `other` are in this set.
    #[must_use]
    pub const fn contains(self, other: Effects) -> bool {
        self.0 & other.0 == other.0
    }

    /// Whether the set is empty.
    #[must_use]
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The names of the effects in the set: `fluorescence`, `phosphorescence`, `polarization`.
    pub fn names(self) -> impl Iterator<Item = &'static str> {
        Self::NAMES.iter().filter(move |(effect, _)| self.contains(*effect)).map(|(_, name)| *name)
    }
}

impl core::fmt::Display for Effects {
    /// `fluorescence + polarization`; `no effect` of none.
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        if self.is_empty() {
            return f.pad("no effect");
        }
        self.names()
            .enumerate()
            .try_for_each(|(k, name)| write!(f, "{}{name}", if k == 0 { "" } else { " + " }))
    }
}

/// What a path or one of its stages costs.
///
/// ```
/// # use nanospectra::path::{Effects, Price};
/// let effects = Effects::FLUORESCENCE.and(Effects::POLARIZATION);
/// assert!(effects.names().eq(["fluorescence", "polarization"]));
/// let price = Price { effects, multiply_adds: 486, bytes: 1296 };
/// assert_eq!(price.to_string(), "fluorescence + polarization, 486 multiply-adds, 1296 bytes");
/// assert_eq!(Price::factor(31).to_string(), "no effect, 31 multiply-adds, 124 bytes");
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Price {
    /// The effects that it computes.
    pub effects: Effects,
    /// Multiplications (most with an addition) for evaluating all bins once, at most: the compiler leaves out
    /// what does not reach the eye. An observer of `C` channels adds `C * N` of its own.
    pub multiply_adds: usize,
    /// Bytes of the numbers that its stages hold, in flash or in RAM.
    pub bytes: usize,
}

impl core::fmt::Display for Price {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "{}, {} multiply-adds, {} bytes", self.effects, self.multiply_adds, self.bytes)
    }
}

impl Price {
    /// The price of nothing: no effects, no multiplications, no bytes.
    pub const NONE: Price = Price { effects: Effects::NONE, multiply_adds: 0, bytes: 0 };

    /// The price of a light of `bands` numbers: its bytes.
    #[must_use]
    pub const fn light(bands: usize) -> Price {
        Price { bytes: 4 * bands, ..Price::NONE }
    }

    /// The price of a filter or surface of `bands` factors: one multiplication for each, and its bytes.
    #[must_use]
    pub const fn factor(bands: usize) -> Price {
        Price { multiply_adds: bands, bytes: 4 * bands, ..Price::NONE }
    }

    /// The price of both, one after the other.
    #[must_use]
    pub const fn plus(self, other: Price) -> Price {
        Price {
            effects: self.effects.and(other.effects),
            multiply_adds: self.multiply_adds + other.multiply_adds,
            bytes: self.bytes + other.bytes,
        }
    }

    /// This price with `more` multiplications added.
    #[must_use]
    pub const fn and_multiply_adds(self, more: usize) -> Price {
        Price { multiply_adds: self.multiply_adds + more, ..self }
    }
}

/// Light on its way, or matter, whose price is known while compiling. A spectrum has the price of a light.
///
/// ```
/// use nanospectra::path::{Plain, Priced, Times};
/// use nanospectra::{Light, Power, Reflectance};
///
/// type Scene<'a> = Plain<Power, Times<Times<&'a Light<31>, &'a Reflectance<31>>, &'a Reflectance<31>>>;
/// const _: () = assert!(Scene::PRICE.multiply_adds <= 70 && Scene::PRICE.effects.is_empty());
///
/// let (sun, glass, paper) = (Light::flat(1.0), Reflectance::flat(0.5), Reflectance::flat(0.8));
/// let scene: Scene = sun.through(&glass).onto(&paper);
/// assert_eq!((scene.price().multiply_adds, scene.price().bytes), (2 * 31, 3 * 31 * 4));
/// ```
pub trait Priced {
    /// The price of working out all numbers once.
    const PRICE: Price;
    /// The multiplications of [`PRICE`](Self::PRICE) that a second reading of the numbers would take again.
    /// Light that makes matter fluoresce is read twice.
    const AGAIN: usize = Self::PRICE.multiply_adds;
}

impl<T: Priced> Priced for &T {
    const PRICE: Price = T::PRICE;
    const AGAIN: usize = T::AGAIN;
}

/// The price of a path or a stage, from a value of it.
#[must_use]
pub const fn price_of<T: Priced>(_: &T) -> Price {
    T::PRICE
}
