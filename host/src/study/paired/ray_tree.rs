//! The ray tree of a pixel: its rays in the order in which they are traced, and what became of each of them.

use rta_core::illumination::RayKind;
use rta_core::scene::Object;

/// What a ray met.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HitKind {
    /// Nothing.
    Sky,
    /// A tile of the floor: one of the odd ones, or not.
    Floor {
        /// Whether it has the second colour.
        odd: bool,
    },
    /// Any other object, by its place in its list.
    Object(Object),
}

/// How a lamp shines on a surface.
#[derive(Clone, Copy, Debug)]
pub enum Visibility {
    /// Not at all: it is behind the surface.
    Behind,
    /// Too faint for the number format, so nobody asked for its shadow.
    Faint,
    /// It is in front.
    Front {
        /// What part of its light comes through: 0 in the shadow.
        part: f64,
        /// Whether it makes a cut-out highlight there.
        glint: bool,
    },
}

impl Visibility {
    /// Whether the two are one branch. What is too faint in one format brings next to nothing in another.
    fn is_like(self, other: Self) -> bool {
        // The parts are products of a few coefficients, each rounded.
        const ROUNDING: f64 = 1e-5;
        match (self, other) {
            (Self::Behind, Self::Behind) | (Self::Faint, Self::Faint | Self::Behind) => true,
            (Self::Behind, Self::Faint) => true,
            (Self::Faint, Self::Front { glint, .. }) | (Self::Front { glint, .. }, Self::Faint) => !glint,
            (Self::Front { part: a, glint: b }, Self::Front { part: c, glint: d }) => {
                (a - c).abs() < ROUNDING && (b == d || a == 0.0)
            }
            _ => false,
        }
    }
}

/// One ray and what came of it.
#[derive(Clone, Debug)]
pub struct Step {
    /// What it was traced for.
    pub kind: RayKind,
    /// How many rays there are between it and the eye.
    pub depth: u8,
    /// What it met.
    pub hit: HitKind,
    /// How far away, where that was a surface.
    pub distance: Option<f64>,
    /// Whether it met that from the inside.
    pub inside: bool,
    /// Whether all of it was reflected there that should have been transmitted.
    pub total_reflection: bool,
    /// How each lamp shines there; none where the surface is not lit.
    pub lamps: Vec<Visibility>,
}

impl Step {
    /// Whether the two took the same branches.
    #[must_use]
    pub fn is_like(&self, other: &Self) -> bool {
        self.kind == other.kind
            && self.depth == other.depth
            && self.hit == other.hit
            && self.inside == other.inside
            && self.total_reflection == other.total_reflection
            && self.lamps.len() == other.lamps.len()
            && self.lamps.iter().zip(&other.lamps).all(|(a, b)| a.is_like(*b))
    }
}

/// The ray tree of a pixel, in the order it is followed.
#[derive(Clone, Debug, Default)]
pub struct RayTree {
    /// The rays.
    pub steps: Vec<Step>,
}

impl RayTree {
    /// The first ray with another branch; nothing where the two are one.
    #[must_use]
    pub fn parting(&self, other: &Self) -> Option<usize> {
        let like = self.steps.iter().zip(&other.steps).take_while(|(a, b)| a.is_like(b)).count();
        (like < self.steps.len().max(other.steps.len())).then_some(like)
    }
}
