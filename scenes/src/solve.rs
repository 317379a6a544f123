//! A scene that is solved for its radiosity before it is drawn.

use rta_core::color::Rgb;
use rta_core::needs::Everything;
use rta_core::radiosity::{self, Mesh, Rays, Solver};
use rta_core::range::Admitted;
use rta_core::scene::Limits;

use crate::accelerator::bvh;
use crate::accelerator::search::Search;
use crate::description::Description;
use crate::narrow::{Narrow, Narrowed};

impl<S: Narrow> Narrowed<S> {
    /// Solves for the indirect light of a scene that has [none yet](Description::unsolved), as a board does. `limits` are those of the scene,
    /// and `description` is what it was made of.
    ///
    /// # Errors
    /// What is wrong with the quads.
    pub fn solve(&mut self, description: &Description, limits: Limits<S>) -> Result<(), radiosity::Error> {
        let Some(lit) = self.lit.as_ref().filter(|lit| lit.arriving.is_empty()) else { return Ok(()) };
        let built = bvh::build::<S>(description);
        let search = built.bvh().map_or(Search::Lists, Search::Hierarchy);
        let admitted = Admitted::baked(self.scene(), limits, search);
        let mesh = Mesh::new(&lit.quads, &admitted.scene)?;
        let mut memory = [(); 2].map(|()| vec![Rgb::BLACK; mesh.len()]);
        let [reflected, arriving] = &mut memory;
        let elsewhere =
            Solver::<S, Everything, Rays, _>::indirect_light(&admitted, mesh, reflected, arriving)?;
        let [_, arriving] = memory;
        if let Some(lit) = &mut self.lit {
            (lit.arriving, lit.elsewhere) = (arriving, elsewhere);
        }
        Ok(())
    }
}
