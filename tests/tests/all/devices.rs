//! Pictures put on the three emulated devices and read back, and written into a file and read back.

use std::io::Cursor;

use clap::ValueEnum;
use rta::coloring::{Coloring, DitherKind, SAMPLES, TableKind};
use rta::device::Device;
use rta::picture::error::PictureError;
use rta::picture::{Caption, Displayed};
use rta::raster::Size;
use rta::screen::Screen;
use rta_core::color::Rgb;
use rta_core::raster::lattice::Lattice;
use rta_drivers::display::expand;
use rta_drivers::quantize::{Adaptive, ColorTable, Uniform};
use rta_tests::exact::fnv1a;
use rta_tests::golden::Indexed;

const ALL: [Device; 3] = [Device::Vga, Device::Graphigs, Device::Pixrect];

/// Returns every colour table, and a table made for the picture with every dithering.
fn colorings() -> Vec<Coloring> {
    let of = |table, dither| Coloring { table, dither, samples: SAMPLES };
    let tables = TableKind::value_variants().iter().map(|&table| of(table, DitherKind::None));
    let dithered = DitherKind::value_variants().iter().map(|&dither| of(TableKind::Sampled, dither));
    tables.chain(dithered).collect()
}

/// Returns the tables that are not made from the picture, without dithering.
fn plain(table: TableKind) -> Coloring {
    Coloring { table, dither: DitherKind::None, samples: 0 }
}

/// Returns a picture whose registers are slopes with noise: many more colours than any table holds.
fn light(device: Device, coloring: Coloring, size: Size) -> Vec<Rgb<u8>> {
    let max = u32::from(coloring.light_max(device.capabilities()));
    let mut dice = fastrand::Rng::with_seed(fnv1a(device.to_string().bytes()));
    let mut level = |part: u32, whole: u32| {
        let slope = part * max / whole;
        u8::try_from((slope + dice.u32(0..=max / 8)).min(max)).expect("a level")
    };
    let (width, height) = (size.width(), size.height());
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    places.map(|(x, y)| Rgb::new(level(x, width), level(y, height), level(width - x, width))).collect()
}

fn show(device: Device, coloring: Coloring, size: Size, light: &[Rgb<u8>]) -> Displayed {
    let on_grid = |lattice: Lattice| {
        let pixel = |(x, y): (u32, u32)| light.get(y as usize * size.columns() + x as usize).copied();
        Ok::<_, PictureError>(lattice.pixels().filter_map(pixel).collect())
    };
    let mut screen = Screen::new((device, coloring), (size, 1.0), on_grid).expect("it starts");
    // In bands of seven rows, as a tracer delivers them.
    for (y, band) in (0..).step_by(7).zip(light.chunks(7 * size.columns())) {
        screen.put_rows(y, band).expect("it fits");
    }
    screen.picture().expect("it answers")
}

#[test]
fn what_is_read_back_is_what_was_put() {
    let size = Size::new(150, 100).expect("a size");
    for device in ALL {
        let capabilities = device.capabilities();
        let levels = light(device, plain(TableKind::Adaptive), size);
        let adaptive = Adaptive::new(capabilities.colors).expect("a table");
        let uniform = Uniform::new(capabilities.colors, capabilities.gun_max).expect("a table");
        let wanted: [(_, Box<dyn ColorTable>); 2] =
            [(TableKind::Adaptive, Box::new(adaptive)), (TableKind::Uniform, Box::new(uniform))];
        for (kind, mut table) in wanted {
            let got = Indexed::of(&show(device, plain(kind), size, &levels));
            let indices: Vec<_> = levels.iter().map(|&l| table.index(l)).collect();
            assert_eq!(got.indices, indices, "{device} {kind}");
            let expanded = |c: &Rgb<u8>| c.map(|level| expand(level, capabilities.gun_max));
            assert!(got.palette.iter().copied().eq(table.entries().iter().map(expanded)), "{device} {kind}");
        }
    }
}

#[test]
fn a_picture_of_few_colours_comes_back_as_it_is() {
    for device in ALL {
        let (size, max) = (device.size(), device.capabilities().gun_max);
        // Every pixel of the whole screen, in 120 colours.
        let color = |i: u32| {
            let part = |n: u32| u8::try_from(n * u32::from(max) / 5).expect("a level");
            Rgb::new(part(i % 6), part(i / 6 % 5), part(i / 30 % 4))
        };
        let (width, height) = (size.width(), size.height());
        let at = |x: u32, y: u32| color(x / 3 + 7 * (y / 2) + (x * y) % 11);
        let levels: Vec<_> = (0..height).flat_map(|y| (0..width).map(move |x| at(x, y))).collect();
        let got = Indexed::of(&show(device, plain(TableKind::Adaptive), size, &levels));
        assert_eq!((got.width, got.height), (width, height));
        assert_eq!(got.palette.len(), 120, "{device}");
        assert!(got.colors().into_iter().eq(levels.iter().map(|c| c.map(|l| expand(l, max)))), "{device}");
    }
}

#[test]
fn tables_are_within_the_device() {
    let size = Size::new(160, 120).expect("a size");
    for (device, colors, levels_of_a_gun) in
        [(Device::Vga, 256, 64), (Device::Graphigs, 128, 16), (Device::Pixrect, 256, 256)]
    {
        let guns: Vec<u8> = (0..levels_of_a_gun)
            .map(|level: u16| {
                u8::try_from((2 * 255 * u32::from(level) / (u32::from(levels_of_a_gun) - 1)).div_ceil(2))
            })
            .map(|level| level.expect("8 bits"))
            .collect();
        for table in colorings() {
            let got = Indexed::of(&show(device, table, size, &light(device, table, size)));
            assert!(got.palette.len() <= colors, "{device} {table}: {} colours", got.palette.len());
            if table.table == TableKind::Adaptive {
                assert_eq!(got.palette.len(), colors, "{device}: noise fills the table");
            }
            for color in &got.palette {
                for level in [color.r, color.g, color.b] {
                    assert!(guns.contains(&level), "{device} {table}: no gun has level {level}");
                }
            }
            assert!(got.indices.iter().all(|&index| usize::from(index) < got.palette.len()));
        }
    }
}

#[test]
fn a_file_holds_what_the_device_shows() {
    let size = Size::new(97, 61).expect("a size");
    for device in ALL {
        for table in colorings() {
            let picture = show(device, table, size, &light(device, table, size));
            let mut file = Vec::new();
            picture.write_png(&Caption::default(), &mut file).expect("memory takes it");
            let read = Indexed::read(Cursor::new(file)).expect("an indexed PNG");
            assert_eq!(read, Indexed::of(&picture), "{device} {table}");
        }
    }
}
