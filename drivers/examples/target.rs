//! A display that has a driver for embedded-graphics, here that crate's own simulator: writes what it shows as a PNG.
//! `cargo run -p rta-drivers --example target [FILE]`

use std::path::{Path, PathBuf};

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::Size;
use embedded_graphics_core::pixelcolor::Rgb565;
use embedded_graphics_simulator::{OutputSettingsBuilder, SimulatorDisplay};
use rta_core::{Q16, prelude::*};
use rta_drivers::direct::{DirectColor, DirectDisplay, DirectPainter};
use rta_drivers::dither::Bayer;
use rta_drivers::target::Target;

/// Calls `with` with a tracer of a golden mirror on a chequered floor, and the camera.
fn scene<T>(with: impl FnOnce(&Tracer<'_, Q16, Rta, Everything, 5>, &Camera<Q16>) -> T) -> Result<T, Error> {
    let length = |n: i32| Q16::from_num(n);
    let gold = Rgb::new(Unit::ratio(9, 10), Unit::ratio(7, 10), Unit::ratio(3, 10));
    let ball = Sphere::new(Xyz::new(length(0), length(5), length(2)), length(2), gold, 0);
    let lamp = Lamp::white(Xyz::new(length(-4), length(0), length(6)), length(1), 60);
    let scene = Scene { spheres: &[ball], materials: &[Material::Mirror], lamps: &[lamp], ..Scene::day() };
    let eye = Xyz::new(length(0), length(-1), length(2));
    let camera = Camera::new(eye, UnitVec3::<Q16>::Y, Lens::new(1, 1, (4, 3)));
    let scene = scene.admit(&camera)?;
    Ok(with(&Tracer::new(&scene, Rta, 5)?, &camera))
}

type Error = Box<dyn core::error::Error>;

/// Draws the scene on any target. Nothing is kept of the picture but what the target keeps.
fn draw<T>(target: &mut T) -> Result<(), Error>
where
    T: DrawTarget<Color: DirectColor, Error: core::error::Error + 'static>,
{
    scene(|tracer, camera| {
        let mut painter = DirectPainter::dithered(Target::new(target), Bayer);
        let (width, height) = painter.display().size();
        let raster = Raster::new(width, height)?;
        for y in 0..height {
            painter.put_row(0, y, Pixels::row(tracer, camera, raster, y).map(|light| light.levels(255)))?;
        }
        Ok(painter.update()?)
    })?
}

/// Draws on a simulated display of 320 x 240 pixels in 16 bits and writes what it shows.
fn picture(file: &Path) -> Result<(), Error> {
    let mut display = SimulatorDisplay::<Rgb565>::new(Size::new(320, 240));
    draw(&mut display)?;
    Ok(display.to_rgb_output_image(&OutputSettingsBuilder::new().build()).save_png(file)?)
}

fn main() -> Result<(), Error> {
    let file = std::env::args_os().nth(1).map_or_else(|| "rta-target.png".into(), PathBuf::from);
    picture(&file)?;
    println!("{}", file.display());
    Ok(())
}

#[test]
fn the_picture_has_the_levels_of_the_light() -> Result<(), Error> {
    use embedded_graphics_core::geometry::{OriginDimensions, Point};
    use embedded_graphics_core::pixelcolor::Rgb888;
    use rta_drivers::dither::bayer;

    let file = std::env::temp_dir().join(format!("rta-target-{}.png", std::process::id()));
    picture(&file)?;
    let shown = SimulatorDisplay::<Rgb888>::load_png(&file);
    std::fs::remove_file(&file)?;
    let shown = shown?;
    assert_eq!(shown.size(), Size::new(320, 240));
    let mut colors = std::collections::HashSet::new();
    scene(|tracer, camera| {
        let places = (0..240).flat_map(|y| (0..320).map(move |x| (x, y)));
        for ((x, y), light) in places.zip(Pixels::new(tracer, camera, Raster::new(320, 240)?)) {
            let light = light.levels(255);
            // The pattern has 64 thresholds between a level and the next: the level is the highest whose distance to the light is below one.
            let level = |light: u8, most: u8| {
                let threshold = f64::from(bayer(x, y)) + 0.5;
                let reached = |level: u8| {
                    f64::from(level) <= f64::from(light) * f64::from(most) / 255.0 + threshold / 64.0
                };
                (0..=most).rev().find(|&level| reached(level)).unwrap_or(0)
            };
            let want = Rgb565::new(level(light.r, 31), level(light.g, 63), level(light.b, 31));
            colors.insert(want);
            let at = Point::new(i32::try_from(x)?, i32::try_from(y)?);
            assert_eq!(shown.get_pixel(at), Rgb888::from(want), "{at:?}");
        }
        Ok::<_, Error>(())
    })??;
    assert!(colors.len() > 200);
    Ok(())
}
