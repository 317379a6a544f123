//! Some of the pixels of a raster, evenly spread over it: the samples from which a display's colour table is made before the picture
//! is drawn.

use super::{Center, Places, Raster};
use crate::color::Rgb;
use crate::scalar::{Light, Unit};

/// A grid of `n x m` pixels of a raster of `w x h`, as square as the raster's pixels: column `i` of the grid is column
/// `floor((2i + 1) w / 2n)` of the raster, and so for the rows.
///
/// It places one sample in the middle of each of these pixels, so [`Pixels::sampled`](super::Pixels::sampled) on the
/// [grid](Lattice::grid) gives their light, row by row, just as the picture will have it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lattice {
    grid: Raster,
    raster: Raster,
}

impl Lattice {
    /// Returns a grid of at most `most` pixels of `raster`, at least one: all of them, if there are no more.
    pub fn new(raster: Raster, most: usize) -> Self {
        let (width, height) = (u64::from(raster.width), u64::from(raster.height));
        let most = u64::try_from(most).unwrap_or(u64::MAX).max(1);
        if width * height <= most {
            return Self { grid: raster, raster };
        }
        // The raster has more than `most` pixels, so the grid is smaller than it: n * m <= n * (n * h / w) <= most. A raster that is so
        // narrow or so low that no grid is as square gets a single column or row.
        let columns = (most * width / height).isqrt().clamp(1, width.min(most));
        let rows = (columns * height / width).clamp(1, (most / columns).min(height));
        let grid = Raster { width: side(columns), height: side(rows) };
        Self { grid, raster }
    }

    /// Returns how many columns and rows the grid has, as a raster.
    pub const fn grid(self) -> Raster {
        self.grid
    }

    /// Returns the pixel of the raster, column and row, that is in column `i` and row `j` of the grid.
    pub const fn pixel(self, i: u32, j: u32) -> (u32, u32) {
        (spread(i, self.grid.width, self.raster.width), spread(j, self.grid.height, self.raster.height))
    }

    /// Returns all of these pixels, row by row.
    pub fn pixels(self) -> impl Iterator<Item = (u32, u32)> {
        (0..self.grid.height).flat_map(move |j| (0..self.grid.width).map(move |i| self.pixel(i, j)))
    }
}

/// A side of a raster, which is at most 65535.
fn side(pixels: u64) -> u32 {
    u32::try_from(pixels).unwrap_or(Raster::MAX_SIDE)
}

/// Returns `floor((2i + 1) of / 2n)`. For `i < n` and sides of at most 65535 no product exceeds 2^33.
#[allow(clippy::cast_possible_truncation, reason = "the quotient is below `of`")]
const fn spread(i: u32, n: u32, of: u32) -> u32 {
    ((2 * i as u64 + 1) * of as u64 / (2 * n as u64)) as u32
}

impl Places for Lattice {
    type Row<U: Unit> = U;

    fn samples(&self) -> u32 {
        1
    }

    fn row<U: Unit>(&self, _grid: Raster, j: u32) -> U {
        Center.row(self.raster, self.pixel(0, j).1)
    }

    fn place<U: Unit>(&self, _grid: Raster, row: U, i: u32, sample: u32) -> (U, U) {
        Center.place(self.raster, row, self.pixel(i, 0).0, sample)
    }

    fn add<L: Light>(&self, sum: Rgb<L>, light: Rgb<L>) -> Rgb<L> {
        Center.add(sum, light)
    }

    fn mean<L: Light>(&self, sum: Rgb<L>) -> Rgb<L> {
        Center.mean(sum)
    }
}

#[cfg(test)]
mod tests {
    use super::{Lattice, Raster};

    fn raster(width: u32, height: u32) -> Raster {
        Raster::new(width, height).expect("sides of a raster")
    }

    #[test]
    fn a_grid_is_as_square_as_the_raster_and_never_larger_than_asked() {
        for ((width, height), most, grid) in [
            ((320, 200), 4096, (80, 50)),
            ((1024, 1024), 4096, (64, 64)),
            ((1152, 900), 4096, (72, 56)),
            ((160, 100), 1024, (40, 25)),
            ((64, 64), 4096, (64, 64)),
            ((65535, 1), 4096, (4096, 1)),
            ((1, 65535), 4096, (1, 4096)),
            ((65535, 65535), 1, (1, 1)),
            ((3, 2), 0, (1, 1)),
            ((65535, 65535), usize::MAX, (65535, 65535)),
        ] {
            let lattice = Lattice::new(raster(width, height), most);
            assert_eq!(lattice.grid(), raster(grid.0, grid.1), "{width}x{height}, {most}");
        }
    }

    #[test]
    fn no_grid_is_too_large() {
        for (width, height) in [(7, 5), (5, 7), (1, 9), (320, 200), (31, 65535), (65535, 2)] {
            for most in 1..200 {
                let grid = Lattice::new(raster(width, height), most).grid();
                assert!(
                    grid.width() as usize * grid.height() as usize <= most,
                    "{width}x{height}, {most}: {grid:?}"
                );
            }
        }
    }

    #[test]
    fn the_pixels_are_evenly_spread() {
        let lattice = Lattice::new(raster(320, 200), 4096);
        assert_eq!(
            [lattice.pixel(0, 0), lattice.pixel(1, 1), lattice.pixel(79, 49)],
            [(2, 2), (6, 6), (318, 198)]
        );
        assert!(lattice.pixels().nth(81) == Some((6, 6)) && lattice.pixels().count() == 80 * 50);
        let all = Lattice::new(raster(5, 3), 15);
        assert!((0..5).all(|i| all.pixel(i, i.min(2)) == (i, i.min(2))));
    }
}
