//! Rays that are lost, and rays that go on through mirrors and glass.

use super::{Faces, Wall, furnace, on_face};
use crate::Q16;
use crate::material::{Glass, Material};
use crate::needs::Everything;
use crate::radiosity::exact::{offset_parallel, parallel};
use crate::radiosity::{Patch, Rays, Solver};
use crate::scalar::Unit;
use crate::scalar::read::Read;
use crate::scene::Scene;

extern crate std;
use std::vec;
use std::vec::Vec;

const RAYS: Rays = Rays { count: 4096, seed: 2 };

/// Returns the form factors from the floor, quadrilateral 0, in a scene with these materials.
fn floor_row<S: Read>(faces: &Faces<S>, materials: &[Material<S>]) -> Vec<f64> {
    let scene = Scene { materials, ..faces.bare() }.admit(&super::camera::<S>()).expect("it fits");
    let mut row = vec![S::Unit::ZERO; faces.quads.len()];
    let solver = Solver::<S, Everything, _>::new(&scene, faces.mesh(), RAYS, 0);
    solver.factors(Patch { quad: 0, cell: [0, 0] }, &mut row).expect("there is room");
    row.into_iter().map(S::read).collect()
}

fn close(found: f64, exact: f64, tolerance: f64) {
    assert!((found - exact).abs() < tolerance, "{found}, {exact}");
}

/// The unit cube, with other faces in place of those of which `other` tells material and colour.
fn cube<S: Read>(other: impl Fn(usize) -> Option<(u16, [f64; 3])>) -> Faces<S> {
    let mut faces = Faces::new();
    for face in 0..6 {
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|at| on_face(face, at));
        let [a, b, c, d] = corners;
        let corners = if matches!(face, 1 | 3 | 4) { [a, d, c, b] } else { corners };
        match other(face) {
            Some((material, color)) => faces.bare_face(corners, color, material),
            None => faces.push(corners, [1, 1], furnace(0.5, 0.0)(0, 0)),
        }
    }
    faces
}

fn through_a_mirror<S: Read>(rounding: f64) {
    let faces = cube::<S>(|face| (face == 5).then_some((0, [1.0; 3])));
    let row = floor_row(&faces, &[Material::Mirror]);
    // The ceiling, and its image: a room of twice the depth, whose floor and ceiling belong together.
    let unit = [0.0, 1.0];
    close(row[1], offset_parallel(unit, unit, unit, [0.0, 2.0], 1.0), 0.015);
    close(row.iter().sum::<f64>(), 1.0 - row[0], rounding + row[0]);
    // The mirror shows the floor nothing of itself.
    close(row[0], 0.0, 1e-12);
    // One that keeps a part.
    let dim = floor_row(&cube::<S>(|face| (face == 5).then_some((0, [0.5; 3]))), &[Material::Mirror]);
    let lost = 1.0 - dim.iter().sum::<f64>();
    close(lost, 0.5 * crate::radiosity::exact::perpendicular(1.0, 1.0, 1.0), 0.015);
}

#[test]
fn a_mirror_doubles_a_room() {
    through_a_mirror::<f64>(1e-12);
    // A ray that begins a few LSB from an edge may begin beyond it.
    through_a_mirror::<Q16>(1e-3);
}

#[test]
fn light_between_mirrors_is_followed_four_times() {
    let faces = cube::<f64>(|face| (face >= 2).then_some((0, [1.0; 3])));
    let row = floor_row(&faces, &[Material::Mirror]);
    let sum: f64 = row.iter().sum();
    assert!(row[1] > 0.6 && sum > 0.6 && sum < 0.999, "{row:?}");
    // Nothing comes back to the floor but by the ceiling.
    close(row[0], 0.0, 1e-12);
}

#[test]
fn glass_lets_its_part_through() {
    let pane = |height: f64| [[0.0, 0.0, height], [1.0, 0.0, height], [1.0, 1.0, height], [0.0, 1.0, height]];
    let glass = |kt: f64| Material::Transparent(Glass { kt, ks: 0.0, eta: 1.0, denser: true });
    let exact = parallel(1.0, 1.0, 1.0);
    for (panes, part) in [(1, 0.8), (4, 0.4096), (5, 0.0)] {
        let mut faces = cube::<f64>(|_| None);
        (0..panes).for_each(|k| faces.bare_face(pane(0.1 + 0.15 * f64::from(k)), [1.0; 3], 0));
        close(floor_row(&faces, &[glass(0.8)])[1], part * exact, 0.015);
    }
}

#[test]
fn what_is_met_from_behind_or_has_no_patches_brings_nothing() {
    let mut faces = cube::<f64>(|_| None);
    let below = [[0.0, 0.0, 0.999], [0.0, 1.0, 0.999], [1.0, 1.0, 0.999], [1.0, 0.0, 0.999]];
    let open = floor_row(&faces, &[]);
    // Just below the ceiling, and seen by it from behind: it hides the ceiling from the floor.
    faces.push(below, [1, 1], Wall { reflectance: [0.5; 3], emission: [1.0; 3] });
    let row = floor_row(&faces, &[]);
    close(row[1], 0.0, 2e-3);
    close(row[6], open[1], 2e-3);
    let scene = faces.scene();
    let solver = Solver::<f64, Everything, _>::new(&scene, faces.mesh(), RAYS, 0);
    let ceiling = Patch { quad: 1, cell: [0, 0] };
    assert_eq!(solver.arriving(ceiling, &mut ()).r, 0.0, "a lamp does not shine through its back");
    let mut all = [0.0; 7];
    solver.factors(ceiling, &mut all).expect("there is room");
    assert!(all[6] == 0.0 && all.iter().sum::<f64>() < 0.01, "{all:?}");
    // Two triangles without patches in its place.
    let mut faces = cube::<f64>(|_| None);
    faces.bare_face(below, [1.0; 3], crate::scene::PLAIN);
    let row = floor_row(&faces, &[]);
    close(row[1], 0.0, 2e-3);
    close(row.iter().sum(), 1.0 - open[1], 2e-3);
}
