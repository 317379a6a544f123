//! `rta radiosity`: the light of all diffuse surfaces of a scene, solved once for all eyes.

use core::fmt::Write;

use crate::args::RadiosityArgs;
use crate::args::radiosity::{Factors, Method, PatchName};
use crate::engine::interrupt;
use crate::engine::radiosity::{RadiosityError, Settings, Solved, solve};
use crate::error::Error;
use crate::picture::output::{print, write_text};
use crate::request::scene_file::SceneFile;
use crate::request::solution;

/// The most quads that are told one by one.
const TOLD: usize = 64;

/// Runs `rta radiosity`: prints the mean light of each quad and the energy balance, or the radiosity of one patch, and keeps the solution.
///
/// # Errors
/// Those of reading the scene and of writing, and [`Error::Radiosity`].
pub fn run(args: &RadiosityArgs) -> Result<(), Error> {
    let scene = SceneFile::open_as(&args.scene, args.reading.into())?;
    let RadiosityArgs { format, method, factors, patches, seed, sweeps, .. } = *args;
    let settings = Settings { format, method, factors, patches, seed, sweeps };
    let solved = solve(&scene.description, &settings, interrupt::watch());
    let solved = solved.map_err(|source| Error::Radiosity { scene: scene.source.clone(), source })?;
    if let Some(path) = &args.output {
        write_text(path, &solution::text(&solved.solution, &scene.description), &scene.inputs)?;
    }
    let text = match args.patch {
        Some(name) => {
            let missing =
                || Error::Radiosity { scene: scene.source.clone(), source: no_patch(&solved, name) };
            let [r, g, b] = patch(&solved, name).ok_or_else(missing)?;
            format!("{} {} {}\n", digits(r), digits(g), digits(b))
        }
        None => table(&scene.title, &settings, &solved),
    };
    // A solution on standard output is followed by nothing else.
    let is_taken = args.output.as_ref().is_some_and(|path| path.as_os_str() == "-");
    if !is_taken {
        print(&text, &scene.inputs)?;
    }
    Ok(())
}

/// Returns the place of a quad's first patch among all, for each quad, and after them the number of all.
fn firsts(solved: &Solved) -> Vec<usize> {
    let counts =
        solved.scene.quads.iter().map(|quad| quad.patches.map(usize::from).iter().product::<usize>());
    let mut firsts = vec![0];
    for count in counts {
        firsts.push(firsts.last().copied().unwrap_or(0) + count);
    }
    firsts
}

/// Returns the radiosity of a patch; `None` where there is none of this name.
fn patch(solved: &Solved, PatchName { wall, number }: PatchName) -> Option<[f64; 3]> {
    let firsts = firsts(solved);
    let (first, end) = (*firsts.get(wall)?, *firsts.get(wall.checked_add(1)?)?);
    let place = first.checked_add(number).filter(|place| *place < end)?;
    solved.radiosity.get(place).copied()
}

fn no_patch(solved: &Solved, PatchName { wall, number }: PatchName) -> RadiosityError {
    let quads = solved.scene.quads.len();
    let patches = solved.scene.quads.get(wall).map(|quad| quad.patches);
    RadiosityError::NoSuchPatch { wall, number, quads, patches }
}

/// Formats a number with nine places.
fn digits(value: f64) -> String {
    format!("{value:.9}")
}

fn table(title: &str, settings: &Settings, solved: &Solved) -> String {
    let Solved { scene, radiosity, factors, rounds, left, is_done, balance, .. } = solved;
    let (quads, count) = (scene.quads.len(), radiosity.len());
    let mut text = format!("{title} in {}: {count} patches of {quads} quads\n", settings.format);
    // A String takes all that is written to it.
    let _ = writeln!(
        text,
        "\n{:>6}  {:>9}  radiosity, mean of the patches by area: red, green, blue",
        "quad", "patches"
    );
    let areas = rta_scenes::solution::patch_areas(scene);
    let firsts = firsts(solved);
    for (number, (quad, ends)) in scene.quads.iter().zip(firsts.windows(2)).enumerate().take(TOLD) {
        let [first, end] = *ends else { continue };
        let (mut sums, mut whole) = ([0.0; 3], 0.0);
        let own = radiosity.get(first..end).unwrap_or_default().iter();
        for (light, area) in own.zip(areas.get(first..end).unwrap_or_default()) {
            sums.iter_mut().zip(light).for_each(|(sum, light)| *sum += area * light);
            whole += area;
        }
        let [r, g, b] = sums.map(|sum| digits(sum / whole));
        let [nu, nv] = quad.patches;
        let _ = writeln!(text, "{number:>6}  {:>9}  {r} {g} {b}", format!("{nu} x {nv}"));
    }
    if quads > TOLD {
        let _ = writeln!(text, "   and {} more", quads - TOLD);
    }
    let way = match (settings.method, factors) {
        (Method::Shoot, _) => "shooting, factors of discs".to_owned(),
        (Method::Gauss, _) => format!("Gauss, factors {factors}"),
        (Method::Seidel, _) | (_, Factors::Exact) => format!("Gauss and Seidel, factors {factors}"),
        (Method::Gather, _) => format!("gathering, {factors}, lamps first"),
    };
    let (unit, rest) = match settings.method {
        Method::Shoot => ("shots", format!("unshot {left:.6} of what is emitted")),
        Method::Gauss => ("elimination", "exact but for rounding".to_owned()),
        _ => ("sweeps", format!("last change {left:.3e}")),
    };
    let verdict = if *is_done { "" } else { ": NOT DONE, it needs more --sweeps" };
    let _ = writeln!(text, "\n{way}: {rounds} {unit}, {rest}{verdict}");
    let [emitted, absorbed] = balance;
    let _ =
        writeln!(text, "{:>10}  {:>14}  {:>14}  {:>14}", "energy", "emitted", "absorbed", "part absorbed");
    for ((name, emitted), absorbed) in ["red", "green", "blue"].iter().zip(emitted).zip(absorbed) {
        let part = if *emitted > 0.0 { absorbed / emitted } else { 0.0 };
        let _ = writeln!(text, "{name:>10}  {emitted:>14.9}  {absorbed:>14.9}  {part:>14.9}");
    }
    text + "What is not absorbed leaves the scene, or meets what is no quad.\n"
}
