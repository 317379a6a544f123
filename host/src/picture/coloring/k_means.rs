//! A palette moved to where it is best for all pixels of a picture.

use std::collections::HashMap;

use rta_core::color::Rgb;
use rta_drivers::display::expand;
use rta_drivers::quantize::{ColorTable, Palette, TableError};

/// Rounds of assigning and averaging. On the shipped scenes nothing that can be seen changes after ten.
const ROUNDS: u32 = 32;

/// Returns a palette of as many entries as `palette` whose mean squared distance from the colours `pixels`, in levels of guns
/// 0..=`gun_max`, is less or the same: the method of S. Lloyd, "Least Squares Quantization in PCM", IEEE Transactions on Information
/// Theory 28, 2, 1982. Every pixel belongs to the entry nearest to it, and each entry becomes the mean of its pixels, until none moves.
///
/// It computes in integers, so all machines return the same palette.
///
/// # Errors
/// Those of [`Palette::new`]; there are none for entries that a palette has given.
pub(super) fn refined(
    palette: Palette,
    pixels: impl Iterator<Item = Rgb<u8>>,
    gun_max: u8,
) -> Result<Palette, TableError> {
    let mut counts = HashMap::<Rgb<u8>, u64>::new();
    pixels.for_each(|pixel| *counts.entry(pixel).or_default() += 1);
    let mut palette = palette;
    for _ in 0..ROUNDS {
        let mut sums = vec![(0_u64, Rgb::new(0_u64, 0, 0)); palette.entries().len()];
        for (&levels, &pixels) in &counts {
            let nearest = palette.nearest(levels.map(|level| expand(level, gun_max)));
            if let Some((count, sum)) = sums.get_mut(usize::from(nearest)) {
                *count += pixels;
                *sum = sum.zip(levels, |sum, level| sum + pixels * u64::from(level));
            }
        }
        // The mean of bytes is a byte. Black is an entry whatever is near it.
        let mean =
            |sum: u64, count: u64| ((sum + count / 2) / count).to_le_bytes().first().copied().unwrap_or(0);
        let means: Vec<_> = sums
            .iter()
            .skip(1)
            .zip(palette.levels(gun_max).skip(1))
            .map(|((count, sum), old)| if *count == 0 { old } else { sum.map(|sum| mean(sum, *count)) })
            .collect();
        let next = Palette::new(&means, gun_max)?;
        if next.entries() == palette.entries() {
            break;
        }
        palette = next;
    }
    Ok(palette)
}

#[cfg(test)]
mod tests {
    use rta_core::color::Rgb;
    use rta_drivers::quantize::{ColorTable, Palette};

    use super::refined;

    #[test]
    fn entries_move_to_the_means_of_their_pixels() {
        let gray = |level| Rgb::new(level, level, level);
        let start = Palette::new(&[gray(20), gray(40)], 63).expect("a palette");
        let pixels = [[gray(10); 3], [gray(14); 3], [gray(60); 3]].concat();
        let got = refined(start, pixels.iter().copied(), 63).expect("a palette");
        assert_eq!(got.levels(63).collect::<Vec<_>>(), [gray(0), gray(12), gray(60)]);
        assert_eq!(
            refined(got.clone(), pixels.iter().copied(), 63).expect("a palette").entries(),
            got.entries()
        );
    }
}
