//! A request: the picture that the options of a command ask for.

pub mod error;
pub mod fit;
pub mod sampler;
pub mod scene_file;
pub mod solution;

pub use rta_args::value::sampling;

use std::borrow::Cow;
use std::sync::Arc;

use rta_args::value::until::Until;
use rta_scenes::description::{Description, Settings};
use rta_scenes::sampler::Sampler;
use rta_scenes::solution::Solved;

use crate::args::TracingArgs;
use crate::args::light::ShownValue;
use crate::engine::{self, Cutoff, Engine, Format, MAX_DEPTH, Model};

use crate::picture::coloring::{Coloring, DitherKind};
use crate::picture::device::{Device, Target};
use crate::picture::error::PictureError;
use crate::picture::file::Caption;
use crate::picture::raster::{Aspect, Size};
use error::RequestError;
use fit::Fit;
use sampler::{SPREAD, Told, cones_format, is_of_paths, passes, put_lens, sampler, settling, with_paths};
use scene_file::SceneFile;

/// Depth of the rays where neither the command line nor the scene says it.
const DEPTH: u32 = 5;

/// A picture that is asked for: its display, its raster and how it is traced.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// The display.
    pub target: Target,
    /// Its colour table and dithering; without a device they have no meaning.
    pub coloring: Coloring,
    /// Number format.
    pub format: Format,
    /// Illumination model.
    pub model: Model,
    /// Greatest depth of a ray.
    pub depth: u32,
    /// Contribution cut-off: a ray that brings a smaller part of its light into the pixel is not traced; `None` for the model's.
    pub cutoff: Option<Cutoff>,
    /// Samples of a pixel, and what spreads their rays.
    pub sampling: Sampler,
    /// Radius of the lens and distance that is sharp, where they are not those of the scene.
    pub lens: (Option<f64>, Option<f64>),
    /// Pixels, or the display's own.
    pub size: Option<Size>,
    /// Shape of the screen, or the display's own.
    pub aspect: Option<Aspect>,
    /// Whether a scene that does not fit the number format is scaled.
    pub fit: bool,
    /// When a picture that is traced in passes is done, if its number of samples does not say it.
    pub until: Option<Until>,
    /// Radiosity that was solved for the scene.
    pub light: Option<Arc<Solved>>,
}

/// Returns the colour table and the dithering that are asked for: those that look best on the device, unless others are. A table
/// that is asked for is not dithered by itself.
fn coloring(asked: &TracingArgs, target: Target) -> Coloring {
    let best = Coloring::of(target.device().unwrap_or(Device::Vga));
    let table = asked.table.unwrap_or(best.table);
    let dither = if table == best.table { best.dither } else { DitherKind::None };
    Coloring { table, dither: asked.dither.unwrap_or(dither), samples: asked.table_samples }
}

impl Request {
    /// Returns the request of a command's arguments for a picture on `target`, before the scene is known: with the thesis's model
    /// where they name none.
    #[must_use]
    pub fn of(asked: &TracingArgs, target: Target) -> Self {
        let TracingArgs { format, size, aspect, fit, cutoff, .. } = *asked;
        Self {
            target,
            coloring: coloring(asked, target),
            format,
            model: asked.model.unwrap_or(Model::Rta),
            depth: asked.depth.unwrap_or(DEPTH),
            cutoff,
            // Told in full once there is a scene.
            sampling: sampler(&asked.spreading, None, SPREAD).unwrap_or(Sampler::CENTER),
            lens: (asked.spreading.spread.aperture, asked.spreading.spread.focus),
            size,
            aspect,
            fit,
            until: None,
            light: None,
        }
    }

    /// Returns the request of a command's arguments for a picture of `scene` on `target`: where they leave something open, it is as
    /// the scene has it.
    ///
    /// # Errors
    /// [`RequestError::TableWithoutDevice`], [`RequestError::OfSobol`] for solved light with a grid, and those of [`solution::open`], [`sampler()`] and [`Request::for_scene`].
    pub fn of_scene(asked: &TracingArgs, target: Target, scene: &SceneFile) -> Result<Self, RequestError> {
        if target == Target::None && (asked.table.is_some() || asked.dither.is_some()) {
            return Err(RequestError::TableWithoutDevice);
        }
        let request = Self::of(asked, target).for_scene(asked.model, scene)?;
        let said = &scene.description.settings;
        let Settings { depth, .. } = *said;
        let depth = asked.depth.or(depth).map_or(request.depth, |depth| depth.min(MAX_DEPTH));
        let cutoff = asked.cutoff.or(Cutoff::of(said));
        let light = solution::open(&asked.light, scene)?;
        let lit = light.as_ref().map(|light| scene.description.lit_by(light));
        let drawn = lit.as_ref().unwrap_or(&scene.description).drawn_by(request.model);
        let sampling = sampler(&asked.spreading, Some(&drawn), SPREAD)?;
        let sampling = with_paths(sampling, asked.depth, false);
        if light.is_some() && is_of_paths(&sampling) {
            return Err(RequestError::Solved);
        }
        if light.is_some() && sampling == Sampler::Cones {
            return Err(RequestError::OfCones("--light"));
        }
        if light.is_some() && sampling.spreading().is_none() {
            // Tracers of rays that are not spread know no solved light: the picture would be dark.
            return Err(RequestError::OfSobol("--light"));
        }
        let format = if sampling == Sampler::Cones { cones_format(request.format)? } else { request.format };
        Ok(Self { depth, cutoff, sampling, light, format, ..request })
    }

    /// Returns the request of a picture that is traced in passes up to an end, if there is `until`; `asked` and `scene` are those of
    /// [`Request::of_scene`].
    ///
    /// # Errors
    /// Those of [`passes()`].
    pub fn until(
        self,
        until: Option<Until>,
        asked: &TracingArgs,
        scene: &SceneFile,
    ) -> Result<Self, RequestError> {
        if until.is_none() {
            return Ok(self);
        }
        let sampling = passes(self.sampling, (&asked.spreading, "--until"), &scene.description)?;
        Ok(Self { sampling, until, ..self })
    }

    /// Returns the request of a picture whose pixels end early where their samples agree; `asked` and `scene` are those of
    /// [`Request::of_scene`].
    ///
    /// # Errors
    /// Those of [`settling`].
    pub fn settling(self, asked: &TracingArgs, scene: &SceneFile) -> Result<Self, RequestError> {
        Ok(Self { sampling: settling(self.sampling, &asked.spreading, &scene.description)?, ..self })
    }

    /// Completes the request for a scene. The model is the one that was `asked` for, else the one that the scene was made for;
    /// where neither the request nor a device states a size, it is the scene's, and so is the shape of the screen; where the scene
    /// states none, its pixels are square.
    ///
    /// # Errors
    /// [`RequestError::SceneSize`].
    pub fn for_scene(mut self, asked: Option<Model>, scene: &SceneFile) -> Result<Self, RequestError> {
        self.model = asked.unwrap_or(scene.description.model);
        if let (Target::None, None, Some([width, height])) =
            (self.target, self.size, scene.description.raster)
        {
            let failed =
                |reason| RequestError::SceneSize { name: scene.source.clone(), width, height, reason };
            let size = Size::new(width, height).map_err(failed)?;
            let screen = scene.description.settings.screen;
            let shape = || Aspect::new(screen.map_or(size.ratio(), |[width, height]| width / height));
            self.size = Some(size);
            self.aspect = Some(self.aspect.map_or_else(|| shape().map_err(failed), Ok)?);
        }
        Ok(self)
    }

    /// Returns the size of the picture in pixels and the shape of the screen that it fills (width over height).
    ///
    /// A picture smaller than its device is a window in the device's raster and keeps the shape of the device's
    /// pixels. Without a device, pixels are square, except that 320 x 200 is the 4 : 3 screen of mode 13h.
    ///
    /// # Errors
    /// [`PictureError::LargerThanDevice`], and [`RequestError::Shape`] if the window is too narrow or too wide.
    pub fn raster(&self) -> Result<(Size, f64), RequestError> {
        let (whole, whole_aspect) = (self.target.size(), self.target.aspect());
        let size = self.size.unwrap_or(whole);
        if let Target::On(device) = self.target
            && (size.width() > whole.width() || size.height() > whole.height())
        {
            return Err(PictureError::LargerThanDevice { size, device }.into());
        }
        let natural = match self.target {
            Target::On(_) => size.ratio() / whole.ratio() * whole_aspect,
            Target::None if size == whole => whole_aspect,
            Target::None => size.ratio(),
        };
        let aspect = match self.aspect {
            Some(aspect) => aspect,
            None => Aspect::new(natural).map_err(|reason| RequestError::Shape { size, reason })?,
        };
        Ok((size, aspect.ratio()))
    }

    /// Returns how the scene is to be scaled for a screen of the shape `aspect : 1`.
    #[must_use]
    pub const fn fit(&self, aspect: f64) -> Fit {
        Fit { format: self.format, aspect, model: Some(self.model), depth: self.depth, asked: self.fit }
    }

    /// Makes the scene ready to be traced as asked. If it is scaled, a line on standard error says so.
    ///
    /// # Errors
    /// Those of [`Request::raster`], [`RequestError::Refused`] and [`RequestError::Engine`].
    pub fn engine(&self, scene: &SceneFile) -> Result<Engine, RequestError> {
        let fit = self.fit(self.raster()?.1);
        self.engine_of(scene, fit.scaled(scene))
    }

    /// Makes the scene ready to be traced as asked, without a word about its scale: for the frames of a film after the first.
    ///
    /// # Errors
    /// Those of [`Request::engine`].
    pub fn quiet_engine(&self, scene: &SceneFile) -> Result<Engine, RequestError> {
        let fit = self.fit(self.raster()?.1);
        self.engine_of(scene, fit.scaled_by(scene).0)
    }

    fn engine_of(
        &self,
        scene: &SceneFile,
        mut description: Cow<'_, Description>,
    ) -> Result<Engine, RequestError> {
        let (size, aspect) = self.raster()?;
        let settings = engine::Settings {
            width: size.width(),
            height: size.height(),
            aspect,
            format: self.format,
            model: self.model,
            depth: self.depth,
            cutoff: self.cutoff,
            sampling: self.sampling,
        };
        if let Some(light) = &self.light {
            description = Cow::Owned(description.lit_by(light));
        }
        if self.lens != (None, None) {
            put_lens(self.lens, description.to_mut());
        }
        Engine::new(&description, &settings).map_err(|source| self.fit(aspect).engine_error(scene, source))
    }

    /// Returns the text that is stored in a picture of `scene`.
    #[must_use]
    pub fn caption(&self, scene: &SceneFile) -> Caption {
        let Self { target, coloring, format, model, depth, cutoff, sampling, lens, .. } = self;
        let table = match target {
            Target::On(_) => format!(", {coloring}"),
            Target::None => String::new(),
        };
        let mut settings = format!("device {target}{table}, format {format}, model {model}, depth {depth}");
        if let Some(cutoff) = cutoff.filter(|cutoff| *cutoff != Cutoff::OFF) {
            settings += &format!(", cut-off {cutoff}");
        }
        settings += &Told(sampling).to_string();
        for (length, name) in [(lens.0, "aperture"), (lens.1, "focus")] {
            settings += &length.map_or(String::new(), |length| format!(", {name} {length}"));
        }
        if let Some(light) = &self.light {
            let shown = ShownValue(light.shown);
            settings += &format!(", radiosity of {} patches, {shown}", light.solution.arriving.len());
        }
        Caption { title: scene.title.clone(), settings }
    }
}

#[cfg(test)]
mod tests;
