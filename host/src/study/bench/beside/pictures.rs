//! Pictures of linear light that were written by other processes: PFM, and PPM with 16 bits.

use std::fs;
use std::io;
use std::path::Path;

use rta_core::color::Rgb;

/// Reads a picture of so many pixels, row by row from the top.
///
/// # Errors
/// Those of reading, and [`io::ErrorKind::InvalidData`] for another kind of file or another number of pixels.
pub fn read(path: &Path, pixels: usize) -> io::Result<Vec<Rgb<f32>>> {
    let light = parsed(&fs::read(path)?).filter(|light| light.len() == pixels);
    light.ok_or_else(|| {
        io::Error::new(io::ErrorKind::InvalidData, format!("{} is no such picture", path.display()))
    })
}

/// Returns the light of a picture, 1 is white.
fn parsed(bytes: &[u8]) -> Option<Vec<Rgb<f32>>> {
    let (kind, rest) = word(bytes)?;
    let (width, rest) = word(rest)?;
    let (height, rest) = word(rest)?;
    let (most, rest) = word(rest)?;
    // One byte of white space, then the registers.
    let rest = rest.get(1..)?;
    let (width, height) = (width.parse::<usize>().ok()?, height.parse::<usize>().ok()?);
    let registers: Vec<f32> = match kind {
        "P6" if most == "65535" => {
            rest.as_chunks().0.iter().map(|pair| f32::from(u16::from_be_bytes(*pair)) / 65535.0).collect()
        }
        "PF" if most.starts_with('-') => {
            rest.as_chunks().0.iter().map(|four| f32::from_le_bytes(*four)).collect()
        }
        _ => return None,
    };
    let pixels = registers.as_chunks().0.iter().map(|&[r, g, b]| Rgb::new(r, g, b));
    let mut rows: Vec<Vec<_>> = Vec::new();
    let pixels: Vec<_> = pixels.collect();
    rows.extend(pixels.chunks(width.max(1)).map(<[_]>::to_vec));
    if rows.len() != height || rows.last().is_some_and(|row| row.len() != width) {
        return None;
    }
    // A PFM begins below.
    if kind == "PF" {
        rows.reverse();
    }
    Some(rows.concat())
}

/// Returns the next word of a head and what follows it; lines that begin with # are passed over.
fn word(bytes: &[u8]) -> Option<(&str, &[u8])> {
    let mut rest = bytes.trim_ascii_start();
    while rest.first() == Some(&b'#') {
        let end = rest.iter().position(|byte| *byte == b'\n')?;
        rest = rest.get(end..)?.trim_ascii_start();
    }
    let end = rest.iter().position(u8::is_ascii_whitespace)?;
    let (word, rest) = rest.split_at_checked(end)?;
    Some((core::str::from_utf8(word).ok()?, rest))
}

#[cfg(test)]
mod tests {
    use rta_core::color::Rgb;

    use super::parsed;

    #[test]
    fn pictures_are_read_from_the_top() {
        let mut ppm = b"P6\n# by POV-Ray\n1 2\n65535\n".to_vec();
        ppm.extend([0xff, 0xff, 0, 0, 0x80, 0, 0, 1, 0, 0, 0, 0]);
        let light = parsed(&ppm).expect("a picture");
        assert_eq!(light, [Rgb::new(1.0, 0.0, 32768.0 / 65535.0), Rgb::new(1.0 / 65535.0, 0.0, 0.0)]);
        let mut pfm = b"PF\n1 2\n-1.0\n".to_vec();
        [1.0_f32, 2.0, 3.0, 4.0, 5.0, 6.5].iter().for_each(|light| pfm.extend(light.to_le_bytes()));
        let light = parsed(&pfm).expect("a picture");
        assert_eq!(light, [Rgb::new(4.0, 5.0, 6.5), Rgb::new(1.0, 2.0, 3.0)]);
        pfm.pop();
        assert_eq!(parsed(&pfm), None);
        assert_eq!(parsed(b"P6\n1 1\n255\nabc"), None);
        assert_eq!(parsed(b"P6"), None);
    }
}
