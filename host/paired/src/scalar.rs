//! The arithmetic of both twins, each by its own rules.

use rta_core::scalar::{Light, Magnitude, Number, Positive, Scalar, Sight, Unit};
use rta_packets::ToF32;
use rta_scenes::narrow::Narrow;
use rta_scenes::shading::Shade;

use crate::sight::sight;
use crate::{Bare, Format, Paired, PairedVector, UnitFormat, Value, log};

impl<T: Number + Value> Number for Paired<T> {
    fn size(self) -> Magnitude {
        self.format.size()
    }
}

impl<T: Number> Number for Bare<T> {
    fn size(self) -> Magnitude {
        self.format.size()
    }
}

impl<S: Format> Scalar for Paired<S> {
    type Unit = Paired<S::Unit>;
    type Wide = Paired<S::Wide>;
    type Light = Paired<S::Light>;
    type Power = Bare<S::Power>;
    type Inverse = Bare<S::Inverse>;
    type Vector = PairedVector<S::Vector>;
    type UnitVector = PairedVector<S::UnitVector>;

    const ZERO: Self = Self { format: S::ZERO, twin: 0.0 };
    // The twin's world ends where the format's does.
    const FAR: Self = Self { format: S::FAR, twin: S::FARTHEST };
    const LARGEST_SQUARE: Magnitude = S::LARGEST_SQUARE;
    const LARGEST_PRODUCT: Magnitude = S::LARGEST_PRODUCT;
    const LARGEST_STRETCH: Magnitude = S::LARGEST_STRETCH;
    const CLEARANCE: Magnitude = S::CLEARANCE;

    fn at_most(size: Magnitude) -> Self {
        let format = S::at_most(size);
        Self { format, twin: format.value() }
    }
    #[track_caller]
    fn scale(self, factor: Self::Unit) -> Self {
        Self { format: self.format.scale(factor.format), twin: self.twin.scale(factor.twin) }
            .noted("scale", [self.error(), factor.error()])
    }
    #[track_caller]
    fn product(self, other: Self) -> Self::Wide {
        Paired { format: self.format.product(other.format), twin: self.twin * other.twin }
            .noted("product", [self.error(), other.error()])
    }
    #[track_caller]
    fn part(part: Self::Wide, whole: Self::Wide) -> Self::Unit {
        Paired {
            format: S::part(part.format, whole.format),
            twin: <f64 as Scalar>::part(part.twin, whole.twin),
        }
        .noted("part", [part.error(), whole.error()])
    }
    #[track_caller]
    fn sqrt(square: Self::Wide) -> Self {
        Self { format: S::sqrt(square.format), twin: <f64 as Scalar>::sqrt(square.twin) }
            .noted("sqrt", [square.error()])
    }
    /// A place of a pattern is the format's: patterns are no numbers that a twin could have.
    fn lattice(self, frequency: u32) -> i32 {
        self.format.lattice(frequency)
    }
    #[track_caller]
    fn of_lattice(place: i32) -> Self {
        Self { format: S::of_lattice(place), twin: <f64 as Scalar>::of_lattice(place) }
            .noted("of_lattice", [])
    }
    fn inverse(self) -> Self::Inverse {
        Bare { format: self.format.inverse(), twin: self.twin.inverse() }
    }
    #[track_caller]
    fn fraction(self, whole: Self::Inverse) -> Self::Unit {
        Paired { format: self.format.fraction(whole.format), twin: self.twin.fraction(whole.twin) }
            .noted("fraction", [self.error()])
    }
    #[track_caller]
    fn stretch(self, slope: <Self::Unit as Unit>::Inverse) -> Self {
        let twin = self.twin.stretch(slope.twin).clamp(-S::FARTHEST, S::FARTHEST);
        Self { format: self.format.stretch(slope.format), twin }.noted("stretch", [self.error()])
    }
    fn positive(self) -> Self::Power {
        Bare { format: self.format.positive(), twin: Scalar::positive(self.twin) }
    }
    #[track_caller]
    fn over(self, slope: Self::Unit) -> Self {
        let twin = Scalar::over(self.twin, slope.twin).min(S::FARTHEST);
        Self { format: Scalar::over(self.format, slope.format), twin }
            .noted("over", [self.error(), slope.error()])
    }
    #[track_caller]
    fn padded(self, distance: Self) -> Self {
        let twin = Scalar::padded(self.twin, distance.twin);
        Self { format: self.format.padded(distance.format), twin }.noted("padded", [self.error()])
    }
    fn next_up(self) -> Self {
        Self { format: Scalar::next_up(self.format), twin: self.twin.next_up() }
    }
    #[track_caller]
    fn at_one_place(self, extent: Self, cosine: Self::Unit) -> Self {
        let twin = self.twin.at_one_place(extent.twin, cosine.twin);
        Self { format: self.format.at_one_place(extent.format, cosine.format), twin }
    }
    #[track_caller]
    fn odd_tile(self, tile: Option<Self>) -> bool {
        let format = self.format.odd_tile(tile.map(|tile| tile.format));
        let twin = self.twin.odd_tile(tile.map(|tile| tile.twin));
        log::decision("odd_tile", self.values(), tile.map_or([3.0; 2], |tile| tile.values()), format, twin);
        format
    }
    #[track_caller]
    fn odd_far_tile(self, slope: Self::Unit, height: Self, fall: Self::Unit, tile: Option<Self>) -> bool {
        let (format, twin) = (tile.map(|tile| tile.format), tile.map(|tile| tile.twin));
        let format = self.format.odd_far_tile(slope.format, height.format, fall.format, format);
        let twin = self.twin.odd_far_tile(slope.twin, height.twin, fall.twin, twin);
        log::decision("odd_far_tile", self.values(), fall.values(), format, twin);
        format
    }
    #[track_caller]
    fn sight(
        (axis, normal): (Self::UnitVector, Self::UnitVector),
        sine: Self::Unit,
        pair: [Self::Unit; 2],
    ) -> Option<Sight<Self>> {
        sight([axis, normal], sine, pair)
    }
    fn power(mantissa: u32, exponent: i16) -> Self::Power {
        Bare {
            format: <S as Scalar>::power(mantissa, exponent),
            twin: <f64 as Scalar>::power(mantissa, exponent),
        }
    }
    #[track_caller]
    fn intensity(power: Self::Power) -> Self::Light {
        Paired { format: S::intensity(power.format), twin: <f64 as Scalar>::intensity(power.twin) }
            .noted("intensity", [])
    }
    #[track_caller]
    fn fall_off(power: Self::Power, distance: Self::Inverse) -> Self::Light {
        Paired {
            format: S::fall_off(power.format, distance.format),
            twin: <f64 as Scalar>::fall_off(power.twin, distance.twin),
        }
        .noted("fall_off", [])
    }
}

impl<U: UnitFormat> Unit for Paired<U> {
    type Inverse = Bare<U::Inverse>;
    type Positive = Bare<U::Positive>;
    const ZERO: Self = Self { format: U::ZERO, twin: 0.0 };
    const ONE: Self = Self { format: U::ONE, twin: 1.0 };
    const LARGEST: Magnitude = U::LARGEST;
    const ROUNDING: Self = Self { format: U::ROUNDING, twin: <f64 as Unit>::ROUNDING };
    #[track_caller]
    fn fraction(numerator: i32, denominator: u32) -> Self {
        Self::ratio(i64::from(numerator), i64::from(denominator))
    }
    #[track_caller]
    fn ratio(numerator: i64, denominator: i64) -> Self {
        Self { format: U::ratio(numerator, denominator), twin: <f64 as Unit>::ratio(numerator, denominator) }
            .noted("ratio", [])
    }
    #[track_caller]
    fn of_word(word: u32) -> Self {
        Self { format: U::of_word(word), twin: <f64 as Unit>::of_word(word) }.noted("of_word", [])
    }
    #[track_caller]
    fn of_level(level: i32) -> Self {
        Self { format: U::of_level(level), twin: <f64 as Unit>::of_level(level) }.noted("of_level", [])
    }
    #[track_caller]
    fn turn(x: Self, y: Self) -> Self {
        Self { format: U::turn(x.format, y.format), twin: <f64 as Unit>::turn(x.twin, y.twin) }
            .noted("turn", [x.error(), y.error()])
    }
    #[track_caller]
    fn times(self, factor: Self) -> Self {
        Self { format: self.format.times(factor.format), twin: self.twin * factor.twin }
            .noted("times", [self.error(), factor.error()])
    }
    #[track_caller]
    fn over(self, divisor: Self::Inverse) -> Self {
        Self { format: Unit::over(self.format, divisor.format), twin: Unit::over(self.twin, divisor.twin) }
            .noted("over", [self.error()])
    }
    #[track_caller]
    fn root(self, part: u32) -> Self {
        Self { format: Unit::root(self.format, part), twin: Unit::root(self.twin, part) }
            .noted("root", [self.error()])
    }
    #[track_caller]
    fn arc_squared(self) -> Self {
        Self { format: self.format.arc_squared(), twin: self.twin.arc_squared() }
            .noted("arc_squared", [self.error()])
    }
    fn positive(self) -> Self::Positive {
        Bare { format: self.format.positive(), twin: Unit::positive(self.twin) }
    }
    #[track_caller]
    fn quotient(self, divisor: Self) -> Self {
        // Where the format saturates, so does the twin.
        let twin = (self.twin / divisor.twin).clamp(-2.0, 2.0);
        Self { format: self.format.quotient(divisor.format), twin }
            .noted("quotient", [self.error(), divisor.error()])
    }
    #[track_caller]
    fn radical(a: Self, b: Self, minus: Self) -> Option<Self> {
        let (format, twin) =
            (U::radical(a.format, b.format, minus.format), f64::radical(a.twin, b.twin, minus.twin));
        log::decision("radical", a.values(), minus.values(), format.is_some(), twin.is_some());
        let root = Self { format: format?, twin: twin.unwrap_or(0.0) };
        Some(root.noted("radical", [a.error(), b.error(), minus.error()]))
    }
}

impl<P: Positive<Unit: UnitFormat>> Positive for Bare<P> {
    type Unit = Paired<P::Unit>;
    fn new(value: u64, exponent: i32) -> Self {
        Self { format: P::new(value, exponent), twin: <f64 as Positive>::new(value, exponent) }
    }
    fn plus(self, other: Self) -> Self {
        Self { format: self.format.plus(other.format), twin: self.twin + other.twin }
    }
    fn times(self, other: Self) -> Self {
        Self { format: self.format.times(other.format), twin: self.twin * other.twin }
    }
    fn over(self, divisor: Self) -> Self {
        Self { format: self.format.over(divisor.format), twin: self.twin / divisor.twin }
    }
    fn root(self) -> Self {
        Self { format: self.format.root(), twin: self.twin.sqrt() }
    }
    #[track_caller]
    fn unit(self) -> Self::Unit {
        // Where the format saturates, so does the twin.
        Paired { format: self.format.unit(), twin: self.twin.min(2.0) }.noted("unit", [])
    }
    #[track_caller]
    fn exp2_minus(self) -> Self::Unit {
        Paired { format: self.format.exp2_minus(), twin: self.twin.exp2_minus() }.noted("exp2_minus", [])
    }
    #[track_caller]
    fn shadow(self) -> Self::Unit {
        Paired { format: self.format.shadow(), twin: self.twin.shadow() }.noted("shadow", [])
    }
}

impl<L: Light<Unit: UnitFormat> + Value> Light for Paired<L> {
    type Unit = Paired<L::Unit>;
    const ZERO: Self = Self { format: L::ZERO, twin: 0.0 };
    const WHITE: Self = Self { format: L::WHITE, twin: 1.0 };
    const LARGEST: Magnitude = L::LARGEST;
    #[track_caller]
    fn plus(self, other: Self) -> Self {
        Self { format: self.format.plus(other.format), twin: self.twin + other.twin }
            .noted("plus", [self.error(), other.error()])
    }
    #[track_caller]
    fn times(self, factor: Self::Unit) -> Self {
        Self { format: self.format.times(factor.format), twin: self.twin * factor.twin }
            .noted("times", [self.error(), factor.error()])
    }
    fn level(self, max: u8) -> u8 {
        self.format.level(max)
    }
}

/// The twin has the numbers of the scene file as they are: rounding them is the format's first loss.
impl<S: Format> Shade for Paired<S> {}

impl<S: Format> Narrow for Paired<S> {
    const NAME: &'static str = S::NAME;
    const SMALLEST_RADIUS: f64 = S::SMALLEST_RADIUS;
    const LARGEST_COLOR: f64 = S::LARGEST_COLOR;
    const LARGEST_LIGHT: f64 = S::LARGEST_LIGHT;
    const LARGEST_POWER: f64 = S::LARGEST_POWER;
    fn largest() -> f64 {
        S::largest()
    }
    fn length(value: f64) -> Self {
        Self { format: S::length(value), twin: value }
    }
    fn unit(value: f64) -> Self::Unit {
        Paired { format: S::unit(value), twin: value }
    }
    fn light(value: f64) -> Self::Light {
        Paired { format: S::light(value), twin: value }
    }
    fn power(value: f64) -> Self::Power {
        Bare { format: <S as Narrow>::power(value), twin: value }
    }
    fn to_f64(self) -> f64 {
        self.format.to_f64()
    }
    fn unit_to_f64(unit: Self::Unit) -> f64 {
        S::unit_to_f64(unit.format)
    }
    fn light_to_f64(light: Self::Light) -> f64 {
        S::light_to_f64(light.format)
    }
    fn power_to_f64(power: Self::Power) -> f64 {
        S::power_to_f64(power.format)
    }
}

/// The search follows the format: its numbers decide.
impl<S: Format + ToF32> ToF32 for Paired<S> {
    fn to_f32(self) -> f32 {
        self.format.to_f32()
    }
    fn unit_to_f32(unit: Self::Unit) -> f32 {
        S::unit_to_f32(unit.format)
    }
    fn margin(far: f32) -> f32 {
        S::margin(far)
    }
}
