//! Pictures of several wavelengths.
#![allow(clippy::indexing_slicing)] // a test may panic

use rta::engine::{Format, Model, Settings};
use rta_core::Scalar;
use rta_core::illumination::Whitted;
use rta_core::needs::Everything;
use rta_core::range::Admitted;
use rta_core::ray::RayKind;
use rta_core::trace::decision::Start;
use rta_core::trace::{Observer, Trace, Tracer};
use rta_core::vector::{UnitVec3, Vector};
use rta_scenes::description::Description;
use rta_scenes::narrow::{Narrow, narrow};
use rta_tests::assert_close;
use rta_tests::picture::{SMALL, by_engine};

const PRISM: &str = include_str!("../../../scenes/prism.rta");

fn read(text: &str) -> Description {
    rta_scenes::read(text.as_bytes(), "scene.rta").expect("a scene")
}

/// Returns the scene in so many wavelengths.
fn in_wavelengths(mut scene: Description, count: Option<u32>) -> Description {
    scene.settings.wavelengths = count;
    scene
}

#[test]
fn a_scene_without_dispersion_is_the_same_in_all_wavelengths() {
    let tinted =
        include_str!("../../scenes/models.rta").replace("abbe 30", "").replace("like crown", "like ice");
    for format in [Format::F32, Format::Q16] {
        for model in [Model::Rta, Model::HallGreenberg, Model::CookTorrance] {
            let settings = Settings { format, model, ..SMALL };
            let drawn = |count| by_engine(&in_wavelengths(read(&tinted), count), &settings);
            assert!(drawn(Some(9)) == drawn(None), "{model} in {format}");
        }
    }
}

#[test]
fn a_model_without_refraction_sees_no_wavelengths() {
    for model in [Model::Lambert, Model::Flat, Model::Newell] {
        let settings = Settings { model, ..SMALL };
        let drawn = |count| by_engine(&in_wavelengths(read(PRISM), count), &settings);
        assert!(drawn(Some(9)) == drawn(None), "{model}");
    }
}

#[test]
fn only_what_is_seen_through_the_prism_has_colours() {
    for format in [Format::F32, Format::F64, Format::Q16, Format::Q20] {
        let settings = Settings { format, model: Model::HallGreenberg, ..SMALL };
        let drawn = |count| by_engine(&in_wavelengths(read(PRISM), count), &settings).0;
        let (many, plain) = (drawn(Some(9)), drawn(None));
        let differing: Vec<usize> = (0..many.len()).filter(|&i| many[i] != plain[i]).collect();
        let columns = differing.iter().map(|i| i % SMALL.width as usize);
        assert!(columns.clone().all(|x| x < 50), "{format}: the tubes are white");
        assert!((300..1500).contains(&differing.len()), "{format}: {}", differing.len());
        // Blue, green and red are apart where the tubes are seen through it.
        let colored = |register: usize| {
            let brightest = |pixel: &&[u32; 3]| {
                let light = pixel.map(f32::from_bits);
                let rest: f32 = light.iter().sum::<f32>() - light[register];
                light[register] > 0.05 && light[register] > 2.0 * rest
            };
            many.iter().filter(brightest).count()
        };
        assert!((0..3).all(|register| colored(register) > 3), "{format}: {:?}", [0, 1, 2].map(colored));
    }
}

/// An observer that keeps the direction in which a ray leaves a prism.
#[derive(Default)]
struct Leaving(Option<UnitVec3<f64>>);

impl Observer<f64> for Leaving {
    fn ray(&mut self, kind: RayKind, depth: u8, start: &Start<f64>) {
        if depth == 2 && kind == RayKind::Transmitted {
            self.0 = Some(start.direction);
        }
    }
}

/// The plan is an equilateral triangle. A ray meets its left face at 56 degrees and leaves through the right one.
const ANGLES: &str = "rta 1
camera at 0 -9 0  to 0 0 0  angle 40
spectral 3
material flint like dense-flint
polygon 0 1.7320508075688772 -5  -1 0 -5  -1 0 5  0 1.7320508075688772 5  of flint
polygon -1 0 -5  1 0 -5  1 0 5  -1 0 5  of flint
polygon 1 0 -5  0 1.7320508075688772 -5  0 1.7320508075688772 5  1 0 5  of flint
";

#[test]
fn a_prism_bends_blue_more_than_red_by_snells_law() {
    let narrowed = narrow::<f64>(&read(ANGLES), 1.0).expect("it fits");
    let admitted = narrowed.admit().expect("it is small");
    let further = &narrowed.spectrum.as_ref().expect("it is dispersive").further;
    let incidence = 56.0_f64.to_radians();
    let toward = incidence - 30_f64.to_radians();
    let direction = UnitVec3::<f64>::new(toward.cos(), toward.sin(), 0.0);
    let origin =
        <f64 as Scalar>::Vector::new(-0.5 - 3.0 * toward.cos(), 0.75_f64.sqrt() - 3.0 * toward.sin(), 0.0);
    // The indices of dense flint at 450 and 650 nm, as the specification states them.
    for (materials, index) in [(&narrowed.materials, 1.681_382_66_f64), (&further[1].materials, 1.654_451_63)]
    {
        let admitted = admitted.with_materials(materials);
        let tracer: Tracer<_, _, Everything, 5> =
            Tracer::new(&admitted, Whitted::default(), 5).expect("a depth");
        let mut leaving = Leaving::default();
        tracer.trace(origin, direction, &mut Default::default(), &mut leaving);
        let got = leaving.0.expect("it leaves");
        let inside = (incidence.sin() / index).asin();
        let outside = (index * (60_f64.to_radians() - inside).sin()).asin();
        let want = 30.0 - outside.to_degrees();
        assert_close!(got.y().atan2(got.x()).to_degrees(), want, 1e-6, "degrees", "index {index}");
    }
}

#[test]
fn a_scene_is_admitted_at_each_wavelength_or_at_none() {
    fn limits<S: Narrow>() {
        let narrowed = narrow::<S>(&read(PRISM), 1.6).expect("it fits");
        let scene = narrowed.scene();
        let first = scene.admit(&narrowed.camera).expect("it is admitted").limits;
        for table in &narrowed.spectrum.as_ref().expect("it is dispersive").further {
            let other = rta_core::scene::Scene { materials: &table.materials, ..scene };
            let admitted: Admitted<'_, S> = other.admit(&narrowed.camera).expect("as the first");
            assert_eq!(admitted.limits, first);
        }
    }
    limits::<rta_core::Q16>();
    limits::<rta_core::Q20>();
    limits::<f32>();
}
