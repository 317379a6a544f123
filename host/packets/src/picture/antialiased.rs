//! Pictures with adaptive antialiasing: more rays where the light of neighbours differs.

mod small;

use core::cell::RefCell;

use rta_core::color::Rgb;
use rta_core::raster::Raster;
use rta_core::raster::contrast::Contrasts;
use rta_core::raster::corners::{Corners, Cutting};
use rta_core::ray::RayKind;
use rta_core::scene::Hit;
use rta_core::surface::Surface;
use rta_core::trace::decision::Start;
use rta_core::trace::dice::Sample;
use rta_core::trace::{Observer, Trace};
use rta_core::vector::{UnitVec3, Vec3};
use rta_scenes::narrow::{Narrow, Narrowed};
use rta_scenes::sampler::Adaptive;

use super::{Picture, PutRow, Setup};
use crate::cache::ShadowCache;
use small::{Corner, Objects, Small};

/// Room for the light within a pixel that is cut as often as may be.
const PLACES: usize = Cutting::places(Cutting::most());

/// Mitchell's pixels have their samples at the places of this seed.
const SEED: u32 = 0;

/// A picture with adaptive antialiasing. Its rays are those of a picture with one sample a pixel.
pub(super) struct Antialiased<S: Narrow> {
    single: Box<dyn Picture<S>>,
    setup: Setup,
    adaptive: Adaptive,
    objects: Objects,
}

/// The rays of a picture, one by one; `small` sees what they meet, where that is of interest.
struct Rays<'a, 'o, S: Narrow> {
    picture: &'a dyn Picture<S>,
    small: Option<&'a Small<'a>>,
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
        self.picture.sample((middle, middle), Sample::default(), memory, *self.observer.borrow_mut())
    }

    fn sample<O: Observer<S> + ?Sized>(
        &self,
        _camera: &rta_core::camera::Camera<S>,
        place: (S::Unit, S::Unit),
        sample: Sample,
        memory: &mut ShadowCache,
        _observer: &mut O,
    ) -> Rgb<S::Light> {
        match self.small.and_then(|small| small.corner(&sample)) {
            Some(corner) => {
                let mut observer = self.observer.borrow_mut();
                let mut both = Beside { corner, observer: &mut **observer };
                self.picture.sample(place, sample, memory, &mut both)
            }
            None => self.picture.sample(place, sample, memory, *self.observer.borrow_mut()),
        }
    }
}

/// An observer beside that of a corner.
struct Beside<'a, 'o, S: Narrow> {
    corner: Corner<'a>,
    observer: &'o mut dyn Observer<S>,
}

impl<S: Narrow> Observer<S> for Beside<'_, '_, S> {
    fn ray(&mut self, kind: RayKind, depth: u8, start: &Start<S>) {
        self.corner.ray(kind, depth, start);
        self.observer.ray(kind, depth, start);
    }

    fn hit(&mut self, hit: Option<&Hit<S>>, surface: Option<&Surface<S>>) {
        self.corner.hit(hit, surface);
        self.observer.hit(hit, surface);
    }

    fn shadow(&mut self, lamp: usize, start: &Start<S>) {
        self.observer.shadow(lamp, start);
    }
}

impl<S: Narrow> Antialiased<S> {
    pub(super) fn new(single: Box<dyn Picture<S>>, setup: Setup, adaptive: Adaptive) -> Self {
        let objects = Objects::new(single.scene(), setup.raster);
        Self { single, setup, adaptive, objects }
    }

    /// Calls `put` with each row from `first` to before `end` that `next` has added to an empty one.
    fn each(&self, (first, end): (u32, u32), put: PutRow<S>, mut next: impl FnMut(&mut Vec<Rgb<S::Light>>)) {
        let mut row = Vec::new();
        for _ in first..end.min(self.setup.raster.height()) {
            next(&mut row);
            put(&row);
            row.clear();
        }
    }

    /// Draws rows from `first` to before `end` with pixels cut.
    fn cut(
        &self,
        cutting: Cutting,
        (first, end): (u32, u32),
        put: PutRow<S>,
        observer: &mut dyn Observer<S>,
    ) -> Option<()> {
        let raster = self.setup.raster;
        let width = usize::try_from(raster.width()).ok()?;
        let small = Small::new(self.scene(), raster, cutting, &self.objects);
        let rays = Rays { picture: &*self.single, small: Some(&small), observer: RefCell::new(observer) };
        let (mut above, mut edges) = (vec![Rgb::BLACK; width + 1], vec![Rgb::BLACK; width * cutting.edges()]);
        let view = (&self.scene().camera, raster);
        let rows = Corners::<S, _, PLACES>::new(&rays, view, cutting, &mut above, first)?;
        let mut rows = rows.forced(&small).sharing(&mut edges);
        self.each((first, end), put, |row| {
            rows.next_row(|light| row.push(light));
        });
        Some(())
    }

    /// Draws rows from `first` to before `end` with more samples where the contrast is high.
    fn refined(
        &self,
        (first, end): (u32, u32),
        put: PutRow<S>,
        observer: &mut dyn Observer<S>,
    ) -> Option<()> {
        let raster = self.setup.raster;
        let width = usize::try_from(raster.width()).ok()?;
        let rays = Rays { picture: &*self.single, small: None, observer: RefCell::new(observer) };
        let mut memory = vec![Rgb::BLACK; 3 * width];
        let view = (&self.scene().camera, raster);
        let mut rows = Contrasts::new(&rays, view, SEED, &mut memory, first)?;
        self.each((first, end), put, |row| {
            rows.next_row(|light| row.push(light));
        });
        Some(())
    }
}

impl<S: Narrow> Antialiased<S> {
    /// Draws rows; `observer` is told of every ray.
    fn observed(&self, rows: (u32, u32), put: PutRow<S>, observer: &mut dyn Observer<S>) {
        // There is room for them.
        let _ = match self.adaptive {
            Adaptive::Whitted(cutting) => self.cut(cutting, rows, put, observer),
            Adaptive::Mitchell => self.refined(rows, put, observer),
        };
    }
}

impl<S: Narrow> Picture<S> for Antialiased<S> {
    fn rows(&self, first: u32, end: u32, put: PutRow<S>) {
        self.observed((first, end), put, &mut ());
    }

    fn observed_rows(&self, first: u32, end: u32, observer: &mut dyn Observer<S>) {
        self.observed((first, end), &mut |_| {}, observer);
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

#[cfg(test)]
mod tests;
