//! The range proof against measured sizes: in pictures that are traced in an instrumented scalar, no intermediate
//! exceeds the bound that was proved for it.

use rta_core::accelerator::Lists;
use rta_core::illumination::Rta;
use rta_core::needs::Everything;
use rta_core::range::{Bound, Quantity};
use rta_core::scalar::{Magnitude, Unit};
use rta_core::trace::Tracer;
use rta_core::vector::UnitVec3;
use rta_core::{Q16, Q20, Scalar};
use rta_paired::log::{Kind, Operation, record};
use rta_paired::{Format, Paired};
use rta_scenes::narrow::narrow;
use rta_scenes::{dat, description::Description, shipped};
use rta_tests::random_scenes;

fn value(size: Magnitude) -> f64 {
    let (mantissa, exponent) = size.parts();
    f64::from(mantissa) * 2f64.powi(exponent)
}

/// Returns the rows of the proof that bound the result of an operation; none where it saturates by design or is a
/// constant of the program.
fn rows(operation: &Operation) -> &'static [Quantity] {
    match (operation.kind, operation.name) {
        (Kind::Length, "stretch" | "over") | (Kind::Unit, "over" | "ratio") => &[],
        (Kind::Length, _) => &[Quantity::Reach],
        (Kind::Square, _) => &[Quantity::Square],
        (Kind::Unit, "plus") => &[Quantity::Component, Quantity::ImagePlane],
        (Kind::Unit, "times" | "scale") => {
            &[Quantity::Component, Quantity::Reflectance, Quantity::ImagePlane]
        }
        (Kind::Unit, _) => &[Quantity::Component],
        (Kind::Light, _) => &[Quantity::Radiance],
    }
}

/// Traces every eleventh pixel of every seventh row, and returns the largest share of a bound that was used, with the
/// name of the operation; nothing where the scene does not fit the format.
fn check<S: Format>(name: &str, scene: &Description) -> Option<(f64, &'static str)>
where
    Paired<S>: rta_scenes::narrow::Narrow + Scalar,
{
    let narrowed = narrow::<Paired<S>>(scene, 4.0 / 3.0).ok()?;
    let bounds: [Bound; 13] = narrowed.scene().prove(&narrowed.camera, &Lists).bounds;
    let admitted = narrowed.admit().ok()?;
    let tracer: Tracer<_, _, Everything, 5> = Tracer::new(&admitted, Rta, 5).expect("depth 5 of 5");
    let bound =
        |q: &Quantity| bounds.iter().find(|row| row.quantity == *q).map_or(0.0, |row| value(row.bound));
    let limit = value(Magnitude::new(1, 15));
    let mut most = (0.0, "nothing");
    for (i, j) in (0..200).step_by(7).flat_map(|j| (0..320).step_by(11).map(move |i| (i, j))) {
        let ((), log) = record(|| {
            let center = |i: i64, n: i64| <Paired<S> as Scalar>::Unit::ratio(2 * i + 1 - n, 2 * n);
            let direction: UnitVec3<Paired<S>> =
                narrowed.camera.direction(center(i, 320), center(199 - j, 200));
            tracer.radiance(narrowed.camera.eye, direction);
        });
        assert!(!log.operations.is_empty(), "the scalar is instrumented");
        for operation in &log.operations {
            let rows = rows(operation);
            // Radiance saturates: its bound is the format's largest, whatever the row says of the lamps.
            let bound = rows
                .iter()
                .map(bound)
                .fold(if operation.kind == Kind::Light { limit } else { 0.0 }, f64::max);
            if !rows.is_empty() {
                let part = operation.size / bound;
                assert!(part <= 1.0, "{name} {}: pixel {i},{j}: {operation:?} exceeds {bound}", S::NAME);
                most = if part > most.0 { (part, operation.name) } else { most };
            }
        }
    }
    Some(most)
}

#[test]
fn no_quantity_exceeds_its_bound() {
    let shipped =
        shipped::ALL.iter().map(|(name, text)| (*name, dat::read(text.as_bytes(), name).expect("shipped")));
    for (name, scene) in shipped.chain(random_scenes::all()) {
        let (q16, q20) = (check::<Q16>(name, &scene), check::<Q20>(name, &scene));
        println!("{name:20} q16 {q16:?}  q20 {q20:?}");
        assert!(q16.is_some(), "{name} is admitted to q16");
    }
}
