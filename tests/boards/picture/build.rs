//! Bakes the scene that is drawn. It is chosen by environment variables, so that one package serves every picture:
//!
//! | variable | what it is | unless it is set |
//! | --- | --- | --- |
//! | `RTA_SCENE` | the scene file | the Juggler |
//! | `RTA_MODEL` | the illumination model, by its name | the scene's own |
//! | `RTA_FORMAT` | `q16`, `q20` or `f32` | `q16` |
//! | `RTA_LAMPS` | `point`; `area`: places on lamps with a size, so that shadows have soft edges | `point` |
//! | `RTA_SAMPLES` | samples of a pixel, a power of two | where something spreads rays, what the scene says, or 4 |
//! | `RTA_AA` | `none`; `whitted`: pixels are cut where the light at their corners differs; `mitchell`: they have more samples where the contrast is high; nothing is spread then | `none` |
//! | `RTA_LIGHT` | `lamps`; `radiosity`: the board solves for the indirect light, too | `lamps` |
//! | `RTA_EYE` | `rays`; `buffer`: rays from the eye are found by a Z-buffer of one row | `rays` |
//! | `RTA_NEEDS` | `baked`: only what the scene needs; `everything` | `baked` |
//! | `RTA_COLORS` | `standard`: the board's own colour table; `sampled`: a palette made for the picture; `dithered`: that, with error diffusion | `standard` |
//! | `RTA_SIZE` | width and height in pixels | `160x100` |

use std::env;
use std::error::Error;
use std::fs;
use std::path::PathBuf;

use rta_scenes::bake::{Format, Model, Recipe, SAMPLES, bake_by};
use rta_scenes::sampler::{Adaptive, Cutting, Integrator, Lamps, Sobol, Spreading};

fn main() -> Result<(), Box<dyn Error>> {
    let variable = |name: &str, default: &str| {
        println!("cargo::rerun-if-env-changed={name}");
        env::var(name).unwrap_or_else(|_| default.to_owned())
    };
    let juggler = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../scenes/juggler.dat");
    let format = match variable("RTA_FORMAT", "q16").as_str() {
        "q16" => Format::Q16,
        "q20" => Format::Q20,
        "f32" => Format::F32,
        other => return Err(format!("RTA_FORMAT is q16, q20 or f32, not {other}").into()),
    };
    let file = variable("RTA_SCENE", juggler);
    let model = match variable("RTA_MODEL", "").as_str() {
        "" => None,
        name => {
            let model = Model::ALL.iter().copied().find(|model| model.name() == name);
            Some(model.ok_or_else(|| format!("RTA_MODEL is an illumination model, not {name}"))?)
        }
    };
    let lamps = match variable("RTA_LAMPS", "point").as_str() {
        "point" => Lamps::Point,
        "area" => Lamps::Area,
        other => return Err(format!("RTA_LAMPS is point or area, not {other}").into()),
    };
    let samples = match variable("RTA_SAMPLES", "").as_str() {
        "" => None,
        number => Some(Sobol::new(number.parse()?, 0).ok_or("RTA_SAMPLES is a number from 1 to 16384")?),
    };
    let adaptive = match variable("RTA_AA", "none").as_str() {
        "none" => None,
        "whitted" => Some(Adaptive::Whitted(Cutting::default())),
        "mitchell" => Some(Adaptive::Mitchell),
        other => return Err(format!("RTA_AA is none, whitted or mitchell, not {other}").into()),
    };
    let radiosity = match variable("RTA_LIGHT", "lamps").as_str() {
        "lamps" => false,
        "radiosity" => true,
        other => return Err(format!("RTA_LIGHT is lamps or radiosity, not {other}").into()),
    };
    let buffered = match variable("RTA_EYE", "rays").as_str() {
        "rays" => false,
        "buffer" => true,
        other => return Err(format!("RTA_EYE is rays or buffer, not {other}").into()),
    };
    let scene = bake_by(file, |scene| {
        let recipe = Recipe::of(format, scene);
        let model = model.unwrap_or(recipe.model);
        let natural = Spreading::of(scene, lamps, SAMPLES);
        let integrator = Integrator::Whitted;
        let asked = |samples| Some(Spreading { samples, lamps, split: 1, integrator });
        let spreading = samples.map_or(natural, asked);
        Recipe { model, spreading, adaptive, radiosity, ..recipe }
    })?;
    let (needs, baked) = match variable("RTA_NEEDS", "baked").as_str() {
        "baked" => ("scene::Needs", true),
        "everything" => ("rta_core::needs::Everything", false),
        other => return Err(format!("RTA_NEEDS is baked or everything, not {other}").into()),
    };
    let colors = match variable("RTA_COLORS", "standard").as_str() {
        "standard" => "Standard",
        "sampled" => "Sampled",
        "dithered" => "Dithered",
        other => return Err(format!("RTA_COLORS is standard, sampled or dithered, not {other}").into()),
    };
    let size = variable("RTA_SIZE", "160x100");
    let (width, height) = size.split_once('x').ok_or("RTA_SIZE is a width, an x, and a height")?;
    let (width, height): (u32, u32) = (width.parse()?, height.parse()?);
    let choice = format!(
        "mod scene {{\n    include!({scene:?});\n}}\n\
         type Needs = {needs};\n\
         /// Whether the program is for this scene alone. Otherwise the compiler must not know what it will draw.\n\
         const BAKED: bool = {baked};\n\
         /// Whether rays from the eye are found by a Z-buffer.\nconst BUFFERED: bool = {buffered};\n\
         /// How the colours of the picture are chosen.\nconst COLORS: Colors = Colors::{colors};\n\
         /// Pixels in a row.\npub const WIDTH: u32 = {width};\n\
         /// Rows.\npub const HEIGHT: u32 = {height};\n"
    );
    fs::write(PathBuf::from(env::var("OUT_DIR")?).join("choice.rs"), choice)?;
    Ok(())
}
