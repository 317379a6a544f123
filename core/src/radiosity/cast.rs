//! Along which rays a patch sees the others.

use core::marker::PhantomData;

use crate::sampling::mapping::{disc, lifted};
use crate::sampling::pairs::{Purpose, pair};
use crate::scalar::vector::{UnitVec3, UnitVector, Vector};
use crate::scalar::{Scalar, Unit};

/// One ray from a patch.
#[derive(Clone, Copy, Debug)]
pub struct Cast<S: Scalar> {
    /// Where it begins: the parts of the patch along u and v, 0 to 1.
    pub place: [S::Unit; 2],
    /// Its unit direction, along u, across it and along the normal.
    pub direction: [S::Unit; 3],
    /// The part of all that arrives that arrives along it; those of a patch's rays come to about 1.
    pub weight: S::Unit,
}

/// The rays from a patch, along which it sees the others.
pub trait Casts<S: Scalar>: Copy + Send + Sync {
    /// Whether so many rays meet edges of patches exactly that it matters whose those are: that of the highest number.
    const TIES: bool = false;
    /// Returns how many rays there are.
    fn count(&self) -> u32;
    /// Returns ray number `k` of the patch with the number `patch` in quadrilateral number `quad`.
    fn cast(&self, patch: u32, quad: u32, k: u32) -> Cast<S>;
}

/// Rays from places all over a patch, in directions that are as frequent as their cosine. A power of two is best.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rays {
    /// How many, 1 or more.
    pub count: u32,
    /// The seed of the sequence of numbers.
    pub seed: u32,
}

impl<S: Scalar> Casts<S> for Rays {
    fn count(&self) -> u32 {
        self.count
    }

    fn cast(&self, patch: u32, quad: u32, k: u32) -> Cast<S> {
        let pair = |purpose: Purpose| {
            let [u, v] = pair(patch, quad, purpose.tag(0), self.seed, k);
            [S::Unit::of_word(u), S::Unit::of_word(v)]
        };
        let [x, y] = disc(pair(Purpose::Gather));
        Cast {
            place: pair(Purpose::Patch),
            direction: [x, y, lifted::<S>([x, y])],
            weight: S::Unit::fraction(1, self.count),
        }
    }
}

/// Rays through the middles of the cells of half a cube about the middle of a patch: M. Cohen and D. Greenberg 1985. The cells are traced, so
/// that no second algorithm decides what is seen.
#[derive(Clone, Copy, Debug)]
pub struct HemiCube<S: Scalar> {
    side: u16,
    /// The weight of a cell in the middle of the top: `(2/n)^2 / pi`.
    middle: S::Unit,
    scalar: PhantomData<S>,
}

impl<S: Scalar> HemiCube<S> {
    /// Returns a hemi-cube with `side x side` cells on top and half of that on each of four sides; `None` where `side` is odd, 0, or above
    /// 1024.
    pub fn new(side: u16) -> Option<Self> {
        let is_right = side > 0 && side.is_multiple_of(2) && side <= 1024;
        let cells = u32::from(side).pow(2) / 2;
        // 2/pi, which is taken within 2^-32, over the number of cells of half the top.
        let middle = S::Unit::of_word(0xa2f9_836e).times(S::Unit::fraction(1, cells));
        is_right.then_some(Self { side, middle, scalar: PhantomData })
    }
}

/// Edges of walls that stand in a row with the middles of cells are met exactly.
impl<S: Scalar> Casts<S> for HemiCube<S> {
    const TIES: bool = true;

    fn count(&self) -> u32 {
        3 * u32::from(self.side).pow(2)
    }

    fn cast(&self, _patch: u32, _quad: u32, k: u32) -> Cast<S> {
        let side = u32::from(self.side);
        let (half, one) = (S::Unit::ratio(1, 2), S::Unit::ONE);
        let (row, column) = (k / side, k % side);
        // Half of what lies between -1 and 1, as a vector of half the length has room. The middle of a cell is an odd number of half cells.
        let along =
            |cell: u32| S::Unit::fraction((2 * cell + 1).cast_signed() - side.cast_signed(), 2 * side);
        let across = along(column);
        let (face, vector) = if row < side {
            (4, [across, along(row), half])
        } else {
            // Four sides of half the height, from the bottom up: towards u, towards v, and away from them.
            let (face, row) = ((row - side) / (side / 2), (row - side) % (side / 2));
            let up = S::Unit::fraction((2 * row + 1).cast_signed(), 2 * side);
            (
                face,
                match face {
                    0 => [half, across, up],
                    1 => [across, half, up],
                    2 => [-half, across, up],
                    _ => [across, -half, up],
                },
            )
        };
        let [x, y, z] = vector;
        let direction = UnitVec3::<S>::new(x, y, z);
        let direction = direction.normalize().map_or(UnitVec3::<S>::Z, |(direction, _)| direction);
        let [x, y, z] = [direction.x(), direction.y(), direction.z()];
        // The cosines with the patch's normal and with the face's; 1 over the latter is the distance of the cell.
        let near = match face {
            4 => z,
            0 => x,
            1 => y,
            2 => -x,
            _ => -y,
        };
        let near = near.times(near).times(near);
        let weight = self.middle.times(near.times(z));
        Cast { place: [one.times(half); 2], direction: [x, y, z], weight }
    }
}
