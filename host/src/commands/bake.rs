//! `rta bake`: a scene file into Rust source, for a firmware's flash.

use core::fmt::Write;
use core::sync::atomic::AtomicBool;

use rta_core::color::Rgb;
use rta_scenes::Reading;
use rta_scenes::bake::{self, BakeError, Recipe};
use rta_scenes::description::Description;
use rta_scenes::sampler::{Sampler, Spreading};
use rta_scenes::solution::Shown;

use crate::args::spreading::{SamplerKind, SpreadingArgs};
use crate::args::value::sampling::AdaptiveValue;
use crate::args::{BakeArgs, TracingArgs};
use crate::commands::render::Work;
use crate::engine::interrupt;
use crate::error::Error;
use crate::picture::coloring::{Coloring, DitherKind, TableKind};
use crate::picture::device::{Device, Target};
use crate::picture::output;
use crate::request::Request;
use crate::request::error::RequestError;
use crate::request::fit::Fit;
use crate::request::sampler::{self, put_lens};
use crate::request::scene_file::SceneFile;
use crate::request::solution;

/// Runs `rta bake`: writes the source of a scene.
///
/// # Errors
/// Those of reading the scene and of writing the source, and [`RequestError::Refused`].
pub fn run(args: &BakeArgs) -> Result<(), Error> {
    let reading = Reading::from(args.reading);
    let reading = Reading { texels: reading.texels.or(Some(bake::TEXELS)), ..reading };
    let mut scene = SceneFile::open_as(&args.scene, reading)?;
    if let Some(light) = solution::open(&args.light, &scene)? {
        if matches!(light.shown, Shown::Cache(_)) {
            return Err(RequestError::Kept.into());
        }
        scene.description = scene.description.lit_by(&light);
    }
    let model = args.model.unwrap_or(scene.description.model);
    let spreading = spreading(args, &scene.description.drawn_by(model))?;
    put_lens((args.spread.aperture, args.spread.focus), &mut scene.description);
    let aspect = args.aspect.ratio();
    let fit = Fit { format: args.format, aspect, model: Some(model), depth: 0, asked: args.fit };
    let description = fit.scaled(&scene);
    let adaptive = args.aa.map(|AdaptiveValue(adaptive)| adaptive);
    let recipe =
        Recipe { format: args.format, aspect, model, spreading, adaptive, radiosity: args.radiosity };
    let source = match bake::module(&description, &scene.title, &recipe) {
        Ok(source) => source,
        Err(BakeError::Narrow(error)) => return Err(fit.refused(&scene, error.into()).into()),
        Err(BakeError::Range(error)) => return Err(fit.refused(&scene, error.into()).into()),
        Err(error) => return Err(error.into()),
    };
    // From here on a signal waits for the file, which is soon complete; while a palette is made, it ends that.
    let stop = interrupt::watch();
    let source = match args.palette {
        Some(device) => {
            // Of the scene that is baked, which may be a scaled one.
            let baked = SceneFile { description: description.into_owned(), ..scene.clone() };
            source + &palette(args, device, &recipe, &baked, stop)?
        }
        None => source,
    };
    Ok(output::write_text(&args.output, &source, &scene.inputs)?)
}

/// Returns what spreads the rays of samples as the options have it; where they leave it open, as the scene does.
fn spreading(args: &BakeArgs, scene: &Description) -> Result<Option<Spreading>, RequestError> {
    let BakeArgs { samples, ref spread, .. } = *args;
    // A baked scene has no samples on a grid.
    let sampler = samples.map(|_| SamplerKind::Sobol);
    let asked = SpreadingArgs { samples, sampler, spread: spread.clone(), ..SpreadingArgs::default() };
    Ok(sampler::sampler(&asked, Some(scene), bake::SAMPLES)?.spreading().copied())
}

/// Returns the source of the colour table that `rta render --table baked` makes for the scene on a device.
fn palette(
    args: &BakeArgs,
    device: Device,
    recipe: &Recipe,
    scene: &SceneFile,
    stop: &AtomicBool,
) -> Result<String, Error> {
    let coloring = Coloring { table: TableKind::Baked, dither: DitherKind::None, samples: 0 };
    let aspect = Some(args.aspect);
    let (size, Recipe { format, model, spreading, adaptive, .. }) = (args.size, *recipe);
    let asked = TracingArgs { format, size, aspect, model: Some(model), ..TracingArgs::default() };
    let spread = spreading.map_or(Sampler::CENTER, Sampler::Sobol);
    let sampling = adaptive.map_or(spread, Sampler::Adaptive);
    let request = Request { coloring, sampling, ..Request::of(&asked, Target::On(device)) };
    let levels = Work::new(&request, scene, None, stop)?.quiet(true).palette(device)?;
    let gun_max = device.capabilities().gun_max;
    let mut source = format!(
        "\n/// The colour table of the whole picture on the device {device}: see [`rta_drivers::quantize::Palette`].\n\
         pub static PALETTE: ::rta_drivers::quantize::Palette = {{\n    \
         use ::rta_core::color::Rgb;\n    \
         match ::rta_drivers::quantize::Palette::new(&[\n"
    );
    for Rgb { r, g, b } in levels {
        // A String takes all that is written to it.
        let _ = writeln!(source, "        Rgb::new({r}, {g}, {b}),");
    }
    source += &format!(
        "    ], {gun_max}) {{\n        Ok(palette) => palette,\n        Err(_) => panic!(),\n    }}\n}};\n"
    );
    Ok(source)
}
