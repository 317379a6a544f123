//! Rooms of flat, diffuse surfaces: what paths are mostly followed in, and what light is mostly solved for.

use rta_core::needs::Needs;
use rta_scenes::description::Air;
use rta_scenes::model::Model;
use rta_scenes::narrow::{Narrow, Narrowed};
use rta_scenes::used;

/// What such a room needs.
pub(super) struct Room;

impl Needs for Room {
    const SPHERES: bool = false;
    const ELLIPSOIDS: bool = false;
    const CONES: bool = false;
    const NORMALS: bool = false;
    const PLANES: bool = false;
    const CYLINDERS: bool = false;
    const FLOOR: bool = false;
    const TILES: bool = false;
    const VISIBLE_LAMPS: bool = false;
    const GLINT: bool = false;
    const MIRROR: bool = false;
    const GLASS: bool = false;
    const TRANSPARENT_SHADOWS: bool = false;
    const CHECKER: bool = false;
    const MARBLE: bool = false;
    const WOOD: bool = false;
    const IMAGES: bool = false;
    const BUMPS: bool = false;
    const SURROUNDINGS: bool = false;
    const MESHES: bool = false;
    const SKY_MAP: bool = false;
    const GLOSS: bool = false;
}

/// Returns whether a scene that is drawn with this model, in this air, is such a room.
pub(super) fn is_room<S: Narrow>(scene: &Narrowed<S>, (model, air): (Model, &Air)) -> bool {
    let is_plain = model == Model::Lambert && *air == Air::default();
    is_plain && used::missing::<Room, S>(&scene.scene()).is_none()
}
