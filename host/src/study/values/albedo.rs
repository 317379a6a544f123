//! The part of the light on a rough surface that its facets return, where each reflects all of it.

use core::f64::consts::PI;

use rta_core::illumination::microfacet::{Beckmann, Facet, Sancer, TorranceSparrow};
use rta_core::scalar::Unit;
use rta_core::vector::{UnitVec3, UnitVector};
use rta_scenes::narrow::Narrow;

use super::frame::{direction, roughness};

/// Steps of the tilt and of half a turn. The value changes by less than 1e-4 where there are twice as many.
const STEPS: [u32; 2] = [240, 160];

/// Returns `1/pi` of the integral of `D G / (4 N.V)` over all directions of the light, for an eye at `tv` degrees, the slope `m`
/// and the attenuation 1 of Torrance and Sparrow or 2 of Sancer.
///
/// The integral is taken over the facets instead, which are few beyond 5 m: a facet's solid angle is that of the light over
/// 4 V.H.
pub(super) fn albedo<S: Narrow>(tv: f64, m: f64, kind: f64) -> f64 {
    let slopes = [roughness::<S>(1.0, m)];
    let view = direction::<S>(tv, 180.0);
    let [tilts, turns] = STEPS;
    let steepest = (5.0 * m).atan();
    let (tilt_step, turn_step) = (steepest / f64::from(tilts), PI / f64::from(turns));
    let mut sum = 0.0;
    for i in 0..tilts {
        let tilt = tilt_step * (f64::from(i) + 0.5);
        for j in 0..turns {
            let turn = turn_step * (f64::from(j) + 0.5);
            let halfway = direction::<S>(tilt.to_degrees(), turn.to_degrees());
            if view.dot(halfway) <= S::Unit::ZERO {
                continue;
            }
            let light = -view.reflect(halfway);
            let Some(facet) = Facet::between::<S>(UnitVec3::<S>::Z, light, view) else { continue };
            let (beckmann, all) = (Beckmann(&slopes), S::Unit::ONE);
            let reflectance = if kind == 1.0 {
                facet.balanced_reflectance(&beckmann, &TorranceSparrow, all)
            } else {
                facet.balanced_reflectance(&beckmann, &Sancer(&slopes), all)
            };
            sum += S::power_to_f64(reflectance) * 4.0 * S::unit_to_f64(facet.incidence) * tilt.sin();
        }
    }
    // Two halves of a turn.
    2.0 * sum * tilt_step * turn_step / PI
}
