//! The displays of the tracer: from the levels of three guns to light on a screen.
//!
//! Each layer is one trait and knows only the one below it:
//!
//! ```text
//! painter     Painter<Display, ColorTable>      gun levels in, a picture out
//! quantize    ColorTable: Uniform, Adaptive     gun levels to an index of the colour table
//! display     Display, ReadBack                 a colour table and a raster of indices
//!   vga13h      Mode13h          over bus::{Ports, Memory}       registers of a VGA
//!   graphigs    GraphigsDisplay  over graphigs::Graphigs         calls of the graPHIGS API
//!   pixrect     PixrectDisplay   over pixrect::Pixrect           operations of SunOS's PIXRECT
//!                 Cgthree        over bus::{Registers, Memory}   registers of the Sun frame buffer
//! bus         Ports, Memory, Registers          what a board has to supply
//! ```
//!
//! Under each device is an emulated one (`vga13h::emulated`, `graphigs::emulated`, `pixrect::emulated`): a
//! state machine of the real register file or of the API, which programs and tests run on where there is
//! no such machine. On the real machine the same driver runs over a bus that its firmware implements.
//!
//! Nothing here needs a heap, an operating system or `unsafe`.
//!
//! # A driver for another display
//!
//! Implement [`display::Display`]: what the screen can show, how a colour is loaded, how a row of indices is
//! written. That is all that [`painter::Painter`] and the colour tables ask for.
//!
//! ```
//! use rta_core::color::Rgb;
//! use rta_drivers::display::{Capabilities, Display, DriverError};
//! use rta_drivers::painter::Painter;
//! use rta_drivers::quantize::Adaptive;
//! # use core::convert::Infallible;
//!
//! /// Four greens on 4 x 2 pixels.
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

#![no_std]
#![forbid(unsafe_code)]
#![deny(clippy::float_arithmetic)]

pub mod bus;
pub mod checksum;
pub mod display;
pub mod graphigs;
pub mod painter;
pub mod pixrect;
pub mod quantize;
pub mod vga13h;
