//! `rta radiosity`.

use core::fmt;
use core::str::FromStr;
use std::path::PathBuf;

use clap::{Args, ValueEnum};
use rta_scenes::Format;

use super::choice;
use super::scene::ReadingArgs;

/// `rta radiosity`.
#[derive(Args, Clone, Debug)]
pub struct RadiosityArgs {
    /// Scene file (.rta, .nff, .p3f or .dat), or - for standard input
    pub scene: PathBuf,
    /// How the scene is read
    #[command(flatten)]
    pub reading: ReadingArgs,
    /// Number format
    #[arg(short, long, value_parser = choice::format(), ignore_case = true, default_value_t = Format::F64)]
    pub format: Format,
    /// How the light is found
    #[arg(long, value_enum, ignore_case = true, default_value_t = Method::Gather)]
    pub method: Method,
    /// What a patch sees: exact, rays, rays:N, hemicube or hemicube:N [default: exact where it can be, else rays:64]
    ///
    /// exact is for rooms whose sides are rectangles along the axes with nothing in them; rays:N is N rays from places all
    /// over a patch; hemicube:N is the cells of half a cube with N x N cells on top, 50 if nothing is said.
    #[arg(long, value_name = "WAY")]
    pub factors: Option<Factors>,
    /// Patches along both sides of each quad, instead of what the scene says
    #[arg(long, value_name = "N", value_parser = choice::whole(1_u16..=1000))]
    pub patches: Option<u16>,
    /// Seed of the rays [default: 0]
    #[arg(long, value_name = "N", default_value_t = 0, hide_default_value = true, value_parser = choice::whole(0..=u32::MAX))]
    pub seed: u32,
    /// The most sweeps, or a hundredth of the most shots [default: 16 with rays and cells, 1000 else]
    #[arg(long, value_name = "N", value_parser = choice::whole(1_u16..=10_000))]
    pub sweeps: Option<u16>,
    /// Print the radiosity of one patch, red, green and blue: WALL,NUMBER, the quad's place in the file and the patch's in it, from 0
    #[arg(long, value_name = "WALL,NUMBER")]
    pub patch: Option<PatchName>,
    /// Keep the solution in a file, for --light of rta show and rta render
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// How the light of patches is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Method {
    /// Light is gathered patch by patch from what each sees, which is traced once
    Gather,
    /// All factors are kept, and patches improved in turn (Gauss and Seidel)
    Seidel,
    /// All factors are kept, and the system is eliminated (Gauss; Goral et al. 1984)
    Gauss,
    /// The brightest patch shoots its light, and the next (Cohen et al. 1988; Wallace et al. 1989)
    Shoot,
}

/// What a patch sees of the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Factors {
    /// Known exactly.
    Exact,
    /// So many rays, a power of two at best.
    Rays(u32),
    /// A hemi-cube with so many cells along a side, an even number.
    HemiCube(u16),
}

impl FromStr for Factors {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let text = text.to_ascii_lowercase();
        let (name, number) =
            text.split_once(':').map_or((&*text, None), |(name, number)| (name, Some(number)));
        let within =
            |number: &str, most: u32| number.parse().ok().filter(|number| (1..=most).contains(number));
        let made = match (name, number) {
            ("exact", None) => Some(Self::Exact),
            ("rays", None) => Some(Self::Rays(64)),
            ("rays", Some(number)) => within(number, 1 << 16).map(Self::Rays),
            ("hemicube", None) => Some(Self::HemiCube(50)),
            ("hemicube", Some(number)) => within(number, 1024)
                .filter(|side| side.is_multiple_of(2))
                .and_then(|side| u16::try_from(side).ok())
                .map(Self::HemiCube),
            _ => None,
        };
        made.ok_or(
            "expected exact, rays, rays:N (1 to 65536), hemicube or hemicube:N (an even number up to 1024)",
        )
    }
}

impl fmt::Display for Factors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Exact => f.write_str("exact"),
            Self::Rays(count) => write!(f, "rays:{count}"),
            Self::HemiCube(side) => write!(f, "hemicube:{side}"),
        }
    }
}

/// The name of a patch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PatchName {
    /// The place of its quad in the scene, from 0.
    pub wall: usize,
    /// Its number in the quad, from 0: that along u, and as many for each along v as there are along u.
    pub number: usize,
}

impl FromStr for PatchName {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let numbers = text.split_once(',').and_then(|(wall, number)| {
            Some(Self { wall: wall.trim().parse().ok()?, number: number.trim().parse().ok()? })
        });
        numbers.ok_or("expected WALL,NUMBER, as in 0,4: two whole numbers from 0")
    }
}
