use super::{Faces, Wall, light, shine};
use crate::color::Rgb;
use crate::radiosity::Solution;
use crate::scalar::read::Read;
use crate::{Q16, Q20};

extern crate std;
use std::vec::Vec;

/// A square of so many patches whose light is a linear field, red of 20 + 10 u + v over 20, counted in patches from the first one's middle.
fn linear<S: Read>([nu, nv]: [u16; 2], check: impl Fn(&dyn Fn([u16; 2]) -> f64, &dyn Fn([f64; 2]) -> f64)) {
    let mut faces = Faces::<S>::new();
    let wall = Wall { reflectance: [0.5; 3], emission: [0.0; 3] };
    faces.push([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]], [nu, nv], wall);
    let cells = (0..nv).flat_map(|j| (0..nu).map(move |i| [i, j].map(f64::from)));
    let field: Vec<Rgb<S::Light>> =
        cells.map(|[i, j]| light::<S>([(20.0 + 10.0 * i + j) / 64.0, 1.0, 0.25])).collect();
    let solution = Solution::new(faces.mesh(), &field).expect("there is room");
    check(&|vertex| shine::<S>(solution.vertex(0, vertex))[0] * 64.0, &|[u, v]| {
        let [r, g, b] = shine::<S>(solution.at(0, [S::unit(u), S::unit(v)]));
        assert!((g - 1.0).abs() < 4e-5 && (b - 0.25).abs() < 4e-5, "{g}, {b}");
        r * 64.0
    });
}

fn fields<S: Read>(rounding: f64) {
    linear::<S>([3, 3], |vertex, at| {
        for (name, exact) in [([1, 1], 25.5), ([1, 0], 24.5), ([0, 0], 14.5), ([3, 3], 47.5), ([3, 1], 45.5)]
        {
            let found = vertex(name);
            assert!((found - exact).abs() < rounding, "{name:?}: {found}, {exact}");
        }
        for step in 0..121u32 {
            let (u, v) = (f64::from(step % 11) / 10.0, f64::from(step / 11) / 10.0);
            let (found, exact) = (at([u, v]), 14.5 + 30.0 * u + 3.0 * v);
            assert!((found - exact).abs() < 2.0 * rounding, "{u}, {v}: {found}, {exact}");
        }
    });
    // One patch: its light everywhere. Two in a row: straight on in that direction alone.
    linear::<S>([1, 1], |_, at| assert!((at([0.9, 0.1]) - 20.0).abs() < rounding));
    linear::<S>([2, 1], |_, at| assert!((at([1.0, 0.3]) - 35.0).abs() < 2.0 * rounding));
}

#[test]
fn linear_fields_come_back_in_every_format() {
    fields::<f64>(1e-12);
    fields::<f32>(1e-5);
    fields::<Q16>(64.0 / 65_536.0);
    fields::<Q20>(64.0 / 65_536.0);
}

#[test]
fn light_that_would_be_negative_is_none() {
    let mut faces = Faces::<Q16>::new();
    let wall = Wall { reflectance: [0.5; 3], emission: [0.0; 3] };
    faces.push([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]], [2, 2], wall);
    let field = [0.0, 1.0, 1.0, 1.0].map(|l| light::<Q16>([l; 3]));
    let solution = Solution::new(faces.mesh(), &field).expect("there is room");
    assert_eq!(shine::<Q16>(solution.vertex(0, [0, 0])), [0.0; 3]);
    assert_eq!(shine::<Q16>(solution.vertex(0, [2, 2])), [1.25; 3]);
    assert_eq!(shine::<Q16>(solution.vertex(3, [0, 0])), [0.0; 3], "no such quadrilateral");
    assert!(Solution::new(faces.mesh(), &field[1..]).is_err());
}
