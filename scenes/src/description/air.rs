//! What light meets between the surfaces, and how it fades on its way to the eye.

use core::fmt;
use core::str::FromStr;

/// How light fades on its way, and what the scene is filled with.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Air {
    /// How the light of surfaces fades.
    pub attenuation: Option<Attenuation>,
    /// What the scene is filled with.
    pub medium: Option<Medium>,
}

/// How the light of surfaces fades with the distance.
#[derive(Clone, Copy, Debug, PartialEq)]
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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Medium {
    /// Extinction per unit of length, of red, green and blue, each at least 0.
    pub extinction: [f64; 3],
    /// Part of it that is scattered, 0 to 1.
    pub albedo: f64,
    /// Mean cosine of the angle by which it is scattered, -0.9 to 0.9.
    pub anisotropy: f64,
    /// Places of a ray at which shadows are asked for; 0 is none.
    pub shadows: u32,
    /// How far it reaches from where a ray starts, above 0; without it as far as what the ray meets, and nowhere if that is nothing.
    pub reach: Option<f64>,
}

impl Medium {
    /// Returns a medium that absorbs light and scatters none.
    #[must_use]
    pub const fn fog(extinction: [f64; 3]) -> Self {
        Self { extinction, albedo: 0.0, anisotropy: 0.0, shadows: 0, reach: None }
    }
}

/// Why a text is no air.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AirError;

impl fmt::Display for AirError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(
            "expected none, warnock[:D0], romney[:P[:D0]], haze:NEAR:FAR with NEAR below FAR, or fog:S or fog:R:G:B, with numbers of \
             0 or more",
        )
    }
}

impl core::error::Error for AirError {}

/// Reads a name and its numbers, separated by colons: `haze:10:40`.
impl FromStr for Air {
    type Err = AirError;

    fn from_str(text: &str) -> Result<Self, AirError> {
        let mut words = text.split(':');
        let name = words.next().unwrap_or_default();
        let number = |word: &str| word.parse().ok().filter(|n: &f64| n.is_finite() && *n >= 0.0);
        let numbers = words.map(number).collect::<Option<Vec<f64>>>().ok_or(AirError)?;
        let fading = |fading, from: Option<f64>| {
            let is_right = from.is_none_or(|d0| d0 > 0.0);
            let attenuation = Attenuation { fading, from, color: None };
            is_right.then_some(Self { attenuation: Some(attenuation), medium: None })
        };
        let romney = |p: f64, from| fading(Fading::Romney(p), from).filter(|_| p > 0.0 && p <= 100.0);
        let fog = |extinction| Self { attenuation: None, medium: Some(Medium::fog(extinction)) };
        let air = match (name.to_ascii_lowercase().as_str(), numbers.as_slice()) {
            ("none", []) => Some(Self::default()),
            ("warnock", []) => fading(Fading::Warnock, None),
            ("warnock", &[d0]) => fading(Fading::Warnock, Some(d0)),
            ("romney", []) => romney(4.0, None),
            ("romney", &[p]) => romney(p, None),
            ("romney", &[p, d0]) => romney(p, Some(d0)),
            ("haze", &[near, far]) if near < far => fading(Fading::Haze([near, far]), None),
            ("fog", &[s]) => Some(fog([s; 3])),
            ("fog", &[r, g, b]) => Some(fog([r, g, b])),
            _ => None,
        };
        air.ok_or(AirError)
    }
}
