//! The displays of the ray tracer: from the levels of red, green and blue to pixels on a screen.
//!
//! A display of the early 1990s shows few colours at once. It keeps them in a colour table, and a pixel is the index
//! of an entry. This crate holds what turns a picture into indices, and drivers for the three machines of the thesis
//! on which the ray tracer is modelled ("Modelos matemáticos de iluminación para la síntesis de imagen", UNAM): an
//! IBM PS/2 with a VGA in mode 13h, an IBM RT PC with graPHIGS, and a SUN SPARCstation with PIXRECT. A fourth is of our century: the OLED of
//! a microcontroller's evaluation board, which shows 16 greys.
//!
//! It is `no_std`, and nothing in it needs a heap, an operating system, floating point or `unsafe`.
//!
//! # Layers
//!
//! Each layer knows only the one below it, through a trait:
//!
//! ```text
//! painter     Painter<Display, ColorTable, _>   rows of light in, a picture out
//! dither      Dither: Plain, Diffusion, Ordered spreads what rounding loses over the pixels nearby
//! quantize    ColorTable: Uniform, Palette,     light to an index of the colour table
//!             Adaptive
//! display     Display, ReadBack                 a colour table and a raster of indices
//!   vga13h      Mode13h          over bus::{Ports, Memory}       registers of a VGA
//!   graphigs    GraphigsDisplay  over graphigs::Graphigs         calls of the graPHIGS API
//!   pixrect     PixrectDisplay   over pixrect::Pixrect           operations of SunOS's PIXRECT
//!                 Cgthree        over bus::{Registers, Memory}   registers of the Sun frame buffer
//! bus         Ports, Memory, Registers          what a machine has to supply
//! ```
//!
//! Displays without a colour table have layers of their own, which share the dithering:
//!
//! ```text
//! direct      DirectPainter<DirectDisplay, _>   rows of light in, a picture out
//! dither      DirectDither: Plain, Bayer, Diffusion
//! direct      DirectDisplay                     a raster of levels, of three guns or of one
//!   ssd0323     Ssd0323 over bus::CommandData     commands of an OLED's controller
//!   target      Target over any DrawTarget        of embedded-graphics (feature `embedded-graphics`)
//! ```
//!
//! [`checksum::Checksum`] is a [`display::Display`] that wraps another one and hashes what is sent to it: the test of a
//! port to another machine.
//!
//! Each device has an emulated counterpart (`vga13h::emulated`, `graphigs::emulated`, `pixrect::emulated`, `ssd0323::emulated`). It is a
//! state machine of the real registers or of the API, on which programs and tests run where there is no such machine.
//! On a real machine the same driver runs over a bus that the firmware implements.
//!
//! Where to begin depends on what you have:
//!
//! - a picture to be shown on one of the three devices: [`painter::Painter`] has an example;
//! - another display: read on below, "For authors of a driver", or [`direct`] if it has no colour table;
//! - another machine with one of these devices: see "For authors of a bus".
//!
//! # For authors of a driver
//!
//! Implement [`display::Display`] for your device. It has three required methods: what the screen can show
//! (`capabilities`), how entries of the colour table are loaded (`set_colors`), and how indices are written into a row
//! (`put_pixels`). [`painter::Painter`] and the colour tables ask for no more. The methods of
//! [`display::Capabilities`] do the checks that every driver owes its caller.
//!
//! If the device is reached by ports, registers or a window of memory, be generic over the traits of [`bus`], as
//! [`vga13h::Mode13h`] is; then the driver can be tested without the device. If it can be read, implement
//! [`display::ReadBack`] too. `examples/terminal.rs` draws a scene on a driver for a terminal.
//!
//! ```
//! use rta_core::color::Rgb;
//! use rta_drivers::display::{Capabilities, Display, DriverError};
//! use rta_drivers::painter::Painter;
//! use rta_drivers::quantize::Adaptive;
//! # use core::convert::Infallible;
//!
//! /// A screen of 4 x 2 pixels that shows four levels of green.
//! #[derive(Default)]
//! struct Handheld {
//!     palette: [u8; 4],
//!     pixels: [[u8; 4]; 2],
//! }
//!
//! impl Display for Handheld {
//!     type Error = DriverError<Infallible>;
//!
//!     fn capabilities(&self) -> Capabilities {
//!         Capabilities { width: 4, height: 2, colors: 4, gun_max: 3, aspect: (2, 1) }
//!     }
//!
//!     fn set_colors(&mut self, first: u8, colors: &[Rgb<u8>]) -> Result<(), Self::Error> {
//!         self.capabilities().check_colors(first, colors)?;
//!         for (entry, color) in self.palette[usize::from(first)..].iter_mut().zip(colors) {
//!             *entry = color.g;
//!         }
//!         Ok(())
//!     }
//!
//!     fn put_pixels(&mut self, x: u32, y: u32, indices: &[u8]) -> Result<(), Self::Error> {
//!         self.capabilities().check_pixels(x, y, indices.len())?;
//!         let row = &mut self.pixels[y as usize];
//!         row[x as usize..][..indices.len()].copy_from_slice(indices);
//!         Ok(())
//!     }
//! }
//!
//! let mut painter = Painter::new(Handheld::default(), Adaptive::new(4)?)?;
//! painter.put_row(0, 1, [0, 3, 1, 3].map(|g| Rgb::new(0, g, 0)))?;
//! let (handheld, _) = painter.into_parts();
//! assert_eq!(handheld.palette, [0, 3, 1, 0]);
//! assert_eq!(handheld.pixels[1], [0, 1, 2, 1]);
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```
//!
//! # For authors of a bus
//!
//! Implement the traits of [`bus`] that the driver asks for, on the type of your firmware that owns the device:
//! [`bus::Ports`] and [`bus::Memory`] for a VGA, [`bus::Registers`] and [`bus::Memory`] for a cgthree, [`bus::CommandData`] for an SSD0323.
//! Nothing else of the crate has to change. [`bus`] says what an implementation must guarantee; `tests/boards/pc`, `tests/boards/sparc` and
//! `tests/boards/cortex-m` of the repository hold the buses of three machines that boot.
//!
//! In this example an array stands for the video memory, and the ports are only counted. On a PC the methods would
//! execute `out` and `in`, and access A0000h with `write_volatile` and `read_volatile`.
//!
//! ```
//! use rta_drivers::bus::{Memory, Ports};
//! use rta_drivers::display::Display;
//! use rta_drivers::vga13h::Mode13h;
//!
//! struct Machine {
//!     port_writes: u32,
//!     window: [u8; 0x1_0000],
//! }
//!
//! impl Ports for Machine {
//!     fn out8(&mut self, _port: u16, _value: u8) {
//!         self.port_writes += 1;
//!     }
//!     fn in8(&mut self, _port: u16) -> u8 {
//!         0xFF // nobody answers
//!     }
//! }
//!
//! impl Memory for Machine {
//!     fn write(&mut self, offset: u32, bytes: &[u8]) {
//!         // `zip` ends with the window: bytes beyond it are not written.
//!         self.window.iter_mut().skip(offset as usize).zip(bytes).for_each(|(to, from)| *to = *from);
//!     }
//!     fn read(&mut self, offset: u32, bytes: &mut [u8]) {
//!         for (at, byte) in (offset as usize..).zip(bytes) {
//!             *byte = self.window.get(at).copied().unwrap_or(0xFF);
//!         }
//!     }
//! }
//!
//! let mut screen = Mode13h::after_bios(Machine { port_writes: 0, window: [0; 0x1_0000] });
//! screen.put_pixels(10, 2, &[7])?;
//! let machine = screen.release();
//! assert_eq!(machine.window[2 * 320 + 10], 7);
//! assert_eq!(machine.port_writes, 1); // the pel mask
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```

#![no_std]
#![forbid(unsafe_code)]
#![deny(clippy::float_arithmetic)]

pub mod bus;
pub mod checksum;
pub mod direct;
pub mod display;
pub mod dither;
pub mod graphigs;
pub mod guns;
pub mod painter;
pub mod pixrect;
pub mod quantize;
pub mod ssd0323;
#[cfg(feature = "embedded-graphics")]
pub mod target;
pub mod vga13h;

/// The code of the README, compiled and run with the other examples.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
