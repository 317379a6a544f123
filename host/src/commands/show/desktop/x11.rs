//! The desktop under X11: a connection of the program's own beside that of minifb.

use core::error::Error;
use core::time::Duration;
use std::time::Instant;

use minifb::{HasWindowHandle, Window};
use raw_window_handle::RawWindowHandle;
use x11rb::connection::Connection;
use x11rb::protocol::randr::ConnectionExt as _;
use x11rb::protocol::xproto::{
    AtomEnum, ClientMessageEvent, ConfigureWindowAux, ConnectionExt as _, EventMask, PropMode,
};
use x11rb::rust_connection::RustConnection;
use x11rb::wrapper::ConnectionExt as _;

x11rb::atom_manager! {
    /// The names that window managers and programs have agreed on (Extended Window Manager Hints 1.5).
    Atoms: AtomsCookie {
        _NET_SUPPORTED,
        _NET_WM_STATE,
        _NET_WM_STATE_FULLSCREEN,
        WM_STATE,
    }
}

/// Instance and class of the window (ICCCM 2.0, 4.1.2.5), each ended by a zero.
const CLASS: &[u8] = b"rta\0rta\0";
/// The change of a state that a client asks for: it is removed where it is set, and set where it is not.
const TOGGLE: u32 = 2;
/// A request that comes from an application itself.
const FROM_APPLICATION: u32 = 1;
/// The window manager's list of what it supports is read up to this many atoms.
const MOST_SUPPORTED: u32 = 4096;

/// The state of a window that is neither iconified nor withdrawn.
const NORMAL: u32 = 1;
/// The longest time that a window manager is given to take a window in or let it go.
const REPLY: Duration = Duration::from_millis(300);

/// A rectangle of the screen.
#[derive(Clone, Copy, Debug)]
struct Rectangle {
    x: i32,
    y: i32,
    width: u32,
    height: u32,
}

/// A window and the connection to its server.
#[derive(Debug)]
pub(super) struct Session {
    connection: RustConnection,
    atoms: Atoms,
    root: u32,
    window: u32,
    /// Where the window was before it filled the screen, if no window manager keeps that.
    before: Option<Rectangle>,
}

/// Returns width and height of the first screen.
pub(super) fn screen() -> Option<(usize, usize)> {
    let (connection, number) = x11rb::connect(None).ok()?;
    let root = connection.setup().roots.get(number)?.root;
    let Rectangle { width, height, .. } = monitors(&connection, root).ok()?.into_iter().next()?;
    Some((width as usize, height as usize))
}

/// Returns the monitors, the primary one first; where the server knows none, the whole screen.
fn monitors(connection: &RustConnection, root: u32) -> Result<Vec<Rectangle>, Box<dyn Error>> {
    let asked = || -> Result<_, Box<dyn Error>> { Ok(connection.randr_get_monitors(root, true)?.reply()?) };
    let mut monitors = asked().map(|reply| reply.monitors).unwrap_or_default();
    monitors.sort_by_key(|monitor| !monitor.primary);
    let place = |x: i16, y: i16, width: u16, height: u16| Rectangle {
        x: x.into(),
        y: y.into(),
        width: width.into(),
        height: height.into(),
    };
    if monitors.is_empty() {
        let whole = connection.get_geometry(root)?.reply()?;
        return Ok(vec![place(0, 0, whole.width, whole.height)]);
    }
    Ok(monitors
        .into_iter()
        .map(|monitor| place(monitor.x, monitor.y, monitor.width, monitor.height))
        .collect())
}

impl Session {
    /// Returns the session of a window; none if it is not a window of an X server.
    pub(super) fn of(window: &Window) -> Option<Self> {
        let RawWindowHandle::Xlib(handle) = window.window_handle().ok()?.as_raw() else { return None };
        Self::new(u32::try_from(handle.window).ok()?).ok()
    }

    fn new(window: u32) -> Result<Self, Box<dyn Error>> {
        let (connection, number) = x11rb::connect(None)?;
        let root = connection.setup().roots.get(number).ok_or("no screen")?.root;
        let atoms = Atoms::new(&connection)?.reply()?;
        let (property, kind) = (AtomEnum::WM_CLASS, AtomEnum::STRING);
        connection.change_property8(PropMode::REPLACE, window, property, kind, CLASS)?.check()?;
        let session = Self { connection, atoms, root, window, before: None };
        session.appear_again()?;
        Ok(session)
    }

    /// Lets a window manager take notice of the class: it reads the class of a window when the window appears, which minifb has let
    /// it do already.
    fn appear_again(&self) -> Result<(), Box<dyn Error>> {
        if !self.is_managed()? {
            return Ok(());
        }
        self.awaits_state(true)?;
        self.connection.unmap_window(self.window)?.check()?;
        let withdrawn = self.awaits_state(false);
        self.connection.map_window(self.window)?.check()?;
        withdrawn
    }

    /// Waits until the window manager has taken the window in, or let it go (ICCCM 2.0, 4.1.4), but not for long: some do not say.
    fn awaits_state(&self, is_in: bool) -> Result<(), Box<dyn Error>> {
        let (state, begun) = (self.atoms.WM_STATE, Instant::now());
        while begun.elapsed() < REPLY {
            let asked = self.connection.get_property(false, self.window, state, AtomEnum::ANY, 0, 1)?;
            let normal = asked.reply()?.value32().is_some_and(|mut words| words.next() == Some(NORMAL));
            if normal == is_in {
                break;
            }
            std::thread::sleep(REPLY / 100);
        }
        Ok(())
    }

    /// Asks the window manager to let the window fill its monitor, or to give it back its place. Where no window manager can, the
    /// window is moved and resized here.
    pub(super) fn toggle_full_screen(&mut self) -> Result<(), Box<dyn Error>> {
        if self.before.is_none() && self.is_managed()? {
            let data = [TOGGLE, self.atoms._NET_WM_STATE_FULLSCREEN, 0, FROM_APPLICATION, 0];
            let message = ClientMessageEvent::new(32, self.window, self.atoms._NET_WM_STATE, data);
            let mask = EventMask::SUBSTRUCTURE_REDIRECT | EventMask::SUBSTRUCTURE_NOTIFY;
            self.connection.send_event(false, self.root, mask, message)?.check()?;
            return Ok(());
        }
        let target = match self.before.take() {
            Some(before) => before,
            None => {
                let place = self.place()?;
                self.before = Some(place);
                self.monitor(place)?
            }
        };
        let Rectangle { x, y, width, height } = target;
        let there = ConfigureWindowAux::new().x(x).y(y).width(width).height(height);
        self.connection.configure_window(self.window, &there)?.check()?;
        Ok(())
    }

    /// Returns whether a window manager says that it can let windows fill the screen.
    fn is_managed(&self) -> Result<bool, Box<dyn Error>> {
        let Atoms { _NET_SUPPORTED: supported, _NET_WM_STATE_FULLSCREEN: full, .. } = self.atoms;
        let kind = AtomEnum::ATOM;
        let asked = self.connection.get_property(false, self.root, supported, kind, 0, MOST_SUPPORTED)?;
        let reply = asked.reply()?;
        Ok(reply.value32().is_some_and(|mut atoms| atoms.any(|atom| atom == full)))
    }

    /// Returns where the window is on the screen.
    fn place(&self) -> Result<Rectangle, Box<dyn Error>> {
        let geometry = self.connection.get_geometry(self.window)?.reply()?;
        let corner = self.connection.translate_coordinates(self.window, self.root, 0, 0)?.reply()?;
        let (width, height) = (geometry.width.into(), geometry.height.into());
        Ok(Rectangle { x: corner.dst_x.into(), y: corner.dst_y.into(), width, height })
    }

    /// Returns the monitor on which the middle of a window is, else the first.
    fn monitor(&self, window: Rectangle) -> Result<Rectangle, Box<dyn Error>> {
        let monitors = monitors(&self.connection, self.root)?;
        let half = |length: u32| i32::try_from(length / 2).unwrap_or(0);
        let (x, y) = (window.x + half(window.width), window.y + half(window.height));
        let has = |monitor: &&Rectangle| {
            let within = |at: i32, from: i32, length: u32| {
                u32::try_from(at - from).is_ok_and(|distance| distance < length)
            };
            within(x, monitor.x, monitor.width) && within(y, monitor.y, monitor.height)
        };
        let found = monitors.iter().find(has).or(monitors.first()).copied();
        Ok(found.ok_or("no monitor")?)
    }
}
