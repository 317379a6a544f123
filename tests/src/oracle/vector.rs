//! Vectors of the oracles: three numbers and the operations of a first course.

pub(super) type Vector = [f64; 3];

pub(super) fn sum<const N: usize>(vectors: [Vector; N]) -> Vector {
    vectors.into_iter().fold([0.0; 3], |[x, y, z], [u, v, w]| [x + u, y + v, z + w])
}

pub(super) fn difference([x, y, z]: Vector, [u, v, w]: Vector) -> Vector {
    [x - u, y - v, z - w]
}

/// Returns the product component by component.
pub(super) fn product([x, y, z]: Vector, [u, v, w]: Vector) -> Vector {
    [x * u, y * v, z * w]
}

pub(super) fn scale(factor: f64, vector: Vector) -> Vector {
    vector.map(|part| factor * part)
}

pub(super) fn dot(u: Vector, v: Vector) -> f64 {
    let [x, y, z] = product(u, v);
    x + y + z
}

pub(super) fn cross([x, y, z]: Vector, [u, v, w]: Vector) -> Vector {
    [y * w - z * v, z * u - x * w, x * v - y * u]
}

pub(super) fn length(vector: Vector) -> f64 {
    dot(vector, vector).sqrt()
}

pub(super) fn unit(vector: Vector) -> Vector {
    scale(1.0 / length(vector), vector)
}

/// Returns the largest magnitude of a component.
pub(super) fn largest(vector: Vector) -> f64 {
    vector.iter().fold(0.0, |most, part| most.max(part.abs()))
}
