//! Spheres and ellipsoids as meshes.

use core::f64::consts::{PI, TAU};

use rta_core::scene::Object;

use crate::description::{Description, Detail, Ellipsoid, Sphere, Surface, Triangle};
use crate::space::unit;

/// A vertex: a place of the unit sphere, and the texture coordinates there.
type Vertex = ([f64; 3], [f64; 2]);

impl Description {
    /// Cuts all spheres and ellipsoids into triangles with the true normals at their vertices: `rows` bands from pole to pole, of `2 rows`
    /// quadrilaterals each, of triangles at the poles. They have the texture coordinates of the sphere, where their material has a
    /// texture, and what the object had beside it.
    pub fn tessellate(&mut self, rows: u32) {
        let (spheres, ellipsoids) =
            (core::mem::take(&mut self.spheres), core::mem::take(&mut self.ellipsoids));
        let balls = spheres.into_iter().map(|Sphere { position, color, radius, surface, line }| Ellipsoid {
            position,
            color,
            radii: [radius; 3],
            inside_only: false,
            surface,
            line,
        });
        let balls = (0..).zip(balls).map(|(number, ball)| (Object::Sphere(number), ball));
        let ellipsoids = (0..).zip(ellipsoids).map(|(number, own)| (Object::Ellipsoid(number), own));
        for (object, ellipsoid) in balls.chain(ellipsoids).collect::<Vec<_>>() {
            let detail = self.details.objects.remove(&object).unwrap_or_default();
            self.cut(&ellipsoid, &detail, rows);
        }
    }

    fn cut(&mut self, ellipsoid: &Ellipsoid, detail: &Detail, rows: u32) {
        let &Ellipsoid { position, color, radii, inside_only, surface, line } = ellipsoid;
        let has_texture = match surface {
            Surface::Of(number) => {
                let material = self.materials.get(usize::from(number));
                material.is_some_and(|material| material.texture.is_some() || material.bump.is_some())
            }
            _ => false,
        };
        for corners in triangles(rows) {
            // What is seen from the inside only has its outside there.
            let [first, second, third] = corners;
            let corners = if inside_only { [first, third, second] } else { corners };
            let outside = if inside_only { -1.0 } else { 1.0 };
            let place = |(place, _): Vertex| {
                [0, 1, 2].map(|axis| at(position, axis) + at(radii, axis) * at(place, axis))
            };
            let normal = |(place, _): Vertex| {
                let normal = [0, 1, 2].map(|axis| outside * at(place, axis) / at(radii, axis));
                unit(normal).unwrap_or(place)
            };
            let uv = has_texture.then(|| corners.map(|(_, uv)| uv));
            let detail = Detail { uv, ..detail.clone() };
            if detail != Detail::default() {
                let number = u32::try_from(self.triangles.len()).unwrap_or(u32::MAX);
                self.details.objects.insert(Object::Triangle(number), detail);
            }
            let (vertices, normals) = (corners.map(place), Some(corners.map(normal)));
            self.triangles.push(Triangle { vertices, normals, one_sided: inside_only, color, surface, line });
        }
    }
}

/// Returns a component.
fn at([x, y, z]: [f64; 3], axis: usize) -> f64 {
    match axis {
        0 => x,
        1 => y,
        _ => z,
    }
}

/// Returns the triangles of the unit sphere, counterclockwise as seen from outside, from the zenith down.
fn triangles(rows: u32) -> impl Iterator<Item = [Vertex; 3]> {
    let columns = 2 * rows;
    let vertex = move |column: f64, row: u32| {
        let (u, v) = (column / f64::from(columns), f64::from(row) / f64::from(rows));
        // The poles, and where the last column meets the first, are the same to the last bit.
        let (sine, cosine) = if row == 0 || row == rows {
            (0.0, if row == 0 { 1.0 } else { -1.0 })
        } else {
            (v * PI).sin_cos()
        };
        let (y, x) = ((u % 1.0) * TAU).sin_cos();
        ([sine * x, sine * y, cosine], [u, v])
    };
    (0..rows).flat_map(move |row| {
        (0..columns).flat_map(move |column| {
            let (left, right, middle) = (f64::from(column), f64::from(column + 1), f64::from(column) + 0.5);
            let [upper_left, upper_right] = [left, right].map(|column| vertex(column, row));
            let [lower_left, lower_right] = [left, right].map(|column| vertex(column, row + 1));
            let upper = (row > 0).then_some([upper_left, lower_left, upper_right]);
            let lower = (row + 1 < rows).then_some([upper_right, lower_left, lower_right]);
            let upper = if row + 1 == rows {
                upper.map(|_| [upper_left, vertex(middle, rows), upper_right])
            } else {
                upper
            };
            let lower =
                if row == 0 { lower.map(|_| [vertex(middle, 0), lower_left, lower_right]) } else { lower };
            upper.into_iter().chain(lower)
        })
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::indexing_slicing)] // a test may panic
    use crate::space::{cross, difference};
    use crate::{dat, rta};

    fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
        a.iter().zip(b).map(|(a, b)| a * b).sum()
    }

    #[test]
    fn balls_become_closed_meshes_with_true_normals() {
        let text = "rta 1\ncamera at 0 -9 2 to 0 0 1\nlamp at 0 0 9\nsphere at 1 2 3 radius 2\nellipsoid at 0 0 9 radii 1 2 3\n\
                    ellipsoid at 5 5 5 radii 1 1 1 inside\n";
        let whole = rta::read(text.as_bytes(), "s.rta").expect("a scene");
        for rows in [2u32, 3, 7, 64] {
            let mut scene = whole.clone();
            scene.tessellate(rows);
            assert!(scene.spheres.is_empty() && scene.ellipsoids.is_empty());
            let count = usize::try_from(4 * rows * (rows - 1)).expect("few");
            assert_eq!(scene.triangles.len(), 3 * count);
            for (number, triangle) in scene.triangles.iter().enumerate() {
                let (center, inside) =
                    [([1.0, 2.0, 3.0], false), ([0.0, 0.0, 9.0], false), ([5.0; 3], true)][number / count];
                let [a, b, c] = triangle.vertices;
                let normal = cross(difference(b, a), difference(c, a));
                let outwards = dot(normal, difference(a, center));
                assert!(if inside { outwards < 0.0 } else { outwards > 0.0 }, "{number}: {triangle:?}");
                assert_eq!(triangle.one_sided, inside);
                for own in triangle.normals.expect("normals") {
                    assert!(
                        dot(own, normal) > 0.0 && (dot(own, own) - 1.0).abs() < 1e-12,
                        "{number}: {triangle:?}"
                    );
                }
            }
            // Each edge is that of two triangles of the same ball, once each way.
            let mut edges = std::collections::HashMap::new();
            for triangle in &scene.triangles[..count] {
                let [a, b, c] = triangle.vertices.map(|vertex| vertex.map(f64::to_bits));
                for edge in [(a, b), (b, c), (c, a)] {
                    assert_eq!(edges.insert(edge, ()), None, "{rows}");
                }
            }
            assert!(edges.keys().all(|&(from, to)| edges.contains_key(&(to, from))), "{rows}");
        }
    }

    #[test]
    fn the_juggler_is_all_mesh() {
        let mut scene = dat::read(crate::shipped::JUGGLER.as_bytes(), "juggler.dat").expect("a scene");
        let balls = scene.spheres.len() + scene.ellipsoids.len();
        scene.tessellate(4);
        assert_eq!(scene.triangles.len(), balls * 48);
        assert!(scene.details.objects.is_empty());
    }
}
