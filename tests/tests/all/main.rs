//! What holds rta together, in one program, so that it is linked once. Each module is a theme; its name is a filter:
//!
//! ```text
//! cargo test -p rta-tests --test all golden
//! ```
//!
//! `accuracy`, `baseline` and `deterministic` are programs of their own: they are also run alone, and in release.

mod analytic;
mod bounds;
mod branches;
mod bvh;
mod cases;
mod circles;
mod coats;
mod corners;
mod devices;
mod edges;
mod examples;
mod extremes;
mod fit;
mod fuzzed;
mod gallery;
mod geometry;
mod golden;
mod identities;
mod invariance;
mod medium;
mod mesh;
mod models;
mod needs;
mod numbers;
mod options;
mod properties;
mod range;
mod readme;
mod reductions;
mod report;
mod sampling;
mod scene_page;
mod single_rays;
mod solid_cases;
mod solids;
mod spectral;
mod stability;
mod stack;
mod thin;
mod twins;
mod values;
mod zbuffer;
