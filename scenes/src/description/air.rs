//! What light meets between the surfaces, and how it fades on its way to the eye.

/// How light fades on its way, and what the scene is filled with.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Air {
    /// How the light of surfaces fades.
    pub attenuation: Option<Attenuation>,
    /// What the scene is filled with.
    pub medium: Option<Medium>,
}

/// How the light of surfaces fades with the distance.
#[derive(Clone, Debug, PartialEq)]
pub struct Attenuation {
    /// By which formula.
    pub fading: Fading,
    /// Distance up to which nothing fades, above 0; without it, the length of the ray through the middle of the picture.
    pub from: Option<f64>,
    /// Colour of the haze, linear RGB, each at least 0; without it, that of the horizon.
    pub color: Option<[f64; 3]>,
}

/// A formula by which light fades with the distance d.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fading {
    /// `min(1, from / d)` (Warnock 1969).
    Warnock,
    /// `min(1, from / d)` to a power, above 0 (Romney 1970).
    Romney(f64),
    /// A colour replaces it, linearly between two distances, of which the second is larger.
    Haze([f64; 2]),
}

/// A medium that fills the scene evenly.
#[derive(Clone, Debug, PartialEq)]
pub struct Medium {
    /// Extinction per unit of length, of red, green and blue, each at least 0.
    pub extinction: [f64; 3],
    /// Part of it that is scattered, 0 to 1.
    pub albedo: f64,
    /// Mean cosine of the angle by which it is scattered, -0.9 to 0.9.
    pub anisotropy: f64,
    /// Places of a ray at which shadows are asked for; 0 is none.
    pub shadows: u32,
}
