//! J. F. Blinn, "Models of Light Reflection for Computer Synthesized Pictures", SIGGRAPH 1977, in full: the surface of Torrance and
//! Sparrow (1967) with three distributions of facets.

use super::fresnel::dielectric;
use super::microfacet::{Distribution, Facet, Gauss, Power, Slope, TorranceSparrow, Trowbridge};
use super::table::{PositiveOf, Properties, Row, Tabled, Value};
use super::{Illumination, Secondary, Whitted};
use crate::color::Rgb;
use crate::light::Incident;
use crate::needs::Needs;
use crate::scalar::{Exponent, Positive, Scalar, Unit};
use crate::surface::Surface;

/// `I = ka C Ia + sum S I (kd C N.L + ks D G F / N.V) + ks I_ref + kt I_tra`
///
/// Highlights of a surface of small mirrors with the index of refraction 1.5 or the material's. They are not bounded: a model of looks.
/// All else is as in [`Whitted`], coefficients and rays too. `D` is how facets are distributed: [`ByPower`], [`ByGauss`] or
/// [`ByTrowbridge`], by default with half of them at 10 degrees.
#[derive(Clone, Copy, Debug)]
pub struct BlinnFull<'a, S: Scalar, D = ByTrowbridge> {
    /// The surface without highlights.
    pub surface: Whitted<S>,
    /// The materials.
    pub rows: &'a [BlinnFullRow<S>],
    /// How facets are distributed.
    pub distribution: D,
    /// What materials are taken for that do not say it.
    pub plain: BlinnFullRow<S>,
}

impl<S: Scalar> Default for BlinnFull<'static, S> {
    fn default() -> Self {
        Self::with_facets(ByTrowbridge)
    }
}

impl<S: Scalar, D> BlinnFull<'static, S, D> {
    /// Returns the model with a distribution of facets.
    pub fn with_facets(distribution: D) -> Self {
        Self { surface: Whitted::default(), rows: &[], distribution, plain: BlinnFullRow::default() }
    }
}

/// How facets are distributed on a material.
pub trait Facets<S: Scalar>: Copy + Send + Sync {
    /// Returns D, the relative number of facets that are tilted by the angle.
    fn density(&self, row: &BlinnFullRow<S>, slope: &Slope<S::Unit>) -> PositiveOf<S>;
}

/// [`Power`].
#[derive(Clone, Copy, Debug, Default)]
pub struct ByPower;

/// [`Gauss`].
#[derive(Clone, Copy, Debug, Default)]
pub struct ByGauss;

/// [`Trowbridge`].
#[derive(Clone, Copy, Debug, Default)]
pub struct ByTrowbridge;

impl<S: Scalar> Facets<S> for ByPower {
    fn density(&self, row: &BlinnFullRow<S>, slope: &Slope<S::Unit>) -> PositiveOf<S> {
        Power(row.exponent).density(slope)
    }
}

impl<S: Scalar> Facets<S> for ByGauss {
    fn density(&self, row: &BlinnFullRow<S>, slope: &Slope<S::Unit>) -> PositiveOf<S> {
        Gauss { narrowness: row.narrowness }.density(slope)
    }
}

impl<S: Scalar> Facets<S> for ByTrowbridge {
    fn density(&self, row: &BlinnFullRow<S>, slope: &Slope<S::Unit>) -> PositiveOf<S> {
        Trowbridge { roundness: row.roundness }.density(slope)
    }
}

/// The parameters of one of the distributions for one surface.
struct On<'a, S: Scalar, D>(&'a BlinnFullRow<S>, D);

impl<S: Scalar, D: Facets<S>> Distribution<S::Unit> for On<'_, S, D> {
    fn density(&self, slope: &Slope<S::Unit>) -> PositiveOf<S> {
        self.1.density(self.0, slope)
    }
}

/// What Blinn's model must know of a material.
#[derive(Clone, Copy, Debug)]
pub struct BlinnFullRow<S: Scalar> {
    /// n of [`ByPower`].
    pub exponent: Exponent,
    /// c of [`ByGauss`].
    pub narrowness: PositiveOf<S>,
    /// c of [`ByTrowbridge`].
    pub roundness: S::Unit,
    /// The smaller of the indices of refraction inside and outside over the larger.
    pub q: S::Unit,
    /// Whether the inside has the larger index.
    pub denser: bool,
}

impl<S: Scalar> Default for BlinnFullRow<S> {
    /// Half of the facets at 10 degrees, and the index 1.5.
    fn default() -> Self {
        Self {
            exponent: Exponent::new(46_364, 10),            // 45.278
            narrowness: PositiveOf::<S>::new(312_619, -16), // 4.7702
            roundness: S::Unit::ratio(260_495, 1_000_000),
            q: S::Unit::ratio(2, 3),
            denser: true,
        }
    }
}

impl<S: Scalar> Row<S> for BlinnFullRow<S> {
    const NAME: &'static str = "BlinnFullRow";
    fn fields(&self, mut see: impl FnMut(&'static str, Value<S>)) {
        see("exponent", Value::Exponent(self.exponent));
        see("narrowness", Value::Positive(self.narrowness));
        see("roundness", Value::Unit(self.roundness));
        see("q", Value::Unit(self.q));
        see("denser", Value::Flag(self.denser));
    }
}

impl<S: Scalar, D: Facets<S>> Tabled<S> for BlinnFull<'_, S, D> {
    type Row = BlinnFullRow<S>;
    type Over<'r> = BlinnFull<'r, S, D>;

    fn row(&self, material: &impl Properties<S>) -> BlinnFullRow<S> {
        let plain = &self.plain;
        let (q, denser) = material.index().unwrap_or((plain.q, plain.denser));
        BlinnFullRow {
            exponent: material.exponent().unwrap_or(plain.exponent),
            narrowness: material.narrowness().unwrap_or(plain.narrowness),
            roundness: material.roundness().unwrap_or(plain.roundness),
            q,
            denser,
        }
    }

    fn over<'r>(&self, rows: &'r [BlinnFullRow<S>]) -> BlinnFull<'r, S, D> {
        BlinnFull { surface: self.surface, rows, distribution: self.distribution, plain: self.plain }
    }
}

impl<S: Scalar, D: Facets<S>> Illumination<S> for BlinnFull<'_, S, D> {
    type Weight = S::Unit;
    const ATTENUATION: bool = false;

    fn ambient<N: Needs>(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light> {
        self.surface.ambient::<N>(surface, ambient)
    }

    fn is_lit<N: Needs>(&self, _surface: &Surface<S>) -> bool {
        true
    }

    fn direct<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light> {
        let (kd, ks, _) = self.surface.coefficients::<N>(surface.material, |finish| finish.exponent);
        let row = self.rows.get(usize::from(surface.number)).unwrap_or(&self.plain);
        let facet = Facet::between::<S>(surface.normal, incident.direction, -surface.incoming);
        let highlight = facet.filter(|_| ks > S::Unit::ZERO).map_or(S::Unit::ZERO.positive(), |facet| {
            let reflected = dielectric(row.q, row.denser != surface.inside, facet.incidence);
            let distribution = On(row, self.distribution);
            facet.reflectance(&distribution, &TorranceSparrow, reflected).times(ks.positive())
        });
        let diffuse = kd.times(incident.cosine);
        incident
            .reflected::<N>(surface.color.map(|color| color.times(diffuse).positive().plus(highlight)), false)
    }

    fn diffuse<N: Needs>(&self, surface: &Surface<S>) -> Rgb<S::Unit> {
        self.surface.diffuse::<N>(surface)
    }

    fn secondary<N: Needs>(&self, surface: &Surface<S>) -> Secondary<S::Unit> {
        self.surface.secondary::<N>(surface)
    }
}
