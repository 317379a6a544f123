//! How many guns a display has: three for red, green and blue, or one for grey.
//!
//! Code that treats every gun alike, as dithering does, is written once for both: generic over [`Guns`].

use core::fmt::Debug;

use rta_core::color::Rgb;

/// The guns of a display.
pub trait Guns: Copy + Debug + Default {
    /// A value for each gun.
    type Each<T: Copy + Debug + Default>: Copy + Debug + Default;

    /// Returns the level of each gun for a colour of 8 bits a gun.
    fn of_light(light: Rgb<u8>) -> Self::Each<u8>;

    /// Applies `f` to the value of each gun.
    fn map<T, U>(each: Self::Each<T>, f: impl FnMut(T) -> U) -> Self::Each<U>
    where
        T: Copy + Debug + Default,
        U: Copy + Debug + Default;

    /// Applies `f` to the two values of each gun.
    fn zip<T, U, V>(a: Self::Each<T>, b: Self::Each<U>, f: impl FnMut(T, U) -> V) -> Self::Each<V>
    where
        T: Copy + Debug + Default,
        U: Copy + Debug + Default,
        V: Copy + Debug + Default;
}

/// Three guns: red, green and blue.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Three;

impl Guns for Three {
    type Each<T: Copy + Debug + Default> = Rgb<T>;

    fn of_light(light: Rgb<u8>) -> Rgb<u8> {
        light
    }

    fn map<T, U>(each: Rgb<T>, f: impl FnMut(T) -> U) -> Rgb<U>
    where
        T: Copy + Debug + Default,
        U: Copy + Debug + Default,
    {
        each.map(f)
    }

    fn zip<T, U, V>(a: Rgb<T>, b: Rgb<U>, f: impl FnMut(T, U) -> V) -> Rgb<V>
    where
        T: Copy + Debug + Default,
        U: Copy + Debug + Default,
        V: Copy + Debug + Default,
    {
        a.zip(b, f)
    }
}

/// One gun, for grey: its level is the [`luma`] of a colour.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct One;

impl Guns for One {
    type Each<T: Copy + Debug + Default> = T;

    fn of_light(light: Rgb<u8>) -> u8 {
        luma(light)
    }

    fn map<T, U>(each: T, mut f: impl FnMut(T) -> U) -> U {
        f(each)
    }

    fn zip<T, U, V>(a: T, b: U, mut f: impl FnMut(T, U) -> V) -> V {
        f(a, b)
    }
}

/// Returns how bright a colour is, as the grey of the same brightness: (77 r + 150 g + 29 b) / 256, rounded down. The weights are those of
/// ITU-R BT.601, 0.299, 0.587 and 0.114, in 256ths; their sum is 256, so every grey is its own luma.
///
/// ```
/// use rta_core::color::Rgb;
/// use rta_drivers::guns::luma;
/// assert_eq!([luma(Rgb::new(255, 0, 0)), luma(Rgb::new(0, 255, 0)), luma(Rgb::new(0, 0, 255))], [76, 149, 28]);
/// assert!((0..=255).all(|level| luma(Rgb::new(level, level, level)) == level));
/// ```
pub const fn luma(light: Rgb<u8>) -> u8 {
    // At most 256 * 255 before the shift.
    ((77 * light.r as u32 + 150 * light.g as u32 + 29 * light.b as u32) >> 8).to_le_bytes()[0]
}
