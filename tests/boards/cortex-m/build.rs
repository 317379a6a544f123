//! Writes the memory map of the board that the features choose.

use std::path::PathBuf;
use std::{env, fs};

/// Feature as Cargo spells it for build scripts, sizes of flash memory and RAM.
const BOARDS: [(&str, &str, &str); 3] = [
    ("CARGO_FEATURE_MICROBIT", "256K", "16K"),
    ("CARGO_FEATURE_LM3S6965EVB", "256K", "64K"),
    ("CARGO_FEATURE_MPS2_AN386", "4M", "4M"),
];

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let mut chosen = BOARDS.iter().filter(|(feature, ..)| env::var_os(feature).is_some());
    let (Some((_, flash, ram)), None) = (chosen.next(), chosen.next()) else {
        println!("cargo::error=choose one board: --features microbit, lm3s6965evb or mps2-an386");
        return;
    };
    let map = format!(
        "MEMORY {{\n  FLASH : ORIGIN = 0x00000000, LENGTH = {flash}\n  RAM : ORIGIN = 0x20000000, LENGTH = {ram}\n}}\n"
    );
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("Cargo sets OUT_DIR"));
    fs::write(out.join("memory.x"), map).expect("OUT_DIR can be written");
    println!("cargo::rustc-link-search={}", out.display());
}
