//! A scene that is solved for its radiosity before it is drawn.

use rta_core::color::Rgb;
use rta_core::needs::Everything;
use rta_core::radiosity::{self, Mesh, Quad, Rays, Solver};
use rta_core::range::Admitted;
use rta_core::scalar::Scalar;
use rta_core::scene::Limits;

use crate::accelerator::bvh;
use crate::accelerator::search::Search;
use crate::description::Description;
use crate::narrow::{Narrow, Narrowed};

/// What each patch reflects, a radiosity, and what arrives at it, over pi; and the mean of that over the area.
type Found<S> = ([Vec<Rgb<<S as Scalar>::Light>>; 2], Rgb<<S as Scalar>::Light>);

impl<S: Narrow> Narrowed<S> {
    /// Makes the indirect light of a scene ready for pictures of it. It is solved for, as a board does, where there is [none
    /// yet](Description::unsolved). `limits` are those of the scene, and `description` is what it was made of.
    ///
    /// # Errors
    /// What is wrong with the quads.
    pub fn solve(&mut self, description: &Description, limits: Limits<S>) -> Result<(), radiosity::Error> {
        if let Some(mut lit) = self.lit.take() {
            if lit.arriving.is_empty() {
                let ([reflected, arriving], elsewhere) = self.solved(&lit.quads, description, limits)?;
                (lit.arriving, lit.elsewhere) = (arriving, elsewhere);
                if let Some(gathering) = &mut lit.gathering {
                    gathering.reflected = reflected;
                }
            }
            lit.keep(&self.scene());
            self.lit = Some(lit);
        }
        Ok(())
    }

    /// Solves for the light of the patches of a scene.
    fn solved(
        &self,
        quads: &[Quad<S>],
        description: &Description,
        limits: Limits<S>,
    ) -> Result<Found<S>, radiosity::Error> {
        let built = bvh::build::<S>(description);
        let search = built.bvh().map_or(Search::Lists, Search::Hierarchy);
        let admitted = Admitted::baked(self.scene(), limits, search);
        let mesh = Mesh::new(quads, &admitted.scene)?;
        let mut memory = [(); 2].map(|()| vec![Rgb::BLACK; mesh.len()]);
        let [reflected, arriving] = &mut memory;
        let elsewhere =
            Solver::<S, Everything, Rays, _>::indirect_light(&admitted, mesh, reflected, arriving)?;
        Ok((memory, elsewhere))
    }
}
