//! A palette from samples of the picture, by cuts that take away the most variance.

use core::ops::Bound;

use rta_core::color::Rgb;

use super::{BACKGROUND, MAX_COLORS, Palette, TableError, distance};
use crate::display::reduce;
use crate::dither;

/// The most samples that a colour table can be made of, 2^20: so many are the pixels of the largest of the thesis's screens. With them,
/// no sum and no product here leaves 64 bits.
pub const MAX_SAMPLES: usize = 1 << 20;

/// The boxes of [`variance_cut`], at most one for each entry.
type Parts = heapless::Vec<Part, { MAX_COLORS as usize }>;

/// The stack that [`variance_cut`] needs for its boxes, in bytes: 2 KiB.
pub const BOXES_SIZE: usize = size_of::<Parts>();

/// Makes a palette of at most `colors` entries, black among them, for a display whose guns have the levels 0..=`gun_max`.
///
/// `light` is samples of the picture, 8 bits a gun, row by row on a grid `width` samples wide: those of a
/// [`Lattice`](rta_core::raster::lattice::Lattice), or all pixels. As many are used as `memory` holds; 4096 of them, 12 KiB, give
/// palettes that are within a few per cent of the best. What is in the memory before and after does not matter. Beside it, 2 KiB of
/// stack are needed for the boxes.
///
/// The criterion is that of X. Wu, "Efficient Statistical Computations for Optimal Color Quantization", Graphics Gems II, 1991, computed
/// on the samples themselves instead of a histogram. All samples are in one box at first. The box whose colours spread most about
/// their mean is cut in two across one gun, where that takes away the most of the spread, until there are as many boxes as entries;
/// each entry is the mean of a box. Everything is integers, so every processor makes the same palette.
///
/// Samples are rounded to the guns first, as what the palette will hold. Where guns have fewer than 6 bits they are dithered to them, by
/// the matrix of [`dither::bayer`] over the grid: else a smooth sky lacks one of the two levels that it lies between, and dithering
/// the picture would reach for entries far away.
///
/// # Errors
/// [`TableError::Colors`] unless `colors` is 2..=256, [`TableError::Guns`] if `gun_max` is 0, [`TableError::Samples`] for no samples or
/// more than [`MAX_SAMPLES`].
pub fn variance_cut(
    memory: &mut [Rgb<u8>],
    light: impl IntoIterator<Item = Rgb<u8>>,
    width: u32,
    colors: u16,
    gun_max: u8,
) -> Result<Palette, TableError> {
    if !(2..=MAX_COLORS).contains(&colors) {
        return Err(TableError::Colors { colors, min: 2 });
    }
    if gun_max == 0 {
        return Err(TableError::Guns);
    }
    let samples = rounded(memory, light, width, gun_max)?;
    Palette::new(means(samples, usize::from(colors) - 1), gun_max)
}

/// Rounds samples of a picture, row by row on a grid `width` samples wide, to levels 0..=`gun_max` of a display's guns, as
/// [`variance_cut`] says. Returns those that there is memory for.
///
/// # Errors
/// [`TableError::Samples`] for none or for more than [`MAX_SAMPLES`].
pub(super) fn rounded(
    memory: &mut [Rgb<u8>],
    light: impl IntoIterator<Item = Rgb<u8>>,
    width: u32,
    gun_max: u8,
) -> Result<&mut [Rgb<u8>], TableError> {
    let (mut x, mut y, mut len) = (0, 0, 0);
    for (sample, light) in memory.iter_mut().zip(light) {
        *sample = to_guns(light, x, y, gun_max);
        len += 1;
        x += 1;
        if x == width {
            (x, y) = (0, y + 1);
        }
    }
    let samples = memory.get_mut(..len).unwrap_or_default();
    if samples.is_empty() || samples.len() > MAX_SAMPLES {
        return Err(TableError::Samples { samples: len });
    }
    Ok(samples)
}

/// Returns a colour, 8 bits a gun, as levels 0..=`gun_max` of a display's guns, as [`variance_cut`] takes it for the sample in column `x` of row
/// `y`: dithered where the guns have fewer than 6 bits, else rounded.
pub fn to_guns(light: Rgb<u8>, x: u32, y: u32, gun_max: u8) -> Rgb<u8> {
    let step = if gun_max < 63 { u8::MAX / gun_max.max(1) } else { 0 };
    dither::ordered(light, x, y, Rgb::new(step, step, step)).map(|level| reduce(level, gun_max))
}

/// Cuts samples into at most `count` boxes and returns the mean of each, in the place of the first samples.
// By itself, so that the stack has the boxes only after the samples are there: in firmware, as they are traced, that of the tracer.
#[inline(never)]
fn means(samples: &mut [Rgb<u8>], count: usize) -> &[Rgb<u8>] {
    // Spreads of up to 2^14 samples fit 32 bits; of more, their upper bits do.
    let shift = (samples.len() >> 14).checked_ilog2().map_or(0, |power| power + 1);
    let spread = |colors: &[Rgb<u8>]| u32::try_from(spread(colors) >> shift).unwrap_or(u32::MAX);
    // In the order of their samples, so that a part ends where the next one starts.
    let mut parts = Parts::new();
    let _ = parts.push(Part { start: 0, spread: spread(samples) });
    while parts.len() < count {
        // Of equal ones the first; `max_by_key` takes the last.
        let widest = parts.iter().enumerate().rev().max_by_key(|(_, part)| part.spread);
        let Some((index, start)) = widest.map(|(index, part)| (index, part.start as usize)) else { break };
        let Some(colors) = samples.get_mut(range(&parts, index)) else { break };
        let Some((lower, upper)) = cut(colors).and_then(|at| colors.split_at_checked(at)) else { break };
        let split = u32::try_from(start + lower.len()).unwrap_or(u32::MAX);
        let (below, above) = (spread(lower), spread(upper));
        if let Some(part) = parts.get_mut(index) {
            part.spread = below;
        }
        let _ = parts.insert(index + 1, Part { start: split, spread: above });
    }
    for index in 0..parts.len() {
        let mean = Sums::of(samples.get(range(&parts, index)).unwrap_or_default()).mean();
        // No part that is still to come begins before sample number `index`, as each before it has at least one.
        set(samples, index, mean);
    }
    samples.get(..parts.len()).unwrap_or_default()
}

/// A box: samples from `start` to where the next one starts.
#[derive(Clone, Copy)]
struct Part {
    start: u32,
    /// How much its colours spread, see [`spread`].
    spread: u32,
}

/// Returns which samples are those of part `index`; of the last part, all that are left.
fn range(parts: &[Part], index: usize) -> (Bound<usize>, Bound<usize>) {
    let start = |index: usize| parts.get(index).map(|part| part.start as usize);
    (Bound::Included(start(index).unwrap_or(0)), start(index + 1).map_or(Bound::Unbounded, Bound::Excluded))
}

/// Sums over colours.
#[derive(Clone, Copy, Default)]
pub(super) struct Sums {
    count: u32,
    /// At most 255 * 2^20 each.
    guns: Rgb<u32>,
}

impl Sums {
    fn of(colors: &[Rgb<u8>]) -> Self {
        let mut sums = Self::default();
        colors.iter().for_each(|&color| sums.add(color));
        sums
    }

    fn add(&mut self, color: Rgb<u8>) {
        self.count += 1;
        self.guns = self.guns.zip(color, |sum, level| sum + u32::from(level));
    }

    /// Adds a colour that is there `count` times.
    pub(super) fn add_equal(&mut self, color: Rgb<u8>, count: u32) {
        self.count += count;
        self.guns = self.guns.zip(color, |sum, level| sum + count * u32::from(level));
    }

    pub(super) fn is_empty(self) -> bool {
        self.count == 0
    }

    /// Returns the sums without those of some of the colours.
    fn without(self, part: Self) -> Self {
        Self { count: self.count - part.count, guns: self.guns.zip(part.guns, |sum, part| sum - part) }
    }

    /// Returns the mean, rounded to the nearest level; black for no colours.
    pub(super) fn mean(self) -> Rgb<u8> {
        let count = self.count.max(1);
        // A mean of bytes is a byte.
        self.guns.map(|sum| ((sum + count / 2) / count).to_le_bytes()[0])
    }

    /// Returns the squared length of the sum over the number of colours, in 1/64 of a squared level, rounded down.
    fn square_over_count(self) -> u64 {
        let square = |sum: u32| u64::from(sum) * u64::from(sum);
        // At most 64 * 3 * (255 * 2^20)^2 < 2^64.
        64 * (square(self.guns.r) + square(self.guns.g) + square(self.guns.b)) / u64::from(self.count.max(1))
    }
}

/// Returns the sum of the squared distances of colours from their mean, rounded up: 0 only if all are equal.
fn spread(colors: &[Rgb<u8>]) -> u64 {
    let squares: u64 = colors.iter().map(|&color| u64::from(distance(color, BACKGROUND))).sum();
    squares - Sums::of(colors).square_over_count() / 64
}

/// Cuts colours in two across one gun, where the sum of both spreads is least: sorts them and returns how many are in the lower part. Of
/// equally good cuts it takes that of the first gun, at its lowest level. `None` if all colours are equal.
fn cut(colors: &mut [Rgb<u8>]) -> Option<usize> {
    // The guns take turns to be the first one, so that there is one sort, by that, and no calls to look a gun up.
    let mut best: Option<(u64, usize, usize)> = None;
    for gun in 0..3 {
        // Colours of one level are never parted, so their order among themselves does not matter: any sort will do.
        sort(colors);
        let (mut lower, all) = (Sums::default(), Sums::of(colors));
        for pair in colors.windows(2) {
            let [this, next] = pair else { continue };
            lower.add(*this);
            if this.r < next.r {
                let gain = lower.square_over_count() + all.without(lower).square_over_count();
                if best.is_none_or(|(most, ..)| gain > most) {
                    best = Some((gain, gun, lower.count as usize));
                }
            }
        }
        turn(colors);
    }
    let (_, gun, at) = best?;
    (0..gun).for_each(|_| turn(colors));
    sort(colors);
    (gun..3).for_each(|_| turn(colors));
    Some(at)
}

/// Makes green the first gun, blue the second and red the third; three turns bring all back.
fn turn(colors: &mut [Rgb<u8>]) {
    colors.iter_mut().for_each(|color| *color = Rgb::new(color.g, color.b, color.r));
}

/// The distances of Shell sort that M. Ciura found best, "Best Increments for the Average Case of Shellsort", 2001; larger ones grow by 9/4.
const GAPS: [usize; 8] = [701, 301, 132, 57, 23, 10, 4, 1];

/// Sorts colours by their first gun: Shell sort, which needs no memory. (The sort of the core library takes 6 KB of code more on a
/// Cortex-M0; heap sort needs more instructions for parts that are as small as most.)
fn sort(colors: &mut [Rgb<u8>]) {
    let mut first = 701;
    while first < colors.len() / 3 {
        first = first * 9 / 4;
    }
    let larger = core::iter::successors(Some(first), |gap| Some(gap * 4 / 9)).take_while(|gap| *gap > 701);
    for gap in larger.chain(GAPS) {
        for end in gap..colors.len() {
            let Some(&color) = colors.get(end) else { break };
            let mut at = end;
            while let Some(before) = at.checked_sub(gap)
                && let Some(&larger) = colors.get(before).filter(|before| before.r > color.r)
            {
                set(colors, at, larger);
                at = before;
            }
            set(colors, at, color);
        }
    }
}

fn set(colors: &mut [Rgb<u8>], at: usize, color: Rgb<u8>) {
    if let Some(place) = colors.get_mut(at) {
        *place = color;
    }
}
