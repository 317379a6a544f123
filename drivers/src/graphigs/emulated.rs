//! An emulated IBM RT PC with graPHIGS: one nucleus, one workstation of the type `RTPC`, one image board.
//!
//! It keeps the state of the API (whether graPHIGS, the workstation and a non-retained structure are open), two
//! colour tables (the one that was set, and the one in effect since the last GPUPWS), and the board.
//!
//! Where the reference says nothing, or asks for more than a picture needs, this is what it does:
//!
//! - The board is shown pixel for pixel, without GPDFI and image mappings; its origin is its lower left pixel.
//! - The workstation has the colour models RGB and CMY.
//! - The board is at most as large as the memory lent.
//! - The screen has seven planes (128 colours), so the eighth bit of a board's pixel is not shown.

mod board;

use rta_core::color::Rgb;

use super::{CAPABILITIES, ColorFacilities, ColorModel, GpError, Graphigs, Ibid, Ncid, ONE, Pair};
use super::{PixelArray, WorkstationType, Wsid};
use board::{Board, check_inside};

/// The one workstation type that the machine has.
pub const WORKSTATION_TYPE: WorkstationType = *b"RTPC    ";

/// Bytes of an image board of the size of the screen: 1 MiB.
pub const MEMORY_SIZE: usize = 1024 * 1024;

/// The one nucleus that the machine has.
const NUCLEUS: Ncid = Ncid(1);
/// Entries of the colour table.
const COLORS: usize = CAPABILITIES.colors as usize;
const BLACK: Rgb<u8> = Rgb::new(0, 0, 0);

/// The emulated machine, whose image board lies in memory that the caller lends; it takes 820 bytes at most itself.
#[derive(Clone, Debug)]
pub struct Workstation<M> {
    memory: M,
    /// graPHIGS is open.
    open: bool,
    /// The identifier of the workstation while it is open.
    workstation: Option<Wsid>,
    /// A non-retained structure was begun and not ended.
    drawing: bool,
    /// How the components of GPCR and GPQCR are read.
    model: ColorModel,
    /// The colour table as GPCR set it, levels of 0..=15.
    set: [Rgb<u8>; COLORS],
    /// The colour table that the screen shows: a copy of `set`, made at each GPUPWS.
    effective: [Rgb<u8>; COLORS],
    board: Option<Board>,
}

/// Returns the level, 0..=15, nearest to a component, which is a fraction of [`ONE`].
fn realize(component: u16) -> u8 {
    let (c, one, max) = (u32::from(component), u32::from(ONE), u32::from(CAPABILITIES.gun_max));
    ((c * max + one / 2) / one).to_le_bytes()[0]
}

impl<M: AsRef<[u8]> + AsMut<[u8]>> Workstation<M> {
    /// Makes a machine on which graPHIGS is closed. Its board will lie in `memory`, which must have
    /// [`MEMORY_SIZE`] bytes for one of the size of the screen.
    pub const fn new(memory: M) -> Self {
        Self {
            memory,
            open: false,
            workstation: None,
            drawing: false,
            model: ColorModel::Rgb,
            set: [BLACK; COLORS],
            effective: [BLACK; COLORS],
            board: None,
        }
    }

    /// Returns the levels of the guns, 0..=15 each, at the pixel in column `x` and row `y` from the upper left of
    /// the screen; `None` outside it. Beyond the board the colour of entry 0 is shown; while no workstation is open
    /// the screen is black.
    pub fn pixel(&self, x: u32, y: u32) -> Option<Rgb<u8>> {
        CAPABILITIES.check_pixels::<()>(x, y, 1).ok()?;
        if self.workstation.is_none() {
            return Some(BLACK);
        }
        let from_below = u64::from(CAPABILITIES.height - 1 - y);
        let offset = self.board.and_then(|board| board.offset(u64::from(x), from_below));
        let pixel = offset.and_then(|offset| self.memory.as_ref().get(offset)).copied().unwrap_or(0);
        self.effective.get(usize::from(pixel) % COLORS).copied()
    }

    /// Checks that graPHIGS is open.
    fn check_open(&self) -> Result<(), GpError> {
        if self.open { Ok(()) } else { Err(GpError::RequiresPhop) }
    }

    /// Checks that the workstation is open and has the identifier `wsid`.
    fn check_workstation(&self, wsid: Wsid) -> Result<(), GpError> {
        match self.workstation {
            None => Err(GpError::RequiresWsop),
            Some(open) if open != wsid => Err(GpError::Workstation),
            Some(_) => Ok(()),
        }
    }

    /// Returns the board if it exists and has the identifier `ibid`.
    fn check_board(&self, ibid: Ibid) -> Result<Board, GpError> {
        self.check_open()?;
        self.board.filter(|board| board.id == ibid).ok_or(GpError::Board)
    }

    /// Converts components of the current colour model to levels of red, green and blue, 0..=15.
    fn levels(&self, components: Rgb<u16>) -> Rgb<u8> {
        match self.model {
            ColorModel::Cmy => components.map(|c| realize(ONE - c)),
            _ => components.map(realize),
        }
    }
}

impl<M: AsRef<[u8]> + AsMut<[u8]>> Graphigs for Workstation<M> {
    fn gpopph(&mut self) -> Result<(), GpError> {
        if self.open {
            return Err(GpError::RequiresPhcl);
        }
        self.open = true;
        Ok(())
    }

    fn gpclph(&mut self) -> Result<(), GpError> {
        self.check_open()?;
        if self.workstation.is_some() {
            return Err(GpError::RequiresPhop);
        }
        self.open = false;
        self.board = None;
        Ok(())
    }

    fn gpopws(&mut self, wsid: Wsid, _connid: &str, wstype: WorkstationType) -> Result<(), GpError> {
        self.check_open()?;
        if wstype != WORKSTATION_TYPE {
            return Err(GpError::WorkstationType);
        }
        if self.workstation.is_some() {
            return Err(GpError::WorkstationInUse);
        }
        self.workstation = Some(wsid);
        self.model = ColorModel::Rgb;
        self.set = [BLACK; COLORS];
        self.effective = self.set;
        Ok(())
    }

    fn gpclws(&mut self, wsid: Wsid) -> Result<(), GpError> {
        self.check_workstation(wsid)?;
        self.workstation = None;
        self.drawing = false;
        Ok(())
    }

    fn gpupws(&mut self, wsid: Wsid) -> Result<(), GpError> {
        self.check_workstation(wsid)?;
        self.effective = self.set;
        Ok(())
    }

    fn gpqcf(&mut self, wstype: WorkstationType) -> Result<ColorFacilities, GpError> {
        self.check_open()?;
        if wstype != WORKSTATION_TYPE {
            return Err(GpError::WorkstationType);
        }
        let levels = u32::from(CAPABILITIES.gun_max) + 1;
        Ok(ColorFacilities {
            model: ColorModel::Rgb,
            available: levels * levels * levels,
            color: true,
            predefined: u32::from(CAPABILITIES.colors),
        })
    }

    fn gpcml(&mut self, wsid: Wsid, model: ColorModel) -> Result<(), GpError> {
        self.check_workstation(wsid)?;
        if !matches!(model, ColorModel::Rgb | ColorModel::Cmy) {
            return Err(GpError::ColorModel);
        }
        self.model = model;
        Ok(())
    }

    fn gpcr(&mut self, wsid: Wsid, index: u32, colors: &[Rgb<u16>]) -> Result<(), GpError> {
        self.check_workstation(wsid)?;
        if colors.is_empty() {
            return Err(GpError::NoIndexes);
        }
        let start = usize::try_from(index).unwrap_or(usize::MAX);
        if start.checked_add(colors.len()).is_none_or(|end| end > COLORS) {
            return Err(GpError::ColorIndex);
        }
        for (at, &color) in (start..).zip(colors) {
            let levels = self.levels(color);
            if let Some(entry) = self.set.get_mut(at) {
                *entry = levels;
            }
        }
        Ok(())
    }

    fn gpqcr(&mut self, wsid: Wsid, start: u32, colors: &mut [Rgb<u16>]) -> Result<(), GpError> {
        self.check_workstation(wsid)?;
        let model = self.model;
        let start = usize::try_from(start).unwrap_or(usize::MAX);
        let end = start.checked_add(colors.len()).ok_or(GpError::Start)?;
        let entries = self.set.get(start..end).ok_or(GpError::Start)?;
        for (to, from) in colors.iter_mut().zip(entries) {
            let rgb = from.map(|level| u16::from(level) * (ONE / u16::from(CAPABILITIES.gun_max)));
            *to = if model == ColorModel::Cmy { rgb.map(|c| ONE - c) } else { rgb };
        }
        Ok(())
    }

    fn gpcrib(&mut self, ibid: Ibid, ncid: Ncid, depth: u32, h: u32, v: u32) -> Result<(), GpError> {
        self.check_open()?;
        if ncid != NUCLEUS {
            return Err(GpError::Nucleus);
        }
        let mask = match depth {
            1 => 0x01,
            2 => 0x03,
            4 => 0x0F,
            8 => 0xFF,
            _ => return Err(GpError::BoardDepth),
        };
        if h == 0 || v == 0 {
            return Err(GpError::BoardSize);
        }
        match self.board {
            Some(board) if board.id == ibid => return Err(GpError::BoardInUse),
            Some(_) => return Err(GpError::Capacity),
            None => {}
        }
        let size = usize::try_from(u64::from(h) * u64::from(v)).unwrap_or(usize::MAX);
        self.memory.as_mut().get_mut(..size).ok_or(GpError::Capacity)?.fill(0);
        self.board = Some(Board { id: ibid, mask, width: h, height: v });
        Ok(())
    }

    fn gpwrct(
        &mut self,
        tibid: Ibid,
        torigin: Pair,
        size: Pair,
        image: PixelArray<&[u8]>,
        sorigin: Pair,
    ) -> Result<(), GpError> {
        let board = self.check_board(tibid)?;
        image.check(image.data.len())?;
        check_inside(sorigin, size, image.x_size, image.y_size)?;
        board.write(self.memory.as_mut(), (torigin.0.into(), torigin.1.into()), size, &image, sorigin);
        Ok(())
    }

    fn gprrct(
        &mut self,
        sibid: Ibid,
        sorigin: Pair,
        size: Pair,
        mut image: PixelArray<&mut [u8]>,
        torigin: Pair,
    ) -> Result<(), GpError> {
        let board = self.check_board(sibid)?;
        image.check(image.data.len())?;
        check_inside(sorigin, size, board.width, board.height)?;
        board.read(self.memory.as_ref(), sorigin, size, &mut image, torigin);
        Ok(())
    }

    fn gpbgst(&mut self, wsid: Wsid) -> Result<(), GpError> {
        self.check_workstation(wsid)?;
        self.drawing = true;
        Ok(())
    }

    fn gpenst(&mut self) -> Result<(), GpError> {
        if !self.drawing {
            return Err(GpError::RequiresNrop);
        }
        self.drawing = false;
        Ok(())
    }

    fn gppxl2(&mut self, point: (i32, i32), image: PixelArray<&[u8]>) -> Result<(), GpError> {
        if !self.drawing {
            return Err(GpError::RequiresNrop);
        }
        image.check(image.data.len())?;
        let Some(board) = self.board else { return Ok(()) }; // without a board nothing is shown
        let bottom = i64::from(point.1) - (i64::from(image.y_size) - 1);
        board.write(
            self.memory.as_mut(),
            (point.0.into(), bottom),
            (image.x_size, image.y_size),
            &image,
            (0, 0),
        );
        Ok(())
    }
}
