//! Solid patterns on integers: places are in 65536ths of a unit, wrapping around after 32768 units, and all sums, products and shifts are
//! exact or floors (K. Perlin, "An Image Synthesizer", and D. Peachey, "Solid Texturing of Complex Surfaces", SIGGRAPH 1985).
#![allow(clippy::cast_possible_truncation)] // sizes are at the line

use crate::scalar::integer::{sqrt, wide};

/// One unit.
const ONE: i32 = 1 << 16;

/// Returns a number that looks random, of a corner of the lattice.
pub fn hash([x, y, z]: [i32; 3]) -> u32 {
    let times = |part: i32, factor: u32| part.cast_unsigned().wrapping_mul(factor);
    let mut hash = times(x, 0x8da6_b343) ^ times(y, 0xd816_3841) ^ times(z, 0xcb1a_b31f);
    hash ^= hash >> 16;
    hash = hash.wrapping_mul(0x85eb_ca6b);
    hash ^= hash >> 13;
    hash = hash.wrapping_mul(0xc2b2_ae35);
    hash ^ hash >> 16
}

/// Returns the dot product of a place relative to a corner and one of twelve directions, which the corner's hash chooses.
fn gradient(hash: u32, [x, y, z]: [i32; 3]) -> i32 {
    let hash = hash & 15;
    let u = if hash < 8 { x } else { y };
    let v = match hash {
        0..4 => y,
        12 | 14 => x,
        _ => z,
    };
    (if hash & 1 == 1 { -u } else { u }) + (if hash & 2 == 2 { -v } else { v })
}

/// Returns `3 f^2 - 2 f^3` for `f` in 65536ths below 1.
fn ease(f: i32) -> i32 {
    ((wide(f, f) * i64::from(3 * ONE - 2 * f)) >> 32) as i32
}

/// Returns `a + (b - a) w` for `w` in 65536ths below 1.
pub(super) fn lerp(a: i32, b: i32, w: i32) -> i32 {
    a + (wide(b - a, w) >> 16) as i32
}

/// Returns the noise at a place: 0 on the lattice, below 70000 in size.
pub fn noise(place: [i32; 3]) -> i32 {
    let cell = place.map(|part| part >> 16);
    let inside = place.map(|part| part & (ONE - 1));
    let [x, y, z] = inside.map(ease);
    let mut corners = [0; 8];
    for (i, value) in (0..).zip(&mut corners) {
        let at: [i32; 3] = [i & 1, i >> 1 & 1, i >> 2];
        let mut corner = cell;
        let mut from = inside;
        for ((corner, from), at) in corner.iter_mut().zip(&mut from).zip(at) {
            *corner = corner.wrapping_add(at);
            *from -= at << 16;
        }
        *value = gradient(hash(corner), from);
    }
    let [a, b, c, d, e, f, g, h] = corners;
    let near = lerp(lerp(a, b, x), lerp(c, d, x), y);
    let far = lerp(lerp(e, f, x), lerp(g, h, x), y);
    lerp(near, far, z)
}

/// Returns the sum of `octaves` absolute noises, each of twice the frequency and half the size of the one before, in 65536ths.
pub fn turbulence(octaves: u8, place: [i32; 3]) -> i32 {
    (0..u32::from(octaves.min(16)))
        .map(|octave| noise(place.map(|part| part.wrapping_shl(octave))).abs() >> octave)
        .sum()
}

/// Returns a smooth wave of period 1 that rises from 0 to 65535 and falls again.
pub fn wave(place: i32) -> u16 {
    let inside = place & (ONE - 1);
    ease((2 * inside).min(2 * ONE - 2 * inside).min(ONE - 1)) as u16
}

/// Returns how marble mixes its colours: a wave along x that turbulence bends by `amount`, in 65536ths.
pub fn marble(octaves: u8, amount: i32, place: [i32; 3]) -> u16 {
    let [x, ..] = place;
    wave(x.wrapping_add((wide(amount, turbulence(octaves, place)) >> 16) as i32))
}

/// Returns how wood mixes its colours: rings about the z axis that noise bends by `amount`, in 65536ths.
pub fn wood(amount: i32, place: [i32; 3]) -> u16 {
    let [x, y, _] = place;
    // At most 2^63.
    let square = wide(x, x).cast_unsigned() + wide(y, y).cast_unsigned();
    // The root is rounded to the nearest; its floor is asked for.
    let nearest = sqrt(square);
    let root = if u64::from(nearest).pow(2) > square { nearest - 1 } else { nearest };
    let bend = (wide(amount, noise(place)) >> 16) as i32;
    wave(root.cast_signed().wrapping_add(bend))
}

/// Returns 0 in the cubes of the first colour, where the sum of the coordinates' floors is even, and 65535 in the others.
pub fn checker([x, y, z]: [i32; 3]) -> u16 {
    if (x ^ y ^ z) >> 16 & 1 == 0 { 0 } else { u16::MAX }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns_hold_to_the_ends_of_the_lattice() {
        let ends = [i32::MIN, i32::MIN + 1, -65_537, -1, 0, 1, 65_535, i32::MAX - 1, i32::MAX];
        for place in ends.iter().flat_map(|&x| ends.map(|y| [x, y, x ^ y])) {
            assert!(noise(place).abs() < 70_000, "{place:?}");
            for amount in ends {
                // Any result is a mixture; none may overflow.
                let _ = (marble(16, amount, place), wood(amount, place), checker(place));
            }
        }
    }

    #[test]
    fn noise_has_no_steps_and_is_0_on_the_lattice() {
        for at in -300_000..300_000 {
            let place = [at, 3 * at, 77_777];
            let step = (noise(place) - noise([at + 1, 3 * at, 77_777])).abs();
            assert!(step <= 8, "a step of {step} at {at}");
        }
        for cell in -40..40 {
            assert_eq!(noise([cell << 16, -cell << 17, cell << 16]), 0);
        }
    }
}
