//! A palette moved to where it is best for all pixels of a picture.

use rta_core::color::Rgb;

use super::cut::{Sums, rounded};
use super::{ColorTable, MAX_COLORS, Palette, TableError};
use crate::display::expand;

/// Rounds of assigning and averaging. On the shipped scenes nothing that can be seen changes after ten.
const ROUNDS: u32 = 32;

/// Returns a palette of at most as many entries as `palette` whose mean squared distance from samples of the picture is less or the same:
/// the method of S. Lloyd, "Least Squares Quantization in PCM", IEEE Transactions on Information Theory 28, 2, 1982. Every sample belongs to the
/// entry nearest to it, and each entry becomes the mean of its samples, until none moves. Black stays, whatever is near it.
///
/// Memory and samples are those of [`variance_cut`](super::variance_cut), which also makes the palette to begin with. It is for machines with the
/// memory for a whole picture; 8 KiB of stack are needed beside it. Everything is integers, so every processor makes the same palette.
///
/// # Errors
/// [`TableError::Guns`] if `gun_max` is 0, [`TableError::Samples`] for no samples or more than [`MAX_SAMPLES`](super::MAX_SAMPLES).
pub fn refined(
    palette: Palette,
    memory: &mut [Rgb<u8>],
    light: impl IntoIterator<Item = Rgb<u8>>,
    width: u32,
    gun_max: u8,
) -> Result<Palette, TableError> {
    let samples = rounded(memory, light, width, gun_max)?;
    // Equal colours stand together, so that the nearest entry is looked for once for all of them.
    samples.sort_unstable_by_key(|color| [color.r, color.g, color.b]);
    let mut palette = palette;
    for _ in 0..ROUNDS {
        let mut sums = [Sums::default(); MAX_COLORS as usize];
        for equal in samples.chunk_by(|a, b| a == b) {
            let Some(&levels) = equal.first() else { continue };
            let nearest = palette.nearest(levels.map(|level| expand(level, gun_max)));
            if let Some(sums) = sums.get_mut(usize::from(nearest)) {
                sums.add_equal(levels, u32::try_from(equal.len()).unwrap_or(u32::MAX));
            }
        }
        let mut means = [Rgb::default(); MAX_COLORS as usize];
        let entries = means.iter_mut().zip(palette.levels(gun_max)).zip(sums);
        for ((mean, old), sums) in entries.skip(1) {
            *mean = if sums.is_empty() { old } else { sums.mean() };
        }
        let next = Palette::new(means.get(1..palette.entries().len()).unwrap_or_default(), gun_max)?;
        if next.entries() == palette.entries() {
            break;
        }
        palette = next;
    }
    Ok(palette)
}
