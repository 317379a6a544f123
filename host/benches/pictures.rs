//! How long small pictures take on one core, without start-up and without writing them anywhere.
//!
//! `cargo bench -p rta` prints wall-clock times, which are quiet only on a quiet machine; `rta bench` counts CPU time, rays
//! and instructions.

use divan::Bencher;
use rta::bench::case::{Case, Tracing};
use rta::engine::Format;
use rta::raster::Size;

fn main() {
    divan::main();
}

/// Each scene that the program carries in itself, and random spheres, in float and in fixed point: 64 x 40, depth 5.
#[divan::bench(
    args = ["juggler", "hall-22", "glass-2", "balls2", "spheres-22", "spheres-1000", "spheres-10000"],
    consts = [false, true],
)]
fn picture<const FIXED: bool>(bencher: Bencher, scene: &str) {
    let format = if FIXED { Format::Q16 } else { Format::F32 };
    let size = Size::new(64, 40).expect("it is small");
    let tracing = Tracing { format, size: Some(size), depth: 5 };
    let case = Case::named(scene, tracing).expect("a scene that fits every format");
    let mut picture = case.picture().expect("little memory");
    bencher.bench_local(|| case.engine().level_rows(0, u8::MAX, &mut picture));
}
