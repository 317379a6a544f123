//! Textures with names, as the scene language has them.

/// A texture.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    /// Its name.
    pub name: String,
    /// What it looks like.
    pub pattern: Pattern,
    /// Where its origin is.
    pub at: [f64; 3],
    /// Units of the scene that are one of the texture's, above 0.
    pub scale: f64,
    /// Line of the source where it begins, from 1; 0 if it has none.
    pub line: u32,
}

/// What a texture looks like.
#[derive(Clone, Debug, PartialEq)]
pub enum Pattern {
    /// Cubes of two colours in turn.
    Checker([[f64; 3]; 2]),
    /// Waves that turbulence bends (Perlin 1985).
    Marble {
        /// The colours that are mixed.
        colors: [[f64; 3]; 2],
        /// Octaves of the turbulence, 1 to 16.
        octaves: u32,
        /// How far it bends the waves.
        amount: f64,
    },
    /// Rings about the z axis that noise bends (Peachey 1985).
    Wood {
        /// The colours that are mixed.
        colors: [[f64; 3]; 2],
        /// How far it bends the rings.
        amount: f64,
    },
    /// A picture (Catmull 1975).
    Image {
        /// Its file, beside that of the scene.
        file: String,
        /// Whether pixels have edges; they are mixed otherwise.
        nearest: bool,
        /// The axes that the picture lies along, where not the coordinates of the object.
        plane: Option<[Axis; 2]>,
    },
}

/// An axis of the world.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// To the right.
    X,
    /// Ahead.
    Y,
    /// Up.
    Z,
}

/// The pixels of a picture file. Their levels are light as it is: 255 is a reflectance of 1, without gamma, as in all pictures that the program
/// draws.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pixels {
    /// Pixels of a row, at least 1.
    pub width: u32,
    /// Rows, at least 1.
    pub height: u32,
    /// The pixels, row by row from above, each 0RGB.
    pub words: Vec<u32>,
}

impl Pixels {
    /// Returns the picture with at most `most` pixels on a side, above 0: each pixel is the mean of those that it takes the place of.
    #[must_use]
    pub fn reduced(self, most: u32) -> Self {
        let longest = self.width.max(self.height);
        let most = most.max(1);
        if longest <= most {
            return self;
        }
        let side = |side: u32| {
            let scaled = u64::from(side) * u64::from(most) / u64::from(longest);
            u32::try_from(scaled).unwrap_or(most).max(1)
        };
        self.resized(side(self.width), side(self.height))
    }

    /// Returns the picture with `width` x `height` pixels, neither more than it has.
    pub(crate) fn resized(&self, width: u32, height: u32) -> Self {
        let ends = |at: u32, of: u32, whole: u32| {
            let end = |at: u32| u64::from(at) * u64::from(whole) / u64::from(of);
            end(at)..end(at + 1).max(end(at) + 1)
        };
        let mut words = Vec::new();
        for row in 0..height {
            for column in 0..width {
                let mut sum = [0u64; 3];
                let mut count = 0;
                for y in ends(row, height, self.height) {
                    for x in ends(column, width, self.width) {
                        let [_, r, g, b] = self.word(x, y).to_be_bytes();
                        sum.iter_mut().zip([r, g, b]).for_each(|(sum, level)| *sum += u64::from(level));
                        count += 1;
                    }
                }
                let [r, g, b] =
                    sum.map(|sum| u8::try_from((sum + count / 2) / count.max(1)).unwrap_or(u8::MAX));
                words.push(u32::from_be_bytes([0, r, g, b]));
            }
        }
        Self { width, height, words }
    }

    fn word(&self, x: u64, y: u64) -> u32 {
        let at = usize::try_from(y * u64::from(self.width) + x).unwrap_or(usize::MAX);
        self.words.get(at).copied().unwrap_or(0)
    }

    /// Returns the mean of a row, linear RGB.
    pub(crate) fn mean(&self, row: u32) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for x in 0..self.width {
            let [_, r, g, b] = self.word(x.into(), row.into()).to_be_bytes();
            sum.iter_mut().zip([r, g, b]).for_each(|(sum, level)| *sum += f64::from(level) / 255.0);
        }
        sum.map(|sum| sum / f64::from(self.width.max(1)))
    }

    /// Returns the mixture of the four pixels about a place, in parts of the width, which repeats, and of the height.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // within the picture
    pub(crate) fn mixed(&self, u: f64, v: f64) -> [f64; 3] {
        let (width, height) = (f64::from(self.width), f64::from(self.height));
        let (x, y) = ((u * width - 0.5).rem_euclid(width), (v * height - 0.5).clamp(0.0, height - 1.0));
        let (column, row) = (x.floor(), y.floor());
        let (right, down) = (x - column, y - row);
        let level = |column: f64, row: f64| {
            let [_, r, g, b] = self.word((column % width) as u64, row.min(height - 1.0) as u64).to_be_bytes();
            [r, g, b].map(f64::from)
        };
        let mut mixed = [0.0; 3];
        for (dx, dy, part) in [
            (0.0, 0.0, (1.0 - right) * (1.0 - down)),
            (1.0, 0.0, right * (1.0 - down)),
            (0.0, 1.0, (1.0 - right) * down),
            (1.0, 1.0, right * down),
        ] {
            let level = level(column + dx, row + dy);
            mixed.iter_mut().zip(level).for_each(|(mixed, level)| *mixed += part * level);
        }
        mixed
    }
}
