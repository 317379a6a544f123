//! Pictures in Q16.16, bit by bit, with any accelerator, illumination model and set of needs.

use core::sync::atomic::AtomicBool;

use rta::bands;
use rta::raster::Size;
use rta_core::accelerator::{Accelerator, Bvh, Lists};
use rta_core::color::Rgb;
use rta_core::illumination::{Illumination, Rta};
use rta_core::needs::{Everything, Needs};
use rta_core::raster::{Pixels, Raster};
use rta_core::sampling::Center;
use rta_core::trace::Tracer;
use rta_core::vector::Vector;
use rta_core::{Error, Q16};
use rta_packets::Packets;
use rta_scenes::accelerator::bvh::{self, Built};
use rta_scenes::description::Description;
use rta_scenes::narrow::{Narrowed, narrow};
use rta_scenes::{dat, shipped};

/// The light of a pixel as the bits of its three Q16.16 registers.
pub type Bits = Rgb<i32>;

/// Recursion depth of pictures for which a test states no other.
pub const DEPTH: u32 = 5;

/// Capacity of the stack of pending rays: the program's, so that tracers are compiled once.
const STACK: usize = 32;

/// A scene in Q16.16, and the raster that it is drawn on.
#[derive(Debug)]
pub struct Exact {
    scene: Narrowed<Q16>,
    bvh: Built<Q16>,
    packets: Packets,
    raster: Raster,
}

impl Exact {
    /// Makes a scene ready to be drawn on a 4 : 3 screen of `width` x `height` pixels.
    ///
    /// # Panics
    /// The scene does not fit Q16.16, or a side of the raster is 0.
    #[must_use]
    pub fn new(scene: &Description, width: u32, height: u32) -> Self {
        Self {
            scene: narrow::<Q16>(scene, 4.0 / 3.0).expect("the scene fits Q16.16"),
            bvh: bvh::build::<Q16>(scene),
            packets: Packets::build::<Q16>(scene),
            raster: Raster::new(width, height).expect("a raster"),
        }
    }

    /// Returns the scene in its number format.
    #[must_use]
    pub const fn scene(&self) -> &Narrowed<Q16> {
        &self.scene
    }

    /// Returns the hierarchy that firmware searches the scene with, if it has one.
    #[must_use]
    pub fn bvh(&self) -> Option<Bvh<'_, Q16>> {
        self.bvh.bvh()
    }

    /// Returns what the program searches the scene with.
    #[must_use]
    pub const fn packets(&self) -> &Packets {
        &self.packets
    }

    /// Draws as many pixels as `out` holds, from the row `first` on, row by row; the scene is searched by `accelerator`.
    ///
    /// # Errors
    /// Those of [`Tracer::new`] and of the range check.
    pub fn rows<M: Illumination<Q16>, N: Needs>(
        &self,
        accelerator: impl Accelerator<Q16>,
        model: M,
        depth: u32,
        first: u32,
        out: &mut [Bits],
    ) -> Result<(), Error> {
        let admitted = self.scene.scene().admit_with(&self.scene.camera, accelerator)?;
        let tracer: Tracer<_, M, N, STACK, _> = Tracer::new(&admitted, model, depth)?;
        let pixels =
            Pixels::sampled(&tracer, &self.scene.camera, self.raster, Center, first, self.raster.height());
        for (pixel, light) in out.iter_mut().zip(pixels) {
            *pixel = light.map(|register| register.0.to_bits());
        }
        Ok(())
    }

    /// Returns the whole picture, row by row; the scene is searched by `accelerator`.
    ///
    /// # Errors
    /// Those of [`Exact::rows`].
    pub fn searched<M: Illumination<Q16>, N: Needs>(
        &self,
        accelerator: impl Accelerator<Q16>,
        model: M,
        depth: u32,
    ) -> Result<Vec<Bits>, Error> {
        let mut pixels = vec![Bits::default(); self.pixels()];
        self.rows::<M, N>(accelerator, model, depth, 0, &mut pixels)?;
        Ok(pixels)
    }

    /// Returns the whole picture, row by row; each ray is tried with one object after the other.
    ///
    /// # Errors
    /// Those of [`Exact::rows`].
    pub fn picture<M: Illumination<Q16>, N: Needs>(&self, model: M, depth: u32) -> Result<Vec<Bits>, Error> {
        self.searched::<M, N>(Lists, model, depth)
    }

    /// Returns the whole picture in the thesis's model as the program draws it, by this number of threads.
    ///
    /// # Errors
    /// Those of the threads and of the bands.
    pub fn threaded(&self, threads: u16) -> Result<Vec<Bits>, rta::error::Error> {
        let size = Size::new(self.raster.width(), self.raster.height()).expect("a size");
        let mut pixels = Vec::with_capacity(size.pixels());
        let trace = |first, out: &mut [Bits]| {
            self.rows::<_, Everything>(&self.packets, Rta, DEPTH, first, out).expect("the scene is admitted");
        };
        bands::bands(size, &bands::pool(Some(threads))?, &AtomicBool::new(false), trace, |_, band| {
            pixels.extend(band);
            Ok::<_, rta::error::Error>(())
        })?;
        Ok(pixels)
    }

    /// Returns the number of pixels.
    #[must_use]
    pub const fn pixels(&self) -> usize {
        self.raster.width() as usize * self.raster.height() as usize
    }

    /// Returns the number of pixels in a row.
    #[must_use]
    pub const fn columns(&self) -> usize {
        self.raster.width() as usize
    }

    /// Returns the eye's coordinates as the bits of the format, to tell scenes apart in messages.
    #[must_use]
    pub fn eye(&self) -> [i32; 3] {
        let eye = self.scene.camera.eye;
        [eye.x(), eye.y(), eye.z()].map(|c| c.to_bits())
    }
}

/// Returns a scene that comes with rta, by its name without extension.
///
/// # Panics
/// There is none of that name.
#[must_use]
pub fn shipped_scene(name: &str) -> Description {
    let file = format!("{name}.dat");
    let (_, text) = shipped::ALL.iter().find(|(known, _)| *known == file).expect("a shipped scene");
    dat::read(text.as_bytes(), &file).expect("a shipped scene is well formed")
}

/// Returns the FNV-1a hash of 64 bits (Fowler, Noll and Vo; RFC 9923).
pub fn fnv1a(bytes: impl IntoIterator<Item = u8>) -> u64 {
    bytes.into_iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

/// Returns [`fnv1a`] of a picture: red, green and blue of each pixel, four bytes each, little endian.
#[must_use]
pub fn hash(pixels: &[Bits]) -> u64 {
    fnv1a(pixels.iter().flat_map(|p| [p.r, p.g, p.b]).flat_map(i32::to_le_bytes))
}

#[cfg(test)]
mod tests {
    use super::fnv1a;

    #[test]
    fn the_hash_is_that_of_its_authors() {
        assert_eq!(fnv1a([]), 0xcbf2_9ce4_8422_2325);
        assert_eq!(fnv1a(*b"a"), 0xaf63_dc4c_8601_ec8c);
        assert_eq!(fnv1a(*b"foobar"), 0x8594_4171_f739_67e8);
    }
}
