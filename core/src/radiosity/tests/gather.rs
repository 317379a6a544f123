use super::{Faces, furnace, room_g, shine};
use crate::color::Rgb;
use crate::needs::Everything;
use crate::radiosity::{Balance, Casts, HemiCube, Rays, Solver, Stop};
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

/// Returns room G of 3 x 3 patches a wall, six quadrilaterals, and for each patch its number there where each is one of its own.
fn room_of_six<S: Read>() -> (Faces<S>, [usize; 54]) {
    let mut faces = Faces::<S>::cube(3, false, |face, _| room_g(3)(face, 4));
    faces.quads[1].emitting = [[1, 1], [2, 2]];
    // Walls whose u goes along the second axis, so that they face inwards.
    let name = |number: usize| match number / 9 {
        face @ (1 | 3 | 4) => face * 9 + number % 3 * 3 + number % 9 / 3,
        _ => number,
    };
    (faces, core::array::from_fn(name))
}

/// Returns the rms error over the mean of B of the patches that do not emit, in room G, n 3, with as exact a light of lamps as that of all.
fn error<C: Casts<f64>>(exact: &[[f64; 3]], casts: C, lamps_first: bool) -> f64 {
    let (faces, names) = room_of_six::<f64>();
    let scene = faces.scene();
    let solver = Solver::<f64, Everything, _>::new(&scene, faces.mesh(), casts, 0);
    let solver = if lamps_first { solver } else { solver.by_rays_alone() };
    let arriving = names.map(|name| {
        let factor = if lamps_first { super::room::exact(3, (name / 9, name % 9), (1, 4)) } else { 0.0 };
        Rgb::new(factor, factor, factor)
    });
    let mut reflected = [Rgb::BLACK; 54];
    let stop = Stop { sweeps: 40, bits: 20 };
    stop.repeat(|| solver.sweep(&mut reflected, Some(&arriving), 20)).expect("there is room");
    rms(&reflected, exact, names)
}

/// Returns the rms error over the mean of B of the patches that do not emit.
fn rms(reflected: &[Rgb<f64>], exact: &[[f64; 3]], names: [usize; 54]) -> f64 {
    let (mut squares, mut sum) = (0.0, 0.0);
    for (found, name) in reflected.iter().zip(names).filter(|(_, name)| *name != 9 + 4) {
        for (found, exact) in shine::<f64>(*found).iter().zip(exact[name]) {
            squares += (found - exact) * (found - exact);
            sum += exact;
        }
    }
    let count = 53.0 * 3.0;
    libm::sqrt(squares / count) / (sum / count)
}

#[test]
fn lamps_first_are_worth_a_hundred_times_as_many_rays() {
    let exact = super::room::by_gauss::<f64>(3);
    let mean = |count: u32, lamps_first: bool, seeds: u32| {
        let errors = (0..seeds).map(|seed| error(&exact, Rays { count, seed }, lamps_first));
        libm::sqrt(errors.map(|error| error * error).sum::<f64>() / f64::from(seeds))
    };
    // The errors of the table, within one and a half times.
    let close = |found: f64, stated: f64| {
        assert!(found < 1.5 * stated && found > stated / 1.5, "{found}, {stated}");
    };
    for (count, stated, seeds) in [(16, 0.042, 8), (64, 0.018, 8), (256, 0.0090, 4), (1024, 0.0051, 2)] {
        close(mean(count, true, seeds), stated);
    }
    for (count, stated, seeds) in [(16, 0.965, 8), (64, 0.444, 8), (256, 0.186, 4)] {
        close(mean(count, false, seeds), stated);
    }
    for (side, most) in [(10, 0.0128), (50, 0.0034)] {
        // Who owns cells whose middle is on an edge decides how good a hemi-cube is.
        let found = error(&exact, HemiCube::new(side).expect("it is even"), true);
        assert!(found < 2.0 * most, "{side}: {found}, {most}");
    }
}

#[test]
fn the_usual_solver_is_within_three_percent() {
    let exact = super::room::by_gauss::<f64>(3);
    let (faces, names) = room_of_six::<f64>();
    let scene = faces.scene();
    let mut squares = 0.0;
    for seed in 0..8 {
        let solver = Solver::<f64, Everything, _>::new(&scene, faces.mesh(), Rays { count: 64, seed }, seed);
        let mut reflected = [Rgb::BLACK; 54];
        let outcome = solver.solve(&mut reflected, None, Stop::default()).expect("there is room");
        assert!(outcome.is_done);
        let error = rms(&reflected, &exact, names);
        squares += error * error;
    }
    let error = libm::sqrt(squares / 8.0);
    assert!(error < 1.5 * 0.026 && error > 0.026 / 1.5, "{error}");
}

/// Returns by what part more is absorbed in room G than is emitted, at most of three registers, or the rounding of the format.
fn excess<S: Read>(n: u16, places: u16) -> f64 {
    let mut faces = Faces::<S>::cube(n, false, |face, _| room_g(3)(face, 4));
    faces.quads[1].emitting = [[n / 3; 2], [2 * n / 3; 2]];
    let scene = faces.scene();
    let rays = Rays { count: 64, seed: 3 };
    let solver = Solver::<S, Everything, _>::new(&scene, faces.mesh(), rays, 4).with_places(places);
    let (mut reflected, mut arriving) = (vec![Rgb::BLACK; 216], vec![Rgb::BLACK; 216]);
    solver.solve(&mut reflected, Some(&mut arriving), Stop::default()).expect("there is room");
    let Balance { emitted, absorbed } = solver.balance(&reflected, Some(&arriving));
    let both = shine::<S>(emitted).into_iter().zip(shine::<S>(absorbed));
    both.map(|(emitted, absorbed)| {
        assert!((emitted - 1.0 / 54.0).abs() < 1e-5, "{emitted}");
        (absorbed / emitted - 1.0).abs()
    })
    .fold(0.0, f64::max)
}

#[test]
fn what_is_emitted_is_absorbed_within_a_hundredth() {
    for (n, places) in [(6, 2), (3, 4)] {
        let excess = excess::<f64>(n, places);
        assert!(excess < 0.01, "{n}: {excess}");
    }
    let excess = excess::<Q16>(6, 2);
    assert!(excess < 0.01, "in Q16: {excess}");
}
