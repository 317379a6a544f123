//! Vectors of both twins: each the native one of its format.

use core::ops::{Add, Neg, Sub};

use rta_core::Scalar;
use rta_core::vector::{LengthVector, Plan, UnitVec3, UnitVector, Vec3, Vector};

use crate::{Bare, Format, Paired, UnitFormat, Value, log};

/// A vector of the format under test and its twin in `f64`.
#[derive(Clone, Copy, Debug)]
pub struct PairedVector<V> {
    /// The vector in the format under test.
    pub format: V,
    /// The vector in `f64`.
    pub twin: Vec3<f64>,
}

impl<V: Vector<Component: Value>> PairedVector<V> {
    fn components(self) -> [Paired<V::Component>; 3] {
        [self.x(), self.y(), self.z()]
    }

    /// Error of the component that is farthest off.
    pub(crate) fn error(self) -> f64 {
        self.components().map(Paired::error).into_iter().fold(0.0, f64::max)
    }

    /// The lengths of the two, to tell them apart in a log.
    fn lengths(self) -> [f64; 2] {
        let square = self.components().map(Paired::values);
        let [format, twin] = square.iter().fold([0.0, 0.0], |[a, b], [x, y]| [a + x * x, b + y * y]);
        [format.sqrt(), twin.sqrt()]
    }

    #[track_caller]
    pub(crate) fn noted(self, name: &'static str, operands: impl IntoIterator<Item = f64>) -> Self {
        let [x, y, z] = self.components();
        let worse =
            |a: Paired<V::Component>, b: Paired<V::Component>| if b.error() > a.error() { b } else { a };
        let worst = worse(worse(x, y), z);
        let size = [x, y, z].iter().fold(0.0, |size: f64, c| size.max(c.format.value().abs()));
        log::operation(name, (V::Component::KIND, size), worst.values(), worst.error(), operands);
        self
    }
}

/// Vectors are equal where the format says so; the tracer never asks.
impl<V: PartialEq> PartialEq for PairedVector<V> {
    fn eq(&self, other: &Self) -> bool {
        self.format == other.format
    }
}

impl<V: Vector<Component: Value>> Add for PairedVector<V> {
    type Output = Self;
    #[track_caller]
    fn add(self, other: Self) -> Self {
        Self { format: self.format + other.format, twin: self.twin + other.twin }
            .noted("+", [self.error(), other.error()])
    }
}

impl<V: Vector<Component: Value>> Sub for PairedVector<V> {
    type Output = Self;
    #[track_caller]
    fn sub(self, other: Self) -> Self {
        Self { format: self.format - other.format, twin: self.twin - other.twin }
            .noted("-", [self.error(), other.error()])
    }
}

impl<V: Vector> Neg for PairedVector<V> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { format: -self.format, twin: -self.twin }
    }
}

impl<V: Vector<Component: Value>> Vector for PairedVector<V> {
    type Component = Paired<V::Component>;
    fn new(x: Self::Component, y: Self::Component, z: Self::Component) -> Self {
        Self { format: V::new(x.format, y.format, z.format), twin: Vector::new(x.twin, y.twin, z.twin) }
    }
    fn x(self) -> Self::Component {
        Paired { format: self.format.x(), twin: self.twin.x }
    }
    fn y(self) -> Self::Component {
        Paired { format: self.format.y(), twin: self.twin.y }
    }
    fn z(self) -> Self::Component {
        Paired { format: self.format.z(), twin: self.twin.z }
    }
}

/// The plan of the format and that of `f64`.
fn plans<S: Format>(plan: Plan<Paired<S>>) -> (Plan<S>, Plan<f64>) {
    let Plan { x, y, stretch } = plan;
    (
        Plan { x: x.format, y: y.format, stretch: stretch.format },
        Plan { x: x.twin, y: y.twin, stretch: stretch.twin },
    )
}

impl<V: LengthVector<Component: Value, Scalar: Format>> LengthVector for PairedVector<V> {
    type Scalar = Paired<V::Scalar>;

    #[track_caller]
    fn dot(self, direction: UnitVec3<Self::Scalar>) -> Self::Scalar {
        Paired {
            format: LengthVector::dot(self.format, direction.format),
            twin: LengthVector::dot(self.twin, direction.twin),
        }
        .noted("dot", [self.error(), direction.error()])
    }
    #[track_caller]
    fn norm_squared(self) -> <Self::Scalar as Scalar>::Wide {
        Paired { format: self.format.norm_squared(), twin: self.twin.norm_squared() }
            .noted("norm_squared", [self.error()])
    }
    #[track_caller]
    fn along(self, direction: UnitVec3<Self::Scalar>, distance: Self::Scalar) -> Self {
        Self {
            format: self.format.along(direction.format, distance.format),
            twin: self.twin.along(direction.twin, distance.twin),
        }
        .noted("along", [self.error(), direction.error(), distance.error()])
    }
    #[track_caller]
    fn reject(self, direction: UnitVec3<Self::Scalar>, distance: Self::Scalar) -> Self {
        Self {
            format: LengthVector::reject(self.format, direction.format, distance.format),
            twin: LengthVector::reject(self.twin, direction.twin, distance.twin),
        }
        .noted("reject", [self.error(), direction.error(), distance.error()])
    }
    #[track_caller]
    fn local(
        self,
        direction: UnitVec3<Self::Scalar>,
        distance: Self::Scalar,
        radius: <Self::Scalar as Scalar>::Inverse,
    ) -> UnitVec3<Self::Scalar> {
        PairedVector {
            format: self.format.local(direction.format, distance.format, radius.format),
            twin: self.twin.local(direction.twin, distance.twin, radius.twin),
        }
        .noted("local", [self.error(), direction.error(), distance.error()])
    }
    #[track_caller]
    fn normalize(self) -> Option<(UnitVec3<Self::Scalar>, Self::Scalar, <Self::Scalar as Scalar>::Inverse)> {
        let (format, twin) = (LengthVector::normalize(self.format), LengthVector::normalize(self.twin));
        log::decision("normalize", self.lengths(), [0.0, 0.0], format.is_some(), twin.is_some());
        let (direction, length, inverse) = format?;
        let (twin, twin_length, twin_inverse) = twin.unwrap_or((self.twin, 0.0, 0.0));
        let direction = PairedVector { format: direction, twin }.noted("normalize", [self.error()]);
        let length = Paired { format: length, twin: twin_length }.noted("length", [self.error()]);
        Some((direction, length, Bare { format: inverse, twin: twin_inverse }))
    }
    fn clearance(self, extent: Self::Scalar) -> (Self::Scalar, Self::Scalar) {
        let (step, most) = self.format.clearance(extent.format);
        let (twin_step, twin_most) = self.twin.clearance(extent.twin);
        (Paired { format: step, twin: twin_step }, Paired { format: most, twin: twin_most })
    }
    #[track_caller]
    fn dot_plan(self, plan: Plan<Self::Scalar>) -> Self::Scalar {
        let error = plan.x.error().max(plan.y.error());
        let (format, twin) = plans(plan);
        Paired { format: self.format.dot_plan(format), twin: self.twin.dot_plan(twin) }
            .noted("dot_plan", [self.error(), error])
    }
    #[track_caller]
    fn cross_plan(self, plan: Plan<Self::Scalar>) -> Self::Scalar {
        let error = plan.x.error().max(plan.y.error());
        let (format, twin) = plans(plan);
        Paired { format: self.format.cross_plan(format), twin: self.twin.cross_plan(twin) }
            .noted("cross_plan", [self.error(), error])
    }
    #[track_caller]
    fn cross_plan_over(
        self,
        plan: Plan<Self::Scalar>,
        radius: <Self::Scalar as Scalar>::Inverse,
    ) -> <Self::Scalar as Scalar>::Unit {
        let error = plan.x.error().max(plan.y.error());
        let (format, twin) = plans(plan);
        Paired {
            format: self.format.cross_plan_over(format, radius.format),
            twin: self.twin.cross_plan_over(twin, radius.twin),
        }
        .noted("cross_plan_over", [self.error(), error])
    }
}

impl<V: UnitVector<Component: UnitFormat>> UnitVector for PairedVector<V> {
    const X: Self = Self { format: V::X, twin: <Vec3<f64> as UnitVector>::X };
    const Y: Self = Self { format: V::Y, twin: <Vec3<f64> as UnitVector>::Y };
    const Z: Self = Self { format: V::Z, twin: <Vec3<f64> as UnitVector>::Z };

    #[track_caller]
    fn dot(self, other: Self) -> Self::Component {
        Paired {
            format: UnitVector::dot(self.format, other.format),
            twin: UnitVector::dot(self.twin, other.twin),
        }
        .noted("cosine", [self.error(), other.error()])
    }
    #[track_caller]
    fn cross(self, other: Self) -> Self {
        Self {
            format: UnitVector::cross(self.format, other.format),
            twin: UnitVector::cross(self.twin, other.twin),
        }
        .noted("cross", [self.error(), other.error()])
    }
    #[track_caller]
    fn scale(self, factor: Self::Component) -> Self {
        Self { format: self.format.scale(factor.format), twin: UnitVector::scale(self.twin, factor.twin) }
            .noted("scale", [self.error(), factor.error()])
    }
    #[track_caller]
    fn times(self, other: Self) -> Self {
        Self { format: self.format.times(other.format), twin: UnitVector::times(self.twin, other.twin) }
            .noted("times", [self.error(), other.error()])
    }
    #[track_caller]
    fn plus(self, other: Self, factor: Self::Component) -> Self {
        Self {
            format: self.format.plus(other.format, factor.format),
            twin: UnitVector::plus(self.twin, other.twin, factor.twin),
        }
        .noted("plus", [self.error(), other.error(), factor.error()])
    }
    #[track_caller]
    fn normalize(self) -> Option<(Self, <Self::Component as rta_core::scalar::Unit>::Inverse)> {
        let (format, twin) = (UnitVector::normalize(self.format), UnitVector::normalize(self.twin));
        log::decision("normalize", self.lengths(), [0.0, 0.0], format.is_some(), twin.is_some());
        let (direction, inverse) = format?;
        let (twin, twin_inverse) = twin.unwrap_or((self.twin, 0.0));
        let direction = Self { format: direction, twin }.noted("normalize", [self.error()]);
        Some((direction, Bare { format: inverse, twin: twin_inverse }))
    }
    #[track_caller]
    fn reflect(self, normal: Self) -> Self {
        Self {
            format: UnitVector::reflect(self.format, normal.format),
            twin: UnitVector::reflect(self.twin, normal.twin),
        }
        .noted("reflect", [self.error(), normal.error()])
    }
    #[track_caller]
    fn halfway(self, other: Self) -> Option<Self> {
        let (format, twin) = (self.format.halfway(other.format), self.twin.halfway(other.twin));
        log::decision("halfway", self.lengths(), other.lengths(), format.is_some(), twin.is_some());
        let halfway = Self { format: format?, twin: twin.unwrap_or(self.twin) };
        Some(halfway.noted("halfway", [self.error(), other.error()]))
    }
    #[track_caller]
    fn half_chord(self, radius: Self::Component) -> Option<Self::Component> {
        let (format, twin) = (self.format.half_chord(radius.format), self.twin.half_chord(radius.twin));
        log::decision("half_chord", self.lengths(), radius.values(), format.is_some(), twin.is_some());
        let half = Paired { format: format?, twin: twin.unwrap_or(0.0) };
        Some(half.noted("half_chord", [self.error(), radius.error()]))
    }
    #[track_caller]
    fn plan<S: Scalar<Unit = Self::Component>>(self) -> Option<Plan<S>> {
        let format = self.format.plan::<<V::Component as UnitFormat>::Length>();
        let twin = self.twin.plan::<f64>();
        log::decision("plan", self.lengths(), [0.0, 0.0], format.is_some(), twin.is_some());
        let format = format?;
        let twin = twin.unwrap_or(Plan { x: self.twin.x, y: self.twin.y, stretch: 0.0 });
        let x = Paired { format: format.x, twin: twin.x }.noted("plan", [self.error()]);
        let y = Paired { format: format.y, twin: twin.y }.noted("plan", [self.error()]);
        Some(Plan { x, y, stretch: Bare { format: format.stretch, twin: twin.stretch } })
    }
}
