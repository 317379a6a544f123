//! Tells the program by which compiler it was built, and how: instruction counts are compared only between equals.

use core::error::Error;
use std::env;
use std::process::Command;

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    let version = Command::new(env::var("RUSTC")?).arg("--version").output()?.stdout;
    let version = String::from_utf8(version)?;
    let (target, level) = (env::var("TARGET")?, env::var("OPT_LEVEL")?);
    let features = env::var("CARGO_CFG_TARGET_FEATURE").unwrap_or_default();
    println!("cargo::rustc-env=RTA_BUILD={}, {target} ({features}), opt-level {level}", version.trim());
    Ok(())
}
