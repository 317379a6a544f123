//! What spreads rays in a scene: lamps with a size, a lens, rough materials.

use rta_core::camera::{Aperture, Camera};
use rta_core::light::area::Square;
use rta_core::trace::dice::Spread;
use rta_core::trace::moving::Motion;
use rta_core::trace::path::Emitter;
use rta_core::vector::{UnitVector, Vector};

use super::check::Checker;
use super::moving::motions;
use super::{Narrow, NarrowError, Narrowed};
use crate::description::{Description, LampShape, Material, Shining};
use crate::sampler::Spreading;
use crate::space::{cross, length, unit};

/// What spreads rays in a scene of one number format: the lists that a core [`Spread`] borrows.
#[derive(Clone, Debug, PartialEq)]
pub struct Spreads<S: Narrow> {
    /// Lamps that are parallelograms, in the order of the scene's lamps as far as any is one.
    pub squares: Vec<Option<Square<S>>>,
    /// The lens, if there is one.
    pub aperture: Option<Aperture<S>>,
    /// Roughness of the materials, in their order as far as any is rough.
    pub roughness: Vec<S::Unit>,
    /// The bodies of the triangles, by a number for each, equal for faces of one body.
    pub bodies: Vec<u32>,
    /// The lamps whose light paths meet on triangles.
    pub emitters: Vec<Emitter<S>>,
    /// What moves while the shutter is open.
    pub motions: Vec<Motion<S>>,
}

impl<S: Narrow> Narrowed<S> {
    /// Returns what spreads, borrowed, where lamps are asked as `asked` says.
    pub fn spread(&self, asked: &Spreading) -> Spread<'_, S> {
        let Spreads { squares, aperture, roughness, bodies, .. } = &self.spreads;
        Spread {
            lamps: asked.lamps,
            split: asked.split,
            squares,
            aperture: *aperture,
            roughness,
            bodies,
            indirect: self.lit.as_ref().and_then(|lit| lit.indirect(&self.scene())),
        }
    }
}

impl<S: Narrow> Spreads<S> {
    pub(super) fn of(
        description: &Description,
        said: &[Material],
        camera: &Camera<S>,
        shining: &[Shining],
    ) -> Result<Self, NarrowError> {
        let emitter = |&Shining { lamp, triangle, area }: &Shining| {
            let area = <S as Narrow>::power(area);
            Emitter { lamp, triangle, area }
        };
        let mut squares = Vec::new();
        for (&number, shape) in &description.details.lamps {
            let LampShape::Area { corner, edges } = shape else { continue };
            let line = description.lamps.get(number).map_or(0, |lamp| lamp.line);
            squares.resize(number, None);
            squares.push(Some(square(&Checker::new("lamp", number, line), *corner, *edges)?));
        }
        let mut roughness: Vec<_> = said.iter().map(|own| S::unit(own.roughness.unwrap_or(0.0))).collect();
        let rough = said.iter().rposition(|own| own.roughness.is_some_and(|roughness| roughness > 0.0));
        roughness.truncate(rough.map_or(0, |last| last + 1));
        Ok(Self {
            squares,
            aperture: aperture(description, camera)?,
            roughness,
            bodies: bodies(description),
            emitters: shining.iter().map(emitter).collect(),
            motions: motions(description)?,
        })
    }
}

/// Returns a number for each triangle, the same for those that one statement of the scene's file made: the faces of a polygon or of a mesh.
fn bodies(description: &Description) -> Vec<u32> {
    let mut number = 0;
    let triangles = &description.triangles;
    let mut before = None;
    let each = triangles.iter().map(|triangle| {
        if before.is_some_and(|line| line != triangle.line || line == 0) {
            number += 1;
        }
        before = Some(triangle.line);
        number
    });
    each.collect()
}

fn square<S: Narrow>(
    check: &Checker<S>,
    corner: [f64; 3],
    edges: [[f64; 3]; 2],
) -> Result<Square<S>, NarrowError> {
    let far = |by: &[[f64; 3]]| {
        let mut place = corner;
        for edge in by {
            place.iter_mut().zip(edge).for_each(|(c, edge)| *c += edge);
        }
        check.place(place, 0.0)
    };
    let [first, second] = edges;
    let (corner, ends) = (far(&[])?, [far(&[first])?, far(&[second])?]);
    far(&edges)?;
    let area = cross(first, second);
    let [x, y, z] = unit(area).unwrap_or([0.0, 0.0, 1.0]).map(S::unit);
    let least = S::length((length(area).sqrt() / 64.0).max(S::SMALLEST_RADIUS));
    Ok(Square {
        corner,
        edges: ends.map(|end| end - corner),
        normal: Vector::new(x, y, z),
        least: (least, least.inverse()),
    })
}

fn aperture<S: Narrow>(
    description: &Description,
    camera: &Camera<S>,
) -> Result<Option<Aperture<S>>, NarrowError> {
    let Some(diameter) = description.optics.aperture else { return Ok(None) };
    let check = Checker::<S>::named("the lens");
    let radius = diameter / 2.0;
    check.place(description.camera.eye, radius)?;
    let sharp = description.optics.focus.unwrap_or_else(|| length(description.camera.view));
    let forward = [camera.forward.x(), camera.forward.y(), camera.forward.z()].map(S::unit_to_f64);
    let shift = radius * length(forward) / sharp;
    check.at_most("its radius over the distance that is sharp, in focal distances", shift, MOST_SHIFT)?;
    let [right, up] = [camera.right, camera.up].map(|side| side.normalize().map_or(side, |(side, _)| side));
    Ok(Some(Aperture { radius: S::length(radius), shift: S::unit(shift), axes: [right, up] }))
}

/// The way to a place of the image plane, at most the root of 1.5 long, and this shift have room in every format.
const MOST_SHIFT: f64 = 0.5;
