//! What an illumination model does not use of the materials of a scene.
//!
//! No list says which model knows which property. The model is asked what it answers about sample surfaces of the material, and of
//! copies of it in which one property has another value: where no answer differs, the property is not used. A property may so be unused
//! because the model does not know it, or because another property of the material hides it.

use rta_core::color::Rgb;
use rta_core::illumination::{Bend, Illumination, Way};
use rta_core::light::{Incident, Lamp};
use rta_core::material::Material as Finish;
use rta_core::needs::Everything;
use rta_core::ray::{RayKind, Start};
use rta_core::surface::Surface;
use rta_core::vector::{UnitVector, Vector};

use crate::description::{Description, Edge, Material, Slope, Surface as Of};
use crate::model::Model;
use crate::narrow;
use crate::narrow::variant::Options;
use crate::shading::{Shaded, shaded};

/// What is not used of one material.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unused {
    /// The name of the material.
    pub material: String,
    /// Line of the source where it begins, from 1; 0 for one that every scene knows.
    pub line: u32,
    /// The keywords of its properties, at least one.
    pub properties: Vec<&'static str>,
}

/// Returns what `model` does not use of the materials with names that objects of the scene have; nothing of a material whose
/// coefficients are too large to be drawn at all.
///
/// Textures, bumps and dispersion, which no model sees, are left out.
#[must_use]
pub fn unused(scene: &Description, model: Model) -> Vec<Unused> {
    let surfaces = scene.floor.iter().map(|own| &own.surface);
    let surfaces = surfaces.chain(scene.cylinders.iter().map(|own| &own.surface));
    let surfaces = surfaces.chain(scene.ellipsoids.iter().map(|own| &own.surface));
    let surfaces = surfaces.chain(scene.spheres.iter().map(|own| &own.surface));
    let surfaces = surfaces.chain(scene.cones.iter().map(|own| &own.surface));
    let surfaces = surfaces.chain(scene.triangles.iter().map(|own| &own.surface));
    let surfaces = surfaces.chain(scene.planes.iter().map(|own| &own.surface));
    let mut is_used = vec![false; scene.materials.len()];
    for surface in surfaces {
        if let Of::Of(number) = surface
            && let Some(is_used) = is_used.get_mut(usize::from(*number))
        {
            *is_used = true;
        }
    }
    let materials = scene.materials.iter().zip(is_used).filter(|(_, is_used)| *is_used);
    let options = Options::of(scene);
    let unused = materials.map(|(material, _)| Unused {
        material: material.name.clone(),
        line: material.line,
        properties: of(material, (model, &options)),
    });
    unused.filter(|unused| !unused.properties.is_empty()).collect()
}

/// Returns the keywords of the properties of a material that change no answer of the model.
fn of(material: &Material, (model, options): (Model, &Options)) -> Vec<&'static str> {
    let stated = changed(material);
    let copies = stated.iter().flat_map(|(_, copies)| copies);
    let said: Vec<_> = [material].into_iter().chain(copies).cloned().collect();
    let Ok(finishes) = narrow::finishes::<f64>(&said) else { return Vec::new() };
    let (shaded, sees_lamps) = (shaded(model, 1.0, &said, options), sees_lamps(model));
    let mut all = (0..).zip(said.iter().zip(&finishes)).map(|(number, (said, finish))| {
        let color = said.color.unwrap_or(COLOR);
        Answers { model: &shaded, finish, number, color, numbers: Vec::new() }.all(sees_lamps)
    });
    let first = all.next();
    let mut properties = Vec::new();
    for (keyword, copies) in &stated {
        // All are asked, so that the next ones are those of the next property.
        let differ = all.by_ref().take(copies.len()).filter(|own| Some(own) != first.as_ref()).count();
        if differ == 0 {
            properties.push(*keyword);
        }
    }
    properties
}

/// Returns whether the model asks for lamps at all: whether a plain surface sends back some of their light.
fn sees_lamps(model: Model) -> bool {
    let shaded = shaded(model, 1.0, &[Material::default()], &Options::default());
    let (finish, numbers) = (&Finish::Opaque, Vec::new());
    let mut answers = Answers { model: &shaded, finish, number: 0, color: COLOR, numbers };
    answers.ask_about_lamps();
    answers.numbers.iter().any(|light| *light != 0.0)
}

/// Returns the keyword of each property that a material states, with copies of the material in which only this one has another value.
fn changed(material: &Material) -> Vec<(&'static str, Vec<Material>)> {
    type Number = fn(&mut Material) -> &mut Option<f64>;
    type Triple = fn(&mut Material) -> &mut Option<[f64; 3]>;
    const SHARES: &[f64] = &[0.0, 0.3, 0.7, 1.0];
    const NUMBERS: &[(&str, Number, &[f64])] = &[
        ("ambient", |own| &mut own.ambient, SHARES),
        ("diffuse", |own| &mut own.diffuse, SHARES),
        ("back", |own| &mut own.back, SHARES),
        ("specular", |own| &mut own.specular, SHARES),
        ("transmit", |own| &mut own.transmit, SHARES),
        ("mirror", |own| &mut own.mirror, SHARES),
        ("exponent", |own| &mut own.exponent, &[2.0, 20.0, 300.0]),
        ("gloss", |own| &mut own.gloss, &[3.0, 12.0, 30.0]),
        ("index", |own| &mut own.index, &[0.8, 1.25, 2.0]),
    ];
    const COLORS: &[[f64; 3]] = &[[0.2, 0.5, 0.8], [0.7, 0.6, 0.1]];
    const TRIPLES: &[(&str, Triple)] = &[
        ("color", |own| &mut own.color),
        ("metal", |own| &mut own.metal),
        ("absorb", |own| &mut own.absorb),
    ];
    let mut all = Vec::new();
    for (keyword, field, values) in NUMBERS {
        add(&mut all, keyword, material, *field, values);
    }
    for (keyword, field) in TRIPLES {
        add(&mut all, keyword, material, *field, COLORS);
    }
    const METALS: &[[[f64; 2]; 3]] =
        &[[[0.2, 3.0], [0.4, 2.5], [1.3, 1.9]], [[1.3, 7.3], [1.0, 6.6], [0.7, 5.6]]];
    add(&mut all, "nk", material, |own| &mut own.nk, METALS);
    if let Some(own) = material.edge {
        let other = |share: f64| if share < 0.5 { share + 0.25 } else { share - 0.25 };
        let exponent = Edge { exponent: own.exponent % 3 + 1, ..own };
        let edges =
            [exponent, Edge { least: other(own.least), ..own }, Edge { most: other(own.most), ..own }];
        add(&mut all, "edge", material, |own| &mut own.edge, &edges);
    }
    if !material.slopes.is_empty() {
        let copies = [0.05, 0.4]
            .map(|slope| Material { slopes: vec![Slope { slope, share: 1.0 }], ..material.clone() });
        all.push(("slope", copies.into()));
    }
    if material.thin {
        all.push(("thin", vec![Material { thin: false, ..material.clone() }]));
    }
    all
}

/// Adds the copies of a material in which a field that it states has another of the `values`.
fn add<T: Copy>(
    all: &mut Vec<(&'static str, Vec<Material>)>,
    keyword: &'static str,
    material: &Material,
    field: impl Fn(&mut Material) -> &mut Option<T>,
    values: &[T],
) {
    let mut copy = material.clone();
    if field(&mut copy).is_some() {
        let copies = values.iter().map(|value| {
            *field(&mut copy) = Some(*value);
            copy.clone()
        });
        all.push((keyword, copies.collect()));
    }
}

/// Angles with the normal under which the samples are looked at, in degrees, and the angles of lamps beside the mirrored direction.
const VIEWS: [f64; 4] = [0.0, 25.0, 50.0, 80.0];
const ASIDE: [f64; 7] = [-40.0, -15.0, -5.0, -1.0, 2.0, 8.0, 25.0];
/// Colour of a sample whose material has none.
const COLOR: [f64; 3] = [0.9, 0.5, 0.3];
/// Length of a ray inside of a sample.
const LENGTH: f64 = 2.0;

/// What a model answers about samples of one material, all answers one after the other.
struct Answers<'a> {
    model: &'a Shaded<f64>,
    /// What the tracer must know of the material.
    finish: &'a Finish<f64>,
    /// Its number in the model's table.
    number: u16,
    color: [f64; 3],
    numbers: Vec<f64>,
}

impl<'a> Answers<'a> {
    fn add(&mut self, Rgb { r, g, b }: Rgb<f64>) {
        self.numbers.extend([r, g, b]);
    }

    /// Returns the samples, each with the angle under which it is looked at: from outside, then from inside.
    fn samples(&self) -> impl Iterator<Item = (f64, Surface<'a, f64>)> + use<'a> {
        let (material, number, [r, g, b]) = (self.finish, self.number, self.color);
        let sample = move |inside, angle: f64| Surface {
            point: Vector::new(0.0, 0.0, 0.0),
            normal: UnitVector::Z,
            face: None,
            incoming: direction(180.0 - angle),
            distance: LENGTH,
            inside,
            extent: 1.0,
            color: Rgb::new(r, g, b),
            material,
            surroundings: false,
            mesh: None,
            number,
        };
        [false, true].into_iter().flat_map(move |inside| VIEWS.map(|angle| (angle, sample(inside, angle))))
    }

    /// Asks for the light of lamps before and behind the samples.
    fn ask_about_lamps(&mut self) {
        for (angle, sample) in self.samples() {
            let behind = ASIDE.map(|aside| 180.0 + angle + aside);
            for angle in ASIDE.map(|aside| aside - angle).into_iter().chain(behind) {
                let lamp = Lamp::white(direction(angle), 0.0, 1);
                if let Some(incident) = Incident::new(&lamp, sample.point, sample.normal) {
                    self.add(self.model.direct::<Everything>(&sample, &incident));
                }
            }
        }
    }

    /// Returns all answers. What comes through to a lamp counts where the model asks for lamps, `sees_lamps`.
    fn all(mut self, sees_lamps: bool) -> Vec<f64> {
        self.ask_about_lamps();
        let glass = self.finish.glass::<Everything>();
        self.numbers.extend(glass.filter(|_| sees_lamps).map(|glass| glass.kt));
        for (_, sample) in self.samples() {
            self.add(self.model.ambient::<Everything>(&sample, Rgb::new(1.0, 1.0, 1.0)));
            let rays = self.model.secondary::<Everything>(&sample);
            let [reflected, transmitted] =
                [rays.reflected, rays.transmitted].map(|weight| weight.unwrap_or(Rgb::BLACK));
            self.add(reflected);
            self.add(transmitted);
            // Where it goes does not matter if there is none.
            if let Some(glass) = glass.filter(|_| rays.transmitted.is_some()) {
                match rays.bend {
                    Bend::Straight => self.numbers.push(1.0),
                    Bend::Refracted if glass.denser => self.numbers.push(glass.eta),
                    Bend::Refracted => self.numbers.push(1.0 / glass.eta),
                }
            }
            let start = Start { origin: sample.point, direction: sample.incoming };
            let kind = RayKind::Transmitted;
            let way =
                Way { kind, start, length: Some(LENGTH), surface: Some(&sample), shift: None, lamps: &[] };
            if let Some(passage) = self.model.along::<Everything>(&way, |_, _| 1.0) {
                self.add(passage.weight);
                self.add(passage.veil);
            }
        }
        self.numbers
    }
}

/// Returns the unit vector in the plane of x and z at an angle with z, in degrees.
fn direction<V: Vector<Component = f64>>(angle: f64) -> V {
    let (sine, cosine) = angle.to_radians().sin_cos();
    V::new(sine, 0.0, cosine)
}

#[cfg(test)]
mod tests {
    use super::unused;
    use crate::model::Model;
    use crate::rta;

    /// Returns what a model does not use of the materials of a scene with these lines, as "name: keywords".
    fn spare(lines: &str, model: &str) -> Vec<String> {
        let text = format!("rta 1\ncamera at 0 -8 2 look 0 1 0\n{lines}\n");
        let scene = rta::read(text.as_bytes(), "a.rta").expect("a scene");
        let model = Model::ALL.iter().find(|own| own.name() == model).expect("a model");
        let line = |own: super::Unused| format!("{}: {}", own.material, own.properties.join(" "));
        unused(&scene, *model).into_iter().map(line).collect()
    }

    /// Returns what is not used of one material with these properties.
    fn of(properties: &str, model: &str) -> String {
        let lines = format!("material a {properties}\nsphere at 0 0 0 radius 1 of a");
        let all = spare(&lines, model);
        all.first().map_or(String::new(), |own| own.strip_prefix("a: ").expect("its name").to_owned())
    }

    #[test]
    fn each_model_uses_what_its_formula_has() {
        const ALL: &str = "like bottle  color .5 .6 .7  ambient .3  diffuse .4  back .2  specular .3  transmit .3  mirror .4
              exponent 30  gloss 12  slope .2  metal .9 .8 .3  edge 2 .1 .4";
        for (model, used, spare) in [
            (
                "flat",
                "color",
                "ambient diffuse specular transmit exponent gloss index metal absorb edge slope",
            ),
            // Through glass a lamp shines on other things.
            ("lambert", "color diffuse transmit", "specular mirror exponent gloss index metal absorb slope"),
            ("phong", "ambient diffuse specular transmit exponent index", "back mirror metal absorb slope"),
            ("whitted", "ambient diffuse specular transmit exponent index", "back mirror metal absorb slope"),
            ("newell", "diffuse specular exponent edge", "back mirror index metal absorb slope"),
            ("kay-greenberg", "specular transmit index absorb", "back mirror gloss metal slope"),
            ("hall-greenberg", "specular transmit index absorb exponent", "back mirror gloss slope"),
            ("cook-torrance", "specular mirror slope", "back exponent gloss absorb"),
        ] {
            let told = of(ALL, model);
            let is_told = |keyword: &&str| told.split(' ').any(|own| own == *keyword);
            assert_eq!(used.split(' ').find(is_told), None, "{model} uses it, told as unused: {told}");
            let missing = spare.split(' ').find(|keyword| !is_told(keyword));
            assert_eq!(missing, None, "{model} does not use it, not told: {told}");
        }
    }

    #[test]
    fn a_property_is_unused_too_where_another_hides_it() {
        // Highlights without weight, and a slope that decides before gloss.
        assert_eq!(of("diffuse .9  exponent 30", "phong"), "exponent");
        assert_eq!(of("diffuse .9  specular .1  exponent 30", "phong"), "");
        for model in ["cook-torrance", "hall-greenberg"] {
            assert_eq!(of("metal .9 .8 .3  gloss 12", model), "");
        }
        assert_eq!(of("metal .9 .8 .3  gloss 12  slope .2", "cook-torrance"), "gloss");
        // Through a thin wall light is not bent; what it reflects depends on the index.
        assert_eq!(of("diffuse .2  transmit .8  index 1.5", "whitted"), "");
        assert_eq!(of("diffuse .2  transmit .8  index 1.5  thin", "whitted"), "index");
        assert_eq!(of("specular .2  transmit .8  index 1.5  thin", "hall-greenberg"), "");
    }

    #[test]
    fn only_materials_that_things_have_are_told() {
        let lines = "material a gloss 3\nmaterial b like gold  exponent 9\nfloor white black of b\nplane at 0 0 -9 normal 0 0 1 of ink";
        assert_eq!(spare(lines, "lambert"), ["b: exponent gloss metal nk", "ink: index absorb"]);
        assert_eq!(spare("sphere at 0 0 0 radius 1 of opaque", "flat"), Vec::<String>::new());
    }
}
