//! What each command of the program does. The studies have rooms of their own in [`study`](crate::study).

pub mod bake;
pub mod check;
pub mod explain;
pub mod hash;
pub mod render;
pub mod show;
