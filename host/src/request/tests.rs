//! Rasters, screens and tables of requests.

use super::Request;
use crate::args::{ShowArgs, TracingArgs};
use crate::picture::error::PictureError;
use crate::request::error::RequestError;

use crate::picture::coloring::{DitherKind, TableKind};
use crate::picture::device::{Device, Target};
use crate::picture::raster::Size;

fn request(target: Target, size: Option<&str>, aspect: Option<&str>) -> Request {
    let size = size.map(|text| text.parse().expect("a size"));
    let aspect = aspect.map(|text| text.parse().expect("an aspect"));
    Request { size, aspect, ..Request::of(&ShowArgs::default().tracing, target) }
}

#[test]
fn rasters_and_screens_follow_the_device() {
    let vga = Target::On(Device::Vga);
    let graphigs = Target::On(Device::Graphigs);
    let cases = [
        (vga, None, None, "320x200", 4.0 / 3.0),
        (vga, Some("160x100"), None, "160x100", 4.0 / 3.0),
        (vga, Some("100x100"), None, "100x100", 5.0 / 6.0),
        (vga, Some("100x100"), Some("2:1"), "100x100", 2.0),
        (graphigs, Some("512x256"), None, "512x256", 2.0),
        (Target::On(Device::Pixrect), None, None, "1152x900", 1.28),
        (Target::None, None, None, "320x200", 4.0 / 3.0),
        (Target::None, Some("320x200"), None, "320x200", 4.0 / 3.0),
        (Target::None, Some("640x400"), None, "640x400", 1.6),
        (Target::None, None, Some("1"), "320x200", 1.0),
    ];
    for (target, size, aspect, want_size, want_aspect) in cases {
        let (got, shape) = request(target, size, aspect).raster().expect("it fits");
        assert_eq!(got.to_string(), want_size);
        assert!((shape - want_aspect).abs() < 1e-12, "{target} {size:?} {aspect:?}: {shape}");
    }
}

#[test]
fn what_does_not_fit_is_refused() {
    let large = request(Target::On(Device::Vga), Some("320x201"), None).raster();
    assert!(matches!(
        large,
        Err(RequestError::Picture(PictureError::LargerThanDevice { device: Device::Vga, .. }))
    ));
    let narrow = request(Target::None, Some("1x101"), None).raster();
    assert!(matches!(narrow, Err(RequestError::Shape { .. })));
    assert_eq!(
        request(Target::None, Some("1x101"), Some("1")).raster().expect("told").0,
        Size::new(1, 101).expect("small")
    );
}

#[test]
fn dithering_follows_the_device_and_the_table() {
    use DitherKind::{Bayer, Fs, None as Plain};
    let cases = [
        (Device::Vga, None, None, TableKind::Sampled, Plain),
        (Device::Graphigs, None, None, TableKind::Sampled, Fs),
        (Device::Pixrect, None, Some(Plain), TableKind::Sampled, Plain),
        (Device::Pixrect, Some(TableKind::Tolerant), None, TableKind::Tolerant, Plain),
        (Device::Vga, Some(TableKind::Uniform), Some(Bayer), TableKind::Uniform, Bayer),
    ];
    for (device, table, dither, want_table, want_dither) in cases {
        let args = TracingArgs { table, dither, ..TracingArgs::default() };
        let coloring = Request::of(&args, Target::On(device)).coloring;
        assert_eq!((coloring.table, coloring.dither), (want_table, want_dither), "{device}");
    }
}
