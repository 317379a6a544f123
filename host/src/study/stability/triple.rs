//! Triples of numbers: places and vectors, also random ones.

use fastrand::Rng;

/// Three numbers: a place, or a direction of length 1.
pub type Triple = [f64; 3];

/// `a + factor b`.
#[must_use]
pub fn add([x, y, z]: Triple, [u, v, w]: Triple, factor: f64) -> Triple {
    [x + factor * u, y + factor * v, z + factor * w]
}

/// The dot product.
#[must_use]
pub fn dot([x, y, z]: Triple, [u, v, w]: Triple) -> f64 {
    x * u + y * v + z * w
}

/// The product of each component.
#[must_use]
pub fn times([x, y, z]: Triple, [u, v, w]: Triple) -> Triple {
    [x * u, y * v, z * w]
}

/// The Euclidean length.
#[must_use]
pub fn length(v: Triple) -> f64 {
    dot(v, v).sqrt()
}

/// The unit vector along `v`, which is not zero.
#[must_use]
pub fn unit(v: Triple) -> Triple {
    let length = length(v);
    v.map(|part| part / length)
}

/// A unit vector at right angles to one.
pub fn across(axis: Triple, rng: &mut Rng) -> Triple {
    loop {
        let v = sphere(rng);
        let rest = add(v, axis, -dot(v, axis));
        if length(rest) > 0.1 {
            let rest = unit(rest);
            return unit(add(rest, axis, -dot(rest, axis)));
        }
    }
}

/// A unit vector, all directions alike.
pub fn sphere(rng: &mut Rng) -> Triple {
    loop {
        let v = [signed(rng), signed(rng), signed(rng)];
        let length = length(v);
        if (0.01..=1.0).contains(&length) {
            return v.map(|part| part / length);
        }
    }
}

/// From -1 to 1.
pub fn signed(rng: &mut Rng) -> f64 {
    2.0 * rng.f64() - 1.0
}

/// -1 or 1.
pub fn sign(rng: &mut Rng) -> f64 {
    if rng.bool() { 1.0 } else { -1.0 }
}

/// From `10^least` to `10^most`, all magnitudes alike.
pub fn magnitude(rng: &mut Rng, least: f64, most: f64) -> f64 {
    10f64.powf(least + (most - least) * rng.f64())
}
