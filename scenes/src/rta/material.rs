//! Materials: their definitions, and what refers to them.

use super::Reader;
use super::builtin;
use super::nearest::found;
use super::said::{Given, Said};
use super::statements::A_MATERIAL;
use crate::description::{Dispersion, Edge, Kind, Material, Slope, Surface};
use crate::error::{Found, SceneError};
use crate::numbers::{Numbers, Short};

/// Most slopes of microfacets.
const MOST_SLOPES: usize = 4;
/// How far the sum of shares may be from 1.
const SHARES_TOLERANCE: f64 = 1e-6;
/// The largest exponent.
pub(super) const MOST_EXPONENT: f64 = 1000.0;

impl<'a> Reader<'a> {
    pub(super) fn material(&mut self, said: &Said<'a>) -> Result<(), SceneError> {
        let (name, place) = said.part("").map_or(("", said.place), |part| part.word(0));
        let taken = match self.defined.get(name) {
            Some(first) => Some(format!("\"{name}\", which is defined in line {}", first.line)),
            None => builtin::material(name).map(|_| format!("\"{name}\", which is built in")),
        };
        if let Some(taken) = taken {
            return Err(said.error(place, "a new name of the material", Found::Told(taken)));
        }
        let like = match said.part("like") {
            Some(like) => self.known(said, like)?,
            None if said.has("metal") || said.has("nk") => {
                Material { kind: Kind::Metal, ..Material::default() }
            }
            None => Material::default(),
        };
        let mut made = Material { name: name.into(), line: said.place.0, ..like };
        for (own, keyword) in [
            (&mut made.ambient, "ambient"),
            (&mut made.diffuse, "diffuse"),
            (&mut made.back, "back"),
            (&mut made.specular, "specular"),
            (&mut made.transmit, "transmit"),
            (&mut made.mirror, "mirror"),
            (&mut made.exponent, "exponent"),
            (&mut made.gloss, "gloss"),
            (&mut made.roughness, "roughness"),
            (&mut made.index, "index"),
        ] {
            *own = said.number(keyword).or(*own);
        }
        made.color = said.triple("color").or(made.color);
        if said.has("metal") || said.has("nk") {
            made.metal = said.triple("metal");
            made.nk = said.part("nk").map(|nk| [nk.numbers(0), nk.numbers(2), nk.numbers(4)]);
        }
        if let Some(left) = said.triple("absorb") {
            let over = said.number("over").unwrap_or(1.0);
            // Above 0, however little is left.
            made.absorb = Some(left.map(|part| part.powf(1.0 / over).clamp(f64::MIN_POSITIVE, 1.0)));
        }
        if let Some(abbe) = said.number("abbe") {
            made.dispersion = Some(Dispersion::Abbe(abbe));
        }
        if let Some(part) = said.part("sellmeier") {
            let terms = (1..part.data.len()).step_by(2).map(|at| part.numbers(at)).collect();
            made.dispersion = Some(Dispersion::Sellmeier { offset: part.number(0), terms });
        }
        if let Some(edge) = said.part("edge") {
            let exponent = u8::try_from(edge.whole(0)).unwrap_or(1);
            made.edge = Some(Edge { exponent, least: edge.number(1), most: edge.number(2) });
        }
        made.emits = said.triple("emits").or(made.emits);
        made.thin |= said.has("thin");
        made.surroundings |= said.has("surroundings");
        if said.has("slope") {
            made.slopes = slopes(said)?;
        }
        if let Some(part) = said.part("texture") {
            made.texture = Some(self.known_texture(said, part)?);
        }
        if let Some(part) = said.part("bump") {
            made.bump = Some((self.known_texture(said, part)?, part.number(1)));
        }
        self.look_at(said, &mut made);
        self.defined.insert(name, made);
        Ok(())
    }

    /// Warns of what is seldom meant.
    fn look_at(&mut self, said: &Said<'a>, made: &mut Material) {
        let line = said.place.0;
        if made.exponent.is_some_and(|exponent| exponent > MOST_EXPONENT) {
            if made.specular == Some(0.0) {
                made.exponent = Some(MOST_EXPONENT);
            } else {
                self.warn("exponent", line, || format!("an exponent is larger than {MOST_EXPONENT}"));
            }
        }
        let stated = ["diffuse", "specular", "transmit"].iter().any(|part| said.has(part));
        if let Some(own) = made.coefficients().filter(|_| stated) {
            let sum = own.kd + own.ks + own.kt;
            if sum > 1.0 + SHARES_TOLERANCE {
                let text = || {
                    format!(
                        "diffuse, specular and transmit add up to {}, more than the light",
                        Short::nearest(sum)
                    )
                };
                self.warn("shares", line, text);
            }
        }
    }

    /// Returns the material of a name, which is built in or defined above.
    fn known(&self, said: &Said<'a>, part: &Given<'a>) -> Result<Material, SceneError> {
        let (name, place) = part.word(0);
        let known = self.defined.get(name).cloned().or_else(|| builtin::material(name));
        known.ok_or_else(|| {
            let names = builtin::names().map(|name| -> &str { name }).chain(self.defined.keys().copied());
            said.error(place, A_MATERIAL, found(name, names))
        })
    }

    /// Returns the surface of what is `of` a material, which has its place in the scene from now on.
    pub(super) fn refer(&mut self, said: &Said<'a>, part: &Given<'a>) -> Result<Surface, SceneError> {
        let (name, place) = part.word(0);
        if let Some(number) = self.used.get(name) {
            return Ok(Surface::Of(*number));
        }
        let material = match builtin::surface(name) {
            Some(Ok(surface)) => return Ok(surface),
            Some(Err(material)) => material,
            None => self.known(said, part)?,
        };
        let Ok(number) = u16::try_from(self.scene.materials.len()) else {
            let found = Found::Told("one more".into());
            return Err(said.error(place, "at most 65536 materials", found));
        };
        self.scene.materials.push(material);
        self.used.insert(name, number);
        Ok(Surface::Of(number))
    }

    /// Returns material and colour of an object.
    pub(super) fn surface(&mut self, said: &Said<'a>) -> Result<(Surface, [f64; 3]), SceneError> {
        let surface = match said.part("of") {
            Some(of) => self.refer(said, of)?,
            None => Surface::Opaque,
        };
        let of_material = match surface {
            Surface::Of(number) => self.scene.materials.get(usize::from(number)).and_then(|own| own.color),
            _ => None,
        };
        let color = said.triple("color").or(of_material).unwrap_or([1.0; 3]);
        if let Some(above) = color.into_iter().find(|register| *register > 1.0) {
            let noun = said.statement.noun;
            let text = || {
                let above = Numbers(&[above]).to_string();
                format!("the colour of this {noun} has a register of {above}: colours go from 0 to 1")
            };
            self.warn("colour", said.place.0, text);
        }
        Ok((surface, color))
    }
}

/// Returns the slopes of a material: one, or several whose shares add up to 1.
fn slopes(said: &Said<'_>) -> Result<Vec<Slope>, SceneError> {
    let mut slopes: Vec<Slope> = Vec::new();
    let mut last = said.place;
    let mut is_stated = true;
    for part in &said.parts {
        match part.keyword {
            "slope" if slopes.len() == MOST_SLOPES => {
                let found = Found::Told("one more".into());
                return Err(said.error(part.place, format!("at most {MOST_SLOPES} slopes"), found));
            }
            "slope" => {
                // One that has a share has it behind itself.
                if !is_stated {
                    return Err(said.error(
                        part.place,
                        "the share of the slope before",
                        Found::word("slope"),
                    ));
                }
                slopes.push(Slope { slope: part.number(0), share: 1.0 });
                (last, is_stated) = (part.word(0).1, false);
            }
            "share" => {
                if let Some(slope) = slopes.last_mut() {
                    slope.share = part.number(0);
                }
                (last, is_stated) = (part.word(0).1, true);
            }
            _ => {}
        }
    }
    let sum: f64 = slopes.iter().map(|slope| slope.share).sum();
    if (sum - 1.0).abs() > SHARES_TOLERANCE {
        // As people write it: without a 0 before the point.
        let sum = Short::nearest(sum).to_string();
        let found =
            Found::Number(sum.strip_prefix('0').filter(|rest| !rest.is_empty()).unwrap_or(&sum).into());
        return Err(said.error(last, "shares of slopes that add up to 1", found));
    }
    Ok(slopes)
}
