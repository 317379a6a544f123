//! The functions that values can be stated of, by their names: the functions of the core that pictures are made with.

use rta_core::illumination::fade::{Phase, airlight, edge, fade, haze, transmittance};
use rta_core::illumination::fresnel::{Shift, dielectric, f0, index, inverse_index};
use rta_core::illumination::microfacet::{
    Attenuation, Beckmann, Distribution, Gauss, Power, Sancer, Slope, TorranceSparrow, Trowbridge, highlight,
    mixed, refracting,
};
use rta_core::illumination::{Blinn, Bouknight, Lambert, Phong, Romney, Whitted};
use rta_core::scalar::Unit;
use rta_core::vector::{UnitVec3, UnitVector};
use rta_scenes::gloss;
use rta_scenes::narrow::{Narrow, conductor, exponent};

use super::albedo::albedo;
use super::frame::{Lit, cosine, direction, facet, positive, reflected_lamp, roughness};
use super::spectrum;

/// A function that values can be stated of.
#[derive(Clone, Copy, Debug)]
pub struct Function {
    /// Its name.
    pub name: &'static str,
    /// The names of its arguments.
    pub arguments: &'static [&'static str],
    /// The relative error that it may have in fixed point.
    pub fixed: f64,
    /// The relative error that it may have in every format whatever is asked for, where the value is an integral.
    pub always: f64,
    /// Returns the value. There are as many numbers as arguments.
    pub compute: fn(&[f64]) -> f64,
}

/// The relative error of what is computed in a few operations in fixed point.
const NEAR: f64 = 1e-6;

/// Halvings of the angle of a ray through air, so that what is left of the error of the sum is below a millionth.
const HALVINGS: u8 = 12;

macro_rules! functions {
    ($($name:ident($($argument:ident),*) within $fixed:expr $(, always $always:expr)? => $value:expr;)*) => {
        vec![$(Function {
            name: stringify!($name),
            arguments: &[$(stringify!($argument)),*],
            fixed: $fixed,
            always: 0.0 $(+ $always)?,
            compute: |numbers| {
                let [$($argument),*] = *numbers else { return f64::NAN };
                $value
            },
        }),*]
    };
}

pub(super) use functions;

/// Returns the functions of light, as they are computed in the format `S`. Angles are in degrees.
pub(super) fn all<S: Narrow>() -> Vec<Function> {
    functions! {
        lamp(p, r, d) within NEAR => reflected_lamp::<S>(positive::<S>(1.0), [p, r, d]);
        fade(p, d, d0) within NEAR => unit::<S>(fade(S::length(d), S::length(d0), exponent(p)));
        haze(d, i, t) within NEAR => unit::<S>(haze(S::length(d), S::length(i), S::length(t)));
        lambert(tl) within NEAR => Lit::<S>::new(tl, 0.0, 0.0).light(&Lambert::default(), 0.0);
        bouknight(ka, kd, p, tl) within NEAR => {
            let model = Bouknight { ka: S::unit(ka), kd: S::unit(kd), exponent: exponent(p) };
            Lit::<S>::new(tl, 0.0, 0.0).light(&model, 1.0)
        };
        romney(p, tv, d, d0) within NEAR => {
            let lit = Lit { distance: S::length(d), ..Lit::<S>::new(0.0, tv, 0.0) };
            lit.light(&Romney { exponent: exponent(p), reference: S::length(d0) }, 0.0)
        };
        phong(tl, tv, phi, n) within NEAR =>
            Lit::<S>::new(tl, tv, phi).finish(0.0, 1.0, n).light(&Phong::default(), 0.0);
        blinn(tl, tv, phi, n) within NEAR =>
            Lit::<S>::new(tl, tv, phi).finish(0.0, 1.0, n).light(&Blinn::default(), 0.0);
        whitted(kd, ks, n, tl, tv, phi) within NEAR =>
            Lit::<S>::new(tl, tv, phi).finish(kd, ks, n).light(&Whitted::default(), 0.0);
        d_power(n, a) within NEAR => density::<S>(&Power(exponent(n)), a);
        d_gauss(c, a) within NEAR => density::<S>(&gauss::<S>(c), a);
        d_tr(c, a) within NEAR => density::<S>(&Trowbridge { roundness: S::unit(c) }, a);
        d_beckmann(m, a) within NEAR => density::<S>(&Beckmann(&[roughness::<S>(1.0, m)]), a);
        d_two(w1, m1, m2, a) within NEAR =>
            density::<S>(&Beckmann(&[roughness::<S>(w1, m1), roughness::<S>(1.0 - w1, m2)]), a);
        n_blinn(b) within NEAR => rounded_exponent(gloss::blinn(b));
        n_phong(b) within NEAR => rounded_exponent(gloss::phong(b));
        c_gauss(b) within NEAR => S::power_to_f64(positive::<S>(gloss::gauss(b)));
        c_tr(b) within NEAR => unit::<S>(S::unit(gloss::trowbridge(b)));
        m_beckmann(b) within NEAR => S::power_to_f64(positive::<S>(gloss::beckmann(b)));
        g_ts(tl, tv, phi) within NEAR => passed::<S>(&TorranceSparrow, tl, tv, phi);
        g_sancer(tl, tv, m) within NEAR => passed::<S>(&Sancer(&[roughness::<S>(1.0, m)]), tl, tv, 180.0);
        fresnel(eta, angle) within NEAR => unit::<S>(reflected::<S>(eta, cosine::<S>(angle)));
        fresnel_k(eta, k, angle) within NEAR => {
            unit::<S>(conductor::<S>([eta, k]).reflectance(cosine::<S>(angle)))
        };
        f0(eta, k) within NEAR => unit::<S>(f0::<S::Unit>(positive::<S>(eta), positive::<S>(k)));
        eta_of(f0) within NEAR => S::power_to_f64(index(S::unit(f0)));
        q_of(f0) within NEAR => unit::<S>(inverse_index(S::unit(f0)));
        shift(f0, fm0, angle) within NEAR =>
            unit::<S>(Shift::new(S::unit(fm0)).reflectance(S::unit(f0), cosine::<S>(angle)));
        blinn_full(kind, parameter, eta, tl, tv, phi) within NEAR =>
            blinn_full::<S>(kind, parameter, eta, [tl, tv, phi]);
        ct(tl, tv, phi, m, f0) within NEAR => mirrored::<S>([tl, tv, phi], m, false, |c| of_f0::<S>(f0, c));
        ct_sancer(tl, tv, phi, m, f0) within NEAR => mirrored::<S>([tl, tv, phi], m, true, |c| of_f0::<S>(f0, c));
        ct_lit(s, c, m, f0, fm0, tl, tv, phi, p, r, d) within NEAR => {
            let mirrored = mirrored::<S>([tl, tv, phi], m, false, |cosine| {
                Shift::new(S::unit(fm0)).reflectance(S::unit(f0), cosine)
            });
            let mixed = mixed(S::unit(s), positive::<S>(mirrored), S::unit(c), cosine::<S>(tl));
            reflected_lamp::<S>(mixed, [p, r, d])
        };
        albedo(tv, m, g) within NEAR, always 1e-3 => albedo::<S>(tv, m, g);
        pseudo(tmin, tmax, n, tv) within NEAR =>
            unit::<S>(edge(S::unit(tmin), S::unit(tmax), exponent(n), cosine::<S>(tv)));
        absorb(a, d) within NEAR => unit::<S>(transmittance::<S>(positive::<S>(-a.log2()), S::length(d)));
        hall_h(tl, tv, phi, k) within NEAR => hall::<S>([tl, tv, phi], k, |facet, _| facet);
        hall_t(tl, tv, phi, k, n) within NEAR => hall::<S>([tl, tv, phi], k, |facet, light| {
            highlight(facet, exponent(n), S::Unit::ONE - reflected::<S>(k, light))
        });
        hall_r(f0, fm0, tl, tv, phi, n) within NEAR => facet::<S>(tl, tv, phi).map_or(0.0, |facet| {
            let reflected = Shift::new(S::unit(fm0)).reflectance(S::unit(f0), facet.incidence);
            unit::<S>(highlight(facet.slope.cosine, exponent(n), reflected))
        });
        fog(s, d) within NEAR => unit::<S>(left::<S>(s, d));
        phase(g, t) within NEAR => S::power_to_f64(Phase { forward: S::unit(g) }.scattered(cosine::<S>(t)));
        sunbeam(w, s, d, g, t) within NEAR => {
            let phase = Phase { forward: S::unit(g) };
            S::power_to_f64(phase.sunbeam(S::unit(w), cosine::<S>(t), left::<S>(s, d)))
        };
        airlight(s, h, t0, t1) within NEAR => {
            let [height, from, to] = [h, t0, t1].map(S::length);
            S::power_to_f64(airlight(positive::<S>(s), height, from, to, HALVINGS))
        };
        spectral(count, i, register) within NEAR => spectrum::weight::<S>(count, i, register);
        sellmeier(k, nm) within NEAR => spectrum::sellmeier::<S>(k, nm);
        rocksalt(nm) within NEAR => spectrum::built_in::<S>("rock-salt", nm);
        ethanol(nm) within NEAR => spectrum::built_in::<S>("ethyl-alcohol", nm);
        cauchy(nd, abbe, nm) within NEAR => spectrum::cauchy::<S>(nd, abbe, nm);
    }
}

impl Function {
    /// Returns the relative error that the function may have in f32 on top of that of its few operations: a power n makes n times as
    /// much of its base's rounding, and a highlight of the slope m is 1/m^2 as sensitive to a direction's.
    pub(super) fn single(&self, numbers: &[f64]) -> f64 {
        let part = |(name, &number): (&&str, &f64)| match *name {
            "n" => 3e-6 * number,
            "m" | "m1" | "m2" => 5e-6 / (number * number),
            _ => 0.0,
        };
        self.arguments.iter().zip(numbers).map(part).fold(0.0, f64::max)
    }
}

fn unit<S: Narrow>(value: S::Unit) -> f64 {
    S::unit_to_f64(value)
}

/// Returns an exponent as it is kept with a material.
fn rounded_exponent(value: f64) -> f64 {
    let (mantissa, places) = exponent(value).parts();
    f64::from(mantissa) / f64::from(1u32 << places)
}

fn gauss<S: Narrow>(c: f64) -> Gauss<S::Unit> {
    Gauss { narrowness: positive::<S>(c) }
}

fn density<S: Narrow>(distribution: &impl Distribution<S::Unit>, angle: f64) -> f64 {
    let slope = Slope::between(UnitVec3::<S>::Z, direction::<S>(angle, 0.0));
    S::power_to_f64(distribution.density(&slope))
}

fn passed<S: Narrow>(attenuation: &impl Attenuation<S::Unit>, tl: f64, tv: f64, phi: f64) -> f64 {
    facet::<S>(tl, tv, phi).map_or(0.0, |facet| unit::<S>(attenuation.passed(&facet)))
}

/// Returns an index of refraction as it is kept with a material: the smaller of it and its reciprocal, and whether it is above 1.
fn sides<S: Narrow>(eta: f64) -> (S::Unit, bool) {
    (S::unit(eta.min(1.0 / eta)), eta > 1.0)
}

/// Returns Fresnel's reflectance of a material without absorption.
fn reflected<S: Narrow>(eta: f64, cosine: S::Unit) -> S::Unit {
    let (q, denser) = sides::<S>(eta);
    dielectric(q, denser, cosine)
}

/// Returns Fresnel's reflectance of the index of refraction that belongs to a reflectance at perpendicular incidence.
fn of_f0<S: Narrow>(f0: f64, cosine: S::Unit) -> S::Unit {
    dielectric(inverse_index(S::unit(f0)), true, cosine)
}

/// Returns the reflectance of Cook's and Torrance's surface, by Sancer's attenuation or that of Torrance and Sparrow.
fn mirrored<S: Narrow>(
    [tl, tv, phi]: [f64; 3],
    m: f64,
    sancer: bool,
    fresnel: impl Fn(S::Unit) -> S::Unit,
) -> f64 {
    let Some(facet) = facet::<S>(tl, tv, phi) else { return 0.0 };
    let slopes = [roughness::<S>(1.0, m)];
    let (distribution, reflected) = (Beckmann(&slopes), fresnel(facet.incidence));
    S::power_to_f64(if sancer {
        facet.balanced_reflectance(&distribution, &Sancer(&slopes), reflected)
    } else {
        facet.balanced_reflectance(&distribution, &TorranceSparrow, reflected)
    })
}

/// Returns the reflectance of Blinn's surface, by the distribution of that number: power, gauss or trowbridge.
fn blinn_full<S: Narrow>(kind: f64, parameter: f64, eta: f64, [tl, tv, phi]: [f64; 3]) -> f64 {
    let Some(facet) = facet::<S>(tl, tv, phi) else { return 0.0 };
    let reflected = reflected::<S>(eta, facet.incidence);
    S::power_to_f64(match kind {
        1.0 => facet.reflectance(&Power(exponent(parameter)), &TorranceSparrow, reflected),
        2.0 => facet.reflectance(&gauss::<S>(parameter), &TorranceSparrow, reflected),
        3.0 => facet.reflectance(&Trowbridge { roundness: S::unit(parameter) }, &TorranceSparrow, reflected),
        _ => return f64::NAN,
    })
}

/// Returns what a function makes of the cosines of refracting facets with the normal on their side and with the lamp; 0 where
/// there are none. The lamp is below the surface.
fn hall<S: Narrow>([tl, tv, phi]: [f64; 3], k: f64, light: impl Fn(S::Unit, S::Unit) -> S::Unit) -> f64 {
    let below = direction::<S>(180.0 - tl, 0.0);
    let (q, denser) = sides::<S>(k);
    let facet = refracting(below, direction::<S>(tv, phi), q, denser);
    facet.map_or(0.0, |facet| {
        let cosine = -UnitVec3::<S>::Z.dot(facet);
        if cosine > S::Unit::ZERO { unit::<S>(light(cosine, below.dot(facet))) } else { 0.0 }
    })
}

/// Returns what a medium of the extinction s leaves of light over the length d.
fn left<S: Narrow>(extinction: f64, distance: f64) -> S::Unit {
    transmittance::<S>(positive::<S>(extinction * core::f64::consts::LOG2_E), S::length(distance))
}
