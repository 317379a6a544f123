//! The tiles of the floor in a cone: their mean, as one point would show one of them alone.

use core::f64::consts::TAU;

use rta_core::vector::Vec3;

use super::beam::Beam;

/// Rays of the rim by which the part of the floor is found that a cone meets.
const RIM: u32 = 16;

/// A cone that meets more tiles than that, along x or y, sees the mean of both colours.
const MOST: f64 = 8.0;

/// Returns the part, 0 to 1, of what a cone meets of the floor that are tiles where `floor(x / tile) + floor(y / tile)` is odd.
pub fn odd_part(beam: &Beam, tile: f64) -> f64 {
    let (mut least, mut most) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for i in 0..RIM {
        let (sine, cosine) = (TAU * f64::from(i) / f64::from(RIM)).sin_cos();
        let ray = beam.ray([cosine, sine]);
        let t = -ray.origin.z / ray.direction.z;
        // A cone in which there is the horizon meets any number of tiles.
        if !(t > 0.0 && t < f64::MAX) {
            return 0.5;
        }
        let place = [ray.origin.x + ray.direction.x * t, ray.origin.y + ray.direction.y * t];
        for ((place, least), most) in place.into_iter().zip(&mut least).zip(&mut most) {
            let number = (place / tile).floor();
            *least = least.min(number);
            *most = most.max(number);
        }
    }
    let [columns, rows] = [most[0] - least[0] + 1.0, most[1] - least[1] + 1.0];
    if columns > MOST || rows > MOST {
        return 0.5;
    }
    let is_odd = |x: f64, y: f64| (x + y).rem_euclid(2.0) >= 1.0;
    if columns == 1.0 && rows == 1.0 {
        return if is_odd(least[0], least[1]) { 1.0 } else { 0.0 };
    }
    let (mut all, mut odd) = (0.0, 0.0);
    let steps = |count: f64| (0..8).map(f64::from).take_while(move |step| *step < count);
    for column in steps(columns) {
        for row in steps(rows) {
            let [x, y] = [least[0] + column, least[1] + row];
            let corner = |right: f64, up: f64| Vec3::<f64>::new((x + right) * tile, (y + up) * tile, 0.0);
            let corners = [corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)];
            let part = beam.polygon(corners).map_or(0.0, |covered| covered.part);
            all += part;
            odd += if is_odd(x, y) { part } else { 0.0 };
        }
    }
    if all > 0.0 { odd / all } else { 0.5 }
}

#[cfg(test)]
mod tests {
    use rta_core::vector::{UnitVec3, Vec3};

    use super::super::beam::Beam;
    use super::odd_part;

    /// The part of a cone's rays that meet odd tiles.
    fn found(beam: &Beam) -> f64 {
        let (mut all, mut odd) = (0.0, 0.0);
        for i in 0..400 {
            for k in 0..400 {
                let place = [i, k].map(|cell: i32| f64::from(2 * cell + 1) / 400.0 - 1.0);
                if place[0].hypot(place[1]) <= 1.0 {
                    let ray = beam.ray(place);
                    let t = -ray.origin.z / ray.direction.z;
                    let tile = |origin: f64, way: f64| (origin + way * t).floor();
                    let sum = tile(ray.origin.x, ray.direction.x) + tile(ray.origin.y, ray.direction.y);
                    all += 1.0;
                    odd += sum.rem_euclid(2.0);
                }
            }
        }
        odd / all
    }

    #[test]
    fn tiles_are_counted_by_their_areas() {
        for (fall, angle) in [(1.2f64, 0.1), (0.7, 0.2), (0.4, 0.05), (0.3, 0.1)] {
            for x in [0.0, 0.3, 0.7, 1.2] {
                let axis = UnitVec3::<f64>::new(0.0, fall.cos(), -fall.sin());
                let beam = Beam::new(Vec3::<f64>::new(x, 0.2, 2.0), axis, 0.0, angle);
                let (own, exact) = (odd_part(&beam, 1.0), found(&beam));
                assert!((own - exact).abs() < 4e-3, "{fall} {x}: {own}, {exact}");
            }
        }
        // One tile alone, and the horizon.
        let down = |x| Beam::new(Vec3::<f64>::new(x, 0.5, 2.0), -UnitVec3::<f64>::Z, 0.0, 0.01);
        assert_eq!(odd_part(&down(1.5), 1.0), 1.0);
        assert_eq!(odd_part(&down(0.5), 1.0), 0.0);
        let level = Beam::new(Vec3::<f64>::new(0.5, 0.5, 2.0), UnitVec3::<f64>::Y, 0.0, 0.01);
        assert_eq!(odd_part(&level, 1.0), 0.5);
    }
}
