//! graPHIGS, call by call.

use rta_core::color::Rgb;
use rta_drivers::display::{Display, DriverError};
use rta_drivers::graphigs::emulated::{MEMORY_SIZE, WORKSTATION_TYPE, Workstation};
use rta_drivers::graphigs::{ColorModel, GpError, Graphigs, GraphigsDisplay, Ibid, Ncid, ONE};
use rta_drivers::graphigs::{PixelArray, PixelOrder, Wsid};

const WS: Wsid = Wsid(7);
const NUCLEUS: Ncid = Ncid(1);
const BOARD: Ibid = Ibid(3);

/// graPHIGS and the workstation open, no board yet.
fn open() -> Workstation<Vec<u8>> {
    let mut api = Workstation::new(vec![0xEE; MEMORY_SIZE]);
    api.gpopph().unwrap();
    api.gpopws(WS, "IBM5081", WORKSTATION_TYPE).unwrap();
    api
}

/// graPHIGS and the workstation open, with an image board of 4 x 3 pixels of `depth` bits.
fn with_board(depth: u32) -> Workstation<Vec<u8>> {
    let mut api = open();
    api.gpcrib(BOARD, NUCLEUS, depth, 4, 3).unwrap();
    api
}

/// Application data whose highest row comes first.
fn array<D>(x_size: u32, y_size: u32, data: D) -> PixelArray<D> {
    PixelArray { x_size, y_size, order: PixelOrder::LeftRightTopBottom, data }
}

/// Reads the board of 4 x 3 pixels; its highest row comes first.
fn rows(api: &mut Workstation<Vec<u8>>) -> [[u8; 4]; 3] {
    let mut data = [0; 12];
    api.gprrct(BOARD, (0, 0), (4, 3), array(4, 3, &mut data), (0, 0)).unwrap();
    [0, 4, 8].map(|i| data[i..i + 4].try_into().unwrap())
}

#[test]
fn calls_need_their_state() {
    let mut api = Workstation::new(vec![0; 16]);
    let white = [Rgb::new(ONE, ONE, ONE)];
    assert_eq!(api.gpclph(), Err(GpError::RequiresPhop));
    assert_eq!(api.gpopws(WS, "", WORKSTATION_TYPE), Err(GpError::RequiresPhop));
    assert_eq!(api.gpqcf(WORKSTATION_TYPE), Err(GpError::RequiresPhop));
    assert_eq!(api.gpcrib(BOARD, NUCLEUS, 8, 1, 1), Err(GpError::RequiresPhop));
    assert_eq!(api.gpwrct(BOARD, (0, 0), (1, 1), array(1, 1, &[0]), (0, 0)), Err(GpError::RequiresPhop));
    api.gpopph().unwrap();
    assert_eq!(api.gpopph(), Err(GpError::RequiresPhcl));
    assert_eq!(api.gpcr(WS, 0, &white), Err(GpError::RequiresWsop));
    assert_eq!(api.gpupws(WS), Err(GpError::RequiresWsop));
    assert_eq!(api.gpclws(WS), Err(GpError::RequiresWsop));
    assert_eq!(api.gpopws(WS, "", *b"5080    "), Err(GpError::WorkstationType));
    api.gpopws(WS, "", WORKSTATION_TYPE).unwrap();
    assert_eq!(api.gpopws(Wsid(8), "", WORKSTATION_TYPE), Err(GpError::WorkstationInUse));
    let other = Wsid(8);
    assert_eq!(api.gpcr(other, 0, &white), Err(GpError::Workstation));
    assert_eq!(api.gpcml(other, ColorModel::Rgb), Err(GpError::Workstation));
    assert_eq!(api.gpupws(other), Err(GpError::Workstation));
    assert_eq!(api.gpclws(other), Err(GpError::Workstation));
    assert_eq!(api.gpclph(), Err(GpError::RequiresPhop), "a workstation is still open");
    api.gpclws(WS).unwrap();
    assert_eq!(api.gpcr(WS, 0, &white), Err(GpError::RequiresWsop));
    api.gpclph().unwrap();
    assert_eq!(api.gpclph(), Err(GpError::RequiresPhop));
    api.gpopph().unwrap();
}

#[test]
fn errors_have_the_numbers_of_the_api() {
    assert_eq!(GpError::Board.number(), Some(232));
    assert_eq!(GpError::Workstation.to_string(), "graPHIGS error 25: workstation does not exist");
    assert_eq!(GpError::ColorModel.to_string(), "workstation does not have the colour model");
}

#[test]
fn facilities_are_those_of_the_thesis() {
    let facilities = open().gpqcf(WORKSTATION_TYPE).unwrap();
    assert_eq!((facilities.available, facilities.color), (4096, true));
    assert_eq!(facilities.model, ColorModel::Rgb);
    assert_eq!(open().gpqcf(*b"X       "), Err(GpError::WorkstationType));
}

#[test]
fn components_become_the_nearest_of_16_levels() {
    let mut api = open();
    let step = f64::from(ONE) / 15.0;
    for component in (0..=ONE).step_by(7).chain([ONE]) {
        let mut got = [Rgb::new(0, 0, 0)];
        api.gpcr(WS, 127, &[Rgb::new(component, ONE - component, 0)]).unwrap();
        api.gpqcr(WS, 127, &mut got).unwrap();
        let nearest = |c: u16| (f64::from(c) / step).round() * step;
        assert!((f64::from(got[0].r) - nearest(component)).abs() < 1e-9, "{component}");
        assert!((f64::from(got[0].g) - nearest(ONE - component)).abs() < 1e-9, "{component}");
        assert_eq!(got[0].b, 0);
    }
}

#[test]
fn color_models_are_converted_or_refused() {
    let mut api = open();
    api.gpcml(WS, ColorModel::Cmy).unwrap();
    let cyan = Rgb::new(ONE, 0, 0);
    api.gpcr(WS, 1, &[cyan]).unwrap();
    let mut got = [Rgb::new(0, 0, 0)];
    api.gpqcr(WS, 1, &mut got).unwrap();
    assert_eq!(got, [cyan]);
    assert_eq!(api.gpcml(WS, ColorModel::Hsv), Err(GpError::ColorModel));
    assert_eq!(api.gpcml(WS, ColorModel::Cieluv), Err(GpError::ColorModel));
    api.gpcml(WS, ColorModel::Rgb).unwrap();
    api.gpqcr(WS, 1, &mut got).unwrap();
    assert_eq!(got, [Rgb::new(0, ONE, ONE)]);
}

#[test]
fn the_color_table_has_128_entries() {
    let mut api = open();
    let white = Rgb::new(ONE, ONE, ONE);
    assert_eq!(api.gpcr(WS, 0, &[white; 129]), Err(GpError::ColorIndex));
    assert_eq!(api.gpcr(WS, 127, &[white; 2]), Err(GpError::ColorIndex));
    assert_eq!(api.gpcr(WS, 128, &[white]), Err(GpError::ColorIndex));
    assert_eq!(api.gpcr(WS, u32::MAX, &[white; 2]), Err(GpError::ColorIndex));
    assert_eq!(api.gpcr(WS, 0, &[]), Err(GpError::NoIndexes));
    let mut table = [white; 128];
    api.gpqcr(WS, 0, &mut table).unwrap();
    assert_eq!(table, [Rgb::new(0, 0, 0); 128], "refused calls set nothing");
    api.gpcr(WS, 0, &[white; 128]).unwrap();
    assert_eq!(api.gpqcr(WS, 1, &mut table), Err(GpError::Start));
    assert_eq!(api.gpqcr(WS, u32::MAX, &mut table), Err(GpError::Start));
}

#[test]
fn colors_take_effect_with_the_update() {
    let mut api = with_board(8);
    api.gpwrct(BOARD, (0, 0), (1, 1), array(1, 1, &[5]), (0, 0)).unwrap();
    api.gpcr(WS, 5, &[Rgb::new(ONE, 0, 0)]).unwrap();
    let lower_left = (0, 1023);
    assert_eq!(api.pixel(lower_left.0, lower_left.1), Some(Rgb::new(0, 0, 0)));
    api.gpupws(WS).unwrap();
    assert_eq!(api.pixel(lower_left.0, lower_left.1), Some(Rgb::new(15, 0, 0)));
    assert_eq!(api.pixel(5, 1023), Some(Rgb::new(0, 0, 0)), "beyond the board is the background");
    api.gpcr(WS, 0, &[Rgb::new(0, 0, ONE)]).unwrap();
    api.gpupws(WS).unwrap();
    assert_eq!(api.pixel(5, 1023), Some(Rgb::new(0, 0, 15)));
    api.gpclws(WS).unwrap();
    assert_eq!(api.pixel(0, 1023), Some(Rgb::new(0, 0, 0)), "a closed workstation is dark");
}

#[test]
fn boards_are_checked_when_they_are_made() {
    let mut api = open();
    assert_eq!(api.gpcrib(BOARD, Ncid(2), 8, 4, 3), Err(GpError::Nucleus));
    assert_eq!(api.gpcrib(BOARD, NUCLEUS, 7, 4, 3), Err(GpError::BoardDepth));
    assert_eq!(api.gpcrib(BOARD, NUCLEUS, 8, 0, 3), Err(GpError::BoardSize));
    assert_eq!(api.gpcrib(BOARD, NUCLEUS, 8, 4, 0), Err(GpError::BoardSize));
    assert_eq!(api.gpcrib(BOARD, NUCLEUS, 8, 1024, 1025), Err(GpError::Capacity));
    assert_eq!(api.gpcrib(BOARD, NUCLEUS, 8, u32::MAX, u32::MAX), Err(GpError::Capacity));
    api.gpcrib(BOARD, NUCLEUS, 8, 4, 3).unwrap();
    assert_eq!(rows(&mut api), [[0; 4]; 3], "a new board is clear");
    assert_eq!(api.gpcrib(BOARD, NUCLEUS, 8, 4, 3), Err(GpError::BoardInUse));
    assert_eq!(api.gpcrib(Ibid(4), NUCLEUS, 8, 4, 3), Err(GpError::Capacity));
    let write = api.gpwrct(Ibid(4), (0, 0), (1, 1), array(1, 1, &[1]), (0, 0));
    assert_eq!(write, Err(GpError::Board));
}

#[test]
fn rectangles_are_cut_at_the_board_and_to_its_depth() {
    let mut api = with_board(4);
    let data = [0x11, 0x12, 0x13, 0x14, 0x15, 0x16];
    // 3 x 2 pixels, their lower left at (2, 2): only the lowest row and two columns are on the board.
    api.gpwrct(BOARD, (2, 2), (3, 2), array(3, 2, &data), (0, 0)).unwrap();
    assert_eq!(rows(&mut api), [[0, 0, 4, 5], [0; 4], [0; 4]]);
    // One row of two pixels: the middle and the right of the data's upper row.
    api.gpwrct(BOARD, (0, 0), (2, 1), array(3, 2, &data), (1, 1)).unwrap();
    assert_eq!(rows(&mut api), [[0, 0, 4, 5], [0; 4], [2, 3, 0, 0]]);
    // Data whose lowest row comes first.
    let image = PixelArray { x_size: 3, y_size: 2, order: PixelOrder::LeftRightBottomTop, data: &data[..] };
    api.gpwrct(BOARD, (1, 0), (3, 2), image, (0, 0)).unwrap();
    assert_eq!(rows(&mut api), [[0, 0, 4, 5], [0, 4, 5, 6], [2, 1, 2, 3]]);
    let before = rows(&mut api);
    for origin in [(4, 0), (0, 3), (u32::MAX, 0), (0, u32::MAX), (u32::MAX, u32::MAX)] {
        api.gpwrct(BOARD, origin, (3, 2), array(3, 2, &data), (0, 0)).unwrap();
    }
    assert_eq!(rows(&mut api), before);
    for (size, x_size, y_size, from) in [
        ((0, 1), 3, 2, (0, 0)),
        ((1, 0), 3, 2, (0, 0)),
        ((3, 1), 3, 2, (1, 0)),
        ((1, 2), 3, 2, (0, 1)),
        ((1, 1), 3, 2, (u32::MAX, u32::MAX)),
        ((1, 1), 3, 3, (0, 0)),
        ((1, 1), 0, 2, (0, 0)),
        ((1, 1), u32::MAX, u32::MAX, (0, 0)),
    ] {
        let refused = api.gpwrct(BOARD, (0, 0), size, array(x_size, y_size, &data), from);
        assert_eq!(refused, Err(GpError::Rectangle), "{size:?} of {x_size} x {y_size} from {from:?}");
    }
    assert_eq!(rows(&mut api), before);
}

#[test]
fn rectangles_are_read_from_inside_the_board() {
    let mut api = with_board(8);
    let data: Vec<u8> = (1..=12).collect();
    api.gpwrct(BOARD, (0, 0), (4, 3), array(4, 3, &data), (0, 0)).unwrap();
    let mut into = [0; 6];
    // What leaves the application data is discarded.
    api.gprrct(BOARD, (1, 0), (2, 2), array(3, 2, &mut into), (2, 0)).unwrap();
    assert_eq!(into, [0, 0, 6, 0, 0, 10]);
    for (origin, size) in [((0, 0), (5, 1)), ((3, 0), (2, 1)), ((0, 3), (1, 1)), ((u32::MAX, 0), (2, 1))] {
        let refused = api.gprrct(BOARD, origin, size, array(3, 2, &mut into), (0, 0));
        assert_eq!(refused, Err(GpError::Rectangle));
    }
}

#[test]
fn pixel_primitives_need_a_structure_and_are_clipped() {
    let mut api = with_board(8);
    let data = [1, 2, 3, 4];
    assert_eq!(api.gppxl2((0, 0), array(2, 2, &data)), Err(GpError::RequiresNrop));
    assert_eq!(api.gpenst(), Err(GpError::RequiresNrop));
    assert_eq!(api.gpbgst(Wsid(1)), Err(GpError::Workstation));
    api.gpbgst(WS).unwrap();
    api.gppxl2((1, 2), array(2, 2, &data)).unwrap();
    assert_eq!(rows(&mut api), [[0, 1, 2, 0], [0, 3, 4, 0], [0; 4]]);
    api.gppxl2((-1, 0), array(2, 2, &data)).unwrap(); // left and below
    api.gppxl2((3, 3), array(2, 2, &data)).unwrap(); // right and above
    assert_eq!(rows(&mut api), [[0, 1, 2, 3], [0, 3, 4, 0], [2, 0, 0, 0]]);
    for corner in [(i32::MIN, i32::MIN), (i32::MAX, i32::MAX), (i32::MIN, i32::MAX), (i32::MAX, i32::MIN)] {
        api.gppxl2(corner, array(2, 2, &data)).unwrap();
    }
    assert_eq!(rows(&mut api), [[0, 1, 2, 3], [0, 3, 4, 0], [2, 0, 0, 0]]);
    assert_eq!(api.gppxl2((0, 0), array(2, 3, &data)), Err(GpError::Rectangle));
    api.gpenst().unwrap();
    assert_eq!(api.gppxl2((0, 0), array(2, 2, &data)), Err(GpError::RequiresNrop));
}

#[test]
fn the_display_opens_turns_rows_and_closes() {
    let machine = Workstation::new(vec![0; MEMORY_SIZE]);
    let mut display = GraphigsDisplay::open(machine, "IBM5081", WORKSTATION_TYPE).unwrap();
    let levels: Vec<_> = (0..128).map(|i| Rgb::new(i % 16, i / 16, 15 - i % 16)).collect();
    display.set_colors(0, &levels).unwrap();
    display.put_pixels(3, 0, &[17]).unwrap();
    display.update().unwrap();
    assert_eq!(display.api().pixel(3, 0), Some(levels[17]));
    let mut top = [0];
    display.api_mut().gprrct(Ibid(1), (3, 1023), (1, 1), array(1, 1, &mut top), (0, 0)).unwrap();
    assert_eq!(top, [17]);
    display.api_mut().gpclws(Wsid(1)).unwrap();
    assert_eq!(display.update(), Err(DriverError::Device(GpError::RequiresWsop)));
    display.api_mut().gpopws(Wsid(1), "IBM5081", WORKSTATION_TYPE).unwrap();
    let mut machine = display.close().unwrap();
    assert_eq!(machine.gpclph(), Err(GpError::RequiresPhop), "closed");
    let small = Workstation::new(vec![0; MEMORY_SIZE - 1]);
    let refused = GraphigsDisplay::open(small, "IBM5081", WORKSTATION_TYPE);
    assert_eq!(refused.unwrap_err(), GpError::Capacity);
}
