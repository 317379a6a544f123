//! A cone in one number format: everything but its middle is made in `f64`.

use rta_core::scene::PLAIN;
use rta_core::shape::Cone;

use super::triangle::direction;
use super::{Checker, Narrow, NarrowError};
use crate::description;
use crate::space::{difference, length, unit};

/// Returns cone number `index` of a description, of no material yet.
pub(super) fn narrow<S: Narrow>(index: usize, of: &description::Cone) -> Result<Cone<S>, NarrowError> {
    let check = Checker::<S>::new("cone", index, of.line);
    let way = difference(of.apex, of.base);
    let height = length(way);
    let (base, apex) = (of.base_radius, of.apex_radius);
    check.place(of.base, base)?;
    check.place(of.apex, apex)?;
    let Some(axis) = unit(way) else { return Err(check.error("the height", 0.0, S::SMALLEST_RADIUS)) };
    check.radius(base.max(apex))?;
    let [x, y, z] = [0, 1, 2].map(|i: usize| {
        of.base.get(i).zip(of.apex.get(i)).map_or(0.0, |(base, apex)| f64::midpoint(*base, *apex))
    });
    let radius = (height / 2.0).hypot(base.max(apex));
    let center = check.place([x, y, z], radius)?;
    let span = check.radius(2.0 * radius)?;
    // The side's own length.
    let side = height.hypot(apex - base);
    let (cosine, sine) = (height / side, (apex - base) / side);
    let part = |length: f64| S::unit(length / (2.0 * radius));
    Ok(Cone {
        center,
        axis: direction::<S>(axis),
        span,
        inverse_span: span.inverse(),
        half_height: part(height / 2.0),
        waist: part(f64::midpoint(base, apex) * cosine),
        cosine: S::unit(cosine),
        sine: S::unit(sine),
        radii: [part(base), part(apex)],
        capped: of.capped,
        inside_only: of.inside_only,
        color: check.color("a colour's register", of.color)?,
        material: PLAIN,
    })
}
