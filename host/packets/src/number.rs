//! The number formats as the search sees them: in `f32`, with a margin for what that loses.

use rta_core::{Q16, Q20, Scalar};

/// A number format that can be searched in `f32`.
///
/// All of the search is in `f32` whatever the picture is traced in, and all of it only says what a ray cannot meet. What is
/// left is asked in the picture's own format.
pub trait ToF32: Scalar {
    /// Whether the search computes with these very numbers.
    const IS_F32: bool = false;

    /// Returns the nearest `f32` of a length.
    fn to_f32(self) -> f32;

    /// Returns the nearest `f32` of a component of a unit vector.
    fn unit_to_f32(unit: Self::Unit) -> f32;

    /// Returns by how much a search in `f32` makes boxes and spheres larger, where neither the ray's origin nor they have a
    /// coordinate above `far`: more than the object in it, its own test and that in `f32` can be wrong together.
    fn margin(far: f32) -> f32;

    /// Returns the distance of a sphere's nearest hit in ]0, `t_max`[ from what the search knows of it: the distance of the
    /// foot point, the square of how far that is from the centre, and the radius. Nothing in a format that is finer or coarser
    /// than `f32`, whose spheres have to be asked themselves.
    #[inline]
    fn of_sphere(_along: f32, _across: f32, _radius: f32, _t_max: Self) -> Option<Option<Self>> {
        None
    }

    /// Returns the distance at which a ray meets a triangle in ]0, `t_max`[ from what the search knows of it: that distance, and the least at
    /// which anything of the triangle may be. Nothing in a format that is finer or coarser than `f32`.
    #[inline]
    fn of_triangle(_distance: f32, _begin: f32, _t_max: Self) -> Option<Option<Self>> {
        None
    }
}

/// What is rounded to an `f32` is wrong by half an EPSILON of `far`, and a foot point in `f32` by 14 EPSILON of its distance,
/// which is below 3.5 `far`. Twice as much is added to the format's `own` margin.
#[inline]
fn with_own(far: f32, own: f32) -> f32 {
    far * (100.0 * f32::EPSILON) + own
}

macro_rules! float {
    ($f:ty, { $($own:item)* }) => {
        #[allow(clippy::cast_possible_truncation)] // to the nearest
        impl ToF32 for $f {
            $($own)*
            #[inline]
            fn to_f32(self) -> f32 {
                self as f32
            }
            #[inline]
            fn unit_to_f32(unit: Self) -> f32 {
                unit as f32
            }
            /// A place is as far away as twice `far` in each coordinate, and a foot point errs by `14 EPSILON` of its distance
            /// at most.
            #[inline]
            fn margin(far: f32) -> f32 {
                far * with_own(1.0, (64.0 * <$f>::EPSILON) as f32)
            }
        }
    };
}

float!(f32, {
    const IS_F32: bool = true;
    /// The search has done the sphere's own arithmetic, in its order.
    #[inline]
    fn of_sphere(along: f32, across: f32, radius: f32, t_max: f32) -> Option<Option<f32>> {
        let square = radius * radius;
        if across > square {
            return Some(None);
        }
        let half = (square - across).sqrt();
        let (near, far) = (along - half, along + half);
        let t = if near > 0.0 { near } else { far };
        Some((t > 0.0 && t < t_max).then_some(t))
    }
    /// The search has done the triangle's own arithmetic, in its order.
    #[inline]
    fn of_triangle(distance: f32, begin: f32, t_max: f32) -> Option<Option<f32>> {
        Some((distance < t_max && begin < t_max).then_some(distance))
    }
});
float!(f64, {});

macro_rules! fixed_point {
    ($f:ty) => {
        impl ToF32 for $f {
            #[inline]
            fn to_f32(self) -> f32 {
                from_bits(self.to_bits(), <$f>::FRAC_NBITS)
            }
            #[inline]
            fn unit_to_f32(unit: Self::Unit) -> f32 {
                from_bits(unit.to_bits(), 30)
            }
            /// A foot point errs by 2 LSB and 2^-26 of its distance, which is below 2^31 LSB; twice that, and what the
            /// reciprocal of a direction is wrong by, 2^-29 of as much: 72 LSB wherever the ray is.
            #[inline]
            fn margin(far: f32) -> f32 {
                with_own(far, from_bits(72, <$f>::FRAC_NBITS))
            }
        }
    };
}

fixed_point!(Q16);
fixed_point!(Q20);

/// A fixed-point number with an LSB of 2^-`fraction`, rounded.
#[inline]
#[allow(clippy::cast_precision_loss)] // to the nearest
fn from_bits(bits: i32, fraction: u32) -> f32 {
    bits as f32 * f32::from_bits((127 - fraction) << 23)
}
