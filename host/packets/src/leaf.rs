//! The nodes of the hierarchy, which hold four boxes, and the leaves, which hold four bounding spheres.

use core::fmt;
use core::num::NonZeroU32;

use glam::Vec4;
use rta_core::scene::Object;
use rta_core::shape::Triangle;

use crate::four::vector::{Vec3x4, pick, set};

/// The greatest number of levels of nodes in a hierarchy.
pub(crate) const MAX_DEPTH: usize = 21;

/// Coordinates are below this, so that no square overflows.
pub(crate) const LARGEST: f32 = 1e17;

/// The child in one of a node's boxes: none, a node that comes later in the list, or a run of leaves.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) struct Child(u32);

impl Child {
    /// No child.
    pub(crate) const EMPTY: Self = Self(u32::MAX);
    /// The most leaves in a run.
    pub(crate) const MAX_COUNT: u32 = 14;
    /// The most leaves in all.
    pub(crate) const MAX_ITEMS: u32 = 1 << Self::FIRST_BITS;
    const FIRST_BITS: u32 = 27;
    const RUN: u32 = 1 << 31;

    /// Returns the child that is node `number`; [`Child::EMPTY`] where that is not below 2^31.
    pub(crate) const fn node(number: u32) -> Self {
        if number < Self::RUN { Self(number) } else { Self::EMPTY }
    }

    /// Returns the child that is a run of `count` leaves from leaf `first` on; [`Child::EMPTY`] where there are too many.
    pub(crate) const fn run_of(first: u32, count: u32) -> Self {
        if first >= Self::MAX_ITEMS || count > Self::MAX_COUNT {
            return Self::EMPTY;
        }
        Self(Self::RUN | count << Self::FIRST_BITS | first)
    }

    /// Returns the node's number; `None` for a run of leaves and for no child.
    #[inline]
    pub(crate) fn number(self) -> Option<usize> {
        (self.0 & Self::RUN == 0).then(|| index(self.0))
    }

    /// Returns the first leaf of a run and the number of leaves; for no child, a run beyond all lists.
    #[inline]
    pub(crate) fn run(self) -> (usize, usize) {
        (index(self.0 & (Self::MAX_ITEMS - 1)), index(self.0 >> Self::FIRST_BITS & 15))
    }
}

impl fmt::Debug for Child {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.number() {
            Some(number) => write!(f, "node {number}"),
            None => write!(f, "leaves {:?}", self.run()),
        }
    }
}

/// A node: four boxes.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(crate) struct Boxes {
    /// For x, y and z: the least of each box, and the greatest. Where there is no child, the least is infinite and the
    /// greatest its negative.
    pub(crate) planes: [[Vec4; 2]; 3],
    /// The children in the boxes.
    pub(crate) children: [Child; 4],
}

impl Boxes {
    /// No boxes.
    pub(crate) const EMPTY: Self =
        Self { planes: [[Vec4::INFINITY, Vec4::NEG_INFINITY]; 3], children: [Child::EMPTY; 4] };

    /// Returns where a ray enters each box, 0 if it starts within; and a bit for each that it enters before `t_max`, the lowest for the first. For
    /// x, y and z there are the places from where the way is to the plane that it enters by, and to the one that it leaves by; the reciprocal
    /// of its direction; and which plane it enters by, where 0 is the least.
    #[inline(always)]
    #[allow(clippy::indexing_slicing, reason = "every index is below the length")]
    pub(crate) fn enter(
        &self,
        (starts, inverse, entry): (&[[Vec4; 2]; 3], &[Vec4; 3], &[usize; 3]),
        t_max: f32,
    ) -> (Vec4, u32) {
        let (mut near, mut far) = (Vec4::ZERO, Vec4::splat(t_max));
        for axis in 0..3 {
            let ([start, end], inverse, entry) = (starts[axis], inverse[axis], entry[axis] & 1);
            // Where there is no number, the second operand is the result.
            near = ((self.planes[axis][entry] - start) * inverse).max(near);
            far = ((self.planes[axis][entry ^ 1] - end) * inverse).min(far);
        }
        (near, near.cmple(far).bitmask())
    }
}

/// A leaf: four bounding spheres. For a sphere or a lamp it is the object itself, so that `f32` finds the hit by these numbers.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(crate) struct Sphere4 {
    /// x, y and z of their centres.
    pub(crate) center: [Vec4; 3],
    /// Radii; of none it is negative and infinite.
    pub(crate) radius: Vec4,
    /// The objects in them; `Object::Floor`, which is in no leaf, for an empty place.
    pub(crate) items: [Object; 4],
    /// Where there are cones among them, the number of their [`Cone4`]; else [`Sphere4::NO_CONES`].
    pub(crate) cones: u32,
    /// Where there are triangles among them, the number of their [`Triangle4`], or in `f32` their [`Exact4`]; else [`Sphere4::NO_TRIANGLES`].
    pub(crate) triangles: u32,
}

impl Sphere4 {
    /// No cones.
    pub(crate) const NO_CONES: u32 = u32::MAX;
    /// No triangles.
    pub(crate) const NO_TRIANGLES: u32 = u32::MAX;
    /// No spheres.
    pub(crate) const EMPTY: Self = Self {
        center: [Vec4::ZERO; 3],
        radius: Vec4::NEG_INFINITY,
        items: [Object::Floor; 4],
        cones: Self::NO_CONES,
        triangles: Self::NO_TRIANGLES,
    };

    /// Returns centre and radius of one bounding sphere, four times.
    #[inline(always)]
    pub(crate) fn sphere(&self, slot: usize) -> (Vec3x4, Vec4) {
        (Vec3x4(self.center.map(|four| pick(four, slot))), pick(self.radius, slot))
    }

    /// Returns the numbers of the spheres that are there.
    #[inline(always)]
    pub(crate) fn slots(&self) -> Bits {
        Bits(self.radius.cmpge(Vec4::ZERO).bitmask())
    }
}

/// Infinite cylinders about the cones of a leaf: their axes go through the centres of the leaf's bounding spheres.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cone4 {
    /// x, y and z of the unit vectors along their axes; of what is no cone, 0.
    pub(crate) axis: [Vec4; 3],
    /// Radii.
    pub(crate) radius: Vec4,
}

impl Cone4 {
    /// Cylinders that exclude nothing.
    pub(crate) const EMPTY: Self = Self { axis: [Vec4::ZERO; 3], radius: Vec4::ZERO };
}

/// The planes of the triangles of a leaf, as the picture has them; of what is no triangle, NaN.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Triangle4 {
    /// x, y and z of their corners.
    pub(crate) corner: [Vec4; 3],
    /// x, y and z of their normals.
    pub(crate) normal: [Vec4; 3],
    /// For each vertex, x, y and z of the unit vector in the plane that is normal to the opposite edge and points to the vertex.
    pub(crate) inward: [[Vec4; 3]; 3],
    /// How far their corners are from the opposite edges.
    pub(crate) height: Vec4,
}

impl Triangle4 {
    /// No planes.
    pub(crate) const EMPTY: Self = Self {
        corner: [Vec4::NAN; 3],
        normal: [Vec4::NAN; 3],
        inward: [[Vec4::NAN; 3]; 3],
        height: Vec4::NAN,
    };
}

/// Four triangles in `f32`, as the picture has them, so that the search finds their hits itself.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Exact4 {
    pub(crate) vertices: [Vec3x4; 3],
    pub(crate) normal: Vec3x4,
    /// The longer of the edges at the first vertices.
    pub(crate) extent: Vec4,
    /// How far a plane must be above a ray that meets it from behind: 0, or infinity where the triangle is seen from one side alone.
    pub(crate) back: Vec4,
    /// A bit for each that is there.
    pub(crate) which: u32,
}

impl Exact4 {
    /// No triangles, which no ray meets.
    pub(crate) const EMPTY: Self = {
        let nothing = Vec3x4([Vec4::NAN; 3]);
        Self { vertices: [nothing; 3], normal: nothing, extent: Vec4::NAN, back: Vec4::NAN, which: 0 }
    };

    /// One triangle, four times.
    #[inline(always)]
    pub(crate) fn splat(triangle: &Triangle<f32>) -> Self {
        Self {
            vertices: triangle.vertices.map(Vec3x4::splat),
            normal: Vec3x4::splat(triangle.normal),
            extent: Vec4::splat(triangle.extent),
            back: Vec4::splat(back(triangle)),
            which: 15,
        }
    }

    /// Changes one of them.
    pub(crate) fn set(&mut self, k: usize, triangle: &Triangle<f32>) {
        for (four, vertex) in self.vertices.iter_mut().zip(triangle.vertices) {
            four.set(k, vertex);
        }
        self.normal.set(k, triangle.normal);
        set(&mut self.extent, k, triangle.extent);
        set(&mut self.back, k, back(triangle));
        self.which |= 1 << (k & 3);
    }
}

/// Returns the triangle's part of [`Exact4::back`].
#[inline(always)]
fn back(triangle: &Triangle<f32>) -> f32 {
    if triangle.one_sided { f32::INFINITY } else { 0.0 }
}

/// Four vertical cylinders, seen from above.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Column4 {
    /// x and y of their axes.
    pub(crate) center: [Vec4; 2],
    /// Radii; of none it is negative and infinite.
    pub(crate) radius: Vec4,
    /// Which they are, in their list.
    pub(crate) cylinders: [u32; 4],
}

impl Column4 {
    /// No cylinders.
    pub(crate) const EMPTY: Self =
        Self { center: [Vec4::ZERO; 2], radius: Vec4::NEG_INFINITY, cylinders: [u32::MAX; 4] };
}

/// The numbers of the bits that are 1, of the lowest four.
#[derive(Clone, Copy)]
pub(crate) struct Bits(pub(crate) u32);

impl Iterator for Bits {
    type Item = usize;

    #[inline]
    fn next(&mut self) -> Option<usize> {
        let lowest = NonZeroU32::new(self.0)?.trailing_zeros();
        self.0 &= self.0.wrapping_sub(1);
        Some(index(lowest & 3))
    }
}

/// A number as an index; one that is too large for the machine lies beyond all lists.
#[inline]
pub(crate) fn index(number: u32) -> usize {
    usize::try_from(number).unwrap_or(usize::MAX)
}
