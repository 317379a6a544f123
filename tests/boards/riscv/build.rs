//! Tells the linker where its script is: it works in the workspace's folder.

use std::env;

fn main() {
    println!("cargo::rerun-if-changed=link.ld");
    println!(
        "cargo::rustc-link-search={}",
        env::var("CARGO_MANIFEST_DIR").expect("Cargo sets CARGO_MANIFEST_DIR")
    );
}
