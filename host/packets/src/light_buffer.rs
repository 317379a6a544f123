//! Light buffers: for each direction from the eye, and from each of the first lamps, the leaves that lie there.
//!
//! Most rays start at the eye or end at a lamp. They do not need the hierarchy, but use the light buffer of E. Haines and
//! D. Greenberg ("The Light Buffer: A Shadow-Testing Accelerator", IEEE CG&A 6, 1986), which serves the eye as well. The six
//! faces of a cube about the point are divided into cells, and each cell lists the leaves that are seen through it.

use glam::Vec4;

use crate::leaf::index;
use crate::rays::RayF32;

/// A leaf that is seen through a cell, and how much farther away it is than [`LightBuffer::nearest`], with 7 binary digits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Candidate(u32);

impl Candidate {
    /// Instead of a leaf's number: there are more leaves than the cell lists, and the hierarchy has to be searched.
    pub(crate) const REST: u32 = (1 << Self::LEAF_BITS) - 1;
    const LEAF_BITS: u32 = 18;

    /// Returns a candidate from a distance, 0 or more, and the number of a leaf, or [`Candidate::REST`].
    #[must_use]
    pub(crate) fn new(near: f32, leaf: u32) -> Self {
        // There is no sign.
        Self(near.to_bits() << 1 & !Self::REST | leaf & Self::REST)
    }

    /// Returns a lower bound of the leaf's distance beyond [`LightBuffer::nearest`].
    #[inline]
    #[must_use]
    pub(crate) fn near(self) -> f32 {
        f32::from_bits((self.0 & !Self::REST) >> 1)
    }

    /// Returns the number of the leaf, or [`Candidate::REST`].
    #[inline]
    #[must_use]
    pub(crate) const fn leaf(self) -> u32 {
        self.0 & Self::REST
    }
}

/// A face: cells in rows. Of each vector, the component of the face's own axis and the last are those of one cell.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Face {
    /// Where the middle of the first cell is, at the distance 1.
    pub(crate) low: Vec4,
    /// How many cells are as long as 1.
    pub(crate) scale: Vec4,
    /// How many cells there are, less a half.
    pub(crate) end: Vec4,
    /// How many cells the next one along an axis is away.
    pub(crate) stride: Vec4,
    /// The number of the first cell.
    pub(crate) first: u32,
    /// That of the cell for what lies beside the others.
    pub(crate) beside: u32,
}

impl Face {
    /// Nothing is seen through it.
    pub(crate) const EMPTY: Self = Self {
        low: Vec4::ZERO,
        scale: Vec4::ZERO,
        end: Vec4::splat(-1.0),
        stride: Vec4::ZERO,
        first: 0,
        beside: u32::MAX,
    };
}

/// A light buffer: the faces of a cube about the eye or a lamp, divided into cells.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LightBuffer {
    /// x, y and z of the point; the last is [`Packets::size`].
    pub(crate) center: Vec4,
    /// The distance by which a ray may miss the point. The objects were enlarged by twice as much for the cells, which also covers
    /// the ray's own margin and the rounding of these numbers.
    pub(crate) slack: f32,
    /// The largest margin of a ray that it serves.
    pub(crate) margin: f32,
    /// The distance of the nearest object from the point.
    pub(crate) nearest: f32,
    /// The faces towards x, -x, y, -y, z, -z.
    pub(crate) faces: [Face; 6],
}

/// Added and taken away again, it rounds what is below 2^22 in size.
const ROUND: Vec4 = Vec4::splat(12_582_912.0);
/// Added to a whole number below 2^23, that is the last digits of the sum.
const WHOLE: f32 = 8_388_608.0;
const DIGITS: u32 = 0x7f_ffff;

impl LightBuffer {
    /// A light buffer that serves no ray.
    pub(crate) const NONE: Self =
        Self { center: Vec4::ZERO, slack: 0.0, margin: -1.0, nearest: 0.0, faces: [Face::EMPTY; 6] };

    /// Returns the number of the cell that a direction leads through.
    #[inline(always)]
    fn cell(&self, direction: Vec4) -> Option<usize> {
        // Without a branch, as the axis is as good as random from one lamp to the next.
        let size = direction.abs();
        let most = size.max_element();
        let axis = index(size.cmpge(Vec4::splat(most)).bitmask().trailing_zeros() & 3);
        let side = direction.is_negative_bitmask() as usize >> axis & 1;
        let face = self.faces.get(2 * axis + side)?;
        let place = (direction * Vec4::splat(most.recip()) - face.low) * face.scale;
        if (place.cmpge(Vec4::splat(-0.5)) & place.cmplt(face.end)).bitmask() != 15 {
            return Some(index(face.beside));
        }
        let place = (place + ROUND) - ROUND;
        let cell = (place.dot(face.stride) + WHOLE).to_bits() & DIGITS;
        Some(index(face.first) + index(cell))
    }

    /// Returns the numbers of the cells that four directions lead through; a number beyond all cells where there is none.
    #[inline(always)]
    pub(crate) fn cells(&self, direction: [Vec4; 3]) -> [usize; 4] {
        let [x, y, z] = direction;
        let (ax, ay, az) = (x.abs(), y.abs(), z.abs());
        let most = ax.max(ay).max(az);
        let (along_x, along_y) = (ax.cmpge(most).bitmask(), ay.cmpge(most).bitmask());
        let face = match (along_x, along_y) {
            (15, _) => one_of(self.faces.first_chunk(), x),
            (0, 15) => one_of(self.faces.get(2..).and_then(|rest| rest.first_chunk()), y),
            (0, 0) => one_of(self.faces.last_chunk(), z),
            _ => None,
        };
        let Some(face) = face else {
            let lane = |k: usize| {
                let at = |four: Vec4| four.as_ref().get(k).copied().unwrap_or_default();
                self.cell(Vec4::new(at(x), at(y), at(z), 0.0)).unwrap_or(usize::MAX)
            };
            return [lane(0), lane(1), lane(2), lane(3)];
        };
        let (inverse, mut cells, mut are_there) = (most.recip(), Vec4::splat(WHOLE), 15);
        for (axis, direction) in direction.into_iter().enumerate() {
            let at = |four: Vec4| Vec4::splat(four.as_ref().get(axis).copied().unwrap_or_default());
            let place = (direction * inverse - at(face.low)) * at(face.scale);
            are_there &= (place.cmpge(Vec4::splat(-0.5)) & place.cmplt(at(face.end))).bitmask();
            cells += ((place + ROUND) - ROUND) * at(face.stride);
        }
        let mut lane = 0;
        cells.to_array().map(|cell| {
            let is_there = are_there >> lane & 1 == 1;
            lane += 1;
            if is_there { index(face.first) + index(cell.to_bits() & DIGITS) } else { index(face.beside) }
        })
    }
}

/// The face on the side of four numbers; nothing where they are not on one side.
#[inline(always)]
fn one_of(faces: Option<&[Face; 2]>, along: Vec4) -> Option<&Face> {
    let [upwards, downwards] = faces?;
    match along.is_negative_bitmask() {
        0 => Some(upwards),
        15 => Some(downwards),
        _ => None,
    }
}

/// The candidates of a ray that passes the point of a light buffer, the nearest first.
pub(crate) struct Candidates<'a> {
    pub(crate) entries: &'a [Candidate],
    nearest: f32,
}

impl Candidates<'_> {
    /// A lower bound of the distance of each candidate from the point.
    #[inline(always)]
    pub(crate) fn near(&self, entry: Candidate) -> f32 {
        entry.near() + self.nearest
    }
}

/// The light buffers of a scene: of the eye, and of as many lamps as their memory is enough for.
#[derive(Clone, Debug, Default)]
pub(crate) struct LightBuffers {
    /// The light buffer of the eye, then those of the first lamps; or none at all.
    pub(crate) buffers: Vec<LightBuffer>,
    /// The first candidate of each cell of the buffers, and where those of the last cell end.
    pub(crate) cells: Vec<u32>,
    /// The candidates of all cells.
    pub(crate) candidates: Vec<Candidate>,
}

impl LightBuffers {
    /// Returns how many bytes the cells and candidates take.
    pub(crate) const fn bytes(&self) -> usize {
        self.cells.len() * size_of::<u32>() + self.candidates.len() * size_of::<Candidate>()
    }

    /// Returns the candidates of a ray that starts at the eye; `None` if it does not.
    #[inline(always)]
    pub(crate) fn eye_sees(&self, ray: &RayF32) -> Option<Candidates<'_>> {
        let buffer = self.buffers.first()?;
        let beside = buffer.center - ray.origin;
        let is_there = beside.length_squared() <= buffer.slack * buffer.slack && ray.margin <= buffer.margin;
        is_there.then(|| self.seen(buffer, ray.direction))
    }

    /// Returns the candidates of a ray that ends at lamp number `lamp` within `t_max`, and the distance of its origin from the lamp;
    /// `None` if it does not end there, or if there are too many candidates.
    #[inline(always)]
    pub(crate) fn lamp_sees(&self, ray: &RayF32, t_max: f32, lamp: usize) -> Option<(Candidates<'_>, f32)> {
        let buffer = self.buffers.get(lamp + 1)?;
        let way = buffer.center - ray.origin;
        let along = way.dot(ray.direction);
        let beside = way - ray.direction * along;
        let far = along + buffer.slack;
        let is_there = beside.length_squared() <= buffer.slack * buffer.slack
            && ray.margin <= buffer.margin
            && t_max <= far;
        if !is_there {
            return None;
        }
        let seen = self.seen(buffer, -ray.direction);
        match seen.entries.last() {
            Some(&rest) if rest.leaf() == Candidate::REST && seen.near(rest) <= far => None,
            _ => Some((seen, far)),
        }
    }

    #[inline(always)]
    fn seen(&self, buffer: &LightBuffer, direction: Vec4) -> Candidates<'_> {
        let run = buffer.cell(direction).and_then(|cell| self.run(cell));
        Candidates { entries: run.unwrap_or_default(), nearest: buffer.nearest }
    }

    /// Returns the candidates of a cell of a light buffer, both by number; the eye's light buffer is the first.
    #[inline(always)]
    pub(crate) fn in_cell(&self, buffer: usize, cell: usize) -> Candidates<'_> {
        let nearest = self.buffers.get(buffer).map_or(0.0, |buffer| buffer.nearest);
        Candidates { entries: self.run(cell).unwrap_or_default(), nearest }
    }

    #[inline(always)]
    fn run(&self, cell: usize) -> Option<&[Candidate]> {
        let (first, end) = (*self.cells.get(cell)?, *self.cells.get(cell + 1)?);
        self.candidates.get(index(first)..index(end))
    }
}
