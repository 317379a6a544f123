//! What happened while numbers ran in lock step: a log for each thread, written only while [`record`] runs.

use core::cell::RefCell;
use core::panic::Location;

/// The kinds of numbers, each with its own range.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// A length.
    Length,
    /// The square of a length.
    Square,
    /// A component of a unit vector, a coefficient.
    Unit,
    /// A radiance.
    Light,
}

/// An operation and what it lost.
#[derive(Clone, Copy, Debug)]
pub struct Operation {
    /// The method of the scalar or vector, or the sign.
    pub name: &'static str,
    /// Where in the tracer.
    pub place: &'static Location<'static>,
    /// Which ray of the tree, counted from 0 in the order they are followed.
    pub ray: usize,
    /// The result in the format and in `f64`; of a vector the component that is farthest off.
    pub result: [f64; 2],
    /// Error of the result, in units of its last place.
    pub error: f64,
    /// What kind of number it is.
    pub kind: Kind,
    /// Size of the result in the format; of a vector, of the largest component.
    pub size: f64,
    /// The largest error of what went in, each in units of its own last place.
    pub operands: f64,
}

impl Operation {
    /// Bits of the result that are wrong.
    #[must_use]
    pub fn bits_lost(&self) -> f64 {
        self.error.max(1.0).log2()
    }

    /// By how many bits the result is worse than what went in.
    #[must_use]
    pub fn growth(&self) -> f64 {
        self.bits_lost() - self.operands.max(1.0).log2()
    }
}

/// A decision that `f64` would have taken differently.
#[derive(Clone, Copy, Debug)]
pub struct Flip {
    /// The comparison's sign, or the method that decides.
    pub question: &'static str,
    /// Where in the tracer.
    pub place: &'static Location<'static>,
    /// Which ray of the tree.
    pub ray: usize,
    /// The first operand, in the format and in `f64`.
    pub left: [f64; 2],
    /// The second operand.
    pub right: [f64; 2],
}

/// All that was recorded, in its order.
#[derive(Clone, Debug, Default)]
pub struct Log {
    /// Operations.
    pub operations: Vec<Operation>,
    /// Flipped decisions. Not each of them changes the ray tree: many searches are only cut short.
    pub flips: Vec<Flip>,
    ray: usize,
}

thread_local! {
    static LOG: RefCell<Option<Log>> = const { RefCell::new(None) };
}

/// Runs `body`, and gives what was recorded of it on this thread. A recording inside another one is apart from it.
pub fn record<R>(body: impl FnOnce() -> R) -> (R, Log) {
    let outer = LOG.replace(Some(Log::default()));
    let result = body();
    let log = LOG.replace(outer).unwrap_or_default();
    (result, log)
}

/// Runs `body` without recording it.
pub(super) fn pause<R>(body: impl FnOnce() -> R) -> R {
    let log = LOG.take();
    let result = body();
    LOG.set(log);
    result
}

/// From now on it is about that ray.
pub(super) fn enter(ray: usize) {
    with(|log| log.ray = ray);
}

fn with(write: impl FnOnce(&mut Log)) {
    LOG.with_borrow_mut(|log| {
        if let Some(log) = log {
            write(log);
        }
    });
}

#[track_caller]
pub(super) fn operation(
    name: &'static str,
    (kind, size): (Kind, f64),
    result: [f64; 2],
    error: f64,
    operands: impl IntoIterator<Item = f64>,
) {
    let place = Location::caller();
    with(|log| {
        let operands = operands.into_iter().fold(0.0, f64::max);
        // A quantity that is infinite in a float (a reciprocal of nothing) is never used.
        if error.is_finite() && operands.is_finite() {
            log.operations.push(Operation { name, place, ray: log.ray, result, error, kind, size, operands });
        }
    });
}

#[track_caller]
pub(super) fn decision<R: PartialEq>(
    question: &'static str,
    left: [f64; 2],
    right: [f64; 2],
    format: R,
    twin: R,
) {
    if format != twin {
        let place = Location::caller();
        with(|log| log.flips.push(Flip { question, place, ray: log.ray, left, right }));
    }
}
