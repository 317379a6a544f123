//! Pictures on every way into a [`Picture`], by their hashes.

use rta_core::prelude::*;
use rta_core::{Q16, needs::Everything};
use rta_drivers::checksum::Checksum;
use rta_drivers::display::Display;
use rta_drivers::painter::Painter;
use rta_drivers::quantize::Adaptive;
use rta_golden::{Capabilities, DrawError, Format, Model, Paper, Picture, Render, Rgb, Screen, Table};

/// What `rta hash` prints for the scenes that come with it, with the options beside.
const HASHES: [(&str, Render, u64); 10] = [
    ("glass-2.dat", DEFAULT, 0x6925_b448_1ecb_f051),
    // -d pixrect -s 200x100, dithered
    ("hall-22.dat", on(Screen::PIXRECT.window(200, 100)), 0xe623_9895_6016_463a),
    // -t tolerant
    ("juggler.dat", TOLERANT, 0x025f_36a4_3f0a_6094),
    ("hall-22.dat", TOLERANT, 0x79b6_c466_54aa_a1b2),
    ("glass-2.dat", TOLERANT, 0xe712_e4bb_ec7d_a195),
    // Phong, as all NFF.
    ("balls2.nff", TOLERANT, 0x52d2_8b36_5ba3_11ac),
    // -d graphigs -s 300x200 -t adaptive
    ("glass-2.dat", on(Screen::GRAPHIGS.window(300, 200).with(Table::Adaptive)), 0xa4a1_1d2a_bdb7_ddc6),
    // -d pixrect -s 200x100 -t uniform
    ("hall-22.dat", on(Screen::PIXRECT.window(200, 100).with(Table::Uniform)), 0x9988_2742_615c_498a),
    // -t tolerant -s 100x60 -m whitted --depth 2
    ("hall-22.dat", Render { model: Some(Model::Whitted), depth: 2, ..on(SMALL) }, 0x3b29_2b08_fff6_1725),
    // -t tolerant -s 100x60 -f q20
    ("juggler.dat", Render { format: Format::Q20, ..on(SMALL) }, 0xc715_481d_b828_9082),
];

const DEFAULT: Render = on(Screen::VGA);
const TOLERANT: Render = on(Screen::VGA.with(Table::Tolerant));
const SMALL: Screen = Screen::VGA.window(100, 60).with(Table::Tolerant);

const fn on(screen: Screen) -> Render {
    Render { screen, format: Format::Q16, model: None, depth: 5 }
}

#[test]
fn hashes_are_those_that_the_program_prints() {
    assert_eq!(Render::default(), DEFAULT);
    let drawn: Vec<_> = HASHES
        .iter()
        .map(|(scene, render, _)| {
            let picture = render.file(format!("../../scenes/{scene}")).expect("a scene that fits");
            assert_eq!(picture.size(), render.screen.size);
            picture.hash()
        })
        .collect();
    for ((scene, render, golden), drawn) in HASHES.iter().zip(drawn) {
        assert_eq!(drawn, *golden, "{scene} {render:?} {drawn:016x}");
    }
}

/// A scene, as a firmware has it; `draw` is given tracer and camera.
fn traced<T>(draw: impl FnOnce(&Tracer<'_, Q16, Rta, Everything, 8>, &Camera<Q16>) -> T) -> T {
    let length = |n: i32| Q16::from_num(n);
    let red = Rgb::new(Unit::ratio(9, 10), Unit::ratio(1, 5), Unit::ratio(1, 10));
    let ball = Sphere::new(Xyz::new(length(0), length(5), length(1)), length(1), red, 0);
    let lamp = Lamp::white(Xyz::new(length(-4), length(0), length(6)), length(1), 60);
    let scene = Scene { spheres: &[ball], materials: &[Material::Mirror], lamps: &[lamp], ..Scene::day() };
    let eye =
        Camera::new(Xyz::new(length(0), length(0), length(2)), UnitVec3::<Q16>::Y, Lens::new(1, 1, (4, 3)));
    let admitted = scene.admit(&eye).expect("it fits");
    draw(&Tracer::new(&admitted, Rta, 5).expect("a depth"), &eye)
}

#[test]
fn a_scene_of_ones_own_is_one_picture_on_all_ways() {
    let screen = Screen::VGA.window(64, 40).with(Table::Tolerant);
    let (width, height) = screen.size;
    let device = Capabilities { width, height, ..screen.device };
    let (picture, levels) = traced(|tracer, camera| {
        let raster = Raster::new(width, height).expect("a raster");
        let levels: Vec<_> = Pixels::new(tracer, camera, raster).map(|light| light.levels(63)).collect();
        (screen.trace(tracer, camera).expect("it is drawn"), levels)
    });
    assert_eq!(picture, screen.paint(levels.clone()).expect("it is drawn"));
    // With a table made for the picture, `paint` takes all 8 bits.
    let sampled = screen.with(Table::Sampled);
    let (drawn, light) = traced(|tracer, camera| {
        let raster = Raster::new(width, height).expect("a raster");
        let light: Vec<_> = Pixels::new(tracer, camera, raster).map(|light| light.levels(255)).collect();
        (sampled.trace(tracer, camera).expect("it is drawn"), light)
    });
    assert_eq!(sampled.light_max(), 255);
    assert_eq!(drawn, sampled.paint(light).expect("it is drawn"));
    assert_ne!(drawn, picture);

    // A firmware draws on the paper, and another one on what a board would hash.
    fn draw<D: Display>(display: D, levels: &[Rgb<u8>]) -> D {
        let table = Adaptive::tolerant(256, display.capabilities().gun_max).expect("a table");
        let columns = display.capabilities().width as usize;
        let mut painter = Painter::new(display, table).unwrap();
        for (y, row) in (0..).zip(levels.chunks(columns)) {
            painter.put_row(0, y, row.iter().copied()).unwrap();
        }
        painter.into_parts().0
    }
    let paper = || Paper::new(device).expect("a raster");
    assert_eq!(picture, draw(paper(), &levels).into_picture().expect("it was drawn"));
    assert_eq!(picture.hash(), draw(Checksum::new(paper()), &levels).value());

    // Without a table, every pixel keeps its levels.
    let direct = screen.with(Table::None).paint(levels.clone()).expect("it is drawn");
    assert_eq!(direct, Picture::direct((64, 40), 63, levels).expect("levels of a VGA"));
    assert_ne!(direct.hash(), picture.hash());
}

#[test]
fn what_is_no_picture_is_refused() {
    let black = Rgb::new(0, 0, 0);
    let says = |drawn: Result<Picture, DrawError>, what: &str| {
        let error = drawn.expect_err(what);
        assert_eq!(format!("{error}"), format!("{error:?}"));
        assert!(error.to_string().contains(what), "{error}");
    };
    says(Picture::indexed((2, 2), 63, [black], [0; 3]), "3 pixels are not a picture of 2 x 2");
    says(Picture::indexed((2, 2), 63, [black], [0, 0, 1, 0]), "no entry 1");
    says(Picture::indexed((1, 1), 63, [black; 257], [0]), "257 colours");
    says(Picture::indexed((1, 1), 63, [Rgb::new(0, 64, 0)], [0]), "level 64 is above 63");
    says(Picture::indexed((0, 1), 63, [black], []), "0 x 1 pixels");
    says(Picture::direct((1, 1), 0, [black]), "no level above 0");
    says(Picture::direct((1, 2), 31, [black, Rgb::new(0, 0, 32)]), "level 32 is above 31");
    says(Picture::direct((1 << 16, 1), 31, [black]), "65536 x 1 pixels");
    says(Screen::VGA.window(321, 200).paint([]), "321 x 200 pixels do not fit a device of 320 x 200");
    says(Screen::VGA.paint([black]), "1 pixels are not a picture of 320 x 200");
    says(
        Screen::of(Capabilities { colors: 4, ..Screen::VGA.device })
            .with(Table::Uniform)
            .window(1, 1)
            .paint([black]),
        "4 colours",
    );
    says(Paper::new(Screen::VGA.device).expect("a raster").into_picture(), "no entry 0");

    let file = |render: Render, name: &str| render.file(name);
    says(file(DEFAULT, "tests/none.dat"), "cannot read the scene tests/none.dat");
    says(file(DEFAULT, "Cargo.toml"), "Cargo.toml:1:1: expected");
    says(
        file(Render { depth: 33, ..DEFAULT }, "tests/ball.dat"),
        "tests/ball.dat: a recursion depth of 33 exceeds 32",
    );
    says(file(on(Screen::VGA.window(1, 200)), "tests/ball.dat"), "too narrow or too wide");
    let mut scene = rta_scenes::read(include_bytes!("ball.dat"), "ball.dat").expect("a scene");
    scene.spheres.iter_mut().for_each(|sphere| sphere.position = [1e5, 0.0, 0.0]);
    says(DEFAULT.scene(&scene), "sphere 1 (line 8) is out of q16's range");
    scene.spheres.iter_mut().for_each(|sphere| sphere.position = [3e4, 0.0, 0.0]);
    says(DEFAULT.scene(&scene), "sphere 1 (line 8)");
    assert!(Render { format: Format::F64, ..on(SMALL) }.scene(&scene).is_ok());
}
