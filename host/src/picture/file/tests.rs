use rta_core::color::Rgb;

use std::io::Write;

use super::{
    Caption, Displayed, FileType, Pixels, bytes, flip, write_light, write_pfm_header, write_png_rows,
};
use crate::picture::raster::Size;

const RED: Rgb<u8> = Rgb::new(255, 0, 0);
const GRAY: Rgb<u8> = Rgb::new(85, 85, 85);

fn indexed() -> Displayed {
    let pixels = Pixels::Indexed { palette: vec![RED, GRAY], indices: vec![0, 1, 1, 0, 0, 1] };
    Displayed { size: Size::new(3, 2).expect("small"), aspect: 1.5 * 5.0 / 6.0, pixels }
}

#[test]
fn extensions_name_types_in_any_case() {
    assert_eq!(FileType::of_extension("PNG"), Some(FileType::Png));
    assert_eq!(FileType::of_extension("pfm"), Some(FileType::Pfm));
    assert_eq!(FileType::of_extension("jpg"), None);
    assert_eq!(FileType::of_extension(""), None);
}

#[test]
fn an_indexed_png_keeps_its_table_shape_and_words() {
    let mut file = Vec::new();
    let caption = Caption { title: "Spheres \u{3b1}".into(), settings: "depth 5".into() };
    indexed().write_png(&caption, &mut file).expect("memory takes it");
    let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().expect("a PNG");
    let mut indices = [9; 6];
    reader.next_frame(&mut indices).expect("six pixels");
    reader.finish().expect("an end");
    assert_eq!(indices, [0, 1, 1, 0, 0, 1]);
    let info = reader.info();
    assert_eq!(info.color_type, png::ColorType::Indexed);
    assert_eq!(info.palette.as_deref(), Some(&[255, 0, 0, 85, 85, 85][..]));
    let shape = info.pixel_dims.expect("the pixels are not square");
    assert_eq!((shape.xppu, shape.yppu), (6, 5));
    assert!(info.uncompressed_latin1_text.iter().any(|chunk| chunk.keyword == "Software"));
    let title = info.utf8_text.iter().find(|chunk| chunk.keyword == "Title").expect("a title");
    assert_eq!(title.get_text().expect("text"), "Spheres \u{3b1}");
}

#[test]
fn square_pixels_need_no_word() {
    let picture = Displayed { aspect: 1.5, ..indexed() };
    let mut file = Vec::new();
    picture.write_png(&Caption::default(), &mut file).expect("memory takes it");
    let reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().expect("a PNG");
    assert!(reader.info().pixel_dims.is_none());
}

#[test]
fn a_ppm_has_the_colours_of_the_table() {
    let (mut table, mut direct) = (Vec::new(), Vec::new());
    indexed().write_ppm(&mut table).expect("memory takes it");
    let pixels = Pixels::Direct(vec![RED, GRAY, GRAY, RED, RED, GRAY]);
    Displayed { pixels, ..indexed() }.write_ppm(&mut direct).expect("memory takes it");
    assert_eq!(table, direct);
    assert_eq!(table, b"P6\n3 2\n255\n\xff\0\0UUUUUU\xff\0\0\xff\0\0UUU");
}

#[test]
fn a_pfm_is_in_little_endian() {
    let mut file = Vec::new();
    let pixels = [Rgb::new(0.0, 40_000.0, 0.25), Rgb::new(1.0, 2.0, -0.5)];
    write_pfm_header(Size::new(1, 2).expect("small"), &mut file).expect("memory takes it");
    write_light(&pixels, &mut file).expect("memory takes it");
    let numbers: Vec<u8> =
        [0.0_f32, 40_000.0, 0.25, 1.0, 2.0, -0.5].into_iter().flat_map(f32::to_le_bytes).collect();
    assert_eq!(file, [b"PF\n1 2\n-1.0\n".as_slice(), &numbers].concat());
}

#[test]
fn rows_are_flipped() {
    for (rows, want) in [(0, vec![]), (1, vec![0, 1]), (2, vec![2, 3, 0, 1]), (3, vec![4, 5, 2, 3, 0, 1])] {
        let mut pixels: Vec<i32> = (0..2 * rows).collect();
        flip(&mut pixels, 2);
        assert_eq!(pixels, want);
    }
}

#[test]
fn rows_of_a_png_one_by_one_are_the_picture() {
    let size = Size::new(2, 3).expect("small");
    let pixels = [RED, GRAY, GRAY, RED, RED, GRAY];
    let mut file = Vec::new();
    let fill = |rows: &mut dyn Write| pixels.chunks(4).try_for_each(|part| rows.write_all(&bytes(part)));
    write_png_rows(size, size.ratio(), &Caption::default(), &mut file, fill).expect("memory takes it");
    let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().expect("a PNG");
    let mut got = [9; 18];
    reader.next_frame(&mut got).expect("six pixels");
    assert_eq!(got.as_slice(), bytes(&pixels));
}
