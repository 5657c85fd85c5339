//! What the parts of a scene cost.

use crate::matter::Mueller;
use crate::path::scene::{Part, Scene};
use crate::path::{Effects, Price, Priced};

/// One line of a [bill](Scene::bill): what one part of the scene costs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BillLine {
    /// The number of the part, counted from 0.
    pub part: usize,
    /// What it is: `"filter"`, `"dye"`, ..
    pub name: &'static str,
    /// Its effect is left out: what remains is a plain factor.
    pub left_out: bool,
    /// Its effects, and what it takes to work it out once.
    pub price: Price,
}

impl<const N: usize, const CAP: usize, G> Scene<'_, N, CAP, G> {
    /// What each part costs when light is walked through: its effects, multiply-adds, bytes.
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
    /// // Four numbers for each bin from the polarizer on.
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

    /// What walking light through all parts costs. A lamp adds its bytes ([`Price::light`]), an observer of
    /// `C` channels `C * N` multiply-adds.
    #[must_use]
    pub fn price(&self) -> Price {
        self.bill().fold(Price::NONE, |sum, line| sum.plus(line.price))
    }

    /// What the scene costs once it is folded into an observer of `channels` channels: what that observer
    /// costs alone.
    #[must_use]
    pub const fn folded_price(&self, channels: usize) -> Price {
        Price { effects: Effects::NONE, multiply_adds: channels * N, bytes: 4 * channels * N }
    }
}
