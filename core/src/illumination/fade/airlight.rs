//! Light of a lamp that air scatters into a ray (Max 1986; Nishita, Miyamae, Nakamae 1987).

use crate::scalar::{Positive, Scalar, Unit};

/// The fewest halvings of the angle that the lamp sees of the ray: the series of [`Part::angle`] needs a small one.
const FEWEST: u8 = 4;

/// Returns the light that a medium of the extinction s (a unit of length) scatters evenly into a ray, as a part of the lamp's
/// intensity and for a medium that absorbs nothing: `s / 4` times the integral of `exp(-s (t - from + r)) / r^2` over the ray. The
/// lamp is at the distance `height`, above 0, from the ray's line; t runs from `from` to `to`, both measured along the ray
/// from the foot of the lamp, `to` the larger one; r is the distance from the lamp.
///
/// The angle that the lamp sees of the ray is cut into `2^halvings` equal parts, 16 at least, and each is taken by its
/// middle. With 16 the value errs by at most 1e-4 / height^2; four times as many divide the error by 16. The result is 0 or
/// more, at most `s (to - from) / (4 height^2)`.
pub fn airlight<S: Scalar>(extinction: S::Power, height: S, from: S, to: S, halvings: u8) -> S::Power {
    let sight = Sight::<S>::new(height, from, to, halvings);
    let mut sum = S::ZERO.positive();
    sight.places(&mut |along, away| {
        sum = sum.plus(extinction.times(along.plus(away)).exp_minus().positive());
    });
    sight.integral(sum).times(extinction)
}

/// A ray as a lamp sees it: places on it at the middles of equal parts of the angle that the lamp sees of the ray.
#[derive(Clone, Copy, Debug)]
pub struct Sight<S: Scalar> {
    part: Part<S::Power>,
    height: S::Power,
    halvings: u8,
}

impl<S: Scalar> Sight<S> {
    /// Returns the view of a ray from a lamp at the distance `height`, above 0, from the ray's line. `from` and `to` are the ends of the ray
    /// along the line, measured from the foot of the lamp; `to` is the larger one. There are `2^halvings` places, at least 16.
    pub fn new(height: S, from: S, to: S, halvings: u8) -> Self {
        let (start, end) = (End::new(height, from), End::new(height, to));
        let height = height.positive();
        let width = if (from < S::ZERO) == (to < S::ZERO) {
            (to - from).positive()
        } else {
            size(from).plus(size(to))
        };
        // The half of the angle, by the halves of the ends' angles with the lamp's foot. No cosine is 0: the ray is not endless.
        let least = S::Unit::ratio(1, 1 << 24);
        let cosine = start.cosine.times(end.cosine) + start.sine.times(end.sine);
        let cosine = if cosine < least { least } else { cosine };
        // Of the two forms of the sine each is exact where the other is a difference or a quotient of small numbers.
        let sine = if cosine < S::Unit::ratio(1, 2) {
            (end.sine.times(start.cosine) - start.sine.times(end.cosine)).positive()
        } else {
            height.times(width).over(start.away.times(end.away).times(cosine.positive())).times(half())
        };
        let before = S::ZERO.positive();
        let part = Part { before, width, start: start.away, end: end.away, cosine: cosine.positive(), sine };
        Self { part, height, halvings: halvings.max(FEWEST) }
    }

    /// Calls `see` with each place: its distance from the start of the ray and that from the lamp.
    pub fn places(&self, see: &mut impl FnMut(S::Power, S::Power)) {
        self.part.each(self.halvings, &mut |part| {
            let middle = part.width.times(part.start).over(part.start.plus(part.end));
            see(part.before.plus(middle), part.middle());
        });
    }

    /// Calls `see` with the distance from the start of the ray of one place in each of the equal parts of the angle, as far within each:
    /// `shift` of it, 0 to 1. The mean over all shifts is the integral, but for 4th powers of a part's angle.
    pub fn shifted(&self, shift: S::Unit, see: &mut impl FnMut(S::Power)) {
        let (shift, rest) = (shift.positive(), (S::Unit::ONE - shift).positive());
        self.part.each(self.halvings, &mut |part| {
            // A line from a triangle's corner cuts the side across from it as the sides are to each other, each times the sine of its part
            // of the angle; these are small, and nearly as their angles.
            let (near, far) = (part.start.times(shift), part.end.times(rest));
            see(part.before.plus(part.width.times(near).over(near.plus(far))));
        });
    }

    /// Returns a quarter of the integral of `f / r^2` over the ray, for the sum of f over its places.
    pub fn integral(&self, sum: S::Power) -> S::Power {
        // The mean over the angle, times the angle.
        let mean = sum.times(S::Power::new(1, -i32::from(self.halvings) - 2));
        mean.times(self.part.angle(self.halvings)).over(self.height)
    }
}

fn half<P: Positive>() -> P {
    P::new(1, -1)
}

/// Returns the absolute value of a length.
fn size<S: Scalar>(length: S) -> S::Power {
    if length < S::ZERO { (-length).positive() } else { length.positive() }
}

/// One end of a ray, as the lamp sees it.
struct End<S: Scalar> {
    /// Its distance from the lamp.
    away: S::Power,
    /// Cosine of half of the angle between the end and the foot.
    cosine: S::Unit,
    /// Sine of that half; negative before the foot.
    sine: S::Unit,
}

impl<S: Scalar> End<S> {
    fn new(height: S, place: S) -> Self {
        let (height, along) = (height.positive(), size(place));
        let away = height.times(height).plus(along.times(along)).root();
        let sum = away.plus(height);
        let cosine = sum.over(away).times(half()).root().unit();
        let sine = along.over(away.times(sum).plus(away.times(sum)).root()).unit();
        Self { away, cosine, sine: if place < S::ZERO { -sine } else { sine } }
    }
}

/// A part of a ray.
#[derive(Clone, Copy, Debug)]
struct Part<P> {
    /// Length of the ray before it.
    before: P,
    /// Its length.
    width: P,
    /// Distance of its start from the lamp.
    start: P,
    /// Distance of its end from the lamp.
    end: P,
    /// Cosine of half of the angle that the lamp sees of it.
    cosine: P,
    /// Sine of that half.
    sine: P,
}

impl<P: Positive> Part<P> {
    /// Returns the two parts that the lamp sees as equally large. A bisector of a triangle's angle cuts the side across from it as
    /// the other two are to each other, so that nothing has to be subtracted.
    fn halves(self) -> [Self; 2] {
        let sum = self.start.plus(self.end);
        let middle = self.middle();
        let cosine = P::new(1, 0).plus(self.cosine).times(half()).root();
        let sine = self.sine.over(cosine).times(half());
        let width = self.width.times(self.start).over(sum);
        let first = Self { width, end: middle, cosine, sine, ..self };
        let rest = self.width.times(self.end).over(sum);
        [first, Self { before: self.before.plus(width), width: rest, start: middle, cosine, sine, ..self }]
    }

    /// Returns the distance of its middle, as the lamp sees it, from the lamp.
    fn middle(self) -> P {
        let twice = self.start.times(self.end).over(self.start.plus(self.end));
        twice.plus(twice).times(self.cosine)
    }

    /// Calls `see` with each of `2^halvings` parts that the lamp sees as equally large.
    fn each(self, halvings: u8, see: &mut impl FnMut(Self)) {
        if halvings == 0 {
            return see(self);
        }
        for half in self.halves() {
            half.each(halvings - 1, see);
        }
    }

    /// Returns the angle that the lamp sees of the part (radians), by the arcsine's series for that of `2^-halvings` of it.
    fn angle(self, halvings: u8) -> P {
        let mut part = self;
        for _ in 0..halvings {
            [part, _] = part.halves();
        }
        let square = part.sine.times(part.sine);
        let third = P::new(3, 0).over(P::new(40, 0)).times(square).plus(P::new(1, 0).over(P::new(6, 0)));
        let series = third.times(square).plus(P::new(1, 0)).times(part.sine);
        series.times(P::new(1, i32::from(halvings) + 1))
    }
}
