//! Rooms, and what is known of them.

extern crate std;

use std::vec::Vec;

use super::{Mesh, Quad};
use crate::camera::{Camera, Lens};
use crate::color::Rgb;
use crate::range::Admitted;
use crate::scalar::Light;
use crate::scalar::read::{Read, direction, place};
use crate::scene::{PLAIN, Scene, Sky};
use crate::shape::Triangle;

mod factor;
mod follow;
mod gather;
mod mesh;
mod room;
mod shoot;
mod vertex;
mod view;

/// Returns the light of three registers, each below 2.
fn light<S: Read>([r, g, b]: [f64; 3]) -> Rgb<S::Light> {
    Rgb::new(r, g, b).map(|light| S::Light::WHITE.times(S::unit(light)))
}

fn color<S: Read>([r, g, b]: [f64; 3]) -> Rgb<S::Unit> {
    Rgb::new(r, g, b).map(S::unit)
}

/// Returns the registers as floats.
fn shine<S: Read>(Rgb { r, g, b }: Rgb<S::Light>) -> [f64; 3] {
    [r, g, b].map(S::shine)
}

/// Quadrilaterals and their triangles.
struct Faces<S: Read> {
    quads: Vec<Quad<S>>,
    triangles: Vec<Triangle<S>>,
}

/// What the patches of a wall are like.
#[derive(Clone, Copy)]
struct Wall {
    reflectance: [f64; 3],
    emission: [f64; 3],
}

/// The camera of scenes that nobody looks at.
fn camera<S: Read>() -> Camera<S> {
    Camera::new(place::<S>([0.5; 3]), direction::<S>([0.0, 1.0, 0.0]), Lens::new(1, 1, (1, 1)))
}

impl<S: Read> Faces<S> {
    const fn new() -> Self {
        Self { quads: Vec::new(), triangles: Vec::new() }
    }

    fn push(&mut self, corners: [[f64; 3]; 4], patches: [u16; 2], wall: Wall) {
        let first = self.quads.last().map_or(0, |last| last.first + last.len() as u32);
        self.quads.push(Quad {
            corners: corners.map(place::<S>),
            patches,
            first,
            reflectance: color::<S>(wall.reflectance),
            emission: light::<S>(wall.emission),
            emitting: [[0; 2], patches],
            triangle: self.triangles.len() as u32,
            triangles: 2,
        });
        self.bare_face(corners, [0.0; 3], PLAIN);
    }

    /// Adds two triangles without patches.
    fn bare_face(&mut self, corners: [[f64; 3]; 4], own: [f64; 3], material: u16) {
        let minus = |a: [f64; 3], b: [f64; 3]| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
        let cross = |a: [f64; 3], b: [f64; 3]| {
            [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
        };
        let length = |a: [f64; 3]| libm::sqrt(a.iter().map(|c| c * c).sum());
        let normal = cross(minus(corners[2], corners[0]), minus(corners[3], corners[1]));
        let size = length(normal);
        let normal = direction::<S>(normal.map(|c| c / size));
        for [b, c] in [[1, 2], [2, 3]] {
            let extent = length(minus(corners[b], corners[0])).max(length(minus(corners[c], corners[0])));
            self.triangles.push(Triangle {
                vertices: [corners[0], corners[b], corners[c]].map(place::<S>),
                extent: S::length(extent),
                normal,
                normals: None,
                one_sided: false,
                color: color::<S>(own),
                material,
            });
        }
    }

    /// Returns the unit cube, seen from inside: floor, ceiling, x = 0, x = 1, y = 0, y = 1, each of n x n patches, u along its first axis. If
    /// `is_split`, each patch is a quadrilateral of its own. `wall` tells of face and patch, without `is_split` of the face alone.
    fn cube(n: u16, is_split: bool, wall: impl Fn(usize, usize) -> Wall) -> Self {
        let mut faces = Self::new();
        for face in 0..6 {
            let (cells, patches) = if is_split { (n, 1) } else { (1, n) };
            for j in 0..cells {
                for i in 0..cells {
                    let part = |k: u16| f64::from(k) / f64::from(cells);
                    let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
                    let corners = corners.map(|(i, j)| on_face(face, [part(i), part(j)]));
                    let [a, b, c, d] = corners;
                    // Counterclockwise from inside.
                    let corners = if matches!(face, 1 | 3 | 4) { [a, d, c, b] } else { corners };
                    faces.push(corners, [patches; 2], wall(face, usize::from(i + j * cells)));
                }
            }
        }
        faces
    }

    fn scene(&self) -> Admitted<'_, S> {
        self.bare().admit(&camera::<S>()).expect("it fits")
    }

    fn bare(&self) -> Scene<'_, S> {
        let sky = Sky { horizon: Rgb::BLACK, zenith: Rgb::BLACK };
        Scene { triangles: &self.triangles, ..Scene::empty(sky, Rgb::BLACK) }
    }

    fn mesh(&self) -> Mesh<'_, S> {
        Mesh::new(&self.quads, &self.bare()).expect("it is right")
    }
}

/// Returns the place (u, v) of a face of the unit cube.
fn on_face(face: usize, [u, v]: [f64; 2]) -> [f64; 3] {
    let high = if face % 2 == 1 { 1.0 } else { 0.0 };
    match face / 2 {
        0 => [u, v, high],
        1 => [high, u, v],
        _ => [u, high, v],
    }
}

/// Returns the walls of a room in Goral's manner: white but for the left and the right wall; the middle of the ceiling emits 1, in n x n
/// patches, where n is 1, 3 or 6.
fn room_g(n: u16) -> impl Fn(usize, usize) -> Wall {
    move |face, patch| {
        let reflectance = match face {
            2 => [0.6, 0.1, 0.1],
            3 => [0.1, 0.6, 0.1],
            _ => [0.7; 3],
        };
        let middle: &[usize] = match n {
            1 => &[0],
            3 => &[4],
            _ => &[14, 15, 20, 21],
        };
        let emits = face == 1 && middle.contains(&patch);
        Wall { reflectance, emission: [if emits { 1.0 } else { 0.0 }; 3] }
    }
}

/// Returns the walls of a closed room in which all is alike.
fn furnace(reflectance: f64, emission: f64) -> impl Fn(usize, usize) -> Wall {
    move |_, _| Wall { reflectance: [reflectance; 3], emission: [emission; 3] }
}
