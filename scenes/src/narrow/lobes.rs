//! How rough a surface is by the facets that a model has for its highlights, so that its mirror rays are spread by the model's own lobe.

use std::borrow::Cow;

use rta_core::illumination::beckmann_slopes;
use rta_core::illumination::microfacet::Roughness;
use rta_core::illumination::table::MOST_SLOPES;

use super::Narrow;
use super::variant::Options;
use crate::description::{Description, Kind, Material};
use crate::gloss;
use crate::model::Model;

/// The option of a model by which its reflected and refracted rays are spread as its highlights are.
pub(crate) const LOBES: &str = "lobes";

/// The parts of the models that say nothing else: c of Trowbridge and Reitz with half of the facets at 10 degrees, and the slope of Cook and
/// Torrance.
const ROUNDNESS: f64 = 0.260_495;
const SLOPE: f64 = 0.3;

impl Options {
    /// Returns how rough a material is, 0 to 1, by the facets of a model with the option `lobes`; `None` without it, and for a material that
    /// reflects and transmits no rays. Facets are spread by Trowbridge and Reitz, which for theirs is exact: the roughness is c. A slope m of
    /// Beckmann's is the roughness m, as the two agree near the normal but for a factor of the tails, and of several slopes it is the root of the
    /// mean square; by itself it counts only with `sancer`, as [grooves](Self::lobe_slopes) are spread by Beckmann's own. Other facets have as
    /// many at the same angle as half of those straight up ([`gloss`](crate::gloss)).
    pub(crate) fn lobe(&self, model: Model, material: &Material) -> Option<f64> {
        self.numbers(model, LOBES)?;
        let own = self.said(model, material);
        let is_above = |share: Option<f64>| share.is_some_and(|share| share > 0.0);
        if own.kind == Kind::Opaque && ![own.specular, own.mirror, own.transmit].into_iter().any(is_above) {
            return None;
        }
        let (number, has) = (|name| self.number(model, name), |name| self.numbers(model, name).is_some());
        // The angle at which the facets are half as many, in degrees.
        let at_half = |angle: f64| gloss::trowbridge(angle.clamp(0.0, 89.0));
        let roughness = match model {
            Model::BlinnFull if has("power") => {
                let exponent = own.exponent.or(own.gloss.map(gloss::blinn)).or_else(|| number("power"));
                exponent.map_or(ROUNDNESS, |n| at_half(0.5_f64.powf(n.recip()).acos().to_degrees()))
            }
            Model::BlinnFull if has("gauss") => {
                let narrowness = own.gloss.map(gloss::gauss).or_else(|| number("gauss"));
                narrowness.map_or(ROUNDNESS, |c| at_half((core::f64::consts::LN_2.sqrt() / c).to_degrees()))
            }
            Model::BlinnFull => {
                own.gloss.map(gloss::trowbridge).or_else(|| number("trowbridge")).unwrap_or(ROUNDNESS)
            }
            Model::CookTorrance if !own.slopes.is_empty() => {
                let [shares, squares] = own.slopes.iter().fold([0.0; 2], |[shares, squares], part| {
                    [shares + part.share, squares + part.share * part.slope * part.slope]
                });
                if shares > 0.0 { (squares / shares).sqrt() } else { SLOPE }
            }
            Model::CookTorrance => own.gloss.map_or(SLOPE, gloss::beckmann),
            _ => return None,
        };
        Some(roughness.clamp(0.0, 1.0))
    }
}

impl Options {
    /// Returns the slopes of a material by whose grooves its mirror rays are spread: those of Cook and Torrance with the option `lobes`, but not
    /// `sancer`. `None` of others, and of a material that says its roughness itself.
    pub(crate) fn lobe_slopes<S: Narrow>(
        &self,
        model: Model,
        material: &Material,
    ) -> Option<[Roughness<S::Unit>; MOST_SLOPES]> {
        let is_grooved = model == Model::CookTorrance && self.numbers(model, "sancer").is_none();
        (is_grooved && material.roughness.is_none()).then_some(())?;
        self.lobe(model, material)?;
        Some(beckmann_slopes::<S>(&*self.said(model, material)))
    }
}

impl Description {
    /// Returns whether the model that the scene is made for spreads rays by its own lobes.
    #[must_use]
    pub fn has_lobes(&self) -> bool {
        self.settings.model_options.iter().any(|option| option.name == LOBES)
    }

    /// Returns the scene as a model draws it: without the lobes of the model that it is made for, if that is another.
    #[must_use]
    pub fn drawn_by(&self, model: Model) -> Cow<'_, Self> {
        if model == self.model || !self.has_lobes() {
            return Cow::Borrowed(self);
        }
        let mut other = self.clone();
        other.settings.model_options.retain(|option| option.name != LOBES);
        Cow::Owned(other)
    }
}
