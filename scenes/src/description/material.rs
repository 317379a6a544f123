//! Materials with names, as the scene language has them.

pub use rta_core::illumination::table::Kind;

use super::{Dispersion, Surface};
use crate::gloss;

/// A material: what a scene says of it. What it leaves out, the illumination model decides.
///
/// A material serves every model, so a model may not use all that is said.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Material {
    /// Its name.
    pub name: String,
    /// Which of the thesis's types it is like, for the models that know no others.
    pub kind: Kind,
    /// Colour of objects that have none of their own, linear RGB, each 0 to 1.
    pub color: Option<[f64; 3]>,
    /// Coefficient of ambient light, ka, 0 to 1.
    pub ambient: Option<f64>,
    /// Diffuse coefficient, kd, 0 or more.
    pub diffuse: Option<f64>,
    /// Coefficient of light that shines through from behind, diffusely, 0 to 1.
    pub back: Option<f64>,
    /// Specular coefficient, ks, 0 or more: of highlights and of the reflected ray; in models of microfacets their share, s.
    pub specular: Option<f64>,
    /// Share of the light that is transmitted, kt, 0 or more.
    pub transmit: Option<f64>,
    /// Share of the light of the reflected ray, in models that have highlights without one, 0 to 1.
    pub mirror: Option<f64>,
    /// Exponent of highlights, 0 or more.
    pub exponent: Option<f64>,
    /// Angle in degrees at which highlights have half their strength, above 0 and below 45: it sets exponents and slopes where
    /// these are not given.
    pub gloss: Option<f64>,
    /// Roughness of the facets that reflect and refract rays, alpha of Trowbridge and Reitz, 0 (a mirror) to 1.
    pub roughness: Option<f64>,
    /// Slopes of microfacets, at most four, whose shares add up to 1; none where the model's is taken.
    pub slopes: Vec<Slope>,
    /// Index of refraction of the inside with respect to the outside, above 0.
    pub index: Option<f64>,
    /// How the index depends on the wavelength, in pictures of several wavelengths.
    pub dispersion: Option<Dispersion>,
    /// What a metal reflects at perpendicular incidence, linear RGB, each 0 to 1.
    pub metal: Option<[f64; 3]>,
    /// Index of refraction n and coefficient of extinction k of a metal, of red, green and blue.
    pub nk: Option<[[f64; 2]; 3]>,
    /// What is left of light inside after a length of 1, linear RGB, each above 0 and at most 1.
    pub absorb: Option<[f64; 3]>,
    /// How a thin wall transmits more or less where it is seen at an angle.
    pub edge: Option<Edge>,
    /// Whether it is a thin wall: light goes straight through.
    pub thin: bool,
    /// The radiance that its outside sends out by itself, linear RGB, each at least 0.
    pub emits: Option<[f64; 3]>,
    /// Whether its mirror rays see the sky alone, and no things.
    pub surroundings: bool,
    /// Name of the texture that gives its colour.
    pub texture: Option<String>,
    /// Name of the texture that gives its bumps, and their height.
    pub bump: Option<(String, f64)>,
    /// Line of the source where it begins, from 1; 0 if it has none.
    pub line: u32,
}

/// Microfacets of one slope.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slope {
    /// Root of the mean square of their slopes, m, 0.01 to 1.
    pub slope: f64,
    /// Their part of all facets, 0 to 1.
    pub share: f64,
}

/// Transmission of a thin wall: `least + (most - least) (1 - (1 - N.V)^exponent)` (Kay 1979).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// The exponent: 1, 2 or 3.
    pub exponent: u8,
    /// Transmission at the edge, 0 to 1.
    pub least: f64,
    /// Transmission where the wall is seen perpendicularly, 0 to 1.
    pub most: f64,
}

/// The coefficients of a material for the models that compute no reflectance of their own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficients {
    /// Of ambient light, 0 or more.
    pub ka: f64,
    /// Diffuse, 0 or more.
    pub kd: f64,
    /// Specular, 0 or more.
    pub ks: f64,
    /// Share of the light that is transmitted, 0 or more.
    pub kt: f64,
    /// Exponent of highlights by the halfway vector, 0 or more.
    pub exponent: f64,
    /// Exponent of highlights around the reflected ray, 0 or more.
    pub reflected: f64,
    /// Index of refraction of the inside with respect to the outside, above 0.
    pub index: f64,
}

/// The exponent of highlights where a scene states none.
const EXPONENT: f64 = 50.0;

impl Material {
    /// Returns the material of a surface, by its number among `materials` where it has one there; a number that is too large means
    /// a material that says nothing.
    #[must_use]
    pub fn of(surface: &Surface, materials: &[Self]) -> Self {
        let said = Self::default();
        match *surface {
            Surface::Of(number) => materials.get(usize::from(number)).cloned().unwrap_or(said),
            Surface::Shiny => Self { kind: Kind::Shiny, ..said },
            Surface::Mirror => Self { kind: Kind::Mirror, ..said },
            Surface::Transparent { ks, kt, ior } => {
                Self { diffuse: Some(0.0), specular: Some(ks), transmit: Some(kt), index: Some(ior), ..said }
            }
            Surface::Finish { kd, ks, exponent, kt, ior } => Self {
                diffuse: Some(kd),
                specular: Some(ks),
                exponent: Some(exponent),
                transmit: Some(kt),
                index: Some(ior),
                ..said
            },
            Surface::Opaque => said,
        }
    }

    /// Returns the material at a wavelength in nanometres: with the index that it has there.
    #[must_use]
    pub fn at(&self, nanometres: f64) -> Self {
        let at = |dispersion: &Dispersion| dispersion.index(self.index.unwrap_or(1.0), nanometres);
        Self { index: self.dispersion.as_ref().map(at).or(self.index), ..self.clone() }
    }

    /// Returns the coefficients; `None` for a material of one of the thesis's types 0 to 2 that states none.
    #[must_use]
    pub fn coefficients(&self) -> Option<Coefficients> {
        let stated = [self.ambient, self.diffuse, self.specular, self.transmit, self.exponent, self.gloss];
        // What comes through to a lamp is what comes through where a wall is seen perpendicularly.
        let transmit = self.transmit.or(self.edge.map(|edge| edge.most));
        let [kd, ks, kt] = match self.kind {
            Kind::Glass => [0.0, 0.1, 0.9],
            Kind::Metal => [0.4, 0.6, 0.0],
            _ if stated.iter().all(Option::is_none) && self.edge.is_none() => return None,
            Kind::Opaque => [1.0, 0.0, 0.0],
            Kind::Shiny => [0.8, 0.2, 0.0],
            Kind::Mirror => [0.0, 1.0, 0.0],
        };
        let kd = self.diffuse.unwrap_or(kd);
        let by_gloss = |exponent: fn(f64) -> f64| {
            self.exponent
                .unwrap_or_else(|| self.gloss.map_or(EXPONENT, |angle| exponent(angle).clamp(1.0, 1000.0)))
        };
        Some(Coefficients {
            ka: self.ambient.unwrap_or(kd),
            kd,
            ks: self.specular.unwrap_or(ks),
            kt: transmit.unwrap_or(kt),
            exponent: by_gloss(gloss::blinn),
            reflected: by_gloss(gloss::phong),
            // Through a thin wall light goes straight on.
            index: self.index.filter(|_| !self.thin).unwrap_or(1.0),
        })
    }
}
