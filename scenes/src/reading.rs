//! What a reader may do with a file that its format leaves open.

use crate::description::{Air, Shading};

/// How a scene file is read where its format leaves that open.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reading {
    /// Whether lines that begin with no entity of the format are passed over, each with a warning. Otherwise they are an
    /// error, but for those that cannot hold an object.
    pub lenient: bool,
    /// Whether polygons of NFF are seen only from where their corners run counterclockwise, as the format has it. Many files
    /// do not care, so that half of a mesh would be missing: without it they are seen from both sides.
    pub one_sided: bool,
    /// Air that takes the place of the scene's.
    pub air: Option<Air>,
    /// The most pixels on a side that a picture of a texture or of the sky keeps; 0 leaves pictures unread.
    pub texels: Option<u32>,
    /// The number of wavelengths that takes the place of the scene's: an odd number from 1 to 31, or 0 for red, green and blue.
    pub wavelengths: Option<u32>,
    /// Spheres and ellipsoids become meshes with twice as many quadrilaterals around the axis and as many from pole to pole.
    pub tessellate: Option<u32>,
    /// How all triangles with normals are shaded, whatever the scene says.
    pub shading: Option<Shading>,
    /// Whether normals and light of vertices are mixed on the screen, for rays from the eye.
    pub scanline: bool,
    /// The instant of the film, 0 to 1, at which the scene is drawn, with everything where it is then; without it nothing has moved, and
    /// what moves along paths is kept.
    pub instant: Option<f64>,
}
