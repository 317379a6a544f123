//! Hands the linker the script of the way to boot.

use std::env;

fn main() {
    let folder = env::var("CARGO_MANIFEST_DIR").expect("cargo sets it");
    let floppy = env::var_os("CARGO_FEATURE_FLOPPY").is_some();
    let script = if floppy { "floppy.ld" } else { "multiboot.ld" };
    println!("cargo:rustc-link-arg=-T{folder}/{script}");
    println!("cargo:rerun-if-changed={script}");
}
