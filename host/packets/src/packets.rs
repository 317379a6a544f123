//! The lists that the search goes by.

use crate::leaf::{Boxes, Column4, Cone4, Exact4, Sphere4, Triangle4};
use crate::light_buffer::LightBuffers;

/// How a processor with SIMD registers searches a scene: a hierarchy over all finite objects and all visible lamps, the vertical
/// cylinders beside it, and light buffers. Built by [`Packets::build`]; a reference to it is an accelerator.
///
/// That each box contains its objects is the builder's promise. Where one is too small, something is not seen; nothing else
/// happens.
#[derive(Clone, Debug, Default)]
pub struct Packets {
    /// Nodes of four boxes in preorder, the root first. Of few objects there are none: all leaves are tried.
    pub(crate) nodes: Vec<Boxes>,
    /// The root of the visible lamps, where they are so many that they are not among the objects.
    pub(crate) lamps: Option<u32>,
    /// Objects, four by four: what nodes and light buffers name.
    pub(crate) leaves: Vec<Sphere4>,
    /// Cylinders about the cones among them, named by leaves.
    pub(crate) cones: Vec<Cone4>,
    /// Planes of the triangles among them, named by leaves.
    pub(crate) triangles: Vec<Triangle4>,
    /// In `f32`, in their place, the triangles themselves.
    pub(crate) exact: Vec<Exact4>,
    /// Vertical cylinders, four by four, in the order of their list.
    pub(crate) columns: Vec<Column4>,
    /// What is seen from the eye, and from the first lamps; nothing without nodes.
    pub(crate) light_buffers: LightBuffers,
    /// The largest size of a coordinate.
    pub(crate) size: f32,
    /// Whether the scene is too large to be searched in `f32`: then each object is asked.
    pub(crate) is_too_large: bool,
}

#[cfg(test)]
mod tests;
