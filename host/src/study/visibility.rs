//! `rta visibility`.

pub mod casting;
pub mod integer;
pub mod outcome;
pub mod painter;
#[cfg(test)]
mod samples;
pub mod scanline;
pub mod scanplane;
pub mod subdivision;
#[cfg(test)]
mod tests;
pub mod zbuffer;
