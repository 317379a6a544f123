//! How far two pictures of one scene agree, and pictures of a scene in NFF by the oracle and in a number format of the program.

use core::fmt;

use rta::engine::{Format, Model, Settings};
use rta::request::fit::Fit;
use rta::scene::Scene as SceneFile;

use crate::oracle::nff;
use crate::picture::render;

/// A picture in linear light that is not clamped.
pub struct Picture {
    /// Row by row from the top.
    pub pixels: Vec<[f64; 3]>,
    /// Pixels in a row.
    pub width: usize,
}

/// Recursion depth of the pictures, which is the program's default.
pub const DEPTH: u32 = 5;

/// Most pixels that are named.
const NAMED: usize = 8;

/// How far two pictures agree.
#[derive(Clone, Debug)]
pub struct Agreement {
    /// Pixels that agree within the limit, in a hundred.
    pub percent: f64,
    /// The largest difference of a register, both clamped to [0, 1].
    pub largest: f64,
    /// Column and row of pixels that do not agree.
    pub outside: Vec<(usize, usize)>,
}

impl Agreement {
    /// Compares two pictures; a pixel agrees if its registers, clamped to [0, 1], differ by no more than `limit`.
    ///
    /// # Panics
    /// The pictures have different sizes.
    #[must_use]
    pub fn new(one: &Picture, other: &Picture, limit: f64) -> Self {
        let width = one.width;
        assert_eq!((width, one.pixels.len()), (other.width, other.pixels.len()), "pictures of one size");
        let difference = |(p, q): (&[f64; 3], &[f64; 3])| {
            let registers = p.iter().zip(q).map(|(a, b)| (a.clamp(0.0, 1.0) - b.clamp(0.0, 1.0)).abs());
            // What is no number agrees with nothing.
            registers.map(|error| if error.is_nan() { f64::INFINITY } else { error }).fold(0.0, f64::max)
        };
        let errors: Vec<f64> = one.pixels.iter().zip(&other.pixels).map(difference).collect();
        let outside = (0..).zip(&errors).filter(|(_, error)| **error > limit);
        let outside: Vec<_> = outside.map(|(pixel, _)| (pixel % width, pixel / width)).collect();
        Self {
            percent: 100.0 - 100.0 * outside.len() as f64 / errors.len() as f64,
            largest: errors.into_iter().fold(0.0, f64::max),
            outside,
        }
    }
}

impl fmt::Display for Agreement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:7.3} %, largest {:.1e}", self.percent, self.largest)?;
        for (x, y) in self.outside.iter().take(NAMED) {
            write!(f, " {x},{y}")?;
        }
        if self.outside.len() > NAMED {
            write!(f, " and {} more", self.outside.len() - NAMED)
        } else {
            Ok(())
        }
    }
}

/// A scene in NFF and its name.
pub struct Nff {
    name: String,
    text: String,
}

impl Nff {
    /// Keeps a scene's text. Where a `size` is given, the picture has so many pixels in place of what the text says.
    #[must_use]
    pub fn new(name: &str, text: &str, size: Option<(usize, usize)>) -> Self {
        let mut text = text.to_owned();
        if let Some((width, height)) = size
            && let Some((before, after)) = text.split_once("resolution ")
        {
            let rest = after.split_once('\n').map_or("", |(_, rest)| rest);
            text = format!("{before}resolution {width} {height}\n{rest}");
        }
        Self { name: name.to_owned(), text }
    }

    /// Returns the oracle's picture.
    ///
    /// # Errors
    /// What the oracle cannot read.
    pub fn oracle(&self) -> Result<Picture, String> {
        let scene = nff::read(&self.text).map_err(|error| format!("{}: {error}", self.name))?;
        Ok(Picture { pixels: nff::render(&scene, DEPTH), width: scene.width() })
    }

    /// Returns the picture that `rta render --device none --fit` draws.
    ///
    /// # Errors
    /// What the program refuses, by its message.
    pub fn program(&self, format: Format) -> Result<Picture, String> {
        let description =
            rta_scenes::read(self.text.as_bytes(), &self.name).map_err(|error| error.to_string())?;
        let [width, height] = description.raster.ok_or("no size")?;
        let aspect = f64::from(width) / f64::from(height);
        let scene = SceneFile {
            source: self.name.clone(),
            title: self.name.clone(),
            description,
            inputs: Default::default(),
        };
        let fit = Fit { format, aspect, model: Some(Model::Phong), depth: DEPTH, asked: true };
        let settings = Settings {
            width,
            height,
            aspect,
            format,
            model: Model::Phong,
            depth: DEPTH,
            ..Settings::default()
        };
        let pixels =
            render(&fit.scaled(&scene), &settings).map_err(|error| format!("{}: {error}", self.name))?;
        Ok(Picture { pixels, width: width as usize })
    }
}
