//! Pictures with adaptive antialiasing: light at the corners of pixels, which are cut where it differs.

use core::cell::RefCell;

use rta_core::color::Rgb;
use rta_core::raster::Raster;
use rta_core::raster::corners::{Corners, Cutting};
use rta_core::trace::dice::Sample;
use rta_core::trace::{Observer, Trace};
use rta_core::vector::{UnitVec3, Vec3};
use rta_scenes::narrow::{Narrow, Narrowed};

use super::{Picture, PutRow, Setup};
use crate::cache::ShadowCache;

/// Room for the light within a pixel that is cut as often as may be.
const PLACES: usize = Cutting::places(Cutting::most());

/// A picture whose pixels are cut. Its rays are those of a picture with one sample a pixel.
pub(super) struct Cut<S: Narrow> {
    pub(super) single: Box<dyn Picture<S>>,
    pub(super) setup: Setup,
    pub(super) cutting: Cutting,
}

/// The rays of a picture, one by one.
struct Rays<'a, 'o, S: Narrow> {
    single: &'a dyn Picture<S>,
    /// Who is told of every ray.
    observer: RefCell<&'o mut dyn Observer<S>>,
}

impl<S: Narrow> Trace<S> for Rays<'_, '_, S> {
    type Memory = ShadowCache;

    /// In the middle of the picture: whoever asks for a direction has no place.
    fn trace<O: Observer<S> + ?Sized>(
        &self,
        _origin: Vec3<S>,
        _direction: UnitVec3<S>,
        memory: &mut ShadowCache,
        _observer: &mut O,
    ) -> Rgb<S::Light> {
        let middle = S::unit(0.0);
        self.single.sample((middle, middle), Sample::default(), memory, *self.observer.borrow_mut())
    }

    fn sample<O: Observer<S> + ?Sized>(
        &self,
        _camera: &rta_core::camera::Camera<S>,
        place: (S::Unit, S::Unit),
        sample: Sample,
        memory: &mut ShadowCache,
        _observer: &mut O,
    ) -> Rgb<S::Light> {
        self.single.sample(place, sample, memory, *self.observer.borrow_mut())
    }
}

impl<S: Narrow> Cut<S> {
    /// Calls `put` with the light of the pixels of some rows; `observer` is told of every ray.
    fn cut_rows(&self, first: u32, end: u32, put: PutRow<S>, observer: &mut dyn Observer<S>) {
        let raster = self.setup.raster;
        let rays = Rays { single: &*self.single, observer: RefCell::new(observer) };
        let width = usize::try_from(raster.width()).unwrap_or_default();
        let mut above = vec![Rgb::BLACK; width + 1];
        let camera = &self.scene().camera;
        let rows = Corners::<S, _, PLACES>::new(&rays, (camera, raster), self.cutting, &mut above, first);
        // There is room for them.
        let Some(mut rows) = rows else { return };
        let mut row = Vec::with_capacity(width);
        for _ in first..end.min(raster.height()) {
            rows.next_row(|light| row.push(light));
            put(&row);
            row.clear();
        }
    }
}

impl<S: Narrow> Picture<S> for Cut<S> {
    fn rows(&self, first: u32, end: u32, put: PutRow<S>) {
        self.cut_rows(first, end, put, &mut ());
    }

    fn observed_rows(&self, first: u32, end: u32, observer: &mut dyn Observer<S>) {
        self.cut_rows(first, end, &mut |_| {}, observer);
    }

    fn preview_rows(&self, raster: Raster, first: u32, end: u32, put: PutRow<S>) {
        self.single.preview_rows(raster, first, end, put);
    }

    fn sample(
        &self,
        place: (S::Unit, S::Unit),
        sample: Sample,
        cache: &mut ShadowCache,
        observer: &mut dyn Observer<S>,
    ) -> Rgb<S::Light> {
        self.single.sample(place, sample, cache, observer)
    }

    fn setup(&self) -> &Setup {
        &self.setup
    }

    fn scene(&self) -> &Narrowed<S> {
        self.single.scene()
    }
}
