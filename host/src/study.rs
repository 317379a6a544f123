//! Studies of the tracer itself: what its pictures cost, what its number formats do to them, and how different two pictures look.

pub mod bench;
pub mod error;
pub mod measure;
pub mod paired;
pub mod report;
pub mod stability;
pub mod values;
