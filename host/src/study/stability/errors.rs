//! How far the light of rays is from that in `f64`.

use rta_core::Scalar;
use rta_core::color::Rgb;
use rta_core::scene::Object;
use rta_scenes::shading::Shade;

use super::guard::Failure;
use super::outcome::Measured;
use crate::engine::single;

/// The brightest level of a gun of 8 bits.
const LEVELS: f64 = 255.0;

/// Differences from `f64` in levels.
pub(super) struct Errors(pub(super) Vec<f64>);

/// The light of a ray from the eye, and what it meets.
type Traced<S> = (Result<Rgb<<S as Scalar>::Light>, Failure>, Option<Object>);

impl Errors {
    /// Takes a ray's light in a format beside that in `f64`.
    pub(super) fn take<S: Shade>(&mut self, tested: Traced<S>, exact: Traced<f64>, measured: &mut Measured) {
        match (tested, exact) {
            ((Ok(light), object), (Ok(expected), twin)) => {
                match difference(light.map(single::<S>), expected.map(single::<f64>)) {
                    None => measured.non_finite += 1,
                    Some(_) if object != twin => measured.wrong += 1,
                    Some(levels) => self.0.push(levels),
                }
            }
            ((Err(failure), _), _) | (_, (Err(failure), _)) => measured.failed(failure),
        }
    }
}

/// Returns how far the worst register is off on a display of 256 levels, or none if a register is not finite. Light that `f64`
/// still holds may be beyond `f32`, to which both were converted.
fn difference(got: Rgb<f32>, want: Rgb<f32>) -> Option<f64> {
    let levels = got.zip(want, |got, want| {
        let shown = |light: f32| f64::from(light).clamp(0.0, 1.0) * LEVELS;
        (got.is_finite() && !want.is_nan()).then(|| (shown(got) - shown(want)).abs())
    });
    Some(levels.r?.max(levels.g?).max(levels.b?))
}
