//! What covers a material: its pattern of colours, its bumps, the light that it sends out, and how its mirror rays and its corners are
//! treated.
//!
//! A [`Coat`] belongs to the number of a material, as a model's own rows do, so objects hold nothing more. It acts on the surface that a ray
//! has met, before any illumination model is asked, and so composes with all of them. A program whose [`Needs`] have no
//! [`COATS`](Needs::COATS) contains nothing of it.
//!
//! Patterns are integer arithmetic on places in 65536ths of a unit, so that all number formats draw the same where their places agree.

mod bump;
mod chart;
mod image;
mod mesh;
pub mod noise;
mod octahedral;

pub use bump::{Bump, STEEP, tilt};
pub use chart::{Chart, NO_COORDINATES, ball};
pub use image::{Axis, Image};
pub use mesh::{Mesh, Shading, bishop_weimer, gouraud, mixed_normal, on_screen};
pub use octahedral::fold;

use crate::color::Rgb;
use crate::needs::Needs;
use crate::scalar::vector::UnitVec3;
use crate::scalar::{Scalar, Unit};

/// What covers a material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coat<S: Scalar> {
    /// The pattern that takes the place of the object's colour.
    pub texture: Option<Texture<S>>,
    /// The pattern that tilts the normals.
    pub bump: Option<Bump<S>>,
    /// Whether mirror rays see the sky alone, and no things (Blinn and Newell 1976).
    pub surroundings: bool,
    /// The radiance that the outside of the surface sends out by itself.
    pub emission: Rgb<S::Light>,
    /// How triangles with normals are shaded.
    pub shading: Shading,
    /// The unit direction of view, where rays from the eye mix normals or light of vertices on the screen, as a scan line does; without it they
    /// are mixed in space.
    pub view: Option<UnitVec3<S>>,
}

impl<S: Scalar> Coat<S> {
    /// Nothing.
    pub const PLAIN: Self = Self {
        texture: None,
        bump: None,
        surroundings: false,
        emission: Rgb::BLACK,
        shading: Shading::Normals,
        view: None,
    };
}

/// A pattern at its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Texture<S: Scalar> {
    /// What it looks like.
    pub pattern: Pattern,
    /// The two colours that it mixes; an image has its own.
    pub colors: [Rgb<S::Unit>; 2],
    /// Units of the texture in one of the scene, in 2^-24.
    pub frequency: u32,
    /// The texture's coordinates of the scene's origin, negated, in 65536ths.
    pub origin: [i32; 3],
}

/// What a texture looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pattern {
    /// Cubes of two colours in turn.
    Checker,
    /// Waves along x that turbulence bends (Perlin 1985).
    Marble {
        /// Octaves of the turbulence, 1 to 16.
        octaves: u8,
        /// How far it bends the waves, in 65536ths.
        amount: i32,
    },
    /// Rings about the z axis that noise bends (Peachey 1985).
    Wood {
        /// How far it bends the rings, in 65536ths.
        amount: i32,
    },
    /// A picture (Catmull 1975).
    Image(Image),
}

impl<S: Scalar> Texture<S> {
    /// Returns a place in the texture's coordinates, in 65536ths.
    pub fn place(&self, [x, y, z]: [S; 3]) -> [i32; 3] {
        let [a, b, c] = self.origin;
        [(x, a), (y, b), (z, c)].map(|(part, origin)| part.lattice(self.frequency).wrapping_sub(origin))
    }

    /// Returns how a solid pattern mixes its colours at a place in its coordinates: 0 for the first, 65535 for the second. An image, which is
    /// not solid, gives 0.
    pub fn mix<N: Needs>(&self, place: [i32; 3]) -> u16 {
        match self.pattern {
            Pattern::Checker if N::CHECKER => noise::checker(place),
            Pattern::Marble { octaves, amount } if N::MARBLE => noise::marble(octaves, amount, place),
            Pattern::Wood { amount } if N::WOOD => noise::wood(amount, place),
            _ => 0,
        }
    }

    /// Returns colours of which each register is the largest or smallest that the texture has.
    pub(crate) fn extremes(&self) -> [Rgb<S::Unit>; 2] {
        match self.pattern {
            Pattern::Image(_) => [S::Unit::ONE; 2].map(|one| Rgb::new(one, one, one)),
            _ => self.colors,
        }
    }

    /// Returns the colour that a pattern mixes.
    pub(crate) fn mixed(&self, mix: u16) -> Rgb<S::Unit> {
        let [first, second] = self.colors;
        let part = S::Unit::of_level(i32::from(mix));
        first.zip(second, |a, b| a + (b - a).times(part))
    }
}
