//! Time by a counter of few bits.

/// Adds up what a counter counts. It must be looked at before it has gone round once.
pub struct Elapsed<R> {
    read: R,
    mask: u32,
    last: u32,
    total: u64,
}

impl<R: FnMut() -> u32> Elapsed<R> {
    /// Begins now. `read` returns the counter, which counts up in as many bits as `mask` has.
    pub fn new(mask: u32, mut read: R) -> Self {
        let last = read() & mask;
        Self { read, mask, last, total: 0 }
    }

    /// Looks at the counter, and returns what it has counted since the beginning.
    pub fn look(&mut self) -> u64 {
        let now = (self.read)() & self.mask;
        self.total += u64::from(now.wrapping_sub(self.last) & self.mask);
        self.last = now;
        self.total
    }
}
