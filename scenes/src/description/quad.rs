//! Quads: surfaces with four corners, which radiosity divides into patches.

use rta_core::scene::Object;

use super::{Description, FallOff, Lamp, LampShape, Material, Shown, Surface, Triangle};
use crate::space::{Triple, cross, difference, length};

/// A quadrilateral among the [triangles](Description::triangles) of a scene, whose places, colour and material are theirs. Its outside is
/// where its corners run counterclockwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quad {
    /// The number of its first triangle, from 0: there are [`Quad::triangles`] of them.
    pub triangle: u32,
    /// Patches along u, from the first corner to the second, and along v, from the first to the fourth: each 1 or more.
    pub patches: [u16; 2],
    /// The part of it that emits, where its material does: least u, least v, largest u, largest v, between 0 and 1; all of it without. A
    /// patch emits where its middle lies in the part.
    pub emitting: Option<[f64; 4]>,
}

impl Quad {
    /// Returns the number of its triangles: two, and in a quad that emits in part eight around that part and two in it.
    #[must_use]
    pub const fn triangles(&self) -> u32 {
        if self.emitting.is_some() { 10 } else { 2 }
    }

    /// Returns the place in the list of its triangles.
    fn range(&self) -> core::ops::Range<usize> {
        let place = |number: u32| usize::try_from(number).unwrap_or(usize::MAX);
        place(self.triangle)..place(self.triangle.saturating_add(self.triangles()))
    }

    /// Returns its triangles among those of its scene; none where it is of another.
    #[must_use]
    pub fn of<'t>(&self, triangles: &'t [Triangle]) -> &'t [Triangle] {
        triangles.get(self.range()).unwrap_or(&[])
    }

    /// Returns its corners, from its triangles; `None` where they are not there.
    #[must_use]
    pub fn corners(&self, triangles: &[Triangle]) -> Option<[Triple; 4]> {
        Some(match (self.emitting, self.of(triangles)) {
            (None, [first, second]) => {
                let ([a, b, c], [.., d]) = (first.vertices, second.vertices);
                [a, b, c, d]
            }
            (Some(_), [first, _, second, _, third, _, fourth, ..]) => {
                [first, second, third, fourth].map(|triangle| {
                    let [corner, ..] = triangle.vertices;
                    corner
                })
            }
            _ => return None,
        })
    }

    /// Returns the corners of the part of it that emits, if its material does, from its own.
    fn shining(&self, corners: [Triple; 4]) -> [Triple; 4] {
        let [u0, v0, u1, v1] = self.emitting.unwrap_or([0.0, 0.0, 1.0, 1.0]);
        [[u0, v0], [u1, v0], [u1, v1], [u0, v1]].map(|place| bilinear(corners, place))
    }

    /// Returns whether it emits at a place, u and v from 0 to 1, if its material does.
    #[must_use]
    pub fn emits_at(&self, [u, v]: [f64; 2]) -> bool {
        self.emitting.is_none_or(|[u0, v0, u1, v1]| (u0..=u1).contains(&u) && (v0..=v1).contains(&v))
    }
}

/// Returns the place of a quad with these corners at u and v, from 0 to 1.
#[must_use]
pub fn bilinear([a, b, c, d]: [Triple; 4], [u, v]: [f64; 2]) -> Triple {
    let mut place = [0.0; 3];
    for ((((place, a), b), c), d) in place.iter_mut().zip(a).zip(b).zip(c).zip(d) {
        *place = (1.0 - v) * ((1.0 - u) * a + u * b) + v * ((1.0 - u) * d + u * c);
    }
    place
}

/// Returns the means of opposite edges, from the first corner to the second and from the first to the fourth.
fn edges([a, b, c, d]: [Triple; 4]) -> [Triple; 2] {
    let edge = |from: [Triple; 2], to: [Triple; 2]| -> Triple {
        let [[first, second], [third, fourth]] = [from, to];
        let sides = (difference(third, first), difference(fourth, second));
        core::array::from_fn(|i| f64::midpoint(register(sides.0, i), register(sides.1, i)))
    };
    [edge([a, d], [b, c]), edge([a, b], [d, c])]
}

/// Returns the triangles of a quad, as [`Quad::corners`] finds its corners in them.
#[must_use]
pub fn cut(corners: [Triple; 4], emitting: Option<[f64; 4]>) -> Vec<[Triple; 3]> {
    let halves = |[a, b, c, d]: [Triple; 4]| [[a, b, c], [a, c, d]];
    let Some([u0, v0, u1, v1]) = emitting else { return halves(corners).into() };
    let inner = [[u0, v0], [u1, v0], [u1, v1], [u0, v1]].map(|place| bilinear(corners, place));
    let ([a, b, c, d], [e, f, g, h]) = (corners, inner);
    [[a, b, f, e], [b, c, g, f], [c, d, h, g], [d, a, e, h], inner].map(halves).concat()
}

/// A lamp that [`Description::with_emitters`] adds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shining {
    /// Its number, from 0.
    pub lamp: u32,
    /// The number of the first of the two triangles that emit its light, from 0.
    pub triangle: u32,
    /// Its area.
    pub area: f64,
}

impl Description {
    /// Returns the lamps that [`Description::with_emitters`] adds, in the order of their numbers.
    #[must_use]
    pub fn shining(&self) -> Vec<Shining> {
        if self.is_solved() {
            return Vec::new();
        }
        let lit = self.quads.iter().filter(|quad| self.emission(quad).is_some());
        let found = lit.filter_map(|quad| {
            let [first, second] = edges(quad.shining(quad.corners(&self.triangles)?));
            // The last two of a quad that emits in part.
            let triangle = quad.triangle.saturating_add(quad.triangles() - 2);
            Some((triangle, length(cross(first, second))))
        });
        let numbers = u32::try_from(self.lamps.len()).unwrap_or(u32::MAX)..;
        numbers.zip(found).map(|(lamp, (triangle, area))| Shining { lamp, triangle, area }).collect()
    }

    /// Returns whether all light was solved ahead, so that there are no lamps.
    fn is_solved(&self) -> bool {
        self.details.light.as_ref().is_some_and(|light| light.shown == Shown::All)
    }

    /// Returns whether a quad emits light.
    #[must_use]
    pub fn has_emitters(&self) -> bool {
        self.quads.iter().any(|quad| self.emission(quad).is_some())
    }

    /// Returns the radiance that a quad emits where it does; `None` where nothing of it does.
    #[must_use]
    pub fn emission(&self, quad: &Quad) -> Option<Triple> {
        let Surface::Of(number) = quad.of(&self.triangles).first()?.surface else { return None };
        let light = self.materials.get(usize::from(number))?.emits?;
        light.iter().any(|register| *register > 0.0).then_some(light)
    }

    /// Returns the scene as it is traced: what of a quad does not emit has a material that does not, and each quad that emits is also a lamp of
    /// the same light, a parallelogram of its area and of the means of its opposite edges. Where all light was solved ahead there are no
    /// lamps.
    #[must_use]
    pub fn with_emitters(&self) -> Self {
        let mut scene = self.clone();
        let is_whole = self.is_solved();
        if is_whole {
            scene.lamps.clear();
            scene.details.lamps.clear();
        }
        for quad in &self.quads {
            let (Some(light), Some(corners)) = (self.emission(quad), quad.corners(&self.triangles)) else {
                continue;
            };
            if quad.emitting.is_some() {
                scene.darken(quad);
            }
            if is_whole {
                continue;
            }
            let corners = quad.shining(corners);
            let edges = edges(corners);
            let area = length(cross(edges[0], edges[1]));
            let corner = core::array::from_fn(|i| {
                let middle = corners.map(|corner| register(corner, i)).iter().sum::<f64>() / 4.0;
                middle - edges.map(|edge| register(edge, i)).iter().sum::<f64>() / 2.0
            });
            let line = quad.of(&self.triangles).first().map_or(0, |triangle| triangle.line);
            scene.details.lamps.insert(scene.lamps.len(), LampShape::Area { corner, edges });
            scene.lamps.push(Lamp {
                position: bilinear(corners, [0.5, 0.5]),
                color: light.map(|register| register * area / core::f64::consts::PI),
                radius: 0.0,
                fall_off: FallOff::Square,
                line,
            });
        }
        scene
    }

    /// Gives the triangles around the part of a quad that emits a material that does not.
    fn darken(&mut self, quad: &Quad) {
        let Some(around) = self.triangles.get_mut(quad.range()).and_then(|all| all.first_chunk_mut::<8>())
        else {
            return;
        };
        let [first, ..] = around;
        let Surface::Of(number) = first.surface else { return };
        let Some(own) = self.materials.get(usize::from(number)) else { return };
        let dark = Material { emits: None, ..own.clone() };
        let there = self.materials.iter().position(|material| *material == dark);
        let number = there.unwrap_or_else(|| {
            self.materials.push(dark);
            self.materials.len() - 1
        });
        let surface = u16::try_from(number).map_or(Surface::Opaque, Surface::Of);
        around.iter_mut().for_each(|triangle| triangle.surface = surface);
    }

    /// Returns the quad that a triangle is the first of, by its number, and whether another triangle of a quad is meant.
    pub(crate) fn quad(&self, triangle: Object) -> Option<(&Quad, bool)> {
        let Object::Triangle(number) = triangle else { return None };
        let place = self.quads.partition_point(|quad| quad.triangle <= number).checked_sub(1)?;
        let quad = self.quads.get(place)?;
        (number < quad.triangle.saturating_add(quad.triangles())).then_some((quad, number != quad.triangle))
    }
}

fn register(of: Triple, axis: usize) -> f64 {
    of.get(axis).copied().unwrap_or_default()
}
