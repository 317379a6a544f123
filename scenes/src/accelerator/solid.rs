//! The finite objects of a scene as builders of hierarchies see them.

use rta_core::scene::Object;

use super::bounds::Bounds;
use crate::description::{Cone, Description};
use crate::space::{difference, dot, length};

/// A finite object.
#[derive(Clone, Copy, Debug)]
pub struct Solid {
    /// A box about it.
    pub bounds: Bounds,
    /// What a ray that is tested against it costs, in spheres.
    pub cost: f32,
    /// Which it is.
    pub object: Object,
}

impl Solid {
    /// Returns a sphere, or what costs as much.
    #[must_use]
    pub fn sphere(position: [f64; 3], radius: f64, object: Object) -> Self {
        Self { bounds: Bounds::about(position, [radius; 3]), cost: 1.0, object }
    }

    /// Returns the middle of its box.
    #[must_use]
    pub fn center(&self) -> [f64; 3] {
        self.bounds.center()
    }
}

/// Returns all finite objects of a scene, list by list.
#[must_use]
pub fn solids(scene: &Description) -> Vec<Solid> {
    let spheres =
        (0..).zip(&scene.spheres).map(|(i, s)| Solid::sphere(s.position, s.radius, Object::Sphere(i)));
    let ellipsoids = (0..).zip(&scene.ellipsoids).map(|(i, e)| Solid {
        bounds: Bounds::about(e.position, e.radii),
        cost: 3.0,
        object: Object::Ellipsoid(i),
    });
    let cones = (0..).zip(&scene.cones).map(|(i, c)| {
        // A disc reaches as far along an axis as that is across the disc's own.
        let axis = axis(c);
        let disc = |radius: f64| axis.map(|along| radius * (1.0 - along * along).max(0.0).sqrt());
        let (base, apex) =
            (Bounds::about(c.base, disc(c.base_radius)), Bounds::about(c.apex, disc(c.apex_radius)));
        Solid { bounds: base.with(&apex), cost: 3.0, object: Object::Cone(i) }
    });
    let triangles = (0..).zip(&scene.triangles).map(|(i, t)| {
        let corner = |bounds: Bounds, v: &[f64; 3]| bounds.with(&Bounds::about(*v, [0.0; 3]));
        let bounds = t.vertices.iter().fold(Bounds::NONE, corner);
        Solid { bounds, cost: 1.5, object: Object::Triangle(i) }
    });
    let all = spheres.chain(ellipsoids).chain(cones).chain(triangles);
    if !scene.has_motion() {
        return all.collect();
    }
    // About all of its way.
    let swept = |solid: Solid| match scene.swept(solid.object) {
        Some([from, to]) => {
            let bounds = solid.bounds.moved(from).with(&solid.bounds.moved(to));
            Solid { bounds, ..solid }
        }
        None => solid,
    };
    all.map(swept).collect()
}

fn axis(cone: &Cone) -> [f64; 3] {
    let way = difference(cone.apex, cone.base);
    let height = length(way);
    way.map(|along| along / height)
}

/// Returns how far the farthest point of a finite object is from a place; 0 of what is not there.
#[must_use]
pub fn reach(scene: &Description, object: Object, from: [f64; 3]) -> f64 {
    let index = |i: u32| i as usize;
    let away = |place: [f64; 3]| length(difference(place, from));
    let found = match object {
        Object::Sphere(i) => scene.spheres.get(index(i)).map(|s| away(s.position) + s.radius),
        Object::Ellipsoid(i) => scene.ellipsoids.get(index(i)).map(|e| {
            let largest = e.radii.iter().fold(0.0f64, |most, &radius| most.max(radius));
            away(e.position) + largest
        }),
        Object::Cone(i) => scene.cones.get(index(i)).map(|c| {
            let axis = axis(c);
            // On the edge of a disc, on the side that is turned away.
            let disc = |center: [f64; 3], radius: f64| {
                let along = dot(difference(center, from), axis);
                let across = (away(center) * away(center) - along * along).max(0.0).sqrt();
                along.hypot(across + radius)
            };
            disc(c.base, c.base_radius).max(disc(c.apex, c.apex_radius))
        }),
        Object::Triangle(i) => {
            let triangle = scene.triangles.get(index(i));
            triangle.map(|t| t.vertices.iter().map(|v| away(*v)).fold(0.0, f64::max))
        }
        _ => None,
    };
    let moved = scene.swept(object).map_or(0.0, |ends| ends.map(length).into_iter().fold(0.0, f64::max));
    found.unwrap_or(0.0) + moved
}
