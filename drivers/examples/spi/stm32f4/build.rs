//! Writes the memory map of the STM32F411xE: 512 KiB of flash memory, 128 KiB of RAM.

use std::path::PathBuf;
use std::{env, fs};

const MAP: &str = "\
MEMORY {
  FLASH : ORIGIN = 0x08000000, LENGTH = 512K
  RAM : ORIGIN = 0x20000000, LENGTH = 128K
}
";

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("Cargo sets OUT_DIR"));
    fs::write(out.join("memory.x"), MAP).expect("OUT_DIR can be written");
    println!("cargo::rustc-link-search={}", out.display());
}
