//! The means of places on lamps against the exact light of the lamps.

use super::{Glimpse, Square};
use crate::light::Lamp;
use crate::sampling::pairs::{Pairs, Purpose};
use crate::scalar::Unit;
use crate::scalar::read::{Read, direction, place};
use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector};
use crate::{Q16, Q20};

/// Returns the mean over 32 seeds and its standard error of `value`, a mean over 64 pairs.
fn statistics<U: Unit>(value: impl Fn([U; 2]) -> f64) -> [f64; 2] {
    let mut sums = [0.0; 2];
    for seed in 0..32 {
        let pairs = Pairs::new(9, 4, Purpose::Lamp.tag(1), seed);
        let mean = (0..64).map(|i| value(pairs.units(i))).sum::<f64>() / 64.0;
        sums = [sums[0] + mean, sums[1] + mean * mean];
    }
    let mean = sums[0] / 32.0;
    [mean, libm::sqrt((sums[1] / 32.0 - mean * mean).max(0.0) / 31.0)]
}

/// Returns `H / (pi L)` of a sphere of the radius `radius`, the distance `distance` and the cosine `cosine`.
fn sphere<S: Read>(radius: f64, distance: f64, cosine: f64) -> [f64; 2] {
    let sine = libm::sqrt(1.0 - cosine * cosine);
    let at = [distance * sine, 0.0, distance * cosine];
    let radius = S::length(radius);
    let lamp = Lamp::white(place::<S>(at), S::ZERO, 1);
    let normal = UnitVec3::<S>::Z;
    statistics(|pair| {
        let own = (radius, radius.inverse());
        let Glimpse { place, lamp } = Glimpse::of_sphere(&lamp, own, (place::<S>([0.0; 3]), normal), pair);
        let part = S::far(radius) / S::far(lamp.distance);
        if place.cosine > S::Unit::ZERO { part * part * S::read(lamp.cosine) } else { 0.0 }
    })
}

fn holds([mean, error]: [f64; 2], exact: f64, rounding: f64, what: &str) {
    assert!((mean - exact).abs() < 5.0 * error + rounding, "{what}: {mean}, {exact} +- {error}");
}

#[test]
fn spheres_give_the_light_of_points() {
    let cases = [
        (0.5, 3.0, 0.6, 0.016_666_667),
        // A lamp that sets.
        (0.5, 1.0, 0.0, 0.028_834_443),
        // The point is within it.
        (2.0, 1.0, 0.6, 1.0),
        // And far away.
        (0.5, 30.0, 1.0, 0.25 / 900.0),
    ];
    for (radius, distance, cosine, exact) in cases {
        holds(sphere::<f64>(radius, distance, cosine), exact, 1e-9, "f64");
        holds(sphere::<f32>(radius, distance, cosine), exact, 1e-6, "f32");
        holds(sphere::<Q16>(radius, distance, cosine), exact, 1e-5, "q16");
        holds(sphere::<Q20>(radius, distance, cosine), exact, 1e-6, "q20");
    }
}

/// Returns Lambert's factor of the unit square at the height 2 over its corner: the part of the light of a sky that it hides.
fn square<S: Read>() -> [f64; 2] {
    let lamp = Lamp::white(place::<S>([0.5, 0.5, 2.0]), S::ZERO, 1);
    let least = S::length(1.0 / 64.0);
    let square = Square {
        corner: place::<S>([0.0, 0.0, 2.0]),
        middle: lamp.position,
        // Their product points down.
        edges: [place::<S>([0.0, 1.0, 0.0]), place::<S>([1.0, 0.0, 0.0])],
        normal: direction::<S>([0.0, 0.0, -1.0]),
        least: (least, least.inverse()),
    };
    statistics(|pair| {
        let from = (place::<S>([0.0; 3]), UnitVec3::<S>::Z);
        let Some(Glimpse { lamp, .. }) = Glimpse::of_square(&lamp, &square, from, pair) else { return 0.0 };
        S::read(lamp.cosine) / S::far(lamp.distance) / S::far(lamp.distance) / core::f64::consts::PI
    })
}

#[test]
fn squares_give_the_light_of_their_solid_angle() {
    let exact = 0.059_864_118;
    holds(square::<f64>(), exact, 1e-9, "f64");
    holds(square::<f32>(), exact, 1e-7, "f32");
    holds(square::<Q16>(), exact, 1e-5, "q16");
    holds(square::<Q20>(), exact, 1e-6, "q20");
}

#[test]
fn squares_shine_to_one_side() {
    let lamp = Lamp::white(place::<f64>([0.5, 0.5, 2.0]), 0.0, 1);
    let square = Square {
        corner: place::<f64>([0.0, 0.0, 2.0]),
        middle: lamp.position,
        edges: [place::<f64>([0.0, 1.0, 0.0]), place::<f64>([1.0, 0.0, 0.0])],
        normal: direction::<f64>([0.0, 0.0, -1.0]),
        least: (1.0 / 64.0, 64.0),
    };
    let from = (place::<f64>([0.3, 0.2, 5.0]), -UnitVec3::<f64>::Z);
    assert!(Glimpse::of_square(&lamp, &square, from, [0.5, 0.5]).is_none());
}

#[test]
fn squares_that_move_are_where_their_middle_is() {
    let square = |z: f64| Square {
        corner: place::<f64>([0.0, 0.0, z]),
        middle: place::<f64>([0.5, 0.5, z]),
        edges: [place::<f64>([0.0, 1.0, 0.0]), place::<f64>([1.0, 0.0, 0.0])],
        normal: direction::<f64>([0.0, 0.0, -1.0]),
        least: (1.0 / 64.0, 64.0),
    };
    let there = Lamp::white(place::<f64>([0.5, 0.5, 4.0]), 0.0, 1);
    let from = (place::<f64>([0.3, 0.2, 1.0]), UnitVec3::<f64>::Z);
    let [moved, built] = [square(2.0), square(4.0)].map(|square| {
        Glimpse::of_square(&there, &square, from, [0.25, 0.75]).expect("it shines there").place
    });
    assert_eq!((moved.direction, moved.distance), (built.direction, built.distance));
}

#[test]
fn shadow_rays_end_at_the_lamp() {
    let lamp = Lamp::white(place::<f64>([0.0, 0.0, 3.0]), 0.0, 1);
    for (from, distance) in [([0.0, 0.0, 0.0], true), ([0.0, 0.0, 2.8], false)] {
        for i in 0..64 {
            let pair = Pairs::new(0, 0, 4, 1).units(i);
            let glimpse =
                Glimpse::of_sphere(&lamp, (0.5, 2.0), (place::<f64>(from), UnitVec3::<f64>::Z), pair);
            let end = place::<f64>(from).along(glimpse.place.direction, glimpse.place.distance);
            let away = (end - lamp.position).norm_squared();
            assert!((away - 0.25).abs() < 1e-9, "{distance}: {away}");
        }
    }
}
