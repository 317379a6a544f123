//! What an illumination model is asked about: a point of a surface, and the ray that met it.

use crate::color::Rgb;
use crate::material::Material;
use crate::needs::Needs;
use crate::scalar::vector::{UnitVec3, Vec3};
use crate::scalar::{Scalar, Unit};

/// The point of a surface that a ray has met.
#[derive(Clone, Copy, Debug)]
pub struct Surface<'a, S: Scalar> {
    /// The place.
    pub point: Vec3<S>,
    /// Unit normal, turned towards the ray's origin. The other side's is its negative.
    pub normal: UnitVec3<S>,
    /// Unit direction of the ray that came here: the view direction is its negative.
    pub incoming: UnitVec3<S>,
    /// How far the ray came; where it came from [`Surface::inside`], that is its way through the material.
    pub distance: S,
    /// Whether the ray hit the surface from the inside.
    pub inside: bool,
    /// The size that [`clearance`](crate::scalar::vector::LengthVector::clearance) is told of the object.
    pub extent: S,
    /// Reflectance.
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
