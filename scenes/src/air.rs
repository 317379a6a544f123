//! Air, as a scene or a command line says it: what becomes of light between the things of a scene, under any illumination model.

use core::fmt;
use core::str::FromStr;

/// What fills the space between the things of a scene.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Air {
    /// Nothing.
    #[default]
    Clear,
    /// Light fades with the distance from the eye: `min(1, (d0 / d)^exponent)`.
    Distance {
        /// The exponent, 0 or more: 1 of Warnock, 2 or 4 of Romney.
        exponent: f64,
        /// d0, above 0; if none is said, the length of the ray in the middle of the picture.
        reference: Option<f64>,
    },
    /// Haze hides a growing part of what is farther than `near`, and all of what is farther than `far`.
    Haze {
        /// A length, 0 or more.
        near: f64,
        /// A length above `near`.
        far: f64,
        /// Its radiance; if none is said, the horizon's.
        color: Option<[f64; 3]>,
    },
    /// Fog leaves `exp(-s d)` of the light over a length d.
    Fog {
        /// s of each register, 0 or more.
        extinction: [f64; 3],
    },
}

impl Air {
    /// Returns the air of a scene that is `factor` times as large.
    #[must_use]
    pub fn scaled(self, factor: f64) -> Self {
        match self {
            Self::Clear => Self::Clear,
            Self::Distance { exponent, reference } => {
                Self::Distance { exponent, reference: reference.map(|length| length * factor) }
            }
            Self::Haze { near, far, color } => Self::Haze { near: near * factor, far: far * factor, color },
            Self::Fog { extinction } => Self::Fog { extinction: extinction.map(|s| s / factor) },
        }
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
        let distance = |exponent: f64, reference: Option<f64>| {
            let is_right = exponent <= 100.0 && reference.is_none_or(|d0| d0 > 0.0);
            is_right.then_some(Self::Distance { exponent, reference })
        };
        let air = match (name.to_ascii_lowercase().as_str(), numbers.as_slice()) {
            ("none", []) => Some(Self::Clear),
            ("warnock", []) => distance(1.0, None),
            ("warnock", &[d0]) => distance(1.0, Some(d0)),
            ("romney", []) => distance(4.0, None),
            ("romney", &[p]) => distance(p, None),
            ("romney", &[p, d0]) => distance(p, Some(d0)),
            ("haze", &[near, far]) => (near < far).then_some(Self::Haze { near, far, color: None }),
            ("fog", &[s]) => Some(Self::Fog { extinction: [s; 3] }),
            ("fog", &[r, g, b]) => Some(Self::Fog { extinction: [r, g, b] }),
            _ => None,
        };
        air.ok_or(AirError)
    }
}
