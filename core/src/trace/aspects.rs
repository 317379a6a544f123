//! What stands for a point of a mesh whose light is not that of its mixed normal.

use crate::color::Rgb;
use crate::illumination::{Illumination, Secondary, Weight};
use crate::light::{Incident, Lamp};
use crate::needs::{Apart, Needs};
use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector, Vec3};
use crate::scalar::{Scalar, Unit};
use crate::surface::Surface;
use crate::texture::{Mesh, Shading, bishop_weimer, gouraud};

/// The surfaces whose light a point of a mesh sends back.
// No function of it is inlined: scenes without meshes do not pay for it.
#[allow(clippy::large_enum_variant, reason = "it lives as long as one call")]
pub enum Aspects<'a, S: Scalar> {
    /// The vertices of its triangle, and their weights (Gouraud 1971).
    Vertices([Surface<'a, S>; 3], [S::Unit; 3]),
    /// The point as it is seen from the middle of its triangle (Bishop and Weimer 1986).
    Middle(Surface<'a, S>),
}

impl<'a, S: Scalar> Aspects<'a, S> {
    /// Returns what stands for a point of a mesh.
    #[inline(never)]
    pub fn of<N: Needs>(surface: &Surface<'a, S>, mesh: &Mesh<'a, S>) -> Self {
        let (origin, face) = (surface.origin(), surface.side::<N>());
        let weights = mesh.weights(origin, surface.point);
        let normals = mesh.triangle.normals.unwrap_or([mesh.triangle.normal; 3]);
        let normals = normals.map(|normal| if surface.inside { -normal } else { normal });
        let at = |point: Vec3<S>, normal: UnitVec3<S>| {
            let way = (point - origin).normalize();
            let (incoming, distance) =
                way.map_or((surface.incoming, S::ZERO), |(direction, length, _)| (direction, length));
            let normal = towards_eye::<S>(normal, incoming).unwrap_or(face);
            Surface { point, normal, incoming, distance, face: None, mesh: None, ..*surface }
        };
        if mesh.shading == Shading::Gouraud {
            let ([a, b, c], [first, second, third]) = (mesh.triangle.vertices, normals);
            return Self::Vertices([at(a, first), at(b, second), at(c, third)], weights);
        }
        Self::Middle(match bishop_weimer::<S>(weights, normals) {
            Some(normal) => at(mesh.triangle.middle(), normal),
            // The mixed normal as it is.
            None => Surface { face: None, mesh: None, ..*surface },
        })
    }

    /// Returns the radiance that they send back of the scene's ambient light.
    #[inline(never)]
    pub fn ambient<M: Illumination<S>, N: Needs>(&self, model: &M, ambient: Rgb<S::Light>) -> Rgb<S::Light> {
        self.mixed(|surface| model.ambient::<Apart<N>>(surface, ambient))
    }

    /// Returns the radiance that they send back of a lamp, without shadows, where it [is reached](Illumination::is_reached).
    #[inline(never)]
    pub fn direct<M: Illumination<S>, N: Needs>(&self, model: &M, lamp: &Lamp<S>) -> Rgb<S::Light> {
        self.mixed(|surface| {
            let incident = Incident::new(lamp, surface.point, surface.normal);
            let incident = incident.filter(|incident| model.is_reached::<N>(surface, incident));
            incident.map_or(Rgb::BLACK, |incident| model.direct::<Apart<N>>(surface, &incident))
        })
    }

    /// Returns the weights of the secondary rays of the point.
    #[inline(never)]
    pub fn secondary<M: Illumination<S>, N: Needs>(&self, model: &M) -> Secondary<M::Weight> {
        let (surfaces, weights) = match self {
            Self::Middle(surface) => return model.secondary::<Apart<N>>(surface),
            Self::Vertices(surfaces, weights) => (surfaces, weights),
        };
        let mut mixed = Secondary::NONE;
        for (surface, weight) in surfaces.iter().zip(weights) {
            let own = model.secondary::<Apart<N>>(surface);
            let add = |sum: Option<M::Weight>, own: Option<M::Weight>| match (
                sum,
                own.map(|own| own.dimmed(*weight)),
            ) {
                (Some(sum), Some(own)) => Some(sum.join(own)),
                (sum, own) => sum.or(own),
            };
            mixed = Secondary {
                reflected: add(mixed.reflected, own.reflected),
                transmitted: add(mixed.transmitted, own.transmitted),
                bend: own.bend,
            };
        }
        mixed
    }

    fn mixed(&self, light: impl Fn(&Surface<'a, S>) -> Rgb<S::Light>) -> Rgb<S::Light> {
        match self {
            Self::Vertices(surfaces, weights) => gouraud::<S>(*weights, surfaces.each_ref().map(light)),
            Self::Middle(surface) => light(surface),
        }
    }
}

/// Returns a normal, turned as little as need be to be on the side from which a ray comes; `None` where it is along the ray. The vertex of a
/// face that is seen may itself be turned away.
fn towards_eye<S: Scalar>(normal: UnitVec3<S>, incoming: UnitVec3<S>) -> Option<UnitVec3<S>> {
    let least = S::Unit::ratio(1, 1024); // so that no rounding turns it away
    let excess = normal.dot(incoming) + least;
    if excess <= S::Unit::ZERO {
        return Some(normal);
    }
    normal.plus(incoming, -excess).normalize().map(|(normal, _)| normal)
}
