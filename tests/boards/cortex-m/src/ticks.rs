//! Retired instructions, by the SysTick timer.
//!
//! These processors do not count instructions. Under QEMU's `-icount shift=0` an instruction takes 1 ns of
//! the emulated clock, so the timer's period in nanoseconds is the number of instructions in a tick.
//! On a real board, or without `-icount`, the figure is time in nanoseconds.

use cortex_m::Peripherals;
use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;

/// Half nanoseconds in a tick: 16 MHz.
#[cfg(feature = "microbit")]
const HALVES: u64 = 125;
/// Half nanoseconds in a tick: 12.5 MHz.
#[cfg(feature = "lm3s6965evb")]
const HALVES: u64 = 160;
/// Half nanoseconds in a tick: 25 MHz.
#[cfg(feature = "mps2-an386")]
const HALVES: u64 = 80;

/// The timer counts down in 24 bits.
const MASK: u32 = 0xff_ffff;

/// Counts ticks: [`Ticks::read`] must be called at least once in 2^24 of them (0.67 G instructions or more).
pub struct Ticks {
    last: u32,
    sum: u64,
}

impl Ticks {
    /// Starts the timer.
    pub fn start() -> Self {
        // SAFETY: called once, and nothing else has the peripherals.
        let mut timer = unsafe { Peripherals::steal() }.SYST;
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(MASK);
        timer.clear_current();
        timer.enable_counter();
        Self { last: SYST::get_current(), sum: 0 }
    }

    /// Adds the ticks since the last call.
    pub fn read(&mut self) {
        let now = SYST::get_current();
        self.sum += u64::from(self.last.wrapping_sub(now) & MASK);
        self.last = now;
    }

    /// Instructions between the start and the last reading.
    pub fn instructions(&self) -> u64 {
        self.sum * HALVES / 2
    }
}
