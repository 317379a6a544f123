//! All form factors in memory: Gauss's elimination, and Gauss and Seidel's sweeps.

use super::mesh::{Mesh, Patch};
use super::sweep::{Gathered, Outcome, Stop, Watch};
use super::{Error, room};
use crate::color::Rgb;
use crate::scalar::{Light, Scalar, Summed, Unit};

/// The form factors between all patches of a mesh: 4 bytes for each pair in fixed point.
#[derive(Clone, Copy, Debug)]
pub struct Matrix<'a, S: Scalar> {
    mesh: Mesh<'a, S>,
    factors: &'a [S::Unit],
}

impl<'a, S: Scalar> Matrix<'a, S> {
    /// Returns the matrix of a mesh. `row` writes the form factors from a patch to all patches, as
    /// [`Solver::factors`](super::Solver::factors) does; `factors` is room for as many as there are pairs.
    ///
    /// # Errors
    /// [`Error::Room`] where there is too little room, [`Error::Factors`] where the factors of a patch come to more than 1, are negative, or
    /// have it see itself, and those of `row`.
    pub fn new(
        mesh: Mesh<'a, S>,
        factors: &'a mut [S::Unit],
        mut row: impl FnMut(Patch, &mut [S::Unit]) -> Result<(), Error>,
    ) -> Result<Self, Error> {
        let count = mesh.len();
        let factors = room(factors, count.saturating_mul(count))?;
        for (number, (patch, factors)) in
            mesh.patches().zip(factors.chunks_exact_mut(count.max(1))).enumerate()
        {
            row(patch, factors)?;
            let most =
                factors.iter().fold(S::Unit::ROUNDING, |most, _| most + S::Unit::ROUNDING) + S::Unit::ONE;
            let (mut sum, mut is_right) = (S::Unit::ZERO, factors.get(number) == Some(&S::Unit::ZERO));
            for &factor in &*factors {
                // Added up only so far as it cannot overflow.
                is_right &= factor >= S::Unit::ZERO && factor <= most - sum;
                sum = if is_right { sum + factor } else { sum };
            }
            if !is_right {
                return Err(Error::Factors(patch));
            }
        }
        Ok(Self { mesh, factors })
    }

    /// Returns the mesh.
    pub const fn mesh(&self) -> &Mesh<'a, S> {
        &self.mesh
    }

    /// Returns the form factors from a patch to all.
    pub fn row(&self, number: usize) -> &'a [S::Unit] {
        let count = self.mesh.len();
        self.factors.get(number * count..(number + 1) * count).unwrap_or(&[])
    }

    /// Solves by Gauss's elimination: `light` becomes B of each patch, and `work` is room for as many numbers as there are factors.
    ///
    /// A register after the other has a matrix of its own, `1 - rho F`. The pivot of a row is its largest number: that of the patch itself,
    /// and it stays so, since a patch's factors come to 1 at most and reflectances are lower. The others are 0 or negative, so that nothing
    /// cancels out, and no number leaves the range from -1 to 1.
    ///
    /// # Errors
    /// [`Error::Room`] where a slice is too short.
    pub fn gauss(&self, light: &mut [Rgb<S::Light>], work: &mut [S::Unit]) -> Result<(), Error> {
        let count = self.mesh.len();
        let light = room(light, count)?;
        let work = room(work, count.saturating_mul(count))?;
        for register in [Register::Red, Register::Green, Register::Blue] {
            self.eliminate(register, light, work);
            substitute::<S>(register, light, work);
        }
        Ok(())
    }

    /// Makes `work` the upper triangle of the system of one register, each row divided by its pivot, and `light` its right side.
    fn eliminate(&self, register: Register, light: &mut [Rgb<S::Light>], work: &mut [S::Unit]) {
        let count = self.mesh.len();
        for (i, patch) in self.mesh.patches().enumerate() {
            let Some(quad) = self.mesh.quads().get(patch.quad) else { continue };
            let reflectance = register.of(quad.reflectance);
            let (done, rest) = work.split_at_mut(i * count);
            let Some(row) = rest.get_mut(..count) else { continue };
            for (number, factor) in row.iter_mut().zip(self.row(i)) {
                *number = -reflectance.times(*factor);
            }
            row.iter_mut().skip(i).take(1).for_each(|pivot| *pivot = *pivot + S::Unit::ONE);
            let mut sum =
                register.of(quad.emitted(patch.cell)).added(<S::Light as Summed>::EMPTY, S::Unit::ONE);
            for ((k, upper), right) in done.chunks_exact(count).enumerate().zip(&*light) {
                let mut numbers = row.iter_mut().zip(upper).skip(k);
                let Some(factor) = numbers.next().map(|(number, _)| *number) else { continue };
                numbers.for_each(|(number, upper)| *number = *number - factor.times(*upper));
                sum = register.of(*right).added(sum, -factor);
            }
            let mut numbers = row.iter_mut().skip(i);
            let pivot = numbers.next().map_or(S::Unit::ONE, |pivot| *pivot);
            numbers.for_each(|number| *number = number.quotient(pivot));
            let right = S::Light::mean(sum, whole::<S>(pivot), S::Unit::ONE);
            light.iter_mut().skip(i).take(1).for_each(|light| register.put(light, right));
        }
    }

    /// Makes B of each patch what it emits, with which [`Matrix::sweep`] begins.
    ///
    /// # Errors
    /// [`Error::Room`] where the slice is too short.
    pub fn start(&self, light: &mut [Rgb<S::Light>]) -> Result<(), Error> {
        let light = room(light, self.mesh.len())?;
        light
            .iter_mut()
            .zip(self.mesh.patches())
            .for_each(|(light, patch)| *light = self.mesh.emitted(patch));
        Ok(())
    }

    /// Improves B of each patch once, in the order of their numbers (Gauss and Seidel): later patches already see what is new of earlier
    /// ones.
    ///
    /// # Errors
    /// [`Error::Room`] where the slice is too short.
    pub fn sweep(&self, light: &mut [Rgb<S::Light>], bits: u8) -> Result<Outcome<S::Light>, Error> {
        let light = room(light, self.mesh.len())?;
        let mut watch = Watch::NEW;
        for (number, patch) in self.mesh.patches().enumerate() {
            let Some(quad) = self.mesh.quads().get(patch.quad) else { continue };
            let mut gathered = Gathered::NOTHING;
            gathered.weigh(S::Unit::ONE);
            self.row(number).iter().zip(&*light).for_each(|(factor, light)| gathered.add(*light, *factor));
            let reflected = gathered.mean(quad.reflectance);
            if let Some(light) = light.get_mut(number) {
                watch.put(light, reflected.plus(quad.emitted(patch.cell)), reflected);
            }
        }
        Ok(watch.outcome(bits))
    }

    /// Solves by sweeps from what is emitted: `light` becomes B of each patch.
    ///
    /// # Errors
    /// [`Error::Room`] where the slice is too short.
    pub fn solve(&self, light: &mut [Rgb<S::Light>], stop: Stop) -> Result<Outcome<S::Light>, Error> {
        self.start(light)?;
        stop.repeat(|| self.sweep(light, stop.bits))
    }
}

/// Solves the upper triangle that elimination leaves, from the last patch to the first.
fn substitute<S: Scalar>(register: Register, light: &mut [Rgb<S::Light>], work: &[S::Unit]) {
    let count = light.len();
    for (i, row) in work.chunks_exact(count.max(1)).enumerate().rev() {
        let Some((own, others)) = light.get_mut(i..).and_then(<[_]>::split_first_mut) else { continue };
        let mut sum = register.of(*own).added(<S::Light as Summed>::EMPTY, S::Unit::ONE);
        for (number, other) in row.iter().skip(i + 1).zip(&*others) {
            sum = register.of(*other).added(sum, -*number);
        }
        register.put(own, S::Light::mean(sum, whole::<S>(S::Unit::ONE), S::Unit::ONE));
    }
}

/// Returns the sum of weights that come to this number.
fn whole<S: Scalar>(weight: S::Unit) -> <S::Light as Summed>::Sum {
    S::Light::WHITE.added(<S::Light as Summed>::EMPTY, weight)
}

/// One of three registers.
#[derive(Clone, Copy)]
enum Register {
    Red,
    Green,
    Blue,
}

impl Register {
    fn of<T>(self, color: Rgb<T>) -> T {
        match self {
            Self::Red => color.r,
            Self::Green => color.g,
            Self::Blue => color.b,
        }
    }

    fn put<T>(self, color: &mut Rgb<T>, value: T) {
        match self {
            Self::Red => color.r = value,
            Self::Green => color.g = value,
            Self::Blue => color.b = value,
        }
    }
}
