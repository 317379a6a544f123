//! Which columns of a row an object can be seen in.

use core::cmp::Ordering;
use core::ops::Range;

use crate::camera::Camera;
use crate::raster::{Center, Places, Raster};
use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector};
use crate::scalar::{Scalar, Unit};
use crate::shape::Look;

/// A row of pixels as the eye sees it.
pub(super) struct Columns<'c, S: Scalar> {
    pub(super) camera: &'c Camera<S>,
    raster: Raster,
    /// Where the row lies on the image plane.
    row: S::Unit,
    /// Unit vectors ahead, to the right and up.
    axes: [UnitVec3<S>; 3],
    /// Distance, width and height of the image plane.
    plane: [S::Unit; 3],
}

impl<'c, S: Scalar> Columns<'c, S> {
    /// Returns row `y` of a picture.
    pub(super) fn new(camera: &'c Camera<S>, raster: Raster, y: u32) -> Self {
        let vectors = [camera.forward, camera.right, camera.up];
        let axes = vectors.map(|vector| vector.normalize().map_or(vector, |(axis, _)| axis));
        let [ahead, right, up] = axes;
        let plane = [ahead.dot(camera.forward), right.dot(camera.right), up.dot(camera.up)];
        Self { camera, raster, row: Center.row(raster, y), axes, plane }
    }

    /// Returns all columns.
    pub(super) const fn all(&self) -> Range<u32> {
        0..self.raster.width()
    }

    /// Returns the direction of the ray through the middle of a pixel.
    pub(super) fn direction(&self, x: u32) -> UnitVec3<S> {
        let (right, up) = Center.place(self.raster, self.row, x, 0);
        self.camera.direction(right, up)
    }

    /// Returns at least the columns in which rays can meet an object's bounding sphere: those between the places at which a cube about it is
    /// seen.
    pub(super) fn of(&self, look: &Look<S>) -> Range<u32> {
        let way = look.center - self.camera.eye;
        let [ahead, right, up] = self.axes.map(|axis| way.dot(axis));
        // Room for the roundings of these three, and of their products below.
        let radius = look.radius.padded(ahead).padded(ahead);
        let (near, far) = (ahead - radius, ahead + radius);
        if far <= S::ZERO {
            return 0..0;
        }
        if near <= S::ZERO {
            return self.all();
        }
        let [distance, width, height] = self.plane;
        // Products are rounded to the last digit whatever their size, in fixed point.
        let digit = S::ZERO.next_up();
        let room = digit + digit + digit + digit;
        // Where a place of the image plane lies beside the cube: below all of it, where it is seen, or above.
        let beside = |side: S::Unit, middle: S| {
            let least = (middle - radius).scale(distance) - room;
            let most = (middle + radius).scale(distance) + room;
            move |place: S::Unit| {
                let slope = place.times(side);
                let (nearer, farther) = (near.scale(slope), far.scale(slope));
                let is_above = slope > S::Unit::ZERO;
                let (low, high) = if is_above { (nearer, farther) } else { (farther, nearer) };
                if high < least {
                    Ordering::Less
                } else if low > most {
                    Ordering::Greater
                } else {
                    Ordering::Equal
                }
            }
        };
        if beside(height, up)(-self.row) != Ordering::Equal {
            return 0..0;
        }
        let beside = beside(width, right);
        let place = |x: u32| Center.place::<S::Unit>(self.raster, self.row, x, 0).0;
        let count = |is_counted: &dyn Fn(Ordering) -> bool| {
            let (mut low, mut high) = (0, self.raster.width());
            while low < high {
                let middle = (low + high) / 2;
                if is_counted(beside(place(middle))) { low = middle + 1 } else { high = middle }
            }
            low
        };
        count(&Ordering::is_lt)..count(&Ordering::is_le)
    }
}

#[cfg(test)]
#[cfg(feature = "f64")]
mod tests {
    use super::Columns;
    use crate::camera::{Camera, Lens};
    use crate::color::Rgb;
    use crate::raster::Raster;
    use crate::scalar::Unit;
    use crate::scalar::read::{Read, direction, place};
    use crate::shape::{Primitive, Sphere};
    use crate::{Q16, Q20};

    /// Returns the columns of row `y` of a picture of 100 x 100 pixels, 1 high and 1 wide at the distance 1, that ask a ball of radius 1
    /// before or beside an eye at 0 that looks north.
    fn columns<S: Read>(center: [f64; 3], y: u32) -> core::ops::Range<u32> {
        let camera =
            Camera::<S>::new(place::<S>([0.0; 3]), direction::<S>([0.0, 1.0, 0.0]), Lens::new(1, 1, (1, 1)));
        let one = S::Unit::ONE;
        let ball = Sphere::new(place::<S>(center), S::length(1.0), Rgb::new(one, one, one), 0);
        Columns::new(&camera, Raster::new(100, 100).expect("a raster"), y).of(&ball.look())
    }

    fn are_found<S: Read>() {
        // It is seen up to 1 / sqrt(99) to both sides, and the square about it up to 1 / 9.
        assert_eq!(columns::<S>([0.0, 10.0, 0.0], 50), 39..61);
        assert_eq!(columns::<S>([0.0, 10.0, 0.0], 38), 0..0);
        // From 1 / 11 to 3 / 9.
        assert_eq!(columns::<S>([2.0, 10.0, 0.0], 50), 59..83);
        assert_eq!(columns::<S>([9.0, 10.0, 0.0], 50), 100..100);
        assert_eq!(columns::<S>([0.0, -10.0, 0.0], 50), 0..0);
        // The eye's plane goes through it.
        assert_eq!(columns::<S>([3.0, 0.5, 0.0], 50), 0..100);
    }

    #[test]
    fn columns_are_found() {
        are_found::<f32>();
        are_found::<Q16>();
        are_found::<Q20>();
    }
}
