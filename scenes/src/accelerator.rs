//! Builders of hierarchies: what they share, and the one for firmware.
//!
//! A hierarchy is made ahead, from the description of a scene in `f64`, by the surface area heuristic. What it holds is larger
//! than its objects by what their numbers are rounded by in the format.

pub mod bounds;
pub mod bvh;
pub mod sah;
pub mod search;
pub mod solid;
