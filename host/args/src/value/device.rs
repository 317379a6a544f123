//! The three devices of the thesis, and what each of them can show.

use core::fmt;

use clap::ValueEnum;
use clap::builder::PossibleValue;
use rta_drivers::display::Capabilities;

use super::degrees::PixelsPerDegree;
use super::raster::Size;

/// A display of 1990.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Device {
    /// IBM PS/2, mode 13h: 320x200, 256 colours of 262144, screen 4:3.
    Vga,
    /// IBM RT PC with graPHIGS: 1024x1024, 128 colours of 4096.
    Graphigs,
    /// SUN SPARCstation with PIXRECT: 1152x900, 256 colours of 16777216.
    Pixrect,
}

impl Device {
    /// Returns the capabilities that its driver states.
    #[must_use]
    pub const fn capabilities(self) -> Capabilities {
        match self {
            Self::Vga => rta_drivers::vga13h::CAPABILITIES,
            Self::Graphigs => rta_drivers::graphigs::CAPABILITIES,
            Self::Pixrect => rta_drivers::pixrect::CAPABILITIES,
        }
    }

    /// Returns the raster of the whole screen.
    #[must_use]
    pub fn size(self) -> Size {
        let Capabilities { width, height, .. } = self.capabilities();
        Size::clamped(width, height)
    }

    /// Returns how many of its pixels one degree of the visual field holds for somebody who sits 60 cm before the screen, where a
    /// degree is 10.5 mm: of a 14 inch tube that shows 320 columns on 26 cm, of the IBM 5081 with 1024 on 28 cm, of a Sun's 19 inch
    /// tube with 1152 on 35 cm.
    #[must_use]
    pub const fn pixels_per_degree(self) -> PixelsPerDegree {
        PixelsPerDegree(match self {
            Self::Vga => 13.0,
            Self::Graphigs => 38.0,
            Self::Pixrect => 35.0,
        })
    }

    /// Width over height of the whole screen.
    #[must_use]
    pub fn aspect(self) -> f64 {
        let (width, height) = self.capabilities().aspect;
        f64::from(width) / f64::from(height)
    }
}

impl fmt::Display for Device {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Vga => "vga",
            Self::Graphigs => "graphigs",
            Self::Pixrect => "pixrect",
        })
    }
}

/// The display that a picture is made for, if any.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// On a device, through its colour table.
    On(Device),
    /// On no device: every pixel keeps its own colour.
    None,
}

impl Target {
    /// The device whose raster and shape a picture without a device has, unless others are asked for.
    const NO_DEVICE: Device = Device::Vga;

    /// The raster of a whole picture.
    #[must_use]
    pub fn size(self) -> Size {
        self.device().unwrap_or(Self::NO_DEVICE).size()
    }

    /// Width over height of the screen that a whole picture fills.
    #[must_use]
    pub fn aspect(self) -> f64 {
        self.device().unwrap_or(Self::NO_DEVICE).aspect()
    }

    /// The device, if there is one.
    #[must_use]
    pub const fn device(self) -> Option<Device> {
        match self {
            Self::On(device) => Some(device),
            Self::None => None,
        }
    }

    /// Returns the display after this one, in a circle: the three devices, and none.
    #[must_use]
    pub const fn next(self) -> Self {
        match self {
            Self::On(Device::Vga) => Self::On(Device::Graphigs),
            Self::On(Device::Graphigs) => Self::On(Device::Pixrect),
            Self::On(Device::Pixrect) => Self::None,
            Self::None => Self::On(Device::Vga),
        }
    }
}

impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::On(device) => device.fmt(f),
            Self::None => f.write_str("none"),
        }
    }
}

impl ValueEnum for Target {
    fn value_variants<'a>() -> &'a [Self] {
        &[Self::On(Device::Vga), Self::On(Device::Graphigs), Self::On(Device::Pixrect), Self::None]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        match self {
            Self::On(device) => device.to_possible_value(),
            Self::None => Some(
                PossibleValue::new("none")
                    .help("No display: 8 bits a gun without a colour table, or linear light"),
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Device, Target};

    #[test]
    fn every_device_has_its_raster_and_shape_and_none_is_in_the_circle() {
        let mut target = Target::On(Device::Vga);
        for (size, aspect) in [("320x200", 4.0 / 3.0), ("1024x1024", 1.0), ("1152x900", 1.28)] {
            assert!(target.device().is_some());
            assert_eq!(target.size().to_string(), size);
            assert!((target.aspect() - aspect).abs() < 1e-12);
            target = target.next();
        }
        assert_eq!((target, target.next()), (Target::None, Target::On(Device::Vga)));
    }
}
