//! The objects.

use rta_core::scene::Object;

use super::Reader;
use super::said::Said;
use crate::description::{Cone, Cylinder, Detail, Ellipsoid, Plane, Shading, Sphere, Surface, Triangle};
use crate::error::{Found, SceneError};
use crate::polygon::{self, MOST_CORNERS, MOST_CROSSINGS, NotCut, Sheet};
use crate::space::{Triple, unit};

/// Returns the number of the next object of a list.
fn next<T>(list: &[T]) -> u32 {
    u32::try_from(list.len()).unwrap_or(u32::MAX)
}

impl<'a> Reader<'a> {
    pub(super) fn object(&mut self, said: &Said<'a>) -> Result<(), SceneError> {
        let (surface, color) = self.surface(said)?;
        let line = said.place.0;
        let place = |part| said.triple(part).unwrap_or_default();
        let number = |part| said.number(part).unwrap_or_default();
        let position = place("at");
        let scene = &mut self.scene;
        let object = match said.statement.keyword {
            "sphere" => {
                let radius = number("radius");
                if radius < 0.0 {
                    let radii = [-radius; 3];
                    scene.ellipsoids.push(Ellipsoid {
                        position,
                        color,
                        radii,
                        inside_only: true,
                        surface,
                        line,
                    });
                    Object::Ellipsoid(next(&scene.ellipsoids) - 1)
                } else {
                    scene.spheres.push(Sphere { position, color, radius, surface, line });
                    Object::Sphere(next(&scene.spheres) - 1)
                }
            }
            "ellipsoid" => {
                let (radii, inside_only) = (place("radii"), said.has("inside"));
                scene.ellipsoids.push(Ellipsoid { position, color, radii, inside_only, surface, line });
                Object::Ellipsoid(next(&scene.ellipsoids) - 1)
            }
            "cylinder" => {
                let radius = number("radius");
                scene.cylinders.push(Cylinder { position, color, radius, surface, line });
                Object::Cylinder(next(&scene.cylinders) - 1)
            }
            "cone" => {
                let cone = cone(said, surface, color)?;
                self.scene.cones.push(cone);
                Object::Cone(next(&self.scene.cones) - 1)
            }
            "plane" => {
                let normal = place("normal");
                if unit(normal).is_none() {
                    let place = said.part("normal").map_or(said.place, |normal| normal.word(0).1);
                    let found = Found::Number("0 0 0".into());
                    return Err(said.error(place, "the plane's normal (not zero)", found));
                }
                scene.planes.push(Plane { point: position, normal, color, surface, line });
                Object::Plane(next(&scene.planes) - 1)
            }
            "quad" => return self.quad(said, surface, color),
            "box" => return self.cuboid(said, surface, color),
            _ => return self.polygon(said, surface, color),
        };
        self.detail(said, object, None)
    }

    /// Keeps what an object has beside what all of its kind have.
    pub(super) fn detail(
        &mut self,
        said: &Said<'a>,
        object: Object,
        uv: Option<[[f64; 2]; 3]>,
    ) -> Result<(), SceneError> {
        let shading = match (said.has("gouraud"), said.has("bishop-weimer")) {
            (true, _) => Shading::Gouraud,
            (_, true) => Shading::BishopWeimer,
            _ => Shading::Normals,
        };
        let detail = Detail { shading, moves: said.triple("moves"), along: self.along(said)?, uv };
        if detail != Detail::default() {
            self.scene.details.objects.insert(object, detail);
        }
        Ok(())
    }

    /// A polygon or a triangle.
    fn polygon(&mut self, said: &Said<'a>, surface: Surface, color: Triple) -> Result<(), SceneError> {
        let line = said.place.0;
        let places = |keyword| -> Vec<Triple> {
            let Some(part) = said.part(keyword) else { return Vec::new() };
            (0..part.data.len()).step_by(3).map(|at| part.numbers(at)).collect()
        };
        let (corners, normals) = (places(""), places("normals"));
        if let Some(part) = said.part("normals") {
            if normals.len() != corners.len() {
                let expected =
                    format!("{} normals, one a corner of the {}", corners.len(), said.statement.noun);
                return Err(said.error(
                    part.place,
                    expected,
                    Found::Told(format!("{} of them", normals.len())),
                ));
            }
            if let Some(zero) = normals.iter().position(|normal| *normal == [0.0; 3]) {
                let found = Found::Number("0 0 0".into());
                return Err(said.error(part.word(3 * zero).1, "a normal that is not zero", found));
            }
        }
        if corners.len() > usize::try_from(MOST_CORNERS).unwrap_or(usize::MAX) {
            let expected = format!("at most {MOST_CORNERS} corners of the polygon");
            return Err(said.error(said.end, expected, Found::Told(format!("{} of them", corners.len()))));
        }
        let sheet = if said.statement.keyword == "triangle" {
            triangle(&corners, &normals)
        } else {
            polygon::sheet(corners, normals)
        };
        let sheet = match sheet {
            Ok(sheet) => sheet,
            Err(why) => {
                let noun = said.statement.noun;
                let text = || match why {
                    NotCut::Flat => format!("this {noun} has no area and is left out"),
                    NotCut::Tangled => {
                        format!("this {noun} crosses itself more than {MOST_CROSSINGS} times and is left out")
                    }
                };
                self.warn("flat", line, text);
                return Ok(());
            }
        };
        if sheet.is_crossed {
            let text = || "this polygon crosses itself: all that its outline winds around is shown".into();
            self.warn("crossed", line, text);
        }
        let uv = said.part("uv").map(|uv| [uv.numbers(0), uv.numbers(2), uv.numbers(4)]);
        let one_sided = said.has("one-sided");
        for (vertices, normals) in sheet.triangles {
            self.detail(said, Object::Triangle(next(&self.scene.triangles)), uv)?;
            self.scene.triangles.push(Triangle { vertices, normals, one_sided, color, surface, line });
        }
        Ok(())
    }
}

/// Returns a triangle as a polygon that is cut: as it is, however thin, unless its corners are on one line.
fn triangle(corners: &[Triple], normals: &[Triple]) -> Result<Sheet, NotCut> {
    let Some(&vertices) = corners.first_chunk().filter(|vertices| !polygon::is_flat(**vertices)) else {
        return Err(NotCut::Flat);
    };
    let normals = normals.first_chunk().copied();
    Ok(Sheet { triangles: vec![(vertices, normals)], is_crossed: false })
}

fn cone(said: &Said<'_>, surface: Surface, color: Triple) -> Result<Cone, SceneError> {
    let [base, apex] = ["from", "to"].map(|end| said.triple(end).unwrap_or_default());
    let [base_radius, apex_radius] =
        ["from", "to"].map(|end| said.after(end, "radius").map_or(0.0, |radius| radius.number(0)));
    if base == apex {
        let place = said.part("to").map_or(said.place, |to| to.word(0).1);
        let found = Found::Told("the same place".into());
        return Err(said.error(place, "the other end of the cone (not where it begins)", found));
    }
    if base_radius == 0.0 && apex_radius == 0.0 {
        let place = said.after("to", "radius").map_or(said.place, |radius| radius.word(0).1);
        let expected = "a radius of the cone (a number > 0 at one end)";
        return Err(said.error(place, expected, Found::Number("0 at both".into())));
    }
    let (capped, inside_only) = (said.has("capped"), said.has("inside"));
    let line = said.place.0;
    Ok(Cone { base, base_radius, apex, apex_radius, capped, inside_only, color, surface, line })
}
