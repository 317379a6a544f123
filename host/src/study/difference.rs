//! `rta difference`: how visible the difference of two picture files is.

use core::fmt;

use super::error::StudyError;
use super::measure::{Pair, PixelsPerDegree, Psnr, flip, mean, psnr, scielab};
use crate::args::DifferenceArgs;
use crate::picture::file::reading::ReadPicture;
use crate::picture::output;

/// How different two pictures look, as means over all pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// The distance of the eye.
    pub pixels_per_degree: PixelsPerDegree,
    /// FLIP, 0 to 1.
    pub flip: f64,
    /// S-CIELAB, in units of CIEDE2000.
    pub scielab: f64,
    /// The peak signal-to-noise ratio, which knows no distance.
    pub psnr: Psnr,
}

impl Difference {
    /// Measures two pictures at one distance.
    #[must_use]
    pub fn of(pair: &Pair<'_>, pixels_per_degree: PixelsPerDegree) -> Self {
        Self {
            pixels_per_degree,
            flip: mean(&flip::map(pair, pixels_per_degree)),
            scielab: mean(&scielab::map(pair, pixels_per_degree)),
            psnr: psnr(pair),
        }
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { pixels_per_degree, flip, scielab, psnr } = self;
        writeln!(f, "FLIP      {flip:.4}  at {pixels_per_degree} pixels a degree")?;
        writeln!(f, "S-CIELAB  {scielab:.3}")?;
        writeln!(f, "PSNR      {psnr}")
    }
}

/// Runs `rta difference`.
///
/// # Errors
/// Those of reading the pictures, [`StudyError::Sizes`], and those of writing to standard output.
pub fn run(args: &DifferenceArgs) -> Result<(), StudyError> {
    let [reference, test] = [ReadPicture::open(&args.reference)?, ReadPicture::open(&args.test)?];
    if reference.size != test.size {
        let named = |path: &std::path::Path, size| (path.display().to_string(), size);
        return Err(StudyError::Sizes {
            reference: named(&args.reference, reference.size),
            test: named(&args.test, test.size),
        });
    }
    let pair = Pair::new(&reference.pixels, &test.pixels, reference.size)?;
    let mut inputs = reference.inputs.clone();
    inputs.add(&test.inputs);
    Ok(output::print(&Difference::of(&pair, args.pixels_per_degree).to_string(), &inputs)?)
}
