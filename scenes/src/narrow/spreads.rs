//! What spreads rays in a scene: lamps with a size, a lens, rough materials.

use rta_core::camera::{Aperture, Camera};
use rta_core::illumination::microfacet::Roughness;
use rta_core::illumination::table::MOST_SLOPES;
use rta_core::light::area::Square;
use rta_core::trace::dice::Spread;
use rta_core::trace::moving::Motion;
use rta_core::trace::path::Emitter;
use rta_core::vector::{UnitVector, Vec3, Vector};

use super::check::Checker;
use super::moving::{eye, motions};
use super::variant::Options;
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
    /// Slopes of the materials that are rough by grooves, in their order as far as any is; of a share of 0 for the others.
    pub slopes: Vec<[Roughness<S::Unit>; MOST_SLOPES]>,
    /// The bodies of the triangles, by a number for each, equal for faces of one body.
    pub bodies: Vec<u32>,
    /// The lamps whose light paths meet on triangles.
    pub emitters: Vec<Emitter<S>>,
    /// What moves while the shutter is open.
    pub motions: Vec<Motion<S>>,
    /// How far the eye moves while it is.
    pub eye: Option<Vec3<S>>,
}

impl<S: Narrow> Narrowed<S> {
    /// Returns what spreads, borrowed, where lamps are asked as `asked` says.
    pub fn spread(&self, asked: &Spreading) -> Spread<'_, S> {
        let Spreads { squares, aperture, roughness, slopes, bodies, eye, .. } = &self.spreads;
        Spread {
            lamps: asked.lamps,
            split: asked.split,
            squares,
            aperture: *aperture,
            roughness,
            slopes,
            bodies,
            indirect: self.lit.as_ref().and_then(|lit| lit.indirect(&self.scene())),
            eye: *eye,
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
            let check = Checker::new("lamp", number, line);
            let middle = description.lamps.get(number).map_or(*corner, |lamp| lamp.position);
            let middle = check.place(middle, 0.0)?;
            squares.push(Some(square(&check, (*corner, middle), *edges)?));
        }
        let options = Options::of(description);
        let roughness = said.iter().map(|own| own.roughness.or_else(|| options.lobe(description.model, own)));
        let roughness: Vec<_> = roughness.map(|own| own.unwrap_or(0.0)).collect();
        let rough = roughness.iter().rposition(|own| *own > 0.0);
        let mut roughness: Vec<_> = roughness.into_iter().map(S::unit).collect();
        roughness.truncate(rough.map_or(0, |last| last + 1));
        let slopes: Vec<_> =
            said.iter().map(|own| options.lobe_slopes::<S>(description.model, own)).collect();
        let grooved = slopes.iter().rposition(Option::is_some).map_or(0, |last| last + 1);
        let none = Roughness { share: S::unit(0.0), inverse: <S as Narrow>::power(1.0) };
        let slopes = slopes.into_iter().take(grooved).map(|own| own.unwrap_or([none; MOST_SLOPES]));
        Ok(Self {
            squares,
            aperture: aperture(description, camera)?,
            roughness,
            slopes: slopes.collect(),
            bodies: bodies(description),
            emitters: shining.iter().map(emitter).collect(),
            motions: motions(description)?,
            eye: eye::<S>(description)?,
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
    (corner, middle): ([f64; 3], Vec3<S>),
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
        middle,
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
