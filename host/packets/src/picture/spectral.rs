//! Pictures of several wavelengths: one ray at a time, in every number format.

use rta_core::color::Rgb;
use rta_core::needs::Everything;
use rta_core::raster::Raster;
use rta_core::scalar::Unit;
use rta_core::trace::dice::Sample;
use rta_core::trace::{Observer, Trace};
use rta_scenes::narrow::Narrowed;
use rta_scenes::sampler::Sampler;
use rta_scenes::shading::{AnySpectrum, Wavelengths};

use super::{Format, MAX_DEPTH, Picture, PutRow, Ready, Setup};
use crate::cache::ShadowCache;
use crate::packets::Packets;
use crate::rows::put_rows;

/// A picture whose light depends on the wavelength.
pub(super) struct Spectral<S: Format> {
    pub(super) ready: Ready<S>,
    pub(super) wavelengths: Wavelengths<S>,
}

type Traced<'t, 'a, S> = AnySpectrum<'t, S, Everything, { MAX_DEPTH as usize }, &'a Packets>;

impl<S: Format> Spectral<S> {
    /// Returns what `draw` makes of the tracer of the picture.
    fn with_tracer<'a, R>(&'a self, draw: impl FnOnce(&Traced<'_, 'a, S>) -> R) -> Option<R> {
        let Setup { depth, cutoff, .. } = self.ready.setup;
        let admitted = self.ready.admitted();
        let cutoff = cutoff.map(|(numerator, denominator)| S::Unit::ratio(numerator, denominator));
        // There is a tracer: the depth was checked when the picture was made ready.
        self.wavelengths.with_tracer(&self.ready.scene, &admitted, (depth, cutoff), draw).ok()
    }

    fn traced(&self, raster: Raster, places: Sampler, rows: (u32, u32), put: PutRow<S>) {
        let camera = &self.ready.scene.camera;
        self.with_tracer(|tracer| put_rows(tracer, camera, (raster, places), rows, put));
    }
}

impl<S: Format> Picture<S> for Spectral<S> {
    fn rows(&self, first: u32, end: u32, put: PutRow<S>) {
        let Setup { raster, sampling, .. } = self.ready.setup;
        self.traced(raster, sampling, (first, end), put);
    }

    fn preview_rows(&self, raster: Raster, first: u32, end: u32, put: PutRow<S>) {
        self.traced(raster, Sampler::CENTER, (first, end), put);
    }

    fn sample(
        &self,
        place: (S::Unit, S::Unit),
        sample: Sample,
        cache: &mut ShadowCache,
        observer: &mut dyn Observer<S>,
    ) -> Rgb<S::Light> {
        let camera = &self.ready.scene.camera;
        self.with_tracer(|tracer| tracer.sample(camera, place, sample, cache, observer)).unwrap_or(Rgb::BLACK)
    }

    fn setup(&self) -> &Setup {
        &self.ready.setup
    }

    fn scene(&self) -> &Narrowed<S> {
        &self.ready.scene
    }
}
