//! Tools of the tests that span several crates: independent renderers ([`oracle`]), generated scenes
//! ([`random_scenes`]), golden pictures ([`golden`]), comparison of pictures ([`picture`],
//! [`agreement`], [`exact`]), bytes that every build draws ([`baseline`], [`deterministic`]), points of surfaces as a model is asked about
//! them ([`point`]), and the boards under emulation ([`boards`]).

pub mod agreement;
pub mod baseline;
pub mod boards;
pub mod close;
pub mod deterministic;
pub mod exact;
pub mod fuzzed;
pub mod fuzzed_picture;
pub mod golden;
pub mod measure;
pub mod oracle;
pub mod picture;
pub mod point;
pub mod random_scenes;

/// The code of the README, compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
struct Readme;
