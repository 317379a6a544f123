//! Studies of the tracer itself: what its pictures cost, what its number formats and the colours of devices do to them, how different
//! two pictures look, and how other algorithms find what is seen.

pub mod bench;
pub mod compare;
pub mod cones;
pub mod difference;
pub mod error;
pub mod figures;
pub mod html;
pub mod markdown;
pub mod measure;
pub mod models;
pub mod palette;
pub mod plot;
pub mod report;
mod sheet;
pub mod stability;
pub mod trail;
pub mod values;
pub mod visibility;
