//! Comparison with golden pictures: what is equal, what the errors say, and what they leave behind.

use std::fs::{self, File};
use std::io::BufReader;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use rta_golden::{BLESS, DrawError, Mismatch, Picture, Rgb};

const BLACK: Rgb<u8> = Rgb::new(0, 0, 0);
const RED: Rgb<u8> = Rgb::new(63, 0, 0);
const DIM: Rgb<u8> = Rgb::new(62, 0, 0);

/// Returns a picture of 3 x 2 pixels.
fn picture(colors: &[Rgb<u8>], indices: [u8; 6]) -> Picture {
    Picture::indexed((3, 2), 63, colors, indices).expect("a picture")
}

/// Returns the path of a file that is not there, in a folder that is not there.
fn fresh(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    if folder.exists() {
        fs::remove_dir_all(&folder).expect("an old folder");
    }
    folder.join("golden.png")
}

/// Writes a PNG of 3 x 2 pixels.
fn golden(name: &str, color: png::ColorType, palette: Option<&[u8]>, data: &[u8]) -> PathBuf {
    let path = fresh(name);
    fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
    let mut encoder = png::Encoder::new(File::create(&path).expect("a file"), 3, 2);
    encoder.set_color(color);
    if let Some(palette) = palette {
        encoder.set_palette(palette.to_vec());
    }
    encoder.write_header().expect("a header").write_image_data(data).expect("pixels");
    path
}

/// Returns the kind, the size and the registers of a PNG in RGB, or its indices.
fn decoded(path: &Path) -> (png::ColorType, (u32, u32), Vec<u8>) {
    let file = File::open(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut reader = png::Decoder::new(BufReader::new(file)).read_info().expect("a PNG");
    let mut data = vec![0; reader.output_buffer_size().expect("few pixels")];
    let info = reader.next_frame(&mut data).expect("pixels");
    (info.color_type, (info.width, info.height), data)
}

/// Compares a picture with a golden one and returns the error, which prints alike with `{}` and `{:?}`.
fn refused(picture: &Picture, golden: &Path) -> (Mismatch, String) {
    let error = picture.is_golden(golden).expect_err("they differ");
    let text = error.to_string();
    assert_eq!(text, format!("{error:?}"));
    assert!(
        text.contains(&golden.display().to_string()) && text.contains("RTA_BLESS=1 cargo test"),
        "{text}"
    );
    (error, text)
}

#[test]
fn what_looks_alike_is_equal_however_it_is_encoded() {
    let drawn = picture(&[BLACK, RED], [0, 1, 0, 1, 1, 0]);
    let rgb = [[0, 0, 0], [255, 0, 0], [0, 0, 0], [255, 0, 0], [255, 0, 0], [0, 0, 0]].concat();
    let rgba: Vec<u8> = rgb.chunks(3).flat_map(|color| [color, &[7]].concat()).collect();
    // An entry that is not used, and the others in another order.
    let palette = [[9, 9, 9], [255, 0, 0], [0, 0, 0]].concat();
    drawn.is_golden(golden("rgb", png::ColorType::Rgb, None, &rgb)).unwrap();
    drawn.is_golden(golden("rgba", png::ColorType::Rgba, None, &rgba)).unwrap();
    drawn.is_golden(golden("indexed", png::ColorType::Indexed, Some(&palette), &[2, 1, 2, 1, 1, 2])).unwrap();
    let grey = picture(&[BLACK, Rgb::new(63, 63, 63)], [0, 1, 0, 1, 1, 0]);
    grey.is_golden(golden("grey", png::ColorType::Grayscale, None, &[0, 255, 0, 255, 255, 0])).unwrap();
}

#[test]
fn a_difference_is_told_and_shown() {
    let path = golden("differs", png::ColorType::Indexed, Some(&[0, 0, 0, 255, 0, 0]), &[0, 1, 0, 1, 1, 0]);
    let drawn = picture(&[BLACK, RED, DIM], [0, 2, 0, 1, 1, 1]);
    let (error, text) = refused(&drawn, &path);
    let Mismatch::Pixels(difference) = &error else { panic!("{text}") };
    assert!(
        text.contains(
            "2 of 6 pixels differ, by up to 255 of 255 in a gun\n  first:      column 1 of row 0, #fb0000 was drawn, #ff0000 is golden"
        ),
        "{text}"
    );
    assert_eq!((difference.differing, difference.pixels, difference.largest), (2, 6, 255));
    assert_eq!((difference.x, difference.y), (1, 0));
    // The files lie in the folder of the build, not beside the golden picture.
    let (shown, apart) = (&difference.kept.drawn, difference.kept.difference.as_ref().expect("one size"));
    let build = Path::new(env!("CARGO_TARGET_TMPDIR")).parent().expect("the folder of the build");
    for (file, end) in [(shown, "differs/golden.png"), (apart, "differs/golden-difference.png")] {
        assert!(
            file.starts_with(build.join("golden/rta-golden")) && file.ends_with(end),
            "{}",
            file.display()
        );
        assert!(text.contains(&file.display().to_string()), "{text}");
    }
    assert_eq!(decoded(shown), (png::ColorType::Indexed, (3, 2), vec![0, 2, 0, 1, 1, 1]));
    // 4 of 255 are made visible, at column 1 of row 0; all of red is at column 2 of row 1.
    let red = [0, 64, 0, 0, 0, 255];
    let seen = red.into_iter().flat_map(|level| [level, 0, 0]).collect();
    assert_eq!(decoded(apart), (png::ColorType::Rgb, (3, 2), seen));
    // The golden picture is as it was.
    assert_eq!(decoded(&path).2, [0, 1, 0, 1, 1, 0]);
    let (_, text) = refused(&picture(&[BLACK, RED, DIM], [0, 1, 0, 1, 1, 2]), &path);
    assert!(
        text.contains("1 of 6 pixels differs, by 251 of 255 in a gun\n  first:      column 2 of row 1"),
        "{text}"
    );
}

#[test]
fn a_golden_picture_that_is_missing_of_another_size_or_none_is_an_error() {
    let drawn = picture(&[BLACK, RED], [0, 1, 0, 1, 1, 0]);
    let path = fresh("missing");
    let (error, text) = refused(&drawn, &path);
    let Mismatch::Missing { kept, .. } = &error else { panic!("{text}") };
    assert!(text.contains("is not there yet\n  drawn: ") && !path.exists(), "{text}");
    assert_eq!(decoded(&kept.drawn).2, [0, 1, 0, 1, 1, 0]);

    let path = golden("size", png::ColorType::Grayscale, None, &[0; 6]);
    let high = Picture::direct((2, 3), 255, [BLACK; 6]).expect("a picture");
    let (error, text) = refused(&high, &path);
    let Mismatch::Size { kept, .. } = &error else { panic!("{text}") };
    assert!(text.contains("has 3 x 2 pixels, the picture drawn 2 x 3"), "{text}");
    assert_eq!((decoded(&kept.drawn).1, &kept.difference), ((2, 3), &None));

    let path = fresh("broken");
    fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
    fs::write(&path, "GIF89a").expect("a file");
    let (error, text) = refused(&drawn, &path);
    assert!(matches!(error, Mismatch::Unreadable { .. }) && text.contains("cannot be read: "), "{text}");
    assert_eq!(fs::read(&path).expect("it is there"), b"GIF89a");
}

#[test]
fn another_hash_is_told_as_source() {
    let drawn = picture(&[BLACK, RED], [0, 1, 0, 1, 1, 0]);
    drawn.has_hash(drawn.hash()).unwrap();
    let text = drawn.has_hash(0xab).expect_err("another hash").to_string();
    assert!(text.ends_with(", not 0x0000_0000_0000_00ab"), "{text}");
    let told =
        text.trim_start_matches("the hash of the picture drawn is 0x").split(',').next().expect("a number");
    assert_eq!(u64::from_str_radix(&told.replace('_', ""), 16), Ok(drawn.hash()));
    let test = || -> Result<(), Mismatch> { Picture::direct((1, 1), 1, [])?.has_hash(0) };
    assert!(matches!(test(), Err(Mismatch::NotDrawn(DrawError::Pixels { .. }))));
}

/// Compares with the golden picture that `GOLDEN` names; run by the test below, which sets the variables.
#[test]
#[ignore = "run by is_blessed_by_the_variable"]
fn compares() {
    let path = std::env::var_os("GOLDEN").expect("set by the other test");
    picture(&[BLACK, RED], [0, 1, 0, 1, 1, 0]).is_golden(path).unwrap();
}

#[test]
fn is_blessed_by_the_variable() {
    let compares = |path: &Path, bless: &str| -> Output {
        let mut test = Command::new(std::env::current_exe().expect("this test"));
        test.args(["--exact", "compares", "--ignored"]).env("GOLDEN", path).env(BLESS, bless);
        test.output().expect("it runs")
    };
    let path = fresh("blessed");
    // Not by a variable that is empty or 0: then it is missing, and the test says how to make it.
    for off in ["", "0"] {
        let failed = compares(&path, off);
        assert!(!failed.status.success() && !path.exists());
        let told =
            String::from_utf8_lossy(&failed.stdout).into_owned() + &String::from_utf8_lossy(&failed.stderr);
        assert!(told.contains("is not there yet") && told.contains("RTA_BLESS=1 cargo test"), "{told}");
    }
    assert!(compares(&path, "1").status.success());
    assert_eq!(decoded(&path), (png::ColorType::Indexed, (3, 2), vec![0, 1, 0, 1, 1, 0]));
    assert!(compares(&path, "0").status.success());
    // A picture that differs is replaced, also one of another kind and size.
    fs::write(&path, "GIF89a").expect("a file");
    assert!(!compares(&path, "").status.success());
    assert!(compares(&path, "yes").status.success() && compares(&path, "").status.success());
}
