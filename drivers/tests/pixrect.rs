//! PIXRECT, operation by operation, and the cgthree under it, register by register.
#![allow(clippy::indexing_slicing, reason = "a test that indexes out of bounds fails, as it should")]

use rta_core::color::Rgb;
use rta_drivers::bus::{Memory, Registers, ShortMemory};
use rta_drivers::display::Display;
use rta_drivers::pixrect::emulated::{Blank, Board, MEMORY_SIZE};
use rta_drivers::pixrect::{Cgthree, MemPixrect, PIX_CLR, PIX_DONTCLIP, PIX_DST, PIX_SET, PIX_SRC};
use rta_drivers::pixrect::{PixOp, Pixrect, PixrectDisplay, PixrectError, Rect};

type Mem = MemPixrect<Vec<u8>>;

const fn rect(x: i32, y: i32, w: i32, h: i32) -> Rect {
    Rect { x, y, w, h }
}

/// A memory pixrect with a value of its own at every pixel, from `base` up.
fn numbered(width: u32, height: u32, base: u8) -> Mem {
    let mut pr = blank(width, height, 8);
    for (value, (x, y)) in (base..=255).chain(0..=255).zip(all(width, height)) {
        pr.pr_put(x, y, value).unwrap();
    }
    pr
}

fn blank(width: u32, height: u32, depth: u8) -> Mem {
    MemPixrect::new(vec![0; usize::try_from((width + 16) * height).unwrap()], width, height, depth).unwrap()
}

fn all(width: u32, height: u32) -> impl Iterator<Item = (i32, i32)> {
    let (width, height) = (i32::try_from(width).unwrap(), i32::try_from(height).unwrap());
    (0..height).flat_map(move |y| (0..width).map(move |x| (x, y)))
}

fn pixels(pr: &mut impl Pixrect) -> Vec<u8> {
    let (width, height) = pr.size();
    all(width, height).map(|(x, y)| pr.pr_get(x, y).unwrap()).collect()
}

/// A function of a source byte and a destination byte.
type Function = fn(u8, u8) -> u8;

/// The sixteen functions, by their expressions and by what they do.
fn functions() -> [(PixOp, Function); 16] {
    [
        (PIX_CLR, |_, _| 0),
        (!(PIX_SRC | PIX_DST), |s, d| !(s | d)),
        (!PIX_SRC & PIX_DST, |s, d| !s & d),
        (!PIX_SRC, |s, _| !s),
        (PIX_SRC & !PIX_DST, |s, d| s & !d),
        (!PIX_DST, |_, d| !d),
        (PIX_SRC ^ PIX_DST, |s, d| s ^ d),
        (!(PIX_SRC & PIX_DST), |s, d| !(s & d)),
        (PIX_SRC & PIX_DST, |s, d| s & d),
        (!(PIX_SRC ^ PIX_DST), |s, d| !(s ^ d)),
        (PIX_DST, |_, d| d),
        (!PIX_SRC | PIX_DST, |s, d| !s | d),
        (PIX_SRC, |s, _| s),
        (PIX_SRC | !PIX_DST, |s, d| s | !d),
        (PIX_SRC | PIX_DST, |s, d| s | d),
        (PIX_SET, |_, _| 0xFF),
    ]
}

#[test]
fn every_function_is_its_truth_table() {
    let mut codes = std::collections::HashSet::new();
    for (op, wanted) in functions() {
        assert!(codes.insert(op.bits()), "{op:?} twice");
        let mut depends = false;
        for s in 0..=255 {
            for d in 0..=255 {
                assert_eq!(op.apply(s, d), wanted(s, d), "{op:?} of {s} and {d}");
                depends |= wanted(s, d) != wanted(s, 0);
            }
        }
        assert_eq!(op.needs_dst(), depends, "{op:?}");
    }
    assert_eq!((PIX_SRC.bits(), PIX_DST.bits(), PIX_SET.bits()), (0x18, 0x14, 0x1E));
    assert_eq!((PIX_SRC | PIX_DONTCLIP).with_color(0xAB).bits(), 0xAB << 5 | 0x19);
    assert_eq!((!(PIX_SRC | PIX_DONTCLIP).with_color(1)).bits(), 0x06);
}

#[test]
fn rop_does_every_function_in_the_planes_of_the_mask() {
    for (op, wanted) in functions() {
        for planes in [0xFF, 0x0F, 0xA5, 0x00] {
            let (mut dst, mut src) = (numbered(16, 16, 0), numbered(16, 15, 7));
            dst.pr_putattributes(planes);
            let (old, with) = (pixels(&mut dst), pixels(&mut src));
            dst.pr_rop(rect(0, 0, 16, 15), op, &mut src, 0, 0).unwrap();
            for (i, got) in pixels(&mut dst).into_iter().enumerate() {
                let new = with.get(i).map_or(old[i], |&s| wanted(s, old[i]));
                assert_eq!(got, new & planes | old[i] & !planes, "{op:?} pixel {i}, planes {planes:02X}");
            }
        }
    }
    let mut dst = blank(2, 2, 8);
    dst.pr_putattributes(0xF0);
    dst.pr_put(1, 1, 0xFF).unwrap();
    assert_eq!(pixels(&mut dst), [0, 0, 0, 0xF0]);
}

/// What clipping should give, pixel by pixel.
fn by_pixels(dst: &mut Mem, to: Rect, src: &mut Mem, sx: i32, sy: i32) {
    for y in 0..to.h.clamp(0, 50) {
        for x in 0..to.w.clamp(0, 50) {
            let sum = |a: i32, b: i32| a.checked_add(b).unwrap_or(i32::MAX);
            if let Ok(value) = src.pr_get(sum(sx, x), sum(sy, y)) {
                let _outside = dst.pr_put(sum(to.x, x), sum(to.y, y), value);
            }
        }
    }
}

#[test]
fn rop_clips_at_every_edge_of_both() {
    let at = [i32::MIN, -9, -2, 0, 3, 7, 8, i32::MAX];
    let len = [i32::MIN, -1, 0, 1, 5, 20, i32::MAX];
    let mut needed = 0;
    for (x, sx) in at.into_iter().flat_map(|x| at.map(|sx| (x, sx))) {
        for w in len {
            for (to, sx, sy) in [(rect(x, 1, w, 4), sx, 0), (rect(1, x, 4, w), 0, sx)] {
                let (mut got, mut wanted) = (blank(8, 8, 8), blank(8, 8, 8));
                let mut src = numbered(8, 8, 1);
                got.pr_rop(to, PIX_SRC, &mut src, sx, sy).unwrap();
                by_pixels(&mut wanted, to, &mut src, sx, sy);
                let wanted = pixels(&mut wanted);
                assert_eq!(pixels(&mut got), wanted, "{to:?} from ({sx}, {sy})");
                // Without clipping it is all or nothing.
                let area = i64::from(to.w.max(0)) * i64::from(to.h.max(0));
                let drawn = i64::try_from(wanted.iter().filter(|&&p| p != 0).count()).unwrap();
                let mut whole = blank(8, 8, 8);
                let result = whole.pr_rop(to, PIX_SRC | PIX_DONTCLIP, &mut src, sx, sy);
                if area == drawn && area > 0 {
                    assert_eq!(result, Ok(()));
                    assert_eq!(pixels(&mut whole), wanted);
                } else if area > 0 {
                    needed += 1;
                    assert_eq!(result, Err(PixrectError::OutOfBounds), "{to:?} from ({sx}, {sy})");
                    assert!(pixels(&mut whole).iter().all(|&p| p == 0));
                }
            }
        }
    }
    assert!(needed > 100);
}

#[test]
fn put_and_get_stay_inside() {
    let mut pr = numbered(3, 2, 1);
    for (x, y) in [(-1, 0), (0, -1), (3, 0), (0, 2), (i32::MIN, 0), (0, i32::MAX), (i32::MAX, i32::MIN)] {
        assert_eq!(pr.pr_get(x, y), Err(PixrectError::OutOfBounds));
        assert_eq!(pr.pr_put(x, y, 9), Err(PixrectError::OutOfBounds));
    }
    assert_eq!(pixels(&mut pr), [1, 2, 3, 4, 5, 6]);
}

#[test]
fn a_null_source_is_the_color_of_the_operation() {
    let mut pr = blank(100, 3, 8);
    pr.pr_rop_null(rect(-5, 1, 1000, 1), PIX_SRC.with_color(42)).unwrap();
    let wanted: Vec<u8> = (0..300).map(|i| if i / 100 == 1 { 42 } else { 0 }).collect();
    assert_eq!(pixels(&mut pr), wanted);
    pr.pr_rop_null(rect(0, 0, 100, 3), (PIX_SRC ^ PIX_DST).with_color(0xFF)).unwrap();
    assert_eq!(pr.pr_get(99, 1), Ok(!42));
    let outside = pr.pr_rop_null(rect(0, 0, 101, 3), PIX_CLR | PIX_DONTCLIP);
    assert_eq!(outside, Err(PixrectError::OutOfBounds));
    let mut bits = blank(9, 1, 1);
    bits.pr_rop_null(rect(1, 0, 7, 1), PIX_SRC.with_color(2)).unwrap();
    assert_eq!(pixels(&mut bits), [0, 1, 1, 1, 1, 1, 1, 1, 0]);
}

#[test]
fn a_pixrect_can_be_scrolled_onto_itself() {
    for (dx, dy) in [(0, 1), (0, -1), (1, 0), (-1, 0), (3, 2), (-3, -2), (3, -2), (-3, 2), (0, 0)] {
        // Wider than one chunk, so that the order of chunks matters too.
        let mut pr = blank(200, 6, 8);
        for (x, y) in all(200, 6) {
            pr.pr_put(x, y, u8::try_from((x * 7 + y * 31) % 251).unwrap()).unwrap();
        }
        let old = pixels(&mut pr);
        pr.pr_rop_self(rect(dx, dy, 200, 6), PIX_SRC, 0, 0).unwrap();
        for ((x, y), got) in all(200, 6).zip(pixels(&mut pr)) {
            let (sx, sy) = (x - dx, y - dy);
            let inside = (0..200).contains(&sx) && (0..6).contains(&sy);
            let (fx, fy) = if inside { (sx, sy) } else { (x, y) };
            assert_eq!(got, old[usize::try_from(fy * 200 + fx).unwrap()], "({x}, {y}) by ({dx}, {dy})");
        }
    }
}

#[test]
fn depths_mix_only_from_one_bit() {
    let mut stencil = blank(20, 1, 1);
    for x in [0, 7, 8, 19] {
        stencil.pr_put(x, 0, 1).unwrap();
    }
    let mut wide = numbered(20, 1, 100);
    wide.pr_rop(rect(0, 0, 20, 1), PIX_SRC.with_color(5), &mut stencil, 0, 0).unwrap();
    let wanted: Vec<u8> = (0..20).map(|x| if [0, 7, 8, 19].contains(&x) { 5 } else { 0 }).collect();
    assert_eq!(pixels(&mut wide), wanted);
    wide.pr_rop(rect(0, 0, 1, 1), PIX_SRC, &mut stencil, 0, 0).unwrap();
    assert_eq!(wide.pr_get(0, 0), Ok(0xFF), "colour 0 stands for all ones");
    assert_eq!(stencil.pr_rop(rect(0, 0, 1, 1), PIX_SRC, &mut wide, 0, 0), Err(PixrectError::Depth));
    let mut other = blank(20, 1, 1);
    other.pr_rop(rect(1, 0, 19, 1), !PIX_SRC, &mut stencil, 0, 0).unwrap();
    let wanted: Vec<u8> = (0..20).map(|x| u8::from(x > 0 && ![1, 8, 9].contains(&x))).collect();
    assert_eq!(pixels(&mut other), wanted);
    assert!(MemPixrect::new(vec![0; 100], 2, 2, 4).is_err());
}

#[test]
fn memory_is_laid_out_as_in_sunos() {
    let mut memory = [0; 8];
    let mut pr = MemPixrect::new(&mut memory[..], 17, 2, 1).unwrap();
    for (x, y) in [(0, 0), (9, 0), (16, 0), (2, 1)] {
        pr.pr_put(x, y, 1).unwrap();
    }
    assert_eq!(memory, [0x80, 0x40, 0x80, 0, 0x20, 0, 0, 0]);
    let mut memory = [0; 8];
    let mut pr = MemPixrect::new(&mut memory[..], 3, 2, 8).unwrap();
    pr.pr_put(2, 0, 1).unwrap();
    pr.pr_put(0, 1, 2).unwrap();
    assert_eq!(memory, [0, 0, 1, 0, 2, 0, 0, 0]);
    for (width, height) in [(5, 2), (u32::MAX, u32::MAX), (1, u32::MAX), (u32::MAX, 0)] {
        let refused = MemPixrect::new([0; 8], width, height, 8).map(|_| ());
        assert_eq!(refused, Err(PixrectError::Memory));
    }
    let mut pr = numbered(2, 2, 0);
    assert_eq!(pr.pr_putcolormap(0, &[1], &[1], &[1]), Err(PixrectError::NoColormap));
    assert_eq!(PixrectDisplay::new(pr).unwrap_err(), PixrectError::NoColormap);
    assert_eq!(PixrectDisplay::new(blank(2, 2, 1)).unwrap_err(), PixrectError::Depth);
}

#[test]
fn a_region_is_a_pixrect_of_its_own() {
    let mut pr = numbered(4, 4, 1);
    pr.pr_putattributes(0x7F);
    let mut region = pr.pr_region(rect(1, 2, 2, 9));
    assert_eq!((region.size(), region.planes()), ((2, 2), 0x7F));
    assert_eq!(pixels(&mut region), [10, 11, 14, 15]);
    region.pr_putattributes(0xFF);
    region.pr_rop_null(rect(-5, -5, 100, 100), PIX_SET).unwrap();
    assert_eq!(region.pr_put(2, 0, 9), Err(PixrectError::OutOfBounds));
    let mut inner = region.pr_region(rect(1, 1, 1, 1));
    inner.pr_put(0, 0, 77).unwrap();
    assert_eq!(pixels(&mut pr), [1, 2, 3, 4, 5, 6, 7, 8, 9, 255, 255, 12, 13, 255, 77, 16]);
    assert_eq!(pr.planes(), 0x7F, "the parent's mask is its own");
    for part in
        [rect(-5, 0, 5, 4), rect(4, 0, 5, 4), rect(0, 0, -1, 4), rect(i32::MIN, i32::MAX, i32::MAX, 1)]
    {
        let mut nothing = pr.pr_region(part);
        assert_eq!(nothing.size().0.min(nothing.size().1), 0, "{part:?}");
        nothing.pr_rop_null(rect(0, 0, 10, 10), PIX_CLR).unwrap();
    }
    assert_eq!(pr.pr_region(rect(-2, -2, 5, 4)).size(), (3, 2));
    assert_eq!(pr.pr_get(0, 0), Ok(1));
    // A part of the screen is a display too.
    let mut screen = Cgthree::open(board());
    let mut display = PixrectDisplay::new(screen.pr_region(rect(100, 50, 320, 200))).unwrap();
    assert_eq!((display.capabilities().width, display.capabilities().aspect), (320, (320, 200)));
    display.put_pixels(319, 199, &[9]).unwrap();
    assert!(display.put_pixels(319, 199, &[9, 9]).is_err());
    assert_eq!(screen.pr_get(419, 249), Ok(9));
}

fn board() -> Board<Vec<u8>> {
    Board::new(vec![0; MEMORY_SIZE]).unwrap()
}

/// Records the registers written, passes everything on.
struct Recorder(Board<Vec<u8>>, Vec<(u32, u32)>);

impl Registers for Recorder {
    fn write8(&mut self, offset: u32, value: u8) {
        self.1.push((offset, value.into()));
        self.0.write8(offset, value);
    }
    fn read8(&mut self, offset: u32) -> u8 {
        self.0.read8(offset)
    }
    fn write32(&mut self, offset: u32, value: u32) {
        self.1.push((offset, value));
        self.0.write32(offset, value);
    }
}

impl Memory for Recorder {
    fn write(&mut self, offset: u32, bytes: &[u8]) {
        self.0.write(offset, bytes);
    }
    fn read(&mut self, offset: u32, bytes: &mut [u8]) {
        self.0.read(offset, bytes);
    }
}

#[test]
fn opening_a_cgthree_is_this_sequence() {
    let did = Cgthree::open(Recorder(board(), Vec::new())).release().1;
    let bt458 = [(0, 4), (8, 0xFF), (0, 5), (8, 0), (0, 6), (8, 0x40), (0, 7), (8, 0), (0, 0)];
    assert_eq!(did[..9], bt458);
    assert_eq!(did[9..201], [(4, 0); 192]);
    assert_eq!(did[201..], [(0x10, 0x40)]);
}

#[test]
fn the_colormap_is_loaded_in_words_of_whole_groups() {
    let mut screen = Cgthree::open(Recorder(board(), Vec::new()));
    let start = screen.bus().1.len();
    // Entries 3 to 6 are in two groups of four: 0 to 3 and 4 to 7.
    screen.pr_putcolormap(3, &[1, 4, 7, 10], &[2, 5, 8, 11], &[3, 6, 9, 12]).unwrap();
    let did =
        [(0, 0), (4, 0), (4, 0), (4, 0x0001_0203), (4, 0x0405_0607), (4, 0x0809_0A0B), (4, 0x0C00_0000)];
    assert_eq!(screen.bus().1[start..], did);
    screen.pr_putcolormap(255, &[20], &[21], &[22]).unwrap();
    assert_eq!(screen.bus().1[start + did.len()..], [(0, 252), (4, 0), (4, 0), (4, 0x0014_1516)]);
    screen.pr_put(1151, 899, 255).unwrap();
    assert_eq!(screen.bus().0.monitor().unwrap().pixel(1151, 899), Some(Rgb::new(20, 21, 22)));

    let before = screen.bus().1.len();
    for (index, r, g) in [(256, 1, 1), (255, 2, 2), (usize::MAX, 1, 1), (0, 257, 257), (0, 2, 1)] {
        let (red, green) = (vec![9; r], vec![9; g]);
        assert_eq!(screen.pr_putcolormap(index, &red, &green, &red), Err(PixrectError::Colormap));
        let (mut red, mut green, mut blue) = (red.clone(), green.clone(), red);
        let read = screen.pr_getcolormap(index, &mut red, &mut green, &mut blue);
        assert_eq!(read, Err(PixrectError::Colormap));
    }
    screen.pr_putcolormap(256, &[], &[], &[]).unwrap();
    assert_eq!(screen.bus().1.len(), before, "refused and empty calls write nothing");
    let (mut r, mut g, mut b) = ([0; 4], [0; 4], [0; 4]);
    screen.pr_getcolormap(3, &mut r, &mut g, &mut b).unwrap();
    assert_eq!((r, g, b), ([1, 4, 7, 10], [2, 5, 8, 11], [3, 6, 9, 12]));
}

#[test]
fn the_bt458_counts_in_bytes_and_words() {
    let mut screen = Cgthree::open(board()).release();
    screen.write8(0x00, 255);
    for value in [1, 2, 3, 4, 5, 6] {
        screen.write8(0x04, value); // 255, then 0: the address wraps
    }
    screen.write8(0x04, 99); // red alone changes nothing
    screen.write32(0x00, 1); // and an address starts the sequence anew
    screen.write32(0x04, 0x0708_090A);
    screen.write32(0x04, 0x0B0C_0D0E);
    screen.write(0, &[255, 0, 1, 2, 3]);
    let monitor = screen.monitor().unwrap();
    let shown: Vec<_> = (0..5).map(|x| monitor.pixel(x, 0).unwrap()).collect();
    let rgb = Rgb::new;
    assert_eq!(shown, [rgb(1, 2, 3), rgb(4, 5, 6), rgb(7, 8, 9), rgb(10, 11, 12), rgb(0, 0, 0)]);
    // The read mask is applied on the way to the screen.
    screen.write8(0x00, 4);
    screen.write8(0x08, 0x01);
    assert_eq!(screen.read8(0x08), 1);
    assert_eq!(screen.monitor().unwrap().pixel(3, 0), Some(rgb(4, 5, 6)));
    assert_eq!(screen.monitor().unwrap().pixel(0, 0), Some(rgb(7, 8, 9)));
    screen.write8(0x00, 6);
    screen.write8(0x08, 0);
    assert_eq!(screen.monitor().unwrap_err(), Blank::RamOff);
    screen.write8(0x10, 0);
    assert_eq!(screen.monitor().unwrap_err(), Blank::VideoOff);
    for offset in [0x04, 0x0C, 0x20, u32::MAX] {
        screen.write8(offset, 1);
        assert_eq!(screen.read8(offset), 0, "{offset:X}h");
    }
    let short = Board::new(vec![0; 10]).unwrap_err();
    assert_eq!(short, ShortMemory { needed: 1_036_800, found: 10 });
}

#[test]
fn the_frame_buffer_ends_with_the_screen() {
    let mut machine = board();
    let mut bytes = [0; 3];
    machine.write(1_036_798, &[1, 2, 3]);
    machine.read(1_036_798, &mut bytes);
    assert_eq!(bytes, [1, 2, 0xFF]);
    machine.write(u32::MAX, &[1, 2, 3]);
    machine.read(u32::MAX, &mut bytes);
    assert_eq!(bytes, [0xFF; 3]);
    // A row that leaves the screen on the right does not go on in the next.
    let mut screen = Cgthree::open(machine);
    screen.write_row(1150, 0, &[7; 5]);
    assert_eq!([screen.pr_get(1150, 0), screen.pr_get(1151, 0), screen.pr_get(0, 1)], [Ok(7), Ok(7), Ok(0)]);
    screen.write_row(0, 900, &[7; 5]);
    screen.write_row(u32::MAX, u32::MAX, &[7; 5]);
}
