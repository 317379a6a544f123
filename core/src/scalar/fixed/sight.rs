//! A place on a sphere as seen from outside, by products of 32 bits. A Cortex-M0 has an instruction for such a product; one of 64 bits that is
//! rounded to 32 takes it 40.
//!
//! Numbers are in Q2.30, or rough: in Q.15. Where a place lies on the disc is rough; what is computed of that place is not.

use crate::scalar::integer::GUESS;
use crate::scalar::vector::Xyz;

/// 1 in Q2.30.
const ONE: i32 = 1 << 30;

/// Returns a product with a rough number, rounded.
const fn rough(product: i32) -> i32 {
    (product + (1 << 14)) >> 15
}

/// Returns the product of two numbers of up to 1 in size, within 1.5 units of the last place: the product of the lower halves, which is below one
/// unit, is left out.
const fn near(a: i32, b: i32) -> i32 {
    let (high, low) = (a >> 15, a & 0x7fff);
    let (other, rest) = (b >> 15, b & 0x7fff);
    // Each of the two is below 2^30 - 2^14. Of what is left out, the mean is a quarter of a unit.
    high * other + ((high * rest + other * low + (3 << 13)) >> 15)
}

/// Returns the product of two numbers of up to 1 in size, within 0.51 units of the last place.
const fn times(a: i32, b: i32) -> i32 {
    let (high, low) = (a >> 15, a & 0x7fff);
    let (other, rest) = (b >> 15, b & 0x7fff);
    high * other + rough(high * rest + other * low + ((low * rest) >> 15))
}

/// Returns the square of a number of up to 1 in size, within 0.51 units of the last place.
const fn square(a: i32) -> i32 {
    let (high, low) = (a >> 15, a & 0x7fff);
    high * high + rough(2 * high * low + ((low * low) >> 15))
}

/// Returns the product of a number of up to 1 in size and a rough one.
const fn mixed(a: i32, b: i32) -> i32 {
    (a >> 15) * b + rough((a & 0x7fff) * b)
}

/// Returns `1 / (2 sqrt m)` for `m` from 1/4 to 1, within 2^-11 of it.
fn guess(m: i32) -> i32 {
    // In Q.32, where 1 is no number.
    let m = (m.cast_unsigned() << 2).wrapping_sub(1);
    let i = (m >> 26).saturating_sub(16) as usize;
    let Some([here, next, ..]) = GUESS.get(i..) else { return ONE / 2 };
    let (here, next, part) = (i32::from(*here), i32::from(*next), ((m >> 10) & 0xffff).cast_signed());
    (here << 15) - (((here - next) * part) >> 1)
}

/// Returns a number times 4 to the power that takes it to 1/4 or more, and that power; 0 counts as the smallest number above it.
const fn raised(m: i32) -> (i32, u32) {
    let (mut m, mut power) = (if m > 0 { m } else { 1 }, 0);
    while m < ONE / 4 {
        m <<= 2;
        power += 1;
    }
    (m, power)
}

/// Returns where a pair of numbers from 0 to 1 lies on the unit disc, and how far from its middle: as
/// [`disc`](crate::sampling::mapping::disc), but rough. The pair is rounded to the middle of one of `2^15` parts, which is never that of the disc.
fn spot(pair: [i32; 2]) -> ([i32; 2], i32) {
    let [a, b] = pair.map(|c| (c.clamp(0, ONE - 1) >> 14 | 1) - (1 << 15));
    let is_flat = a.abs() > b.abs();
    let (along, across) = if is_flat { (a, b) } else { (b, a) };
    let radius = along.abs();
    // The quotient of the two, by a guess of the reciprocal that what it leaves over corrects.
    let (whole, power) = raised(radius << 15);
    let across = across << (2 * power);
    let half = guess(whole) >> 15;
    let inverse = rough(half * half); // a quarter of it
    let part = (across * inverse) >> 13;
    let rest = (across << 15) - part * (whole >> 15);
    let part = part + (((rest >> 6) * inverse) >> 22);
    // Sine and cosine of that part of an eighth of a turn, by the polynomials of least error.
    let square = rough(part * part);
    let sine = rough(part * (25_734 - rough(square * (2_637 - rough(square * 73)))));
    let cosine = (1 << 15) - rough(square * (10_102 - rough(square * 505)));
    let (along, across) = (rough(along * cosine), rough(radius * sine));
    (if is_flat { [along, across] } else { [across, along] }, radius)
}

/// Returns the place of the plane that stands on a unit vector, from that along the two sides of its
/// [`Frame`](crate::sampling::mapping::Frame): rough.
fn placed(axis: Xyz<i32>, [x, y]: [i32; 2]) -> Xyz<i32> {
    let size = axis.map(i32::abs);
    let Xyz { x: east, y: north, z: up } = axis.map(|c| c >> 15);
    // The axis along which it is shortest, and those that follow it.
    let is_first = size.x <= size.y && size.x <= size.z;
    let is_second = size.y <= size.z;
    let (short, next, last) = if is_first {
        (east, north, up)
    } else if is_second {
        (north, up, east)
    } else {
        (up, east, north)
    };
    // The first side is (0, last, -next) over its length, the second is at right angles to both.
    let square = ONE - short * short;
    let half = guess(square) >> 15;
    let (x, y) = ((x * half) >> 14, (y * half) >> 14);
    let sunk = rough(y * short);
    let here = -rough(y * (square >> 15));
    let after = rough(last * x + next * sunk);
    let end = rough(last * sunk - next * x);
    if is_first {
        Xyz::new(here, after, end)
    } else if is_second {
        Xyz::new(end, here, after)
    } else {
        Xyz::new(after, end, here)
    }
}

/// Returns what [`Scalar::sight`](crate::scalar::Scalar::sight) does: the direction of the place, and its cosine, that over the cosine of the angle
/// with the axis, and its distance as a part of that of the middle.
// Apart in firmware: 80 bytes less stack on a Cortex-M0, 30 instructions more.
#[cfg_attr(target_os = "none", inline(never))]
pub(super) fn sight((axis, normal): (Xyz<i32>, Xyz<i32>), sine: i32, pair: [i32; 2]) -> (Xyz<i32>, [i32; 3]) {
    let (spot, radius) = spot(pair);
    let out = placed(axis, spot);
    let radius = radius * radius;
    // The root of 1 - |p|^2, and its reciprocal: a step of Newton's iteration leaves 2^-21 of it at 1/4, 2^-27 at 1.
    let (m, power) = raised(ONE - near(square(sine), radius));
    let half = guess(m);
    let half = half + near(half, ONE / 2 - 2 * near(square(half), m));
    let along = (2 * near(m, half)) >> power;
    let aim = axis.zip(out, |a, o| near(a, along) + mixed(sine, o));
    // What is rough in that is its length, too: 1 / sqrt(1 + x) is 1 - x/2 + 3/8 x^2.
    let excess = square(aim.x) + square(aim.y) + square(aim.z) - ONE;
    let bend = ((excess >> 5) * (excess >> 5)) >> 20;
    let more = (excess - bend + (bend >> 2)) >> 1;
    let direction = aim.map(|c| c - times(c, more));
    let cosine = near(normal.x, direction.x) + near(normal.y, direction.y) + near(normal.z, direction.z);
    let mut slanted = cosine.saturating_add(near(cosine, 2 * half - ONE));
    for _ in 0..power {
        slanted = slanted.saturating_add(slanted);
    }
    // From its nearest point to the plane of the disc: rather too far, so that no ray ends within the sphere.
    let (m, power) = raised(ONE - radius);
    let height = (((m >> 15) * (guess(m) >> 15)) * 2) >> power;
    let height = (height + (height >> 12)).min(ONE);
    let reach = (along - near(sine, height)).max(0);
    (direction, [cosine, slanted.max(-i32::MAX), reach])
}

#[cfg(test)]
#[cfg(feature = "f64")]
mod tests {
    extern crate std;

    use super::*;
    use crate::light::area;
    use crate::scalar::vector::UnitVec3;

    const UNIT: f64 = 1.0 / (1u32 << 30) as f64;

    fn value(bits: i32) -> f64 {
        f64::from(bits) * UNIT
    }

    fn vector(v: Xyz<i32>) -> UnitVec3<f64> {
        UnitVec3::<f64>::new(value(v.x), value(v.y), value(v.z))
    }

    /// Numbers of Q2.30 from -1 to 1.
    fn numbers() -> impl Iterator<Item = i32> {
        let mut state = 0x9e37_79b9_7f4a_7c15u64;
        core::iter::repeat_with(move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            i32::try_from(state.cast_signed() >> 33).unwrap_or(0)
        })
    }

    #[allow(clippy::cast_possible_truncation, reason = "at most 2^30")]
    fn direction(numbers: &mut impl Iterator<Item = i32>) -> Xyz<i32> {
        loop {
            let [x, y, z] = [(); 3].map(|()| value(numbers.next().unwrap_or(0)));
            let length = libm::sqrt(x * x + y * y + z * z);
            if length > 0.1 && length < 1.0 {
                return Xyz::new(x, y, z).map(|c| libm::round(c / length / UNIT) as i32);
            }
        }
    }

    #[test]
    fn places_are_those_of_f64() {
        let mut numbers = numbers();
        let axes = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (-1, 0, 0), (0, -1, 0), (0, 0, -1)];
        for i in 0..200_000usize {
            let axis = match axes.get(i / 1000) {
                Some(&(x, y, z)) => Xyz::new(x, y, z).map(|c: i32| c * ONE),
                None => direction(&mut numbers),
            };
            let normal = direction(&mut numbers);
            let mut size = || numbers.next().unwrap_or(0).abs().min(ONE - 1);
            let sine = match i % 8 {
                0 => ONE,
                1 => 0,
                k => size() >> (3 * (k - 2)),
            };
            let pair = match i % 64 {
                0 => [0, ONE - 1],
                1 => [ONE / 2, ONE / 2],
                2 => [ONE, ONE / 2 - 1],
                _ => [size(), size()],
            };
            let (got, [cosine, slanted, reach]) = sight((axis, normal), sine, pair);
            let got = vector(got);
            // The middles of parts.
            let middles = pair.map(|c| value((c.min(ONE - 1) >> 14 | 1) << 14));
            let exact = area::sight::<f64>((vector(axis), vector(normal)), value(sine), middles);
            let what = || std::format!("{axis:?} {normal:?} {sine} {pair:?}");
            let off = got - exact.direction;
            assert!(libm::fabs(got.length() - 1.0) < 2.0 * UNIT, "length {}: {}", got.length(), what());
            assert!(off.length() < 4e-4 * value(sine) + 4.0 * UNIT, "{off:?}: {}", what());
            let exact_cosine = got.dot(vector(normal));
            assert!(libm::fabs(value(cosine) - exact_cosine) < 4.0 * UNIT, "{}", what());
            let along = exact.direction.dot(vector(axis));
            if along > 0.51 {
                let off = value(slanted) - exact_cosine / along;
                assert!(libm::fabs(off) < 5e-4 * value(sine) + 4.0 * UNIT, "slanted {off}: {}", what());
            }
            // A shadow ray ends before the sphere, by at most a thousandth of the radius.
            let short = exact.reach - value(reach);
            let radius = value(sine);
            assert!(
                along < 0.1 || short > -4.0 * UNIT && short < 1e-3 * radius + 4.0 * UNIT,
                "reach {short}: {}",
                what()
            );
        }
    }
}
