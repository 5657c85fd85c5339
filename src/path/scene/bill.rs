//! Lists the price of each part of a scene.

use crate::matter::Mueller;
use crate::path::scene::{Part, Scene};
use crate::path::{Effects, Price, Priced};

/// One line of a [bill](Scene::bill), which says how much one part of the scene costs.
///
/// See the [example](Scene::bill) of a bill.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BillLine {
    /// The number of the part in the scene, counted from 0.
    pub part: usize,
    /// The name that says which kind of part it is, such as `"filter"` or `"dye"`.
    pub name: &'static str,
    /// Whether the effect of the part is left out, so that it is a plain factor for each bin.
    pub left_out: bool,
    /// The effects of the part, and what it takes to compute all bins behind it once.
    pub price: Price,
}

impl<const N: usize, const CAP: usize, G> Scene<'_, N, CAP, G> {
    /// Returns a line for each part, which says how much the part costs when light is followed through the
    /// scene.
    ///
    /// ```
    /// # use nanospectra::Reflectance;
    /// # use nanospectra::matter::Polarizer;
    /// # use nanospectra::path::{Part, Scene};
    /// let (sheet, glass) = (Polarizer::ideal(0.0), Reflectance::flat(0.9));
    /// let mut scene: Scene<31, 2> = Scene::new();
    /// scene.push(&sheet)?;
    /// scene.push(Part::Filter(&glass))?;
    /// for line in scene.bill() {
    ///     println!("{}: {}", line.name, line.price); // polarizer: polarization, 124 multiply-adds, ..
    /// }
    /// // Behind the polarizer there are four numbers for each bin.
    /// assert_eq!(scene.bill().last().map(|line| line.price.multiply_adds), Some(4 * 31));
    /// # Ok::<(), nanospectra::path::SceneFullError>(())
    /// ```
    pub fn bill(&self) -> impl Iterator<Item = BillLine> {
        let mut stokes = false;
        self.steps().enumerate().map(move |(part, step)| {
            let price = step.price();
            let turns = price.effects.contains(Effects::POLARIZATION);
            // A part that polarizes or passes polarization on has four numbers to work on behind one that
            // polarizes.
            let passes = matches!(step.part, Part::Filter(_)) || step.part.polarizes();
            let more = match stokes && passes {
                true if turns => Mueller::<N, G>::PRICE.multiply_adds - price.multiply_adds,
                true => 3 * N,
                false => 0,
            };
            stokes = (stokes && passes) || turns;
            let price = price.and_multiply_adds(more);
            BillLine { part, name: step.part.name(), left_out: step.left_out, price }
        })
    }

    /// Returns the price that is paid to follow light through all parts once.
    ///
    /// A lamp adds its bytes ([`Price::light`]), and an observer of `C` channels adds `C * N` multiply-adds.
    /// See the [example](#example).
    #[must_use]
    pub fn price(&self) -> Price {
        self.bill().fold(Price::NONE, |sum, line| sum.plus(line.price))
    }

    /// Returns the price of the scene once it is folded into an observer of `channels` channels, which is the
    /// price of that observer alone.
    #[must_use]
    pub const fn folded_price(&self, channels: usize) -> Price {
        Price { effects: Effects::NONE, multiply_adds: channels * N, bytes: 4 * channels * N }
    }
}
