//! One parameter for the highlights of all models: the angle at which a distribution of facets has half as many as it has
//! straight up (R. Hall, "Illumination and Color in Computer Generated Imagery", 1989), so that models can be compared.
//!
//! Angles are in degrees, above 0 and below 90, or below 45 for [`phong`].

use core::f64::consts::LN_2;

/// Returns the exponent of a highlight by the halfway vector, and of the distribution
/// [`Power`](rta_core::illumination::microfacet::Power): `-ln 2 / ln cos b`.
#[must_use]
pub fn blinn(angle: f64) -> f64 {
    -LN_2 / angle.to_radians().cos().ln()
}

/// Returns the exponent of a highlight around the reflected ray, which moves by twice the angle of the halfway vector.
#[must_use]
pub fn phong(angle: f64) -> f64 {
    blinn(2.0 * angle)
}

/// Returns c of [`Gauss`](rta_core::illumination::microfacet::Gauss): `sqrt(ln 2) / b`, b in radians.
#[must_use]
pub fn gauss(angle: f64) -> f64 {
    LN_2.sqrt() / angle.to_radians()
}

/// Returns c of [`Trowbridge`](rta_core::illumination::microfacet::Trowbridge): `c^2 = (cos^2 b - 1) / (cos^2 b - sqrt 2)`.
#[must_use]
pub fn trowbridge(angle: f64) -> f64 {
    let square = angle.to_radians().cos().powi(2);
    ((square - 1.0) / (square - core::f64::consts::SQRT_2)).sqrt()
}

/// Returns m of [`Beckmann`](rta_core::illumination::microfacet::Beckmann): `m^2 = -tan^2 b / ln(cos^4 b / 2)`.
#[must_use]
pub fn beckmann(angle: f64) -> f64 {
    let angle = angle.to_radians();
    (-angle.tan().powi(2) / (angle.cos().powi(4) / 2.0).ln()).sqrt()
}
