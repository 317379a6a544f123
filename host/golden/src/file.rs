//! PNG files.

use std::fs::File;
use std::io::{self, BufReader};
use std::path::Path;

use rta_core::color::Rgb;

/// Colours of 8 bits a gun, row by row from the top, and the number of pixels in a row and of rows.
pub(crate) struct Colors {
    pub(crate) width: u32,
    pub(crate) height: u32,
    pub(crate) pixels: Vec<Rgb<u8>>,
}

/// Reads a PNG of any kind. Transparency plays no part, and of 16 bits a gun the upper 8 count.
pub(crate) fn read(path: &Path) -> io::Result<Colors> {
    let mut decoder = png::Decoder::new(BufReader::new(File::open(path)?));
    decoder.set_transformations(png::Transformations::normalize_to_color8());
    let mut reader = decoder.read_info()?;
    let too_large = || io::Error::from(io::ErrorKind::OutOfMemory);
    let mut registers = vec![0; reader.output_buffer_size().ok_or_else(too_large)?];
    let info = reader.next_frame(&mut registers)?;
    let pixels = registers.chunks_exact(info.color_type.samples()).map(|pixel| match *pixel {
        [r, g, b, ..] => Rgb::new(r, g, b),
        [grey, ..] => Rgb::new(grey, grey, grey),
        [] => Rgb::default(),
    });
    Ok(Colors { width: info.width, height: info.height, pixels: pixels.collect() })
}

/// Returns a PNG of 8 bits a gun. With a colour table, `data` is an index for each pixel; without one, red, green and blue.
pub(crate) fn encode(
    (width, height): (u32, u32),
    table: Option<Vec<u8>>,
    data: &[u8],
) -> io::Result<Vec<u8>> {
    let mut content = Vec::new();
    let mut encoder = png::Encoder::new(&mut content, width, height);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_color(if table.is_some() { png::ColorType::Indexed } else { png::ColorType::Rgb });
    if let Some(table) = table {
        encoder.set_palette(table);
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(data)?;
    writer.finish()?;
    Ok(content)
}

/// Returns the registers of colours one after the other: red, green, blue.
pub(crate) fn registers(colors: impl IntoIterator<Item = Rgb<u8>>) -> Vec<u8> {
    colors.into_iter().flat_map(|color| [color.r, color.g, color.b]).collect()
}
