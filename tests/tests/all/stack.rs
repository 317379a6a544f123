//! Bytes of the stack of pending rays.
//!
//! A pending ray is an origin (three lengths), a direction (three units), a weight (three units in `Rta`, which
//! colours what mirrors reflect; one in `Whitted`) and a depth, each aligned to its words. The stack holds one for each
//! level of depth and its length. These are the numbers of a machine of 64 bits; with 32 bits the length is 4 bytes.

use rta_core::illumination::{Illumination, Rta, Whitted};
use rta_core::needs::Everything;
use rta_core::trace::Tracer;
use rta_core::{Q16, Q20};
use rta_scenes::narrow::Narrow;

const fn bytes<S: Narrow, M: Illumination<S> + 'static, const STACK: usize>() -> usize {
    Tracer::<'static, S, M, Everything, STACK>::STACK_BYTES
}

#[test]
#[cfg(target_pointer_width = "64")]
fn five_levels_cost_what_is_documented() {
    assert_eq!(bytes::<Q16, Rta, 5>(), 208);
    assert_eq!(bytes::<Q16, Whitted<Q16>, 5>(), 168);
    assert_eq!(bytes::<Q20, Rta, 5>(), 208);
    assert_eq!(bytes::<Q20, Whitted<Q20>, 5>(), 168);
    assert_eq!(bytes::<f32, Rta, 5>(), 208);
    assert_eq!(bytes::<f32, Whitted<f32>, 5>(), 168);
    assert_eq!(bytes::<f64, Rta, 5>(), 408);
    assert_eq!(bytes::<f64, Whitted<f64>, 5>(), 328);
}

#[test]
fn each_level_costs_the_same() {
    const WORD: usize = size_of::<usize>();
    assert_eq!(bytes::<Q16, Rta, 32>() - WORD, 32 * 40);
    assert_eq!(bytes::<Q16, Rta, 0>(), WORD);
    assert_eq!(bytes::<Q16, Rta, 8>() - bytes::<Q16, Rta, 6>(), 80);
}
