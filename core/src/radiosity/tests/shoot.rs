//! Factors by discs and by hemi-cubes for patches that shoot.

use super::room::{by_gauss, exact};
use super::{Faces, furnace, room_g, shine};
use crate::color::Rgb;
use crate::needs::Everything;
use crate::radiosity::{HemiCube, Patch, Rays, Shooter, Solver};
use crate::scalar::read::Read;
use crate::scalar::{Light, Unit};
use crate::{Q16, Q20};

extern crate std;
use std::vec;
use std::vec::Vec;

/// Shoots until less than a thousandth of what was emitted is left, each factor by discs; returns B and the number of shots.
fn by_discs<S: Read>() -> (Vec<[f64; 3]>, u32) {
    let faces = Faces::<S>::cube(3, true, room_g(3));
    let scene = faces.scene();
    let solver = Solver::<S, Everything, _>::new(&scene, faces.mesh(), Rays { count: 1, seed: 0 }, 0);
    let (mut light, mut unshot) = (vec![Rgb::BLACK; 54], vec![Rgb::BLACK; 54]);
    let mut shooter = Shooter::new(faces.mesh(), &mut light, &mut unshot).expect("there is room");
    let (mut shots, end) = (0, S::Light::WHITE.times(S::Unit::ratio(1, 1000)));
    while shooter.left() >= end {
        let Some(source) = shooter.next() else { break };
        shooter.shoot(source, |receiver| solver.disc_factor(receiver, source, &mut ()));
        shots += 1;
    }
    assert_eq!(shooter.clamped(), 0);
    (light.into_iter().map(shine::<S>).collect(), shots)
}

#[test]
fn shooting_by_discs_comes_near_in_every_format() {
    let exact = by_gauss::<f64>(3);
    let (found, shots) = by_discs::<f64>();
    // Exact factors leave 0.00966 after 200 shots.
    assert!((250..500).contains(&shots), "{shots}");
    let mean = |light: &[[f64; 3]]| light.iter().flatten().sum::<f64>();
    let (ours, theirs) = (mean(&found), mean(&exact));
    assert!((ours / theirs - 1.0).abs() < 0.02, "{ours}, {theirs}");
    for fixed in [by_discs::<Q16>().0, by_discs::<Q20>().0, by_discs::<f32>().0] {
        for (fixed, found) in fixed.iter().flatten().zip(found.iter().flatten()) {
            assert!((fixed - found).abs() < 3e-3, "{fixed}, {found}");
        }
    }
}

#[test]
fn factors_by_discs_are_near_the_exact_ones() {
    let faces = Faces::<f64>::cube(3, true, furnace(0.5, 1.0));
    let scene = faces.scene();
    let solver = Solver::<f64, Everything, _>::new(&scene, faces.mesh(), Rays { count: 1, seed: 0 }, 0);
    let name = |quad: usize| (quad / 9, quad % 9);
    let patch = |quad: usize| Patch { quad, cell: [0, 0] };
    for receiver in [0, 4, 13, 40] {
        let mut sum = 0.0;
        for source in 0..54 {
            let factor = solver.disc_factor(patch(receiver), patch(source), &mut ());
            let truth = exact(3, name(receiver), name(source));
            // Side by side they differ most: that of a place is not that of a patch.
            assert!((factor - truth).abs() < 0.01 + 0.25 * truth, "{receiver}, {source}: {factor}, {truth}");
            sum += factor;
        }
        assert!((sum - 1.0).abs() < 0.05, "{receiver}: {sum}");
    }
    assert_eq!(solver.disc_factor(patch(0), patch(1), &mut ()), 0.0, "in one plane");
    assert_eq!(solver.disc_factor(patch(0), patch(54), &mut ()), 0.0, "none such");
}

#[test]
fn a_shot_by_a_hemi_cube_is_one_by_rows() {
    let faces = Faces::<f64>::cube(3, true, room_g(3));
    let scene = faces.scene();
    let cube = HemiCube::new(50).expect("it is even");
    let solver = Solver::<f64, Everything, _>::new(&scene, faces.mesh(), cube, 0);
    let (mut light, mut unshot) = (vec![Rgb::BLACK; 54], vec![Rgb::BLACK; 54]);
    let mesh = faces.mesh();
    let mut shooter = Shooter::new(mesh, &mut light, &mut unshot).expect("there is room");
    let source = shooter.next().expect("light is left");
    assert_eq!(source, Patch { quad: 13, cell: [0, 0] });
    let mut row = [0.0; 54];
    solver.factors(source, &mut row).expect("there is room");
    shooter.shoot(source, |receiver| mesh.turned(receiver, source, &row));
    // All patches are equally large: what arrives is the factor, of which white reflects 0.7.
    for (number, light) in shooter.light().iter().enumerate().filter(|(number, _)| *number < 9) {
        assert!((light.r - 0.7 * row[number]).abs() < 1e-12);
    }
    // All is sent, in a closed room.
    let sum: f64 = row.iter().sum();
    assert!((sum - 1.0).abs() < 1e-12, "{sum}");
    assert_ne!(shooter.next(), Some(source));
}

#[test]
fn equal_patches_shoot_in_order() {
    let faces = Faces::<Q16>::cube(2, false, furnace(0.5, 1.0));
    let (mut light, mut unshot) = (vec![Rgb::BLACK; 24], vec![Rgb::BLACK; 24]);
    let mesh = faces.mesh();
    let mut shooter = Shooter::new(mesh, &mut light, &mut unshot).expect("there is room");
    for number in 0..3 {
        let source = shooter.next().expect("light is left");
        assert_eq!(mesh.number(source), Some(number));
        shooter.shoot(source, |_| Unit::ZERO);
    }
    // More than all is counted, and is as much as all.
    let source = shooter.next().expect("light is left");
    shooter.shoot(source, |_| <Q16 as crate::Scalar>::Unit::from_num(1.5));
    assert_eq!(shooter.clamped(), 23);
    assert_eq!(shine::<Q16>(shooter.light()[0]), [1.5; 3]);
    assert!(Shooter::new(mesh, &mut light[1..], &mut unshot).is_err());
}
