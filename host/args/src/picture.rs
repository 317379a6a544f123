//! Arguments of the commands that draw a picture: `rta show`, `rta render` and `rta hash`.

use std::path::PathBuf;

use clap::Args;

use super::tracing::TracingArgs;
use crate::value::device::{Device, Target};
use crate::value::file_type::FileType;
use rta_scenes::Format;

/// `rta show`.
#[derive(Args, Debug)]
pub struct ShowArgs {
    /// Scene file (.rta, .dat, .nff or .p3f), or - for standard input; without one, the Juggler
    pub scene: Option<PathBuf>,
    /// The display to emulate, or none for 8 bits a gun without a colour table
    #[arg(short, long, value_enum, ignore_case = true, default_value_t = Target::On(Device::Vga))]
    pub device: Target,
    /// How the picture is traced.
    #[command(flatten)]
    pub tracing: TracingArgs,
}

impl Default for ShowArgs {
    fn default() -> Self {
        Self { scene: None, device: Target::On(Device::Vga), tracing: TracingArgs::default() }
    }
}

/// `rta render`.
#[derive(Args, Debug)]
pub struct RenderArgs {
    /// Scene file (.rta, .dat, .nff or .p3f), or - for standard input
    pub scene: PathBuf,
    /// Picture file; its extension tells the kind (see --as); - is standard output
    ///
    /// A PNG or BMP from a device is indexed, with the device's own colour table. PFM and HDR hold linear light, unclamped, and need
    /// --device none.
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    /// The display to emulate, or none for 8 bits a gun without a colour table
    #[arg(short, long, value_enum, ignore_case = true, default_value_t = Target::On(Device::Vga))]
    pub device: Target,
    /// Kind of picture, whatever the name of the file says [default: by the extension; png into pipes]
    #[arg(long = "as", value_enum, ignore_case = true, value_name = "TYPE")]
    pub file_type: Option<FileType>,
    /// Say nothing but warnings and errors: no progress bar, and no line about the picture at the end
    #[arg(short, long)]
    pub quiet: bool,
    /// How the picture is traced.
    #[command(flatten)]
    pub tracing: TracingArgs,
}

/// `rta hash`. Its number format is fixed point unless another is asked for: only there do all machines arrive at one hash.
#[derive(Args, Debug)]
#[command(mut_arg("format", |format| format.default_value(Format::Q16.name())))]
pub struct HashArgs {
    /// Scene file (.rta, .dat, .nff or .p3f), or - for standard input
    pub scene: PathBuf,
    /// The display
    #[arg(short, long, value_enum, ignore_case = true, default_value_t = Device::Vga)]
    pub device: Device,
    /// How the picture is traced.
    #[command(flatten)]
    pub tracing: TracingArgs,
}
