//! How a picture is traced, for every command that traces one.

use clap::Args;

use super::choice;
use super::light::LightArgs;
use super::scene::ReadingArgs;
use super::spreading::SpreadingArgs;
use crate::value::coloring::{DitherKind, SAMPLES, TableKind};
use crate::value::cutoff::Cutoff;
use crate::value::raster::{Aspect, Size};
use rta_packets::picture::MAX_DEPTH;
use rta_scenes::{Format, Model};

/// How a picture is traced.
#[derive(Args, Clone, Debug)]
pub struct TracingArgs {
    /// How the scene is read
    #[command(flatten)]
    pub reading: ReadingArgs,
    /// Number format of the tracer
    #[arg(short, long, value_parser = choice::format(), ignore_case = true, default_value_t = Format::F32)]
    pub format: Format,
    /// Illumination model [default: what the scene was made for: rta, or phong for .nff]
    #[arg(short, long, value_parser = choice::model(), ignore_case = true)]
    pub model: Option<Model>,
    /// Reflections and refractions that a ray is followed through; 0 is what the eye sees directly
    ///
    /// [default: what a .rta says, else 5; with --integrator paths 64 bounces of any kind]
    #[arg(long, value_name = "N", value_parser = choice::whole(0..=MAX_DEPTH), verbatim_doc_comment)]
    pub depth: Option<u32>,
    /// A ray that would bring less than this part of its light into the pixel is not traced: 1/64, or 0 for all
    ///
    /// [default: what a .rta says, else 0]
    #[arg(long, value_name = "PART", verbatim_doc_comment)]
    pub cutoff: Option<Cutoff>,
    /// Samples, and what spreads their rays
    #[command(flatten)]
    pub spreading: SpreadingArgs,
    /// Light that was solved
    #[command(flatten)]
    pub light: LightArgs,
    /// Colour table of the device [default: sampled]
    #[arg(short, long, value_enum, ignore_case = true)]
    pub table: Option<TableKind>,
    /// Dithering of the device's colours [default: none on vga, fs on graphigs and pixrect; none with another --table]
    #[arg(long, value_enum, ignore_case = true)]
    pub dither: Option<DitherKind>,
    /// The most samples of which a sampled colour table is made, as many as a firmware has memory for, 3 bytes each
    #[arg(long, value_name = "N", default_value_t = SAMPLES, value_parser = choice::whole(1..=1_u32 << 20))]
    pub table_samples: u32,
    /// Pixels of the picture [default: the device's; with --device none those of the scene, else 320x200]
    ///
    /// On a device the picture is a window in its raster, so it may not be larger, and its pixels keep their
    /// shape. Up to 65535 pixels a side; with --device none only a band of rows is held in memory.
    #[arg(short, long, value_name = "WxH")]
    pub size: Option<Size>,
    /// Shape of the screen that the picture fills, as 4:3 or 1.333
    ///
    /// [default: the device's shape, or the shape that its pixels give a window of --size; with --device none
    /// square pixels, except that 320x200 is a 4:3 screen]
    #[arg(long, value_name = "RATIO", verbatim_doc_comment)]
    pub aspect: Option<Aspect>,
    /// Scale the scene by a power of two if it does not fit the number format (not one with a floor)
    #[arg(long)]
    pub fit: bool,
    /// Threads that trace [default: one for each core]
    #[arg(long, value_name = "N", value_parser = choice::whole(1_u16..=1024))]
    pub threads: Option<u16>,
}

impl Default for TracingArgs {
    /// The values of the options that are not given on a command line.
    fn default() -> Self {
        Self {
            reading: ReadingArgs::default(),
            format: Format::F32,
            model: None,
            depth: None,
            cutoff: None,
            spreading: SpreadingArgs::default(),
            light: LightArgs::default(),
            table: None,
            dither: None,
            table_samples: SAMPLES,
            size: None,
            aspect: None,
            fit: false,
            threads: None,
        }
    }
}
