//! An STM32F411 "Black Pill" (Cortex-M4F) with an ILI9341 of 240 x 320 pixels, held sideways.
//!
//! | ILI9341 | STM32F411 |
//! | --- | --- |
//! | SCK | PA5 (SPI1) |
//! | SDI | PA7 (SPI1) |
//! | CS | PA4 |
//! | D/C | PA3 |
//! | RESET | PA2 |
//!
//! The board's light, PC13, which is on when the pin is low, is on once the picture stands. It blinks where there is none.

#![no_std]
#![no_main]

use core::panic::PanicInfo;

use cortex_m_rt::entry;
use embedded_hal::delay::DelayNs;
use embedded_hal::spi::MODE_0;
use embedded_hal_bus::spi::ExclusiveDevice;
use spi_picture::{Failure, ili9341};
use stm32f4xx_hal::pac::{self, SPI1};
use stm32f4xx_hal::prelude::*;
use stm32f4xx_hal::rcc::Config;
use stm32f4xx_hal::spi::Spi;

#[entry]
fn main() -> ! {
    let Some(pac) = pac::Peripherals::take() else { stop() };
    // The board's crystal has 25 MHz.
    let mut rcc = pac.RCC.freeze(Config::hse(25.MHz()).sysclk(96.MHz()));
    let mut delay = pac.TIM5.delay_us(&mut rcc);
    let (a, c) = (pac.GPIOA.split(&mut rcc), pac.GPIOC.split(&mut rcc));
    let mut light = c.pc13.into_push_pull_output_in_state(stm32f4xx_hal::gpio::PinState::High);

    let pins = (Some(a.pa5), SPI1::NoMiso, Some(a.pa7));
    // The ILI9341's data sheet allows a write cycle of 100 ns; modules take several times as much.
    let spi = Spi::new(pac.SPI1, pins, MODE_0, 24.MHz(), &mut rcc);
    let Ok(spi) = ExclusiveDevice::new_no_delay(spi, a.pa4.into_push_pull_output());
    let (dc, reset) = (a.pa3.into_push_pull_output(), a.pa2.into_push_pull_output());

    let drawn: Result<(), Failure> = ili9341(spi, dc, reset, &mut delay);
    light.set_low();
    loop {
        delay.delay_ms(250);
        if drawn.is_err() {
            light.toggle();
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
