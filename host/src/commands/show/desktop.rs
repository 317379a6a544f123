//! What a window needs of the desktop and minifb does not have: the size of the screen, full screen, and the class by which
//! window managers know the program. They are to be had on X11 alone.

use minifb::Window;

#[cfg(all(unix, not(target_os = "macos")))]
mod x11;
#[cfg(all(unix, not(target_os = "macos")))]
use x11 as system;

/// Where there is no X11 there is nothing to ask.
#[cfg(not(all(unix, not(target_os = "macos"))))]
mod system {
    use minifb::Window;

    pub(super) fn screen() -> Option<(usize, usize)> {
        None
    }

    #[derive(Debug)]
    pub(super) enum Session {}

    impl Session {
        pub(super) fn of(_window: &Window) -> Option<Self> {
            None
        }

        pub(super) fn toggle_full_screen(&mut self) -> Result<(), Box<dyn core::error::Error>> {
            match *self {}
        }
    }
}

/// Returns width and height of the screen in pixels, where they are known; of several screens, of the one that is used first.
#[must_use]
pub fn screen() -> Option<(usize, usize)> {
    system::screen()
}

/// A window on its desktop.
#[derive(Debug)]
pub struct Desktop(Option<system::Session>);

/// Why the window does not fill the screen.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum DesktopError {
    /// The desktop is not X11.
    #[error("full screen is to be had on X11 alone")]
    NotX11,
    /// The X server refuses.
    #[error("no full screen: {0}")]
    Refused(Box<dyn core::error::Error>),
}

impl Desktop {
    /// Tells the desktop of which class the window is.
    #[must_use]
    pub fn of(window: &Window) -> Self {
        Self(system::Session::of(window))
    }

    /// Lets the window fill the screen, or gives it back the place that it had before.
    ///
    /// # Errors
    /// [`DesktopError`].
    pub fn toggle_full_screen(&mut self) -> Result<(), DesktopError> {
        let session = self.0.as_mut().ok_or(DesktopError::NotX11)?;
        session.toggle_full_screen().map_err(DesktopError::Refused)
    }
}
