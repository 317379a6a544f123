//! Scene files of rta: readers, and their way into a scene of any number format.
//!
//! A reader turns a file into a [`description::Description`], owned and in `f64`: [`dat`] reads the thesis's own
//! format, [`nff`] that of the Standard Procedural Databases, [`rta`] the scene language, and [`read`] chooses between them.
//! [`shipped`] holds the scenes that come with rta; [`fit`](mod@fit) scales a scene that does not fit a number format.
//!
//! ```
//! use rta_scenes::{read, shipped};
//!
//! let juggler = read(shipped::JUGGLER.as_bytes(), "juggler.dat")?;
//! assert_eq!(juggler.spheres.len(), 70);
//!
//! let error = read(b"0 0 1\n0 1 zero", "scene.dat").unwrap_err();
//! assert_eq!(
//!     error.to_string(),
//!     "scene.dat:2:5: expected the z of the direction of view (a number), found \"zero\", not a number"
//! );
//!
//! let error = read(b"v\nfrom 0 0 1\nto 0 0 0", "scene.nff").unwrap_err();
//! assert_eq!(error.to_string(), "scene.nff:3:1: expected the word \"at\" of the viewpoint, found \"to\"");
//! # Ok::<(), rta_scenes::error::SceneError>(())
//! ```
//!
//! `examples/draw.rs` goes on from there, through a number format to a picture file.

#[macro_use]
pub mod model; // first, for its macro

pub mod accelerator;
pub mod bake;
pub mod dat;
pub mod description;
mod doubts;
pub mod error;
pub mod fit;
pub mod format;
pub mod gloss;
mod lines;
pub mod narrow;
pub mod nff;
mod numbers;
mod patches;
pub mod pictures;
mod polygon;
mod reading;
pub mod rta;
pub mod sampler;
pub mod shading;
pub mod shipped;
pub mod solution;
mod solve;
pub mod space;
pub mod spectrum;
mod tessellate;
mod tokens;
pub mod unused;
pub mod used;
pub mod warning;

pub use bake::bake;
pub use format::Format;
pub use lines::OutOfRange;
pub use model::Model;
pub use numbers::Short;
pub use reading::Reading;

use std::path::Path;

use description::Description;
use error::SceneError;

/// Reads a scene in the format that the name of its file says: `.rta`, `.nff`, `.p3f` or `.dat`, in letters of any size. What is
/// called otherwise, such as standard input, is of the scene language if it begins with `rta`, NFF if it begins with another word,
/// and else `.dat`, which begins with a number.
///
/// # Errors
/// Those of [`rta::read`], [`nff::read`] and [`dat::read`].
pub fn read(text: &[u8], file: &str) -> Result<Description, SceneError> {
    read_with(text, file, Reading::default())
}

/// Reads a scene as [`read`] does, and as `reading` says where the format leaves something open.
///
/// # Errors
/// Those of [`rta::read`], [`nff::read_with`] and [`dat::read`].
pub fn read_with(text: &[u8], file: &str, reading: Reading) -> Result<Description, SceneError> {
    let extension = Path::new(file).extension();
    let is = |other: &str| extension.is_some_and(|extension| extension.eq_ignore_ascii_case(other));
    // What is not text or has nothing in it is the same error in all formats.
    let first = || tokens::Tokens::new(text, file).ok().and_then(|mut tokens| tokens.next());
    let is_told = ["rta", "nff", "p3f", "dat"].into_iter().any(is);
    let word = if is_told { None } else { first().filter(|token| !token.is_like_a_number()) };
    let is_language = word.is_some_and(|token| token.text == "rta");
    let scene = if is("rta") || is_language {
        rta::read(text, file)
    } else if is("nff") || is("p3f") || word.is_some() {
        nff::read_with(text, file, reading)
    } else {
        dat::read(text, file)
    };
    scene.map(|scene| {
        let mut scene = match reading.instant {
            Some(instant) => scene.at(instant),
            None => scene,
        };
        scene.air = reading.air.unwrap_or(scene.air);
        if let Some(count) = reading.wavelengths {
            scene.settings.wavelengths = Some(count).filter(|count| *count > 0);
        }
        if let Some(around) = reading.tessellate {
            scene.tessellate(around);
        }
        if let Some(shading) = reading.shading {
            scene.shade_all(shading);
        }
        scene.details.scanline = reading.scanline;
        scene
    })
}

#[cfg(test)]
mod tests {
    use super::{dat, nff, read, shipped};

    #[test]
    fn the_name_tells_the_format_and_else_the_text() {
        let balls = include_bytes!("../balls2.nff");
        let glass = shipped::GLASS_2.as_bytes();
        for name in ["a.nff", "a.NFF", "a.dat.Nff", "standard input", "balls", "balls.txt"] {
            assert_eq!(read(balls, name), nff::read(balls, name), "{name}");
            assert!(read(balls, name).is_ok(), "{name}");
        }
        for name in ["a.dat", "a.DAT", "nff", "standard input", "a.nff.txt", ".nff"] {
            assert_eq!(read(glass, name), dat::read(glass, name), "{name}");
            assert!(read(glass, name).is_ok(), "{name}");
        }
        // The name is believed: the error is about the format that it promises.
        assert_eq!(read(glass, "a.nff"), nff::read(glass, "a.nff"));
        assert_eq!(read(balls, "a.dat"), dat::read(balls, "a.dat"));
        // A number that is wrong is a number.
        for text in ["1,5 2 3", "-x", "NaN 1 1", "", "# v", "\0"] {
            let error = read(text.as_bytes(), "input").expect_err("it is no scene");
            assert_eq!(Err(error), dat::read(text.as_bytes(), "input"), "{text}");
        }
    }
}

/// The code of the README, compiled and run with the other examples.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
