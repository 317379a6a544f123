//! The input of an illumination model: a point of a surface, and the ray that meets it.

use crate::color::Rgb;
use crate::material::Material;
use crate::needs::Needs;
use crate::scalar::vector::{UnitVec3, Vec3};
use crate::scalar::{Scalar, Unit};

/// A point of a surface that a ray meets.
#[derive(Clone, Copy, Debug)]
pub struct Surface<'a, S: Scalar> {
    /// The place of the point.
    pub point: Vec3<S>,
    /// Unit normal on the side from which the ray comes.
    pub normal: UnitVec3<S>,
    /// Unit direction of the ray that meets the surface; the view direction is its negative.
    pub incoming: UnitVec3<S>,
    /// Length of the ray up to the point; for a ray from [`Surface::inside`], its way through the material.
    pub distance: S,
    /// Whether the ray meets the surface from the inside.
    pub inside: bool,
    /// Size of the object, from which [`clearance`](crate::scalar::vector::LengthVector::clearance) is computed.
    pub extent: S,
    /// Reflectance of the surface, for each register.
    pub color: Rgb<S::Unit>,
    /// What the surface does with light.
    pub material: &'a Material<S>,
}

impl<S: Scalar> Surface<'_, S> {
    /// Returns the diffuse reflectance: the colour, times the diffuse coefficient of its finish where it has one.
    pub fn diffuse<N: Needs>(&self) -> Rgb<S::Unit> {
        match self.material.finish::<N>() {
            Some(finish) => self.color.map(|c| c.times(finish.kd)),
            None => self.color,
        }
    }
}
