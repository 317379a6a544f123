//! Why a picture is not drawn, and why it is not the golden one.
//!
//! What a test returns or unwraps is printed with `{:?}`, so both kinds of errors print their message there too.

use core::convert::Infallible;
use core::fmt;
use std::io;
use std::path::PathBuf;

use rta_core::color::Rgb;
use rta_drivers::display::{Capabilities, DriverError};
use rta_drivers::quantize::TableError;
use rta_scenes::OutOfRange;
use rta_scenes::error::SceneError;
use rta_scenes::narrow::NarrowError;

use crate::kept::Kept;

/// Why there is no picture.
#[non_exhaustive]
pub enum DrawError {
    /// The scene file cannot be read.
    Read {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// The scene file is not a scene.
    Scene(SceneError),
    /// The scene of a file cannot be drawn as asked.
    File {
        /// The file.
        path: PathBuf,
        /// Why not.
        reason: Box<DrawError>,
    },
    /// A number of the scene does not fit the number format.
    Narrow(NarrowError),
    /// A quantity that the tracer computes may not fit the number format.
    Range(OutOfRange),
    /// The tracer refuses the raster or the depth.
    Tracer(rta_core::Error),
    /// The colour table does not suit the device.
    Table(TableError),
    /// The display refuses a pixel or a colour.
    Display(DriverError<Infallible>),
    /// The picture has more pixels in a row, or more rows, than the device.
    Larger {
        /// Pixels in a row.
        width: u32,
        /// Rows.
        height: u32,
        /// The device.
        device: Capabilities,
    },
    /// The picture is too narrow or too wide to be seen through a camera.
    Shape {
        /// Width over height of the screen, not of the raster.
        aspect: f64,
    },
    /// There are not as many pixels as the picture has places.
    Pixels {
        /// The pixels.
        pixels: usize,
        /// Places in a row.
        width: u32,
        /// Rows.
        height: u32,
    },
}

impl fmt::Display for DrawError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Read { path, source } => write!(f, "cannot read the scene {}: {source}", path.display()),
            Self::Scene(error) => error.fmt(f),
            Self::File { path, reason } => write!(f, "{}: {reason}", path.display()),
            Self::Narrow(error) => error.fmt(f),
            Self::Range(error) => error.fmt(f),
            Self::Tracer(error) => error.fmt(f),
            Self::Table(error) => error.fmt(f),
            Self::Display(error) => error.fmt(f),
            Self::Larger { width, height, device } => {
                write!(
                    f,
                    "{width} x {height} pixels do not fit a device of {} x {}",
                    device.width, device.height
                )
            }
            Self::Shape { aspect } => {
                write!(f, "a screen of {aspect} : 1 is too narrow or too wide: 0.01 to 100 are possible")
            }
            Self::Pixels { pixels, width, height } => {
                write!(f, "{pixels} pixels are not a picture of {width} x {height}")
            }
        }
    }
}

/// Declares that an error prints its message with `{:?}` too, and that others become a variant of it.
macro_rules! errors {
    ($($Error:ident: $($Variant:ident($from:ty))*;)+) => {$(
        impl fmt::Debug for $Error {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                fmt::Display::fmt(self, f)
            }
        }

        $(impl From<$from> for $Error {
            fn from(error: $from) -> Self {
                Self::$Variant(error)
            }
        })*
    )+};
}

errors! {
    DrawError: Scene(SceneError) Narrow(NarrowError) Range(OutOfRange) Tracer(rta_core::Error) Table(TableError)
        Display(DriverError<Infallible>);
    Mismatch: NotDrawn(DrawError);
}

impl core::error::Error for DrawError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Read { source, .. } => Some(source),
            Self::File { reason, .. } => Some(reason),
            _ => None,
        }
    }
}

/// What differs between a picture and the golden one of its size.
#[derive(Debug)]
#[non_exhaustive]
pub struct Difference {
    /// The file of the golden picture.
    pub golden: PathBuf,
    /// Pixels that differ.
    pub differing: usize,
    /// Pixels of the picture.
    pub pixels: usize,
    /// The largest difference of a gun, 1 to 255.
    pub largest: u8,
    /// Column of the first pixel that differs, row by row from the upper left.
    pub x: u32,
    /// Its row.
    pub y: u32,
    /// Its colour in the picture drawn, with 8 bits a gun.
    pub drawn_color: Rgb<u8>,
    /// Its colour in the golden picture.
    pub golden_color: Rgb<u8>,
    /// The files that show it.
    pub kept: Kept,
}

/// Why a picture is not the golden one.
#[non_exhaustive]
pub enum Mismatch {
    /// There is no picture to compare.
    NotDrawn(DrawError),
    /// The hash is another one.
    Hash {
        /// That of the picture drawn.
        drawn: u64,
        /// That which it should be.
        golden: u64,
    },
    /// Pixels differ.
    Pixels(Box<Difference>),
    /// The pictures have different sizes.
    Size {
        /// The file of the golden picture.
        golden: PathBuf,
        /// Width and height of the picture drawn.
        drawn: (u32, u32),
        /// Width and height of the golden picture.
        golden_size: (u32, u32),
        /// The file that shows the picture drawn.
        kept: Kept,
    },
    /// There is no golden picture yet.
    Missing {
        /// The file that it would be.
        golden: PathBuf,
        /// The file that shows the picture drawn.
        kept: Kept,
    },
    /// The golden picture cannot be read, or is no PNG.
    Unreadable {
        /// Its file.
        golden: PathBuf,
        /// What the system or the decoder says.
        source: io::Error,
        /// The file that shows the picture drawn.
        kept: Kept,
    },
    /// The golden picture cannot be written anew.
    Write {
        /// Its file.
        golden: PathBuf,
        /// What the system says.
        source: io::Error,
    },
}

/// What to do about a failure that is meant.
const ADVICE: &str = "\n  if it is right, RTA_BLESS=1 cargo test makes it the golden picture";

impl fmt::Display for Mismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotDrawn(error) => error.fmt(f),
            Self::Hash { drawn, golden } => {
                write!(f, "the hash of the picture drawn is {}, not {}", literal(*drawn), literal(*golden))
            }
            Self::Pixels(difference) => difference.fmt(f),
            Self::Size { golden, drawn, golden_size, kept } => {
                let (golden, (width, height), (w, h)) = (golden.display(), drawn, golden_size);
                write!(f, "{golden} has {w} x {h} pixels, the picture drawn {width} x {height}{kept}{ADVICE}")
            }
            Self::Missing { golden, kept } => {
                write!(f, "{} is not there yet{kept}{ADVICE}", golden.display())
            }
            Self::Unreadable { golden, source, kept } => {
                write!(f, "{} cannot be read: {source}{kept}{ADVICE}", golden.display())
            }
            Self::Write { golden, source } => write!(f, "{} cannot be written: {source}", golden.display()),
        }
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { golden, differing, pixels, largest, x, y, drawn_color, golden_color, kept } = self;
        let hex = |color: &Rgb<u8>| format!("#{:02x}{:02x}{:02x}", color.r, color.g, color.b);
        let (verb, by) = if *differing == 1 { ("differs", "by") } else { ("differ", "by up to") };
        write!(
            f,
            "{}: {differing} of {pixels} pixels {verb}, {by} {largest} of 255 in a gun\n  \
             first:      column {x} of row {y}, {} was drawn, {} is golden{kept}{ADVICE}",
            golden.display(),
            hex(drawn_color),
            hex(golden_color)
        )
    }
}

/// Returns a hash as it stands in Rust source.
fn literal(hash: u64) -> String {
    let digits = format!("{hash:016x}");
    let groups: Vec<_> = digits.as_bytes().chunks(4).map(String::from_utf8_lossy).collect();
    format!("0x{}", groups.join("_"))
}

impl core::error::Error for Mismatch {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::NotDrawn(error) => Some(error),
            Self::Unreadable { source, .. } | Self::Write { source, .. } => Some(source),
            _ => None,
        }
    }
}
