//! Golden pictures: what the three devices showed when somebody last looked at it and found it right.
//!
//! A golden picture is an indexed PNG with the device's colour table. Indices and table are compared byte for byte, but
//! not the files, so that it may be compressed in another way. To record them all anew after a change that is meant:
//!
//! ```text
//! RTA_BLESS=1 cargo test -p rta-tests --test all golden
//! ```
//!
//! and then look at what `git diff` says has changed.

use std::fs::{self, File};
use std::io::BufReader;
use std::path::{Path, PathBuf};

use core::sync::atomic::AtomicBool;

use rta::args::ShowArgs;
use rta::coloring::{Coloring, DitherKind, TableKind};
use rta::device::{Device, Target};
use rta::engine::{Format, Model};
use rta::error::Error;
use rta::picture::output::Inputs;
use rta::picture::{Displayed, Pixels};
use rta::render::Work;
use rta::request::Request;
use rta::scene::Scene;
use rta_core::color::Rgb;

use crate::exact::shipped_scene;

/// A picture as indices into a colour table of 8 bits a gun.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Indexed {
    /// Pixels in a row.
    pub width: u32,
    /// Number of rows.
    pub height: u32,
    /// The colour table.
    pub palette: Vec<Rgb<u8>>,
    /// An index for each pixel, row by row.
    pub indices: Vec<u8>,
}

impl Indexed {
    /// Returns the indices and the table of a picture that a device showed.
    ///
    /// # Panics
    /// The picture has no table.
    #[must_use]
    pub fn of(picture: &Displayed) -> Self {
        let Pixels::Indexed { palette, indices } = &picture.pixels else { panic!("a device has a table") };
        let (width, height) = (picture.size.width(), picture.size.height());
        Self { width, height, palette: palette.clone(), indices: indices.clone() }
    }

    /// Reads an indexed PNG.
    ///
    /// # Errors
    /// The file is no PNG with indices of 8 bits, or the picture is too large.
    pub fn read(source: impl std::io::BufRead + std::io::Seek) -> Result<Self, Box<dyn core::error::Error>> {
        let mut reader = png::Decoder::new(source).read_info()?;
        let info = reader.info();
        if info.color_type != png::ColorType::Indexed || info.bit_depth != png::BitDepth::Eight {
            return Err("not an indexed PNG with 8 bits a pixel".into());
        }
        let (width, height) = (info.width, info.height);
        let table = info.palette.as_deref().ok_or("no colour table")?;
        let (entries, _) = table.as_chunks();
        let palette = entries.iter().map(|&[r, g, b]| Rgb::new(r, g, b)).collect();
        let mut indices = vec![0; reader.output_buffer_size().ok_or("too large")?];
        reader.next_frame(&mut indices)?;
        Ok(Self { width, height, palette, indices })
    }

    /// Returns the colours of the pixels, row by row.
    #[must_use]
    pub fn colors(&self) -> Vec<Rgb<u8>> {
        let color = |&index: &u8| self.palette.get(usize::from(index)).copied().unwrap_or_default();
        self.indices.iter().map(color).collect()
    }
}

/// Returns the request for a golden picture: the whole screen of a device, the thesis's model, the adaptive colour
/// table, depth 5.
#[must_use]
pub fn request(device: Device, format: Format) -> Request {
    Request {
        coloring: Coloring { table: TableKind::Adaptive, dither: DitherKind::None, samples: 0 },
        format,
        model: Model::Rta,
        depth: 5,
        size: None,
        aspect: None,
        ..Request::of(&ShowArgs::default().tracing, Target::On(device))
    }
}

/// Returns a shipped scene, by its name without extension.
#[must_use]
pub fn scene(name: &str) -> Scene {
    let description = shipped_scene(name);
    Scene { source: format!("{name}.dat"), title: name.into(), description, inputs: Inputs::default() }
}

/// Draws a shipped scene on a device in Q16.16, by one thread.
///
/// # Errors
/// Those of [`Work`].
pub fn draw(name: &str, device: Device) -> Result<Displayed, Error> {
    let (request, scene) = (request(device, Format::Q16), scene(name));
    Work::new(&request, &scene, Some(1), &AtomicBool::new(false))?.displayed()
}

/// Compares a picture with the golden one of that name, or records it as the golden one if `RTA_BLESS` is set.
///
/// # Panics
/// They differ. The picture and a difference picture are then written to the folder `golden` in that of the build, and
/// the message says where and by how much they differ.
pub fn check(name: &str, picture: &Displayed) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("golden").join(format!("{name}.png"));
    check_file(&path, "format q16, model rta, depth 5, adaptive colour table", picture);
}

/// Compares a picture with the one in a file, or records it there if `RTA_BLESS` is set. The caption that a recorded picture gets
/// says with which `settings` it was drawn.
///
/// # Panics
/// As [`check`].
pub fn check_file(path: &Path, settings: &str, picture: &Displayed) {
    let name = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    if std::env::var_os("RTA_BLESS").is_some_and(|value| !value.is_empty() && value != "0") {
        write(path, settings, picture);
        return;
    }
    let got = Indexed::of(picture);
    let golden = File::open(path)
        .map_err(Into::into)
        .and_then(|file| Indexed::read(BufReader::new(file)))
        .unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    if got == golden {
        return;
    }
    let (shown, difference) = (output(&format!("{name}.png")), output(&format!("{name}-difference.png")));
    write(&shown, settings, picture);
    let far = |a: Rgb<u8>, b: Rgb<u8>| a.zip(b, u8::abs_diff);
    let apart: Vec<_> = got.colors().into_iter().zip(golden.colors()).map(|(a, b)| far(a, b)).collect();
    let pixels = if got.indices.len() == golden.indices.len() {
        // Small differences are made visible.
        let seen = |d: u8| if d == 0 { 0 } else { d.saturating_mul(4).max(64) };
        let picture = Displayed {
            pixels: Pixels::Direct(apart.iter().map(|d| d.map(seen)).collect()),
            ..picture.clone()
        };
        write(&difference, settings, &picture);
        format!(
            "{} pixels of {} in another index, {} in another colour, by {} of 255 at most; {}",
            got.indices.iter().zip(&golden.indices).filter(|(a, b)| a != b).count(),
            got.indices.len(),
            apart.iter().filter(|d| **d != Rgb::default()).count(),
            apart.iter().map(|d| d.r.max(d.g).max(d.b)).max().unwrap_or(0),
            difference.display(),
        )
    } else {
        format!("{} x {} pixels, not {} x {}", got.width, got.height, golden.width, golden.height)
    };
    panic!(
        "{name} is not the golden picture ({} colours, not {}): {pixels}; {}",
        got.palette.len(),
        golden.palette.len(),
        shown.display()
    );
}

/// Returns the path of a file in the folder `golden` of the build; tests run in its `debug/deps` or `release/deps`.
fn output(name: &str) -> PathBuf {
    let test = std::env::current_exe().unwrap_or_default();
    test.ancestors().nth(3).unwrap_or(Path::new(".")).join("golden").join(name)
}

/// Writes a picture as a PNG with a caption, and makes its folder.
fn write(path: &Path, settings: &str, picture: &Displayed) {
    let mut content = Vec::new();
    let caption = rta::picture::Caption {
        title: path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default(),
        settings: settings.into(),
    };
    picture.write_png(&caption, &mut content).expect("memory takes it");
    let folder = path.parent().expect("a file in a folder");
    fs::create_dir_all(folder)
        .and_then(|()| fs::write(path, content))
        .unwrap_or_else(|error| panic!("{}: {error}", path.display()));
}
