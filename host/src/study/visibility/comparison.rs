//! All algorithms on one view, and how their ids compare.

use cpu_time::ThreadTime;

use super::algorithm::{ALL, Algorithm};
use super::integer::View;
use super::outcome::{LeftOut, Outcome};
use super::scanplane::distance;
use super::tracer;

/// How far from an edge the samples of areas in `f64` may differ from exact ids, in the unit of the distance of the image plane.
const SAMPLES: f64 = 1e-9;

/// How far from an edge the tracer's hits in `f64` may differ, in that unit.
const HITS: f64 = 1.0 / (1 << 30) as f64;

/// How many pixels have another id than the exact one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Apart {
    /// Those within reach of an edge.
    pub at_edges: usize,
    /// All others.
    pub elsewhere: usize,
}

impl Apart {
    /// Compares ids with the exact ones. Within `reach` of an edge of either triangle, or of the line in which they meet, is at an edge.
    #[must_use]
    pub fn new(view: &View, ids: &[u32], exact: &[u32], reach: f64) -> Self {
        let width = view.raster.size.width();
        let mut apart = Self { at_edges: 0, elsewhere: ids.len().abs_diff(exact.len()) };
        for (place, pair) in (0..).zip(ids.iter().zip(exact)).filter(|(_, (own, exact))| own != exact) {
            let ray = view.raster.ray(place % width, place / width);
            let [own, exact] = [*pair.0, *pair.1].map(|id| view.triangle(id));
            let far = |one: Option<_>, other| one.map_or(f64::INFINITY, |one| distance(one, other, ray));
            let is_near = far(own, exact).min(far(exact, own)) < reach;
            *(if is_near { &mut apart.at_edges } else { &mut apart.elsewhere }) += 1;
        }
        apart
    }

    /// Returns the number of all of them.
    #[must_use]
    pub const fn pixels(self) -> usize {
        self.at_edges + self.elsewhere
    }
}

/// What an algorithm did.
#[derive(Clone, Debug)]
pub struct Run {
    /// What came of it.
    pub outcome: Outcome,
    /// How its ids compare.
    pub apart: Apart,
    /// CPU time, in milliseconds.
    pub milliseconds: f64,
}

impl Run {
    /// Returns whether the ids are equal: everywhere, or but for edges where the algorithm rounds.
    #[must_use]
    pub const fn is_equal(&self, algorithm: &Algorithm) -> bool {
        self.apart.elsewhere == 0 && (self.apart.at_edges == 0 || !algorithm.is_exact)
    }
}

/// All algorithms on one view.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The exact ids.
    pub ids: Vec<u32>,
    /// The algorithms with what they did.
    pub runs: Vec<(Algorithm, Result<Run, LeftOut>)>,
    /// How the ids of the tracer compare.
    pub tracer: Apart,
}

impl Comparison {
    /// Runs all algorithms. Their ids are compared with those of the first of the list that is run.
    #[must_use]
    pub fn new(view: &View) -> Self {
        let outcomes = ALL.map(|algorithm| {
            let start = ThreadTime::now();
            let outcome = (algorithm.draw)(view);
            (algorithm, outcome, start.elapsed().as_secs_f64() * 1e3)
        });
        let first = outcomes.iter().find_map(|(_, outcome, _)| outcome.as_ref().ok());
        let ids = first.map_or_else(|| view.blank(), |outcome| outcome.ids.clone());
        let runs = outcomes.map(|(algorithm, outcome, milliseconds)| {
            let reach = if algorithm.is_exact { 0.0 } else { SAMPLES };
            let run = outcome.map(|outcome| {
                let apart = Apart::new(view, &outcome.ids, &ids, reach);
                Run { outcome, apart, milliseconds }
            });
            (algorithm, run)
        });
        let tracer = Apart::new(view, &tracer::traced(view), &ids, HITS);
        Self { ids, runs: runs.into(), tracer }
    }

    /// Returns whether all ids are equal, as far as the algorithms were run.
    #[must_use]
    pub fn is_equal(&self) -> bool {
        let equal = |(algorithm, run): &(Algorithm, Result<Run, LeftOut>)| {
            run.as_ref().map_or(true, |run| run.is_equal(algorithm))
        };
        self.tracer.elsewhere == 0 && self.runs.iter().all(equal)
    }
}

#[cfg(test)]
mod tests {
    use super::{Apart, Comparison};
    use crate::study::visibility::samples::{random, ring, view};

    #[test]
    fn a_pixel_that_differs_is_found() {
        let view = view((16, 16), &ring());
        let comparison = Comparison::new(&view);
        assert!(comparison.is_equal() && comparison.runs.iter().all(|(_, run)| run.is_ok()));
        let mut ids = comparison.ids.clone();
        // The middle of the first bar's near end, and a corner of the picture.
        let inside = ids.iter().position(|id| *id == 1).expect("it is seen");
        ids.iter_mut().skip(inside).take(1).for_each(|id| *id = 0);
        assert_eq!(Apart::new(&view, &ids, &comparison.ids, 1e-9), Apart { at_edges: 0, elsewhere: 1 });
        assert_eq!(Apart::new(&view, &ids, &comparison.ids, 1.0), Apart { at_edges: 1, elsewhere: 0 });
    }

    #[test]
    fn the_tracer_sees_the_same_triangles() {
        for seed in 10..13 {
            let comparison = Comparison::new(&view((80, 60), &random(seed, 300, 20_000)));
            assert!(comparison.is_equal(), "{:?}", comparison.tracer);
        }
    }
}
