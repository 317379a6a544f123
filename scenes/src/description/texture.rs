//! Textures with names, as the scene language has them. Nothing draws them yet.

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
