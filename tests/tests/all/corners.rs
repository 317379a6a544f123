//! Pixels that are cut where the light at their corners differs, beside pixels with as many samples everywhere.

use rta_core::camera::Camera;
use rta_core::color::Rgb;
use rta_core::illumination::Rta;
use rta_core::needs::Everything;
use rta_core::raster::corners::{Corners, Cutting};
use rta_core::raster::{Pixels, Raster};
use rta_core::sampling::Sampling;
use rta_core::trace::{Trace, Tracer};
use rta_scenes::narrow::narrow;
use rta_tests::exact::shipped_scene;

fn sampled(tracer: &impl Trace<f64>, camera: &Camera<f64>, raster: Raster, side: u8) -> Vec<Rgb<f64>> {
    let sampling = Sampling::grid(side).expect("small");
    Pixels::sampled(tracer, camera, raster, sampling, 0, raster.height()).collect()
}

/// Returns the root of the mean square of the differences of two pictures.
fn rms(one: &[Rgb<f64>], other: &[Rgb<f64>]) -> f64 {
    let squares = one.iter().zip(other).map(|(one, other)| {
        let Rgb { r, g, b } = one.zip(*other, |one, other| (one - other) * (one - other));
        r + g + b
    });
    (squares.sum::<f64>() / (3.0 * one.len() as f64)).sqrt()
}

#[test]
fn cut_pixels_are_as_good_as_a_grid_of_samples_for_a_quarter_of_its_rays() {
    for name in ["juggler", "hall-22"] {
        let mut scene = shipped_scene(name);
        // Of one colour: tiles that are smaller than a pixel are seen by no corner.
        if let Some(floor) = &mut scene.floor {
            floor.colors = [[0.6; 3]; 2];
        }
        let narrowed = narrow::<f64>(&scene, 4.0 / 3.0).expect("it fits");
        let admitted = narrowed.admit().expect("it fits");
        let tracer: Tracer<'_, _, _, Everything, 8> = Tracer::new(&admitted, Rta, 5).expect("not deep");
        let (camera, raster) = (&narrowed.camera, Raster::new(160, 100).expect("small"));
        let truth = sampled(&tracer, camera, raster, 13);
        let grid = rms(&sampled(&tracer, camera, raster, 4), &truth);
        let mut above = vec![Rgb::BLACK; 161];
        let rows = Corners::<_, _>::new(&tracer, (camera, raster), Cutting::default(), &mut above, 0);
        let (mut rows, mut cut) = (rows.expect("room"), Vec::new());
        while rows.next_row(|light| cut.push(light)) {}
        let (error, rays) = (rms(&cut, &truth), rows.rays() as f64 / (16.0 * cut.len() as f64));
        println!("{name}: error {error:.5}, of a 4 x 4 grid {grid:.5}; {:.1} % of its rays", 100.0 * rays);
        // The hall's mirrors see things that are smaller than a pixel, which no corner sees.
        let (most, share) = if name == "juggler" { (1.1, 0.25) } else { (2.0, 0.5) };
        assert!(error < most * grid, "{name}: {error}, {grid}");
        assert!(rays < share, "{name}: {rays}");
    }
}
