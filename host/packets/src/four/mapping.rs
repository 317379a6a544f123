//! Where four pairs of numbers lie on a disc and among directions: four times [`rta_core::sampling::mapping`], whose functions have the names
//! of these.

use glam::{Vec3, Vec4};
use rta_core::scalar::Unit;

use super::vector::Vec3x4;

/// Four times the sine and the cosine of an angle, in eighths of a turn from -1 to 1.
#[inline(always)]
fn sine_cosine(part: Vec4) -> (Vec4, Vec4) {
    let word = |word| Vec4::splat(<f32 as Unit>::of_word(word));
    let x = part * word(0xc90f_daa4);
    let square = x * x;
    let step = |rest: Vec4, factor| Vec4::ONE - square * word(factor) * rest;
    let sine = [0x038e_38e4, 0x0618_6188, 0x0ccc_cccd, 0x2aaa_aaac].into_iter().fold(Vec4::ONE, step);
    let cosine = [0x02d8_2d84, 0x0492_4925, 0x0888_8889, 0x1555_5555, 0x8000_0000];
    (x * sine, cosine.into_iter().fold(Vec4::ONE, step))
}

/// Returns where four pairs of numbers from 0 to 1 lie on the unit disc.
#[inline(always)]
pub(crate) fn disc([u, v]: [Vec4; 2]) -> [Vec4; 2] {
    let [a, b] = [u + u - Vec4::ONE, v + v - Vec4::ONE];
    let is_first = a.abs().cmpgt(b.abs());
    let (long, short) = (Vec4::select(is_first, a, b), Vec4::select(is_first, b, a));
    // In the middle 0 over 0 would be no number.
    let ratio = Vec4::select(long.cmpeq(Vec4::ZERO), long, short / long);
    let (sine, cosine) = sine_cosine(ratio);
    let (along, across) = (long * cosine, long * sine);
    [Vec4::select(is_first, along, across), Vec4::select(is_first, across, along)]
}

/// Returns `sqrt(1 - x^2 - y^2)` four times; 0 where that is no number.
#[inline(always)]
pub(crate) fn lifted([x, y]: [Vec4; 2]) -> Vec4 {
    (Vec4::ONE - (x * x + y * y)).max(Vec4::ZERO).sqrt()
}

/// Four times the frame of a unit vector.
#[derive(Clone, Copy)]
pub(crate) struct Frame4 {
    axis: Vec3x4,
    sides: [Vec3x4; 2],
}

impl Frame4 {
    /// Returns the frames of four unit vectors.
    #[inline(always)]
    pub(crate) fn about(axis: Vec3x4) -> Self {
        let [x, y, z] = axis.0.map(Vec4::abs);
        let is_x = x.cmple(y) & x.cmple(z);
        let is_y = y.cmple(z);
        let others = Vec3x4::select(is_y, Vec3x4::splat(Vec3::Y), Vec3x4::splat(Vec3::Z));
        let shortest = Vec3x4::select(is_x, Vec3x4::splat(Vec3::X), others);
        let first = axis.cross(shortest);
        let inverse = first.dot(first).sqrt().recip();
        let first = Vec3x4::select(inverse.cmplt(Vec4::INFINITY), first.scale(inverse), shortest);
        Self { axis, sides: [first, axis.cross(first)] }
    }

    /// Returns the vectors with these components along the two sides and the axis.
    #[inline(always)]
    pub(crate) fn vector(&self, [x, y, z]: [Vec4; 3]) -> Vec3x4 {
        let [first, second] = self.sides;
        self.axis.scale(z).plus(first, x).plus(second, y)
    }
}

#[cfg(test)]
#[allow(clippy::indexing_slicing, clippy::float_cmp, reason = "a test may panic, and is exact")]
mod tests {
    use glam::{Vec3, Vec4};
    use rta_core::sampling::mapping::{Frame, disc, lifted};

    use crate::four::pairs::units;
    use crate::four::vector::{Vec3x4, lane};

    #[test]
    fn four_places_are_those_of_the_core() {
        let mut word = 1u32;
        let mut next = || {
            word = word.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            word
        };
        let middle = [1 << 31; 4];
        for run in 0..5000 {
            let [first, second] = [(); 2].map(|()| [(); 4].map(|()| next()));
            // Also the middle of the disc, and its diagonals.
            let (u, v) = match run {
                0 => (middle, middle),
                1 => (first, middle),
                2 => (first, first),
                _ => (first, second),
            };
            let pair = [u, v].map(units);
            let [x, y] = super::disc(pair);
            let height = super::lifted([x, y]);
            let axes = [0, 1, 2, 3].map(|k| {
                let along = Vec3::new(lane(&x, k), lane(&y, k), lane(&height, k));
                [along, Vec3::X, -Vec3::Y, Vec3::Z][if run % 16 == 0 { k } else { 0 }]
            });
            let vectors = super::Frame4::about(Vec3x4::new(axes)).vector([x, y, Vec4::ONE]);
            for (k, axis) in axes.into_iter().enumerate() {
                let own = disc(pair.map(|four| lane(&four, k)));
                assert_eq!([lane(&x, k), lane(&y, k)], own);
                assert_eq!(lane(&height, k).to_bits(), lifted::<f32>(own).to_bits());
                assert_eq!(vectors.lane(k), Frame::about(axis).vector([own[0], own[1], 1.0]));
            }
        }
    }
}
