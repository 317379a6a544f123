//! The scenes on the page about the scene language, `scenes/README.md`, each in a block of code with a name.
//!
//! ```text
//! rta NAME                 a whole scene
//! rta NAME after OTHER     lines that are added to those of another block
//! rta NAME in OTHER        lines that are added too, but take the place of the other's lines of the same statements
//! ```

use core::sync::atomic::AtomicBool;
use std::path::Path;

use rta::args::{ShowArgs, TracingArgs};
use rta::coloring::DitherKind;
use rta::device::{Device, Target};
use rta::engine::Format;
use rta::error::Error;
use rta::picture::Displayed;
use rta::picture::output::Inputs;
use rta::raster::{Aspect, Size};
use rta::render::Work;
use rta::scene::Scene;
use rta_scenes::bake::TEXELS;
use rta_scenes::error::SceneError;

/// Pixels of a scene that does not say how many it has, and samples of each.
const RASTER: &str = "picture 160 100  screen 8 5  samples 9\n";

/// A scene of the page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Example {
    /// Its name, which is that of its picture.
    pub name: String,
    /// The whole scene.
    pub text: String,
}

/// Returns the scenes of a page in their order; one that needs another has it above itself.
///
/// # Panics
/// A block has no name, or needs one that is not above it.
#[must_use]
pub fn examples(page: &str) -> Vec<Example> {
    let mut all: Vec<Example> = Vec::new();
    for block in page.split("```").skip(1).step_by(2).filter_map(|block| block.strip_prefix("rta ")) {
        let (head, own) = block.split_once('\n').expect("lines");
        let words: Vec<_> = head.split_whitespace().collect();
        let (name, text) = match words.as_slice() {
            [name] => (name, own.to_owned()),
            [name, how @ ("after" | "in"), other] => {
                let other = all.iter().find(|example| example.name == *other);
                let other = &other.unwrap_or_else(|| panic!("{name} needs a block above it")).text;
                (name, if *how == "in" { without(other, own) } else { other.clone() } + own)
            }
            _ => panic!("what is {head}?"),
        };
        all.push(Example { name: (*name).into(), text });
    }
    all
}

/// Returns the lines that do not begin with a word that lines of `own` begin with.
fn without(lines: &str, own: &str) -> String {
    let first = |line: &str| line.split_whitespace().next().unwrap_or_default().to_owned();
    let words: Vec<_> = own.lines().map(first).collect();
    lines.lines().filter(|line| !words.contains(&first(line))).map(|line| format!("{line}\n")).collect()
}

impl Example {
    /// Reads the scene.
    ///
    /// # Errors
    /// It is no scene.
    fn scene(&self) -> Result<Scene, SceneError> {
        let has_raster = self.text.lines().any(|line| line.starts_with("picture "));
        let text = self.text.clone() + if has_raster { "" } else { RASTER };
        let source = format!("{}.rta", self.name);
        let mut description = rta_scenes::read(text.as_bytes(), &source)?;
        let folder = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes"));
        description.load_pictures(folder, TEXELS).unwrap_or_else(|error| panic!("{source}: {error}"));
        Ok(Scene { source, title: self.name.clone(), description, inputs: Inputs::default() })
    }

    /// Draws the scene in Q16.16 with 256 colours, which make a small file.
    ///
    /// # Errors
    /// Those of a picture.
    ///
    /// # Panics
    /// It is no scene.
    pub fn picture(&self) -> Result<Displayed, Error> {
        let scene = self.scene().unwrap_or_else(|error| panic!("{error}"));
        let plain = ShowArgs::default().tracing;
        let plain = TracingArgs { format: Format::Q16, dither: Some(DitherKind::None), ..plain };
        let mut request = plain.request_for(Target::On(Device::Pixrect), &scene)?;
        let description = &scene.description;
        let [width, height] = description.raster.expect("it has one");
        let shape = description.settings.screen.unwrap_or([f64::from(width), f64::from(height)]);
        let [across, up] = shape;
        request.size = Some(Size::new(width, height).expect("a small size"));
        request.aspect = Some(Aspect::new(across / up).expect("a shape"));
        Work::new(&request, &scene, Some(1), &AtomicBool::new(false))?.displayed()
    }
}
