//! Scenes of glass: in glass, around the observer, as columns and as lenses.

use core::f64::consts::TAU;

use rta_scenes::description::{Description, Surface};

use super::{Dice, cylinder, ellipsoid, glass, ground, sphere};

/// Glass around bubbles around glass around something solid.
pub(super) fn glass_in_glass() -> Description {
    let mut dice = Dice::new(12);
    let mut scene = ground([0.0, -9.0, 3.0], [0.0, 1.0, -0.12]);
    let white = [0.95; 3];
    for (radius, surface) in
        [(2.0, glass(0.05, 1.5)), (1.5, glass(0.05, 0.75)), (1.0, glass(0.05, 1.4)), (0.5, Surface::Shiny)]
    {
        let color = if surface == Surface::Shiny { [0.9, 0.3, 0.1] } else { white };
        scene.spheres.push(sphere([-1.6, 0.0, 2.1], radius, color, surface));
    }
    // Off centre, two bubbles in one sphere.
    scene.spheres.push(sphere([2.6, -0.5, 1.6], 1.5, white, glass(0.1, 1.33)));
    scene.spheres.push(sphere([2.2, -0.7, 1.9], 0.5, white, glass(0.1, 1.0 / 1.33)));
    scene.spheres.push(sphere([3.1, -0.4, 1.2], 0.4, white, Surface::Mirror));
    for index in 0..5 {
        let x = 3.0 * f64::from(index) - 6.0;
        scene.spheres.push(sphere([x, 6.0, 1.0], 1.0, dice.color(), Surface::Opaque));
    }
    scene
}

/// The observer sits off the centre of a glass sphere that is among others.
pub(super) fn eye_in_glass() -> Description {
    let mut dice = Dice::new(13);
    let mut scene = ground([0.4, -5.8, 2.7], [0.05, 1.0, -0.1]);
    scene.spheres.push(sphere([0.0, -6.0, 2.5], 2.0, [0.9; 3], glass(0.1, 1.2)));
    for index in 0..7 {
        let angle = f64::from(index) * TAU / 7.0;
        let position = [5.5 * angle.cos(), 5.5 * angle.sin(), 1.2];
        scene.spheres.push(sphere(position, 1.2, dice.color(), dice.solid()));
    }
    scene
}
/// Columns of glass, water and air, one within another, before solid things.
pub(super) fn glass_cylinders() -> Description {
    let mut dice = Dice::new(18);
    let mut scene = ground([0.0, -10.0, 3.0], [0.0, 1.0, -0.15]);
    let indices = [(0.05, 1.5), (0.3, 1.33), (0.1, 0.8), (0.0, 1.0), (0.2, 2.4)];
    for (column, (ks, ior)) in indices.into_iter().enumerate() {
        let x = 2.2 * column as f64 - 4.4;
        scene.cylinders.push(cylinder([x, -1.0], 0.8, [0.9, 0.95, 0.9], glass(ks, ior)));
    }
    scene.cylinders.push(cylinder([-4.3, -1.1], 0.4, [0.9; 3], glass(0.05, 1.0 / 1.5)));
    for index in 0..8 {
        let x = 2.0 * f64::from(index) - 7.0;
        scene.spheres.push(sphere([x, 4.0, 1.5], 0.8, dice.color(), dice.solid()));
    }
    scene
}

/// Lenses, needles and bubbles.
pub(super) fn glass_ellipsoids() -> Description {
    let mut dice = Dice::new(19);
    let mut scene = ground([0.0, -10.0, 3.2], [0.0, 1.0, -0.17]);
    for (x, z, radii, ks, ior) in [
        (-4.2, 1.6, [1.4, 0.4, 1.4], 0.05, 1.5),
        (-1.4, 1.7, [0.5, 0.5, 1.6], 0.2, 1.33),
        (0.9, 1.2, [1.2, 1.2, 0.5], 0.1, 1.8),
        (3.6, 1.5, [1.2, 0.8, 1.4], 0.1, 0.7),
        (0.8, 3.2, [0.8, 0.6, 0.7], 0.4, 0.9),
    ] {
        scene.ellipsoids.push(ellipsoid([x, -1.0, z], radii, [0.95, 0.95, 0.9], glass(ks, ior)));
    }
    for index in 0..8 {
        let (x, color, surface) = (2.0 * f64::from(index) - 7.0, dice.color(), dice.solid());
        scene.ellipsoids.push(ellipsoid([x, 4.0, 1.5], [0.8, 0.6, 1.2], color, surface));
    }
    scene
}
