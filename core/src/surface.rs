//! The input of an illumination model: a point of a surface, and the ray that meets it.

use crate::color::Rgb;
use crate::light::Incident;
use crate::material::Material;
use crate::needs::Needs;
use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector, Vec3};
use crate::scalar::{Scalar, Unit};
use crate::texture::Mesh;

/// A point of a surface that a ray meets.
#[derive(Clone, Copy, Debug)]
pub struct Surface<'a, S: Scalar> {
    /// The place of the point.
    pub point: Vec3<S>,
    /// Unit normal on the side from which the ray comes.
    pub normal: UnitVec3<S>,
    /// Where `normal` is interpolated, the unit normal of the flat face itself, on the side from which the ray comes. It tells
    /// what is behind the surface, so that a ray that is reflected at the interpolated normal does not end in the face.
    pub face: Option<UnitVec3<S>>,
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
    /// Whether mirror rays see the sky alone, and no things.
    pub surroundings: bool,
    /// A triangle that is not shaded by its mixed normals alone.
    pub mesh: Option<Mesh<'a, S>>,
    /// The number of the material in the scene's list, from 0, by which a model finds its own parameters of it.
    pub number: u16,
}

impl<S: Scalar> Surface<'_, S> {
    /// Returns where the ray begins.
    pub fn origin(&self) -> Vec3<S> {
        self.point.along(self.incoming, -self.distance)
    }

    /// Returns the unit normal of the flat face, where [`Surface::normal`] is interpolated.
    fn flat<N: Needs>(&self) -> Option<UnitVec3<S>> {
        if N::NORMALS { self.face } else { None }
    }

    /// Returns the unit normal of the surface itself, which is not interpolated.
    pub fn side<N: Needs>(&self) -> UnitVec3<S> {
        self.flat::<N>().unwrap_or(self.normal)
    }

    /// Returns whether a lamp is behind the surface, or in its plane. Where light is mixed that vertices send back, their normals tell it for
    /// each of them, and here the flat face alone.
    pub fn is_behind<N: Needs>(&self, incident: &Incident<S>) -> bool {
        let zero = S::Unit::ZERO;
        let is_dark = incident.cosine <= zero && !(N::MESHES && self.mesh.is_some());
        is_dark || self.flat::<N>().is_some_and(|face| face.dot(incident.direction) <= zero)
    }

    /// Returns the unit direction of a secondary ray: `direction`, or, where it was made from an interpolated normal and leads
    /// to the wrong side of the face, its reflection on the face. `leaves` tells whether the ray is to leave on the side of the
    /// normal. Both agree where the direction lies in the face, so the picture has no seam.
    pub fn fold<N: Needs>(&self, direction: UnitVec3<S>, leaves: bool) -> UnitVec3<S> {
        let Some(face) = self.flat::<N>() else { return direction };
        let cosine = face.dot(direction);
        let is_right = if leaves { cosine >= S::Unit::ZERO } else { cosine <= S::Unit::ZERO };
        if is_right { direction } else { direction.reflect(face) }
    }

    /// Returns the diffuse reflectance: the colour, times the diffuse coefficient of its finish where it has one.
    pub fn diffuse<N: Needs>(&self) -> Rgb<S::Unit> {
        match self.material.finish::<N>() {
            Some(finish) => self.color.map(|c| c.times(finish.kd)),
            None => self.color,
        }
    }
}
