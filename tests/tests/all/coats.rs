//! Coats of materials in pictures: patterns in all number formats, and mapped surroundings beside mirrors.
#![allow(clippy::indexing_slicing)] // a test may panic

use rta::engine::{Engine, Format, Settings};
use rta_core::color::Rgb;
use rta_scenes::bake::TEXELS;

/// The largest difference of what counts as the same.
const STEP: i32 = 4;

/// Returns the levels of a picture.
fn picture(text: &str, (width, height): (u32, u32), format: Format) -> Vec<Rgb<u8>> {
    let mut scene = rta_scenes::read(text.as_bytes(), "coats.rta").expect("a scene");
    scene.load_pictures(concat!(env!("CARGO_MANIFEST_DIR"), "/scenes").as_ref(), TEXELS).expect("pictures");
    let settings = Settings { width, height, format, model: scene.model, ..Settings::default() };
    let engine = Engine::new(&scene, &settings).expect("it fits");
    let mut levels = vec![Rgb::new(0, 0, 0); (width * height) as usize];
    engine.level_rows(0, u8::MAX, &mut levels);
    levels
}

/// Returns how many pixels differ in a register by more than 1/63.
fn differing(a: &[Rgb<u8>], b: &[Rgb<u8>]) -> usize {
    let far = |a: u8, b: u8| (i32::from(a) - i32::from(b)).abs() > STEP;
    a.iter().zip(b).filter(|(a, b)| far(a.r, b.r) || far(a.g, b.g) || far(a.b, b.b)).count()
}

#[test]
fn patterns_are_the_same_in_all_formats() {
    let text = include_str!("../../scenes/surfaces.rta");
    let size = (320, 200);
    let want = picture(text, size, Format::F64);
    for format in [Format::F32, Format::Q16, Format::Q20] {
        let count = differing(&picture(text, size, format), &want);
        println!("{format}: {count} of {} pixels differ", want.len());
        assert!(count * 100 <= want.len(), "{format}: {count} of {} pixels", want.len());
    }
}

/// A flat mirror that fills a picture which is taken from far away, so that all rays are nearly parallel; and a red ball that it mirrors.
const MIRROR: &str = "\
rta 1
camera at 0 -2000 2000  to 0 0 0  lens 1400
model whitted
sky map \"../../scenes/evening.png\"
ambient white
material mapped like mirror  surroundings
sphere at 0 1.5 1.5  radius .7  color .9 .1 .1
";

#[test]
fn a_flat_mirror_in_mapped_surroundings_shows_one_colour() {
    let mirror = |material: &str| format!("{MIRROR}floor white white of {material}\n");
    for format in [Format::F64, Format::F32, Format::Q16] {
        let mapped = picture(&mirror("mapped"), (24, 24), format);
        // The ball itself is seen in the upper part of the picture.
        let floor = &mapped[24 * 16..];
        assert!(differing(floor, &vec![floor[0]; floor.len()]) == 0, "{format}: more than one colour");
        let traced = picture(&mirror("mirror"), (24, 24), format);
        let seen = differing(&traced[24 * 16..], floor);
        assert!(seen > 20, "{format}: the traced mirror shows the ball in {seen} pixels");
    }
}

#[test]
fn bumps_turn_with_the_side_that_is_seen_and_keep_mean_light() {
    // A ball of bumps of no height is a ball without bumps.
    let ball = |bump: &str| {
        let text = format!(
            "rta 1\ncamera at 0 -5 0  to 0 0 0\nmodel whitted\nlamp at 0 -9 0 power 1\ntexture t marble black white\n\
             material m diffuse 1 {bump}\nsphere at 0 0 0 radius 1 color .8 .8 .8 of m\n"
        );
        picture(&text, (40, 40), Format::Q16)
    };
    let plain = ball("");
    assert_eq!(differing(&ball("bump t 0"), &plain), 0);
    assert!(differing(&ball("bump t .05"), &plain) > 100);
    let mean = |levels: &[Rgb<u8>]| levels.iter().map(|level| u32::from(level.r)).sum::<u32>();
    let (bumped, flat) = (mean(&ball("bump t .01")), mean(&plain));
    assert!(bumped.abs_diff(flat) * 20 < flat, "{bumped} and {flat}");
}
