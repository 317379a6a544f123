//! Writes the memory map: 2 MiB of flash memory, of which the first 256 bytes make it readable, and 256 KiB of RAM.

use std::path::PathBuf;
use std::{env, fs};

const MAP: &str = "\
MEMORY {
  BOOT2 : ORIGIN = 0x10000000, LENGTH = 0x100
  FLASH : ORIGIN = 0x10000100, LENGTH = 2048K - 0x100
  RAM : ORIGIN = 0x20000000, LENGTH = 256K
}
SECTIONS {
  .boot2 ORIGIN(BOOT2) : { KEEP(*(.boot2)); } > BOOT2
} INSERT BEFORE .text;
";

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("Cargo sets OUT_DIR"));
    fs::write(out.join("memory.x"), MAP).expect("OUT_DIR can be written");
    println!("cargo::rustc-link-search={}", out.display());
}
