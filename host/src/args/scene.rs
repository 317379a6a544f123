//! Arguments of the commands that are about a scene without drawing it: `rta check` and `rta bake`.

use std::path::PathBuf;

use clap::Args;

use super::choice;
use crate::engine::{Format, Model};
use crate::picture::raster::Aspect;

/// `rta check`.
#[derive(Args, Debug)]
pub struct CheckArgs {
    /// Scene file (.dat or .nff), or - for standard input
    pub scene: PathBuf,
    /// Number format
    #[arg(short, long, value_parser = choice::format(), ignore_case = true, default_value_t = Format::Q16)]
    pub format: Format,
    /// Shape of the screen
    #[arg(long, value_name = "RATIO", default_value = "4:3")]
    pub aspect: Aspect,
    /// Scale the scene by a power of two if it does not fit the number format (not one with a floor)
    #[arg(long)]
    pub fit: bool,
}

/// `rta bake`.
#[derive(Args, Debug)]
pub struct BakeArgs {
    /// Scene file (.dat or .nff), or - for standard input
    pub scene: PathBuf,
    /// Number format
    #[arg(short, long, value_parser = choice::format(), ignore_case = true, default_value_t = Format::Q16)]
    pub format: Format,
    /// Illumination model that the scene is drawn with, which decides what it needs [default: rta, or phong for .nff]
    #[arg(short, long, value_parser = choice::model(), ignore_case = true)]
    pub model: Option<Model>,
    /// Shape of the screen that the whole picture fills
    #[arg(long, value_name = "RATIO", default_value = "4:3")]
    pub aspect: Aspect,
    /// Scale the scene by a power of two if it does not fit the number format (not one with a floor)
    #[arg(long)]
    pub fit: bool,
    /// Rust file; - is standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
}
