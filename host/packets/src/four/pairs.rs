//! The numbers that four samples are spread by: four times [`rta_core::sampling::pairs`], whose functions have the names of these.
//!
//! What is written as loops over four words is what a compiler makes SIMD instructions of.

use glam::Vec4;
use rta_core::sampling::pairs::hash;
use rta_core::trace::dice::Sample;

use super::vector::one;

/// Four words side by side.
pub(crate) type Words = [u32; 4];

/// Four sequences of pairs of numbers: four times [`Pairs`](rta_core::sampling::pairs::Pairs).
#[derive(Clone, Copy)]
pub(crate) struct Pairs4 {
    shuffle: Words,
    scramble: [Words; 2],
}

impl Pairs4 {
    /// Returns the sequences of the pixels of four samples for their tags and a seed.
    #[inline(always)]
    pub(crate) fn new(samples: &[Sample; 4], tags: Words, seed: u32) -> Self {
        let [first, others @ ..] = samples;
        let [tag, ..] = tags;
        // Mostly all are samples of one pixel, at the same place of their trees.
        let is_one = others.iter().all(|sample| (sample.x, sample.y) == (first.x, first.y));
        if is_one && tags == [tag; 4] {
            let [shuffle, u, v, _] = hash([first.x, first.y, tag, seed]);
            return Self { shuffle: [shuffle; 4], scramble: [[u; 4], [v; 4]] };
        }
        let [x, y] = [samples.each_ref().map(|sample| sample.x), samples.each_ref().map(|sample| sample.y)];
        Self::hashed(x, y, tags, seed)
    }

    /// Returns the sequences of four pixels by their columns and rows, for their tags and a seed: four times [`hash`].
    #[inline(never)] // inlined, it is not made SIMD instructions of: 300 instead of 130 instructions
    pub(crate) fn hashed(x: Words, y: Words, tags: Words, seed: u32) -> Self {
        let [x, y, z, w] = fold4([x, y, tags, [seed; 4]].map(stepped));
        let [shuffle, u, v, _] = fold4([x, y, z, w].map(|words| words.map(|word| word ^ word >> 16)));
        Self { shuffle, scramble: [u, v] }
    }

    /// Returns a pair of each sequence, by their numbers from 0: all first words, and all second ones.
    #[inline(never)] // inlined, it is not made SIMD instructions of: 470 instead of 260 instructions
    pub(crate) fn words(&self, numbers: Words) -> [Words; 2] {
        let [u, v] = self.scramble;
        let shuffled = reversed(mixed(reversed(numbers), self.shuffle));
        // Sobol's words are reversed bits, which are scrambled in their own order.
        [reversed(mixed(shuffled, u)), reversed(mixed(pascal(shuffled), v))]
    }

    /// Returns a pair of each sequence as numbers of 0 or more and below 1.
    #[inline(always)]
    pub(crate) fn units(&self, numbers: Words) -> [Vec4; 2] {
        self.words(numbers).map(units)
    }
}

/// Returns four words behind the point as numbers: four times [`Unit::of_word`](rta_core::scalar::Unit::of_word).
#[inline(always)]
#[allow(clippy::cast_precision_loss)] // 24 bits
pub(crate) fn units(words: Words) -> Vec4 {
    Vec4::from_array(words.map(|word| (word >> 8) as f32)) * Vec4::splat(1.0 / 16_777_216.0)
}

/// Returns four words with their bits from the last to the first.
#[inline(always)]
fn reversed(words: Words) -> Words {
    words.map(u32::reverse_bits)
}

/// Returns four words whose bits are flipped or not by a hash of the bits below them: [`owen`](rta_core::sampling::pairs::owen) on reversed
/// bits.
#[inline(always)]
fn mixed(words: Words, seeds: Words) -> Words {
    let mut mixed = words;
    for (v, seed) in mixed.iter_mut().zip(seeds) {
        *v ^= v.wrapping_mul(0x3d20_adea);
        *v = v.wrapping_add(seed);
        *v = v.wrapping_mul((seed >> 16) | 1);
        *v ^= v.wrapping_mul(0x0552_6c56);
        *v ^= v.wrapping_mul(0x53a2_2864);
    }
    mixed
}

/// Returns the second words of Sobol's sequence, their bits reversed: Pascal's triangle modulo 2.
#[inline(always)]
fn pascal(words: Words) -> Words {
    let steps = [(16, 0x0000_ffff), (8, 0x00ff_00ff), (4, 0x0f0f_0f0f), (2, 0x3333_3333), (1, 0x5555_5555)];
    steps.into_iter().fold(words, |words, (shift, mask)| words.map(|word| word ^ word >> shift & mask))
}

/// Returns the next words of four linear congruential generators.
#[inline(always)]
fn stepped(words: Words) -> Words {
    words.map(|word| word.wrapping_mul(1_664_525).wrapping_add(1_013_904_223))
}

/// Returns four times four words each of which depends on all of its four.
#[inline(always)]
fn fold4([x, y, z, w]: [Words; 4]) -> [Words; 4] {
    let x = plus_product(x, y, w);
    let y = plus_product(y, z, x);
    let z = plus_product(z, x, y);
    [x, y, z, plus_product(w, y, z)]
}

/// Returns `a + b * c` four times.
#[inline(always)]
fn plus_product(a: Words, b: Words, c: Words) -> Words {
    core::array::from_fn(|k| one(&a, k).wrapping_add(one(&b, k).wrapping_mul(one(&c, k))))
}

#[cfg(test)]
#[allow(clippy::indexing_slicing, reason = "a test may panic")]
mod tests {
    use rta_core::sampling::pairs::{Pairs, Purpose};
    use rta_core::trace::dice::Sample;

    use super::{Pairs4, units};
    use crate::four::vector::lane;

    #[test]
    fn four_pairs_are_those_of_the_core() {
        let sample = |x, y, number| Sample { x, y, number };
        let alone = [sample(10, 20, 0), sample(11, 20, 7), sample(640, 3, 12_345), sample(0, 0, u32::MAX)];
        for samples in [alone, [0, 1, 2, 3].map(|number| sample(7, 9, number)), [sample(3, 4, 5); 4]] {
            for nodes in [[1; 4], [1, 2, 9, 77]] {
                let tags = nodes.map(|node| Purpose::Lamp.tag(node));
                let four = Pairs4::new(&samples, tags, 0x9e37_79b9);
                let numbers = samples.map(|sample| sample.number);
                let ([first, second], [x, y]) = (four.words(numbers), four.units(numbers));
                for k in 0..4 {
                    let Sample { x: column, y: row, number } = samples[k];
                    let own = Pairs::new(column, row, tags[k], 0x9e37_79b9);
                    assert_eq!([first[k], second[k]], own.words(number));
                    assert_eq!([lane(&x, k), lane(&y, k)], own.units::<f32>(number));
                }
            }
        }
        assert_eq!(
            units([0, 255, 256, u32::MAX]).to_array(),
            [0.0, 0.0, 1.0 / 16_777_216.0, 1.0 - 1.0 / 16_777_216.0]
        );
    }
}
