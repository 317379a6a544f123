//! R. L. Cook and K. E. Torrance, "A Reflectance Model for Computer Graphics", ACM Transactions on Graphics 1 (1982).

use super::microfacet::{Attenuation, Beckmann, Facet, Roughness, Sancer, TorranceSparrow, mixed};
use super::table::{Kind, MOST_SLOPES, Properties, Reflecting, Reflection, Row, Tabled, Value};
use super::{Illumination, Secondary};
use crate::color::Rgb;
use crate::light::Incident;
use crate::needs::Needs;
use crate::scalar::vector::UnitVector;
use crate::scalar::{Light, Positive, Scalar, Unit};
use crate::surface::Surface;

/// `I = ka C Ia + sum S E (s D G F / (4 N.V) + (1 - s) C N.L)`
///
/// A rough surface of small mirrors whose slopes are distributed as Beckmann has it. E is attenuated with the square of the distance and
/// knows the size of the lamp. The paper's constant would return up to four times the light that falls in; this one never returns
/// more than that. The model asks for no transmitted ray: glass is drawn as what it is on its surface.
///
/// | of the thesis's types | s | diffuse | reflected ray |
/// | --- | --- | --- | --- |
/// | 0, opaque | 0 | C | none |
/// | 1, shiny | .2 of the index 1.5 | .8 C | none |
/// | 2, mirror | 0 | none | F, the object's colour where it is met perpendicularly |
/// | 3, glass | .2 of its index | .8 C | none |
///
/// Dielectrics have s .2, metals 1, unless they say otherwise; slopes are .3. `G` is how facets hide each other: [`Grooves`] or
/// [`Slopes`], or one of them in [`Published`]. `F` is what they reflect: [`Reflection`], or for metals by their complex index of
/// refraction [`Exact`](super::table::Exact).
#[derive(Clone, Copy, Debug)]
pub struct CookTorrance<'a, S: Scalar, G = Grooves, F = Reflection<S>> {
    /// The materials.
    pub rows: &'a [CookTorranceRow<S, F>],
    /// How facets hide each other.
    pub hidden: G,
}

impl<S: Scalar> Default for CookTorrance<'static, S> {
    fn default() -> Self {
        Self::with_hidden(Grooves)
    }
}

impl<S: Scalar, G, F> CookTorrance<'static, S, G, F> {
    /// Returns the model with facets that hide each other so.
    pub fn with_hidden(hidden: G) -> Self {
        Self { rows: &[], hidden }
    }
}

/// How facets hide each other.
pub trait Hidden<U: Unit>: Copy + Send + Sync {
    /// Whether the surface returns no more light than it gets.
    const BALANCED: bool = true;
    /// Returns the part of the facets that are lit and seen, 0 to 1, of a surface with those slopes.
    fn passed(&self, facet: &Facet<U>, slopes: &[Roughness<U>]) -> U;
}

/// As the sides of V-shaped grooves: [`TorranceSparrow`].
#[derive(Clone, Copy, Debug, Default)]
pub struct Grooves;

/// As the slopes of a rough surface: [`Sancer`].
#[derive(Clone, Copy, Debug, Default)]
pub struct Slopes;

/// Facets with the constant that the paper prints, which makes them four times as bright.
#[derive(Clone, Copy, Debug, Default)]
pub struct Published<G>(pub G);

impl<U: Unit, G: Hidden<U>> Hidden<U> for Published<G> {
    const BALANCED: bool = false;
    fn passed(&self, facet: &Facet<U>, slopes: &[Roughness<U>]) -> U {
        self.0.passed(facet, slopes)
    }
}

impl<U: Unit> Hidden<U> for Grooves {
    fn passed(&self, facet: &Facet<U>, _slopes: &[Roughness<U>]) -> U {
        TorranceSparrow.passed(facet)
    }
}

impl<U: Unit> Hidden<U> for Slopes {
    fn passed(&self, facet: &Facet<U>, slopes: &[Roughness<U>]) -> U {
        Sancer(slopes).passed(facet)
    }
}

/// What Cook's and Torrance's model must know of a material.
#[derive(Clone, Copy, Debug)]
pub struct CookTorranceRow<S: Scalar, F = Reflection<S>> {
    /// ka, 0 or more.
    pub ambient: S::Unit,
    /// s, the share of the light that facets reflect, 0 to 1.
    pub share: S::Unit,
    /// Whether the rest of the light is reflected diffusely.
    pub is_diffuse: bool,
    /// What facets reflect.
    pub reflection: F,
    /// Their slopes; those of a share of 0 are left out.
    pub slopes: [Roughness<S::Unit>; MOST_SLOPES],
    /// The share of the light of the reflected ray, 0 to 1.
    pub mirror: S::Unit,
}

impl<S: Scalar, F: Reflecting<S>> Row<S> for CookTorranceRow<S, F> {
    const NAME: &'static str = "CookTorranceRow";
    fn fields(&self, mut see: impl FnMut(&'static str, Value<S>)) {
        see("ambient", Value::Unit(self.ambient));
        see("share", Value::Unit(self.share));
        see("is_diffuse", Value::Flag(self.is_diffuse));
        see("reflection", self.reflection.value());
        see("slopes", Value::Slopes(self.slopes));
        see("mirror", Value::Unit(self.mirror));
    }
}

/// Returns the slopes of the facets of a material; behind them entries of a share of 0, which [`Roughness::used`] leaves out.
pub fn beckmann_slopes<S: Scalar>(material: &impl Properties<S>) -> [Roughness<S::Unit>; MOST_SLOPES] {
    let first = material.slope(0).unwrap_or_else(|| Roughness {
        share: S::Unit::ONE,
        inverse: <S::Unit as Unit>::Positive::new(10, 0).over(Positive::new(3, 0)),
    });
    let none = Roughness { share: S::Unit::ZERO, inverse: first.inverse };
    let rest = |index| material.slope(index).unwrap_or(none);
    [first, rest(1), rest(2), rest(3)]
}

impl<S: Scalar, F> CookTorranceRow<S, F> {
    fn slopes(&self) -> &[Roughness<S::Unit>] {
        Roughness::used(&self.slopes)
    }
}

impl<S: Scalar, G: Hidden<S::Unit>, F: Reflecting<S> + 'static> Tabled<S> for CookTorrance<'_, S, G, F> {
    type Row = CookTorranceRow<S, F>;
    type Over<'r> = CookTorrance<'r, S, G, F>;

    fn row(&self, material: &impl Properties<S>) -> CookTorranceRow<S, F> {
        let (zero, one) = (S::Unit::ZERO, S::Unit::ONE);
        let kind = material.kind();
        let share = match kind {
            Kind::Metal => one,
            Kind::Opaque if material.index().is_some() => S::Unit::ratio(1, 5),
            Kind::Opaque | Kind::Mirror => zero,
            Kind::Shiny | Kind::Glass => S::Unit::ratio(1, 5),
        };
        CookTorranceRow {
            ambient: material.ambient().unwrap_or(if kind == Kind::Mirror { zero } else { one }),
            share: material.specular().filter(|_| kind != Kind::Mirror).unwrap_or(share),
            is_diffuse: kind != Kind::Mirror,
            reflection: F::of(material),
            slopes: beckmann_slopes(material),
            mirror: material.mirror().unwrap_or(if kind == Kind::Mirror { one } else { zero }),
        }
    }

    fn over<'r>(&self, rows: &'r [CookTorranceRow<S, F>]) -> CookTorrance<'r, S, G, F> {
        CookTorrance { rows, hidden: self.hidden }
    }
}

impl<S: Scalar, G, F> CookTorrance<'_, S, G, F> {
    fn row_of(&self, surface: &Surface<S>) -> Option<&CookTorranceRow<S, F>> {
        self.rows.get(usize::from(surface.number))
    }
}

impl<S: Scalar, G: Hidden<S::Unit>, F: Reflecting<S>> Illumination<S> for CookTorrance<'_, S, G, F> {
    type Weight = Rgb<S::Unit>;
    const REFRACTS: bool = false;

    fn ambient<N: Needs>(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light> {
        let part = self.row_of(surface).map_or(S::Unit::ONE, |row| row.ambient);
        ambient.zip(surface.color, |light, color| light.times(color.times(part)))
    }

    fn is_lit<N: Needs>(&self, _surface: &Surface<S>) -> bool {
        true
    }

    fn direct<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light> {
        let (zero, one) = (S::Unit::ZERO, S::Unit::ONE);
        let none = zero.positive();
        let row = self.row_of(surface);
        let (share, is_diffuse) = row.map_or((zero, true), |row| (row.share, row.is_diffuse));
        let facet = row.filter(|row| row.share > zero).zip(Facet::between::<S>(
            surface.normal,
            incident.direction,
            -surface.incoming,
        ));
        // D G / (4 N.V), or D G / (N.V), for facets that reflect all, and what they reflect.
        let (mirrored, part) = facet.map_or((none, Rgb::new(zero, zero, zero)), |(row, facet)| {
            let slopes = row.slopes();
            let passed = Passed(self.hidden.passed(&facet, slopes));
            let mirrored = if G::BALANCED {
                facet.balanced_reflectance(&Beckmann(slopes), &passed, one)
            } else {
                facet.reflectance(&Beckmann(slopes), &passed, one)
            };
            (mirrored, row.reflection.at(surface.color, surface.inside, facet.incidence))
        });
        let cosine = if is_diffuse { incident.cosine } else { zero };
        let reflectance = surface
            .color
            .zip(part, |color, part| mixed(share, mirrored.times(part.positive()), color, cosine));
        incident.reflected::<N>(reflectance, true)
    }

    fn diffuse<N: Needs>(&self, surface: &Surface<S>) -> Rgb<S::Unit> {
        let (zero, one) = (S::Unit::ZERO, S::Unit::ONE);
        let part =
            self.row_of(surface).map_or(one, |row| if row.is_diffuse { one - row.share } else { zero });
        surface.color.map(|color| color.times(part))
    }

    fn secondary<N: Needs>(&self, surface: &Surface<S>) -> Secondary<Self::Weight> {
        let Some(row) = self.row_of(surface).filter(|row| row.mirror > S::Unit::ZERO) else {
            return Secondary::NONE;
        };
        let cosine = -surface.normal.dot(surface.incoming);
        let weight =
            row.reflection.at(surface.color, surface.inside, cosine).map(|part| part.times(row.mirror));
        Secondary { reflected: Some(weight), ..Secondary::NONE }
    }
}

/// A part of the facets that is known.
struct Passed<U>(U);

impl<U: Unit> Attenuation<U> for Passed<U> {
    fn passed(&self, _facet: &Facet<U>) -> U {
        self.0
    }
}
