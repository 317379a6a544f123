//! The scene that is shown, at each instant of its film.

use std::sync::Arc;

use crate::engine::Engine;
use crate::error::Error;
use crate::request::Request;
use crate::request::error::RequestError;
use crate::request::scene_file::SceneFile;

/// A scene, how it is traced, and how many frames its film has.
#[derive(Clone, Debug)]
pub struct Source {
    scene: Arc<SceneFile>,
    request: Request,
    frames: Option<u32>,
}

impl Source {
    /// Returns a scene that is to be traced as `request` has it: one picture, or the frames of a film.
    #[must_use]
    pub const fn new(scene: Arc<SceneFile>, request: Request, frames: Option<u32>) -> Self {
        Self { scene, request, frames }
    }

    /// How the scene is traced.
    #[must_use]
    pub const fn request(&self) -> &Request {
        &self.request
    }

    /// Returns how many frames the film has; one picture is one.
    #[must_use]
    pub fn frames(&self) -> u32 {
        self.frames.unwrap_or(1)
    }

    /// Makes the first frame ready to be traced. If the scene is scaled, a line on standard error says so.
    ///
    /// # Errors
    /// Those of [`Request::engine`], of a film as [`Error::Frame`].
    pub fn first_engine(&self) -> Result<Engine, Error> {
        self.made(0, Request::engine)
    }

    /// Makes a frame ready to be traced.
    ///
    /// # Errors
    /// Those of [`Source::first_engine`].
    pub fn engine(&self, number: u32) -> Result<Engine, Error> {
        self.made(number, Request::quiet_engine)
    }

    fn made(
        &self,
        number: u32,
        make: impl Fn(&Request, &SceneFile) -> Result<Engine, RequestError>,
    ) -> Result<Engine, Error> {
        let Some(frames) = self.frames else { return Ok(make(&self.request, &self.scene)?) };
        let instant = f64::from(number) / f64::from(frames);
        let made = make(&self.request, &self.scene.at(instant));
        made.map_err(|source| Error::Frame { number, instant, source: Box::new(source.into()) })
    }
}
