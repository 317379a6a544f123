//! What comes out of `rta render`, and of `rta show` where there is no display.

use std::fs;

use super::folder::{Folder, decoder};

#[test]
fn a_device_gives_an_indexed_png_with_its_own_colours() {
    let folder = Folder::new();
    for (device, width, height, colors, guns, shape) in [
        ("vga", 320, 200, 256, 63, Some((6, 5))),
        ("graphigs", 1024, 1024, 128, 15, None),
        ("pixrect", 1152, 900, 256, 255, None),
    ] {
        for table in ["adaptive", "tolerant", "uniform"] {
            let path = folder.path("out.png");
            folder.renders(&["scene.dat", "-o", "out.png", "--device", device, "--table", table]);
            let mut reader = decoder(&path);
            let mut indices = vec![0; reader.output_buffer_size().unwrap()];
            reader.next_frame(&mut indices).unwrap();
            let info = reader.info();
            assert_eq!((info.width, info.height, info.color_type), (width, height, png::ColorType::Indexed));
            let palette = info.palette.as_deref().unwrap();
            assert!(palette.len() <= colors * 3 && palette.len() > 30, "{device} {table}: {}", palette.len());
            let entries = palette.len() / 3;
            assert!(indices.iter().all(|index| usize::from(*index) < entries));
            // Only what the guns can do: multiples of 255 / guns, rounded.
            let levels: Vec<u32> = (0..=guns).map(|level| (level * 255 + guns / 2) / guns).collect();
            assert!(palette.iter().all(|part| levels.contains(&u32::from(*part))), "{device} {table}");
            assert_eq!(info.pixel_dims.map(|dims| (dims.xppu, dims.yppu)), shape);
        }
    }
}

#[test]
fn every_kind_of_picture_says_the_same() {
    let folder = Folder::new();
    for options in [&["--device", "vga"][..], &["--device", "none"]] {
        folder.renders(&[&["scene.dat", "-o", "out.png"], options].concat());
        let ppm = folder.renders(&[&["scene.dat", "-o", "-", "--as", "ppm"], options].concat());
        let header = b"P6\n320 200\n255\n";
        assert!(ppm.starts_with(header));
        let mut reader = decoder(&folder.path("out.png"));
        let mut data = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut data).unwrap();
        if let Some(palette) = reader.info().palette.as_deref() {
            data = data.iter().flat_map(|index| palette[usize::from(*index) * 3..][..3].to_vec()).collect();
        }
        assert!(ppm[header.len()..] == data, "{options:?}");
    }
    let pfm = folder.renders(&["scene.dat", "-o", "-", "--as", "pfm", "--device", "none", "--format", "f64"]);
    let ppm = folder.renders(&["scene.dat", "-o", "-", "--as", "ppm", "--device", "none", "--format", "f64"]);
    let numbers = pfm.strip_prefix(b"PF\n320 200\n-1.0\n").unwrap();
    assert_eq!(numbers.len(), 320 * 200 * 12);
    let levels = &ppm[15..];
    for (place, bytes) in numbers.chunks_exact(4).enumerate() {
        let light = f32::from_le_bytes(bytes.try_into().unwrap());
        let (row, rest) = (place / 960, place % 960);
        let level = f32::from(levels[(199 - row) * 960 + rest]);
        assert!((light.clamp(0.0, 1.0) * 255.0 - level).abs() < 0.501, "{place}: {light} {level}");
    }
}

#[test]
fn bytes_do_not_depend_on_threads() {
    let folder = Folder::new();
    for options in [
        &["--format", "q16", "--as", "png", "--device", "graphigs", "--size", "300x200"][..],
        &["--format", "f32", "--as", "pfm", "--device", "none", "--size", "333x77"],
    ] {
        let with =
            |threads| folder.renders(&[&["scene.dat", "-o", "-", "--threads", threads], options].concat());
        let one = with("1");
        assert!(one == with("2") && one == with("13"), "{options:?}");
    }
}

#[test]
fn without_a_display_the_picture_is_a_file_in_the_folder() {
    let folder = Folder::new();
    let juggler = String::from_utf8(folder.rta(&[]).stdout).unwrap();
    assert!(juggler.contains("./rta-juggler-vga.png") && juggler.lines().count() == 1, "{juggler}");
    let again = folder.rta(&["show", "--device", "vga"]);
    assert_eq!(again.status.code(), Some(0));
    let shown = folder.rta(&["show", "scene.dat", "--device", "graphigs", "--size", "64x64"]);
    assert!(String::from_utf8(shown.stdout).unwrap().contains("./rta-scene-graphigs.png"));
    assert_eq!(
        folder.names(),
        ["rta-juggler-vga-2.png", "rta-juggler-vga.png", "rta-scene-graphigs.png", "scene.dat"]
    );
    let read = |name| fs::read(folder.path(name)).unwrap();
    assert!(read("rta-juggler-vga.png") == read("rta-juggler-vga-2.png"));
    let no_such_display = folder.command(&["show"]).env("DISPLAY", ":9999").output().unwrap();
    assert!(no_such_display.status.success());
    assert!(folder.path("rta-juggler-vga-3.png").exists());
}
