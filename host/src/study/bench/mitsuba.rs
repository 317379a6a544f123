//! Rooms for Mitsuba 3 (W. Jakob and others, <https://www.mitsuba-renderer.org>): the same triangles before the same eye, and a script that
//! follows paths in them with its variant `scalar_rgb`.

use core::fmt::Write;

use rta_core::vector::Vector;
use rta_scenes::description::{Air, Description, Material, Model};
use rta_scenes::narrow::narrow;
use rta_scenes::space::length;

use crate::engine::EngineError;
use crate::picture::raster::Size;

/// What the script needs of a scene, and a scene has not.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum MitsubaError {
    /// Something else than diffuse triangles is in the scene.
    #[error(
        "beside mitsuba, a room is of triangles and quads, which emit as a whole, by the model lambert, in clear air: {0} is not"
    )]
    NoRoom(String),
    /// The scene's camera cannot be expressed.
    #[error(transparent)]
    Camera(#[from] EngineError),
}

/// Returns a script for Python that draws a room by paths as Mitsuba has them by itself, on a screen of the shape `aspect : 1`: one picture for
/// each number of samples, `theirs-N.pfm`. For each it prints a line with the number and the CPU seconds of drawing, without reading the
/// scene. Its argument is the seed.
///
/// # Errors
/// [`MitsubaError`]; `title` is what the scene is called then.
pub fn script(
    scene: &Description,
    title: &str,
    (size, aspect): (Size, f64),
    samples: &[u32],
) -> Result<String, MitsubaError> {
    if !is_room(scene) {
        return Err(MitsubaError::NoRoom(title.to_owned()));
    }
    let camera =
        narrow::<f64>(&Description::empty(scene.camera.clone()), aspect).map_err(EngineError::from)?.camera;
    let [eye, forward, up] = [camera.eye, camera.forward, camera.up].map(|v| [v.x(), v.y(), v.z()]);
    let fov = 2.0 * (length(up) / 2.0 / length(forward)).atan().to_degrees();
    let ([x, y, z], [a, b, c]) = (eye, forward);
    let target = [x + a, y + b, z + c];
    let mut text = String::new();
    // A String takes all that is written to it.
    let _ = writeln!(text, "EYE, TARGET, UP, FOV = {eye:?}, {target:?}, {up:?}, {fov:?}");
    let _ = writeln!(text, "WIDTH, HEIGHT, SAMPLES = {}, {}, {samples:?}", size.width(), size.height());
    let _ = writeln!(text, "SKY = {:?}", scene.sky.horizon);
    let _ = writeln!(text, "# Vertices, reflectance, and the radiance that is emitted.\nTRIANGLES = [");
    for triangle in &scene.triangles {
        let emits = Material::of(&triangle.surface, &scene.materials).emits.unwrap_or_default();
        let _ = writeln!(text, "    ({:?}, {:?}, {emits:?}),", triangle.vertices, triangle.color);
    }
    text += "]\n";
    text += SCRIPT;
    Ok(text)
}

/// Draws what the lines before it say.
const SCRIPT: &str = include_str!("mitsuba/draw.py");

/// Returns whether a scene is of what the script knows.
fn is_room(scene: &Description) -> bool {
    let others = scene.cylinders.len() + scene.ellipsoids.len() + scene.spheres.len() + scene.cones.len();
    let is_flat = others + scene.planes.len() + scene.lamps.len() == 0 && scene.floor.is_none();
    let is_plain = scene.triangles.iter().all(|triangle| triangle.normals.is_none())
        && scene.textures.is_empty()
        && scene.quads.iter().all(|quad| quad.emitting.is_none());
    let is_clear = scene.air == Air::default() && scene.sky.horizon == scene.sky.zenith;
    is_flat && is_plain && is_clear && scene.model == Model::Lambert && scene.optics.aperture.is_none()
}

#[cfg(test)]
mod tests {
    use super::{MitsubaError, script};

    const ROOM: &str = "rta 1\npicture 4 2  screen 2 1\ncamera at 0 -3 1  look 0 1 0  lens 1\nmodel lambert\n\
                        material light  emits 6 5 4\n\
                        quad 0 0 0  2 0 0  2 2 0  0 2 0  color .5 .25 .5\n\
                        quad 0 0 2  0 2 2  2 2 2  2 0 2  color .5 .5 .5  of light\n";

    #[test]
    fn a_room_is_told() {
        let read = |text: &str| rta_scenes::read(text.as_bytes(), "room.rta").expect("a scene");
        let size = "4x2".parse().expect("a size");
        let told = script(&read(ROOM), "room", (size, 2.0), &[1, 16]).expect("a room");
        for line in [
            "EYE, TARGET, UP, FOV = [0.0, -3.0, 1.0], [0.0, -2.0, 1.0],",
            "WIDTH, HEIGHT, SAMPLES = 4, 2, [1, 16]\n",
            "]], [0.5, 0.25, 0.5], [0.0, 0.0, 0.0]),\n",
            "]], [0.5, 0.5, 0.5], [6.0, 5.0, 4.0]),\n",
        ] {
            assert!(told.contains(line), "{line}: {told}");
        }
        let other = format!("{ROOM}sphere at 1 1 1  radius .5  color .5 .5 .5\n");
        let error = script(&read(&other), "room", (size, 2.0), &[1]).expect_err("a sphere");
        assert!(matches!(error, MitsubaError::NoRoom(_)), "{error}");
    }
}
