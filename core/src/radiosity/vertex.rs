//! Light at vertices of patches, and between them.

use super::Error;
use super::mesh::{Mesh, Patch};
use super::quad::{cell, clamped};
use crate::color::Rgb;
use crate::scalar::{Light, Scalar, Summed, Unit};

/// The light of all patches of a mesh, interpolated within each quadrilateral.
#[derive(Clone, Copy, Debug)]
pub struct Solution<'a, S: Scalar> {
    mesh: Mesh<'a, S>,
    light: &'a [Rgb<S::Light>],
    /// [`Solution::corners`] of each patch, where they are kept; else empty.
    corners: &'a [Corners<S>],
}

/// The light at the corners of a patch, as its numbers along u and v are: at the first both, the first and the next, the next and the first, the
/// next both.
pub type Corners<S> = [Rgb<<S as Scalar>::Light>; 4];

/// A sum of light, register by register.
type Sums<L> = Rgb<<L as Summed>::Sum>;

/// Up to two patches in a row, and the weights that they have at a vertex of them.
type Row<U> = [(u16, U); 2];

/// Returns the two patches beside vertex number `vertex` of a row of `count`, with the weights that their mean has; at an end it is twice
/// the last one's less the next vertex's.
fn row<U: Unit>(vertex: u16, count: u16) -> Row<U> {
    let half = U::ratio(1, 2);
    let last = count.saturating_sub(1);
    match vertex {
        _ if last == 0 => [(0, U::ONE), (0, U::ZERO)],
        0 => [(0, U::ONE + half), (1, -half)],
        vertex if vertex > last => [(last, U::ONE + half), (last - 1, -half)],
        vertex => [(vertex - 1, half), (vertex, half)],
    }
}

impl<'a, S: Scalar> Solution<'a, S> {
    /// Returns the light of the patches of a mesh, in the order of their numbers.
    ///
    /// # Errors
    /// [`Error::Room`] where there is light for fewer patches.
    pub fn new(mesh: Mesh<'a, S>, light: &'a [Rgb<S::Light>]) -> Result<Self, Error> {
        let (needed, found) = (mesh.len(), light.len());
        if needed <= found {
            Ok(Self { mesh, light, corners: &[] })
        } else {
            Err(Error::Room { needed, found })
        }
    }

    /// Returns the solution with the light at the corners of its patches kept, in the order of the patches' numbers, each as
    /// [`Solution::corners`] has it: the same light, for less work wherever it is asked for.
    ///
    /// # Errors
    /// [`Error::Room`] where there are corners for fewer patches.
    pub fn with_corners(self, corners: &'a [Corners<S>]) -> Result<Self, Error> {
        let (needed, found) = (self.mesh.len(), corners.len());
        if needed <= found { Ok(Self { corners, ..self }) } else { Err(Error::Room { needed, found }) }
    }

    /// Returns the light at the corners of a patch.
    pub fn corners(&self, Patch { quad, cell: [i, j] }: Patch) -> Corners<S> {
        let kept = self.mesh.number(Patch { quad, cell: [i, j] }).and_then(|number| self.corners.get(number));
        let vertex = |along, up| self.vertex(quad, [i + along, j + up]);
        kept.copied().unwrap_or_else(|| [vertex(0, 0), vertex(1, 0), vertex(0, 1), vertex(1, 1)])
    }

    /// Returns the mesh.
    pub const fn mesh(&self) -> &Mesh<'a, S> {
        &self.mesh
    }

    /// Returns the light of a patch; none for one that is not there.
    pub fn patch(&self, patch: Patch) -> Rgb<S::Light> {
        let light = self.mesh.number(patch).and_then(|number| self.light.get(number));
        light.copied().unwrap_or(Rgb::BLACK)
    }

    /// Returns the light at vertex (i, j) of a quadrilateral, 0 to its number of patches each: within it the mean of four patches, beyond
    /// its outer patches what a straight line leads to, 0 or more; none for a quadrilateral that is not there. Other quadrilaterals do not
    /// enter it.
    ///
    /// Goral et al. 1984 have the light of outer vertices so: at an edge twice the mean of the two patches less the vertex within, in a
    /// corner twice the patch less the vertex diagonal to it.
    pub fn vertex(&self, quad: usize, [i, j]: [u16; 2]) -> Rgb<S::Light> {
        let Some([nu, nv]) = self.mesh.quads().get(quad).map(|quad| quad.patches) else { return Rgb::BLACK };
        let (across, up) = (row::<S::Unit>(i, nu), row::<S::Unit>(j, nv));
        let is_end = |vertex: u16, count: u16| count > 1 && (vertex == 0 || vertex >= count);
        let is_corner = is_end(i, nu) && is_end(j, nv);
        let quarter = S::Unit::ratio(1, 4);
        let patches = up.into_iter().flat_map(|(j, v)| across.map(|(i, u)| ([i, j], u, v)));
        let weighted = patches.enumerate().map(|(number, (cell, u, v))| {
            let weight = match (is_corner, number) {
                (true, 0) => S::Unit::ratio(7, 4),
                (true, _) => -quarter,
                (false, _) => u.times(v),
            };
            (self.patch(Patch { quad, cell }), weight)
        });
        mixed::<S>(weighted)
    }

    /// Returns the light at (u, v) of a quadrilateral, 0 to 1 each: bilinear between the vertices of its patches.
    pub fn at(&self, quad: usize, [u, v]: [S::Unit; 2]) -> Rgb<S::Light> {
        let Some([nu, nv]) = self.mesh.quads().get(quad).map(|quad| quad.patches) else { return Rgb::BLACK };
        let split = |at: S::Unit, count: u16| {
            let whole = cell(at, count);
            let share = |cells: u16| S::Unit::fraction(cells.into(), count.into());
            let part = clamped((at - share(whole)).quotient(share(1)));
            (whole, [S::Unit::ONE - part, part])
        };
        let ((i, across), (j, up)) = (split(u, nu), split(v, nv));
        let weights = up.into_iter().flat_map(|v| across.map(|u| u.times(v)));
        mixed::<S>(self.corners(Patch { quad, cell: [i, j] }).into_iter().zip(weights))
    }
}

/// Returns the sum of light times weights, which come to 1; 0 where it is negative.
fn mixed<S: Scalar>(light: impl Iterator<Item = (Rgb<S::Light>, S::Unit)>) -> Rgb<S::Light> {
    let empty = <S::Light as Summed>::EMPTY;
    let sums = light.fold(Rgb::new(empty, empty, empty), |sums: Sums<S::Light>, (light, weight)| {
        sums.zip(light, |sum, light| light.added(sum, weight))
    });
    let whole = S::Light::WHITE.added(empty, S::Unit::ONE);
    sums.map(|sum| S::Light::mean(sum, whole, S::Unit::ONE))
}
