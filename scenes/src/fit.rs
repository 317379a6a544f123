//! A scene made larger or smaller, so that it fits a number format.

use core::fmt;

use crate::description::{Cone, Description, Lamp, Model, Triangle};

/// The smallest and the largest factor that are tried, as powers of two.
pub const EXPONENTS: core::ops::RangeInclusive<i32> = -40..=40;

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
        for Lamp { position, color, radius, .. } in &mut self.lamps {
            scale(position);
            *radius *= factor;
            if self.model == Model::Rta {
                color.iter_mut().for_each(|register| *register *= factor * factor);
            }
        }
    }
}

/// The power of two nearest to 1 by which a scene has to be scaled so that it `fits`, the smaller of two that are as
/// near; `None` if there is none within [`EXPONENTS`].
///
/// # Errors
/// [`FloorError`], unless it fits as it is.
pub fn fit(scene: &Description, fits: impl Fn(&Description) -> bool) -> Result<Option<f64>, FloorError> {
    if fits(scene) {
        return Ok(Some(1.0));
    }
    if scene.floor.is_some() {
        return Err(FloorError);
    }
    // One copy for all: powers of two do not round, and a scene may hold a million objects.
    let (mut copy, mut last) = (scene.clone(), 1.0);
    let larger = 1..=*EXPONENTS.end();
    let mut factors = larger.flat_map(|exponent| [-exponent, exponent]).map(|exponent| 2_f64.powi(exponent));
    Ok(factors.find(|&factor| {
        copy.scale(factor / last);
        last = factor;
        fits(&copy)
    }))
}

#[cfg(test)]
mod tests;
