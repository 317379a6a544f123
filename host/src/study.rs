//! Studies of the tracer itself: what its pictures cost, and what its number formats do to them.

pub mod bench;
pub mod error;
pub mod paired;
pub mod report;
pub mod stability;
