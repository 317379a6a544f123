//! What a cone meets of a convex thing of any shape: its outline, found by rays.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use super::cover::{Covered, part};

/// Directions in which the outline is looked for.
const DIRECTIONS: u32 = 48;

/// Halvings of the way on which it is: to a 2^20th of the cone's width.
const HALVINGS: u32 = 20;

/// Returns what a convex thing covers of a cone: `meets` says whether a ray of it, by its place, meets the thing; `inner` is a place where one
/// does.
pub fn convex(inner: [f64; 2], meets: impl Fn([f64; 2]) -> bool) -> Option<Covered> {
    // An octagon about the disc: if the thing covers its corners, it covers all.
    let around = 1.0 / (PI / 8.0).cos();
    let mut corners = (0..8).map(|i| {
        let (sine, cosine) = (FRAC_PI_2 / 2.0 * f64::from(i)).sin_cos();
        [cosine * around, sine * around]
    });
    if corners.all(&meets) {
        return Some(Covered::WHOLE);
    }
    let [x, y] = inner;
    let apart = x.hypot(y);
    if !meets(inner) {
        return None;
    }
    // From a place beside the disc, the directions to it alone, between its tangents.
    let is_within = apart <= 1.0;
    let (first, width) = if is_within {
        (0.0, TAU)
    } else {
        let half = (1.0 / apart).asin();
        ((-y).atan2(-x) - half, 2.0 * half)
    };
    let far = apart + 1.5;
    let mut outline = Vec::new();
    for i in 0..=DIRECTIONS {
        let (sine, cosine) = (first + width * f64::from(i) / f64::from(DIRECTIONS)).sin_cos();
        let at = |way: f64| [x + cosine * way, y + sine * way];
        let (mut near, mut end) = (0.0, far);
        if meets(at(far)) {
            near = far;
        } else {
            for _ in 0..HALVINGS {
                let middle = f64::midpoint(near, end);
                if meets(at(middle)) { near = middle } else { end = middle }
            }
        }
        outline.push(at(near));
    }
    if !is_within {
        outline.push(inner);
    }
    part(&outline)
}
