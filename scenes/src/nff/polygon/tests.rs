#![allow(clippy::indexing_slicing)] // a test may panic

use super::cut;
use crate::space::{Triple, cross, difference, dot};

/// The triangles of a polygon; checks that each runs the way of the polygon and that together they are `area`, and
/// that none lies where the polygon does not: their areas add up, so it is enough that their middles are inside.
fn covers(corners: &[Triple], area: f64, normal: Triple) -> Vec<[usize; 3]> {
    let cut = cut(corners).expect("it has an area");
    let off = difference(cut.normal, normal);
    assert!(dot(off, off) < 1e-20, "{:?}", cut.normal);
    let mut sum = 0.0;
    for triangle in &cut.triangles {
        let [a, b, c] = triangle.map(|corner| corners[corner]);
        let part = dot(cross(difference(b, a), difference(c, a)), normal) / 2.0;
        assert!(part > 0.0, "{triangle:?} is turned over");
        sum += part;
        let middle = [0, 1, 2].map(|axis| (a[axis] + b[axis] + c[axis]) / 3.0);
        assert!(winding(corners, middle, normal) > 0.9, "{triangle:?} is outside");
    }
    assert!((sum - area).abs() < 1e-9 * area, "{sum} and not {area}");
    cut.triangles
}

/// How often a polygon runs around a place.
fn winding(corners: &[Triple], place: Triple, normal: Triple) -> f64 {
    let sides = corners.iter().zip(corners.iter().cycle().skip(1));
    let angles = sides.map(|(&a, &b)| {
        let (a, b) = (difference(a, place), difference(b, place));
        dot(cross(a, b), normal).atan2(dot(a, b))
    });
    angles.sum::<f64>() / core::f64::consts::TAU
}

fn flat(corners: &[[f64; 2]]) -> Vec<Triple> {
    corners.iter().map(|&[x, y]| [x, y, 0.0]).collect()
}

/// Every way to begin a polygon, for not every one can be fanned.
fn turned(corners: &[Triple]) -> impl Iterator<Item = Vec<Triple>> {
    (0..corners.len()).map(|first| {
        let mut corners = corners.to_vec();
        corners.rotate_left(first);
        corners
    })
}

const UP: Triple = [0.0, 0.0, 1.0];
const L: [[f64; 2]; 6] = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];

#[test]
fn convex_polygons_are_fans() {
    let square = flat(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    assert_eq!(covers(&square, 1.0, UP), [[0, 1, 2], [0, 2, 3]]);
    let tilted = [[4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]];
    let third = 1.0 / 3.0_f64.sqrt();
    assert_eq!(covers(&tilted, 8.0 * 3.0_f64.sqrt(), [third; 3]), [[0, 1, 2]]);
    // A corner in the middle of a side.
    let side = flat(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0]]);
    assert_eq!(covers(&side, 2.0, UP), [[0, 2, 3]]);
}

#[test]
fn an_l_is_covered_from_every_corner_in_every_plane() {
    for corners in turned(&flat(&L)) {
        covers(&corners, 4.0, UP);
        let back: Vec<_> = corners.iter().rev().copied().collect();
        covers(&back, 4.0, [0.0, 0.0, -1.0]);
        let to = |axes: [usize; 3]| corners.iter().map(|c| axes.map(|axis| c[axis])).collect::<Vec<_>>();
        covers(&to([2, 0, 1]), 4.0, [1.0, 0.0, 0.0]);
        covers(&to([1, 2, 0]), 4.0, [0.0, 1.0, 0.0]);
        covers(&to([2, 1, 0]), 4.0, [-1.0, 0.0, 0.0]);
        covers(&to([0, 2, 1]), 4.0, [0.0, -1.0, 0.0]);
    }
    // From the inner corner it is a fan; from its neighbour it must not be.
    let inner = turned(&flat(&L)).nth(3).expect("it has six");
    assert!(covers(&inner, 4.0, UP).iter().all(|triangle| triangle[0] == 0));
    let beside = turned(&flat(&L)).nth(4).expect("it has six");
    assert!(covers(&beside, 4.0, UP).iter().any(|triangle| !triangle.contains(&0)));
}

#[test]
fn stars_are_covered() {
    for points in [5_u32, 8, 60] {
        let half = core::f64::consts::PI / f64::from(points);
        let corner = |i: u32| {
            let (angle, radius) = (half * f64::from(i), if i.is_multiple_of(2) { 1.0 } else { 0.2 });
            [radius * angle.cos() + 100.0, radius * angle.sin() - 7.0, 5.0]
        };
        let corners: Vec<_> = (0..2 * points).map(corner).collect();
        assert_eq!(covers(&corners, f64::from(points) * 0.2 * half.sin(), UP).len(), 2 * points as usize - 2);
    }
}

#[test]
fn spikes_combs_and_holes_are_covered() {
    let spike = flat(&[[0.0, 0.0], [1.0, 0.0], [1.0, 2.0], [1.0, 1.0], [0.0, 1.0]]);
    turned(&spike).for_each(|corners| _ = covers(&corners, 1.0, UP));
    let mut comb = vec![[0.0, -1.0]];
    for tooth in (0..20).rev().map(f64::from) {
        comb.extend([[tooth + 1.0, 0.0], [tooth + 0.5, 3.0]]);
    }
    comb.push([0.0, 0.0]);
    // Teeth of 1 x 3 / 2 on a right triangle below.
    comb.insert(1, [20.0, -1.0]);
    turned(&flat(&comb)).for_each(|corners| _ = covers(&corners, 20.0 * 1.5 + 20.0, UP));
    let hole = flat(&[
        [0.0, 0.0],
        [4.0, 0.0],
        [4.0, 4.0],
        [0.0, 4.0],
        [0.0, 0.0],
        [1.0, 1.0],
        [1.0, 3.0],
        [3.0, 3.0],
        [3.0, 1.0],
        [1.0, 1.0],
    ]);
    covers(&hole, 12.0, UP);
}

#[test]
fn size_and_place_play_no_part() {
    for scale in [1e-300, 1e-9, 1e9, 1e300] {
        let corners: Vec<Triple> = flat(&L).iter().map(|corner| corner.map(|c| (c - 1.5) * scale)).collect();
        let expected = cut(&flat(&L)).expect("it has an area").triangles;
        assert_eq!(cut(&corners).expect("it has an area").triangles, expected, "{scale}");
    }
    let far: Vec<Triple> = flat(&L).iter().map(|&[x, y, z]| [x + 1e6, y - 1e6, z + 1e6]).collect();
    covers(&far, 4.0, UP);
}

#[test]
fn what_has_no_area_is_nothing() {
    for corners in [
        flat(&[[1.0, 1.0]; 3]),
        flat(&[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]),
        flat(&[[0.0, 0.0], [1.0, 1.0], [1.0, 1.0]]),
        flat(&[[0.1, 0.2], [0.3, 0.6], [0.7, 1.4], [0.2, 0.4]]),
        flat(&[[1e300, 1e300], [-1e300, -1e300], [0.0, 0.0]]),
        vec![[f64::MAX; 3], [-f64::MAX; 3], [f64::MAX; 3]],
    ] {
        assert!(cut(&corners).is_none(), "{corners:?}");
    }
    assert!(cut(&[]).is_none());
}

#[test]
fn what_crosses_itself_ends_all_the_same() {
    let pentagram: Vec<_> = (0..5).map(|i| f64::from(i * 2) * core::f64::consts::TAU / 5.0).collect();
    let pentagram: Vec<_> = pentagram.into_iter().map(|angle| [angle.cos(), angle.sin(), 0.0]).collect();
    assert_eq!(cut(&pentagram).expect("it has an area").triangles.len(), 3);
    let uneven_bow = flat(&[[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 3.0]]);
    assert!(cut(&uneven_bow).expect("one wing is larger").triangles.len() <= 2);
}

#[test]
fn the_largest_polygons_take_no_time() {
    // A spiral wall: next to no corner is an ear at first.
    let count = super::super::MOST_CORNERS / 2;
    let corner = |i: u32, wall: f64| {
        let angle = f64::from(i) * 0.05;
        let radius = 1.0 + 0.1 * angle + wall;
        [radius * angle.cos(), radius * angle.sin(), 0.0]
    };
    let mut corners: Vec<_> = (0..count).map(|i| corner(i, 0.1)).collect();
    corners.extend((0..count).rev().map(|i| corner(i, 0.0)));
    let begun = std::time::Instant::now();
    let triangles = cut(&corners).expect("it has an area").triangles;
    assert_eq!(triangles.len(), corners.len() - 2);
    assert!(begun.elapsed().as_secs() < 20, "{:?}", begun.elapsed());
}
