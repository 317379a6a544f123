//! What moves while the shutter is open.

use std::borrow::Cow;

use rta_core::scene::Object;

use super::path::shift;
use super::{Description, LampShape};
use crate::space::Triple;

impl Description {
    /// Returns whether something moves while the shutter is open.
    #[must_use]
    pub fn has_motion(&self) -> bool {
        let details = &self.details;
        self.has_velocities()
            || self.optics.moves.is_some()
            || !details.lamp_moves.is_empty()
            || details.objects.values().any(|detail| detail.moves.is_some())
    }

    /// Returns whether things move along paths while the shutter is open: only a shutter with times of its own tells which part of a film that
    /// is.
    fn has_velocities(&self) -> bool {
        self.optics.shutter.is_some() && self.moves()
    }

    /// Returns the scene as it is at the beginning, with the velocity of paths as motions of their own.
    fn begun(&self) -> Cow<'_, Self> {
        if self.has_velocities() { Cow::Owned(self.at(0.0)) } else { Cow::Borrowed(self) }
    }

    /// Returns when the shutter opens and closes: from 0 to 1 where nothing is said.
    fn shutter(&self) -> [f64; 2] {
        self.optics.shutter.unwrap_or([0.0, 1.0])
    }

    /// Returns the scene as it is in the middle of the time that the shutter is open, from -1/2 to 1/2.
    #[must_use]
    pub fn in_the_middle(&self) -> Self {
        let begun = self.begun();
        let mut scene = begun.clone().into_owned();
        let [opening, closing] = self.shutter();
        let middle = |moves: Triple| moves.map(|c| c * f64::midpoint(opening, closing));
        for (&object, detail) in &begun.details.objects {
            if let Some(moves) = detail.moves {
                scene.shift(object, middle(moves));
            }
        }
        for (&number, &moves) in &begun.details.lamp_moves {
            scene.shift_lamp(number, middle(moves));
        }
        if let Some(moves) = begun.optics.moves {
            shift(&mut scene.camera.eye, middle(moves));
        }
        for moves in scene.all_moves() {
            moves.iter_mut().for_each(|c| *c *= closing - opening);
        }
        scene.optics.shutter = Some([-0.5, 0.5]);
        scene
    }

    /// Returns how far all that moves does, to be changed.
    pub(crate) fn all_moves(&mut self) -> impl Iterator<Item = &mut Triple> {
        let objects = self.details.objects.values_mut().filter_map(|detail| detail.moves.as_mut());
        objects.chain(self.details.lamp_moves.values_mut()).chain(&mut self.optics.moves)
    }

    /// Returns the scene as it is in the middle of the time that the shutter is open, in which nothing moves.
    #[must_use]
    pub fn stopped(&self) -> Self {
        let mut scene = self.in_the_middle();
        scene.details.objects.values_mut().for_each(|detail| detail.moves = None);
        scene.details.lamp_moves.clear();
        scene.optics.moves = None;
        scene
    }

    /// Returns how far an object is moved when the shutter opens and when it closes.
    pub(crate) fn swept(&self, object: Object) -> Option<[Triple; 2]> {
        let detail = self.details.objects.get(&object)?;
        let path = detail.along.as_ref().filter(|_| self.has_velocities());
        let carried = path.map(|path| self.carried(path, 0.0)).unwrap_or_default();
        if detail.moves.is_none() && carried.moves.is_none() {
            return None;
        }
        let end = |time: f64| {
            let mut end = carried.by;
            [detail.moves, carried.moves]
                .into_iter()
                .flatten()
                .for_each(|moves| shift(&mut end, moves.map(|c| c * time)));
            end
        };
        Some(self.shutter().map(end))
    }

    /// Returns the places of an object that move with it: its centre, the ends of its axis, or its corners; of a lamp its middle and
    /// its corners.
    pub(crate) fn places(&self, object: Object) -> Vec<Triple> {
        let place = |number: u32| usize::try_from(number).unwrap_or(usize::MAX);
        match object {
            Object::Ellipsoid(i) => self.ellipsoids.get(place(i)).map(|own| vec![own.position]),
            Object::Sphere(i) => self.spheres.get(place(i)).map(|own| vec![own.position]),
            Object::Cylinder(i) => {
                self.cylinders.get(place(i)).map(|own| vec![[own.position[0], own.position[1], 0.0]])
            }
            Object::Plane(i) => self.planes.get(place(i)).map(|own| vec![own.point]),
            Object::Cone(i) => self.cones.get(place(i)).map(|own| vec![own.base, own.apex]),
            Object::Triangle(i) => self.triangles.get(place(i)).map(|own| own.vertices.to_vec()),
            Object::Lamp(i) => {
                let corners = match self.details.lamps.get(&place(i)) {
                    Some(LampShape::Area { corner, edges: [along, across] }) => {
                        let far = |by: &[Triple]| {
                            let mut place = *corner;
                            by.iter().for_each(|by| shift(&mut place, *by));
                            place
                        };
                        vec![far(&[]), far(&[*along]), far(&[*across]), far(&[*along, *across])]
                    }
                    _ => Vec::new(),
                };
                let middle = self.lamps.get(place(i)).map(|own| own.position);
                Some(middle.into_iter().chain(corners).collect())
            }
            Object::Floor => None,
        }
        .unwrap_or_default()
    }

    /// Moves an object.
    pub(super) fn shift(&mut self, object: Object, by: Triple) {
        let place = |number: u32| usize::try_from(number).unwrap_or(usize::MAX);
        let one = |object: Option<&mut Triple>| object.map_or((), |object| shift(object, by));
        match object {
            Object::Ellipsoid(i) => one(self.ellipsoids.get_mut(place(i)).map(|own| &mut own.position)),
            Object::Sphere(i) => one(self.spheres.get_mut(place(i)).map(|own| &mut own.position)),
            Object::Cylinder(i) => one(self.cylinders.get_mut(place(i)).map(|own| &mut own.position)),
            Object::Plane(i) => one(self.planes.get_mut(place(i)).map(|own| &mut own.point)),
            Object::Cone(i) => {
                if let Some(own) = self.cones.get_mut(place(i)) {
                    shift(&mut own.base, by);
                    shift(&mut own.apex, by);
                }
            }
            Object::Triangle(i) => {
                let own = self.triangles.get_mut(place(i));
                own.into_iter().flat_map(|own| &mut own.vertices).for_each(|vertex| shift(vertex, by));
            }
            Object::Lamp(_) | Object::Floor => {}
        }
    }
}
