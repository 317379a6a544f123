//! The shipped scenes on the three devices, byte for byte, and the float formats beside them.
//!
//! `RTA_BLESS=1 cargo test -p rta-tests --test all golden` records the pictures that are drawn now as the golden ones.

use core::sync::atomic::AtomicBool;

use rta::coloring::{Coloring, DitherKind, TableKind};
use rta::device::Device;
use rta::engine::{Format, Model};
use rta::raster::Size;
use rta::render::Work;
use rta::request::Request;
use rta_core::color::Rgb;
use rta_golden::{Render, Screen, Table};
use rta_tests::golden::{check, draw, request, scene};
use rta_tests::picture::share_within;

/// On the two large screens, one row of so many is compared between the formats.
const STRIDE: u32 = 9;

/// Differences of linear light between floats and fixed point, clamped to what a display shows, each with the least
/// share of pixels in a hundred that is within it: a level of the VGA's guns, and one of the PIXRECT's. The other
/// pixels are edges, where a rounding decides which object is hit.
const TOLERANCES: [(f64, f64); 2] = [(1.0 / 63.0, 99.8), (1.0 / 255.0, 99.5)];

fn golden(name: &str, device: Device) {
    check(&format!("{name}-{device}"), &draw(name, device).expect("it is drawn"));
}

/// Returns some rows of the picture that a device is sent, in linear light.
fn linear(name: &str, device: Device, format: Format) -> Vec<[f64; 3]> {
    let engine = request(device, format).engine(&scene(name)).expect("it is drawn");
    let (width, height) = (engine.settings().width, engine.settings().height);
    let stride = if device == Device::Vga { 1 } else { STRIDE };
    let mut row = vec![Rgb::default(); width as usize];
    let mut pixels = Vec::new();
    for y in (0..height).step_by(stride as usize) {
        engine.linear_rows(y, &mut row);
        pixels.extend(row.iter().map(|p| [p.r, p.g, p.b].map(f64::from)));
    }
    pixels
}

fn floats_are_near(name: &str, device: Device) {
    let fixed = linear(name, device, Format::Q16);
    for format in [Format::F32, Format::F64] {
        let float = linear(name, device, format);
        for (tolerance, least) in TOLERANCES {
            let share = share_within(&fixed, &float, tolerance);
            println!("{name} {device} {format}: {share:.3} % within {tolerance:.4}");
            assert!(
                share >= least,
                "{name} on {device}: {share} % of q16 and {format} within {tolerance}, at least {least} % must be"
            );
        }
    }
}

/// The crate for the tests of others draws by one ray after another and searches as firmware does; the program, by packets and
/// threads.
#[test]
fn a_picture_of_rta_golden_has_the_hash_that_the_program_prints() {
    let screens = [
        (Device::Vga, Screen::VGA),
        (Device::Graphigs, Screen::GRAPHIGS),
        (Device::Pixrect, Screen::PIXRECT),
    ];
    let plain = |table| Coloring { table, dither: DitherKind::None, samples: 0 };
    let tables = |device| {
        [
            (Coloring::of(device), Table::Sampled),
            (plain(TableKind::Adaptive), Table::Adaptive),
            (plain(TableKind::Tolerant), Table::Tolerant),
            (plain(TableKind::Uniform), Table::Uniform),
        ]
    };
    for name in ["juggler", "hall-22", "glass-2"] {
        let on_all = screens.into_iter().flat_map(|screen| tables(screen.0).map(|table| (screen, table)));
        for ((device, screen), (coloring, table)) in on_all {
            for (format, model, depth) in [(Format::Q16, Model::Rta, 5), (Format::Q20, Model::Whitted, 2)] {
                let size = Some(Size::new(96, 40).expect("a size"));
                let asked = Request { coloring, size, model, depth, ..request(device, format) };
                let (scene, stop) = (scene(name), AtomicBool::new(false));
                let work = Work::new(&asked, &scene, Some(2), &stop).expect("it is drawn");
                let program = work.quiet(true).checksum(device).expect("nothing stops it");
                let screen = screen.window(96, 40).with(table);
                let render = Render { screen, format, model: Some(model), depth };
                let picture = render.scene(&scene.description).expect("it is drawn");
                assert_eq!(picture.hash(), program, "{name} {device} {coloring} {format} {model}");
            }
        }
    }
}

macro_rules! pictures {
    ($($test:ident: $scene:literal on $device:ident;)*) => {$(
        mod $test {
            use rta::device::Device;

            #[test]
            fn is_golden() {
                super::golden($scene, Device::$device);
            }

            #[test]
            fn is_near_in_floats() {
                super::floats_are_near($scene, Device::$device);
            }
        }
    )*};
}

pictures! {
    juggler_vga: "juggler" on Vga;
    juggler_graphigs: "juggler" on Graphigs;
    juggler_pixrect: "juggler" on Pixrect;
    hall_22_vga: "hall-22" on Vga;
    hall_22_graphigs: "hall-22" on Graphigs;
    hall_22_pixrect: "hall-22" on Pixrect;
    glass_2_vga: "glass-2" on Vga;
    glass_2_graphigs: "glass-2" on Graphigs;
    glass_2_pixrect: "glass-2" on Pixrect;
}
