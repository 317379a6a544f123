//! Vectors of three `f64`.

/// A place or a direction.
pub type Triple = [f64; 3];

/// Returns `a - b`.
#[must_use]
pub fn difference(a: Triple, b: Triple) -> Triple {
    let ([ax, ay, az], [bx, by, bz]) = (a, b);
    [ax - bx, ay - by, az - bz]
}

/// Returns the dot product.
#[must_use]
pub fn dot(a: Triple, b: Triple) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Returns the cross product.
#[must_use]
pub fn cross(a: Triple, b: Triple) -> Triple {
    let ([ax, ay, az], [bx, by, bz]) = (a, b);
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}

/// The length, without leaving the range of `f64` on the way.
pub fn length(v: Triple) -> f64 {
    let greatest = v.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
    if greatest > 0.0 && greatest.is_finite() {
        let scaled = v.map(|c| c / greatest);
        greatest * dot(scaled, scaled).sqrt()
    } else {
        greatest
    }
}

/// The direction with length 1; nothing of a vector that is zero or not finite.
pub fn unit(v: Triple) -> Option<Triple> {
    let greatest = v.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
    if !(greatest > 0.0 && v.iter().all(|c| c.is_finite())) {
        return None;
    }
    let scaled = v.map(|c| c / greatest);
    let length = dot(scaled, scaled).sqrt();
    Some(scaled.map(|c| c / length))
}
