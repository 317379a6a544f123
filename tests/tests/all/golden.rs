//! The shipped scenes on the three devices, byte for byte, and the float formats beside them.
//!
//! `RTA_BLESS=1 cargo test -p rta-tests --test all golden` records the pictures that are drawn now as the golden ones.

use rta::device::Device;
use rta::engine::Format;
use rta_core::color::Rgb;
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
