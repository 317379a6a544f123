use super::{Faces, furnace, room_g, shine};
use crate::color::Rgb;
use crate::needs::Everything;
use crate::radiosity::{HemiCube, Rays, Solver, Stop};
use crate::scalar::read::Read;
use crate::{Q16, Q20};

extern crate std;
use std::vec;
use std::vec::Vec;

const RAYS: Rays = Rays { count: 16, seed: 5 };
const STILL: Stop = Stop { sweeps: 400, bits: Stop::STILL };

/// Solves a closed room in which B is 2 everywhere, by rays alone and by the cells of a hemi-cube.
fn in_furnace<S: Read>(rounding: f64) {
    let faces = Faces::<S>::cube(2, false, furnace(0.5, 1.0));
    let scene = faces.scene();
    let mut reflected = vec![Rgb::BLACK; 24];
    let by_rays = Solver::<S, Everything, _>::new(&scene, faces.mesh(), RAYS, 0).by_rays_alone();
    let outcome = by_rays.solve(&mut reflected, None, STILL).expect("there is room");
    assert!(outcome.is_done, "{outcome:?}");
    let check = |reflected: &[Rgb<S::Light>]| {
        for light in reflected {
            let worst = shine::<S>(*light).iter().map(|b| (b - 1.0).abs()).fold(0.0, f64::max);
            assert!(worst <= rounding, "{worst}");
        }
    };
    check(&reflected);
    let cube = HemiCube::new(6).expect("it is even");
    let by_cells = Solver::<S, Everything, _>::new(&scene, faces.mesh(), cube, 0).by_rays_alone();
    by_cells.solve(&mut reflected, None, STILL).expect("there is room");
    check(&reflected);
}

#[test]
fn a_furnace_is_alike_everywhere_in_every_format() {
    in_furnace::<f64>(1e-12);
    in_furnace::<f32>(1e-6);
    in_furnace::<Q16>(2.0 / 65_536.0);
    in_furnace::<Q20>(2.0 / 65_536.0);
}

#[test]
fn more_sweeps_of_what_is_still_change_nothing() {
    let faces = Faces::<Q16>::cube(3, true, room_g(3));
    let scene = faces.scene();
    let solver = Solver::<Q16, Everything, _>::new(&scene, faces.mesh(), RAYS, 7);
    let (mut reflected, mut arriving) = (vec![Rgb::BLACK; 54], vec![Rgb::BLACK; 54]);
    solver.solve(&mut reflected, Some(&mut arriving), STILL).expect("there is room");
    let still = reflected.clone();
    for _ in 0..20 {
        solver.sweep(&mut reflected, Some(&arriving), Stop::STILL).expect("there is room");
    }
    assert_eq!(reflected, still);
    // What is not kept is the same when computed anew.
    let mut anew = vec![Rgb::BLACK; 54];
    solver.solve(&mut anew, None, STILL).expect("there is room");
    assert_eq!(anew, still);
    assert!(solver.solve(&mut anew[1..], None, STILL).is_err());
    assert!(solver.solve(&mut anew, Some(&mut arriving[1..]), STILL).is_err());
}

#[test]
fn the_usual_stop_is_soon_and_says_what_is_left() {
    let faces = Faces::<Q16>::cube(3, true, room_g(3));
    let scene = faces.scene();
    let solver = Solver::<Q16, Everything, _>::new(&scene, faces.mesh(), RAYS, 7);
    let mut reflected = vec![Rgb::BLACK; 54];
    let outcome = solver.solve(&mut reflected, None, Stop::default()).expect("there is room");
    assert!(outcome.is_done && (3..=12).contains(&outcome.sweeps), "{outcome:?}");
    let once = solver.solve(&mut reflected, None, Stop { sweeps: 1, bits: 12 }).expect("there is room");
    assert!(!once.is_done && once.sweeps == 1 && once.change > outcome.change);
}

/// Formats agree on what is gathered: all but a few rays meet the same patches.
fn beside_f64<S: Read>(tolerance: f64) {
    fn solved<S: Read>() -> Vec<[f64; 3]> {
        let faces = Faces::<S>::cube(3, true, room_g(3));
        let scene = faces.scene();
        let solver = Solver::<S, Everything, _>::new(&scene, faces.mesh(), RAYS, 7);
        let mut reflected = vec![Rgb::BLACK; 54];
        solver.solve(&mut reflected, None, Stop::default()).expect("there is room");
        reflected.into_iter().map(shine::<S>).collect()
    }
    for (own, exact) in solved::<S>().iter().zip(solved::<f64>()) {
        for (own, exact) in own.iter().zip(exact) {
            assert!((own - exact).abs() < tolerance, "{own}, {exact}");
        }
    }
}

#[test]
fn formats_agree() {
    beside_f64::<f32>(2e-3);
    beside_f64::<Q16>(2e-3);
    beside_f64::<Q20>(2e-3);
}
