//! What few things of a scene have, kept beside them, so that the many others need not hold it.

use std::collections::BTreeMap;
use std::sync::Arc;

use rta_core::scene::Object;
use rta_core::texture::Shading;

use super::{Journey, Path, Pixels, Solved};

/// What few objects, lamps, floors and skies have.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Details {
    /// Lamps that are no spheres, by their numbers, from 0.
    pub lamps: BTreeMap<usize, LampShape>,
    /// Objects that have more than their kind.
    pub objects: BTreeMap<Object, Detail>,
    /// Side of the floor's tiles, above 0; 3 without it.
    pub tile: Option<f64>,
    /// File with a picture of the sky, beside that of the scene.
    pub sky_map: Option<String>,
    /// Whether triangles with normals are mixed on the screen, for rays from the eye.
    pub scanline: bool,
    /// Paths, to which camera, lamps and objects refer by name.
    pub paths: Vec<Path>,
    /// How the camera moves, if it does.
    pub journey: Option<Journey>,
    /// The paths of lamps that move, by the lamps' numbers, from 0.
    pub lamp_paths: BTreeMap<usize, String>,
    /// Radiosity that was solved ahead.
    pub light: Option<Arc<Solved>>,
    /// How far lamps move in the time from 0 to 1, by the lamps' numbers, from 0.
    pub lamp_moves: BTreeMap<usize, [f64; 3]>,
    /// The pictures that the scene names, by the names of their files, as far as they were [loaded](super::Description::load_pictures).
    pub pictures: BTreeMap<String, Arc<Pixels>>,
}

/// The shape of a lamp that is no sphere. As long as nothing draws it, a sphere stands for it in
/// [`lamps`](super::Description::lamps).
#[derive(Clone, Debug, PartialEq)]
pub enum LampShape {
    /// So far away that its light is parallel: the direction towards it, of any length but zero.
    Toward([f64; 3]),
    /// A parallelogram: a corner, and the edges from there, which are not parallel.
    Area {
        /// A corner.
        corner: [f64; 3],
        /// The edges.
        edges: [[f64; 3]; 2],
    },
}

/// What an object may have beside what all of its kind have.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Detail {
    /// How a triangle with normals is shaded.
    pub shading: Shading,
    /// How far it moves in the time from 0 to 1.
    pub moves: Option<[f64; 3]>,
    /// The path that it moves along, by its name.
    pub along: Option<String>,
    /// Texture coordinates u and v of the vertices of a triangle.
    pub uv: Option<[[f64; 2]; 3]>,
}
