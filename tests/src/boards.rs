//! The boards under emulation: which there are, how their images are built and booted, and the pictures that they must
//! draw.
//!
//! The images are the packages of `tests/boards`. They are built with one scene, number format and set of needs each,
//! run in an emulator, and what they drew is compared byte for byte with what the engine draws here.

mod antialiased;
pub mod board;
pub mod compare;
pub mod dos;
pub mod dosbox;
pub mod elf;
pub mod expected;
pub mod footprint;
pub mod machine;
pub mod models;
pub mod pcx;
pub mod picture;
pub mod qmp;
pub mod report;
pub mod row;
pub mod toolchain;

use std::path::PathBuf;

/// Returns the folder of the boards' packages.
#[must_use]
pub fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("boards")
}

/// An error of any kind.
pub type Failure = Box<dyn core::error::Error + Send + Sync>;
