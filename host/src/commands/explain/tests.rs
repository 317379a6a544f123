use rta_scenes::{dat, shipped};

use super::{explain, worst};
use crate::engine::{Format, Settings};

fn settings(format: Format) -> Settings {
    Settings { width: 80, height: 50, format, ..Settings::default() }
}

#[test]
fn the_worst_pixel_is_worse_than_all_others() {
    let scene = dat::read(shipped::GLASS_2.as_bytes(), "glass-2").expect("a shipped scene");
    let at = settings(Format::Q16);
    let apart = |x, y| {
        let found = explain(&scene, &at, x, y).expect("it fits").expect("in the raster");
        let registers = found.pixel.light.iter().zip(found.truth.light);
        registers.map(|(a, b)| (a.clamp(0.0, 1.0) - b.clamp(0.0, 1.0)).abs()).fold(0.0, f64::max)
    };
    let (x, y) = worst(&scene, &at).expect("it fits");
    let most = apart(x, y);
    assert!(most > 0.0);
    for (x, y) in [(0, 0), (40, 25), (39, 30), (20, 40), (79, 49), (50, 28)] {
        assert!(apart(x, y) <= most, "{x},{y}");
    }
}

#[test]
fn an_explanation_has_its_parts() {
    let scene = dat::read(shipped::GLASS_2.as_bytes(), "glass-2").expect("a shipped scene");
    for format in [Format::F32, Format::Q16, Format::Q20] {
        let found = explain(&scene, &settings(format), 40, 28).expect("it fits").expect("in the raster");
        let text = found.to_string();
        for part in ["of 63 levels", "of 255 levels", "branches:", "primary", "worse by", "core/src/shape"] {
            assert!(text.contains(part), "{part} in\n{text}");
        }
    }
    assert!(explain(&scene, &settings(Format::Q16), 80, 0).expect("it fits").is_none());
}
