#![allow(clippy::indexing_slicing)] // a test may panic

use super::{NotCut, cut};
use crate::space::{Triple, cross, difference, dot};

/// The triangles of a polygon; checks that each runs the way of the polygon and that together they are `area`, and
/// that none lies where the polygon does not: their areas add up, so it is enough that their middles are inside.
fn covers(corners: &[Triple], area: f64, normal: Triple) -> Vec<[usize; 3]> {
    let cut = cut(corners).expect("it has an area");
    let off = difference(cut.normal, normal);
    assert!(dot(off, off) < 1e-20, "{:?}", cut.normal);
    let mut sum = 0.0;
    let mut places = corners.to_vec();
    places.extend(cut.crossings.iter().map(|crossing| crossing.mix(corners)));
    for triangle in &cut.triangles {
        let [a, b, c] = triangle.map(|corner| places[corner]);
        let part = dot(cross(difference(b, a), difference(c, a)), normal) / 2.0;
        assert!(part > 0.0, "{triangle:?} is turned over");
        sum += part;
        let middle = [0, 1, 2].map(|axis| (a[axis] + b[axis] + c[axis]) / 3.0);
        assert!(winding(corners, middle, normal).abs() > 0.9, "{triangle:?} is outside");
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
        flat(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [1.0, 0.0]]),
        flat(&[[1e300, 1e300], [-1e300, -1e300], [0.0, 0.0]]),
        vec![[f64::MAX; 3], [-f64::MAX; 3], [f64::MAX; 3]],
    ] {
        assert_eq!(cut(&corners).err(), Some(NotCut::Flat), "{corners:?}");
    }
    assert_eq!(cut(&[]).err(), Some(NotCut::Flat));
}

/// The triangles by the places of their corners, whatever the order.
fn set(corners: &[Triple]) -> Vec<Vec<[i64; 3]>> {
    let cut = cut(corners).expect("it has an area");
    let mut places = corners.to_vec();
    places.extend(cut.crossings.iter().map(|crossing| crossing.mix(corners)));
    #[allow(clippy::cast_possible_truncation)] // rounded to 1e-9
    let round = |place: Triple| place.map(|c| (c * 1e9).round() as i64);
    let mut triangles: Vec<Vec<_>> = cut
        .triangles
        .iter()
        .map(|triangle| {
            let mut triangle: Vec<_> = triangle.iter().map(|corner| round(places[*corner])).collect();
            triangle.sort_unstable();
            triangle
        })
        .collect();
    triangles.sort_unstable();
    triangles
}

#[test]
fn an_outline_shows_what_it_winds_around_wherever_it_begins() {
    let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let with = |more: &[[f64; 2]]| [&square[..3], more, &square[3..]].concat();
    let star: Vec<_> = (0..5).map(|i| f64::from(i * 2) * core::f64::consts::TAU / 5.0).collect();
    let star: Vec<_> = star.into_iter().map(|angle| [angle.cos(), angle.sin()]).collect();
    let cases: [(&str, Vec<[f64; 2]>, f64, bool); 12] = [
        ("an antenna out", with(&[[1.0, 1.9], [1.0, 1.0]]), 4.0, false),
        ("an antenna in", with(&[[0.2, 0.2], [1.0, 1.0]]), 4.0, false),
        ("an antenna in line", with(&[[3.0, 1.0], [1.0, 1.0]]), 4.0, false),
        ("corners repeated", square.iter().flat_map(|corner| [*corner; 3]).collect(), 4.0, false),
        ("corners in line", with(&[[0.5, 1.0], [0.0, 1.0]]), 4.0, false),
        ("an even bow tie", vec![[-1.0, -1.0], [1.0, 1.0], [1.0, -1.0], [-1.0, 1.0]], 2.0, true),
        ("an uneven bow tie", vec![[-1.0, -1.0], [1.0, 0.9], [1.0, -0.7], [-1.0, 1.0]], 1.822_222_222, true),
        (
            "two triangles",
            [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 0.0], [-1.0, 0.0], [-1.0, -1.0]].into(),
            1.0,
            false,
        ),
        (
            "a keyhole",
            with(&[[0.5, 0.5], [0.5, -0.5], [-0.5, -0.5], [-0.5, 0.5], [0.5, 0.5], [1.0, 1.0]]),
            3.0,
            false,
        ),
        ("a square twice", [square, square].concat(), 4.0, false),
        (
            "folded back over two sides",
            with(&[[1.0, -1.0], [-1.0, -1.0], [1.0, -1.0], [1.0, 1.0]]),
            4.0,
            false,
        ),
        ("a star in one line", star, 1.122_569_941, true),
    ];
    for (name, outline, area, crosses) in cases {
        for tilt in [0, 1, 2] {
            let corners: Vec<Triple> = flat(&outline)
                .iter()
                .map(|&[x, y, z]| match tilt {
                    0 => [x, y, z],
                    1 => [z + 5.0, x, y],
                    _ => [x * 0.6 - 3.0, y, x * 0.8 + 1.0],
                })
                .collect();
            let expected = set(&corners);
            for one in turned(&corners) {
                let back: Vec<_> = one.iter().rev().copied().collect();
                for corners in [one, back] {
                    let cut = cut(&corners).expect("it has an area");
                    assert_eq!(!cut.crossings.is_empty(), crosses, "{name}");
                    let triangles = covers(&corners, area, cut.normal);
                    // What is convex is a fan about its first corner, in any place of the plane.
                    if !["corners repeated", "corners in line"].contains(&name) {
                        assert_eq!(set(&corners), expected, "{name}: {triangles:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn a_crossing_lies_on_a_side() {
    let corners = flat(&[[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 4.0]]);
    let crossings = cut(&corners).expect("it has an area").crossings;
    let [crossing] = crossings[..] else { panic!("{crossings:?}") };
    assert_eq!(crossing.mix(&corners), [2.0, 2.0, 0.0]);
    let normals = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]];
    assert_eq!(crossing.mix(&normals), [0.5, 0.0, 0.5]);
}

#[test]
fn tangles_are_not_cut() {
    let mut rng = fastrand::Rng::with_seed(7);
    let tangle = |rng: &mut fastrand::Rng, count| -> Vec<Triple> {
        (0..count).map(|_| [rng.f64(), rng.f64(), 0.0]).collect()
    };
    assert_eq!(cut(&tangle(&mut rng, 1000)).err(), Some(NotCut::Tangled));
    assert!(
        cut(&tangle(&mut rng, 140)).expect("it crosses itself some thousand times").crossings.len() > 1000
    );
}

#[test]
fn the_largest_polygons_take_no_time() {
    // A spiral wall: next to no corner is an ear at first.
    let count = crate::nff::MOST_CORNERS / 2;
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
