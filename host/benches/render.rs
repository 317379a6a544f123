//! How long a picture takes on one core, without start-up and without writing it anywhere.
//!
//! `cargo bench -p rta` prints wall-clock times; they are quiet only on a quiet machine.

use divan::Bencher;
use rta::engine::{Engine, Format, Settings};
use rta_core::color::Rgb;
use rta_scenes::{dat, shipped};

fn main() {
    divan::main();
}

/// Each shipped scene in each format, 320 x 200 on a 4 : 3 screen, depth 5, one thread.
#[divan::bench(args = [Format::F32, Format::Q16, Format::F64], consts = [0, 1, 2])]
fn picture<const SCENE: usize>(bencher: Bencher, format: Format) {
    let Some((name, text)) = shipped::ALL.get(SCENE) else { return };
    let scene = dat::read(text.as_bytes(), name).expect("a shipped scene");
    let settings = Settings { format, ..Settings::default() };
    let engine = Engine::new(&scene, &settings).expect("a shipped scene fits every format");
    let mut picture = vec![Rgb::default(); 320 * 200];
    bencher.bench_local(|| engine.level_rows(0, 255, &mut picture));
}
