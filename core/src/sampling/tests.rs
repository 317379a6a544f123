//! The sampler's error against its number of samples, and mappings against their exact values.

use super::mapping::{Facets, disc};
use super::pairs::{Pairs, Purpose};
use crate::scalar::vector::{UnitVec3, UnitVector};
use crate::{Q16, Q20, Scalar};

/// The part of a disc lamp that is seen beyond a straight edge, `s` radii from the middle: `(arccos s - s sqrt(1 - s^2)) / pi`.
fn seg(s: f64) -> f64 {
    let s = s.clamp(-1.0, 1.0);
    (libm::acos(s) - s * libm::sqrt(1.0 - s * s)) / core::f64::consts::PI
}

/// Returns the slope of `log error` over `log samples`, by least squares, of the rms errors of 64 seeds at 4 to 1024 samples.
fn slope(exact: f64, estimate: impl Fn(u32, u32) -> f64) -> f64 {
    let (mut n, mut sums) = (0.0, [0.0f64; 4]);
    for level in 1..=5 {
        let samples = 1u32 << (2 * level);
        let squares: f64 =
            (0..64).map(|seed| (estimate(samples, seed) - exact) * (estimate(samples, seed) - exact)).sum();
        let (x, y) = (libm::log(samples.into()), libm::log(libm::sqrt(squares / 64.0)));
        n += 1.0;
        sums = [sums[0] + x, sums[1] + y, sums[2] + x * x, sums[3] + x * y];
    }
    (n * sums[3] - sums[0] * sums[1]) / (n * sums[2] - sums[0] * sums[0])
}

fn mean(samples: u32, seed: u32, value: impl Fn([f64; 2]) -> f64) -> f64 {
    let pairs = Pairs::new(3, 5, Purpose::Lamp.tag(1), seed);
    (0..samples).map(|i| value(pairs.units(i))).sum::<f64>() / f64::from(samples)
}

#[test]
fn errors_fall_with_the_samples_as_they_should() {
    let (slant, part) = ([0.8, 0.6], 0.31);
    // Where the part of the disc beyond the edge is that.
    let (mut low, mut high) = (-1.0, 1.0);
    for _ in 0..60 {
        let middle = f64::midpoint(low, high);
        if seg(middle) > part { low = middle } else { high = middle }
    }
    let edge = |pair| {
        let [x, y] = disc::<f64>(pair);
        f64::from(u8::from(x * slant[0] + y * slant[1] > low))
    };
    let edges = slope(part, |samples, seed| mean(samples, seed, edge));
    assert!((-0.9..=-0.65).contains(&edges), "slope at an edge: {edges}");
    let smooth = |[u, v]: [f64; 2]| libm::exp(-u - v / 2.0);
    let exact = (1.0 - libm::exp(-1.0)) * 2.0 * (1.0 - libm::exp(-0.5));
    let smooth = slope(exact, |samples, seed| mean(samples, seed, smooth));
    assert!(smooth < -1.3, "slope of a smooth function: {smooth}");
}

#[test]
fn fixed_places_are_a_staircase() {
    for (side, largest) in [(2, 0.279_436_239), (4, 0.126_962_652), (8, 0.062_711_270), (16, 0.031_000_195)] {
        let places = crate::trace::dice::LampPlaces::grid(side);
        let error = (0..=4000).map(|k| {
            let s = -1.0 + f64::from(k) * 0.0005;
            let seen = (0..places.count()).filter(|&k| disc(places.get::<f64>(k))[0] > s).count();
            (seen as f64 / f64::from(places.count()) - seg(s)).abs()
        });
        let error = error.fold(0.0, f64::max);
        assert!((error - largest).abs() < 1e-8, "{side}: {error}, {largest}");
    }
}

/// Returns mean and standard deviation of what facets of that roughness let pass, by 32 seeds of 64 samples.
fn albedo<S: Scalar>(roughness: (i64, i64), view: UnitVec3<S>, unit: impl Fn(S::Unit) -> f64) -> [f64; 2] {
    use crate::scalar::Unit;
    let facets = Facets { roughness: S::Unit::ratio(roughness.0, roughness.1) };
    let normal = UnitVec3::<S>::Z;
    let mut sums = [0.0; 2];
    for seed in 0..32 {
        let pairs = Pairs::new(1, 1, Purpose::Lobe.tag(1), seed);
        let passed = (0..64).map(|i| {
            let facet = facets.seen::<S>(normal, view, pairs.words(i));
            let out = (-view).reflect(facet).dot(normal);
            if out > S::Unit::ZERO { unit(facets.passed(view.dot(normal), out)) } else { 0.0 }
        });
        let mean = passed.sum::<f64>() / 64.0;
        sums = [sums[0] + mean, sums[1] + mean * mean];
    }
    let mean = sums[0] / 32.0;
    [mean, libm::sqrt((sums[1] / 32.0 - mean * mean) * 32.0 / 31.0)]
}

#[test]
fn rough_mirrors_reflect_what_they_should() {
    let sloped = 1.0 - 0.173_648_177_7 * libm::log((1.0 + 0.173_648_177_7) / 0.173_648_177_7);
    for (roughness, degrees, exact) in
        [((3, 10), 60.0, 0.821_711_003), ((1, 2), 0.0, 0.687_848_515), ((1, 1), 80.0, sloped)]
    {
        let angle = f64::to_radians(degrees);
        let (x, z) = (libm::sin(angle), libm::cos(angle));
        let wide = albedo::<f64>(roughness, UnitVec3::<f64>::new(x, 0.0, z), |unit| unit);
        let single = albedo::<f32>(roughness, UnitVec3::<f32>::new(x as f32, 0.0, z as f32), f64::from);
        let fixed = |c: f64| <Q16 as Scalar>::Unit::from_num(c);
        let q16 = albedo::<Q16>(roughness, UnitVec3::<Q16>::new(fixed(x), fixed(0.0), fixed(z)), |unit| {
            unit.to_num()
        });
        let q20 = albedo::<Q20>(roughness, UnitVec3::<Q20>::new(fixed(x), fixed(0.0), fixed(z)), |unit| {
            unit.to_num()
        });
        for [mean, deviation] in [wide, single, q16, q20] {
            let bound = 5.0 * deviation / libm::sqrt(32.0) + 1e-6;
            assert!((mean - exact).abs() < bound, "{roughness:?} at {degrees}: {mean}, {exact} +- {bound}");
        }
    }
}
