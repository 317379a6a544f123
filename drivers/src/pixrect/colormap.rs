//! A colormap as PIXRECT hands it over: three arrays, one for each gun.

use rta_core::color::Rgb;

use super::PixrectError;

/// Checks that the arrays of the three guns have one length and that a colormap of 256 entries has that many from
/// `index` on.
pub(super) fn check_colormap(
    index: usize,
    red: usize,
    green: usize,
    blue: usize,
) -> Result<(), PixrectError> {
    let inside = index.checked_add(red).is_some_and(|end| end <= 256);
    if inside && red == green && red == blue { Ok(()) } else { Err(PixrectError::Colormap) }
}

/// Copies `entries` into one array for each gun, as far as the shortest of the four reaches.
pub(super) fn split_guns(entries: &[Rgb<u8>], red: &mut [u8], green: &mut [u8], blue: &mut [u8]) {
    for (((entry, r), g), b) in entries.iter().zip(red).zip(green).zip(blue) {
        (*r, *g, *b) = (entry.r, entry.g, entry.b);
    }
}
