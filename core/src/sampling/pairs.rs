//! The numbers that rays are spread by: scrambled Sobol pairs, from integers alone, without a table and without a state.
//!
//! Each purpose of each pixel (a place in the pixel, one on the lens, one on a lamp) has a sequence of pairs of its own: the first two
//! dimensions of Sobol's sequence, shuffled and scrambled as A. Owen does it ("Randomly Permuted (t,m,s)-Nets", 1995), by a hash (S.
//! Laine and T. Karras 2011, with the constants of N. Vegdahl 2021) as B. Burley has it ("Practical Hash-based Owen Scrambling",
//! JCGT 9(4), 2020). Any first 2^m pairs of a sequence are a (0, m, 2) net: each box of the size 2^-a x 2^-(m - a) holds one of them.

use crate::scalar::Unit;

/// What a pair of numbers is for. The pairs of different purposes have nothing to do with each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum Purpose {
    /// A place in a pixel.
    Pixel = 0,
    /// A place on the lens.
    Lens = 1,
    /// An instant while the shutter is open; the second number is free.
    Time = 2,
    /// The facet of a rough surface that reflects or refracts a ray.
    Lobe = 3,
    /// A place on a lamp.
    Lamp = 4,
    /// A lamp among several, and whether a path ends.
    Choice = 5,
    /// A step through the air; the second number is free.
    Air = 6,
    /// A place on a lamp that lights the air.
    Beam = 7,
    /// A place on a patch from which light is gathered; x is the patch's number in its quadrilateral, y that of the quadrilateral.
    Patch = 8,
    /// The direction from which it is gathered.
    Gather = 9,
}

impl Purpose {
    /// Returns the tag of this purpose at a ray of the tree: node 1 is the ray from the eye, 2n the ray reflected where that of node n
    /// ends, 2n + 1 the transmitted one, wrapping.
    pub const fn tag(self, node: u32) -> u32 {
        (self as u32).wrapping_add(node.wrapping_mul(16))
    }
}

/// A sequence of pairs of numbers of 32 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pairs {
    shuffle: u32,
    scramble: [u32; 2],
}

impl Pairs {
    /// Returns the sequence of the pixel in column `x` of row `y` for a tag, see [`Purpose::tag`], and a seed.
    pub fn new(x: u32, y: u32, tag: u32, seed: u32) -> Self {
        let [shuffle, u, v, _] = hash([x, y, tag, seed]);
        Self { shuffle, scramble: [u, v] }
    }

    /// Returns pair number `i`, from 0: two numbers of 32 bits behind the point.
    #[inline]
    pub fn words(&self, i: u32) -> [u32; 2] {
        self.further(i).into()
    }

    fn further(&self, i: u32) -> (u32, u32) {
        let [u, v] = self.scramble;
        drawn::<false>(self.shuffle, u, v, i)
    }

    /// Returns pair number `i`, from 0, as numbers of 0 or more and below 1.
    pub fn units<U: Unit>(&self, i: u32) -> [U; 2] {
        let (u, v) = self.further(i);
        [U::of_word(u), U::of_word(v)]
    }
}

/// Returns pair number `i`, from 0, of the sequence that [`Pairs::new`] returns for the other arguments, without the memory that this takes.
#[inline]
pub fn pair(x: u32, y: u32, tag: u32, seed: u32, i: u32) -> [u32; 2] {
    at_once(x, y, tag, seed, i).into()
}

fn at_once(x: u32, y: u32, tag: u32, seed: u32, i: u32) -> (u32, u32) {
    let [shuffle, u, v, _] = hash([x, y, tag, seed]);
    drawn::<true>(shuffle, u, v, i)
}

/// Returns a pair of a sequence, as two values that stay in registers. Two functions, each with one caller, in which it is so inlined: a
/// call costs a Cortex-M0 11 instructions of a pair's 190.
fn drawn<const AT_ONCE: bool>(shuffle: u32, u: u32, v: u32, i: u32) -> (u32, u32) {
    let [first, second] = sobol(owen(i, shuffle));
    (owen(first, u), owen(second, v))
}

/// Returns the bits of a number in another order, which `seed` decides: Owen's scrambling, in which each bit is flipped or not by a hash of
/// the bits above it.
pub const fn owen(x: u32, seed: u32) -> u32 {
    let mut v = x.reverse_bits();
    v ^= v.wrapping_mul(0x3d20_adea);
    v = v.wrapping_add(seed);
    v = v.wrapping_mul((seed >> 16) | 1);
    v ^= v.wrapping_mul(0x0552_6c56);
    v ^= v.wrapping_mul(0x53a2_2864);
    v.reverse_bits()
}

/// Returns pair number `i` of Sobol's sequence in two dimensions. The second is Pascal's triangle modulo 2, in five steps.
pub const fn sobol(i: u32) -> [u32; 2] {
    let mut second = i;
    second ^= (second >> 16) & 0x0000_ffff;
    second ^= (second >> 8) & 0x00ff_00ff;
    second ^= (second >> 4) & 0x0f0f_0f0f;
    second ^= (second >> 2) & 0x3333_3333;
    second ^= (second >> 1) & 0x5555_5555;
    [i.reverse_bits(), second.reverse_bits()]
}

/// Returns a hash of four words: `pcg4d` of M. Jarzynski and M. Olano, "Hash Functions for GPU
/// Rendering", JCGT 9(3), 2020.
#[inline] // in registers: 40 instructions of a pair's 190 on a Cortex-M0
pub const fn hash([x, y, z, w]: [u32; 4]) -> [u32; 4] {
    // One by one: a small machine's compiler would make loops of the four, of twice as many instructions.
    let (x, y, z, w) = mixed(stepped(x), stepped(y), stepped(z), stepped(w));
    let (x, y, z, w) = mixed(x ^ x >> 16, y ^ y >> 16, z ^ z >> 16, w ^ w >> 16);
    [x, y, z, w]
}

/// Returns the next word of a linear congruential generator.
const fn stepped(word: u32) -> u32 {
    word.wrapping_mul(1_664_525).wrapping_add(1_013_904_223)
}

/// Returns four words each of which depends on all.
const fn mixed(mut x: u32, mut y: u32, mut z: u32, mut w: u32) -> (u32, u32, u32, u32) {
    x = x.wrapping_add(y.wrapping_mul(w));
    y = y.wrapping_add(z.wrapping_mul(x));
    z = z.wrapping_add(x.wrapping_mul(y));
    w = w.wrapping_add(y.wrapping_mul(z));
    (x, y, z, w)
}

#[cfg(test)]
#[allow(clippy::indexing_slicing, reason = "a test may panic")]
mod tests {
    use super::*;

    #[test]
    fn words_are_those_of_the_papers() {
        assert_eq!(hash([1, 2, 3, 4]), [0x3622_cd16, 0xf114_71d8, 0xe110_9b3f, 0x02b9_4c2f]);
        assert_eq!(sobol(6), [0x6000_0000, 0x6000_0000]);
        assert_eq!(sobol(0xdead_beef), [0xf77d_b57b, 0x0c66_ae4d]);
        assert_eq!(owen(1, 0x1234_5678), 0x1679_d7f7);
        assert_eq!(owen(0x8000_0000, 0x9e37_79b9), 0x23eb_314f);
        let pairs = Pairs::new(10, 20, 4, 1);
        let first = [0, 1, 2, 3].map(|i| pairs.words(i));
        assert_eq!(
            first,
            [
                [0x7b82_fe3a, 0x307e_e28c],
                [0xe835_611f, 0xc69b_7f67],
                [0x37ac_8065, 0x972c_d405],
                [0xa9c2_95d2, 0x4ca4_44ef]
            ]
        );
    }

    #[test]
    fn each_box_of_a_net_holds_one_pair() {
        for m in 1..=10u32 {
            let pairs = Pairs::new(7, 3, Purpose::Lens.tag(1), m);
            for a in 0..=m {
                let mut held = [0u8; 1024];
                for i in 0..1u32 << m {
                    let [u, v] = pairs.words(i);
                    let cell = |word: u32, bits: u32| u64::from(word) >> (32 - bits);
                    held[usize::try_from(cell(u, a) << (m - a) | cell(v, m - a)).unwrap_or(0)] += 1;
                }
                assert!(held[..1 << m].iter().all(|&count| count == 1), "m {m}, a {a}");
            }
        }
    }

    #[test]
    fn no_two_rays_have_one_tag() {
        // Of 28 surfaces that each transmit.
        let nodes: [u32; 28] = core::array::from_fn(|depth| (2u32 << depth) - 1);
        for (i, &a) in nodes.iter().enumerate() {
            for &b in &nodes[..i] {
                assert_ne!(Purpose::Lobe.tag(a), Purpose::Lobe.tag(b));
            }
        }
    }
}
