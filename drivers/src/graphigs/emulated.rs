//! An emulated IBM RT PC with graPHIGS: one nucleus, one workstation of the type `RTPC`, one image board.
//!
//! It keeps the API's state (graPHIGS, workstation, non-retained structure open or closed), the colour
//! table twice (as set, and as in effect since the last GPUPWS), and the board. Decisions where the
//! reference is silent or asks for more than a picture needs: the board is shown pixel for pixel, without
//! GPDFI and image mappings; its origin is its lower left pixel; the workstation has the RGB and CMY
//! models; the board is at most as large as the memory lent; the screen has seven planes, so an eighth
//! bit of the board is not shown.

use rta_core::color::Rgb;

use super::{CAPABILITIES, ColorFacilities, ColorModel, GpError, Graphigs, Ibid, Ncid, ONE, Pair};
use super::{PixelArray, PixelOrder, WorkstationType, Wsid};

/// The one workstation type there is.
pub const WORKSTATION_TYPE: WorkstationType = *b"RTPC    ";

/// Bytes of an image board of the size of the screen.
pub const MEMORY_SIZE: usize = 1024 * 1024;

/// The one nucleus there is.
const NUCLEUS: Ncid = Ncid(1);
const COLORS: usize = CAPABILITIES.colors as usize;
const BLACK: Rgb<u8> = Rgb::new(0, 0, 0);

/// The emulated workstation, with lent memory for its image board. Takes about 800 bytes besides.
#[derive(Clone, Debug)]
pub struct Workstation<M> {
    memory: M,
    open: bool,
    workstation: Option<Wsid>,
    /// A non-retained structure was begun.
    drawing: bool,
    model: ColorModel,
    set: [Rgb<u8>; COLORS],
    effective: [Rgb<u8>; COLORS],
    board: Option<Board>,
}

#[derive(Clone, Copy, Debug)]
struct Board {
    id: Ibid,
    mask: u8,
    width: u32,
    height: u32,
}

impl Board {
    /// Offset of the pixel at (x, y) from the lower left, if it is on the board.
    fn offset(&self, x: u64, y: u64) -> Option<usize> {
        let (width, height) = (u64::from(self.width), u64::from(self.height));
        if x < width && y < height { usize::try_from(y * width + x).ok() } else { None }
    }
}

impl<D> PixelArray<D> {
    /// Offset in the data of the pixel at (x, y) from the lower left of the array.
    fn offset(&self, x: u64, y: u64) -> Option<usize> {
        let (width, height) = (u64::from(self.x_size), u64::from(self.y_size));
        if x >= width || y >= height {
            return None;
        }
        let row = if self.order == PixelOrder::LeftRightTopBottom { height - 1 - y } else { y };
        usize::try_from(row.checked_mul(width)?.checked_add(x)?).ok()
    }

    /// The array has pixels and `len` bytes hold them.
    fn check(&self, len: usize) -> Result<(), GpError> {
        let pixels = u64::from(self.x_size) * u64::from(self.y_size);
        let holds = u64::try_from(len).is_ok_and(|len| len >= pixels);
        if pixels > 0 && holds { Ok(()) } else { Err(GpError::Rectangle) }
    }
}

/// A rectangle is not empty and lies within `width` x `height`.
fn check_inside(origin: Pair, size: Pair, width: u32, height: u32) -> Result<(), GpError> {
    let fits = |start: u32, len: u32, end: u32| len > 0 && start.checked_add(len).is_some_and(|e| e <= end);
    if fits(origin.0, size.0, width) && fits(origin.1, size.1, height) {
        Ok(())
    } else {
        Err(GpError::Rectangle)
    }
}

/// The level of 16 nearest to a component.
fn realize(component: u16) -> u8 {
    let (c, one, max) = (u32::from(component), u32::from(ONE), u32::from(CAPABILITIES.gun_max));
    ((c * max + one / 2) / one).to_le_bytes()[0]
}

impl<M: AsRef<[u8]> + AsMut<[u8]>> Workstation<M> {
    /// A machine with graPHIGS closed. Boards are made in `memory`; for one of the size of the screen it
    /// must have [`MEMORY_SIZE`] bytes.
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

    /// What the guns show at a pixel of the screen, counted from the upper left: levels of 0..=15. `None`
    /// outside the screen. Where there is no board or no workstation there is black.
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

    fn check_open(&self) -> Result<(), GpError> {
        if self.open { Ok(()) } else { Err(GpError::RequiresPhop) }
    }

    fn check_workstation(&self, wsid: Wsid) -> Result<(), GpError> {
        match self.workstation {
            None => Err(GpError::RequiresWsop),
            Some(open) if open != wsid => Err(GpError::Workstation),
            Some(_) => Ok(()),
        }
    }

    fn check_board(&self, ibid: Ibid) -> Result<Board, GpError> {
        self.check_open()?;
        self.board.filter(|board| board.id == ibid).ok_or(GpError::Board)
    }

    /// The colour as levels, in the current model.
    fn levels(&self, components: Rgb<u16>) -> Rgb<u8> {
        match self.model {
            ColorModel::Cmy => components.map(|c| realize(ONE - c)),
            _ => components.map(realize),
        }
    }

    /// Copies a rectangle of application data to the board; both origins count from the lower left.
    fn draw(&mut self, board: Board, to: (i64, i64), size: Pair, image: &PixelArray<&[u8]>, from: Pair) {
        let memory = self.memory.as_mut();
        for row in 0..size.1 {
            for column in 0..size.0 {
                let target = |start: i64, step: u32| u64::try_from(start + i64::from(step)).ok();
                let offset =
                    target(to.0, column).zip(target(to.1, row)).and_then(|(x, y)| board.offset(x, y));
                let source = image
                    .offset(u64::from(from.0) + u64::from(column), u64::from(from.1) + u64::from(row))
                    .and_then(|offset| image.data.get(offset));
                if let (Some(pixel), Some(value)) = (offset.and_then(|o| memory.get_mut(o)), source) {
                    *pixel = value & board.mask;
                }
            }
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
        self.draw(board, (torigin.0.into(), torigin.1.into()), size, &image, sorigin);
        Ok(())
    }

    fn gprrct(
        &mut self,
        sibid: Ibid,
        sorigin: Pair,
        size: Pair,
        image: PixelArray<&mut [u8]>,
        torigin: Pair,
    ) -> Result<(), GpError> {
        let board = self.check_board(sibid)?;
        image.check(image.data.len())?;
        check_inside(sorigin, size, board.width, board.height)?;
        for row in 0..size.1 {
            for column in 0..size.0 {
                let at = |origin: Pair| {
                    (u64::from(origin.0) + u64::from(column), u64::from(origin.1) + u64::from(row))
                };
                let ((sx, sy), (tx, ty)) = (at(sorigin), at(torigin));
                let source = board.offset(sx, sy).and_then(|offset| self.memory.as_ref().get(offset));
                let offset = image.offset(tx, ty);
                if let (Some(&value), Some(pixel)) = (source, offset.and_then(|o| image.data.get_mut(o))) {
                    *pixel = value;
                }
            }
        }
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
        let Some(board) = self.board else { return Ok(()) }; // no frame buffer without a board
        let bottom = i64::from(point.1) - (i64::from(image.y_size) - 1);
        self.draw(board, (point.0.into(), bottom), (image.x_size, image.y_size), &image, (0, 0));
        Ok(())
    }
}
