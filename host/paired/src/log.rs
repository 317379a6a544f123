//! The log of numbers that run in lock step: one for each thread, written only while [`record`] runs.

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

/// An operation, its result and its error.
#[derive(Clone, Copy, Debug)]
pub struct Operation {
    /// The name of the method, or the operator's sign.
    pub name: &'static str,
    /// The place in the tracer's source.
    pub place: &'static Location<'static>,
    /// The ray of the tree, counted from 0 in the order in which they are traced.
    pub ray: usize,
    /// The result in the format and in `f64`; of a vector the component that is farthest off.
    pub result: [f64; 2],
    /// Error of the result, in units of its last place.
    pub error: f64,
    /// The kind of number.
    pub kind: Kind,
    /// Size of the result in the format; of a vector, of the largest component.
    pub size: f64,
    /// The largest error of an operand, each in units of its own last place.
    pub operands: f64,
}

impl Operation {
    /// Returns the number of bits of the result that are wrong.
    #[must_use]
    pub fn bits_lost(&self) -> f64 {
        self.error.max(1.0).log2()
    }

    /// Returns how many more bits of the result are wrong than of the operands.
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
    /// The place in the tracer's source.
    pub place: &'static Location<'static>,
    /// The ray of the tree, counted from 0.
    pub ray: usize,
    /// The first operand, in the format and in `f64`.
    pub left: [f64; 2],
    /// The second operand.
    pub right: [f64; 2],
}

/// All operations and flipped decisions, in their order.
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

/// Runs `body` and returns its result with the log of this thread. A recording within another one does not add to it.
pub fn record<R>(body: impl FnOnce() -> R) -> (R, Log) {
    let outer = LOG.replace(Some(Log::default()));
    let result = body();
    let log = LOG.replace(outer).unwrap_or_default();
    (result, log)
}

/// Runs `body` without recording it.
pub fn pause<R>(body: impl FnOnce() -> R) -> R {
    let log = LOG.take();
    let result = body();
    LOG.set(log);
    result
}

/// Sets the ray to which the operations that follow belong.
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
