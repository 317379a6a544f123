//! The RAM that a picture's colours take on the machine that draws it.

use rta_core::Error;
use rta_core::color::Rgb;
use rta_core::raster::Raster;
use rta_core::raster::lattice::Lattice;
use rta_drivers::dither::{Cell, Damped, Diffusion, FloydSteinberg, Ordered, Plain};
use rta_drivers::quantize::{Adaptive, BOXES_SIZE, Palette, Uniform};

use crate::picture::coloring::{Coloring, DitherKind, TableKind};
use crate::picture::raster::Size;

/// Returns the bytes that colour table, dithering and pre-pass take together, with the sizes of this processor's types. What a pre-pass
/// takes, samples or the whole picture and the boxes that cut them, is free again once the table stands.
///
/// A baked table is made elsewhere and lies in flash, so only its dithering counts. A table of the whole frame costs the picture.
///
/// # Errors
/// [`Error::Raster`] if the tracer has no raster of this size.
pub fn bytes(coloring: Coloring, size: Size) -> Result<usize, Error> {
    let grid = Lattice::new(Raster::new(size.width(), size.height())?, coloring.samples()).grid();
    let samples = grid.width() as usize * grid.height() as usize;
    let table = match coloring.table {
        TableKind::Sampled | TableKind::Frame => {
            size_of::<Palette>() + samples * size_of::<Rgb<u8>>() + BOXES_SIZE
        }
        TableKind::Baked => 0,
        TableKind::Tolerant | TableKind::Adaptive => size_of::<Adaptive>(),
        TableKind::Uniform => size_of::<Uniform>(),
    };
    let row = size.columns() * size_of::<Cell>();
    let dithering = match coloring.dither {
        DitherKind::None => size_of::<Plain>(),
        DitherKind::Fs => size_of::<Diffusion<Damped, &mut [Cell]>>() + row,
        DitherKind::Fs7351 => size_of::<Diffusion<FloydSteinberg, &mut [Cell]>>() + row,
        DitherKind::Bayer => size_of::<Ordered>(),
    };
    Ok(table + dithering)
}

#[cfg(test)]
mod tests {
    use rta_drivers::quantize::{Palette, Uniform};

    use super::bytes;
    use crate::picture::coloring::{Coloring, DitherKind, TableKind};
    use crate::picture::raster::Size;

    #[test]
    fn a_pre_pass_costs_its_samples_and_diffusion_a_row() {
        let size = Size::new(320, 200).expect("small");
        let bytes = |table, dither| bytes(Coloring { table, dither, samples: 4096 }, size).expect("a raster");
        // 80 x 50 samples of 3 bytes, and 256 boxes of 8 with their number.
        let sampled = bytes(TableKind::Sampled, DitherKind::None);
        assert!((12_000 + 2048..=12_000 + 2064).contains(&(sampled - size_of::<Palette>())), "{sampled}");
        assert_eq!(bytes(TableKind::Frame, DitherKind::None) - sampled, 3 * (64_000 - 4000));
        assert_eq!(bytes(TableKind::Baked, DitherKind::None), 0);
        assert_eq!(bytes(TableKind::Uniform, DitherKind::None), size_of::<Uniform>());
        let row = bytes(TableKind::Baked, DitherKind::Fs);
        assert!((4 * 320..4 * 320 + 128).contains(&row), "{row}");
    }
}
