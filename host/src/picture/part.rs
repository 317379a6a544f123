//! A part of a picture: some of its rows as they come from the tracer, before any display, in a file from which `rta merge` makes pictures.
//!
//! The file is a header of text, a line for each setting of the [`Whole`], the rows and a hash of all else; an empty line; and then the light
//! of the rows, 3 bytes or three 32-bit floats (little endian) a pixel, and 3 bytes for each of those pixels of the grid, of which a colour
//! table is made, that lie in the rows. The rows of a film are those of its frames, one below the other, and each frame has a grid.

use core::ops::Range;
use core::str::FromStr;

use clap::ValueEnum;
use rta_core::color::Rgb;
use rta_core::raster::Raster;
use rta_core::raster::lattice::Lattice;
use rta_drivers::checksum::Fnv;

use super::coloring::Coloring;
use super::device::Target;
use super::file::{Caption, bytes, light_bytes};
use super::raster::Size;

mod error;

pub use error::{MergeError, PartError};

/// The line that the file begins with.
const MAGIC: &str = "rta part 1";

/// What a part is a part of. Two parts belong together if all of it is equal.
#[derive(Clone, Debug, PartialEq)]
pub struct Whole {
    /// Width and height of the picture in pixels.
    pub size: Size,
    /// Width over height of the screen that it fills.
    pub aspect: f64,
    /// The display.
    pub target: Target,
    /// Its colour table and dithering.
    pub coloring: Coloring,
    /// Whether the light is linear, and not levels.
    pub is_linear: bool,
    /// Frames of the film, and how many are shown in a second; nothing for a picture.
    pub film: Option<(u32, u16)>,
    /// What is written into a picture.
    pub caption: Caption,
    /// A hash of the scene.
    pub scene: u64,
}

/// Some rows of a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// The picture.
    pub whole: Whole,
    /// The rows, from 0 at the top. Of a film they are those of whole frames.
    pub rows: Range<u32>,
    /// Their light.
    pub light: Light,
    /// The colours, 8 bits a gun, of the pixels in these rows of which the colour table is made.
    pub grid: Vec<Rgb<u8>>,
}

/// Light of pixels, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub enum Light {
    /// Levels `0..=`[`Whole::most`].
    Levels(Vec<Rgb<u8>>),
    /// Linear light.
    Linear(Vec<Rgb<f32>>),
}

impl Light {
    /// Adds the light of further rows, of the same kind.
    pub fn add(&mut self, other: Self) {
        match (self, other) {
            (Self::Levels(own), Self::Levels(other)) => own.extend(other),
            (Self::Linear(own), Self::Linear(other)) => own.extend(other),
            (Self::Levels(_), Self::Linear(_)) | (Self::Linear(_), Self::Levels(_)) => {}
        }
    }
}

impl Whole {
    /// Returns the light of no rows.
    #[must_use]
    pub const fn dark(&self) -> Light {
        if self.is_linear { Light::Linear(Vec::new()) } else { Light::Levels(Vec::new()) }
    }

    /// The settings as text, in the order of the header.
    fn lines(&self) -> [(&'static str, String); 12] {
        let Self { size, aspect, target, coloring, is_linear, film, caption, scene } = self;
        [
            ("program", env!("CARGO_PKG_VERSION").to_owned()),
            ("scene", format!("{scene:016x}")),
            ("title", caption.title.clone()),
            ("settings", caption.settings.clone()),
            ("size", size.to_string()),
            ("aspect", aspect.to_string()),
            ("device", target.to_string()),
            ("table", coloring.table.to_string()),
            ("dither", coloring.dither.to_string()),
            ("samples", coloring.samples.to_string()),
            ("film", film.map_or("none".to_owned(), |(frames, rate)| format!("{frames}/{rate}"))),
            ("light", if *is_linear { "linear" } else { "levels" }.to_owned()),
        ]
    }

    /// Returns the first setting that another picture has otherwise: its name, its value here, and there.
    #[must_use]
    pub fn difference(&self, other: &Self) -> Option<(&'static str, String, String)> {
        let mut lines = self.lines().into_iter().zip(other.lines());
        lines.find(|(own, other)| own != other).map(|((name, own), (_, other))| (name, own, other))
    }

    /// Returns the number of rows, those of all frames together.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.size.height().saturating_mul(self.film.map_or(1, |(frames, _)| frames))
    }

    /// Returns the highest level of the light, where it is levels.
    #[must_use]
    pub fn most(&self) -> u8 {
        self.target.device().map_or(u8::MAX, |device| self.coloring.light_max(device.capabilities()))
    }

    /// Returns the grid of which the colour table is made, if it is made of the picture.
    #[must_use]
    pub fn lattice(&self) -> Option<Lattice> {
        let samples = self.target.device().map_or(0, |_| self.coloring.samples());
        let raster = Raster::new(self.size.width(), self.size.height()).ok()?;
        (samples > 0 && !self.is_linear).then(|| Lattice::new(raster, samples))
    }

    /// Returns the rows of the grid that lie in some rows of the picture.
    #[must_use]
    pub fn grid_rows(&self, rows: &Range<u32>) -> Range<u32> {
        let Some(lattice) = self.lattice() else { return 0..0 };
        let before = |end: u32| {
            (0..lattice.grid().height()).take_while(|j| lattice.pixel(0, *j).1 < end).map(|j| j + 1).last()
        };
        before(rows.start).unwrap_or(0)..before(rows.end).unwrap_or(0)
    }
}

impl Part {
    /// Returns the part as a file.
    #[must_use]
    pub fn write(&self) -> Vec<u8> {
        let mut head = format!("{MAGIC}\n");
        for (name, value) in self.whole.lines() {
            head += &format!("{name} {value}\n");
        }
        head += &format!("rows {}..{}\n", self.rows.start, self.rows.end);
        let mut content = match &self.light {
            Light::Levels(levels) => bytes(levels),
            Light::Linear(light) => light_bytes(light),
        };
        content.extend(bytes(&self.grid));
        let hash = hash(head.as_bytes(), &content);
        [format!("{head}hash {hash:016x}\n\n").into_bytes(), content].concat()
    }

    /// Reads a part.
    ///
    /// # Errors
    /// All of [`PartError`].
    pub fn read(file: &[u8]) -> Result<Self, PartError> {
        if !file.starts_with(format!("{MAGIC}\n").as_bytes()) {
            return Err(PartError::NoPart);
        }
        let end = file.windows(2).position(|pair| pair == b"\n\n").ok_or(PartError::Header("its end"))?;
        let (head, content) = file.split_at(end + 1);
        let content = content.get(1..).unwrap_or_default();
        let head = core::str::from_utf8(head).map_err(|_| PartError::Header("plain text"))?;
        let mut lines = head.lines().skip(1);
        let mut line = |name: &'static str| {
            let line = lines.next().and_then(|line| line.strip_prefix(name)?.strip_prefix(' '));
            line.ok_or(PartError::Header(name))
        };
        fn parse<T: FromStr>(name: &'static str, text: &str) -> Result<T, PartError> {
            text.parse().map_err(|_| PartError::Header(name))
        }
        fn choose<T: ValueEnum>(name: &'static str, text: &str) -> Result<T, PartError> {
            T::from_str(text, false).map_err(|_| PartError::Header(name))
        }
        let number = |name, text| u64::from_str_radix(text, 16).map_err(|_| PartError::Header(name));
        if line("program")? != env!("CARGO_PKG_VERSION") {
            return Err(PartError::Header("the version of this program"));
        }
        let scene = number("scene", line("scene")?)?;
        let caption = Caption { title: line("title")?.to_owned(), settings: line("settings")?.to_owned() };
        let size: Size = parse("size", line("size")?)?;
        let aspect: f64 = parse("aspect", line("aspect")?)?;
        let target = choose("device", line("device")?)?;
        let table = choose("table", line("table")?)?;
        let dither = choose("dither", line("dither")?)?;
        let samples = parse("samples", line("samples")?)?;
        let film = match line("film")? {
            "none" => None,
            film => {
                let (frames, rate) = film.split_once('/').ok_or(PartError::Header("film"))?;
                Some((parse("film", frames)?, parse("film", rate)?))
            }
        };
        let is_linear = match line("light")? {
            "linear" => true,
            "levels" => false,
            _ => return Err(PartError::Header("light")),
        };
        let coloring = Coloring { table, dither, samples };
        let whole = Whole { size, aspect, target, coloring, is_linear, film, caption, scene };
        let rows = line("rows")?.split_once("..").ok_or(PartError::Header("rows"))?;
        let rows: Range<u32> = parse("rows", rows.0)?..parse("rows", rows.1)?;
        let own = number("hash", line("hash")?)?;
        let has_frames = film.is_none() || [rows.start, rows.end].iter().all(|row| row % size.height() == 0);
        if rows.is_empty() || rows.end > whole.height() || !has_frames {
            return Err(PartError::Header("rows"));
        }
        if !(aspect > 0.0 && aspect.is_finite()) {
            return Err(PartError::Header("aspect"));
        }
        let hashed = head.split_at(head.rfind("hash ").unwrap_or(head.len())).0;
        Self::of_content(whole, rows, content).and_then(|part| {
            if hash(hashed.as_bytes(), content) == own { Ok(part) } else { Err(PartError::Damaged) }
        })
    }

    fn of_content(whole: Whole, rows: Range<u32>, content: &[u8]) -> Result<Self, PartError> {
        let pixels = rows.len().saturating_mul(whole.size.columns());
        let width = whole.lattice().map_or(0, |lattice| lattice.grid().width() as usize);
        let grid = width
            * match whole.film {
                None => whole.grid_rows(&rows).len(),
                Some(_) => {
                    let frames = rows.len() / whole.size.height() as usize;
                    frames * whole.grid_rows(&(0..whole.size.height())).len()
                }
            };
        let light_length = pixels.saturating_mul(if whole.is_linear { 12 } else { 3 });
        let length = light_length.saturating_add(3 * grid);
        match content.len() {
            less if less < length => return Err(PartError::CutOff(length - less)),
            more if more > length => return Err(PartError::Spare(more - length)),
            _ => {}
        }
        let (light, grid) = content.split_at(light_length);
        let levels = |bytes: &[u8]| bytes.as_chunks().0.iter().map(|&[r, g, b]| Rgb::new(r, g, b)).collect();
        let light = if whole.is_linear {
            let float = |word: &[u8; 4]| f32::from_le_bytes(*word);
            let words: Vec<f32> = light.as_chunks().0.iter().map(float).collect();
            Light::Linear(words.as_chunks().0.iter().map(|&[r, g, b]| Rgb::new(r, g, b)).collect())
        } else {
            Light::Levels(levels(light))
        };
        Ok(Self { whole, rows, light, grid: levels(grid) })
    }
}

/// Returns the hash of a header and of what follows it.
fn hash(head: &[u8], content: &[u8]) -> u64 {
    let mut hash = Fnv::EMPTY;
    head.iter().chain(content).for_each(|byte| hash.add(*byte));
    hash.value()
}
