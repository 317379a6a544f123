//! Origins and directions of a case's rays, drawn in `f64` from a seeded generator, so that they are the same in every format.

use core::f64::consts::TAU;

use fastrand::Rng;
use rta_scenes::description::Description;

use super::body::{Body, Rod};
use super::triple::{Triple, across, add, magnitude, sign, signed, sphere, unit};

/// The position of the eye. Rays come in blocks, and each block has an eye and a view of its own.
#[derive(Clone, Copy, Debug)]
pub enum Stand {
    /// The scene's own, moved and turned by up to that much in each coordinate; in about half of the blocks not at all.
    Shaken(f64),
    /// Anywhere on the surface of the first convex object, to within the rounding of the format.
    OnSurface,
    /// The scene's own moved a little, but 0.01 to 100 units above the floor, all magnitudes alike.
    AboveFloor,
}

/// The directions of rays.
#[derive(Clone, Copy, Debug)]
pub enum Aim {
    /// Through anywhere on the image plane: the picture itself.
    Picture,
    /// Through the centre of the image plane.
    Center,
    /// Past the silhouette of the first convex object, from a tenth of its radius down to 1e-9 of it on either side.
    Silhouette,
    /// At the silhouette itself, as near as `f64` can tell.
    Tangent,
    /// To the horizon: 1 down to 1e-9 below it, or above.
    Horizon,
    /// Along the axis of the first cone, towards its narrower end: 0.3 down to 1e-9 beside the direction.
    Axis,
    /// At the narrower end of the first cone: 1e-3 down to 1e-9 beside the direction.
    Apex,
    /// At the places of the first convex object, a sphere, where its normal is halfway between the directions to the first lamp and
    /// to the eye: 0.3 down to 1e-9 beside them.
    Glint,
    /// At the border between light and dark of the first convex object, under the first lamp.
    Border,
    /// At the first lamp: 0.1 down to 1e-9 beside its direction.
    Lamp,
    /// At the first triangle: at its edges, from a tenth of its width down to 1e-9 of it on either side.
    Edge,
    /// From inside the first convex object, whose index of refraction is given: the sine of the angle that the ray meets
    /// the surface at is within 1e-6 of the one for total reflection.
    Critical(f64),
}

/// A direction as it is drawn.
#[derive(Clone, Copy, Debug)]
pub enum Drawn {
    /// Through a place of the image plane, each coordinate from -1/2 to 1/2.
    Through(f64, f64),
    /// A unit vector.
    Along(Triple),
}

impl Stand {
    /// The scene with the eye of one block.
    #[must_use]
    pub fn place(self, scene: &Description, rng: &mut Rng) -> Description {
        let mut scene = scene.clone();
        match self {
            Self::Shaken(most) => {
                if rng.bool() {
                    scene.camera.eye = scene.camera.eye.map(|part| part + most * signed(rng));
                    scene.camera.view = scene.camera.view.map(|part| part + most * signed(rng));
                }
            }
            Self::OnSurface => {
                let first = Body::all(&scene).next();
                if let Some(body) = first {
                    scene.camera.eye = body.surface(sphere(rng));
                }
            }
            Self::AboveFloor => {
                let [x, y, _] = scene.camera.eye;
                scene.camera.eye = [x + signed(rng), y + signed(rng), magnitude(rng, -2.0, 2.0)];
            }
        }
        scene
    }
}

impl Aim {
    /// The direction of one ray from the eye of `scene`.
    #[must_use]
    pub fn draw(self, scene: &Description, rng: &mut Rng) -> Drawn {
        let mut past = |offset: &dyn Fn(&mut Rng) -> f64| match Body::all(scene).next() {
            Some(body) => {
                let offset = offset(rng);
                Drawn::Along(body.past(scene.camera.eye, offset, rng))
            }
            None => Drawn::Along(sphere(rng)),
        };
        match self {
            Self::Picture => Drawn::Through(rng.f64() - 0.5, rng.f64() - 0.5),
            Self::Center => Drawn::Through(0.0, 0.0),
            Self::Silhouette => past(&|rng| 1.0 + sign(rng) * magnitude(rng, -9.0, -1.0)),
            Self::Tangent => past(&|_| 1.0),
            Self::Critical(ior) => past(&|rng| (1.0 + 1e-6 * signed(rng)) / ior),
            Self::Axis | Self::Apex => {
                let Some(rod) = Rod::all(scene).next() else { return Drawn::Along(sphere(rng)) };
                let way = if matches!(self, Self::Axis) {
                    unit(rod.axis())
                } else {
                    unit(add(rod.apex, scene.camera.eye, -1.0))
                };
                let most = if matches!(self, Self::Axis) { -0.5 } else { -3.0 };
                Drawn::Along(unit(add(way, across(way, rng), magnitude(rng, -9.0, most))))
            }
            Self::Glint | Self::Border | Self::Lamp => {
                let eye = scene.camera.eye;
                let Some(lamp) = scene.lamps.first().map(|lamp| lamp.position) else {
                    return Drawn::Along(sphere(rng));
                };
                let place = match (self, Body::all(scene).next()) {
                    (Self::Glint, Some(body)) => {
                        let facet = body.mirror(eye, lamp);
                        Some(body.surface(unit(add(facet, across(facet, rng), magnitude(rng, -9.0, -0.5)))))
                    }
                    (Self::Border, Some(body)) => body.border(lamp, rng),
                    _ => {
                        let way = unit(add(lamp, eye, -1.0));
                        let aside = magnitude(rng, -9.0, -1.0);
                        return Drawn::Along(unit(add(way, across(way, rng), aside)));
                    }
                };
                Drawn::Along(place.map_or_else(|| sphere(rng), |place| unit(add(place, eye, -1.0))))
            }
            Self::Edge => {
                let Some(triangle) = scene.triangles.first() else { return Drawn::Along(sphere(rng)) };
                let [a, b, c] = triangle.vertices;
                let (from, to, third) = match rng.u8(..3) {
                    0 => (a, b, c),
                    1 => (b, c, a),
                    _ => (c, a, b),
                };
                let place = add(from, add(to, from, -1.0), rng.f64());
                let inwards = add(third, place, -1.0);
                let place = add(place, inwards, sign(rng) * magnitude(rng, -9.0, -1.0));
                Drawn::Along(unit(add(place, scene.camera.eye, -1.0)))
            }
            Self::Horizon => {
                let (sine, cosine) = (rng.f64() * TAU).sin_cos();
                Drawn::Along(unit([cosine, sine, sign(rng) * magnitude(rng, -9.0, 0.0)]))
            }
        }
    }
}
