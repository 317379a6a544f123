//! A scene whose diffuse flat surfaces are all quads, for radiosity.

use rta_core::scene::Object;

use crate::description::{Description, Detail, Kind, Material, Quad, Surface, Triangle, bilinear};
use crate::space::{Triple, cross, difference, dot, unit};

/// How far the normals of two halves of a flat quad may be apart: the sine of their angle.
const FLAT: f64 = 1e-6;

/// The quads that a triangle is cut into, each of a corner, the middles of its edges and the centroid, by the weights of the corners in sixths.
const THIRDS: [[[u8; 3]; 4]; 3] = [
    [[6, 0, 0], [3, 3, 0], [2, 2, 2], [3, 0, 3]],
    [[0, 6, 0], [0, 3, 3], [2, 2, 2], [3, 3, 0]],
    [[0, 0, 6], [3, 0, 3], [2, 2, 2], [0, 3, 3]],
];

impl Description {
    /// Returns the diffuse coefficient of a surface, kd.
    #[must_use]
    pub fn diffuse(&self, surface: &Surface) -> f64 {
        let said = Material::of(surface, &self.materials);
        let plain = if said.kind == Kind::Mirror { 0.0 } else { 1.0 };
        said.coefficients().map_or(plain, |own| own.kd)
    }

    /// Returns the scene with all triangles that reflect diffusely or emit as quads: its own; those of two triangles of one statement that are
    /// the halves of a flat convex quadrilateral; and three of each other triangle, of a corner, the middles of its edges and its centroid
    /// each. Quads that are only mirrors or glass are triangles. `patches` is the number of each quad's patches along u and v instead of
    /// what the scene says.
    #[must_use]
    pub fn meshed(&self, patches: Option<u16>) -> Self {
        let mut made = Self {
            triangles: Vec::with_capacity(self.triangles.len()),
            quads: Vec::with_capacity(self.quads.len()),
            ..self.clone()
        };
        made.details.objects.retain(|object, _| !matches!(object, Object::Triangle(_)));
        let side = patches.unwrap_or(1);
        let mut number = 0;
        while let Some(triangle) = self.triangles.get(number) {
            let takes_part = self.diffuse(&triangle.surface) > 0.0 || self.emits(&triangle.surface);
            let object = Object::Triangle(u32::try_from(number).unwrap_or(u32::MAX));
            let detail = self.details.objects.get(&object).cloned().unwrap_or_default();
            if let Some((quad, false)) = self.quad(object) {
                if takes_part {
                    let own = patches.map_or(quad.patches, |side| [side; 2]);
                    made.push_quad(own, quad.emitting);
                }
                quad.of(&self.triangles).iter().for_each(|own| made.push(own.clone(), detail.clone()));
                number += quad.of(&self.triangles).len().max(1);
            } else if !takes_part {
                made.push(triangle.clone(), detail);
                number += 1;
            } else if let Some(other) =
                self.triangles.get(number + 1).filter(|other| are_halves(triangle, other))
            {
                made.push_quad([side; 2], None);
                for own in [triangle, other] {
                    made.push(own.clone(), detail.clone());
                }
                number += 2;
            } else {
                for corners in THIRDS {
                    made.push_quad([side; 2], None);
                    let [a, b, c, d] = corners.map(|weights| weights.map(|sixth| f64::from(sixth) / 6.0));
                    for corners in [[a, b, c], [a, c, d]] {
                        let (part, uv) = part(triangle, detail.uv, corners);
                        made.push(part, Detail { uv, ..detail.clone() });
                    }
                }
                number += 1;
            }
        }
        made
    }

    /// Returns whether a surface emits light.
    fn emits(&self, surface: &Surface) -> bool {
        let Surface::Of(number) = *surface else { return false };
        let light = self.materials.get(usize::from(number)).and_then(|own| own.emits);
        light.is_some_and(|light| light.iter().any(|register| *register > 0.0))
    }

    fn push_quad(&mut self, patches: [u16; 2], emitting: Option<[f64; 4]>) {
        let triangle = u32::try_from(self.triangles.len()).unwrap_or(u32::MAX);
        self.quads.push(Quad { triangle, patches, emitting });
    }

    fn push(&mut self, triangle: Triangle, detail: Detail) {
        if detail != Detail::default() {
            let number = u32::try_from(self.triangles.len()).unwrap_or(u32::MAX);
            self.details.objects.insert(Object::Triangle(number), detail);
        }
        self.triangles.push(triangle);
    }
}

/// Returns whether two triangles, one behind the other in their scene, are the halves of a flat convex quadrilateral.
fn are_halves(first: &Triangle, second: &Triangle) -> bool {
    let ([a, b, c], [d, e, f]) = (first.vertices, second.vertices);
    let look = |of: &Triangle| (of.color, of.surface, of.line, of.one_sided, of.normals);
    let normal = |[a, b, c]: [Triple; 3]| unit(cross(difference(b, a), difference(c, a)));
    let turns =
        |corners: [Triple; 3], along: Triple| normal(corners).is_some_and(|own| dot(own, along) > 0.0);
    let (Some(along), Some(other)) = (normal(first.vertices), normal(second.vertices)) else { return false };
    let [x, y, z] = cross(along, other);
    a == d
        && c == e
        && first.normals.is_none()
        && look(first) == look(second)
        && [x, y, z].iter().all(|part| part.abs() <= FLAT)
        && dot(along, other) > 0.0
        && turns([f, a, b], along)
        && turns([b, c, f], along)
}

/// Returns the part of a triangle whose corners have these weights of its own, with its texture coordinates.
fn part(
    whole: &Triangle,
    uv: Option<[[f64; 2]; 3]>,
    corners: [[f64; 3]; 3],
) -> (Triangle, Option<[[f64; 2]; 3]>) {
    let mixed = |of: [Triple; 3]| {
        corners.map(|weights| -> Triple {
            core::array::from_fn(|axis| {
                of.iter()
                    .zip(weights)
                    .map(|(own, weight)| own.get(axis).copied().unwrap_or_default() * weight)
                    .sum()
            })
        })
    };
    let normals = whole.normals.map(|normals| mixed(normals.map(|normal| unit(normal).unwrap_or(normal))));
    let flat = |uv: [[f64; 2]; 3]| mixed(uv.map(|[u, v]| [u, v, 0.0])).map(|[u, v, _]| [u, v]);
    (Triangle { vertices: mixed(whole.vertices), normals, ..whole.clone() }, uv.map(flat))
}

impl Quad {
    /// Returns the numbers of the patches that emit, where the material does: along u and v, from the first pair up to, but not including, the
    /// second. A patch emits where its middle lies in the part that emits; there may be none.
    #[must_use]
    pub fn emitting_patches(&self) -> [[u16; 2]; 2] {
        let Some([u0, v0, u1, v1]) = self.emitting else { return [[0; 2], self.patches] };
        let [nu, nv] = self.patches;
        let range = |count: u16, [least, largest]: [f64; 2]| {
            let middle = |patch: u16| (f64::from(patch) + 0.5) / f64::from(count);
            let before = |end: f64| (0..count).take_while(|&patch| middle(patch) < end).count();
            let behind = (0..count).take_while(|&patch| middle(patch) <= largest).count();
            [before(least), behind].map(|patch| u16::try_from(patch).unwrap_or(u16::MAX))
        };
        let ([i, k], [j, l]) = (range(nu, [u0, u1]), range(nv, [v0, v1]));
        [[i, j], [k, l]]
    }

    /// Returns its middle, for a quad of these triangles.
    #[must_use]
    pub fn middle(&self, triangles: &[Triangle]) -> Option<Triple> {
        Some(bilinear(self.corners(triangles)?, [0.5; 2]))
    }
}
