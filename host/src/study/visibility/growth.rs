//! What the algorithms cost as the faces of a scene grow, beside the table of I. Sutherland, R. Sproull and R. Schumacker, "A Characterization of
//! Ten Hidden-Surface Algorithms", ACM Computing Surveys 6(1), 1974.

use super::algorithm::ALL;
use super::comparison::Comparison;

/// The numbers of faces of the table of 1974.
pub const FACES: [usize; 3] = [100, 2500, 60_000];

/// The relative costs of the table of 1974. The depth sort is that of M. Newell, R. Newell and T. Sancha, in the place of the painter's tree.
pub const TABLE: [(&str, [u32; 3]); 4] = [
    ("depth sort, 1974", [1, 10, 507]),
    ("scan-line, 1974", [5, 21, 100]),
    ("Warnock, 1974", [11, 64, 307]),
    ("Z-buffer, 1974", [54, 54, 54]),
];

/// What all algorithms cost at one number of faces.
#[derive(Clone, Debug, PartialEq)]
pub struct Cost {
    /// Bands of each sphere.
    pub rows: u32,
    /// Faces of the scene.
    pub faces: usize,
    /// Triangles that are before the eye.
    pub triangles: usize,
    /// The steps of each algorithm of the list, where it was run.
    pub steps: Vec<Option<u64>>,
}

impl Cost {
    /// Returns the steps of a comparison.
    #[must_use]
    pub fn new((rows, faces, triangles): (u32, usize, usize), of: &Comparison) -> Self {
        let steps = of.runs.iter().map(|(_, run)| run.as_ref().ok().map(|run| run.outcome.counts.steps()));
        Self { rows, faces, triangles, steps: steps.collect() }
    }
}

/// Two algorithms of which the one is cheaper below a number of faces and the other above it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// The one that is cheaper below.
    pub few: &'static str,
    /// The one that is cheaper above.
    pub many: &'static str,
    /// The number of faces.
    pub faces: f64,
}

/// Returns where the costs of two algorithms cross, on straight lines between the logarithms of faces and steps.
#[must_use]
pub fn crossings(costs: &[Cost]) -> Vec<Crossing> {
    let mut crossings = Vec::new();
    for (before, after) in costs.iter().zip(costs.iter().skip(1)) {
        let [from, to] = [before, after].map(|cost| (cost.faces as f64).ln());
        let lines: Vec<_> = ALL
            .iter()
            .zip(before.steps.iter().zip(&after.steps))
            .filter_map(|(algorithm, (before, after))| {
                Some((algorithm.name, (*before.as_ref()? as f64).ln(), (*after.as_ref()? as f64).ln()))
            })
            .collect();
        for (place, a) in lines.iter().enumerate() {
            for b in lines.iter().skip(place + 1) {
                let (start, end) = (a.1 - b.1, a.2 - b.2);
                if start * end < 0.0 {
                    let faces = (from + start / (start - end) * (to - from)).exp();
                    let (few, many) = if start < 0.0 { (a.0, b.0) } else { (b.0, a.0) };
                    crossings.push(Crossing { few, many, faces });
                }
            }
        }
    }
    crossings
}

#[cfg(test)]
mod tests {
    use super::{ALL, Cost, Crossing, crossings};

    #[test]
    fn costs_cross_where_powers_do() {
        // n^2 and 1000 n cross at 1000.
        let cost = |faces: usize| {
            let n = faces as u64;
            let steps = vec![Some(n * n), Some(1000 * n), None, None, None, None, None, None];
            Cost { rows: 2, faces, triangles: faces, steps }
        };
        let found = crossings(&[cost(10), cost(100), cost(100_000)]);
        let [Crossing { few, many, faces }] = found[..] else { panic!("{found:?}") };
        assert_eq!((few, many), (ALL[0].name, ALL[1].name));
        assert!((faces - 1000.0).abs() < 1e-6, "{faces}");
    }
}
