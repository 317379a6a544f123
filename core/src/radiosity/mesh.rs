//! The patches of all quadrilaterals: their numbers, areas, and which of them a ray meets.

use super::Error;
use super::quad::{Quad, cell, greatest_reflectance};
use crate::color::Rgb;
use crate::quantity::{Bound, Quantity};
use crate::sampling::mapping::Frame;
use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector, Vec3, Vector};
use crate::scalar::{Light, Magnitude, Number, Positive, Scalar, Unit};
use crate::scene::{Object, Scene, index};
use crate::shape::Triangle;

/// A patch: the number of its quadrilateral, and its own numbers along u and v.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Patch {
    /// Number of the quadrilateral, from 0.
    pub quad: usize,
    /// Number of the patch along u and along v, from 0.
    pub cell: [u16; 2],
}

/// What is wrong with a quadrilateral.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Fault {
    /// Its triangles are not in the scene's list, or not behind those of the quadrilateral before it.
    Triangles,
    /// It has no patches, too many, or they are not numbered from behind those of the quadrilateral before it.
    Patches,
    /// A reflectance is below 0 or above [`greatest_reflectance`].
    Reflectance,
    /// It has no area, or is not convex.
    Area,
}

/// Quadrilaterals of a scene whose patches exchange light.
#[derive(Clone, Copy, Debug)]
pub struct Mesh<'a, S: Scalar> {
    quads: &'a [Quad<S>],
    triangles: &'a [Triangle<S>],
}

/// A patch from which rays leave.
#[derive(Clone, Copy, Debug)]
pub struct Site<'a, S: Scalar> {
    /// The quadrilateral.
    pub quad: &'a Quad<S>,
    /// The patch.
    pub patch: Patch,
    /// Unit normal on the side that reflects.
    pub normal: UnitVec3<S>,
    /// Size of the quadrilateral, as [`LengthVector::leave`] wants it.
    pub extent: S,
    /// Frame of the normal whose first side goes along u.
    pub frame: Frame<UnitVec3<S>>,
    spread: [S::Unit; 4],
}

impl<S: Scalar> Site<'_, S> {
    /// Returns the part of the largest `|P_u x P_v|` that is had at (u, v): the weight of a place that is spread evenly in (u, v).
    #[inline]
    pub fn weight(&self, [u, v]: [S::Unit; 2]) -> S::Unit {
        let mix = |a: S::Unit, b: S::Unit, part: S::Unit| a + (b - a).times(part);
        let [a, b, c, d] = self.spread;
        mix(mix(a, b, u), mix(d, c, u), v)
    }
}

impl<'a, S: Scalar> Mesh<'a, S> {
    /// Returns the mesh of quadrilaterals of a scene.
    ///
    /// # Errors
    /// [`Error::Quad`] with the first quadrilateral that is wrong, and [`Error::Exceeds`] where the light may be too bright for the number
    /// format.
    pub fn new(quads: &'a [Quad<S>], scene: &Scene<'a, S>) -> Result<Self, Error> {
        let mesh = Self { quads, triangles: scene.triangles };
        let (mut patches, mut triangles) = (0u32, 0);
        for (number, quad) in quads.iter().enumerate() {
            let wrong = |fault| Err(Error::Quad { quad: number, fault });
            let is_right = |part: S::Unit| part >= S::Unit::ZERO && part <= greatest_reflectance::<S::Unit>();
            let Rgb { r, g, b } = quad.reflectance.map(is_right);
            let next = quad
                .triangle
                .checked_add(quad.triangles)
                .filter(|&next| index(next) <= scene.triangles.len());
            let Some(next) = next.filter(|_| quad.triangles > 0 && quad.triangle >= triangles) else {
                return wrong(Fault::Triangles);
            };
            let count = u32::try_from(quad.len()).ok().filter(|&count| count > 0 && quad.first == patches);
            let Some(count) = count.and_then(|count| patches.checked_add(count)) else {
                return wrong(Fault::Patches);
            };
            (patches, triangles) = (count, next);
            if !(r && g && b) {
                return wrong(Fault::Reflectance);
            }
            if mesh.site(Patch { quad: number, cell: [0; 2] }).is_none() {
                return wrong(Fault::Area);
            }
        }
        let bound = mesh.bound();
        if bound.holds() { Ok(mesh) } else { Err(Error::Exceeds(bound)) }
    }

    /// Returns the quadrilaterals.
    pub const fn quads(&self) -> &'a [Quad<S>] {
        self.quads
    }

    /// Returns the number of all patches.
    pub fn len(&self) -> usize {
        self.quads.last().map_or(0, |last| index(last.first) + last.len())
    }

    /// Returns whether there are no patches.
    pub fn is_empty(&self) -> bool {
        self.quads.is_empty()
    }

    /// Returns the row of the range proof that bounds the radiosity: the largest emission over 1 less the largest reflectance.
    pub fn bound(&self) -> Bound {
        let mut worst = (Magnitude::ZERO, None);
        let mut reflectance = S::Unit::ZERO;
        for quad in self.quads {
            let Rgb { r, g, b } = quad.emission.map(Number::size);
            let emission = r.max(g).max(b);
            if emission > worst.0 {
                worst = (emission, Some(Object::Triangle(quad.triangle)));
            }
            quad.reflectance.map(|part| reflectance = if part > reflectance { part } else { reflectance });
        }
        let bound = worst.0.over((S::Unit::ONE - reflectance).size());
        let limit = S::Light::LARGEST;
        Bound { quantity: Quantity::Radiosity, bound, limit, object: worst.1, other: None }
    }

    /// Returns the number of a patch among all, as light is kept in a slice.
    #[inline]
    pub fn number(&self, patch: Patch) -> Option<usize> {
        let quad = self.quads.get(patch.quad)?;
        let ([i, j], [nu, nv]) = (patch.cell, quad.patches);
        (i < nu && j < nv).then(|| index(quad.first) + usize::from(i) + usize::from(j) * usize::from(nu))
    }

    /// Returns all patches in the order of their numbers.
    pub fn patches(&self) -> impl Iterator<Item = Patch> {
        self.quads.iter().enumerate().flat_map(|(number, quad)| {
            let [nu, nv] = quad.patches;
            (0..nv).flat_map(move |j| (0..nu).map(move |i| Patch { quad: number, cell: [i, j] }))
        })
    }

    /// Returns the patches that emit, but for those of the quadrilateral `own`, in the order of their numbers, each with its number among all
    /// patches of other quadrilaterals.
    pub(super) fn lamps(&self, own: usize) -> impl Iterator<Item = (Patch, u32)> {
        let skipped = self.quads.get(own).map_or(0, Quad::len);
        let others = self.quads.iter().enumerate().filter(move |(number, _)| *number != own);
        others.filter(|(_, quad)| quad.emission != Rgb::BLACK).flat_map(move |(number, quad)| {
            let before = if number > own { skipped } else { 0 };
            let [nu, nv] = quad.patches;
            let [[i0, j0], [i1, j1]] = quad.emitting;
            (j0..j1.min(nv)).flat_map(move |j| {
                (i0..i1.min(nu)).filter_map(move |i| {
                    let patch = Patch { quad: number, cell: [i, j] };
                    Some((patch, u32::try_from(self.number(patch)? - before).ok()?))
                })
            })
        })
    }

    /// Returns the patch with this number among all.
    pub fn patch(&self, number: usize) -> Option<Patch> {
        let found = self.quads.partition_point(|quad| index(quad.first) <= number).checked_sub(1)?;
        let quad = self.quads.get(found)?;
        let (own, [nu, _]) = (number - index(quad.first), quad.patches.map(usize::from));
        let cell = |number: usize| u16::try_from(number).ok();
        let patch = Patch { quad: found, cell: [cell(own.checked_rem(nu)?)?, cell(own / nu)?] };
        self.number(patch).map(|_| patch)
    }

    /// Returns the emitted radiosity of a patch.
    pub fn emitted(&self, patch: Patch) -> Rgb<S::Light> {
        self.quads.get(patch.quad).map_or(Rgb::BLACK, |quad| quad.emitted(patch.cell))
    }

    /// Returns the unit normal of a quadrilateral on the side that reflects.
    #[inline]
    pub fn normal(&self, quad: usize) -> Option<UnitVec3<S>> {
        let quad = self.quads.get(quad)?;
        self.triangles.get(index(quad.triangle)).map(|triangle| triangle.normal)
    }

    /// Returns what is needed to send rays from a patch; `None` for a patch that is not there, and for a quadrilateral without an area.
    pub fn site(&self, patch: Patch) -> Option<Site<'a, S>> {
        let quad = self.quads.get(patch.quad)?;
        let triangle = self.triangles.get(index(quad.triangle))?;
        let [along, _] = quad.slopes([S::Unit::ratio(1, 2); 2]);
        let (_, spread) = quad.spread(triangle.normal)?;
        let along = along.normalize()?.0;
        // Where the first of the triangles is not in one plane with the others, u may lead out of its plane.
        let (lean, least) = (along.dot(triangle.normal), S::Unit::ratio(1, 1 << 14));
        let is_flat = lean < least && -lean < least;
        let first = if is_flat { along } else { along.plus(triangle.normal, -lean).normalize()?.0 };
        let frame = Frame::beside(triangle.normal, first);
        Some(Site { quad, patch, normal: triangle.normal, extent: triangle.extent, frame, spread })
    }

    /// Returns the area of a patch: that of its two triangles, since it is flat.
    pub fn area(&self, patch: Patch) -> Option<S::Power> {
        let site = self.site(patch)?;
        let quad = site.quad;
        let (most, _) = quad.spread(site.normal)?;
        let [u, v] =
            [most == 1 || most == 2, most >= 2].map(|far| if far { S::Unit::ONE } else { S::Unit::ZERO });
        let [(along, length, _), (across, width, _)] = {
            let [along, across] = quad.slopes([u, v]);
            [along.normalize()?, across.normalize()?]
        };
        let sine = along.cross(across);
        let square = |c: S::Unit| (if c < S::Unit::ZERO { -c } else { c }).positive();
        let [x, y, z] = [sine.x(), sine.y(), sine.z()].map(square).map(|c| c.times(c));
        // The mean of |P_u x P_v|, which is linear, is that in the middle.
        let middle = site.weight(quad.within(patch.cell, [S::Unit::ratio(1, 2); 2])).positive();
        let count = S::Power::new(quad.len() as u64, 0);
        let whole = length.positive().times(width.positive()).times(x.plus(y).plus(z).root());
        Some(whole.times(middle).over(count))
    }

    /// Returns the area of the largest patch.
    pub fn largest_area(&self) -> S::Power {
        let mut most = S::Unit::ZERO.positive();
        for area in self.patches().filter_map(|patch| self.area(patch)) {
            most = if area.size() > most.size() { area } else { most };
        }
        most
    }

    /// Returns the area of a patch as a part of `whole`, which is larger or equal.
    pub fn share(&self, patch: Patch, whole: S::Power) -> S::Unit {
        self.area(patch).map_or(S::Unit::ZERO, |area| area.over(whole).unit())
    }

    /// Returns the form factor from a patch, the receiver, to another from the other's own factors `row`, since `A_i F_ij = A_j F_ji`; at most
    /// 1.99.
    pub fn turned(&self, receiver: Patch, source: Patch, row: &[S::Unit]) -> S::Unit {
        let factor = self.number(receiver).and_then(|number| row.get(number)).copied();
        let (Some(factor), Some(own), Some(other)) = (factor, self.area(receiver), self.area(source)) else {
            return S::Unit::ZERO;
        };
        let (turned, most) = (factor.positive().times(other).over(own).unit(), S::Unit::ratio(199, 100));
        if turned > most { most } else { turned }
    }

    /// Returns the quadrilateral and (u, v) of a place at which a ray met an object; `None` for an object that is no quadrilateral. From
    /// which side it was met is not looked at.
    pub fn locate(&self, object: Object, place: Vec3<S>) -> Option<(usize, [S::Unit; 2])> {
        let Object::Triangle(number) = object else { return None };
        let found = self.quads.partition_point(|quad| quad.triangle <= number).checked_sub(1)?;
        let quad = self.quads.get(found)?;
        if number - quad.triangle >= quad.triangles {
            return None;
        }
        let triangle = self.triangles.get(index(number))?;
        Some((found, quad.solved(triangle.normal, place)))
    }

    /// Returns the last quadrilateral that a ray in this direction meets at a place of one, which differs from that where the place is on its edge.
    pub(super) fn last_beside(
        &self,
        found: (usize, [S::Unit; 2]),
        place: Vec3<S>,
        direction: UnitVec3<S>,
    ) -> (usize, [S::Unit; 2]) {
        let near = S::Unit::ratio(1, 1 << 10);
        let is_inner = |at: S::Unit| at > near && at < S::Unit::ONE - near;
        if found.1.into_iter().all(is_inner) {
            return found;
        }
        let beside = |number: usize| {
            let quad = self.quads.get(number)?;
            let normal = self.normal(number).filter(|normal| normal.dot(direction) < S::Unit::ZERO)?;
            // What rounding may have taken the place off the edge.
            let (_, apart) = place.clearance(self.site(Patch { quad: number, cell: [0; 2] })?.extent);
            let is_near = |way: Vec3<S>| way.norm_squared() <= apart.square();
            let height = (place - quad.corners[0]).dot(normal);
            if height > apart || -height > apart {
                return None;
            }
            let at = quad.solved(normal, place);
            is_near(quad.place(at) - place).then_some((number, at))
        };
        (found.0 + 1..self.quads.len()).rev().find_map(beside).unwrap_or(found)
    }

    /// Returns the patch at (u, v) of a quadrilateral.
    #[inline]
    pub fn at(&self, quad: usize, [u, v]: [S::Unit; 2]) -> Option<Patch> {
        let [nu, nv] = self.quads.get(quad)?.patches;
        Some(Patch { quad, cell: [cell(u, nu), cell(v, nv)] })
    }
}

impl core::fmt::Display for Fault {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::Triangles => "has triangles that are not in the scene, or before those of another",
            Self::Patches => "has no patches, or patches that are numbered wrongly",
            Self::Reflectance => "has a reflectance that is not from 0 to 0.98",
            Self::Area => "has no area or is not convex",
        })
    }
}
