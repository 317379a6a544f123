//! Pictures as textures (E. Catmull 1975): pixels in a pool of words, nearest or mixed.
#![allow(clippy::cast_possible_truncation)] // sizes are at the line

use super::noise::lerp;
use crate::color::Rgb;
use crate::scalar::vector::{UnitVector, Vector};
use crate::scalar::{Scalar, Unit};

/// A picture that repeats.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Image {
    /// Number of its first pixel in the scene's pool; the others follow it row by row from above, each 0RGB.
    pub first: u32,
    /// Pixels of a row, at least 1.
    pub width: u16,
    /// Rows, at least 1.
    pub height: u16,
    /// Whether pixels have edges; they are mixed otherwise.
    pub nearest: bool,
    /// The axes of the world that it lies along, to the right and up, where not the object's own coordinates.
    pub plane: Option<[Axis; 2]>,
    /// Number of the first triangle's texture coordinates in the pool, if there are any: u and v of its three corners in 65536ths, as signed
    /// words; those of the next triangle follow. [`NO_COORDINATES`](super::NO_COORDINATES) as the first says that a triangle has none.
    pub coordinates: Option<u32>,
}

/// An axis of the world.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// To the right.
    X,
    /// Ahead.
    Y,
    /// Up.
    Z,
}

impl Axis {
    /// Returns the component along the axis.
    pub(super) fn of<V: Vector>(self, vector: V) -> V::Component {
        match self {
            Self::X => vector.x(),
            Self::Y => vector.y(),
            Self::Z => vector.z(),
        }
    }

    /// Returns the unit vector along the axis.
    pub(super) fn direction<V: UnitVector>(self) -> V {
        match self {
            Self::X => V::X,
            Self::Y => V::Y,
            Self::Z => V::Z,
        }
    }
}

impl Image {
    /// Returns the pixel in a column of a row, both from 0 and repeating, as 0RGB; black where the pool does not have it.
    fn pixel(&self, pool: &[u32], [column, row]: [i32; 2]) -> u32 {
        let [column, row] = [(column, self.width), (row, self.height)]
            .map(|(at, size)| at.rem_euclid(i32::from(size.max(1))).cast_unsigned());
        let at = self.first.saturating_add(row * u32::from(self.width) + column);
        word(pool, at)
    }

    /// Returns the registers at a place of the picture in 65536ths of it, each 0 to 65535.
    fn registers(&self, pool: &[u32], place: [i32; 2]) -> [i32; 3] {
        let [x, y] = place;
        // In 65536ths of a pixel, within the picture.
        let [x, y] = [(x, self.width), (y, self.height)]
            .map(|(part, size)| (part & 0xffff).wrapping_mul(i32::from(size)));
        if self.nearest {
            return levels(self.pixel(pool, [x >> 16, y >> 16]));
        }
        // The middles of pixels have their own colours.
        bilinear([x - 0x8000, y - 0x8000], |at| self.pixel(pool, at))
    }

    /// Returns the colour at a place of the picture in 65536ths of it. A register of 255 is 1.
    pub(crate) fn color<S: Scalar>(&self, pool: &[u32], place: [i32; 2]) -> Rgb<S::Unit> {
        let [r, g, b] = self.registers(pool, place).map(S::Unit::of_level);
        Rgb::new(r, g, b)
    }

    /// Returns the differences of the brightness, from -65535 to 65535, at the distance of 1/256 of the picture to the right and down.
    pub(crate) fn slope(&self, pool: &[u32], [x, y]: [i32; 2]) -> [i32; 2] {
        let height = |place| {
            let [r, g, b] = self.registers(pool, place);
            // The parts of the registers in brightness (ITU-R BT.709) in 256ths.
            (54 * r + 183 * g + 19 * b) >> 8
        };
        let here = height([x, y]);
        [[x.wrapping_add(256), y], [x, y.wrapping_add(256)]].map(|beside| height(beside) - here)
    }
}

/// Returns a word of the pool; 0 where it has none.
pub(super) fn word(pool: &[u32], at: u32) -> u32 {
    usize::try_from(at).ok().and_then(|at| pool.get(at)).copied().unwrap_or(0)
}

/// Returns the registers of a pixel, 0RGB, of which 65535 is the brightest.
pub(super) fn levels(pixel: u32) -> [i32; 3] {
    let [_, r, g, b] = pixel.to_be_bytes();
    [r, g, b].map(|level| i32::from(level) * 257)
}

/// Returns the mixture of the four pixels about a place in 65536ths of a pixel, whose whole parts are columns and rows.
pub(super) fn bilinear([x, y]: [i32; 2], pixel: impl Fn([i32; 2]) -> u32) -> [i32; 3] {
    let (column, row) = (x >> 16, y >> 16);
    let (right, down) = (x & 0xffff, y & 0xffff);
    let [a, b, c, d] = [[column, row], [column + 1, row], [column, row + 1], [column + 1, row + 1]]
        .map(|at| levels(pixel(at)));
    let mut mixed = [0; 3];
    for ((((mixed, a), b), c), d) in mixed.iter_mut().zip(a).zip(b).zip(c).zip(d) {
        *mixed = lerp(lerp(a, b, right), lerp(c, d, right), down);
    }
    mixed
}
