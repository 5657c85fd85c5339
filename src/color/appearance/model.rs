//! The two appearance models, which differ in the responses that they compress, and the kinds of surround.

use crate::color::{Cat02, Cat16, ConeResponses};

/// A color appearance model of the family of CIECAM02, which is told by the responses that it compresses.
///
/// [`Ciecam02`] and [`Cam16`] implement it. Name one of them as the type parameter of
/// [`ViewingConditions`](crate::color::ViewingConditions), as in this
/// [example](crate::color::ViewingConditions#example).
pub trait AppearanceModel: Copy + 'static {
    /// The responses in which the model adapts to the white.
    type Cones: ConeResponses;
    /// The matrix from X, Y, Z to the responses that are compressed, or `None` if those are the responses in
    /// which the model adapts.
    const COMPRESSED: Option<[[f64; 3]; 3]>;
}

/// The model CIECAM02 (CIE 159:2004), whose uniform space is CAM02-UCS.
///
/// It adapts to the white in the responses of [`Cat02`] and compresses those of Hunt, Pointer and Estevez.
/// Because these are two kinds of responses, saturated blues have negative ones, and some real colors have no
/// appearance at all; [`Cam16`] was made to mend this. See the
/// [example](crate::color::ViewingConditions#example).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ciecam02;
/// The model CAM16 of Li et al. (2017), whose uniform space is CAM16-UCS.
///
/// It adapts to the white and compresses in the same responses, those of [`Cat16`]. CIE 248:2022 made it
/// CIECAM16, with a straight line for the smallest and the largest responses, which is not here. See the
/// [example](crate::color::ViewingConditions#example).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cam16;

impl AppearanceModel for Ciecam02 {
    type Cones = Cat02;
    const COMPRESSED: Option<[[f64; 3]; 3]> =
        Some([[0.38971, 0.68898, -0.07868], [-0.22981, 1.18340, 0.04641], [0.0, 0.0, 1.0]]);
}
impl AppearanceModel for Cam16 {
    type Cones = Cat16;
    const COMPRESSED: Option<[[f64; 3]; 3]> = None;
}

/// The surround of a scene, which says how bright the room around it is.
///
/// The darker it is, the lower the contrast that is seen. See the
/// [example](crate::color::ViewingConditions#example).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Surround {
    /// The room is about as bright as the scene, as for surface colors: F = 1, c = 0.69, Nc = 1.
    ///
    /// See the [example](crate::color::ViewingConditions#example).
    #[default]
    Average,
    /// The room is less bright than the scene, as with television: F = 0.9, c = 0.59, Nc = 0.9.
    Dim,
    /// The room is dark, as with a projector: F = 0.8, c = 0.525, Nc = 0.8.
    Dark,
}

impl Surround {
    /// Returns F, the largest degree of adaptation.
    pub(in crate::color) const fn degree(self) -> f32 {
        match self {
            Surround::Average => 1.0,
            Surround::Dim => 0.9,
            Surround::Dark => 0.8,
        }
    }

    /// Returns c, the impact of the surround on lightness.
    pub(in crate::color) const fn impact(self) -> f32 {
        match self {
            Surround::Average => 0.69,
            Surround::Dim => 0.59,
            Surround::Dark => 0.525,
        }
    }

    /// Returns Nc, the factor of chromatic induction.
    pub(in crate::color) const fn induction(self) -> f32 {
        match self {
            Surround::Average => 1.0,
            Surround::Dim => 0.9,
            Surround::Dark => 0.8,
        }
    }
}
