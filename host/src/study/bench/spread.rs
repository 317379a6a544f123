//! `rta bench --spread --peer povray`: soft shadows and what is out of focus beside POV-Ray's, error against cost of whole processes.
//!
//! Each program's pictures are compared with a converged one of its own, since neither surfaces nor lamps are quite the same in both; the light
//! of both is cut to white.

use rta_core::color::Rgb;
use rta_scenes::description::Description;

use super::beside::process::Process;
use super::beside::{Place, Program, Rows, Work, own_program};
use super::povray::spread::Spread;
use super::povray::spread_scene;
use crate::args::BenchArgs;
use crate::picture::output::{self, Inputs};
use crate::picture::raster::Size;
use crate::study::error::StudyError;
use crate::study::report::Source;
use crate::study::report::light::raster;
use crate::study::report::measure::shown_error;

/// A setting of rta's: the most samples of a pixel, the tolerance within which it ends early, if it does, and places on a lamp for each
/// point that the eye sees.
type Setting = (u32, Option<&'static str>, u32);

/// Settings of rta's for lamps with a size.
const OURS: [Setting; 10] = [
    (4, None, 1),
    (16, None, 1),
    (16, Some(".05:1"), 2),
    (16, Some(".03:1"), 2),
    (16, Some(".04:1"), 4),
    (16, Some(".03:1"), 4),
    (32, Some(".02"), 2),
    (32, Some(".02"), 3),
    (64, Some(".02"), 2),
    (64, Some(".01"), 4),
];

/// Settings of rta's for a lens.
const OURS_OF_LENSES: [Setting; 8] = [
    (4, None, 1),
    (16, Some(".1:2"), 1),
    (16, Some(".06:2"), 1),
    (32, Some(".033:2"), 1),
    (64, Some(".0325:2"), 1),
    (64, Some(".02"), 1),
    (128, Some(".02"), 1),
    (128, Some(".01"), 1),
];

/// Samples of rta's converged picture, and its seed; that of the others is 0.
const CONVERGED: (&str, &str) = ("4096", "24301");

const fn spread(
    (lamp, adaptive): (u16, Option<u32>),
    lens: (u32, f64, f64),
    smoothing: Option<(f64, u32)>,
) -> Spread {
    Spread { lamp, adaptive, lens, smoothing }
}

/// Settings of POV-Ray's, from quick to good, for lamps with a size.
const LAMPS: [Spread; 5] = [
    spread((4, Some(0)), LENS, Some((0.1, 2))),
    spread((6, Some(0)), LENS, Some((0.1, 2))),
    spread((5, Some(1)), LENS, Some((0.2, 3))),
    spread((5, Some(0)), LENS, Some((0.1, 3))),
    spread((8, Some(1)), LENS, Some((0.1, 3))),
];

/// Settings of POV-Ray's, from quick to good, for a lens.
const LENSES: [Spread; 6] = [
    spread((8, Some(1)), (16, 0.9, 1.0 / 128.0), None),
    spread((8, Some(1)), (37, 0.9, 1.0 / 128.0), None),
    spread((8, Some(1)), (64, 0.9, 1.0 / 1024.0), None),
    spread((8, Some(1)), (128, 0.95, 1.0 / 1024.0), None),
    spread((8, Some(1)), (128, 0.99, 1.0 / 10_000.0), None),
    spread((8, Some(1)), (256, 0.99, 1.0 / 10_000.0), None),
];

/// The lens where there is none.
const LENS: (u32, f64, f64) = (16, 0.9, 1.0 / 128.0);

/// POV-Ray's converged picture of lamps: each pixel is cut as often as it may be.
const CONVERGED_LAMPS: Spread = spread((16, Some(1)), LENS, Some((0.0, 4)));

/// POV-Ray's converged picture of a lens: each pixel has all samples.
const CONVERGED_LENS: Spread = spread((4, None), (1024, 0.999_999, 0.0), None);

/// Runs `rta bench --spread --peer povray`.
///
/// # Errors
/// Those of reading a scene, [`StudyError::Still`] of one in which neither lamps nor a lens spread rays, and [`StudyError::Bench`] where a
/// program fails.
pub fn run(args: &BenchArgs) -> Result<(), StudyError> {
    let sources =
        if args.scenes.is_empty() { Source::soft()? } else { crate::study::report::sources(&args.scenes)? };
    let mut inputs = Inputs::default();
    sources.iter().for_each(|source| inputs.add(&source.scene.inputs));
    let texts = sources.iter().map(|source| compared(source, args)).collect::<Result<Vec<_>, _>>()?;
    Ok(output::print(&texts.join("\n"), &inputs)?)
}

/// Returns whether a scene has lamps with a size, and whether it has a lens.
fn spreads(scene: &Description) -> (bool, bool) {
    (
        scene.lamps.iter().any(|lamp| lamp.radius > 0.0),
        scene.optics.aperture.is_some_and(|aperture| aperture > 0.0),
    )
}

/// Returns rta's work of so many samples and more words, on `scene.rta`.
fn ours(settings: String, samples: &str, own: &[&str], (program, shared): (&str, &[String])) -> Work {
    let mut words = vec!["render", "scene.rta", "-o", "ours.pfm", "--quiet", "--device", "none"];
    words.extend(["--lamps", "area", "--samples", samples]);
    words.extend(shared.iter().map(String::as_str).chain(own.iter().copied()));
    let processes = vec![Process::new(program, &words)];
    Work { program: Program::Rta, settings, processes, picture: "ours.pfm".to_owned() }
}

/// Returns POV-Ray's work, whose scene file it writes.
fn theirs(
    (source, place): (&Source, &Place),
    name: &str,
    (args, size, aspect): (&BenchArgs, Size, f64),
    spread: &Spread,
) -> Result<Work, StudyError> {
    let scene = &source.scene.description;
    let text = spread_scene(scene, scene.model, (args.depth, aspect), spread).map_err(StudyError::bench)?;
    place.write(name, text.as_bytes())?;
    let (has_large_lamps, has_lens) = spreads(scene);
    Ok(Work::povray(name, spread.told(has_large_lamps, has_lens), spread.smoothing, size))
}

fn compared(source: &Source, args: &BenchArgs) -> Result<String, StudyError> {
    let (size, aspect) = raster(&source.scene, 1, (args.size, None))?;
    let (is_large, has_lens) = spreads(&source.scene.description);
    if !(is_large || has_lens) {
        return Err(StudyError::Still(source.title.clone()));
    }
    let (place, program) = (Place::new()?, own_program()?);
    place.write("scene.rta", &source.text)?;
    let shared = [
        ["--size".to_owned(), size.to_string()],
        ["--aspect".to_owned(), aspect.to_string()],
        ["--format".to_owned(), args.format.to_string()],
        ["--depth".to_owned(), args.depth.to_string()],
    ]
    .concat();
    let (samples, seed) = CONVERGED;
    let own = ours(String::new(), samples, &["--seed", seed], (&program, &shared));
    let (own_settings, settings, converged): (&[Setting], &[Spread], &Spread) = if has_lens {
        (&OURS_OF_LENSES, &LENSES, &CONVERGED_LENS)
    } else {
        (&OURS, &LAMPS, &CONVERGED_LAMPS)
    };
    let other = theirs((source, &place), "converged.pov", (args, size, aspect), converged)?;
    let drawn = |work: &Work| Ok::<_, StudyError>(work.drawn(place.path(), size.pixels())?.0);
    let references = [drawn(&own)?, drawn(&other)?];
    let mut works: Vec<_> = own_settings
        .iter()
        .map(|&(samples, tolerance, split)| {
            let (samples, split) = (samples.to_string(), split.to_string());
            let mut words = vec!["--threads", "1", "--split", &split];
            words.extend(tolerance.iter().flat_map(|tolerance| ["--tolerance", tolerance]));
            let early = tolerance.map(|tolerance| format!(", tolerance {tolerance}")).unwrap_or_default();
            let split = if split == "1" { String::new() } else { format!(", split {split}") };
            ours(format!("{samples} samples{early}{split}"), &samples, &words, (&program, &shared))
        })
        .collect();
    for (number, setting) in settings.iter().enumerate() {
        works.push(theirs((source, &place), &format!("{number}.pov"), (args, size, aspect), setting)?);
    }
    let compare = |work: &Work, light: &[Rgb<f32>]| {
        let [own, other] = &references;
        (None, shown_error(light, if work.program == Program::Rta { own } else { other }))
    };
    let rows = Rows::new(&works, args, (place.path(), size.pixels()), &compare)?;
    let [own, other] = &references;
    let apart = shown_error(own, other);
    Ok(format!(
        "{}\nThe converged pictures of both are {apart:.4} apart.\n",
        rows.table(&source.title, &size.to_string())
    ))
}
