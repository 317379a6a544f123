//! What is to be seen: the rows of the picture that are there, read back from the device, and below them the finest preview.

use rta_core::color::Rgb;
use rta_drivers::quantize::BACKGROUND;

use super::tracing::Part;
use crate::error::Error;
use crate::picture::coloring::Coloring;
use crate::picture::device::Device;
use crate::picture::error::PictureError;
use crate::picture::file::{Displayed, Pixels};
use crate::picture::raster::Size;
use crate::picture::screen::Screen;
use crate::request::Request;

/// A preview: every pixel stands for a block of the picture's. It never reaches the device, whose colour table is made from the
/// picture's own pixels, in their order.
#[derive(Debug)]
struct Preview {
    size: Size,
    colors: Vec<Rgb<u8>>,
}

/// The picture as far as it has been traced.
#[derive(Debug)]
pub struct Shown {
    /// The device, if there is one, and its colour table; none if every pixel keeps its own colour.
    display: Option<(Device, Coloring)>,
    /// The device once its colour table is known.
    screen: Option<Screen>,
    picture: Displayed,
    /// Rows of the picture that are there.
    rows: u32,
    /// From coarse to fine.
    previews: Vec<Preview>,
    /// Whether the device has rows that were not read back yet.
    stale: bool,
    /// The colours of which the device's colour table is made, and the columns of their grid: each pass makes it anew.
    samples: (Vec<Rgb<u8>>, u32),
    /// Samples of a pixel and estimated error, of a picture in passes.
    pass: Option<(u32, f64)>,
}

impl Shown {
    /// Switches the device of `request` on, with nothing on its screen; or goes on with `screen`, which has the frame before this one.
    ///
    /// # Errors
    /// Those of [`Request::raster`], [`PictureError::Display`] if the device does not start, and [`PictureError::Memory`].
    pub fn new(request: &Request, screen: Option<Screen>) -> Result<Self, Error> {
        let (size, aspect) = request.raster()?;
        let pixels = match request.target.device() {
            Some(_) => Pixels::Indexed { palette: vec![BACKGROUND], indices: vec![0; size.pixels()] },
            None => {
                let mut pixels = Vec::new();
                pixels.try_reserve_exact(size.pixels()).map_err(|_| PictureError::Memory(size))?;
                Pixels::Direct(pixels)
            }
        };
        let picture = Displayed { size, aspect, pixels };
        let display = request.target.device().map(|device| (device, request.coloring));
        let mut shown = Self {
            display,
            screen,
            picture,
            rows: 0,
            previews: Vec::new(),
            stale: false,
            samples: (Vec::new(), 0),
            pass: None,
        };
        if shown.screen.is_none() && request.coloring.samples() == 0 {
            shown.switch_on()?;
        }
        Ok(shown)
    }

    /// Switches the device on, if there is one, with a colour table that is made from the samples that are there.
    fn switch_on(&mut self) -> Result<(), Error> {
        if let Some(display) = self.display {
            let (samples, width) = &self.samples;
            self.screen = Some(Screen::of_samples(display, self.picture.shape(), (samples, *width))?);
            self.stale = true;
        }
        Ok(())
    }

    /// Reads the complete picture back, and lets go of the device.
    ///
    /// # Errors
    /// [`PictureError::Display`] if it does not answer.
    pub fn finish(&mut self) -> Result<Option<Screen>, Error> {
        self.refresh()?;
        Ok(self.screen.take())
    }

    /// Takes rows that have been traced.
    ///
    /// # Errors
    /// [`PictureError::Display`] if the device refuses them.
    pub fn put(&mut self, part: Part) -> Result<(), Error> {
        let (size, first, levels) = match part {
            Part::Rows { size, first, levels } => (size, first, levels),
            Part::Samples { light, width } => {
                self.samples = (light, width);
                return self.switch_on();
            }
            Part::Pass { samples, error, levels } => {
                self.begin_pass(samples, error)?;
                (self.picture.size, 0, levels)
            }
            Part::Ready(_) | Part::Complete(_) | Part::Failed(_) => return Ok(()),
        };
        if size != self.picture.size {
            if first == 0 {
                self.previews.push(Preview { size, colors: Vec::with_capacity(size.pixels()) });
            }
            if let Some(preview) = self.previews.last_mut() {
                preview.colors.extend(levels);
            }
            return Ok(());
        }
        let count = levels.len() / size.columns();
        match (&mut self.screen, &mut self.picture.pixels) {
            (Some(screen), _) => screen.put_rows(first, &levels)?,
            (None, Pixels::Direct(pixels)) => pixels.extend(levels),
            (None, Pixels::Indexed { .. }) => {}
        }
        self.stale = self.screen.is_some();
        self.rows = first + u32::try_from(count).unwrap_or(0);
        if self.rows == size.height() {
            self.previews.clear();
        }
        Ok(())
    }

    /// Makes room for the rows of a pass: they are dithered, and their colours chosen, as if there had been none before.
    fn begin_pass(&mut self, samples: u32, error: f64) -> Result<(), Error> {
        if self.pass.replace((samples, error)).is_some() {
            self.rows = 0;
            match &mut self.picture.pixels {
                Pixels::Direct(pixels) => pixels.clear(),
                Pixels::Indexed { .. } => self.switch_on()?,
            }
        }
        Ok(())
    }

    /// Returns the samples of a pixel and the estimated error of the last pass, if the picture has passes.
    #[must_use]
    pub const fn pass(&self) -> Option<(u32, f64)> {
        self.pass
    }

    /// Reads back what is on the device's screen.
    ///
    /// # Errors
    /// [`PictureError::Display`] if the device does not answer.
    pub fn refresh(&mut self) -> Result<(), Error> {
        if let (true, Some(screen)) = (self.stale, &mut self.screen) {
            self.picture = screen.picture()?;
            self.stale = false;
        }
        Ok(())
    }

    /// Returns the picture as it was read back last. Rows that are not there yet are black on a device, and missing without one.
    #[must_use]
    pub const fn picture(&self) -> &Displayed {
        &self.picture
    }

    /// Returns how many rows of the picture are there.
    #[must_use]
    pub const fn rows(&self) -> u32 {
        self.rows
    }

    /// Returns the colour in a column of a row: the picture's, else that of the finest preview that has it, else black.
    #[must_use]
    pub fn color(&self, x: usize, y: usize) -> Rgb<u8> {
        let size = self.picture.size;
        if y < self.rows as usize {
            let at = y * size.columns() + x;
            let color = match &self.picture.pixels {
                Pixels::Direct(pixels) => pixels.get(at),
                Pixels::Indexed { palette, indices } => {
                    indices.get(at).and_then(|index| palette.get(usize::from(*index)))
                }
            };
            return color.copied().unwrap_or_default();
        }
        let block = |preview: &Preview| {
            let row = y * preview.size.height() as usize / (size.height() as usize).max(1);
            let column = x * preview.size.columns() / size.columns().max(1);
            preview.colors.get(row * preview.size.columns() + column).copied()
        };
        self.previews.iter().rev().find_map(block).unwrap_or_default()
    }

    /// Returns the index of a pixel into the colour table, where there are a table and the pixel.
    #[must_use]
    pub fn index(&self, x: u32, y: u32) -> Option<u8> {
        match &self.picture.pixels {
            Pixels::Indexed { indices, .. } if y < self.rows => {
                indices.get(y as usize * self.picture.size.columns() + x as usize).copied()
            }
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use core::time::Duration;

    use rta_core::color::Rgb;

    use super::Shown;
    use crate::args::ShowArgs;
    use crate::commands::show::tracing::Part;
    use crate::picture::device::{Device, Target};
    use crate::picture::raster::Size;
    use crate::request::Request;

    fn shown(target: Target) -> Shown {
        let request = Request::of(&ShowArgs::default().tracing, target);
        let size = Some(Size::new(4, 4).expect("small"));
        Shown::new(&Request { size, ..request }, None).expect("it starts")
    }

    fn rows(side: u32, first: u32, levels: &[u8]) -> Part {
        let levels = levels.iter().map(|level| Rgb::new(*level, 0, 0)).collect();
        Part::Rows { size: Size::new(side, side).expect("small"), first, levels }
    }

    #[test]
    fn what_is_finer_hides_what_is_coarser_row_by_row() {
        for (target, full, half) in [(Target::None, 255, 128), (Target::On(Device::Vga), 255, 128)] {
            let mut shown = shown(target);
            let red = |shown: &Shown| -> Vec<u8> { (0..4).map(|y| shown.color(0, y).r).collect() };
            assert_eq!(red(&shown), [0; 4]);
            let bright = |level: u8| {
                if level == 0 {
                    0
                } else if level == full {
                    255
                } else {
                    130
                }
            };
            let near = |got: Vec<u8>, want: [u8; 4]| {
                assert!(got.iter().zip(want).all(|(a, b)| a.abs_diff(b) <= 2), "{got:?} {want:?}");
            };
            shown.put(rows(1, 0, &[half])).expect("taken");
            near(red(&shown), [bright(half); 4]);
            shown.put(rows(2, 0, &[full, 0])).expect("taken");
            near(red(&shown), [bright(full), bright(full), bright(half), bright(half)]);
            shown.put(Part::Samples { light: vec![Rgb::new(255, 0, 0)], width: 1 }).expect("taken");
            shown.put(rows(4, 0, &[0; 4])).expect("taken");
            shown.refresh().expect("it answers");
            near(red(&shown), [0, bright(full), bright(half), bright(half)]);
            assert_eq!((shown.rows(), shown.index(0, 1)), (1, None));
            assert_eq!(shown.index(0, 0).is_some(), target != Target::None);
            shown.put(rows(4, 1, &[full; 12])).expect("taken");
            shown.put(Part::Complete(Duration::ZERO)).expect("taken");
            shown.refresh().expect("it answers");
            near(red(&shown), [0, 255, 255, 255]);
            assert!(shown.previews.is_empty());
        }
    }
}
