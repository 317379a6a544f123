//! Hands the linker its script.

use std::env;

fn main() {
    let folder = env::var("CARGO_MANIFEST_DIR").expect("cargo sets it");
    println!("cargo:rustc-link-arg=-T{folder}/prom.ld");
    println!("cargo:rerun-if-changed=prom.ld");
}
