//! Builds the lists of [`Packets`] from a scene's description.

mod four;
mod hidden;
mod light_buffer;
mod window;

use rta_core::scene::Object;
use rta_core::shape::Triangle;
use rta_core::vector::Vector;
use rta_scenes::accelerator::bounds::Bounds;
use rta_scenes::accelerator::sah::{Costs, Tree, tree};
use rta_scenes::accelerator::solid::{Solid, solids};
use rta_scenes::description::Description;
use rta_scenes::narrow::{Narrow, triangle};
use rta_scenes::space::{cross, difference, dot, length, unit};

use crate::leaf::{Boxes, Child, Column4, Cone4, Exact4, LARGEST, MAX_DEPTH, Sphere4, Triangle4};
use crate::number::ToF32;
use crate::packets::Packets;
use four::four;

/// The number of objects up to which they are tested four by four as quickly as by a hierarchy.
const FEW: usize = 8;
/// The number of visible lamps up to which they are in one hierarchy with the objects. More have one of their own, so that a
/// shadow ray, which no lamp stops, does not pass by them.
const FEW_LAMPS: usize = 8;
/// Measured: other costs change the instructions of a picture by 1 %, and these halve the number of leaves.
const COSTS: Costs = Costs { pair: 1.4, object: 0.3, group: 1.0, at_once: 4, leaf: 8 };

/// Returns the costs for a scene. Where the search meets triangles itself, leaves of four are quicker: 5 % of the instructions of paths in
/// the Cornell box.
fn costs<S: ToF32>(solids: &[Solid]) -> Costs {
    let triangles = solids.iter().filter(|solid| matches!(solid.object, Object::Triangle(_))).count();
    if S::IS_F32 && 2 * triangles > solids.len() { Costs { leaf: 4, ..COSTS } } else { COSTS }
}

/// A sphere about an object.
type Ball = ([f64; 3], f64);

impl Packets {
    /// Builds the lists for a scene that is traced in the number format `S`.
    #[must_use]
    pub fn build<S: Narrow + ToF32>(scene: &Description) -> Self {
        let mut solids = solids(scene);
        if solids.len() > FEW {
            hidden::leave_out(scene, &mut solids);
        }
        let mut objects = solids.len();
        let lamps = scene.lamps.iter().zip(0..).filter(|(lamp, _)| lamp.radius > 0.0);
        solids.extend(lamps.map(|(lamp, i)| Solid::sphere(lamp.position, lamp.radius, Object::Lamp(i))));
        let feet =
            scene.cylinders.iter().map(|c| Bounds::about([c.position[0], c.position[1], 0.0], [c.radius; 3]));
        let bounds = solids.iter().map(|solid| solid.bounds).chain(feet);
        let largest = bounds.fold(0.0f64, |most, bounds| most.max(bounds.largest()));
        let mut built = Self::default();
        if largest > f64::from(LARGEST) / 4.0 || solids.len() > Child::MAX_ITEMS as usize {
            built.is_too_large = true;
            return built;
        }
        built.size = single(largest);
        for (four, first) in scene.cylinders.chunks(4).zip((0..).step_by(4)) {
            let mut columns = Column4::EMPTY;
            for ((slot, cylinder), number) in four.iter().enumerate().zip(first..) {
                let [x, y] = &mut columns.center;
                (x[slot], y[slot]) = (single(cylinder.position[0]), single(cylinder.position[1]));
                columns.radius[slot] = single(cylinder.radius);
                if let Some(place) = columns.cylinders.get_mut(slot) {
                    *place = number;
                }
            }
            built.columns.push(columns);
        }
        let mut maker =
            Maker::<S> { scene, solids: &[], built, runs: Vec::new(), format: core::marker::PhantomData };
        if solids.len() <= FEW {
            maker.solids = &solids;
            maker.leaf(0, solids.len());
            return maker.built;
        }
        if solids.len() <= objects + FEW_LAMPS {
            objects = solids.len();
        }
        let costs = costs::<S>(&solids);
        let (first, last) = solids.split_at_mut(objects);
        let mut trees = vec![tree(first, 0, 0, &costs)];
        if !last.is_empty() {
            trees.push(tree(last, objects, 0, &costs));
        }
        maker.solids = &solids;
        maker.built.leaves.reserve_exact(trees.iter().map(leaves).sum());
        if !maker.emit_all(&trees, true) {
            maker.emit_all(&trees, false);
        }
        let occluders = trees.first().map_or(0, leaves);
        drop(trees);
        let Maker { mut built, runs, .. } = maker;
        built.nodes.shrink_to_fit();
        light_buffer::build::<S>(scene, solids, (&runs, occluders), &mut built);
        built
    }
}

/// The nearest; the search has a margin for that.
#[allow(clippy::cast_possible_truncation)] // within the format
pub(super) fn single(value: f64) -> f32 {
    value as f32
}

/// Returns the bounding sphere of an object; of a sphere or a lamp, the object itself.
fn ball(scene: &Description, item: Object) -> Option<Ball> {
    let index = |i: u32| i as usize;
    Some(match item {
        Object::Sphere(i) => scene.spheres.get(index(i)).map(|s| (s.position, s.radius))?,
        Object::Lamp(i) => scene.lamps.get(index(i)).map(|l| (l.position, l.radius))?,
        Object::Ellipsoid(i) => scene
            .ellipsoids
            .get(index(i))
            .map(|e| (e.position, e.radii.iter().fold(0.0f64, |most, &radius| most.max(radius))))?,
        Object::Cone(i) => {
            let cone = scene.cones.get(index(i))?;
            let (way, radius) = (difference(cone.apex, cone.base), cone.base_radius.max(cone.apex_radius));
            (middle(cone.base, cone.apex), (length(way) / 2.0).hypot(radius))
        }
        Object::Triangle(i) => about(scene.triangles.get(index(i))?.vertices),
        Object::Floor | Object::Cylinder(_) | Object::Plane(_) => return None,
    })
}

/// Returns axis and radius of the cylinder about a cone.
fn bounding_cylinder(scene: &Description, item: Object) -> Option<([f64; 3], f64)> {
    let Object::Cone(i) = item else { return None };
    let cone = scene.cones.get(i as usize)?;
    let way = difference(cone.apex, cone.base);
    let length = length(way);
    Some((way.map(|c| c / length), cone.base_radius.max(cone.apex_radius)))
}

/// Returns the planes of a triangle in the picture's number format: corner, normal and three across the edges; and its heights.
fn triangle_planes<S: Narrow + ToF32>(scene: &Description, item: Object) -> Option<([[f32; 3]; 5], f32)> {
    let Object::Triangle(i) = item else { return None };
    let exact = scene.triangles.get(i as usize)?;
    let triangle = triangle::narrow::<S>(0, exact).ok()?;
    let [corner, ..] = triangle.vertices;
    let corner = [corner.x(), corner.y(), corner.z()].map(S::to_f32);
    let normal = [triangle.normal.x(), triangle.normal.y(), triangle.normal.z()].map(S::unit_to_f32);
    // In the plane, to the left of an edge that goes counterclockwise.
    let [a, b, c] = exact.vertices;
    let area = cross(difference(b, a), difference(c, a));
    let inward = [(b, c), (c, a), (a, b)].map(|(from, to)| unit(cross(area, difference(to, from))));
    let [first, second, third] = inward.map(|way| way.unwrap_or_default());
    let height = dot(difference(a, b), first);
    Some(([corner, normal, first.map(single), second.map(single), third.map(single)], single(height)))
}

/// Returns a triangle as a picture in `f32` has it.
fn single_triangle(scene: &Description, item: Object) -> Option<Triangle<f32>> {
    let Object::Triangle(i) = item else { return None };
    triangle::narrow::<f32>(0, scene.triangles.get(i as usize)?).ok()
}

fn middle(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    let mut middle = a;
    for (c, b) in middle.iter_mut().zip(b) {
        *c = f64::midpoint(*c, b);
    }
    middle
}

/// Returns the smallest sphere about a triangle: about its longest side where the angle opposite is not acute, else through all
/// three.
fn about([a, b, c]: [[f64; 3]; 3]) -> Ball {
    let sides = [(a, b, c), (b, c, a), (c, a, b)].map(|(a, b, c)| (length(difference(b, a)), a, b, c));
    let longest = sides.iter().max_by(|p, q| p.0.total_cmp(&q.0));
    let Some(&(side, a, b, c)) = longest else { return (a, 0.0) };
    let center = middle(a, b);
    let reach = length(difference(c, center));
    if reach <= side / 2.0 {
        return (center, side / 2.0);
    }
    // From the middle of the longest side towards the third vertex, where all are equally far: with u along the side and h
    // across it, the vertex at (x, y): h = (x^2 + y^2 - (side/2)^2) / 2y.
    let along = difference(b, a).map(|c| c / side);
    let way = difference(c, center);
    let x: f64 = way.iter().zip(along).map(|(w, u)| w * u).sum();
    let mut across = way;
    for (w, u) in across.iter_mut().zip(along) {
        *w -= x * u;
    }
    let y = length(across);
    let h = (reach * reach - side * side / 4.0) / (2.0 * y);
    let mut place = center;
    for (c, across) in place.iter_mut().zip(across) {
        *c += across / y * h;
    }
    (place, h.hypot(side / 2.0))
}

/// Returns the number of leaves of four that the leaves of a tree fill.
fn leaves(tree: &Tree) -> usize {
    match tree {
        Tree::Leaf(_, _, count) => count.div_ceil(4),
        Tree::Pair(_, pair) => pair.iter().map(leaves).sum(),
    }
}

/// The state while nodes and leaves are written.
struct Maker<'a, S> {
    scene: &'a Description,
    solids: &'a [Solid],
    built: Packets,
    /// The first object of each leaf, and how many it has.
    runs: Vec<(u32, u32)>,
    format: core::marker::PhantomData<S>,
}

impl<S: Narrow + ToF32> Maker<'_, S> {
    /// Appends `count` objects, and returns the number of leaves that they fill.
    fn leaf(&mut self, first: usize, count: usize) -> usize {
        let run = self.solids.get(first..first + count).unwrap_or_default();
        for (four, first) in run.chunks(4).zip((first..).step_by(4)) {
            let (mut leaf, mut cones, mut triangles) = (Sphere4::EMPTY, Cone4::EMPTY, Triangle4::EMPTY);
            let mut exact = Exact4::EMPTY;
            for (slot, solid) in four.iter().enumerate() {
                let item = leaf.items.get_mut(slot);
                let (Some(item), Some((center, reach))) = (item, ball(self.scene, solid.object)) else {
                    continue;
                };
                *item = solid.object;
                leaf.radius[slot] = single(reach);
                for (places, place) in leaf.center.iter_mut().zip(center) {
                    places[slot] = single(place);
                }
                if let Some((axis, radius)) = bounding_cylinder(self.scene, solid.object) {
                    cones.radius[slot] = single(radius);
                    for (axes, axis) in cones.axis.iter_mut().zip(axis) {
                        axes[slot] = single(axis);
                    }
                    leaf.cones = as_number(self.built.cones.len());
                }
                if S::IS_F32 {
                    if let Some(triangle) = single_triangle(self.scene, solid.object) {
                        exact.set(slot, &triangle);
                        leaf.triangles = as_number(self.built.exact.len());
                    }
                } else if let Some((planes, height)) = triangle_planes::<S>(self.scene, solid.object) {
                    let Triangle4 { corner, normal, inward, .. } = &mut triangles;
                    for (all, plane) in [corner, normal].into_iter().chain(inward).zip(planes) {
                        for (places, place) in all.iter_mut().zip(plane) {
                            places[slot] = place;
                        }
                    }
                    triangles.height[slot] = height;
                    leaf.triangles = as_number(self.built.triangles.len());
                }
            }
            if leaf.cones != Sphere4::NO_CONES {
                self.built.cones.push(cones);
            }
            if leaf.triangles != Sphere4::NO_TRIANGLES {
                if S::IS_F32 {
                    self.built.exact.push(exact);
                } else {
                    self.built.triangles.push(triangles);
                }
            }
            self.built.leaves.push(leaf);
            self.runs.push((as_number(first), as_number(four.len())));
        }
        count.div_ceil(4)
    }

    /// Writes the tree of the objects, and that of the lamps if they have their own. Returns whether none has too many levels.
    fn emit_all(&mut self, trees: &[Tree], by_size: bool) -> bool {
        let Packets { nodes, leaves, cones, triangles, exact, .. } = &mut self.built;
        nodes.clear();
        leaves.clear();
        cones.clear();
        triangles.clear();
        exact.clear();
        self.runs.clear();
        let mut levels = 0;
        for (number, tree) in trees.iter().enumerate() {
            self.built.lamps = (number > 0).then(|| as_number(self.built.nodes.len()));
            levels = levels.max(self.emit(tree, by_size));
        }
        levels <= MAX_DEPTH
    }

    /// Writes a tree as nodes of four in preorder, and returns the number of levels.
    fn emit(&mut self, tree: &Tree, by_size: bool) -> usize {
        let children = four(tree, by_size);
        let number = self.built.nodes.len();
        let mut node = Boxes::EMPTY;
        for (slot, child) in children.iter().enumerate() {
            let Bounds { low, high } = child.bounds();
            for ([lows, highs], (&low, &high)) in node.planes.iter_mut().zip(low.iter().zip(high)) {
                if slot < 4 {
                    (lows[slot], highs[slot]) = (single(low), single(high));
                }
            }
        }
        self.built.nodes.push(node);
        let mut kinds = [Child::EMPTY; 4];
        for (kind, child) in kinds.iter_mut().zip(&children) {
            if let Tree::Leaf(_, first, count) = child {
                let leaf = self.built.leaves.len();
                *kind = Child::run_of(as_number(leaf), as_number(self.leaf(*first, *count)));
            }
        }
        let mut depth = 0;
        for (kind, child) in kinds.iter_mut().zip(&children) {
            if let Tree::Pair(..) = child {
                *kind = Child::node(as_number(self.built.nodes.len()));
                depth = depth.max(self.emit(child, by_size));
            }
        }
        if let Some(node) = self.built.nodes.get_mut(number) {
            node.children = kinds;
        }
        depth + 1
    }
}

pub(super) fn as_number(index: usize) -> u32 {
    u32::try_from(index).unwrap_or(u32::MAX)
}
