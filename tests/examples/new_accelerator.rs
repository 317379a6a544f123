//! A new accelerator, outside the core: one required method, and the tracer takes it as a type.
//!
//! This one asks the spheres from near the eye to far from it: what is in front is found early, and most of the rest is then too
//! far away to be looked at twice.

use core::ops::ControlFlow;

use rta_core::Error;
use rta_core::prelude::*;
use rta_core::ray::Ray;
use rta_core::scene::{Object, Visit};
use rta_core::{Q16, accelerator};

/// The objects of a scene, the nearest to the eye first; each once.
#[derive(Clone, Copy)]
struct NearFirst<'a>(&'a [Object]);

impl<S: Scalar> Accelerator<S> for NearFirst<'_> {
    /// Nothing is kept from ray to ray.
    type Memory = ();
    /// Equally near hits have to be told apart by the order of the lists.
    const IN_ORDER: bool = false;

    fn candidates<N: Needs>(
        &self,
        scene: &Scene<'_, S>,
        _ray: &Ray<S>,
        visit: &mut impl Visit<S>,
    ) -> ControlFlow<()> {
        self.0.iter().try_for_each(|&object| scene.one::<N>(object, visit))
    }

    fn check(&self, scene: &Scene<'_, S>) -> Result<(), Error> {
        // A real one also checks that none is named twice: see `accelerator::Bvh`.
        let mut objects = 0;
        scene.looks(|_, _| objects += 1);
        if self.0.len() == objects { Ok(()) } else { Err(Error::Hierarchy(0)) }
    }
}

fn length(n: i32) -> Q16 {
    Q16::from_num(n)
}

/// Draws a row of balls with the new accelerator and with the core's own: the pictures are equal.
pub(crate) fn main() {
    let red = Rgb::new(Unit::ratio(9, 10), Unit::ratio(1, 5), Unit::ratio(1, 10));
    let ball = |y| Sphere::new(Xyz::new(length(0), length(y), length(1)), length(1), red, 0);
    let balls = [ball(12), ball(9), ball(6), ball(3)];
    let lamp = Lamp::white(Xyz::new(length(-4), length(0), length(6)), length(1), 60);
    let scene = Scene { spheres: &balls, materials: &[Material::Shiny], lamps: &[lamp], ..Scene::day() };
    let eye =
        Camera::new(Xyz::new(length(1), length(-2), length(2)), UnitVec3::<Q16>::Y, Lens::new(1, 1, (4, 3)));
    let order = [3, 2, 1, 0].map(Object::Sphere);
    let raster = Raster::new(40, 30).expect("a raster");

    let admitted = scene.admit_with(&eye, NearFirst(&order)).expect("a small scene fits");
    let tracer: Tracer<_, _, Everything, 5, _> = Tracer::new(&admitted, Rta, 5).expect("a stack");
    let near_first: Vec<_> = Pixels::new(&tracer, &eye, raster).collect();

    let admitted = scene.admit_with(&eye, accelerator::Lists).expect("a small scene fits");
    let tracer: Tracer<_, _, Everything, 5, _> = Tracer::new(&admitted, Rta, 5).expect("a stack");
    let listed: Vec<_> = Pixels::new(&tracer, &eye, raster).collect();

    assert!(near_first == listed, "a picture does not depend on how its scene is searched");
    println!("{} pixels are the same", listed.len());
}
