//! `rta merge`: parts of a picture into a picture file.

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
use crate::picture::output::{Inputs, PictureOutput};
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
    let (display, shape) = ((whole.target, whole.coloring), (whole.size, whole.aspect));
    let work = Work::of(joined, display, shape, None, interrupt::watch())?.quiet(true);
    output.fill(|out| work.write(file_type, &whole.caption, out))?;
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

/// The light of a whole picture.
struct Joined {
    levels: Vec<Rgb<u8>>,
    linear: Vec<Rgb<f32>>,
    grid: Vec<Rgb<u8>>,
    columns: usize,
}

impl Source for Joined {
    fn linear_rows(&self, first: u32, out: &mut [Rgb<f32>]) {
        copy(&self.linear, first as usize * self.columns, out);
    }

    /// The parts hold the levels that are asked for: those of their display.
    fn level_rows(&self, first: u32, _gun_max: u8, out: &mut [Rgb<u8>]) {
        copy(&self.levels, first as usize * self.columns, out);
    }

    fn on_grid(&self, _: Lattice, _: &ThreadPool, _: &AtomicBool) -> Result<Vec<Rgb<u8>>, BandsError> {
        Ok(self.grid.clone())
    }
}

fn copy<T: Copy>(from: &[T], first: usize, out: &mut [T]) {
    for (out, from) in out.iter_mut().zip(from.iter().skip(first)) {
        *out = *from;
    }
}

/// Joins the parts of one picture.
fn join(mut parts: Vec<(&Path, Part)>) -> Result<(Whole, Joined), MergeError> {
    parts.sort_by_key(|(_, part)| (part.rows.start, part.rows.end));
    let mut joined = Joined { levels: Vec::new(), linear: Vec::new(), grid: Vec::new(), columns: 0 };
    let mut before: Option<(&Path, Whole, u32)> = None;
    for (path, part) in parts {
        let Part { whole, rows, light, grid } = part;
        let end = match &before {
            None => 0,
            Some((first, own, end)) => {
                let paths = || Box::new((first.to_path_buf(), path.to_owned()));
                if let Some((setting, here, there)) = own.difference(&whole) {
                    return Err(MergeError::Other {
                        paths: paths(),
                        setting,
                        values: Box::new((here, there)),
                    });
                }
                if rows.start < *end {
                    let rows = rows.start..rows.end.min(*end);
                    return Err(MergeError::Overlap { rows, paths: paths() });
                }
                *end
            }
        };
        if rows.start > end {
            return Err(MergeError::Gap { rows: end..rows.start, height: whole.size.height() });
        }
        joined.columns = whole.size.columns();
        match light {
            Light::Levels(levels) => joined.levels.extend(levels),
            Light::Linear(linear) => joined.linear.extend(linear),
        }
        joined.grid.extend(grid);
        before = Some((path, whole, rows.end));
    }
    // The command line has at least one part.
    let Some((_, whole, end)) = before else { return Err(MergeError::Gap { rows: 0..0, height: 0 }) };
    if end < whole.size.height() {
        return Err(MergeError::Gap { rows: end..whole.size.height(), height: whole.size.height() });
    }
    Ok((whole, joined))
}
