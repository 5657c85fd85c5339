//! The price of a path in effects, multiplications and bytes, known while compiling.

/// A set of optical effects that a factor per bin cannot express: fluorescence, phosphorescence,
/// polarization.
///
/// [`Scene::effects`](crate::path::Scene::effects) and [`Price::effects`] return such a set; it prints as a
/// list of names.
///
/// # Example
/// ```
/// use nanospectra::path::Effects;
/// let effects = Effects::FLUORESCENCE.and(Effects::POLARIZATION);
/// assert!(effects.contains(Effects::POLARIZATION) && !effects.contains(Effects::PHOSPHORESCENCE));
/// assert!(effects.names().eq(["fluorescence", "polarization"]));
/// assert_eq!(effects.to_string(), "fluorescence + polarization");
/// assert!(Effects::NONE.is_empty());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Effects(u8);

impl Effects {
    /// The empty set, which describes matter that multiplies the light of each bin by a factor and leaves it
    /// unpolarized.
    pub const NONE: Effects = Effects(0);
    /// Light is absorbed at one wavelength and emitted at another.
    pub const FLUORESCENCE: Effects = Effects(1);
    /// Light is emitted noticeably later than it was absorbed, as by a phosphor.
    pub const PHOSPHORESCENCE: Effects = Effects(2);
    /// Light oscillates more in one direction than in another, so that a path follows it as Stokes vectors.
    pub const POLARIZATION: Effects = Effects(4);

    const NAMES: [(Effects, &str); 3] = [
        (Effects::FLUORESCENCE, "fluorescence"),
        (Effects::PHOSPHORESCENCE, "phosphorescence"),
        (Effects::POLARIZATION, "polarization"),
    ];

    /// Returns the effects that are in this set, in `other`, or in both. See the [example](#example).
    #[must_use]
    pub const fn and(self, other: Effects) -> Effects {
        Effects(self.0 | other.0)
    }

    /// Returns whether all effects of `other` are in this set. See the [example](#example).
    #[must_use]
    pub const fn contains(self, other: Effects) -> bool {
        self.0 & other.0 == other.0
    }

    /// Returns whether there is no effect in the set. See the [example](#example).
    #[must_use]
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Returns the names of the effects in the set: `fluorescence`, `phosphorescence`, `polarization`.
    ///
    /// See the [example](#example).
    pub fn names(self) -> impl Iterator<Item = &'static str> {
        Self::NAMES.iter().filter(move |(effect, _)| self.contains(*effect)).map(|(_, name)| *name)
    }
}

impl core::fmt::Display for Effects {
    /// Writes the names with a plus between them, as `fluorescence + polarization`, or `no effect`.
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        if self.is_empty() {
            return f.pad("no effect");
        }
        self.names()
            .enumerate()
            .try_for_each(|(k, name)| write!(f, "{}{name}", if k == 0 { "" } else { " + " }))
    }
}

/// The price of a path or of one of its stages: how many multiplications and bytes it takes, and which
/// optical effects it computes.
///
/// It is known while compiling ([`Priced::PRICE`]). For a path at hand call its `price()`, as
/// [`Plain::price`](crate::path::Plain::price); for a scene that is put together at run time,
/// [`Scene::price`](crate::path::Scene::price).
///
/// # Example
/// ```
/// use nanospectra::path::{Effects, Price};
/// // Light of 31 bins through a filter: the bytes of both, one multiplication for each bin.
/// let filtered = Price::light(31).plus(Price::factor(31));
/// assert_eq!(filtered.to_string(), "no effect, 31 multiply-adds, 248 bytes");
///
/// let effects = Effects::FLUORESCENCE.and(Effects::POLARIZATION);
/// assert!(effects.names().eq(["fluorescence", "polarization"]));
/// let price = Price { effects, multiply_adds: 486, bytes: 1296 };
/// assert_eq!(price.to_string(), "fluorescence + polarization, 486 multiply-adds, 1296 bytes");
/// assert_eq!(Price::factor(31).to_string(), "no effect, 31 multiply-adds, 124 bytes");
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Price {
    /// The optical effects that it computes, as a set of their names.
    pub effects: Effects,
    /// How many multiplications, most of them with an addition, it takes at most to compute all bins once.
    ///
    /// The compiler leaves out what does not reach the observer. An observer of `C` channels adds `C * N`
    /// of its own.
    pub multiply_adds: usize,
    /// How many bytes the numbers take that its stages hold, in flash or in RAM.
    pub bytes: usize,
}

impl core::fmt::Display for Price {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "{}, {} multiply-adds, {} bytes", self.effects, self.multiply_adds, self.bytes)
    }
}

impl Price {
    /// The price of a path that does nothing and holds nothing: no effects, no multiplications, no bytes.
    pub const NONE: Price = Price { effects: Effects::NONE, multiply_adds: 0, bytes: 0 };

    /// Returns the price of a light of `bands` numbers, which takes bytes and no multiplications.
    ///
    /// See the [example](#example).
    #[must_use]
    pub const fn light(bands: usize) -> Price {
        Price { bytes: 4 * bands, ..Price::NONE }
    }

    /// Returns the price of a filter or surface of `bands` factors: one multiplication for each, and its
    /// bytes.
    ///
    /// See the [example](#example).
    #[must_use]
    pub const fn factor(bands: usize) -> Price {
        Price { multiply_adds: bands, bytes: 4 * bands, ..Price::NONE }
    }

    /// Returns the price of this stage followed by another: the sum of both.
    ///
    /// See the [example](#example).
    #[must_use]
    pub const fn plus(self, other: Price) -> Price {
        Price {
            effects: self.effects.and(other.effects),
            multiply_adds: self.multiply_adds + other.multiply_adds,
            bytes: self.bytes + other.bytes,
        }
    }

    /// Returns this price with `more` multiplications added.
    #[must_use]
    pub const fn and_multiply_adds(self, more: usize) -> Price {
        Price { multiply_adds: self.multiply_adds + more, ..self }
    }
}

/// Types of light on its way and of matter whose [`Price`] is known while compiling.
///
/// The paths of this crate implement it, and so do its fluorescent matter and its Mueller matrices; a
/// spectrum has the price of a light. Implement it for an effect of your own, and a path that holds it in
/// [`Own`](crate::path::Own) has a price too.
///
/// # Example
/// A budget of multiplications that the compiler checks:
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
    /// The price that is paid to compute all bins once. See the [example](Priced#example).
    const PRICE: Price;
    /// How many multiplications of [`PRICE`](Self::PRICE) are repeated if the bins are read a second time.
    ///
    /// Light that makes matter fluoresce is read twice: once to find out how much the matter absorbs, and
    /// once to add what it emits.
    const AGAIN: usize = Self::PRICE.multiply_adds;
}

impl<T: Priced> Priced for &T {
    const PRICE: Price = T::PRICE;
    const AGAIN: usize = T::AGAIN;
}

/// Returns the price of a path or a stage of which there is a value, without naming its type.
///
/// ```
/// use nanospectra::Light;
/// use nanospectra::path::{Price, price_of};
/// assert_eq!(price_of(&Light::<31>::flat(1.0)), Price::light(31));
/// ```
#[must_use]
pub const fn price_of<T: Priced>(_: &T) -> Price {
    T::PRICE
}
