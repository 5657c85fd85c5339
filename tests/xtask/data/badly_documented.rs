//! This crate is badly documented, so that a test sees its faults found.

/// A lamp emits light when it is on.
///
/// # Colors
/// They are warm.
pub struct Lamp {
    pub watts: f32,
}

#[doc(hidden)]
pub fn hidden() {}

impl Lamp {
    /// Makes a lamp.
    pub fn new() -> Self {
        Lamp { watts: 1.0 }
    }

    /// Returns a lamp that is on.
    ///
    /// # Example
    /// ```
    /// assert_eq!(badly_documented::Lamp::on().watts, 1.0);
    /// ```
    pub fn on() -> Self {
        Lamp { watts: 1.0 }
    }

    /// Returns a lamp that emits nothing; see the [example](#colors).
    pub fn off() -> Self {
        Lamp { watts: 0.0 }
    }

    /// Returns a lamp that emits little light, as the [example of another](shades) shows.
    pub fn dim() -> Self {
        Lamp { watts: 0.5 }
    }

    /// Returns a lamp that emits more; see the [example](#method.on) or [that example](Lamp::on).
    pub fn bright() -> Self {
        Lamp { watts: 2.0 }
    }

    /// The lamp as a short text, which nobody `reads`.
    pub fn text() -> &'static str {
        "lamp"
    }

    /// * A list, which is no sentence.
    pub const COLD: f32 = 6500.0;
}

/// What a lamp is covered with.
pub mod shades {
    fn private() {}
}

/// Is a trait of what gives light.
///
/// # Example
/// ```
/// use badly_documented::{Glows, Lamp};
/// assert_eq!(Lamp::on().power(), 1.0);
/// ```
pub trait Glows {
    /// Returns the light that this gives; see the [example](#example).
    fn light(&self) -> f32;

    /// Returns the power that this takes; see the [example](Glows#example).
    fn power(&self) -> f32 {
        1.0
    }
}

impl Glows for Lamp {
    fn light(&self) -> f32 {
        self.watts
    }
}
