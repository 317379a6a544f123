//! The program under valgrind: it traces pictures in the order in which they are named.

use core::sync::atomic::AtomicBool;
use std::path::Path;

use super::case::{Case, Tracing, traced_picture};
use crate::args::TracedArgs;
use crate::engine::Format;
use crate::engine::callgrind::{self, CountError};
use crate::picture::raster::Size;
use crate::study::error::StudyError;

/// The function that is counted, as callgrind is told.
const COUNTED: [&str; 1] = ["*traced_picture"];

/// The name of the scene on standard input.
pub const INPUT: &str = "-";

/// The pictures that a child traces: every scene in every format.
#[derive(Clone, Debug)]
pub struct Work<'a> {
    /// Names of scenes, or [`INPUT`].
    pub scenes: &'a [&'a str],
    /// Number formats.
    pub formats: &'a [Format],
    /// Pixels, or as many as the scene says.
    pub size: Option<Size>,
    /// Recursion depth.
    pub depth: u32,
}

/// The child: traces and prints nothing.
///
/// # Errors
/// Those of reading a scene and making it ready.
pub fn run(args: &TracedArgs) -> Result<(), StudyError> {
    for scene in &args.scenes {
        for format in &args.format {
            let tracing = Tracing { format: *format, size: args.size, depth: args.depth };
            let case = if scene == INPUT {
                Case::file(Path::new(INPUT), tracing)?
            } else {
                Case::named(scene, tracing)?
            };
            traced_picture(case.engine(), &mut case.picture()?);
        }
    }
    Ok(())
}

/// Returns the instructions of each picture, in the order of the scenes and, for each, of the formats.
///
/// # Errors
/// All of [`CountError`].
pub fn count(work: &Work, input: &[u8], stop: &AtomicBool) -> Result<Vec<u64>, CountError> {
    let program = std::env::current_exe()?;
    let formats: Vec<_> = work.formats.iter().map(Format::to_string).collect();
    let (formats, depth) = (formats.join(","), work.depth.to_string());
    let size = work.size.map(|size| size.to_string());
    let mut args = vec!["traced", "--format", &formats, "--depth", &depth];
    args.extend(size.iter().flat_map(|size| ["--size", size]));
    args.push("--");
    args.extend(work.scenes);
    let expected = work.scenes.len() * work.formats.len();
    callgrind::count(&program, &args, input, &COUNTED, expected, stop)
}
