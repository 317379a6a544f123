//! Four rays side by side.

pub(crate) mod closest;
pub(crate) mod geometry;
mod mesh;
pub(crate) mod packet;
pub(crate) mod surfaces;
#[cfg(test)]
#[allow(clippy::indexing_slicing, clippy::float_cmp, reason = "a test may panic, and is exact")]
mod tests;
pub(crate) mod trace;
pub(crate) mod transmittance;
pub(crate) mod triangle;
pub(crate) mod vector;
