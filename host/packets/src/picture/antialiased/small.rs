//! What is smaller than a pixel: the pixels that it lies in are cut whatever the light at their corners is (T. Whitted, "An Improved
//! Illumination Model for Shaded Display", CACM 23, 1980).
//!
//! Objects are known from the start, a bit a pixel; tiles of the floor are seen by the rays through the corners of a pixel, so that those
//! behind something cost nothing.

use core::cell::Cell;

use rta_core::raster::Raster;
use rta_core::raster::corners::{Cutting, Force};
use rta_core::ray::RayKind;
use rta_core::scene::{Hit, Object};
use rta_core::surface::Surface;
use rta_core::trace::Observer;
use rta_core::trace::decision::Start;
use rta_core::trace::dice::Sample;
use rta_core::vector::Vector;
use rta_scenes::narrow::{Narrow, Narrowed};

/// The pixels of a picture in which an object lies whose radius is below that of a pixel.
pub(super) struct Objects {
    width: u32,
    /// A bit a pixel, by rows.
    bits: Vec<u64>,
}

/// The pixels of a picture that are cut.
pub(super) struct Small<'a> {
    objects: &'a Objects,
    cutting: Cutting,
    /// For the corners of two rows, by the number of the row modulo 2: whether tiles smaller than a pixel are seen there.
    tiles: [Vec<Cell<bool>>; 2],
    /// The height of a pixel at the distance 1, in tiles; 0 without tiles of two colours.
    pixel: f64,
}

/// What the ray through a corner of pixels meets.
pub(super) struct Corner<'a> {
    pixel: f64,
    has_tiles: &'a Cell<bool>,
    /// The way from the eye to the start of the ray, along the rays before it.
    way: f64,
}

/// A vector in floats.
fn floats<S: Narrow>(v: rta_core::vector::UnitVec3<S>) -> [f64; 3] {
    [v.x(), v.y(), v.z()].map(S::unit_to_f64)
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn length(v: [f64; 3]) -> f64 {
    dot(v, v).sqrt()
}

impl Objects {
    /// Returns those of a picture of a scene. The triangles of a mesh are no objects by themselves.
    pub(super) fn new<S: Narrow>(scene: &Narrowed<S>, raster: Raster) -> Self {
        let camera = &scene.camera;
        let [forward, right, up] = [camera.forward, camera.right, camera.up].map(floats::<S>);
        let (width, height) = (raster.width(), raster.height());
        let pixels = u64::from(width) * u64::from(height);
        let words = usize::try_from(pixels.div_ceil(64)).unwrap_or_default();
        let mut objects = Self { width, bits: vec![0; words] };
        scene.scene().looks(|object, look| {
            let way = look.center - camera.eye;
            let way = [way.x(), way.y(), way.z()].map(S::to_f64);
            let depth = dot(way, forward) / dot(forward, forward);
            // Place and radius in pixels; the depth is in focal distances.
            let across = |axis: [f64; 3], pixels: u32| {
                let scale = f64::from(pixels) / (dot(axis, axis) * depth);
                (dot(way, axis) * scale, look.radius.to_f64() * length(axis) * scale)
            };
            let ((x, wide), (y, high)) = (across(right, width), across(up, height));
            let is_small = depth > 0.0 && wide.max(high) < 1.0;
            if is_small && !matches!(object, Object::Triangle(_)) {
                let (x, y) = (f64::from(width) / 2.0 + x, f64::from(height) / 2.0 - y);
                objects.mark((x - wide, x + wide), (y - high, y + high), raster);
            }
        });
        objects
    }

    /// Marks the pixels of a box, as far as it lies in the picture.
    fn mark(&mut self, (left, right): (f64, f64), (top, bottom): (f64, f64), raster: Raster) {
        let range = |from: f64, to: f64, pixels: u32| {
            let is_seen = to >= 0.0 && from < f64::from(pixels);
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "it saturates, and is cut to the picture"
            )]
            let pixel = |at: f64| (at.max(0.0) as u32).min(pixels - 1);
            if is_seen { pixel(from)..pixel(to) + 1 } else { 0..0 }
        };
        for y in range(top, bottom, raster.height()) {
            for x in range(left, right, raster.width()) {
                let (word, bit) = self.bit(x, y);
                if let Some(word) = self.bits.get_mut(word) {
                    *word |= bit;
                }
            }
        }
    }

    /// Returns the number of the word in which a pixel's bit is, and the bit.
    fn bit(&self, x: u32, y: u32) -> (usize, u64) {
        let pixel = u64::from(y) * u64::from(self.width) + u64::from(x);
        (usize::try_from(pixel / 64).unwrap_or(usize::MAX), 1 << (pixel % 64))
    }

    fn has(&self, x: u32, y: u32) -> bool {
        let (word, bit) = self.bit(x, y);
        self.bits.get(word).is_some_and(|word| word & bit != 0)
    }
}

impl<'a> Small<'a> {
    /// Returns what is smaller than a pixel of a picture.
    pub(super) fn new<S: Narrow>(
        scene: &Narrowed<S>,
        raster: Raster,
        cutting: Cutting,
        objects: &'a Objects,
    ) -> Self {
        let corners = usize::try_from(raster.width()).unwrap_or_default() + 1;
        let [forward, up] = [scene.camera.forward, scene.camera.up].map(floats::<S>);
        let colored = scene.floor.filter(|floor| floor.colors[0] != floor.colors[1]);
        let tile = colored.map(|floor| floor.tile.map_or(3.0, S::to_f64));
        let height = f64::from(raster.height());
        Self {
            objects,
            cutting,
            tiles: [(); 2].map(|()| vec![Cell::new(false); corners]),
            pixel: tile.map_or(0.0, |tile| length(up) / (length(forward) * height * tile)),
        }
    }

    /// Returns what sees the tiles at a corner of pixels; `None` for another place, and where no floor has tiles.
    pub(super) fn corner(&self, sample: &Sample) -> Option<Corner<'_>> {
        let depth = self.cutting.depth();
        let is_corner = (sample.x | sample.y).trailing_zeros() >= u32::from(depth);
        let has_tiles = self.tiles(sample.x >> depth, sample.y >> depth)?;
        (is_corner && self.pixel > 0.0).then(|| {
            has_tiles.set(false);
            Corner { pixel: self.pixel, has_tiles, way: 0.0 }
        })
    }

    fn tiles(&self, x: u32, y: u32) -> Option<&Cell<bool>> {
        let [even, odd] = &self.tiles;
        let row = if y.is_multiple_of(2) { even } else { odd };
        row.get(usize::try_from(x).ok()?)
    }
}

impl Force for &Small<'_> {
    fn is_cut(&self, x: u32, y: u32) -> bool {
        let corners = [(x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1)];
        self.objects.has(x, y) || corners.into_iter().any(|(x, y)| self.tiles(x, y).is_some_and(Cell::get))
    }
}

impl<S: Narrow> Observer<S> for Corner<'_> {
    fn ray(&mut self, kind: RayKind, _depth: u8, _start: &Start<S>) {
        if kind == RayKind::Primary {
            self.way = 0.0;
        }
    }

    fn hit(&mut self, hit: Option<&Hit<S>>, surface: Option<&Surface<S>>) {
        let (Some(hit), Some(surface)) = (hit, surface) else { return };
        // As a flat mirror shows it: of rays that part, the way of the last one that was traced.
        self.way += hit.distance.to_f64();
        if hit.object == Object::Floor {
            let slope = S::unit_to_f64(surface.incoming.z()).abs();
            // The pixel is drawn out by one over the slope.
            if self.way * self.pixel > slope {
                self.has_tiles.set(true);
            }
        }
    }
}
