//! The objects, and their fill.

use super::{ENTITIES, Fill, Reader};
use crate::description::{Cone, Ellipsoid, Plane, Sphere, Surface, Triangle};
use crate::error::{Found, SceneError};
use crate::numbers::{AXES, Range, Short};
use crate::polygon::{self, MOST_CORNERS, MOST_CROSSINGS, NotCut};
use crate::space::{Triple, cross, difference, length, unit};

impl Reader<'_> {
    /// The entity `f`: eight numbers, or eleven in P3F, where the colour of the highlight is told, which here is the light's.
    pub(super) fn fill(&mut self, line: u32) -> Result<(), SceneError> {
        let is_p3f = self.tokens.numbers_ahead(11) == 11;
        self.begin("fill", line, if is_p3f { 11 } else { 8 });
        let color = self.tokens.color("the fill")?;
        if is_p3f && self.tokens.color("the highlight of the fill")? != [1.0; 3] {
            let text =
                || "the colour of the fill's highlight is not used: highlights have the light's".into();
            self.tallies.highlights.count(line, text);
        }
        let kd = self.tokens.number("the Kd of the fill", Range::NotNegative)?;
        let ks = self.tokens.number("the Ks of the fill", Range::NotNegative)?;
        let exponent = self.tokens.number("the Shine of the fill", Range::NotNegative)?;
        let kt = self.tokens.number("the T of the fill", Range::NotNegative)?;
        let range = if kt > 0.0 { Range::NotNegative } else { Range::Any };
        let ior = self.tokens.number("the index of refraction of the fill", range)?;
        let ior = if ior > 0.0 { ior } else { 1.0 };
        self.fill = Some(Fill { color, surface: Surface::Finish { kd, ks, exponent, kt, ior } });
        self.texture();
        Ok(())
    }

    /// Passes over the name of a texture, which some files have after a fill.
    fn texture(&mut self) {
        if self.tokens.is_amid_line()
            && let Some(name) = self.tokens.peek()
            && !name.is_like_a_number()
            && !ENTITIES.iter().any(|entity| name.text.eq_ignore_ascii_case(entity))
        {
            self.warn(
                name.line,
                format!("the texture \"{}\" of the fill is passed over", Found::show(name.text)),
            );
            self.tokens.skip_line();
        }
    }

    /// Returns the fill that holds for an object of that line.
    fn filled(&mut self, line: u32) -> Fill {
        if self.fill.is_none() {
            self.warn(line, "objects before the first fill (f) are white and diffuse");
        }
        *self.fill.get_or_insert(Fill::DEFAULT)
    }

    pub(super) fn sphere(&mut self, line: u32) -> Result<(), SceneError> {
        let Fill { color, surface } = self.filled(line);
        self.begin("sphere", line, 4);
        let which = self.scene.spheres.len() + self.scene.ellipsoids.len() + 1;
        let position = self.tokens.vector(AXES, format_args!("the centre of sphere {which}"), Range::Any)?;
        let radius = self.tokens.number(format_args!("the radius of sphere {which}"), Range::NotZero)?;
        if radius > 0.0 {
            self.scene.spheres.push(Sphere { position, color, radius, surface, line });
        } else {
            // As an ellipsoid, so that the search for spheres, which every ray waits for, need not ask for their side.
            let radii = [-radius; 3];
            self.scene.ellipsoids.push(Ellipsoid {
                position,
                color,
                radii,
                inside_only: true,
                surface,
                line,
            });
        }
        Ok(())
    }

    pub(super) fn cone(&mut self, line: u32) -> Result<(), SceneError> {
        let Fill { color, surface } = self.filled(line);
        self.begin("cone", line, 8);
        let which = self.scene.cones.len() + 1;
        let base = self.tokens.vector(AXES, format_args!("the base of cone {which}"), Range::Any)?;
        let base_radius = self.tokens.number(format_args!("the base radius of cone {which}"), Range::Any)?;
        let place = self.tokens.place();
        let apex = self.tokens.vector(AXES, format_args!("the apex of cone {which}"), Range::Any)?;
        if apex == base {
            return Err(self.vector_error(
                place,
                format_args!("the apex of cone {which} (not its base)"),
                apex,
            ));
        }
        let place = self.tokens.place();
        let apex_radius = self.tokens.number(format_args!("the apex radius of cone {which}"), Range::Any)?;
        let range = match base_radius {
            base if base > 0.0 => Range::NotNegative,
            base if base < 0.0 => Range::NotPositive,
            _ => Range::NotZero,
        };
        if !range.holds(apex_radius) {
            let expected = format!("the apex radius of cone {which} ({range} like the base radius)");
            let [apex, base] = [apex_radius, base_radius].map(Short::nearest);
            let found = Found::Number(format!("{apex} (the base radius is {base})"));
            return Err(self.tokens.error(place, expected, found));
        }
        self.scene.cones.push(Cone {
            base,
            base_radius: base_radius.abs(),
            apex,
            apex_radius: apex_radius.abs(),
            capped: false,
            inside_only: base_radius < 0.0 || apex_radius < 0.0,
            color,
            surface,
            line,
        });
        Ok(())
    }

    pub(super) fn polygon(&mut self, line: u32, with_normals: bool) -> Result<(), SceneError> {
        let fill = self.filled(line);
        self.polygons += 1;
        self.begin("polygon", line, 1);
        let which = format!("polygon {}", self.polygons);
        let expected =
            format_args!("the number of corners of {which} (a whole number from 3 to {MOST_CORNERS})");
        let count = self.tokens.whole(expected, 3, MOST_CORNERS)?;
        let numbers = count * if with_normals { 6 } else { 3 };
        self.entry.numbers = usize::try_from(numbers).map_or(usize::MAX, |numbers| numbers + 1);
        let (mut corners, mut normals): (Vec<Triple>, Vec<Triple>) = (Vec::new(), Vec::new());
        for number in 1..=count {
            corners.push(self.tokens.vector(AXES, format_args!("corner {number} of {which}"), Range::Any)?);
            if with_normals {
                let normal = format_args!("the normal of corner {number} of {which}");
                normals.push(self.tokens.vector(AXES, normal, Range::Any)?);
            }
        }
        self.sheet(fill, line, corners, normals);
        Ok(())
    }

    /// An infinite plane through three points.
    pub(super) fn plane(&mut self, line: u32) -> Result<(), SceneError> {
        let Fill { color, surface } = self.filled(line);
        self.begin("plane", line, 9);
        let which = self.scene.planes.len() + 1;
        let point = self.tokens.vector(AXES, format_args!("the first point of plane {which}"), Range::Any)?;
        let second =
            self.tokens.vector(AXES, format_args!("the second point of plane {which}"), Range::Any)?;
        let place = self.tokens.place();
        let third = self.tokens.vector(AXES, format_args!("the third point of plane {which}"), Range::Any)?;
        let sides = [second, third].map(|other| unit(difference(other, point)));
        let normal = sides[0].zip(sides[1]).map(|(a, b)| cross(a, b));
        let Some(normal) = normal.filter(|normal| length(*normal) > 1e-9) else {
            let expected = format_args!("the third point of plane {which} (not on one line with the others)");
            return Err(self.vector_error(place, expected, third));
        };
        self.scene.planes.push(Plane { point, normal, color, surface, line });
        Ok(())
    }

    /// A box between two corners, seen from all sides: six polygons that run counterclockwise seen from outside.
    pub(super) fn cuboid(&mut self, line: u32) -> Result<(), SceneError> {
        let fill = self.filled(line);
        self.begin("box", line, 6);
        let a = self.tokens.vector(AXES, "the first corner of the box", Range::Any)?;
        let b = self.tokens.vector(AXES, "the second corner of the box", Range::Any)?;
        let ([ax, ay, az], [bx, by, bz]) = (a, b);
        let [[x, right], [y, back], [z, top]] =
            [[ax, bx], [ay, by], [az, bz]].map(|[a, b]: [f64; 2]| [a.min(b), a.max(b)]);
        for corners in [
            [[x, y, z], [right, y, z], [right, y, top], [x, y, top]],
            [[right, y, z], [right, back, z], [right, back, top], [right, y, top]],
            [[right, back, z], [x, back, z], [x, back, top], [right, back, top]],
            [[x, back, z], [x, y, z], [x, y, top], [x, back, top]],
            [[x, y, top], [right, y, top], [right, back, top], [x, back, top]],
            [[x, back, z], [right, back, z], [right, y, z], [x, y, z]],
        ] {
            self.sheet(fill, line, corners.to_vec(), Vec::new());
        }
        Ok(())
    }

    /// A polygon of corners and their normals, if there are any: triangles, or a part of an area light.
    fn sheet(&mut self, fill: Fill, line: u32, corners: Vec<Triple>, normals: Vec<Triple>) {
        if self.shines {
            return self.shine(line, &corners);
        }
        let Fill { color, surface } = fill;
        let sheet = match polygon::sheet(corners, normals) {
            Ok(sheet) => sheet,
            Err(NotCut::Flat) => {
                return self.tallies.flat.count(line, || "this polygon has no area and is left out".into());
            }
            Err(NotCut::Tangled) => {
                let text = || {
                    format!("this polygon crosses itself more than {MOST_CROSSINGS} times and is left out")
                };
                return self.tallies.tangled.count(line, text);
            }
        };
        if sheet.is_crossed {
            let text = || "this polygon crosses itself: all that its outline winds around is shown".into();
            self.tallies.crossed.count(line, text);
        }
        for (vertices, normals) in sheet.triangles {
            let one_sided = self.reading.one_sided;
            self.scene.triangles.push(Triangle { vertices, normals, one_sided, color, surface, line });
        }
    }
}
