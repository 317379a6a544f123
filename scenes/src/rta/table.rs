//! What a table of statements is made of: each with its words, their values, ranges and defaults, and a sentence for people.

use crate::numbers::Range;

/// A statement of the language.
pub(super) struct Statement {
    /// The word that it begins with.
    pub(super) keyword: &'static str,
    /// What an error calls it.
    pub(super) noun: &'static str,
    /// Whether a scene has it at most once.
    pub(super) once: bool,
    /// What it says, in a sentence without a full stop.
    pub(super) about: &'static str,
    /// What it consists of; what stands first has no keyword.
    pub(super) parts: &'static [Part],
}

impl Statement {
    /// Returns the part without a keyword, if there is one.
    pub(super) fn leading(&self) -> Option<&'static Part> {
        self.parts.first().filter(|part| part.keyword.is_empty())
    }
}

/// A keyword with its values, or values without one.
pub(super) struct Part {
    pub(super) keyword: &'static str,
    /// The values that always follow.
    pub(super) values: &'static [Value],
    /// Values that may follow them, together, and how often.
    pub(super) more: (&'static [Value], usize),
    /// Parts that stay behind these values, in this order.
    pub(super) tail: &'static [Part],
    pub(super) need: Need,
    /// Whether it may be given again right behind itself.
    pub(super) repeats: bool,
    /// What holds where it is not given; empty if there is nothing to be said.
    pub(super) default: &'static str,
    /// What it says, without a full stop.
    pub(super) about: &'static str,
}

/// Whether a part must be given.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Need {
    May,
    Must,
    /// Exactly one of the parts with this number.
    One(u8),
    /// At most one of the parts with this number.
    AtMost(u8),
}

/// A value, by what it is called, as in "the radius of the sphere".
pub(super) struct Value(pub(super) &'static str, pub(super) Kind);

/// What a value is.
#[derive(Clone, Copy)]
pub(super) enum Kind {
    Number(Range),
    Share,
    /// A whole number from the first to the second.
    Whole(u32, u32),
    /// Three coordinates.
    Vector(Range),
    /// Three registers, or a word for them.
    Color(Range),
    /// A colour, or one number for its three registers.
    Spectrum(Range),
    /// A name that is defined by this.
    New,
    /// A name of something, as an error calls it.
    Name(&'static str),
    File,
    Axis,
    /// The word `offset` with a number, which is 1 where it is left out.
    Offset,
    /// Words, each with numbers or without, to the end of the statement.
    Options,
}

/// Makes a part that may be given.
pub(super) const fn may(keyword: &'static str, values: &'static [Value], about: &'static str) -> Part {
    let (more, tail) = ((&[] as &[Value], 0), &[] as &[Part]);
    Part { keyword, values, more, tail, need: Need::May, repeats: false, default: "", about }
}

/// Makes a part that must be given.
pub(super) const fn must(keyword: &'static str, values: &'static [Value], about: &'static str) -> Part {
    Part { need: Need::Must, ..may(keyword, values, about) }
}

/// Makes a part that must be given if no other of this number is.
pub(super) const fn one(
    of: u8,
    keyword: &'static str,
    values: &'static [Value],
    about: &'static str,
) -> Part {
    Part { need: Need::One(of), ..may(keyword, values, about) }
}

/// Makes a part that may be given if no other of this number is.
pub(super) const fn either(
    of: u8,
    keyword: &'static str,
    values: &'static [Value],
    about: &'static str,
) -> Part {
    Part { need: Need::AtMost(of), ..may(keyword, values, about) }
}

impl Part {
    pub(super) const fn default(self, default: &'static str) -> Self {
        Self { default, ..self }
    }

    pub(super) const fn tail(self, tail: &'static [Self]) -> Self {
        Self { tail, ..self }
    }

    pub(super) const fn more(self, most: usize, values: &'static [Value]) -> Self {
        Self { more: (values, most), ..self }
    }
}
