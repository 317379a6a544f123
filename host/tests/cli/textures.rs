//! Picture files as textures: what is read, and what is refused and why.

use png::{BitDepth, ColorType, Encoder};

use super::folder::{Folder, decoder};

const SCENE: &str = "\
rta 1
camera at 0 -5 0  to 0 0 0
model flat
texture map image \"map.png\"
material covered diffuse 1  texture map
sphere at 0 0 0  radius 1  of covered
";

/// Returns a PNG.
fn png((width, height): (u32, u32), color: ColorType, depth: BitDepth, data: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, width, height);
    encoder.set_color(color);
    encoder.set_depth(depth);
    if color == ColorType::Indexed {
        encoder.set_palette(&[0, 0, 0, 255, 0, 51][..]);
    }
    encoder.write_header().unwrap().write_image_data(data).unwrap();
    bytes
}

/// Returns the colour in the middle of the picture of the scene.
fn middle(folder: &Folder) -> [u8; 3] {
    middle_with(folder, &[])
}

/// Returns it with further options.
fn middle_with(folder: &Folder, options: &[&str]) -> [u8; 3] {
    let args = ["render", "scene.rta", "-d", "none", "-s", "9x9", "-o", "out.png"];
    let output = folder.rta(&[&args[..], options].concat());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let mut reader = decoder(&folder.path("out.png"));
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut pixels).unwrap();
    let at = 3 * (4 * 9 + 4);
    [pixels[at], pixels[at + 1], pixels[at + 2]]
}

#[test]
fn pictures_of_all_kinds_are_read() {
    let folder = Folder::new();
    folder.scene("scene.rta", SCENE);
    for (kind, depth, data, want) in [
        (ColorType::Rgb, BitDepth::Eight, &[10, 20, 30][..], [10, 20, 30]),
        (ColorType::Rgba, BitDepth::Eight, &[10, 20, 30, 40], [10, 20, 30]),
        (ColorType::Grayscale, BitDepth::Eight, &[77], [77; 3]),
        (ColorType::Grayscale, BitDepth::One, &[0x80], [255; 3]),
        (ColorType::GrayscaleAlpha, BitDepth::Eight, &[77, 3], [77; 3]),
        (ColorType::Indexed, BitDepth::Eight, &[1], [255, 0, 51]),
        (ColorType::Indexed, BitDepth::Two, &[0x40], [255, 0, 51]),
        (ColorType::Rgb, BitDepth::Sixteen, &[10, 10, 20, 20, 30, 30], [10, 20, 30]),
        (ColorType::Grayscale, BitDepth::Sixteen, &[0x80, 0x80], [0x80; 3]),
    ] {
        folder.scene("map.png", png((1, 1), kind, depth, data));
        assert_eq!(middle(&folder), want, "{kind:?} {depth:?}");
    }
    // A picture is what its bytes say, whatever it is called.
    folder.scene("map.png", b"P3 2 1 255  9 8 7  9 8 7");
    assert_eq!(middle(&folder), [9, 8, 7]);
    // One that is larger than what is kept is the mean of its pixels.
    let checks: Vec<u8> = (0..64 * 32).map(|at| if (at + at / 64) % 2 == 0 { 200 } else { 100 }).collect();
    folder.scene("map.png", png((64, 32), ColorType::Grayscale, BitDepth::Eight, &checks));
    folder.scene("scene.rta", SCENE.replace("\"map.png\"", "\"map.png\" nearest"));
    assert_eq!(middle_with(&folder, &["--texels", "2"]), [150; 3]);
    assert_ne!(middle(&folder), [150; 3]);
}

#[test]
fn what_is_no_picture_is_told_with_its_reason() {
    let folder = Folder::new();
    folder.scene("scene.rta", SCENE);
    let refused = |words: &[&str]| {
        let told = [&["scene.rta: the picture of the texture in line 4, map.png: "], words].concat();
        for command in ["render", "bake", "hash"] {
            let args =
                [&[command, "scene.rta"][..], if command == "hash" { &[] } else { &["-o", "out.png"] }];
            folder.refuses(&args.concat(), &told);
        }
        folder.refuses(&["check", "scene.rta"], &told);
    };
    refused(&["No such file"]);
    let whole = png((8, 8), ColorType::Grayscale, BitDepth::Eight, &[99; 64]);
    for length in [0, 1, 8, 20, 40, whole.len() - 20] {
        folder.scene("map.png", &whole[..length]);
        refused(&[]);
    }
    let mut damaged = whole.clone();
    let end = damaged.len() - 20;
    damaged[end] ^= 0x55;
    folder.scene("map.png", &damaged);
    refused(&[]);
    folder.scene("map.png", "rta 1\n");
    refused(&[]);
    // Only its head says that it is huge: nothing of that size is made.
    let mut huge = whole;
    huge[16..24].copy_from_slice(&[0, 0, 0xea, 0x60, 0, 0, 0xea, 0x60]);
    let sum = crc(&huge[12..29]);
    huge[29..33].copy_from_slice(&sum.to_be_bytes());
    folder.scene("map.png", &huge);
    refused(&["60000 x 60000 pixels, more than 8192 on a side"]);
    // The sky's is told apart.
    folder.scene("scene.rta", "rta 1\ncamera at 0 -5 0  to 0 0 0\nsky map \"none.png\"\n");
    folder.refuses(&["check", "scene.rta"], &["scene.rta: the picture of the sky, none.png: "]);
    // It stays where it is when the scene is converted.
    assert!(folder.rta(&["convert", "scene.rta", "-o", "other.rta"]).status.success());
}

/// Returns the checksum of a chunk of a PNG (ISO 3309).
fn crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |sum, byte| {
        (0..8).fold(sum ^ u32::from(*byte), |sum, _| sum >> 1 ^ if sum & 1 == 1 { 0xedb8_8320 } else { 0 })
    })
}
