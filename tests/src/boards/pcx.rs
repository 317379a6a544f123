//! PCX files of 256 colours, as the DOS program writes them: a decoder that takes nothing for granted.

use rta_core::color::Rgb;

use super::Failure;
use super::expected::Indexed;

/// Bytes of the header, and of the table at the end with the byte that announces it.
const HEADER: usize = 128;
const TABLE: usize = 769;

/// Reads a file of one plane of 8 bits; returns width and height, and the picture, whose levels are 0..=255.
///
/// # Errors
/// What is not as it must be, in words: also bytes that are left over, and runs beyond the end of a row.
pub fn decode(file: &[u8]) -> Result<((usize, usize), Indexed), Failure> {
    let (header, rest) = file.split_at_checked(HEADER).ok_or("it has no header")?;
    let body = rest.len().checked_sub(TABLE).ok_or("it has no colour table")?;
    let (mut body, table) = rest.split_at_checked(body).ok_or("it has no colour table")?;
    if header.get(..4) != Some(&[10, 5, 1, 8]) || header.get(65) != Some(&1) {
        return Err("it is no PCX of 256 colours".into());
    }
    let word = |place: usize| match header.get(place..place + 2) {
        Some(&[low, high]) => usize::from(u16::from_le_bytes([low, high])),
        _ => 0,
    };
    let side = |first, last| (word(last) + 1).checked_sub(word(first)).ok_or("it has no pixels");
    let (width, height, line) = (side(4, 8)?, side(6, 10)?, word(66));
    if line < width || line % 2 != 0 {
        return Err(format!("rows of {line} bytes for {width} pixels").into());
    }
    let mut pixels = Vec::new();
    for _ in 0..height {
        let mut row = Vec::new();
        while row.len() < line {
            let (count, value);
            (count, value, body) = match *body {
                [run @ 0xC0..=0xFF, value, ref rest @ ..] => (usize::from(run & 0x3F), value, rest),
                [value @ 0..=0xBF, ref rest @ ..] => (1, value, rest),
                _ => return Err("its rows end too early".into()),
            };
            row.extend(core::iter::repeat_n(value, count));
        }
        if row.len() > line {
            return Err("a run goes beyond its row".into());
        }
        pixels.extend(row.into_iter().take(width));
    }
    let Some((12, colors)) = table.split_first() else {
        return Err("its colour table is not announced".into());
    };
    if !body.is_empty() {
        return Err(format!("{} bytes between its rows and its colour table", body.len()).into());
    }
    let colors = colors.as_chunks::<3>().0.iter().map(|&[r, g, b]| Rgb::new(r, g, b)).collect();
    Ok(((width, height), Indexed { colors, pixels }))
}

/// The encoder: the very file that the DOS program is built from.
#[cfg(test)]
#[path = "../../boards/pc/src/dos/pcx.rs"]
mod encoder;

#[cfg(test)]
mod tests {
    #![allow(clippy::indexing_slicing)] // a test may panic

    use rta_core::color::Rgb;
    use rta_drivers::display::expand;

    use super::{HEADER, TABLE, decode, encoder};

    /// Colours of which no two are equal.
    fn colors() -> [Rgb<u8>; 256] {
        core::array::from_fn(|index| {
            let index = u8::try_from(index).expect("256 entries");
            Rgb::new(index & 63, index >> 2, 63 - (index >> 2))
        })
    }

    fn encode(width: u16, rows: &[&[u8]]) -> Vec<u8> {
        let height = u16::try_from(rows.len()).expect("a few rows");
        let mut file = encoder::header(width, height).to_vec();
        for row in rows {
            encoder::row(row, |byte| file.push(byte));
        }
        encoder::table(&colors(), 63, |byte| file.push(byte));
        file
    }

    /// Encodes, decodes and compares; returns the bytes of the rows.
    fn round(rows: &[&[u8]]) -> usize {
        let width = rows.first().map_or(0, |row| row.len());
        let file = encode(u16::try_from(width).expect("a short row"), rows);
        let (size, picture) = decode(&file).expect("a picture");
        assert_eq!(size, (width, rows.len()));
        assert_eq!(picture.pixels, rows.concat());
        assert_eq!(picture.colors, colors().map(|color| color.map(|level| expand(level, 63))));
        file.len() - HEADER - TABLE
    }

    #[test]
    fn runs_are_as_long_as_they_may_be() {
        // 63, 63, ... of one value: two bytes each; 320 = 5 * 63 + 5.
        assert_eq!(round(&[&[7; 320]]), 12);
        assert_eq!(round(&[&[7; 63]]), 2 + 1); // and a byte, so that the row is even
        assert_eq!(round(&[&[7; 64]]), 2 + 1);
        assert_eq!(round(&[&[200; 64]]), 2 + 2);
    }

    #[test]
    fn no_run_goes_over_the_end_of_a_row() {
        assert_eq!(round(&[&[7; 10], &[7; 10]]), 4);
    }

    #[test]
    fn the_worst_row_is_twice_as_long_as_its_pixels() {
        let worst: Vec<u8> = (0..320_u16).map(|x| if x % 2 == 0 { 0xC0 } else { 0xFF }).collect();
        assert_eq!(round(&[&worst, &worst]), 2 * 640);
        let best: Vec<u8> = worst.iter().map(|value| value - 0xC0).collect();
        assert_eq!(round(&[&best]), 320);
    }

    #[test]
    fn every_value_comes_back_alone_in_pairs_and_in_odd_rows() {
        let all: Vec<u8> = (0..=255).collect();
        let pairs: Vec<u8> = all.iter().flat_map(|&value| [value, value]).collect();
        assert_eq!(round(&[&all]), 256 + 64);
        assert_eq!(round(&[&pairs]), 512);
        round(&[&all[1..], &all[..255]]);
    }

    #[test]
    fn random_rows_come_back() {
        let mut random = fastrand::Rng::with_seed(13);
        for _ in 0..200 {
            let width = random.usize(1..400);
            // Few values, so that there are runs of all lengths.
            let values = random.u8(1..=255);
            let rows: Vec<Vec<u8>> = (0..3)
                .map(|_| {
                    let mut row = Vec::new();
                    while row.len() < width {
                        let value = 255 - random.u8(0..values);
                        row.extend(core::iter::repeat_n(value, random.usize(1..150).min(width - row.len())));
                    }
                    row
                })
                .collect();
            round(&rows.iter().map(Vec::as_slice).collect::<Vec<_>>());
        }
    }

    #[test]
    fn a_broken_file_is_refused() {
        let file = encode(320, &[&[7; 320]]);
        let refused = |file: &[u8]| decode(file).expect_err("a broken file").to_string();
        assert_eq!(refused(&file[..100]), "it has no header");
        assert_eq!(refused(&file[..file.len() - 1]), "its rows end too early");
        let mut other = file.clone();
        other[file.len() - TABLE] = 11;
        assert_eq!(refused(&other), "its colour table is not announced");
        let mut longer = file.clone();
        longer.insert(HEADER, 0);
        assert!(refused(&longer).contains("run"), "{}", refused(&longer));
        let mut longer = file.clone();
        longer.insert(file.len() - TABLE, 3);
        assert_eq!(refused(&longer), "1 bytes between its rows and its colour table");
        let mut other = file;
        other[65] = 3;
        assert_eq!(refused(&other), "it is no PCX of 256 colours");
    }
}
