//! What firmware needs of the program: `rta bake` and `rta hash`.

use std::collections::BTreeSet;
use std::fs;

use super::folder::{Folder, decoder, spoilt};

#[test]
fn a_scene_is_baked_into_a_file_or_a_pipe() {
    let folder = Folder::new();
    folder.prints(&["bake", "scene.dat", "-o", "scene.rs"]);
    let file = fs::read_to_string(folder.path("scene.rs")).unwrap();
    let piped = folder.prints(&["bake", "scene.dat", "-o", "-"]);
    assert!(file == piped);
    for words in ["pub type Number = ::rta_core::Q16;", "const ELLIPSOIDS: bool = true;", "pub const SCENE: "]
    {
        assert!(file.contains(words), "{words}");
    }
    for (option, value, words) in [
        ("--format", "f32", "pub type Number = f32;"),
        ("--model", "whitted", "const ATTENUATION: bool = false;"),
        ("--aspect", "2:1", "the shape 2.0000 : 1"),
    ] {
        let source = folder.prints(&["bake", "scene.dat", "-o", "-", option, value]);
        assert!(source.contains(words) && !file.contains(words), "{option} {value}");
    }
    assert_eq!(folder.names(), ["scene.dat", "scene.rs"]);
}

#[test]
fn a_palette_is_baked_as_the_table_of_the_picture() {
    let folder = Folder::new();
    let options = ["--format", "q16", "--size", "64x48"];
    folder.prints(&[&["bake", "scene.dat", "-o", "scene.rs", "--palette", "vga"], &options[..]].concat());
    folder.renders(
        &[&["scene.dat", "-o", "out.png", "--table", "baked", "--aspect", "4:3"], &options[..]].concat(),
    );
    let reader = decoder(&folder.path("out.png"));
    let table = reader.info().palette.as_deref().unwrap();
    let source = fs::read_to_string(folder.path("scene.rs")).unwrap();
    let (_, source) = source.split_once("pub static PALETTE").unwrap();
    let levels = source.lines().filter_map(|line| line.trim().strip_prefix("Rgb::new(")?.strip_suffix("),"));
    let bytes = levels.flat_map(|entry| entry.split(", ").map(|level| level.parse::<u32>().unwrap()));
    // 6 bits a gun, expanded to 8.
    let bytes: Vec<_> = bytes.map(|level| ((2 * 255 * level + 63) / 126).to_le_bytes()[0]).collect();
    assert!(bytes.len() > 3 * 100, "{}", bytes.len());
    assert_eq!(bytes, table);
    folder.refuses(&["bake", "scene.dat", "-o", "a.rs", "--size", "64x48"], &["--palette"]);
    // A scene that does not fit is scaled once, and told once.
    folder.scene("far.nff", "v\nfrom 0 -90001 0\nat 0 0 0\nup 0 0 1\nangle 40\nhither 1\nresolution 64 48\nl 9 -90001 5\ns 0 0 0 20000\n");
    let baked =
        folder.rta(&["bake", "far.nff", "-o", "far.rs", "--fit", "--palette", "vga", "--size", "64x48"]);
    let told = String::from_utf8(baked.stderr).unwrap();
    assert!(baked.status.success() && told.matches("is scaled by").count() == 1, "{told}");
    folder.refuses(
        &["bake", "scene.dat", "-o", "a.rs", "--palette", "vga", "--size", "321x2"],
        &["321x2", "vga"],
    );
}

#[test]
fn what_cannot_be_baked_leaves_nothing_behind() {
    let folder = Folder::new();
    let bake = ["bake", "far.dat", "-o", "far.rs"];
    folder.scene("far.dat", spoilt("0 0 1   1 1 1   1   2", "0 90000 1   1 1 1   1   2"));
    folder.refuses(&bake, &["far.dat", "q16", "sphere 1", "90001", "it fits f32"]);
    // Too far for the fine format only.
    folder.scene("far.dat", spoilt("0 0 1   1 1 1   1   2", "0 3000 1   1 1 1   1   2"));
    folder.refuses(&[&bake[..], &["--format", "q20"]].concat(), &["far.dat", "q20", "it fits q16, f32"]);
    // What was baked before stays.
    folder.scene("far.rs", "precious");
    folder.refuses(&[&bake[..], &["--format", "q20"]].concat(), &["far.dat", "sphere 1"]);
    assert_eq!(fs::read(folder.path("far.rs")).unwrap(), b"precious");
    folder.scene("far.dat", "0 0");
    folder.refuses(&bake, &["far.dat", "end of file"]);
    folder.refuses(&["bake", "scene.dat"], &["--output"]);
    folder.refuses(&["bake", "scene.dat", "-o", "missing/scene.rs"], &["missing/scene.rs", "No such file"]);
    folder.refuses(&["bake", "missing.dat", "-o", "scene.rs"], &["missing.dat", "No such file"]);
}

#[test]
fn a_hash_tells_pictures_apart_and_nothing_else() {
    let folder = Folder::new();
    let hash = |options: &[&str]| {
        let line = folder.prints(&[&["hash", "scene.dat", "--size", "64x40"], options].concat());
        let (number, what) = line.split_once("  ").unwrap();
        assert!(number.len() == 16 && number.bytes().all(|digit| digit.is_ascii_hexdigit()), "{line}");
        assert!(what.starts_with("scene, 64x40, device ") && line.lines().count() == 1, "{line}");
        // In the format in which all machines agree, unless another is asked for.
        let format = if options.contains(&"f32") { "format f32," } else { "format q16," };
        assert!(what.contains(format), "{line}");
        number.to_owned()
    };
    let one = hash(&["--threads", "1"]);
    assert_eq!(one, hash(&["--format", "q16"]));
    hash(&["--format", "f32"]);
    assert_eq!(one, hash(&["--threads", "3"]));
    let others = [
        hash(&["--device", "pixrect"]),
        hash(&["--table", "uniform"]),
        hash(&["--table", "adaptive"]),
        hash(&["--table-samples", "1000"]),
        hash(&["--dither", "fs"]),
        hash(&["--model", "whitted"]),
        hash(&["--depth", "0"]),
    ];
    folder.scene("scene.dat", spoilt("4 -8 6", "4 -8 7"));
    let all: BTreeSet<_> = others.into_iter().chain([one, hash(&[])]).collect();
    assert_eq!(all.len(), 9);
    assert_eq!(folder.names(), ["scene.dat"]);
    folder.refuses(&["hash", "scene.dat", "--device", "cga"], &["--device", "graphigs"]);
    folder.refuses(&["hash", "scene.dat", "--device", "none"], &["--device", "none"]);
    folder.refuses(&["hash", "scene.dat", "--size", "321x200"], &["321x200", "vga"]);
    folder.refuses(&["hash"], &["SCENE"]);
}

#[test]
fn a_hash_is_that_of_what_the_display_was_sent() {
    // FNV-1a of the picture's indices and of the sum of its colours, both read from the picture itself.
    let folder = Folder::new();
    let fnv = |bytes: &mut dyn Iterator<Item = u8>, start: u64| {
        bytes.fold(start, |sum, byte| (sum ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
    };
    let options = ["--format", "q16", "--device", "pixrect", "--size", "96x75"];
    folder.renders(&[&["scene.dat", "-o", "out.png"], &options[..]].concat());
    let mut reader = decoder(&folder.path("out.png"));
    let mut indices = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut indices).unwrap();
    // A gun of 8 bits shows its levels as they are.
    let colors = reader.info().palette.as_deref().unwrap().to_vec();
    let start = 0xcbf2_9ce4_8422_2325;
    let colors = fnv(&mut colors.into_iter(), start);
    let want = fnv(&mut indices.into_iter().chain(colors.to_le_bytes()), start);
    let line = folder.prints(&[&["hash", "scene.dat"], &options[..]].concat());
    assert!(line.starts_with(&format!("{want:016x}  ")), "{want:016x}, {line}");
}
