//! The ray tree of a pixel: its rays in the order in which they are traced, and what became of each of them.

use rta_core::ray::RayKind;
use rta_core::scene::Object;

/// What a ray hits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HitKind {
    /// No object: the sky.
    Sky,
    /// A tile of the floor: one of the odd ones, or not.
    Floor {
        /// Whether it has the second colour.
        odd: bool,
    },
    /// Any other object.
    Object(Object),
}

/// Whether a lamp is visible from a point, as far as the model asked.
#[derive(Clone, Copy, Debug)]
pub enum Visibility {
    /// The lamp is behind the surface.
    Behind,
    /// Its light is too faint for the number format, so no shadow ray was traced.
    Faint,
    /// The lamp is in front of the surface.
    Front {
        /// The part of its light that arrives: 0 in shadow.
        part: f64,
        /// Whether the point shows the lamp's cut-out highlight.
        glint: bool,
    },
}

impl Visibility {
    /// Returns whether both take the same branch. Light that is too faint in one format hardly counts in another.
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

/// One ray and what became of it.
#[derive(Clone, Debug)]
pub struct Step {
    /// The kind of ray.
    pub kind: RayKind,
    /// Number of rays between it and the eye.
    pub depth: u8,
    /// What it hit.
    pub hit: HitKind,
    /// Distance of the hit, if it was a surface.
    pub distance: Option<f64>,
    /// Whether it hit the surface from the inside.
    pub inside: bool,
    /// Whether there was total internal reflection.
    pub total_reflection: bool,
    /// Each lamp as seen from there; empty where the surface is not lit.
    pub lamps: Vec<Visibility>,
}

impl Step {
    /// Returns whether the two rays took the same branches.
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

/// The ray tree of a pixel.
#[derive(Clone, Debug, Default)]
pub struct RayTree {
    /// The rays, in the order in which they are traced.
    pub steps: Vec<Step>,
}

impl RayTree {
    /// Returns the index of the first ray that takes another branch in `other`, if any.
    #[must_use]
    pub fn parting(&self, other: &Self) -> Option<usize> {
        let like = self.steps.iter().zip(&other.steps).take_while(|(a, b)| a.is_like(b)).count();
        (like < self.steps.len().max(other.steps.len())).then_some(like)
    }
}
