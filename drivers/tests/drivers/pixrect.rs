//! PIXRECT, operation by operation, on pixrects in memory.

use rta_drivers::display::Display;
use rta_drivers::pixrect::{Cgthree, MemPixrect, PIX_CLR, PIX_DONTCLIP, PIX_DST, PIX_SET, PIX_SRC};
use rta_drivers::pixrect::{PixOp, Pixrect, PixrectDisplay, PixrectError, Rect};

use crate::cgthree::board;

type Mem = MemPixrect<Vec<u8>>;

const fn rect(x: i32, y: i32, w: i32, h: i32) -> Rect {
    Rect { x, y, w, h }
}

/// A memory pixrect of depth 8 whose pixels count up from `base`, row by row; 0 follows 255.
fn numbered(width: u32, height: u32, base: u8) -> Mem {
    let mut pr = blank(width, height, 8);
    for (value, (x, y)) in (base..=255).chain(0..=255).zip(all(width, height)) {
        pr.pr_put(x, y, value).unwrap();
    }
    pr
}

/// A memory pixrect whose pixels are 0.
fn blank(width: u32, height: u32, depth: u8) -> Mem {
    MemPixrect::new(vec![0; usize::try_from((width + 16) * height).unwrap()], width, height, depth).unwrap()
}

/// The coordinates of all pixels, row by row from the top.
fn all(width: u32, height: u32) -> impl Iterator<Item = (i32, i32)> {
    let (width, height) = (i32::try_from(width).unwrap(), i32::try_from(height).unwrap());
    (0..height).flat_map(move |y| (0..width).map(move |x| (x, y)))
}

/// The values of all pixels, row by row from the top.
fn pixels(pr: &mut impl Pixrect) -> Vec<u8> {
    let (width, height) = pr.size();
    all(width, height).map(|(x, y)| pr.pr_get(x, y).unwrap()).collect()
}

/// A function of a source byte and a destination byte.
type Function = fn(u8, u8) -> u8;

/// The sixteen raster operations, each as the manual writes it and as a function of bytes.
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

/// A raster operation PIX_SRC made of single puts and gets: pixels outside either pixrect are skipped.
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
                // With PIX_DONTCLIP either the whole rectangle is drawn or nothing.
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
