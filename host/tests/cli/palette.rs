//! `rta palette`, `rta difference` and `rta compare` from outside.

use std::fs;
use std::process::{Command, Stdio};

use super::folder::{Folder, decoder};

const SMALL: [&str; 4] = ["palette", "scene.dat", "--size", "32x20"];

/// The cells of each row of the tables that `rta palette` prints.
fn rows(folder: &Folder, args: &[&str]) -> Vec<Vec<String>> {
    let text = folder.prints(&[&SMALL, args].concat());
    let rows = text.lines().filter(|line| line.starts_with('|') && !line.contains("-: |"));
    let cells = |line: &str| line.split('|').map(|cell| cell.trim().to_owned()).collect::<Vec<_>>();
    rows.map(|line| cells(line)[1..10].to_vec()).collect()
}

fn flip(folder: &Folder, args: &[&str]) -> String {
    let told = folder.prints(&[&["difference", "reference.png", "test.png"], args].concat());
    told.split_whitespace().nth(1).unwrap().to_owned()
}

#[test]
fn every_table_is_there_with_every_dithering_on_every_device() {
    let folder = Folder::new();
    let rows = rows(&folder, &["--no-instructions"]);
    assert_eq!(rows.len(), 3 * (1 + 6 * 4));
    for (device, (name, dither)) in rows.chunks(25).zip([("13", "none"), ("38", "fs"), ("35", "fs")]) {
        assert_eq!(device[0][3], format!("FLIP at {name}"));
        let combinations: std::collections::BTreeSet<_> = device[1..].iter().map(|row| &row[1..3]).collect();
        assert_eq!(combinations.len(), 24);
        let default: Vec<_> = device.iter().filter(|row| row[0] == "*").map(|row| &row[1..3]).collect();
        assert_eq!(default, [["sampled", dither]]);
        assert!(device[1..].iter().all(|row| row[7].is_empty() && row[8].parse::<u32>().is_ok()));
    }
}

#[test]
fn a_row_is_the_difference_of_the_files_that_render_writes() {
    let folder = Folder::new();
    for (device, aspect, table, dither) in [
        ("vga", "4:3", "uniform", "fs"),
        ("graphigs", "32:20", "sampled", "none"),
        ("pixrect", "32:20", "frame", "bayer"),
    ] {
        let rows = rows(&folder, &["--no-instructions", "-d", device, "--samples", "4"]);
        let row = rows.iter().find(|row| row[1..3] == [table, dither]).unwrap();
        let raster = ["scene.dat", "--size", "32x20", "--samples", "4", "--aspect", aspect];
        folder.renders(&[&raster[..], &["-o", "reference.png", "-d", "none"]].concat());
        let options = ["-o", "test.png", "-d", device, "--table", table, "--dither", dither];
        folder.renders(&[&raster[..], &options].concat());
        assert_eq!(flip(&folder, &["-p", rows[0][3].strip_prefix("FLIP at ").unwrap()]), row[3], "{device}");
        assert_eq!(flip(&folder, &[]), row[4], "{device}");
        assert!(row[3].parse::<f64>().unwrap() > 0.001, "{row:?}");
    }
}

#[test]
fn instructions_are_counted_where_valgrind_is() {
    let folder = Folder::new();
    let valgrind = Command::new("valgrind").arg("--version").stdout(Stdio::null()).status();
    if valgrind.is_ok_and(|status| status.success()) {
        for row in &rows(&folder, &["-d", "vga"])[1..] {
            assert!((20..20_000).contains(&row[7].parse::<u32>().unwrap()), "{row:?}");
        }
    } else {
        let told = folder.rta(&[&SMALL[..], &["-d", "vga"]].concat());
        assert!(told.status.success());
        assert!(String::from_utf8(told.stderr).unwrap().starts_with("rta: no instructions: "));
    }
}

#[test]
fn the_sheet_begins_with_the_picture_without_a_device() {
    let folder = Folder::new();
    rows(&folder, &["--no-instructions", "-d", "vga", "--sheet", "sheet.png"]);
    let mut reader = decoder(&folder.path("sheet.png"));
    let mut sheet = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut sheet).unwrap();
    let (width, height) = (reader.info().width as usize, reader.info().height as usize);
    // Five pictures of 32x20 pixels, each ten times as wide and twelve times as high, and gaps of 4 columns; six rows of them, each
    // with a line of text, and a title.
    assert_eq!(width, 5 * 324);
    let lines = height - 6 * 240;
    assert!((7 * 12..7 * 50).contains(&lines), "{lines} rows of text");
    folder.renders(&["scene.dat", "-o", "a.ppm", "-d", "none", "-s", "32x20", "--aspect", "4:3"]);
    let pixels = fs::read(folder.path("a.ppm")).unwrap().split_off("P6\n32 20\n255\n".len());
    let line = |y: usize| &sheet[3 * y * width..][..3 * 320];
    let enlarged = |y: usize| {
        let row = pixels[3 * 32 * y..][..3 * 32].chunks(3);
        row.flat_map(|pixel| pixel.repeat(10)).collect::<Vec<_>>()
    };
    let title = (0..100).find(|&y| line(y) == enlarged(0)).expect("the first row of the picture");
    for y in 0..20 {
        assert_eq!(line(title + 12 * y + 5), enlarged(y), "row {y}");
    }
}

#[test]
fn what_palette_cannot_do_is_refused() {
    let folder = Folder::new();
    folder.refuses(&["palette", "scene.dat", "--table", "uniform"], &["every colour table"]);
    folder.refuses(&["palette", "scene.dat", "--dither", "fs"], &["every colour table"]);
    folder.refuses(&["palette", "scene.dat", "-s", "320x201"], &["320x201 does not fit vga"]);
    folder.refuses(&["palette", "missing.dat"], &["missing.dat"]);
    folder.refuses(&["palette", "scene.dat", "--sheet", "-"], &["--sheet"]);
    folder.refuses(&["palette", "scene.dat", "--sheet", "a.pfm"], &["PFM holds linear light"]);
    folder.refuses(&["palette", "scene.dat", "--sheet", "a.txt"], &["a.txt", "no known picture format"]);
    folder.refuses(&["palette", "scene.dat", "--sheet", "none/a.png"], &["none/a.png"]);
    fs::rename(folder.path("scene.dat"), folder.path("scene.png")).unwrap();
    folder.refuses(&["palette", "scene.png", "--sheet", "scene.png"], &["the output is the input itself"]);
}

#[test]
fn what_cannot_be_compared_is_refused() {
    let folder = Folder::new();
    folder.renders(&["scene.dat", "-o", "a.png", "-s", "20x20"]);
    folder.renders(&["scene.dat", "-o", "b.png", "-s", "20x10"]);
    folder.refuses(&["difference", "a.png", "b.png"], &["a.png is 20x20", "b.png is 20x10"]);
    folder.refuses(&["difference", "a.png", "none.png"], &["cannot read the picture none.png"]);
    folder.refuses(&["difference", "scene.dat", "a.png"], &["cannot read the picture scene.dat"]);
    for pixels in ["0", "-1", "nan", "1001", "many"] {
        folder.refuses(
            &["difference", "a.png", "a.png", &format!("--pixels-per-degree={pixels}")],
            &["pixels per degree"],
        );
    }
    let png = fs::read(folder.path("a.png")).unwrap();
    folder.scene("half.png", &png[..png.len() / 2]);
    folder.refuses(&["difference", "a.png", "half.png"], &["half.png"]);
    let mut encoder = png::Encoder::new(fs::File::create(folder.path("clear.png")).unwrap(), 1, 1);
    encoder.set_color(png::ColorType::Rgba);
    encoder.write_header().unwrap().write_image_data(&[1, 2, 3, 254]).unwrap();
    folder.refuses(&["difference", "clear.png", "a.png"], &["clear.png", "transparent"]);
}

#[test]
fn equal_pictures_have_no_difference_whatever_their_kind() {
    let folder = Folder::new();
    folder.renders(&["scene.dat", "-o", "reference.png", "-s", "20x20"]);
    let mut reader = decoder(&folder.path("reference.png"));
    let palette = reader.info().palette.clone().unwrap();
    let mut indices = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut indices).unwrap();
    // The indexed picture without its table, with 16 bits a register.
    let wide: Vec<u8> = indices
        .iter()
        .flat_map(|&index| palette[3 * usize::from(index)..][..3].iter().flat_map(|&code| [code, 7]))
        .collect();
    let mut encoder = png::Encoder::new(fs::File::create(folder.path("test.png")).unwrap(), 20, 20);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Sixteen);
    encoder.write_header().unwrap().write_image_data(&wide).unwrap();
    assert_eq!(
        folder.prints(&["difference", "reference.png", "test.png"]),
        "FLIP      0.0000  at 67 pixels a degree\nS-CIELAB  0.000\nPSNR      equal\n"
    );
}

#[test]
fn scenes_are_compared_on_several_displays() {
    let folder = Folder::new();
    let sheet = |scenes: &[&str], devices: &str| {
        let args = ["-o", "sheet.png", "--size", "64x40", "--devices", devices];
        assert_eq!(folder.prints(&[&["compare"], scenes, &args].concat()), "");
        let mut reader = decoder(&folder.path("sheet.png"));
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        assert_eq!(reader.info().width, 2 * (320 + 4));
        pixels
    };
    let halves = |sheet: &[u8], half: usize| {
        let lines = sheet.chunks_exact(648 * 3).skip(60).take(200);
        lines.flat_map(|line| line[half * 324 * 3..][..320 * 3].to_vec()).collect::<Vec<_>>()
    };
    let (same, other) = (sheet(&["scene.dat"], "none,none"), sheet(&["scene.dat"], "none,vga"));
    assert!(halves(&same, 0) == halves(&same, 1) && halves(&same, 0) == halves(&other, 0));
    assert!(halves(&other, 0) != halves(&other, 1), "a VGA has fewer colours");
    assert!(sheet(&["scene.dat", "scene.dat"], "none,vga") == other.repeat(2));
    folder.refuses(
        &["compare", "scene.dat", "-o", "a.png", "--models", "rta", "--devices", "vga"],
        &["--models"],
    );
    folder.refuses(&["compare", "-o", "a.png"], &["SCENES"]);
    folder.refuses(&["compare", "scene.dat", "-o", "a.png", "--devices", "vga,cga"], &["cga"]);
}
