//! Surfaces in the coats of their materials.

use super::World;
use crate::color::Rgb;
use crate::needs::Needs;
use crate::ray::RayKind;
use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector, Vec3, Vector};
use crate::scalar::{Scalar, Unit};
use crate::scene::{Object, index};
use crate::shape::Triangle;
use crate::surface::Surface;
use crate::texture::{
    Chart, Coat, Image, Mesh, NO_COORDINATES, Pattern, Shading, Texture, mixed_normal, tilt,
};

impl<'a, S: Scalar> World<'a, S> {
    /// Covers a surface of an object with the coat of its material, if it has one. `kind` is what the ray is traced for.
    #[inline(always)] // so that a scene without coats pays for one comparison
    pub fn cover<N: Needs>(&self, surface: &mut Surface<'a, S>, object: Object, kind: RayKind) {
        // Not by light alone.
        let is_covered =
            N::CHECKER | N::MARBLE | N::WOOD | N::IMAGES | N::BUMPS | N::SURROUNDINGS | N::MESHES;
        if N::COATS && is_covered && !self.scene.coats.is_empty() {
            // A copy, so that the surface need not be in memory in a scene without coats.
            let mut covered = *surface;
            self.put_on::<N>(&mut covered, object, kind);
            *surface = covered;
        }
    }

    /// Returns the light that a ray brings back with what the surface that it met, if any, sends out by itself.
    #[inline]
    pub fn shining<N: Needs>(&self, light: Rgb<S::Light>, met: Option<&Surface<S>>) -> Rgb<S::Light> {
        match met {
            Some(surface) if N::EMISSION && !self.scene.coats.is_empty() => {
                light.plus(self.emitted(surface.number, surface.inside))
            }
            _ => light,
        }
    }

    /// Returns the radiance that a surface sends out by itself, by the number of its material; none on its inside.
    #[inline(never)] // scenes without coats do not pay for it
    pub fn emitted(&self, material: u16, inside: bool) -> Rgb<S::Light> {
        match self.scene.coats.get(usize::from(material)) {
            Some(coat) if !inside => coat.emission,
            _ => Rgb::BLACK,
        }
    }

    /// Covers a surface of an object in a scene that has coats.
    #[inline(never)] // inlined, it keeps other code from being so: 6 % of the instructions of scenes without coats
    fn put_on<N: Needs>(&self, surface: &mut Surface<'a, S>, object: Object, kind: RayKind) {
        let Some(coat) = self.scene.coats.get(usize::from(surface.number)) else { return };
        if N::SURROUNDINGS {
            surface.surroundings = coat.surroundings;
        }
        if N::MESHES {
            self.shade(surface, coat, object, kind);
        }
        let (seen, point, pool) = (*surface, surface.point, self.scene.pool);
        let chart = |texture: &Texture<S>| match &texture.pattern {
            Pattern::Image(image) if N::IMAGES => {
                let chart = self.chart::<N>(&seen, object, image);
                let [right, down] = chart.place;
                let [right, down, _] = texture.place([right, down, S::ZERO]);
                Some((*image, chart, [right, down]))
            }
            _ => None,
        };
        let solid = |texture: &Texture<S>| texture.place([point.x(), point.y(), point.z()]);
        if let Some(texture) = &coat.texture {
            surface.color = match chart(texture) {
                Some((image, _, place)) => image.color::<S>(pool, place),
                None => texture.mixed(texture.mix::<N>(solid(texture))),
            };
        }
        if N::BUMPS
            && let Some(bump) = &coat.bump
        {
            let gradient = match chart(&bump.texture) {
                Some((image, chart, place)) => bump.along(chart.axes, image.slope(pool, place)),
                None => bump.gradient::<N>(solid(&bump.texture)),
            };
            bend(surface, gradient);
        }
    }

    /// Gives a surface of a triangle with normals the shading that its coat says.
    fn shade(&self, surface: &mut Surface<'a, S>, coat: &'a Coat<S>, object: Object, kind: RayKind) {
        let view = coat.view.as_ref().filter(|_| kind == RayKind::Primary);
        let Object::Triangle(number) = object else { return };
        let Some(triangle) = self.scene.triangles.get(index(number)) else { return };
        let Some(normals) = triangle.normals else { return };
        let mesh = Mesh { triangle, shading: coat.shading, view };
        if coat.shading != Shading::Normals {
            surface.mesh = Some(mesh);
        } else if view.is_some() {
            let mixed = mixed_normal::<S>(mesh.weights(surface.origin(), surface.point), normals);
            let mixed = mixed.map(|normal| if surface.inside { -normal } else { normal });
            let is_seen = |normal: &UnitVec3<S>| normal.dot(surface.incoming) < S::Unit::ZERO;
            surface.normal = mixed.filter(is_seen).or(surface.face).unwrap_or(surface.normal);
        }
    }

    /// Returns where a point of an object lies on an image that covers it.
    fn chart<N: Needs>(&self, surface: &Surface<S>, object: Object, image: &Image) -> Chart<S> {
        let outward = if surface.inside { -surface.normal } else { surface.normal };
        let (scene, point) = (&self.scene, surface.point);
        let found = match object {
            _ if image.plane.is_some() => None,
            Object::Sphere(_) if N::SPHERES => Some(Chart::on_ball(outward)),
            Object::Ellipsoid(i) if N::ELLIPSOIDS => scene.ellipsoids.get(index(i)).map(|ellipsoid| {
                let part = |radius: S| radius.fraction(ellipsoid.inverse_extent);
                let radii = ellipsoid.radii;
                let radii = UnitVec3::<S>::new(part(radii.x()), part(radii.y()), part(radii.z()));
                Chart::on_ball(outward.times(radii).normalize().map_or(outward, |(direction, _)| direction))
            }),
            Object::Cylinder(_) if N::CYLINDERS => Some(Chart::on_tube(UnitVec3::<S>::Z, outward, point.z())),
            Object::Cone(i) if N::CONES => scene
                .cones
                .get(index(i))
                .map(|cone| Chart::on_tube(cone.axis, outward, (point - cone.center).dot(cone.axis))),
            Object::Triangle(i) if N::TRIANGLES => self.on_triangle(i, image, point),
            _ => None,
        };
        found.unwrap_or_else(|| Chart::on_plane(image.plane, point, surface.side::<N>()))
    }

    /// Returns the place on a picture that the texture coordinates of a triangle's corners say; `None` where it has none.
    fn on_triangle(&self, number: u32, image: &Image, point: Vec3<S>) -> Option<Chart<S>> {
        let first = index(image.coordinates?).checked_add(index(number).checked_mul(6)?)?;
        let words: &[u32; 6] = self.scene.pool.get(first..)?.first_chunk()?;
        let [u0, v0, u1, v1, u2, v2] = words.map(u32::cast_signed);
        if u0 == NO_COORDINATES {
            return None;
        }
        let triangle = self.scene.triangles.get(index(number))?;
        let weights = triangle.weights(point);
        let mixed = |corners: [i32; 3]| {
            let parts = corners.into_iter().zip(weights);
            parts.fold(S::ZERO, |sum, (corner, weight)| sum + S::of_lattice(corner).scale(weight))
        };
        let axes = directions(triangle, [[u1 - u0, v1 - v0], [u2 - u0, v2 - v0]]);
        Some(Chart { place: [mixed([u0, u1, u2]), mixed([v0, v1, v2])], axes })
    }
}

/// Gives a surface the normal that bumps with the `gradient` give it, unless that is turned away from the ray.
fn bend<S: Scalar>(surface: &mut Surface<S>, gradient: Vec3<S>) {
    let outward = if surface.inside { -surface.normal } else { surface.normal };
    let tilted = tilt::<S>(outward, gradient);
    let tilted = if surface.inside { -tilted } else { tilted };
    if tilted.dot(surface.incoming) < S::Unit::ZERO {
        // Rays leave along the normal of the surface itself.
        surface.face = surface.face.or(Some(surface.normal));
        surface.normal = tilted;
    }
}

/// Returns the directions in which the texture coordinates of a triangle grow, from their differences along its two edges at the first corner.
fn directions<S: Scalar>(triangle: &Triangle<S>, [[u1, v1], [u2, v2]]: [[i32; 2]; 2]) -> [UnitVec3<S>; 2] {
    let [corner, second, third] = triangle.vertices;
    let edges = [second - corner, third - corner];
    let is_mirrored = i64::from(u1) * i64::from(v2) < i64::from(u2) * i64::from(v1);
    let along = |first: i32, other: i32, fallback: UnitVec3<S>| {
        // Halves, so that the sum has room.
        let whole = first.unsigned_abs().max(other.unsigned_abs()).saturating_mul(2);
        let [a, b] = [first, other].map(|part| S::Unit::fraction(part, whole));
        let [first, second] = edges;
        let sum = |part: fn(Vec3<S>) -> S| part(first).scale(a) + part(second).scale(b);
        let sum = Vec3::<S>::new(sum(Vector::x), sum(Vector::y), sum(Vector::z));
        let direction = sum.normalize().map_or(fallback, |(direction, ..)| direction);
        if is_mirrored { -direction } else { direction }
    };
    [along(v2, -v1, UnitVec3::<S>::X), along(-u2, u1, UnitVec3::<S>::Y)]
}
