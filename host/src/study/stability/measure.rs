//! One case in one format, ray by ray beside `f64`.

use fastrand::Rng;
use rta_core::color::Rgb;
use rta_core::needs::Everything;
use rta_core::range::Admitted;
use rta_core::scene::Object;
use rta_core::trace::{Trace, Tracer};
use rta_core::vector::{UnitVec3, Vector};
use rta_packets::picture as packets;
use rta_packets::tally::Tally;
use rta_scenes::description::Description;
use rta_scenes::in_format;
use rta_scenes::narrow::Narrow;
use rta_scenes::narrow::{Narrowed, narrow};
use rta_scenes::shading::{AnyModel, Shade, any_model};

use super::acne;
use super::aim::Drawn;
use super::cases::Case;
use super::errors::Errors;
use super::exact::rounded;
use super::guard::guarded;
pub use super::outcome::{Measured, Outcome};
use super::scattered;
use super::triple::unit;
use crate::engine::{EngineError, Format, MAX_DEPTH};

/// Rays from one eye.
const BLOCK: usize = 256;

/// Traces about `samples` rays of a case from its eyes, in `format` and in `f64`.
#[must_use]
pub fn measure(case: &Case, format: Format, samples: usize) -> Outcome {
    in_format!(format, S => measured::<S>(case, samples))
}

fn measured<S: packets::Format>(case: &Case, samples: usize) -> Outcome {
    let mut measured = Measured { samples: (samples / case.thinning).max(1), ..Measured::default() };
    let mut errors = Errors(Vec::with_capacity(measured.samples));
    // The same rays for all formats, and others for each case.
    let mut rng =
        Rng::with_seed(case.name.bytes().fold(7, |seed: u64, byte| seed.wrapping_mul(31) + u64::from(byte)));
    let mut left = measured.samples;
    while left > 0 {
        let count = left.min(BLOCK);
        let scene = case.stand.place(&case.scene, &mut rng);
        let found = (&mut measured, &mut errors);
        let traced = guarded(|| match case.spreading {
            Some(spreading) => scattered::block::<S>(case, (&scene, spreading), count, &mut rng, found),
            None => block::<S>(case, &scene, count, &mut rng, found),
        });
        match traced {
            Ok(Ok(())) => {}
            Ok(Err(reason)) => return Outcome::Refused(reason.to_string()),
            // Nothing that is guarded ray by ray: making the scene ready.
            Err(failure) => measured.failed(failure),
        }
        left -= count;
    }
    measured.spread(&mut errors.0);
    if case.acne {
        acne::search::<S>(case, samples / 2, &mut rng, &mut measured);
    }
    Outcome::Traced(measured)
}

/// Traces the rays of one eye.
fn block<S: Shade>(
    case: &Case,
    scene: &Description,
    count: usize,
    rng: &mut Rng,
    (measured, errors): (&mut Measured, &mut Errors),
) -> Result<(), EngineError> {
    let given = rounded::<S>(scene);
    let (tested, exact) = (narrow::<S>(&given, 1.0)?, narrow::<f64>(&given, 1.0)?);
    let (mut rays, mut unused) = (Tally::default(), Tally::default());
    let admitted = (tested.admit()?, exact.admit()?);
    let tested = Side::new(case, &given, &tested, &admitted.0)?;
    let exact = Side::new(case, &given, &exact, &admitted.1)?;
    for i in 0..count {
        let (direction, twin) = directions::<S>(case.aim.draw(scene, rng), &tested, &exact);
        let (mut object, mut twin_object) = (None, None);
        let light = guarded(|| {
            object = tested.object(direction);
            tested.light(direction, i, &mut rays)
        });
        let expected = guarded(|| {
            twin_object = exact.object(twin);
            exact.light(twin, i, &mut unused)
        });
        errors.take::<S>((light, object), (expected, twin_object), measured);
    }
    measured.rays += rays.0.iter().sum::<u64>();
    Ok(())
}

/// Returns a direction in the format, and its exact value in `f64`.
fn directions<S: Shade>(drawn: Drawn, tested: &Side<S>, exact: &Side<f64>) -> (UnitVec3<S>, UnitVec3<f64>) {
    match drawn {
        Drawn::Through(x, y) => {
            let (x, y) = (S::unit(x), S::unit(y));
            let twin = exact.scene.camera.direction(S::unit_to_f64(x), S::unit_to_f64(y));
            (tested.scene.camera.direction(x, y), twin)
        }
        Drawn::Along(direction) => {
            let [x, y, z] = direction.map(S::unit);
            let [u, v, w] = unit([x, y, z].map(S::unit_to_f64));
            (Vector::new(x, y, z), Vector::new(u, v, w))
        }
    }
}

/// A tracer in one format, for any illumination model.
type AnyTracer<'a, S> = Tracer<'a, S, AnyModel<S>, Everything, { MAX_DEPTH as usize }>;

/// A scene in one format with a tracer for each of the models that take turns (see [`stability`](super)).
struct Side<'a, S: Narrow> {
    scene: &'a Narrowed<S>,
    admitted: &'a Admitted<'a, S>,
    tracers: Vec<AnyTracer<'a, S>>,
}

impl<'a, S: Shade> Side<'a, S> {
    fn new(
        case: &Case,
        described: &Description,
        scene: &'a Narrowed<S>,
        admitted: &'a Admitted<'a, S>,
    ) -> Result<Self, rta_core::Error> {
        let model = |&model| any_model(model, &described.air, scene, admitted.limits);
        let tracers = case.models.iter().map(|name| Tracer::new(admitted, model(name), case.depth));
        Ok(Self { scene, admitted, tracers: tracers.collect::<Result<_, _>>()? })
    }

    fn object(&self, direction: UnitVec3<S>) -> Option<Object> {
        let ray = self.admitted.ray::<Everything>(self.scene.camera.eye, direction);
        self.admitted.closest::<Everything>(&ray).map(|hit| hit.object)
    }

    /// Returns the light of ray number `turn`, by the model whose turn it is.
    fn light(&self, direction: UnitVec3<S>, turn: usize, tally: &mut Tally) -> Rgb<S::Light> {
        let tracer = self.tracers.iter().cycle().nth(turn % self.tracers.len().max(1));
        tracer.map_or(Rgb::BLACK, |tracer| tracer.trace(self.scene.camera.eye, direction, &mut (), tally))
    }
}
