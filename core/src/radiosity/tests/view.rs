//! Views that are kept.

use super::{Faces, Wall, shine};
use crate::Q16;
use crate::accelerator::Lists;
use crate::color::Rgb;
use crate::material::Material;
use crate::needs::Everything;
use crate::radiosity::{Casts, HemiCube, Patch, Rays, Solver, Stop, View};
use crate::scalar::read::Read;
use crate::scene::Scene;

extern crate std;
use std::vec;
use std::vec::Vec;

/// Checks that a sweep and what arrives at last are the same to the last bit, whether rays are traced anew, kept, or both by turns.
fn assert_same<S: Read, C: Casts<S>>(casts: C, by_rays_alone: bool) {
    let mut faces = Faces::<S>::cube(3, false, |face, _| Wall {
        reflectance: [0.7, 0.5, 0.1],
        emission: [if face == 1 { 0.25 } else { 0.0 }; 3],
    });
    // In the middle, seen from both sides.
    faces.bare_face([[0.2, 0.3, 0.4], [0.2, 0.7, 0.4], [0.6, 0.7, 0.6], [0.6, 0.3, 0.6]], [0.9, 0.6, 0.3], 0);
    let materials = [Material::Mirror];
    let scene = Scene { materials: &materials, ..faces.bare() };
    let scene = scene.admit_with(&super::camera::<S>(), Lists).expect("it fits");
    let mesh = faces.mesh();
    let solver = Solver::<S, Everything, C>::new(&scene, mesh, casts, 3);
    let solver = if by_rays_alone { solver.by_rays_alone() } else { solver };
    let mut ends = Vec::new();
    let views: Vec<_> = mesh
        .patches()
        .map(|patch| {
            let first = ends.len();
            let whole = solver.view(patch, &mut (), |end| ends.push(end)).expect("it is there");
            (first..ends.len(), whole)
        })
        .collect();
    let view = |number: usize| {
        let (range, whole) = views[number].clone();
        View { ends: &ends[range], whole }
    };
    let black = vec![Rgb::BLACK; mesh.len()];
    let (mut traced, mut kept, mut both) = (black.clone(), black.clone(), black);
    for _ in 0..3 {
        solver.sweep(&mut traced, None, Stop::STILL).expect("there is room");
        solver.sweep_kept(&mut kept, None, Stop::STILL, |number| Some(view(number))).expect("there is room");
        let some = |number| (number % 2 == 0).then(|| view(number));
        solver.sweep_kept(&mut both, None, Stop::STILL, some).expect("there is room");
    }
    assert!(traced.iter().any(|light| shine::<S>(*light)[0] > 0.01));
    assert!(traced == kept && traced == both);
    let last = Patch { quad: 5, cell: [2, 2] };
    let one = Rgb::new(S::unit(1.0), S::unit(1.0), S::unit(1.0));
    let found = solver.viewed(&view(mesh.len() - 1), &kept, one);
    assert!(found == solver.indirect(last, &kept, &mut ()));
    assert!(solver.view(Patch { quad: 6, cell: [0, 0] }, &mut (), |_| ()).is_none());
}

#[test]
fn sweeps_of_kept_views_are_those_of_rays() {
    let rays = Rays { count: 64, seed: 1 };
    assert_same::<f64, _>(rays, false);
    assert_same::<f64, _>(rays, true);
    assert_same::<Q16, _>(rays, false);
    assert_same::<Q16, _>(rays, true);
    let cube = HemiCube::new(8).expect("it is even");
    assert_same::<f32, _>(cube, false);
}
