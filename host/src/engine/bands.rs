//! Shares a picture among all cores: bands of rows are traced in any order and delivered from top to bottom.

use core::sync::atomic::{AtomicBool, Ordering};
use std::collections::BTreeMap;
use std::sync::mpsc;

use rayon::iter::{ParallelBridge, ParallelIterator};
use rayon::{ThreadPool, ThreadPoolBuildError};

use crate::picture::raster::Size;

/// Approximate number of pixels in a band: few enough that a band stops within milliseconds and that the last bands keep all
/// threads busy, and enough that handing a band over costs nothing beside tracing it.
const BAND_PIXELS: u32 = 2048;

/// Why a picture is not traced to its end.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum BandsError {
    /// The threads could not be started.
    #[error("cannot start the threads: {0}")]
    Threads(#[from] ThreadPoolBuildError),
    /// An interrupt or a request to terminate arrived.
    #[error("interrupted")]
    Interrupted,
}

/// Starts `count` threads, or one for each core.
///
/// # Errors
/// [`BandsError::Threads`] if the system has none to give.
pub fn pool(count: Option<u16>) -> Result<ThreadPool, BandsError> {
    let count = count.map_or(0, usize::from);
    Ok(rayon::ThreadPoolBuilder::new().num_threads(count).build()?)
}

/// Traces a picture with all threads of `pool`.
///
/// `trace(first, pixels)` fills whole rows beginning with row `first`; bands begin in order, each by the next free
/// thread. `deliver(first, pixels)` is given every row exactly once, from top to bottom, on the calling thread, so
/// what it sees does not depend on the number of threads.
///
/// # Errors
/// [`BandsError::Interrupted`] soon after `stop` becomes true, and the first error of `deliver`, which also ends the
/// work.
pub fn bands<T: Clone + Default + Send, E: From<BandsError>>(
    size: Size,
    pool: &ThreadPool,
    stop: &AtomicBool,
    trace: impl Fn(u32, &mut [T]) + Sync,
    mut deliver: impl FnMut(u32, Vec<T>) -> Result<(), E>,
) -> Result<(), E> {
    share(size, pool, stop, &trace, &mut deliver)
}

/// [`bands`], compiled once for each kind of pixel and not once for each caller: a call through a pointer for each band costs
/// nothing beside tracing it.
fn share<T: Clone + Default + Send, E: From<BandsError>>(
    size: Size,
    pool: &ThreadPool,
    stop: &AtomicBool,
    trace: &(dyn Fn(u32, &mut [T]) + Sync),
    deliver: &mut dyn FnMut(u32, Vec<T>) -> Result<(), E>,
) -> Result<(), E> {
    let rows = (BAND_PIXELS / size.width()).clamp(1, size.height());
    let abandoned = AtomicBool::new(false);
    let ended = &|| stop.load(Ordering::Relaxed) || abandoned.load(Ordering::Relaxed);
    pool.in_place_scope(|scope| {
        // Bounded, so that a slow delivery holds up the work and does not gather a picture.
        let (sender, receiver) = mpsc::sync_channel(4 * pool.current_num_threads());
        scope.spawn(move |_| {
            let firsts = (0..size.height()).step_by(rows as usize);
            firsts.par_bridge().for_each_with(sender, |sender, first| {
                if ended() {
                    return;
                }
                let count = rows.min(size.height() - first);
                let mut pixels = vec![T::default(); size.columns() * count as usize];
                trace(first, &mut pixels);
                // Nobody listens any more only if delivery has failed, and then nothing is left to do.
                let _ = sender.send((first, count, pixels));
            });
        });
        let mut early = BTreeMap::new();
        let mut next = 0;
        for (first, count, pixels) in receiver {
            early.insert(first, (count, pixels));
            while let Some((count, pixels)) = early.remove(&next) {
                if ended() {
                    return Err(BandsError::Interrupted.into());
                }
                deliver(next, pixels).inspect_err(|_| abandoned.store(true, Ordering::Relaxed))?;
                next += count;
            }
        }
        if next == size.height() { Ok(()) } else { Err(BandsError::Interrupted.into()) }
    })
}

#[cfg(test)]
mod tests {
    use core::sync::atomic::{AtomicBool, AtomicU32, Ordering};

    use super::{BandsError, bands, pool};
    use crate::picture::raster::Size;

    fn pattern(width: u32, first: u32, pixels: &mut [u32]) {
        // Early bands are slow, so that with several threads later ones finish first.
        if first.is_multiple_of(3) {
            std::thread::sleep(core::time::Duration::from_millis(2));
        }
        for (pixel, index) in pixels.iter_mut().zip(first * width..) {
            *pixel = index;
        }
    }

    #[test]
    fn rows_arrive_in_order_for_any_number_of_threads() {
        for (width, height) in [(1000, 50), (3, 1), (5000, 7), (1, 9000)] {
            for threads in [1, 2, 7] {
                let size = Size::new(width, height).expect("a small size");
                let pool = pool(Some(threads)).expect("threads");
                let mut seen = Vec::new();
                let trace = |first, pixels: &mut [u32]| pattern(width, first, pixels);
                let deliver = |first: u32, pixels: Vec<u32>| -> Result<(), BandsError> {
                    assert_eq!(first as usize * size.columns(), seen.len());
                    seen.extend(pixels);
                    Ok(())
                };
                bands(size, &pool, &AtomicBool::new(false), trace, deliver).expect("nothing stops it");
                assert!(seen.iter().copied().eq(0..width * height), "{size} with {threads} threads");
            }
        }
    }

    #[test]
    fn stopping_ends_the_work_early() {
        let size = Size::new(2048, 1000).expect("a size");
        let (stop, traced) = (AtomicBool::new(false), AtomicU32::new(0));
        let trace = |_, _: &mut [u8]| {
            traced.fetch_add(1, Ordering::Relaxed);
            std::thread::sleep(core::time::Duration::from_millis(1));
        };
        let deliver = |first, _| -> Result<(), BandsError> {
            stop.store(first >= 10, Ordering::Relaxed);
            Ok(())
        };
        let outcome = bands(size, &pool(Some(2)).expect("threads"), &stop, trace, deliver);
        assert!(matches!(outcome, Err(BandsError::Interrupted)), "{outcome:?}");
        assert!(traced.into_inner() < 100);
    }

    #[test]
    fn an_error_of_delivery_ends_the_work_and_comes_out() {
        let size = Size::new(2048, 1000).expect("a size");
        let traced = AtomicU32::new(0);
        let trace = |_, _: &mut [u8]| {
            traced.fetch_add(1, Ordering::Relaxed);
            std::thread::sleep(core::time::Duration::from_millis(1));
        };
        #[derive(Debug)]
        enum Ended {
            Bands,
            Delivery,
        }
        impl From<BandsError> for Ended {
            fn from(_: BandsError) -> Self {
                Self::Bands
            }
        }
        let deliver = |_, _| Err(Ended::Delivery);
        let outcome = bands(size, &pool(Some(2)).expect("threads"), &AtomicBool::new(false), trace, deliver);
        assert!(matches!(outcome, Err(Ended::Delivery)), "{outcome:?}");
        assert!(traced.into_inner() < 100);
    }
}
