//! A scene made larger or smaller, so that it fits a number format, and fixed point has enough steps for it.
//!
//! What a picture in fixed point is wrong by falls with the scale of its scene, as places are rounded to a step of the format;
//! and nothing else of it grows as long as the scene is admitted. So the best scale is the largest that is admitted, and
//! beyond [`ENOUGH`] steps it makes no difference, as directions are not finer than that.

use core::fmt;

use crate::accelerator::bounds::Bounds;
use crate::accelerator::solid::solids;
use crate::description::{Attenuation, Cone, Description, Fading, Lamp, LampShape, Model, Optics, Triangle};
use crate::format::Format;
use crate::in_format;
use crate::narrow::Narrow;

/// Steps of a fixed-point format, as a power of two: a scene with as many along its longest side gains nothing by a larger scale.
pub const ENOUGH: f64 = 22.0;
/// Scales that are tried, each half the one before. The first is beyond what any proof admits, and the bounds of the proof, which
/// has spheres about cones and triangles, are at most 2 x 2 x sqrt(3) times the scene's longest side.
const TRIED: i32 = 6;

/// A scene has a floor, whose tiles have the size that they have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FloorError;

impl fmt::Display for FloorError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a scene with a floor cannot be scaled: the tiles keep their size")
    }
}

impl core::error::Error for FloorError {}

impl Description {
    /// The same scene `factor` times as large, about the origin: from its eye it is the same picture. Lamps that are
    /// attenuated are brighter by the square of it.
    ///
    /// # Errors
    /// [`FloorError`].
    pub fn scaled(mut self, factor: f64) -> Result<Self, FloorError> {
        if self.floor.is_some() {
            return Err(FloorError);
        }
        self.scale(factor);
        Ok(self)
    }

    /// The same, whatever the floor.
    fn scale(&mut self, factor: f64) {
        let scale = |place: &mut [f64; 3]| place.iter_mut().for_each(|c| *c *= factor);
        scale(&mut self.camera.eye);
        self.scale_rest(factor);
        for cylinder in &mut self.cylinders {
            scale(&mut cylinder.position);
            cylinder.radius *= factor;
        }
        for ellipsoid in &mut self.ellipsoids {
            scale(&mut ellipsoid.position);
            scale(&mut ellipsoid.radii);
        }
        for sphere in &mut self.spheres {
            scale(&mut sphere.position);
            sphere.radius *= factor;
        }
        for Cone { base, base_radius, apex, apex_radius, .. } in &mut self.cones {
            scale(base);
            scale(apex);
            *base_radius *= factor;
            *apex_radius *= factor;
        }
        for Triangle { vertices, .. } in &mut self.triangles {
            vertices.iter_mut().for_each(scale);
        }
        for plane in &mut self.planes {
            scale(&mut plane.point);
        }
        for Lamp { position, color, radius, fall_off, .. } in &mut self.lamps {
            scale(position);
            *radius *= factor;
            if fall_off.fades(self.model.is_attenuated()) {
                color.iter_mut().for_each(|register| *register *= factor * factor);
            }
        }
    }
}

impl Description {
    /// Scales the lengths of what few scenes have.
    fn scale_rest(&mut self, factor: f64) {
        let scale = |place: &mut [f64; 3]| place.iter_mut().for_each(|c| *c *= factor);
        let Optics { focus, aperture, hither, shutter: _, moves: _ } = &mut self.optics;
        [focus, aperture, hither].into_iter().flatten().for_each(|length| *length *= factor);
        if let Some(Attenuation { fading, from, color: _ }) = &mut self.air.attenuation {
            from.iter_mut().for_each(|length| *length *= factor);
            if let Fading::Haze(distances) = fading {
                distances.iter_mut().for_each(|distance| *distance *= factor);
            }
        }
        if let Some(medium) = &mut self.air.medium {
            medium.extinction.iter_mut().for_each(|part| *part /= factor);
            medium.reach.iter_mut().for_each(|reach| *reach *= factor);
        }
        for texture in &mut self.textures {
            scale(&mut texture.at);
            texture.scale *= factor;
        }
        self.materials
            .iter_mut()
            .filter_map(|own| own.bump.as_mut())
            .for_each(|(_, height)| *height *= factor);
        for left in self.materials.iter_mut().filter_map(|material| material.absorb.as_mut()) {
            left.iter_mut().for_each(|part| *part = part.powf(1.0 / factor).clamp(f64::MIN_POSITIVE, 1.0));
        }
        for shape in self.details.lamps.values_mut() {
            if let LampShape::Area { corner, edges: [first, second] } = shape {
                [corner, first, second].into_iter().for_each(scale);
            }
        }
        let keyframes = self.details.paths.iter_mut().flat_map(|path| &mut path.keyframes);
        keyframes.map(|keyframe| &mut keyframe.place).for_each(scale);
        self.details.journey.iter_mut().filter_map(|journey| journey.aim.as_mut()).for_each(scale);
        self.all_moves().for_each(scale);
    }
}

/// What a scale does for a scene in a number format.
#[derive(Clone, Debug, PartialEq)]
pub enum Fitted {
    /// The scene is admitted, and no scale makes its picture more precise.
    AsItIs,
    /// The factor of the most precise picture, the scene scaled by it, and how many bits are gained by that; none are said to be
    /// gained where the scene is not admitted as it is.
    Scaled {
        /// A power of two.
        factor: f64,
        /// The scene, so many times as large.
        scene: Box<Description>,
        /// How many times, as a power of two, the steps of the format become smaller in the scene, as far as that matters.
        gain: Option<f64>,
    },
    /// The scene is not admitted at any scale.
    Never,
}

/// Returns what a scale does for a scene in a number format, drawn with a model. A format
/// of floating-point numbers has as many digits at each scale: there a scene is scaled only if it is not admitted as it is.
/// `is_admitted` is whether it is, and `admits` tells that of others.
///
/// # Errors
/// [`FloorError`], unless it is admitted as it is.
pub fn fit(
    scene: &Description,
    model: Model,
    format: Format,
    is_admitted: bool,
    admits: impl Fn(&Description) -> bool,
) -> Result<Fitted, FloorError> {
    let missing = missing(scene, format);
    if is_admitted && missing <= 0.0 {
        return Ok(Fitted::AsItIs);
    }
    if scene.floor.is_some() {
        return if is_admitted { Ok(Fitted::AsItIs) } else { Err(FloorError) };
    }
    let most = in_format!(format, S => most::<S>(scene, model));
    let least = if is_admitted { 1 } else { most - TRIED };
    // One copy for all: powers of two do not round, and a scene may hold a million objects.
    let mut copy = Description { model, ..scene.clone() };
    copy.scale(2_f64.powi(most));
    for exponent in (least.max(most - TRIED)..=most).rev() {
        if admits(&copy) {
            let gain = is_admitted.then(|| f64::from(exponent).min(missing));
            copy.model = scene.model;
            return Ok(Fitted::Scaled { factor: 2_f64.powi(exponent), scene: Box::new(copy), gain });
        }
        copy.scale(0.5);
    }
    Ok(if is_admitted { Fitted::AsItIs } else { Fitted::Never })
}

/// Returns how many bits a fixed-point format has too few for a scene at its own scale, as a power of two: more than 0 where its
/// longest side has fewer steps than [`ENOUGH`]. In floating point, and where a scene has a floor or no extent, it is 0.
#[must_use]
pub fn missing(scene: &Description, format: Format) -> f64 {
    let Some(step) = format.step().filter(|_| scene.floor.is_none()) else { return 0.0 };
    let side = longest(&extent(scene));
    if side > 0.0 { ENOUGH - (side / step).log2() } else { 0.0 }
}

/// Returns a box about the eye, all lamps and all objects; of a vertical cylinder, about the middle of it.
fn extent(scene: &Description) -> Bounds {
    let eye = Bounds::about(scene.camera.eye, [0.0; 3]);
    let lamps = scene.lamps.iter().map(|lamp| Bounds::about(lamp.position, [lamp.radius; 3]));
    let cylinders = scene.cylinders.iter().map(|c| {
        let [x, y, _] = c.position;
        Bounds::about([x, y, 0.0], [c.radius; 3])
    });
    let solids = solids(scene).into_iter().map(|solid| solid.bounds);
    solids.chain(lamps).chain(cylinders).fold(eye, |all, bounds| all.with(&bounds))
}

fn longest(bounds: &Bounds) -> f64 {
    bounds.low.iter().zip(bounds.high).map(|(low, high)| high - low).fold(0.0, f64::max)
}

/// Returns the exponent of a power of two that no larger scale is admitted than: neither can the distance between two places be
/// more than three quarters of the format, nor a coordinate more than all of it, nor a lamp brighter than its limit.
#[allow(clippy::cast_possible_truncation)] // within some thousand
fn most<S: Narrow>(scene: &Description, model: Model) -> i32 {
    let extent = extent(scene);
    let by_place = (0.75 * S::largest() / longest(&extent)).min(S::largest() / extent.largest());
    let fading = scene.lamps.iter().filter(|lamp| lamp.fall_off.fades(model.is_attenuated()));
    let strongest = fading.flat_map(|lamp| lamp.color).fold(0.0, f64::max);
    let by_light = (S::LARGEST_POWER / strongest).sqrt(); // infinite, if none fades
    // More is of no use for numbers that are as good as 0, or 0 themselves.
    by_place.min(by_light).log2().floor().clamp(-500.0, 500.0) as i32
}

#[cfg(test)]
mod tests;
