//! A scene as triangles: what is round is cut, and what is infinite is cut off.

use core::f64::consts::TAU;

use rta_scenes::description::{Cone, Cylinder, Description};
use rta_scenes::space::{Triple, cross, difference, dot, length, unit};

/// How far planes and cylinders reach where nothing else is in the scene.
const ALONE: f64 = 100.0;

/// A triangle of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Face {
    /// Its vertices, counterclockwise as seen from outside.
    pub vertices: [Triple; 3],
    /// Whether it is seen from outside alone.
    pub one_sided: bool,
}

/// The triangles of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Faces {
    /// The triangles: spheres, ellipsoids, cones, cylinders, planes, the floor.
    pub all: Vec<Face>,
    /// How far from the eye what is infinite is cut off, if anything is.
    pub reach: Option<f64>,
    /// Lamps that can be seen, which are no faces.
    pub lamps: usize,
}

impl Faces {
    /// Cuts a scene: spheres and ellipsoids into `rows` bands of `2 rows` quadrilaterals, cones and cylinders into `2 rows` quadrilaterals. Infinite
    /// planes, the floor among them, become squares about the place that is nearest to the eye, and infinite cylinders end: both reach
    /// as far from there as the farthest of all other things is from the eye. Lamps are left out.
    #[must_use]
    pub fn new(scene: &Description, rows: u32) -> Self {
        let mut cut = scene.clone();
        cut.tessellate(rows);
        let eye = scene.camera.eye;
        let triangles =
            cut.triangles.iter().map(|own| Face { vertices: own.vertices, one_sided: own.one_sided });
        let mut all: Vec<_> = triangles.collect();
        let around = 2 * rows;
        all.extend(cut.cones.iter().flat_map(|cone| conical(cone, around)));
        let far = all
            .iter()
            .flat_map(|face| face.vertices)
            .map(|vertex| length(difference(vertex, eye)))
            .fold(0.0, f64::max);
        let reach = if far > 0.0 { far } else { ALONE };
        all.extend(cut.cylinders.iter().flat_map(|cylinder| conical(&finite(cylinder, eye, reach), around)));
        let floor = cut.floor.iter().map(|_| ([0.0; 3], [0.0, 0.0, 1.0]));
        let planes = cut.planes.iter().map(|plane| (plane.point, plane.normal)).chain(floor);
        all.extend(planes.filter_map(|(point, normal)| square(point, unit(normal)?, eye, reach)).flatten());
        let is_infinite = !(cut.cylinders.is_empty() && cut.planes.is_empty() && cut.floor.is_none());
        let lamps = cut.lamps.iter().filter(|lamp| lamp.radius > 0.0).count();
        Self { all, reach: is_infinite.then_some(reach), lamps }
    }
}

/// Returns `from + a u + b v`.
fn place(from: Triple, (a, u): (f64, Triple), (b, v): (f64, Triple)) -> Triple {
    let ([x, y, z], [ux, uy, uz], [vx, vy, vz]) = (from, u, v);
    [x + a * ux + b * vx, y + a * uy + b * vy, z + a * uz + b * vz]
}

/// Returns unit vectors that are perpendicular to a unit vector and to each other.
fn across(axis: Triple) -> Option<[Triple; 2]> {
    let [x, y, _] = axis;
    // The axis that is far from parallel.
    let other = if x.abs() < 0.6 {
        [1.0, 0.0, 0.0]
    } else if y.abs() < 0.6 {
        [0.0, 1.0, 0.0]
    } else {
        [0.0, 0.0, 1.0]
    };
    let first = unit(cross(axis, other))?;
    Some([first, cross(axis, first)])
}

/// Returns an infinite cylinder as far as it reaches up and down from the height of the eye.
fn finite(cylinder: &Cylinder, eye: Triple, reach: f64) -> Cone {
    let &Cylinder { position: [x, y, _], color, radius, surface, line } = cylinder;
    let end = |height: f64| [x, y, eye[2] + height];
    Cone {
        base: end(-reach),
        base_radius: radius,
        apex: end(reach),
        apex_radius: radius,
        capped: false,
        inside_only: false,
        color,
        surface,
        line,
    }
}

/// Returns the side and the ends of a cone.
fn conical(cone: &Cone, around: u32) -> Vec<Face> {
    let along = difference(cone.apex, cone.base);
    let Some([u, v]) = unit(along).and_then(across) else { return Vec::new() };
    let ring = |center: Triple, radius: f64| {
        move |column: u32| {
            let (sine, cosine) = (TAU * f64::from(column % around) / f64::from(around)).sin_cos();
            place(center, (radius * cosine, u), (radius * sine, v))
        }
    };
    let (base, apex) = (ring(cone.base, cone.base_radius), ring(cone.apex, cone.apex_radius));
    let face = |[a, b, c]: [Triple; 3]| {
        let vertices = if cone.inside_only { [a, c, b] } else { [a, b, c] };
        Face { vertices, one_sided: cone.inside_only }
    };
    (0..around)
        .flat_map(|column| {
            let ([a, b], [c, d]) = ([base(column), base(column + 1)], [apex(column), apex(column + 1)]);
            let lower = (cone.base_radius > 0.0).then_some([a, b, d]);
            let upper = (cone.apex_radius > 0.0).then_some([a, d, c]);
            let lower = if cone.apex_radius > 0.0 { lower } else { Some([a, b, cone.apex]) };
            let upper = if cone.base_radius > 0.0 { upper } else { Some([cone.base, d, c]) };
            let ends = [[cone.base, b, a], [cone.apex, c, d]].map(|end| cone.capped.then_some(end));
            let is_whole = cone.apex_radius > 0.0;
            [lower, upper.filter(|_| is_whole), ends[0], ends[1].filter(|_| is_whole)]
        })
        .flatten()
        .map(face)
        .collect()
}

/// Returns a square about the place of a plane that is nearest to the eye.
fn square(point: Triple, normal: Triple, eye: Triple, reach: f64) -> Option<[Face; 2]> {
    let [u, v] = across(normal)?;
    let height = dot(difference(eye, point), normal);
    let foot = place(eye, (-height, normal), (0.0, normal));
    let corner = |a: f64, b: f64| place(foot, (a * reach, u), (b * reach, v));
    let [a, b, c, d] = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
    Some([[a, b, c], [a, c, d]].map(|vertices| Face { vertices, one_sided: false }))
}

#[cfg(test)]
mod tests {
    use super::Faces;

    #[test]
    fn all_kinds_are_cut() {
        let text = "rta 1\ncamera at 0 -9 2 to 0 0 1\nfloor .5 .5 .5  .4 .4 .4\nsphere at 0 0 1 radius 1\n";
        let scene = rta_scenes::rta::read(text.as_bytes(), "s.rta").expect("a scene");
        let faces = Faces::new(&scene, 4);
        assert_eq!(faces.all.len(), 48 + 2);
        // The floor's square is as wide as the far side of the ball is away, to both sides.
        let reach = faces.reach.expect("a floor");
        assert!((9.9..10.3).contains(&reach), "{reach}");
        let floor = faces.all.iter().skip(48).flat_map(|face| face.vertices);
        assert!(floor.into_iter().all(|[x, y, z]| z.abs() < 1e-12
            && (x.abs() - reach).abs() < 1e-9
            && ((y + 9.0).abs() - reach).abs() < 1e-9));
    }
}
