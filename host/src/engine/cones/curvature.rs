//! How curved things are.

use rta_core::scene::{Object, Scene};
use rta_core::vector::Vec3;

/// Returns the radius of the sphere that is as curved as a thing is at a place of its surface, by the mean of its curvature along and across:
/// for a cylinder twice its own radius. It is infinite for what is flat, and for what is shaded as if it were not.
pub fn curvature(scene: &Scene<f64>, object: Object, place: Vec3<f64>) -> f64 {
    let found = match object {
        Object::Sphere(i) => scene.spheres.get(i as usize).map(|sphere| sphere.radius),
        Object::Cylinder(i) => scene.cylinders.get(i as usize).map(|cylinder| 2.0 * cylinder.radius),
        Object::Ellipsoid(i) => scene
            .ellipsoids
            .get(i as usize)
            .map(|ellipsoid| of_ellipsoid(ellipsoid.radii, place - ellipsoid.center)),
        Object::Cone(i) => scene.cones.get(i as usize).map(|cone| {
            let way = place - cone.center;
            let along = way.dot(cone.axis);
            let is_end = cone.capped && along.abs() > cone.half_height * cone.span * (1.0 - 1e-9);
            let across = (way - cone.axis * along).length();
            if is_end { f64::INFINITY } else { 2.0 * across / cone.cosine }
        }),
        _ => None,
    };
    found.unwrap_or(f64::INFINITY)
}

/// Returns the reciprocal of the mean curvature of an ellipsoid with these half axes at a place relative to its centre: with h the distance of
/// the tangent plane from the centre, `2 a^2 b^2 c^2 / (h^3 |a^2 + b^2 + c^2 - |x|^2|)`.
fn of_ellipsoid(radii: Vec3<f64>, place: Vec3<f64>) -> f64 {
    let squares = radii * radii;
    let gradient = place / squares;
    let distance = 1.0 / gradient.length();
    let product = squares.x * squares.y * squares.z;
    2.0 * product / (distance.powi(3) * (squares.x + squares.y + squares.z - place.length_squared()))
}

#[cfg(test)]
mod tests {
    use rta_core::vector::Vec3;

    use super::of_ellipsoid;

    #[test]
    fn ellipsoids() {
        let at = |radii: [f64; 3], place: [f64; 3]| {
            let vector = |[x, y, z]: [f64; 3]| Vec3::<f64>::new(x, y, z);
            of_ellipsoid(vector(radii), vector(place))
        };
        assert!((at([2.0; 3], [0.0, 1.2, 1.6]) - 2.0).abs() < 1e-12);
        // At the end of an axis the curvatures are c / a^2 and c / b^2.
        let mean = 2.0 / (1.0 / 4.0 + 1.0 / 9.0);
        assert!((at([2.0, 3.0, 1.0], [0.0, 0.0, 1.0]) - mean).abs() < 1e-12);
        // Far from the ends of a long one it is a cylinder.
        assert!((at([1.0, 1.0, 1000.0], [0.6, 0.8, 0.0]) - 2.0).abs() < 1e-5);
    }
}
