//! The commands of the program, but for the studies, which are in [`study`](crate::study).

pub mod bake;
pub mod check;
pub mod convert;
pub mod explain;
pub mod gallery;
pub mod hash;
pub mod merge;
pub mod pages;
pub mod radiosity;
pub mod render;
pub mod show;
