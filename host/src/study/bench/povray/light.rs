//! What else there may be in a picture than Whitted's rays.

use super::lit::Radiosity;
use super::spread::Spread;

/// What else there is than Whitted's rays.
#[derive(Clone, Copy)]
pub(super) enum Light<'l> {
    /// Nothing.
    Still,
    /// Rays are spread.
    Spread(&'l Spread),
    /// Light goes round.
    Round(&'l Radiosity),
}

impl<'l> Light<'l> {
    /// Returns how rays are spread, if they are.
    pub(super) const fn spread(self) -> Option<&'l Spread> {
        if let Self::Spread(spread) = self { Some(spread) } else { None }
    }

    /// Returns how light goes round, if it does.
    pub(super) const fn round(self) -> Option<&'l Radiosity> {
        if let Self::Round(radiosity) = self { Some(radiosity) } else { None }
    }

    /// Returns the places along each side of lamps that are parallelograms, where they have a size.
    pub(super) fn places(self) -> Option<u16> {
        self.spread().map(|spread| spread.lamp).or(self.round().map(|radiosity| radiosity.lamp))
    }
}
