//! Scenes that are hard on a tracer and yet fair: no coincident surfaces, everything within 50 units of the origin,
//! most pixels between black and white, and no length that Q16.16 cannot hold.
//!
//! They come from a seeded generator and do not change from run to run.

use core::f64::consts::TAU;

use rta_scenes::description::{
    Camera, Cylinder, Description, Ellipsoid, FallOff, Floor, Lamp, Sky, Sphere, Surface,
};

mod in_glass;
#[cfg(test)]
mod tests;

/// Returns all scenes with their names.
#[must_use]
pub fn all() -> Vec<(&'static str, Description)> {
    vec![
        ("every-type", every_type()),
        ("glass-in-glass", in_glass::glass_in_glass()),
        ("eye-in-glass", in_glass::eye_in_glass()),
        ("many-lamps", many_lamps()),
        ("straight-down", straight_down()),
        ("straight-up", straight_up()),
        ("mirror-cylinders", mirror_cylinders()),
        ("glass-cylinders", in_glass::glass_cylinders()),
        ("glass-ellipsoids", in_glass::glass_ellipsoids()),
        ("lamps", lamps()),
        ("overlapping", overlapping()),
        ("below-the-floor", below_the_floor()),
        ("inside-an-ellipsoid", inside_an_ellipsoid()),
        ("crowd-1", crowd(1)),
        ("crowd-2", crowd(2)),
    ]
}

/// Returns fifty objects of every kind and type before the observer, large and small, with three lamps: another scene
/// for each seed.
#[must_use]
pub fn crowd(seed: u64) -> Description {
    let mut dice = Dice::new(seed);
    let mut scene = ground([0.0, -22.0, 7.0], [0.0, 1.0, -0.22]);
    for kind in 0..50 {
        let radius = dice.between(0.25, 1.6);
        let x = dice.between(-11.0, 11.0);
        let y = dice.between(-12.0, 16.0);
        let position = [x, y, radius * dice.between(0.6, 4.0)];
        let (color, surface) = (dice.color(), dice.surface());
        match kind % 10 {
            0 => scene.cylinders.push(cylinder([x, y], radius / 4.0, color, surface)),
            1..4 => {
                let radii = [radius, radius * dice.between(0.4, 1.2), radius * dice.between(0.4, 1.2)];
                scene.ellipsoids.push(ellipsoid(position, radii, color, surface));
            }
            _ => scene.spheres.push(sphere(position, radius, color, surface)),
        }
    }
    scene.lamps = vec![
        lamp([-18.0, -20.0, 24.0], [420.0, 400.0, 360.0], 1.0),
        lamp([20.0, -10.0, 15.0], [90.0, 100.0, 140.0], 0.8),
        lamp([2.0, 25.0, 12.0], [80.0, 60.0, 40.0], 0.6),
    ];
    scene
}

/// Rows of spheres, ellipsoids and cylinders, and columns of the four types of surface.
fn every_type() -> Description {
    let mut dice = Dice::new(11);
    let mut scene = ground([0.0, -13.0, 4.5], [0.0, 1.0, -0.25]);
    for (column, surface) in
        [Surface::Opaque, Surface::Shiny, Surface::Mirror, glass(0.1, 1.5)].into_iter().enumerate()
    {
        let x = 2.6 * column as f64 - 3.9;
        scene.spheres.push(sphere([x, -3.0, 1.0], 1.0, dice.color(), surface));
        scene.ellipsoids.push(ellipsoid([x, 0.7, 1.3], [1.0, 0.7, 1.3], dice.color(), surface));
        scene.cylinders.push(cylinder([x + 0.3, 5.0], 0.5, dice.color(), surface));
    }
    scene
}

/// Twenty coloured lamps in a ring, some of which have a size and are seen.
fn many_lamps() -> Description {
    let mut dice = Dice::new(14);
    let mut scene = ground([0.0, -16.0, 8.0], [0.0, 1.0, -0.42]);
    scene.lamps.clear();
    for index in 0..20 {
        let angle = f64::from(index) * TAU / 20.0;
        let position = [9.0 * angle.cos(), 9.0 * angle.sin(), dice.between(3.0, 7.0)];
        let color = dice.color().map(|part| 7.0 * part);
        scene.lamps.push(lamp(position, color, if index % 3 == 0 { 0.0 } else { 0.35 }));
    }
    for _ in 0..14 {
        let radius = dice.between(0.4, 1.1);
        let position = [dice.between(-6.0, 6.0), dice.between(-5.0, 6.0), radius * 1.3];
        scene.spheres.push(sphere(position, radius, dice.color(), dice.surface()));
    }
    scene
}

/// The direction of view is parallel to the zenith, downwards.
fn straight_down() -> Description {
    let mut dice = Dice::new(15);
    let mut scene = ground([0.5, 0.25, 18.0], [0.0, 0.0, -3.0]);
    scatter(&mut scene, &mut dice, 18, [-7.0, 7.0], [-5.0, 5.0], [0.8, 6.0]);
    scene.cylinders.push(cylinder([-3.0, 2.0], 0.8, dice.color(), Surface::Opaque));
    scene.cylinders.push(cylinder([3.5, -2.5], 1.0, dice.color(), Surface::Mirror));
    scene.cylinders.push(cylinder([3.0, 3.0], 1.0, [0.9; 3], glass(0.1, 1.5)));
    scene
}

/// The direction of view is parallel to the zenith, upwards.
fn straight_up() -> Description {
    let mut dice = Dice::new(16);
    let mut scene = ground([0.5, 0.25, 1.0], [0.0, 0.0, 0.5]);
    scatter(&mut scene, &mut dice, 18, [-7.0, 7.0], [-5.0, 5.0], [8.0, 20.0]);
    scene.cylinders.push(cylinder([-3.0, 2.0], 0.8, dice.color(), Surface::Opaque));
    scene.lamps =
        vec![lamp([6.0, -5.0, 3.0], [90.0, 90.0, 80.0], 0.3), lamp([-2.0, 0.5, 30.0], [60.0; 3], 1.0)];
    scene
}

/// A ring of columns, every other one a mirror, with things between them.
fn mirror_cylinders() -> Description {
    let mut dice = Dice::new(17);
    let mut scene = ground([0.0, -11.0, 3.0], [0.0, 1.0, -0.1]);
    for index in 0..10 {
        let angle = (f64::from(index) + 0.5) * TAU / 10.0;
        let center = [7.0 * angle.sin(), 7.0 * angle.cos()];
        let surface = if index % 2 == 0 { Surface::Mirror } else { dice.solid() };
        scene.cylinders.push(cylinder(center, 1.0, dice.color(), surface));
    }
    scatter(&mut scene, &mut dice, 8, [-4.0, 4.0], [-4.0, 4.0], [0.6, 3.0]);
    scene.lamps =
        vec![lamp([0.0, -4.0, 10.0], [70.0, 66.0, 60.0], 0.5), lamp([1.0, 4.0, 6.0], [20.0; 3], 0.0)];
    scene
}

/// Lamps that are seen and that are not, in glass, in a solid, below the floor, and in a mirror.
fn lamps() -> Description {
    let mut scene = ground([0.0, -13.0, 4.0], [0.0, 1.0, -0.15]);
    scene.lamps = vec![
        lamp([-4.0, 0.0, 3.0], [9.0, 7.0, 3.0], 0.7),
        lamp([4.0, 1.0, 4.0], [5.0, 7.0, 12.0], 0.0),
        lamp([0.0, 2.0, 2.0], [8.0, 3.0, 3.0], 0.4),
        lamp([2.0, -4.0, 1.0], [30.0, 30.0, 30.0], 0.3),
        lamp([0.0, -2.0, -3.0], [50.0, 50.0, 50.0], 1.0),
        lamp([0.0, -12.0, 14.0], [60.0, 60.0, 60.0], 1.5),
    ];
    // The third lamp shines out of glass, the fourth is shut into a solid.
    scene.spheres = vec![
        sphere([0.1, 2.1, 2.1], 1.5, [0.9; 3], glass(0.1, 1.1)),
        sphere([2.0, -4.0, 1.1], 0.8, [0.8, 0.5, 0.3], Surface::Shiny),
        sphere([-3.0, -4.0, 1.2], 1.2, [0.9, 0.9, 1.0], Surface::Mirror),
        sphere([5.0, -2.0, 1.0], 1.0, [0.4, 0.8, 0.4], Surface::Opaque),
        sphere([-7.0, 1.0, 1.5], 1.0, [0.8, 0.3, 0.6], Surface::Shiny),
    ];
    scene.ellipsoids = vec![ellipsoid([0.0, 7.0, 3.0], [5.0, 0.5, 2.5], [0.8; 3], Surface::Mirror)];
    scene
}

/// Objects that go through each other and through the floor.
fn overlapping() -> Description {
    let mut dice = Dice::new(21);
    let mut scene = ground([0.0, -12.0, 5.0], [0.0, 1.0, -0.35]);
    for x in [-5.0, -1.7, 1.7, 5.0] {
        for part in 0..4 {
            let position = [x + dice.between(-0.7, 0.7), dice.between(-0.7, 0.7), dice.between(-0.3, 2.0)];
            let (color, surface) = (dice.color(), dice.surface());
            if part % 2 == 0 {
                scene.spheres.push(sphere(position, dice.between(0.7, 1.2), color, surface));
            } else {
                let radii = [dice.between(0.5, 1.5), dice.between(0.5, 1.5), dice.between(0.5, 1.5)];
                scene.ellipsoids.push(ellipsoid(position, radii, color, surface));
            }
        }
        scene.cylinders.push(cylinder([x + 0.2, 0.3], 0.3, dice.color(), dice.surface()));
    }
    scene
}

/// The observer and most objects are under the floor.
fn below_the_floor() -> Description {
    let mut dice = Dice::new(22);
    // Odd numbers: with round ones a whole row of pixels may lie on the edge of a row of tiles.
    let mut scene = ground([0.1, -13.21, -5.07], [0.0, 1.0, 0.2]);
    scatter(&mut scene, &mut dice, 16, [-6.0, 6.0], [-4.0, 6.0], [-6.0, 1.0]);
    scene.cylinders.push(cylinder([5.5, 6.0], 0.7, dice.color(), Surface::Mirror));
    scene.lamps =
        vec![lamp([-7.0, -11.0, -9.0], [150.0, 140.0, 130.0], 1.0), lamp([0.0, 0.0, 8.0], [90.0; 3], 0.5)];
    scene
}

/// Everything is inside one large ellipsoid, whose inner side is seen and lit.
fn inside_an_ellipsoid() -> Description {
    let mut dice = Dice::new(23);
    let mut scene = ground([0.0, -12.0, 4.0], [0.0, 1.0, -0.08]);
    scene.ellipsoids.push(ellipsoid([0.0, 0.0, 2.0], [14.0, 17.0, 11.0], [0.7, 0.7, 0.8], Surface::Shiny));
    scatter(&mut scene, &mut dice, 14, [-7.0, 7.0], [-5.0, 8.0], [0.6, 5.0]);
    scene.lamps =
        vec![lamp([-5.0, -6.0, 9.0], [70.0, 66.0, 60.0], 0.0), lamp([7.0, 0.0, 6.0], [16.0; 3], 0.5)];
    scene
}

/// Returns an empty floor with a sky and two lamps, seen from `eye` in the direction `view`.
fn ground(eye: [f64; 3], view: [f64; 3]) -> Description {
    Description {
        lamps: vec![
            lamp([-9.0, -14.0, 13.0], [180.0, 175.0, 160.0], 0.8),
            lamp([10.0, -6.0, 9.0], [40.0, 45.0, 60.0], 0.5),
        ],
        floor: Some(Floor { colors: [[0.85, 0.8, 0.7], [0.2, 0.25, 0.35]], surface: Surface::Opaque }),
        ambient: [0.3, 0.3, 0.32],
        sky: Sky { horizon: [0.75, 0.8, 0.9], zenith: [0.15, 0.3, 0.65] },
        ..Description::empty(Camera::upright(eye, view, 1.0))
    }
}

/// Adds `count` spheres and ellipsoids of every type within the given bounds.
fn scatter(scene: &mut Description, dice: &mut Dice, count: u32, x: [f64; 2], y: [f64; 2], z: [f64; 2]) {
    for index in 0..count {
        let position = [x, y, z].map(|[least, most]| dice.between(least, most));
        let (color, surface) = (dice.color(), dice.surface());
        if index % 3 == 0 {
            let radii = [dice.between(0.4, 1.3), dice.between(0.4, 1.3), dice.between(0.4, 1.3)];
            scene.ellipsoids.push(ellipsoid(position, radii, color, surface));
        } else {
            scene.spheres.push(sphere(position, dice.between(0.4, 1.2), color, surface));
        }
    }
}

fn sphere(position: [f64; 3], radius: f64, color: [f64; 3], surface: Surface) -> Sphere {
    Sphere { position, color, radius, surface, line: 0 }
}

fn ellipsoid(position: [f64; 3], radii: [f64; 3], color: [f64; 3], surface: Surface) -> Ellipsoid {
    Ellipsoid { position, color, radii, inside_only: false, surface, line: 0 }
}

fn cylinder([x, y]: [f64; 2], radius: f64, color: [f64; 3], surface: Surface) -> Cylinder {
    Cylinder { position: [x, y, 0.0], color, radius, surface, line: 0 }
}

fn lamp(position: [f64; 3], color: [f64; 3], radius: f64) -> Lamp {
    Lamp { position, color, radius, fall_off: FallOff::OfModel, line: 0 }
}

fn glass(ks: f64, ior: f64) -> Surface {
    Surface::Transparent { ks, kt: 1.0 - ks, ior }
}

/// A seeded generator of random numbers, rounded to thousandths so that a scene written to a file stays readable.
struct Dice(fastrand::Rng);

impl Dice {
    fn new(seed: u64) -> Self {
        Self(fastrand::Rng::with_seed(seed))
    }

    fn between(&mut self, least: f64, most: f64) -> f64 {
        ((least + (most - least) * self.0.f64()) * 1000.0).round() / 1000.0
    }

    fn color(&mut self) -> [f64; 3] {
        [self.between(0.2, 0.95), self.between(0.2, 0.95), self.between(0.2, 0.95)]
    }

    /// Returns opaque, shiny or a mirror.
    fn solid(&mut self) -> Surface {
        match self.0.u8(0..3) {
            0 => Surface::Opaque,
            1 => Surface::Shiny,
            _ => Surface::Mirror,
        }
    }

    /// Returns any of the four types, glass with random coefficients.
    fn surface(&mut self) -> Surface {
        if self.0.u8(0..4) == 0 {
            let ks = self.between(0.0, 0.4);
            glass(ks, self.between(0.7, 2.0))
        } else {
            self.solid()
        }
    }
}
