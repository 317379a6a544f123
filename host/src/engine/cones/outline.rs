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

#[cfg(test)]
mod tests {
    use super::super::cover::{Covered, lens, seg};
    use super::convex;

    fn close(found: Option<Covered>, part: f64, error: f64) {
        let found = found.map_or(0.0, |covered| covered.part);
        assert!((found - part).abs() <= error, "{found}, not {part}");
    }

    #[test]
    fn discs_and_half_planes() {
        for (radius, apart) in [(0.3, 0.2), (0.5, 0.8), (1.2, 0.7), (4.0, 4.5), (300.0, 300.4)] {
            let place: [f64; 2] = [0.6 * apart, -0.8 * apart];
            let covered = convex(place, |[x, y]| (x - place[0]).hypot(y - place[1]) < radius);
            close(covered, lens(1.0, radius, apart), 3e-3);
            let [x, y] = covered.expect("some of it is covered").place;
            // In the middle of what is covered of the line through both middles, or nearly.
            let along = 0.6 * x - 0.8 * y;
            let near = (apart - radius).max(-1.0);
            assert!(along > near && along < 1.0, "{radius} {apart}: {along}");
        }
        // From the edge on, however far its inner place is.
        for s in [-0.7, 0.0, 0.4] {
            for far in [0.9, 2.0, 1e3] {
                close(convex([far, 0.1 * far], |[x, _]| x > s), seg(s), 1e-3);
            }
        }
        close(convex([5.0, 0.0], |[x, y]| (x - 5.0).hypot(y) < 3.0), 0.0, 0.0);
        close(convex([0.5, 0.0], |_| true), 1.0, 0.0);
        close(convex([0.5, 0.0], |_| false), 0.0, 0.0);
    }
}
