//! A Raspberry Pi Pico (RP2040, Cortex-M0+) with an ST7789 of 240 x 320 pixels, held sideways.
//!
//! | ST7789 | Pico |
//! | --- | --- |
//! | SCL | GP18 (SPI0 SCK) |
//! | SDA | GP19 (SPI0 TX) |
//! | CS | GP17 |
//! | D/C | GP16 |
//! | RES | GP20 |
//!
//! The light of the Pico, GP25, is on once the picture stands. It blinks where there is none.

#![no_std]
#![no_main]

use core::panic::PanicInfo;

use embedded_hal::delay::DelayNs;
use embedded_hal::digital::{OutputPin, StatefulOutputPin};
use embedded_hal::spi::MODE_3;
use embedded_hal_bus::spi::ExclusiveDevice;
use rp2040_hal::clocks::init_clocks_and_plls;
use rp2040_hal::fugit::RateExtU32;
use rp2040_hal::gpio::{FunctionSpi, Pins};
use rp2040_hal::{Clock, Sio, Spi, Timer, Watchdog, entry, pac};
use spi_picture::{Failure, st7789};

/// What the boot ROM runs first: it makes the flash memory readable, whichever chip it is.
#[unsafe(link_section = ".boot2")]
#[used]
static BOOT2: [u8; 256] = rp2040_boot2::BOOT_LOADER_GENERIC_03H;

/// The Pico's crystal.
const CRYSTAL: u32 = 12_000_000;

#[entry]
fn main() -> ! {
    let Some(mut pac) = pac::Peripherals::take() else { stop() };
    let mut watchdog = Watchdog::new(pac.WATCHDOG);
    let clocks = init_clocks_and_plls(
        CRYSTAL,
        pac.XOSC,
        pac.CLOCKS,
        pac.PLL_SYS,
        pac.PLL_USB,
        &mut pac.RESETS,
        &mut watchdog,
    );
    let Ok(clocks) = clocks else { stop() };
    let mut timer = Timer::new(pac.TIMER, &mut pac.RESETS, &clocks);
    let sio = Sio::new(pac.SIO);
    let pins = Pins::new(pac.IO_BANK0, pac.PADS_BANK0, sio.gpio_bank0, &mut pac.RESETS);
    let mut light = pins.gpio25.into_push_pull_output();

    let serial = (pins.gpio19.into_function::<FunctionSpi>(), pins.gpio18.into_function::<FunctionSpi>());
    let spi = Spi::<_, _, _, 8>::new(pac.SPI0, serial);
    // The ST7789 takes 62.5 MHz, half of the processor's clock.
    let spi = spi.init(&mut pac.RESETS, clocks.peripheral_clock.freq(), 62_500_000.Hz(), MODE_3);
    let Ok(spi) = ExclusiveDevice::new(spi, pins.gpio17.into_push_pull_output(), timer);
    let (dc, reset) = (pins.gpio16.into_push_pull_output(), pins.gpio20.into_push_pull_output());

    let drawn: Result<(), Failure> = st7789(spi, dc, reset, &mut timer);
    let Ok(()) = light.set_high();
    loop {
        timer.delay_ms(250);
        if drawn.is_err() {
            let Ok(()) = light.toggle();
        }
    }
}

/// Nothing can be done, not even blinking.
fn stop() -> ! {
    loop {
        core::hint::spin_loop();
    }
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    stop()
}
