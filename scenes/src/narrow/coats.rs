//! The coats of a scene's materials, and the words that they look up.

use std::collections::HashMap;

use rta_core::scene::Object;
use rta_core::texture::{self, Bump, Coat, Image, NO_COORDINATES, STEEP, Texture};

use super::check::Checker;
use super::{Narrow, NarrowError};
use crate::description::{self, Axis, Description, Pattern, Pixels, Shading};
use crate::space::unit;

/// Units of a texture in one of the scene have so many bits behind the point.
const FREQUENCY_BITS: u32 = 24;
/// The largest coordinate on a picture, in pictures.
const MOST_REPEATS: f64 = 1000.0;

/// Coats, in the order of the materials' numbers, and words.
type Coats<S> = (Vec<Coat<S>>, Vec<u32>);

/// Returns the coats of the materials of which the scene says `said`, and whose triangles have the `shadings`; none where none is covered.
///
/// # Errors
/// A texture that the format cannot hold.
pub(super) fn narrow<S: Narrow>(
    description: &Description,
    said: &[description::Material],
    shadings: &[Shading],
) -> Result<Coats<S>, NarrowError> {
    let mut pool = Pool { description, words: Vec::new(), files: HashMap::new(), coordinates: None };
    let mut coats = Vec::new();
    let forward = description.camera.direction().filter(|_| description.details.scanline);
    let view = forward.map(super::triangle::direction::<S>);
    for (number, (own, &shading)) in said.iter().zip(shadings).enumerate() {
        let emission = Checker::<S>::named("what a material emits").light(own.emits.unwrap_or_default())?;
        let coat = Coat { shading, view, emission, ..pool.coat(own)? };
        if coat != Coat::PLAIN {
            coats.resize(number, Coat::PLAIN);
            coats.push(coat);
        }
    }
    if let Some(pixels) =
        description.details.sky_map.as_ref().and_then(|file| description.details.pictures.get(file))
    {
        coats.resize(said.len(), Coat::PLAIN);
        let image = pool.sky(pixels);
        coats.push(Coat { texture: Some(plain(texture::Pattern::Image(image))), ..Coat::PLAIN });
    }
    Ok((coats, pool.words))
}

/// Returns a texture without colours where the scene's coordinates are its own.
fn plain<S: Narrow>(pattern: texture::Pattern) -> Texture<S> {
    let black = rta_core::color::Rgb::new(S::unit(0.0), S::unit(0.0), S::unit(0.0));
    Texture { pattern, colors: [black; 2], frequency: 1 << FREQUENCY_BITS, origin: [0; 3] }
}

/// The words that were collected so far.
struct Pool<'a> {
    description: &'a Description,
    words: Vec<u32>,
    /// Where the pictures of the files begin, and their sizes.
    files: HashMap<&'a str, (u32, [u16; 2])>,
    /// Where the texture coordinates of triangles begin, once they are there; `Some(None)` if there are none.
    coordinates: Option<Option<u32>>,
}

/// Returns a number of words or pixels, of which there are fewer than 2^32.
fn count(number: usize) -> u32 {
    u32::try_from(number).unwrap_or(u32::MAX)
}

/// Returns a coordinate in 65536ths, the low 32 bits of it.
#[allow(clippy::cast_possible_truncation)] // a float's cast saturates; then the low word is asked for
fn lattice(value: f64) -> i32 {
    (value * 65536.0).round() as i64 as i32
}

impl<'a> Pool<'a> {
    fn coat<S: Narrow>(&mut self, own: &description::Material) -> Result<Coat<S>, NarrowError> {
        let textures = &self.description.textures;
        let find = |name: &str| textures.iter().find(|texture| texture.name == name);
        let texture =
            own.texture.as_deref().and_then(find).map(|texture| self.texture(texture)).transpose()?;
        let mut bump = None;
        if let Some((said, height)) =
            own.bump.as_ref().and_then(|(name, height)| Some((find(name)?, *height)))
        {
            let check = Checker::<S>::new("the bumps of the texture", self.number(said), said.line);
            #[allow(clippy::cast_precision_loss)] // 4
            let steep = STEEP as f64 * 256.0 * height / said.scale;
            // The gradient is the sum of three such slopes.
            let steep = check.at_most("the slope of its edges", steep, S::largest() / 4.0)?;
            bump = Some(Bump { texture: self.texture(said)?, height: S::length(steep) });
        }
        Ok(Coat { texture, bump, surroundings: own.surroundings, ..Coat::PLAIN })
    }

    /// Returns the place of a texture in the scene's list.
    fn number(&self, texture: &description::Texture) -> usize {
        self.description.textures.iter().position(|other| other.name == texture.name).unwrap_or(0)
    }

    fn texture<S: Narrow>(&mut self, said: &'a description::Texture) -> Result<Texture<S>, NarrowError> {
        let check = Checker::<S>::new("texture", self.number(said), said.line);
        let frequency = f64::from(1u32 << FREQUENCY_BITS) / said.scale;
        if frequency < 1.0 {
            return Err(check.error("its scale", said.scale, f64::from(1u32 << FREQUENCY_BITS)));
        }
        if frequency > f64::from(u32::MAX) {
            return Err(check.error("its scale", said.scale, 1.0 / 255.0));
        }
        let amount = |amount: f64| check.at_most("its amount", amount, f64::from(i16::MAX)).map(lattice);
        let mut colors = [[0.0; 3]; 2];
        let pattern = match &said.pattern {
            Pattern::Checker(own) => {
                colors = *own;
                texture::Pattern::Checker
            }
            Pattern::Marble { colors: own, octaves, amount: bend } => {
                colors = *own;
                let octaves = u8::try_from(*octaves).unwrap_or(u8::MAX);
                texture::Pattern::Marble { octaves, amount: amount(*bend)? }
            }
            Pattern::Wood { colors: own, amount: bend } => {
                colors = *own;
                texture::Pattern::Wood { amount: amount(*bend)? }
            }
            Pattern::Image { file, nearest, plane } => {
                let (first, [width, height]) = self.picture(file);
                let coordinates = self.coordinates::<S>()?;
                let plane = plane.map(|axes| axes.map(axis));
                texture::Pattern::Image(Image { first, width, height, nearest: *nearest, plane, coordinates })
            }
        };
        let [first, second] = colors;
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // between 1 and 2^32
        let frequency = frequency.round() as u32;
        let origin = said.at.map(|part| lattice(part / said.scale));
        let colors =
            [check.color("a colour's register", first)?, check.color("a colour's register", second)?];
        Ok(Texture { pattern, colors, frequency, origin })
    }

    /// Returns where the pixels of a file begin, and its sides; a white pixel for one that was not loaded.
    fn picture(&mut self, file: &'a str) -> (u32, [u16; 2]) {
        if let Some(&there) = self.files.get(file) {
            return there;
        }
        let first = count(self.words.len());
        let side = |side: u32| u16::try_from(side).unwrap_or(u16::MAX);
        let sides = match self.description.details.pictures.get(file) {
            Some(pixels) => {
                self.words.extend(&pixels.words);
                [side(pixels.width), side(pixels.height)]
            }
            None => {
                self.words.push(0xff_ffff);
                [1, 1]
            }
        };
        self.files.insert(file, (first, sides));
        (first, sides)
    }

    /// Returns where the texture coordinates of the triangles begin, if any triangle has some.
    fn coordinates<S: Narrow>(&mut self) -> Result<Option<u32>, NarrowError> {
        if let Some(there) = self.coordinates {
            return Ok(there);
        }
        let objects = &self.description.details.objects;
        let own = |number: u32| objects.get(&Object::Triangle(number)).and_then(|detail| detail.uv);
        let has_some = (0..count(self.description.triangles.len())).any(|number| own(number).is_some());
        let first = has_some.then_some(count(self.words.len()));
        for (number, triangle) in (0..).zip(self.description.triangles.iter().filter(|_| has_some)) {
            let Some(uv) = own(number) else {
                self.words.extend([NO_COORDINATES.cast_unsigned(), 0, 0, 0, 0, 0]);
                continue;
            };
            let index = usize::try_from(number).unwrap_or(usize::MAX);
            let check = Checker::<S>::new("triangle", index, triangle.line);
            for part in uv.into_iter().flatten() {
                let part = check.at_most("a texture coordinate", part, MOST_REPEATS)?;
                self.words.push(lattice(part).cast_unsigned());
            }
        }
        self.coordinates = Some(first);
        Ok(first)
    }

    /// Returns the picture of the sky as one of all directions.
    fn sky(&mut self, pixels: &Pixels) -> Image {
        // As many nodes from the zenith to the nadir and back as there are pixels around the horizon.
        let side = (pixels.width / 2 + 1).clamp(2, 1025);
        let first = count(self.words.len());
        let last = f64::from(side - 1);
        for row in 0..side {
            for column in 0..side {
                let direction = unfold([f64::from(column) / last, f64::from(row) / last]);
                let [x, y, z] = unit(direction).unwrap_or([0.0, 0.0, 1.0]);
                let (u, v) = (y.atan2(x) / core::f64::consts::TAU, z.acos() / core::f64::consts::PI);
                #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a level
                let [r, g, b] = pixels.mixed(u, v).map(|level| level.round() as u8);
                self.words.push(u32::from_be_bytes([0, r, g, b]));
            }
        }
        let side = u16::try_from(side).unwrap_or(u16::MAX);
        Image { first, width: side, height: side, nearest: false, plane: None, coordinates: None }
    }
}

const fn axis(axis: Axis) -> texture::Axis {
    match axis {
        Axis::X => texture::Axis::X,
        Axis::Y => texture::Axis::Y,
        Axis::Z => texture::Axis::Z,
    }
}

/// Returns the direction of a place in the square of all directions, both coordinates from 0 to 1; its length is not 1. See
/// [`fold`](rta_core::texture::fold).
fn unfold([u, v]: [f64; 2]) -> [f64; 3] {
    let [x, y] = [u, v].map(|part| 2.0 * part - 1.0);
    let z = 1.0 - x.abs() - y.abs();
    let sign = |part: f64| if part < 0.0 { -1.0 } else { 1.0 };
    if z < 0.0 { [(1.0 - y.abs()) * sign(x), (1.0 - x.abs()) * sign(y), z] } else { [x, y, z] }
}
