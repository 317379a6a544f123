//! The search of a machine whose processor has lanes: a bounding volume hierarchy, made ahead and borrowed, that tests four
//! boxes at once, and in its leaves four bounding spheres.
//!
//! All of it is in `f32` whatever the picture is traced in, and all of it only says what a ray cannot meet. What is left is
//! asked in the picture's own format, so that a picture in fixed point keeps its bytes: each box and each sphere is larger
//! by a [margin](crate::Scalar::coarse_margin) than the object in it, that object's own test and this one can be wrong together.
//!
//! A node holds the boxes of its four children side by side (I. Wald, C. Benthin and S. Boulos, "Getting Rid of Packets",
//! IEEE Symposium on Interactive Ray Tracing, 2008). The search goes on in the nearest box that the ray enters and keeps
//! the others on a stack of fixed size. Rays that start at the eye or end at a lamp, which most do, have [`Cube`]s instead
//! that tell what lies in their direction. Firmware goes by [`bvh`](crate::bvh) or [`hierarchy`](crate::hierarchy) instead.
//!
//! A picture in `f32` has the lanes' own numbers. There the rays of four neighbouring pixels go side by side, and not only are
//! searched for together: where they meet something, how they leave it and where the lamps are from there is computed four at once,
//! by the same operations in the same order as one at a time.
#![allow(clippy::float_arithmetic)] // machines without lanes have none of it

mod cube;
mod four;
pub(crate) mod geometry;
mod rays;
mod search;
#[cfg(test)]
#[allow(clippy::indexing_slicing, clippy::float_cmp, reason = "a test may panic, and is exact")]
mod tests;
mod triangle;
pub(crate) mod vectors;

use glam::Vec4;

use crate::bvh::{Bits, Child, Item, first_wrong, index};
pub use cube::{Cube, Entry, Face};
pub(crate) use four::Four;
pub(crate) use rays::Met;
pub(crate) use search::{CoarseRay, Probe, Search, Waiting};
use vectors::{Vec3x4, pick};

/// Whether the machine that this is compiled for has lanes.
pub const LANES: bool =
    cfg!(any(target_feature = "sse2", target_feature = "neon", target_feature = "simd128"));

/// Coordinates are below this, so that no square overflows.
pub const LARGEST: f32 = 1e17;

/// A fixed-point number of an LSB of 2^-`fraction`, rounded.
#[inline]
#[allow(clippy::cast_precision_loss)] // to the nearest
pub(crate) fn coarse(bits: i32, fraction: u32) -> f32 {
    bits as f32 * f32::from_bits((127 - fraction) << 23)
}

/// [`Scalar::coarse_margin`](crate::Scalar::coarse_margin) of a format whose own margin is `own`: what is rounded to an `f32` is wrong by half an EPSILON of
/// `far`, and a foot point in `f32` by 14 EPSILON of its distance, which is below 3.5 `far`. Twice as much is added.
#[inline]
pub(crate) fn margin(far: f32, own: f32) -> f32 {
    far * (100.0 * f32::EPSILON) + own
}

/// A node: four boxes.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct Boxes {
    /// For x, y and z: the least of each box, and the greatest. Where there is no child, the least is infinite and the
    /// greatest its negative.
    pub planes: [[Vec4; 2]; 3],
    /// What is in them.
    pub children: [Child; 4],
}

impl Boxes {
    /// No boxes.
    pub const EMPTY: Self =
        Self { planes: [[Vec4::INFINITY, Vec4::NEG_INFINITY]; 3], children: [Child::EMPTY; 4] };
}

/// Four bounding spheres. That of a sphere or a lamp is the thing itself: in `f32` it is met by these numbers.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct Pack {
    /// x, y and z of their centres.
    pub center: [Vec4; 3],
    /// Radii; of none it is negative and infinite.
    pub radius: Vec4,
    /// What is in them.
    pub items: [Item; 4],
    /// Where there are cones among them, the number of their [`Rods`]; else [`Pack::NO_RODS`].
    pub rods: u32,
    /// Where there are triangles among them, the number of their [`Sheets`]; else [`Pack::NO_SHEETS`].
    pub sheets: u32,
}

impl Pack {
    /// No cones.
    pub const NO_RODS: u32 = u32::MAX;
    /// No triangles.
    pub const NO_SHEETS: u32 = u32::MAX;
    /// No spheres.
    pub const EMPTY: Self = Self {
        center: [Vec4::ZERO; 3],
        radius: Vec4::NEG_INFINITY,
        items: [Item::Sphere(u32::MAX); 4],
        rods: Self::NO_RODS,
        sheets: Self::NO_SHEETS,
    };

    /// Centre and radius of a bounding sphere, four times.
    #[inline(always)]
    pub(crate) fn sphere(&self, slot: usize) -> (Vec3x4, Vec4) {
        (Vec3x4(self.center.map(|four| pick(four, slot))), pick(self.radius, slot))
    }

    /// All items that are there.
    #[inline(always)]
    pub(crate) fn slots(&self) -> Bits {
        Bits(self.radius.cmpge(Vec4::ZERO).bitmask())
    }
}

/// Endless cylinders about the cones of a pack: their axes go through its centres.
#[derive(Clone, Copy, Debug)]
pub struct Rods {
    /// x, y and z of the unit vectors along their axes; of what is no cone, 0.
    pub axis: [Vec4; 3],
    /// Radii.
    pub radius: Vec4,
}

impl Rods {
    /// About everything.
    pub const EMPTY: Self = Self { axis: [Vec4::ZERO; 3], radius: Vec4::ZERO };
}

/// The planes of the triangles of a pack, as the picture has them; of what is no triangle, NaN.
#[derive(Clone, Copy, Debug)]
pub struct Sheets {
    /// x, y and z of their corners.
    pub corner: [Vec4; 3],
    /// x, y and z of their normals.
    pub normal: [Vec4; 3],
    /// x, y and z of what of [`Triangle`](crate::shape::Triangle) has this name.
    pub inward: [[Vec4; 3]; 3],
    /// How far their corners are from the opposite edges.
    pub height: Vec4,
}

impl Sheets {
    /// No planes.
    pub const EMPTY: Self = Self {
        corner: [Vec4::NAN; 3],
        normal: [Vec4::NAN; 3],
        inward: [[Vec4::NAN; 3]; 3],
        height: Vec4::NAN,
    };
}

/// Four vertical cylinders, seen from above.
#[derive(Clone, Copy, Debug)]
pub struct Posts {
    /// x and y of their axes.
    pub center: [Vec4; 2],
    /// Radii; of none it is negative and infinite.
    pub radius: Vec4,
    /// Which they are, in their list.
    pub cylinders: [u32; 4],
}

impl Posts {
    /// No cylinders.
    pub const EMPTY: Self =
        Self { center: [Vec4::ZERO; 2], radius: Vec4::NEG_INFINITY, cylinders: [u32::MAX; 4] };
}

/// A hierarchy over all finite objects and all visible lamps, and the vertical cylinders beside it; without packs and posts it
/// is none.
///
/// Admission sees that it leads on, ends and names each object once, not that each box contains its objects: that is the
/// builder's promise. Where one is too small, something is not seen; nothing else happens.
#[derive(Clone, Copy, Debug)]
pub struct Lanes<'a> {
    /// Nodes, the root first. Of few objects there are none: all packs are tried.
    pub nodes: &'a [Boxes],
    /// What the leaves hold: runs of it.
    pub packs: &'a [Pack],
    /// What the packs name.
    pub rods: &'a [Rods],
    /// What they name too.
    pub sheets: &'a [Sheets],
    /// The vertical cylinders, in the order of their list.
    pub posts: &'a [Posts],
    /// What is seen from the eye, and from each lamp; or no cubes. They belong to nodes.
    pub cubes: &'a [Cube],
    /// The first entry of each cell of the cubes, and where those of the last end.
    pub cells: &'a [u32],
    /// The packs that the cells have.
    pub entries: &'a [Entry],
    /// The largest size of a coordinate.
    pub size: f32,
}

impl Lanes<'_> {
    /// No hierarchy.
    pub const NONE: Self = Self {
        nodes: &[],
        packs: &[],
        rods: &[],
        sheets: &[],
        posts: &[],
        cubes: &[],
        cells: &[],
        entries: &[],
        size: 0.0,
    };

    /// The first node that is wrong; without nodes it is 0 where something is missing. `counts` are the numbers of spheres,
    /// ellipsoids, cones, triangles and visible lamps, `cylinders` that of cylinders, and `lamps` that of all lamps.
    pub(crate) fn first_wrong(&self, counts: [usize; 5], cylinders: usize, lamps: usize) -> Option<usize> {
        if self.packs.is_empty() && self.posts.is_empty() {
            return (!self.nodes.is_empty()).then_some(0);
        }
        let [spheres, ellipsoids, cones, triangles, _] = counts;
        let there = |item: &Item| item.is_in([spheres, ellipsoids, cones, triangles, lamps]);
        let held = self.packs.iter().flat_map(|pack| pack.items).filter(there).count();
        let there = |number: &u32| index(*number) < cylinders;
        let posts = self.posts.iter().flat_map(|posts| posts.cylinders).filter(there).count();
        if held != counts.iter().sum::<usize>() || posts != cylinders || !self.has_cubes_right() {
            return Some(0);
        }
        if self.nodes.is_empty() {
            return None;
        }
        first_wrong(|number| Some(self.nodes.get(number)?.children), self.nodes.len(), self.packs.len())
    }
}
