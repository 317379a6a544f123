//! The scenes on the page about the scene language, the README of `rta-scenes`, each in a block of code with a name.
//!
//! ```text
//! rta NAME                 a whole scene
//! rta NAME after OTHER     lines that are added to those of another block
//! rta NAME in OTHER        lines that are added too, but take the place of the other's lines of the same statements
//! ```

use std::path::Path;

use rta_scenes::bake::TEXELS;

use super::Tracing;
use crate::args::TracingArgs;
use crate::engine::Format;
use crate::picture::coloring::DitherKind;
use crate::picture::device::{Device, Target};
use crate::picture::file::Displayed;
use crate::picture::output::Inputs;
use crate::picture::raster::{Aspect, Size};
use crate::request::Request;
use crate::request::error::RequestError;
use crate::request::scene_file::SceneFile;
use crate::study::error::StudyError;
use crate::study::palette::traced::Traced;

/// Pixels of a scene that does not say how many it has, and samples of each.
const RASTER: &str = "picture 160 100  screen 8 5  samples 9\n";

/// A scene of the page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Example {
    /// Its name, which is that of its picture.
    pub name: String,
    /// What is to be seen in the picture, as the page has it in place of the picture.
    pub alt: String,
    /// The whole scene.
    pub text: String,
}

/// Returns the scenes of a page that have a picture there, `pictures/NAME.png`, in their order. A block that needs another has it above
/// itself; one of which that is not so is no scene.
#[must_use]
pub fn examples(page: &str) -> Vec<Example> {
    let mut all: Vec<Example> = Vec::new();
    for block in page.split("```").skip(1).step_by(2).filter_map(|block| block.strip_prefix("rta ")) {
        let Some((head, own)) = block.split_once('\n') else { continue };
        let words: Vec<_> = head.split_whitespace().collect();
        let above = |name: &str| all.iter().find(|example| example.name == name).map(|example| &example.text);
        let (name, text) = match words.as_slice() {
            [name] => (name, Some(own.to_owned())),
            [name, "after", other] => (name, above(other).map(|other| other.clone() + own)),
            [name, "in", other] => (name, above(other).map(|other| without(other, own) + own)),
            _ => continue,
        };
        all.extend(text.map(|text| Example { name: (*name).into(), alt: String::new(), text }));
    }
    let shown = |example: Example| Some(Example { alt: alt(page, &example.name)?, ..example });
    all.into_iter().filter_map(shown).collect()
}

/// Returns what a page has in place of the picture `pictures/NAME.png`, if it shows that.
fn alt(page: &str, name: &str) -> Option<String> {
    let (before, _) = page.split_once(&format!("](pictures/{name}.png)"))?;
    before.rsplit_once("![").map(|(_, alt)| alt.to_owned())
}

/// Returns the lines that do not begin with a word that lines of `own` begin with.
fn without(lines: &str, own: &str) -> String {
    let first = |line: &str| line.split_whitespace().next().unwrap_or_default().to_owned();
    let words: Vec<_> = own.lines().map(first).collect();
    lines.lines().filter(|line| !words.contains(&first(line))).map(|line| format!("{line}\n")).collect()
}

impl Example {
    /// Draws the scene in Q16.16 with 256 colours, which make a small file. The pictures of its textures are in `folder`.
    ///
    /// # Errors
    /// It is no scene, and those of a picture.
    pub fn picture(&self, folder: &Path, tracing: &Tracing) -> Result<Displayed, StudyError> {
        let has_raster = self.text.lines().any(|line| line.starts_with("picture "));
        let text = self.text.clone() + if has_raster { "" } else { RASTER };
        // Its warnings are those of the page.
        let source = format!("{}.rta", self.name);
        let description = rta_scenes::read(text.as_bytes(), &source).map_err(RequestError::from)?;
        let mut scene =
            SceneFile { source, title: self.name.clone(), description, inputs: Inputs::default() };
        let loaded = scene.description.load_pictures(folder, TEXELS);
        loaded.map_err(|source| RequestError::Texture { name: scene.source.clone(), source })?;
        let device = Device::Pixrect;
        let plain =
            TracingArgs { format: Format::Q16, dither: Some(DitherKind::None), ..TracingArgs::default() };
        let request = Request::of_scene(&plain, Target::On(device), &scene)?;
        let raster = scene.description.raster;
        let size = raster.and_then(|[width, height]| Size::new(width, height).ok());
        let shape = scene.description.settings.screen.or(raster.map(|sides| sides.map(f64::from)));
        let aspect = shape.and_then(|[across, up]| Aspect::new(across / up).ok());
        let request = Request { size, aspect, ..request };
        let traced = Traced::new(&request, &scene, tracing.pool, tracing.stop)?;
        Ok(traced.displayed(device, request.coloring)?)
    }
}
