//! Origins and directions of a case's rays, drawn in `f64` from a seeded generator, so that they are the same in every format.

use core::f64::consts::TAU;

use fastrand::Rng;
use rta_scenes::description::Description;

/// Three numbers: a place, or a direction of length 1.
pub type Triple = [f64; 3];

/// The position of the eye. Rays come in blocks, and each block has an eye and a view of its own.
#[derive(Clone, Copy, Debug)]
pub enum Stand {
    /// The scene's own, moved and turned by up to that much in each coordinate; in about half of the blocks not at all.
    Shaken(f64),
    /// Anywhere on the surface of the first round object, to within the rounding of the format.
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
    /// Past the silhouette of the first round object, from a tenth of its radius down to 1e-9 of it on either side.
    Silhouette,
    /// At the silhouette itself, as near as `f64` can tell.
    Tangent,
    /// To the horizon: 1 down to 1e-9 below it, or above.
    Horizon,
    /// From inside the first round object, whose index of refraction is given: the sine of the angle that the ray meets
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

/// A sphere, an ellipsoid or a cylinder, as its centre and radii; a cylinder is seen in the ground plan.
#[derive(Clone, Copy, Debug)]
pub struct Round {
    /// Centre, or a place on the axis.
    pub center: Triple,
    /// Half axes; that of a cylinder along z is infinite.
    pub radii: Triple,
}

impl Round {
    /// Returns all round objects of a scene, spheres first.
    pub fn all(scene: &Description) -> impl Iterator<Item = Self> {
        let spheres = scene.spheres.iter().map(|s| Self { center: s.position, radii: [s.radius; 3] });
        let ellipsoids = scene.ellipsoids.iter().map(|e| Self { center: e.position, radii: e.radii });
        let cylinders = scene
            .cylinders
            .iter()
            .map(|c| Self { center: c.position, radii: [c.radius, c.radius, f64::INFINITY] });
        spheres.chain(ellipsoids).chain(cylinders)
    }

    /// The largest radius that is finite.
    #[must_use]
    pub fn extent(&self) -> f64 {
        self.radii.iter().filter(|r| r.is_finite()).fold(0.0, |most, &r| most.max(r))
    }

    /// The place of the surface in a direction, seen from the centre in the space where the object is a unit sphere.
    #[must_use]
    pub fn surface(&self, direction: Triple) -> Triple {
        let [x, y, z] = direction;
        if self.is_cylinder() {
            let length = x.hypot(y).max(1e-9);
            let [rx, ry, _] = self.radii;
            let [cx, cy, cz] = self.center;
            [cx + rx * x / length, cy + ry * y / length, cz + rx * z]
        } else {
            add(self.center, times(self.radii, direction), 1.0)
        }
    }

    /// Returns the vector from the centre to a place, in the space where the object is a unit sphere or a unit circle.
    #[must_use]
    pub fn seen(&self, mut place: Triple) -> Triple {
        for ((place, center), radius) in place.iter_mut().zip(self.center).zip(self.radii) {
            *place = (*place - center) / radius; // 0 along an infinite axis
        }
        place
    }

    /// A direction from `eye` that passes the centre at `offset` radii; anywhere, if the eye is too near for that.
    #[must_use]
    pub fn past(&self, eye: Triple, offset: f64, rng: &mut Rng) -> Triple {
        let flat = self.is_cylinder();
        let way = self.seen(eye).map(|part| -part);
        let distance = length(way);
        if distance.is_nan() || distance <= offset {
            return sphere(rng);
        }
        let axis = way.map(|part| part / distance);
        let side = if flat {
            let [x, y, _] = axis;
            if rng.bool() { [-y, x, 0.0] } else { [y, -x, 0.0] }
        } else {
            across(axis, rng)
        };
        let sine = offset / distance;
        let bent = add(axis.map(|part| part * (1.0 - sine * sine).sqrt()), side, sine);
        if flat {
            let [x, y, _] = bent;
            unit([x, y, signed(rng)])
        } else {
            unit(times(bent, self.radii))
        }
    }

    fn is_cylinder(&self) -> bool {
        self.radii.iter().any(|r| r.is_infinite())
    }
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
                let first = Round::all(&scene).next();
                if let Some(round) = first {
                    scene.camera.eye = round.surface(sphere(rng));
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
        let mut past = |offset: &dyn Fn(&mut Rng) -> f64| match Round::all(scene).next() {
            Some(round) => {
                let offset = offset(rng);
                Drawn::Along(round.past(scene.camera.eye, offset, rng))
            }
            None => Drawn::Along(sphere(rng)),
        };
        match self {
            Self::Picture => Drawn::Through(rng.f64() - 0.5, rng.f64() - 0.5),
            Self::Center => Drawn::Through(0.0, 0.0),
            Self::Silhouette => past(&|rng| 1.0 + sign(rng) * magnitude(rng, -9.0, -1.0)),
            Self::Tangent => past(&|_| 1.0),
            Self::Critical(ior) => past(&|rng| (1.0 + 1e-6 * signed(rng)) / ior),
            Self::Horizon => {
                let (sine, cosine) = (rng.f64() * TAU).sin_cos();
                Drawn::Along(unit([cosine, sine, sign(rng) * magnitude(rng, -9.0, 0.0)]))
            }
        }
    }
}

/// `a + factor b`.
#[must_use]
pub fn add([x, y, z]: Triple, [u, v, w]: Triple, factor: f64) -> Triple {
    [x + factor * u, y + factor * v, z + factor * w]
}

/// The dot product.
#[must_use]
pub fn dot([x, y, z]: Triple, [u, v, w]: Triple) -> f64 {
    x * u + y * v + z * w
}

fn times([x, y, z]: Triple, [u, v, w]: Triple) -> Triple {
    [x * u, y * v, z * w]
}

/// The Euclidean length.
#[must_use]
pub fn length(v: Triple) -> f64 {
    dot(v, v).sqrt()
}

/// The unit vector along `v`, which is not zero.
#[must_use]
pub fn unit(v: Triple) -> Triple {
    let length = length(v);
    v.map(|part| part / length)
}

/// A unit vector at right angles to one.
pub fn across(axis: Triple, rng: &mut Rng) -> Triple {
    loop {
        let v = sphere(rng);
        let rest = add(v, axis, -dot(v, axis));
        if length(rest) > 0.1 {
            let rest = unit(rest);
            return unit(add(rest, axis, -dot(rest, axis)));
        }
    }
}

/// A unit vector, all directions alike.
pub fn sphere(rng: &mut Rng) -> Triple {
    loop {
        let v = [signed(rng), signed(rng), signed(rng)];
        let length = length(v);
        if (0.01..=1.0).contains(&length) {
            return v.map(|part| part / length);
        }
    }
}

/// From -1 to 1.
pub fn signed(rng: &mut Rng) -> f64 {
    2.0 * rng.f64() - 1.0
}

/// -1 or 1.
pub fn sign(rng: &mut Rng) -> f64 {
    if rng.bool() { 1.0 } else { -1.0 }
}

/// From `10^least` to `10^most`, all magnitudes alike.
pub fn magnitude(rng: &mut Rng, least: f64, most: f64) -> f64 {
    10f64.powf(least + (most - least) * rng.f64())
}
