//! A room in Goral's manner, with exact form factors.

use super::{Faces, on_face, room_g};
use crate::color::Rgb;
use crate::radiosity::exact::{offset_parallel, offset_perpendicular};
use crate::radiosity::{Error, Matrix, Patch, Shooter, Stop};
use crate::scalar::read::Read;
use crate::{Q16, Q20};

use super::{furnace, shine};

extern crate std;
use std::vec;
use std::vec::Vec;

const STILL: Stop = Stop { sweeps: 1000, bits: Stop::STILL };

/// Returns the exact form factor from one of n x n patches of a face of the unit cube to another.
pub(super) fn exact(n: u16, (from, k): (usize, usize), (to, l): (usize, usize)) -> f64 {
    if from == to {
        return 0.0;
    }
    let (size, cells) = (f64::from(n), usize::from(n));
    // For each axis the interval of a patch, of no length along the face's own.
    let extents = |face: usize, patch: usize| {
        let cell = |k: usize| k as f64 / size;
        let low = on_face(face, [cell(patch % cells), cell(patch / cells)]);
        let high = on_face(face, [cell(patch % cells + 1), cell(patch / cells + 1)]);
        [[low[0], high[0]], [low[1], high[1]], [low[2], high[2]]]
    };
    let axis = |face: usize| 2 - [0, 2, 1][face / 2];
    let (one, other) = (extents(from, k), extents(to, l));
    let (a, b) = (axis(from), axis(to));
    let product = if a == b {
        let [u, v] = [[1, 2], [0, 2], [0, 1]][a];
        offset_parallel(one[u], one[v], other[u], other[v], 1.0)
    } else {
        let along = 3 - a - b;
        // Distances from the line that both planes have in common.
        let away = |interval: [f64; 2], plane: [f64; 2]| interval.map(|c| (c - plane[0]).abs());
        let rising = |[p, q]: [f64; 2]| if p < q { [p, q] } else { [q, p] };
        let (x, z) = (rising(away(one[b], other[b])), rising(away(other[a], one[a])));
        offset_perpendicular(x, one[along], z, other[along])
    };
    product * size * size
}

/// Returns the row of the factors of a patch of a cube whose patches are quadrilaterals of their own.
fn exact_row<S: Read>(n: u16, patch: Patch, row: &mut [S::Unit]) -> Result<(), Error> {
    let count = usize::from(n * n);
    let name = |number: usize| (number / count, number % count);
    for (number, factor) in row.iter_mut().enumerate() {
        *factor = S::unit(exact(n, name(patch.quad), name(number)));
    }
    Ok(())
}

/// Returns B of the patches of room G by Gauss's elimination.
pub(super) fn by_gauss<S: Read>(n: u16) -> Vec<[f64; 3]> {
    let faces = Faces::<S>::cube(n, true, room_g(n));
    let mesh = faces.mesh();
    let count = mesh.len();
    let zero = <S::Unit as crate::scalar::Unit>::ZERO;
    let mut factors = vec![zero; count * count];
    let matrix = Matrix::new(mesh, &mut factors, |patch, row| exact_row::<S>(n, patch, row)).expect("exact");
    let mut light = vec![Rgb::BLACK; count];
    let mut work = vec![zero; count * count];
    matrix.gauss(&mut light, &mut work).expect("there is room");
    assert!(matrix.gauss(&mut light, &mut work[1..]).is_err());
    light.into_iter().map(shine::<S>).collect()
}

fn assert_row(found: [f64; 3], exact: [f64; 3], rounding: f64, name: &str) {
    for (found, exact) in found.iter().zip(exact) {
        assert!((found - exact).abs() < rounding, "{name}: {found}, {exact}");
    }
}

/// Room G's rows: means of floor, left and front wall, and two patches of the floor.
fn rows<S: Read>(rounding: f64) {
    let mean = |light: &[[f64; 3]]| -> [f64; 3] {
        core::array::from_fn(|k| light.iter().map(|b| b[k]).sum::<f64>() / light.len() as f64)
    };
    type Row = [f64; 3];
    let cases: [(u16, [Row; 3], Option<[Row; 2]>); 3] = [
        (
            1,
            [
                [0.281_877_062, 0.281_877_062, 0.229_295_552],
                [0.246_054_836, 0.045_026_192, 0.036_634_001],
                [0.281_994_950, 0.281_994_950, 0.229_413_441],
            ],
            None,
        ),
        (
            3,
            [
                [0.033_606_621, 0.033_606_621, 0.027_874_436],
                [0.027_440_479, 0.004_876_512, 0.004_010_379],
                [0.031_088_316, 0.031_088_316, 0.025_253_419],
            ],
            Some([
                [0.039_004_646, 0.039_004_646, 0.033_164_680],
                [0.033_128_509, 0.029_036_387, 0.025_416_548],
            ]),
        ),
        (
            6,
            [
                [0.033_630_734, 0.033_630_734, 0.027_909_052],
                [0.027_458_091, 0.004_872_599, 0.004_007_589],
                [0.031_140_598, 0.031_140_598, 0.025_311_642],
            ],
            Some([
                [0.038_668_056, 0.039_857_769, 0.033_357_701],
                [0.029_751_323, 0.025_128_289, 0.022_030_406],
            ]),
        ),
    ];
    for (n, means, patches) in cases {
        let light = by_gauss::<S>(n);
        let count = usize::from(n * n);
        for (face, exact) in [0, 2, 4].into_iter().zip(means) {
            assert_row(mean(&light[face * count..][..count]), exact, rounding, "a mean");
        }
        if let Some([middle, first]) = patches {
            let half = usize::from(n / 2);
            assert_row(light[half * usize::from(n) + half], middle, rounding, "the middle");
            assert_row(light[0], first, rounding, "patch 0");
        }
    }
}

#[test]
fn rows_of_room_g_in_every_format() {
    rows::<f64>(1e-9);
    rows::<f32>(1e-6);
    rows::<Q16>(4.0 / 65_536.0);
    rows::<Q20>(4.0 / 65_536.0);
}

#[test]
fn exact_factors_are_reciprocal_and_come_to_one() {
    for n in [1u16, 2, 3] {
        let count = usize::from(n * n);
        let name = |number: usize| (number / count, number % count);
        for i in 0..6 * count {
            let row: f64 = (0..6 * count).map(|j| exact(n, name(i), name(j))).sum();
            assert!((row - 1.0).abs() < 1e-12, "n {n}, patch {i}: {row}");
            for j in 0..i {
                // All patches are equally large.
                let (there, back) = (exact(n, name(i), name(j)), exact(n, name(j), name(i)));
                assert!((there - back).abs() < 1e-12, "{i}, {j}: {there}, {back}");
            }
        }
    }
}

#[test]
fn what_is_emitted_is_absorbed() {
    let light = by_gauss::<f64>(3);
    let faces = Faces::<f64>::cube(3, true, room_g(3));
    for k in 0..3 {
        let of = |rgb: Rgb<f64>| [rgb.r, rgb.g, rgb.b][k];
        let (mut emitted, mut absorbed) = (0.0, 0.0);
        for (number, quad) in faces.quads.iter().enumerate() {
            let (e, rho) = (of(quad.emission), of(quad.reflectance));
            emitted += e;
            absorbed += (light[number][k] - e) * (1.0 - rho) / rho;
        }
        assert!((emitted - absorbed).abs() < 1e-12, "{emitted}, {absorbed}");
    }
}

#[test]
fn a_furnace_and_a_room_of_six_patches_by_elimination() {
    let faces = Faces::<f64>::cube(2, true, furnace(0.5, 1.0));
    let mut factors = vec![0.0; 24 * 24];
    let matrix =
        Matrix::new(faces.mesh(), &mut factors, |patch, row| exact_row::<f64>(2, patch, row)).expect("exact");
    let (mut light, mut work) = (vec![Rgb::BLACK; 24], vec![0.0; 24 * 24]);
    matrix.gauss(&mut light, &mut work).expect("there is room");
    assert!(light.iter().all(|b| (b.r - 2.0).abs() < 1e-12 && (b.b - 2.0).abs() < 1e-12));
    matrix.solve(&mut light, STILL).expect("there is room");
    assert!(light.iter().all(|b| (b.r - 2.0).abs() < 1e-12 && (b.g - 2.0).abs() < 1e-12));
    // One patch a wall, the ceiling emits.
    let lit =
        |face, _| super::Wall { emission: [if face == 1 { 1.0 } else { 0.0 }; 3], ..furnace(0.5, 0.0)(0, 0) };
    let faces = Faces::<f64>::cube(1, true, lit);
    let mut factors = [0.0; 36];
    let matrix =
        Matrix::new(faces.mesh(), &mut factors, |patch, row| exact_row::<f64>(1, patch, row)).expect("exact");
    matrix.gauss(&mut light, &mut work).expect("there is room");
    let close = |found: f64, exact: f64| assert!((found - exact).abs() < 1e-9, "{found}, {exact}");
    close(light[1].r, 1.090_909_098);
    close(light[0].g, 0.181_745_826);
    light[2..6].iter().for_each(|wall| close(wall.b, 0.181_836_269));
}

/// Returns the largest and the rms difference of two lights, over patches and registers.
fn errors(found: &[Rgb<f64>], exact: &[[f64; 3]]) -> (f64, f64) {
    let mut differences = Vec::new();
    for (found, exact) in found.iter().zip(exact) {
        differences
            .extend(shine::<f64>(*found).iter().zip(exact).map(|(found, exact)| (found - exact).abs()));
    }
    let squares: f64 = differences.iter().map(|d| d * d).sum();
    (differences.iter().copied().fold(0.0, f64::max), libm::sqrt(squares / differences.len() as f64))
}

/// Whether two numbers agree in the three digits of a table.
fn assert_digits(found: f64, stated: f64, name: &str) {
    assert!((found / stated - 1.0).abs() < 0.006, "{name}: {found}, {stated}");
}

#[test]
fn sweeps_and_shots_converge_as_they_should() {
    let exact = by_gauss::<f64>(3);
    let faces = Faces::<f64>::cube(3, true, room_g(3));
    let mesh = faces.mesh();
    let mut factors = vec![0.0; 54 * 54];
    let matrix =
        Matrix::new(mesh, &mut factors, |patch, row| exact_row::<f64>(3, patch, row)).expect("exact");
    let mut light = vec![Rgb::BLACK; 54];
    matrix.start(&mut light).expect("there is room");
    let largest = exact.iter().flatten().copied().fold(0.0, f64::max);
    for sweep in 1..=8 {
        matrix.sweep(&mut light, 12).expect("there is room");
        let stated = match sweep {
            1 => 0.0176,
            2 => 0.00784,
            4 => 0.000_984,
            8 => 0.000_014_3,
            _ => continue,
        };
        assert_digits(errors(&light, &exact).0 / largest, stated, "a sweep");
    }
    let mut unshot = vec![Rgb::BLACK; 54];
    let mut shooter = Shooter::new(mesh, &mut light, &mut unshot).expect("there is room");
    for shot in 1..=200 {
        let source = shooter.next().expect("light is left");
        let number = mesh.number(source).expect("it is there");
        shooter.shoot(source, |receiver| matrix.row(mesh.number(receiver).expect("it is there"))[number]);
        let (left, without, with) = match shot {
            1 => (0.534, 0.0132, 0.002_02),
            10 => (0.442, 0.0111, 0.001_60),
            50 => (0.202, 0.005_45, 0.000_992),
            100 => (0.0672, 0.001_93, 0.000_326),
            200 => (0.009_66, 0.000_291, 0.000_048_4),
            _ => continue,
        };
        assert_digits(shooter.left(), left, "unshot");
        assert_digits(errors(shooter.light(), &exact).1, without, "without ambient");
        let shown: Vec<_> = mesh.patches().map(|patch| shooter.with_ambient(patch)).collect();
        assert_digits(errors(&shown, &exact).1, with, "with ambient");
    }
    assert_eq!(shooter.clamped(), 0);
}

#[test]
fn factors_that_are_none_are_refused() {
    let faces = Faces::<Q16>::cube(1, true, furnace(0.5, 1.0));
    let mut factors = vec![Q16::unit(0.0); 36];
    let refused = |factors: &mut [_], of: &dyn Fn(usize, usize) -> f64| {
        let row = |patch: Patch, row: &mut [<Q16 as crate::Scalar>::Unit]| {
            (0..).zip(row).for_each(|(k, factor)| *factor = Q16::unit(of(patch.quad, k)));
            Ok(())
        };
        Matrix::new(faces.mesh(), factors, row).map(|_| ()).err()
    };
    let alike = |i, k| if i == k { 0.0 } else { 0.2 };
    let wrong = |quad| Some(Error::Factors(Patch { quad, cell: [0, 0] }));
    assert_eq!(refused(&mut factors, &alike), None);
    assert_eq!(refused(&mut factors, &|i, k| if (i, k) == (2, 3) { 0.3 } else { alike(i, k) }), wrong(2));
    assert_eq!(refused(&mut factors, &|i, k| if (i, k) == (4, 3) { -0.1 } else { alike(i, k) }), wrong(4));
    assert_eq!(refused(&mut factors, &|_, _| 0.1), wrong(0), "patches that see themselves");
    assert_eq!(refused(&mut factors, &|i, k| if i == k { 0.0 } else { 1.9 }), wrong(0), "far too much");
    let needed = Some(Error::Room { needed: 36, found: 35 });
    assert_eq!(refused(&mut factors[1..], &alike), needed);
}
