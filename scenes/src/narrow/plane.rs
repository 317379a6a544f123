//! An infinite plane in one number format.

use rta_core::scene::PLAIN;
use rta_core::shape::Plane;

use super::triangle::direction;
use super::{Checker, Narrow, NarrowError};
use crate::description;
use crate::space::{Triple, difference, dot, unit};

/// Returns plane number `index` of a description, about the place of it that is nearest to the eye, of no
/// material yet.
pub(super) fn narrow<S: Narrow>(
    index: usize,
    of: &description::Plane,
    eye: Triple,
) -> Result<Plane<S>, NarrowError> {
    let check = Checker::<S>::new("plane", index, of.line);
    let Some(normal) = unit(of.normal) else { return Err(check.error("the normal", 0.0, 1.0)) };
    let height = dot(difference(eye, of.point), normal);
    let [x, y, z] = normal.map(|c| c * height);
    Ok(Plane {
        center: check.place(difference(eye, [x, y, z]), Plane::<S>::reach().to_f64())?,
        normal: direction::<S>(normal),
        color: check.color("a colour's register", of.color)?,
        material: PLAIN,
    })
}
