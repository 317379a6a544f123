//! `rta merge`: parts of a picture, or of a film, into a file.

use core::ops::Range;
use core::sync::atomic::AtomicBool;
use std::fs::File;
use std::io::{self, Read, Write};
use std::path::Path;

use rayon::ThreadPool;
use rta_core::color::Rgb;
use rta_core::raster::lattice::Lattice;

use crate::args::MergeArgs;
use crate::commands::render::{Source, Work};
use crate::engine::bands::BandsError;
use crate::engine::interrupt;
use crate::error::Error;
use crate::picture::device::Target;
use crate::picture::error::{PictureError, name};
use crate::picture::file::film::FilmWriter;
use crate::picture::output::{Failure, Inputs, PictureOutput};
use crate::picture::part::{Light, MergeError, Part, Whole};

/// Runs `rta merge`.
///
/// # Errors
/// All of [`MergeError`], and those of files.
pub fn run(args: &MergeArgs) -> Result<(), Error> {
    let output = PictureOutput::open(&args.output, args.file_type)?;
    let file_type = output.file_type();
    let mut inputs = Inputs::default();
    let mut parts = Vec::new();
    for path in &args.parts {
        let (part, input) = read(path)?;
        inputs.add(&input);
        parts.push((path.as_path(), part));
    }
    let output = output.beside(&inputs)?;
    let (whole, joined) = join(parts)?;
    match (whole.target, file_type.is_linear()) {
        (Target::On(device), true) => return Err(PictureError::LinearFromDevice { file_type, device }.into()),
        (_, linear) if linear != whole.is_linear => return Err(PictureError::OtherLight(file_type).into()),
        (Target::None, _) if file_type.needs_table() => {
            return Err(PictureError::NeedsTable(file_type).into());
        }
        _ => {}
    }
    if whole.film.is_some() && !file_type.holds_films() {
        return Err(PictureError::OnePicture(file_type).into());
    }
    let (display, shape) = ((whole.target, whole.coloring), (whole.size, whole.aspect));
    output.fill(|out| {
        let work = |frame| Work::of(joined.frame(&whole, frame), display, shape, None, interrupt::watch());
        let Some((frames, rate)) = whole.film else {
            return work(0)?.quiet(true).write(file_type, &whole.caption, out);
        };
        let mut film = FilmWriter::new(file_type, shape, (frames, rate), None, &whole.caption, out)?;
        for frame in 0..frames {
            film.frame(&work(frame)?.quiet(true).displayed()?)?;
        }
        Ok::<_, Failure<Error>>(film.finish()?)
    })?;
    if !args.quiet {
        let (picture, settings) = (name(&args.output), &whole.caption.settings);
        // Whoever has closed standard error does not want to know.
        let _ = writeln!(io::stderr(), "rta: {picture}: {file_type}, {}, {settings}", whole.size);
    }
    Ok(())
}

fn read(path: &Path) -> Result<(Part, Inputs), Error> {
    let failed = |source| PictureError::Read { path: path.to_owned(), source };
    let mut file = File::open(path).map_err(failed)?;
    let mut content = Vec::new();
    file.read_to_end(&mut content).map_err(failed)?;
    let part = Part::read(&content).map_err(|source| MergeError::Part { path: path.to_owned(), source })?;
    Ok((part, Inputs::file(&file)))
}

/// The light of a whole picture, or of all frames of a film.
struct Joined {
    light: Light,
    grid: Vec<Rgb<u8>>,
}

impl Joined {
    /// Returns a frame; that of a picture is 0.
    fn frame(&self, whole: &Whole, number: u32) -> Frame<'_> {
        let frames = whole.film.map_or(1, |(frames, _)| frames.max(1));
        let grid = self.grid.len() / frames as usize;
        let grid = self.grid.get(number as usize * grid..(number as usize + 1) * grid);
        let first = number as usize * whole.size.pixels();
        Frame { light: &self.light, first, columns: whole.size.columns(), grid: grid.unwrap_or_default() }
    }
}

/// The light of a picture among that of a film.
struct Frame<'a> {
    light: &'a Light,
    /// Its first pixel.
    first: usize,
    columns: usize,
    grid: &'a [Rgb<u8>],
}

impl Frame<'_> {
    fn copy<T: Copy>(&self, from: &[T], row: u32, out: &mut [T]) {
        let from = from.iter().skip(self.first + row as usize * self.columns);
        out.iter_mut().zip(from).for_each(|(out, from)| *out = *from);
    }
}

impl Source for Frame<'_> {
    fn linear_rows(&self, first: u32, out: &mut [Rgb<f32>]) {
        if let Light::Linear(light) = self.light {
            self.copy(light, first, out);
        }
    }

    /// The parts hold the levels that are asked for: those of their display.
    fn level_rows(&self, first: u32, _gun_max: u8, out: &mut [Rgb<u8>]) {
        if let Light::Levels(levels) = self.light {
            self.copy(levels, first, out);
        }
    }

    fn on_grid(&self, _: Lattice, _: &ThreadPool, _: &AtomicBool) -> Result<Vec<Rgb<u8>>, BandsError> {
        Ok(self.grid.to_vec())
    }
}

/// Joins the parts of one picture.
fn join(mut parts: Vec<(&Path, Part)>) -> Result<(Whole, Joined), MergeError> {
    parts.sort_by_key(|(_, part)| (part.rows.start, part.rows.end));
    let mut joined: Option<(&Path, Part)> = None;
    for (path, part) in parts {
        match &mut joined {
            None => {
                gap(&part.whole, 0..part.rows.start)?;
                joined = Some((path, part));
            }
            Some((last, all)) => {
                let paths = || Box::new((last.to_path_buf(), path.to_owned()));
                if let Some((setting, here, there)) = all.whole.difference(&part.whole) {
                    return Err(MergeError::Other {
                        paths: paths(),
                        setting,
                        values: Box::new((here, there)),
                    });
                }
                if part.rows.start < all.rows.end {
                    let (what, rows) = told(&all.whole, part.rows.start..part.rows.end.min(all.rows.end));
                    return Err(MergeError::Overlap { what, rows, paths: paths() });
                }
                gap(&all.whole, all.rows.end..part.rows.start)?;
                all.rows.end = part.rows.end;
                all.light.add(part.light);
                all.grid.extend(part.grid);
                *last = path;
            }
        }
    }
    // The command line has at least one part.
    let Some((_, Part { whole, rows, light, grid })) = joined else {
        return Err(MergeError::Gap { what: "rows", rows: 0..0, all: 0 });
    };
    gap(&whole, rows.end..whole.height())?;
    Ok((whole, Joined { light, grid }))
}

/// Refuses a gap where there is one.
fn gap(whole: &Whole, rows: Range<u32>) -> Result<(), MergeError> {
    if rows.is_empty() {
        return Ok(());
    }
    let (what, rows) = told(whole, rows);
    Err(MergeError::Gap { what, rows, all: whole.film.map_or(whole.size.height(), |(frames, _)| frames) })
}

/// Returns rows as they are told: as frames, where the whole is a film.
fn told(whole: &Whole, rows: Range<u32>) -> (&'static str, Range<u32>) {
    match whole.film {
        Some(_) => ("frames", rows.start / whole.size.height()..rows.end / whole.size.height()),
        None => ("rows", rows),
    }
}
