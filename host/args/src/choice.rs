//! What the values of options may be: number formats and illumination models by their names, and whole numbers.

use core::fmt::Display;
use core::ops::RangeInclusive;
use core::str::FromStr;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

use rta_scenes::{Format, Model};

/// A parser of the name of a number format.
pub(super) fn format() -> impl TypedValueParser<Value = Format> {
    one_of(Format::ALL, Format::name, Format::about)
}

/// A parser of the name of a number format that is put beside `f64`.
pub(super) fn tested_format() -> impl TypedValueParser<Value = Format> {
    PossibleValuesParser::new(["f32", "q16", "q20"]).try_map(|text| named(Format::ALL, Format::name, &text))
}

/// A parser of the name of an illumination model.
pub(super) fn model() -> impl TypedValueParser<Value = Model> {
    one_of(Model::ALL, Model::name, Model::about)
}

fn one_of<T: Copy + Send + Sync + 'static>(
    all: &'static [T],
    name: fn(T) -> &'static str,
    about: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    let values = all.iter().map(|&one| PossibleValue::new(name(one)).help(about(one)));
    PossibleValuesParser::new(values).try_map(move |text| named(all, name, &text))
}

/// The choice of that name. The parsers let only names pass, in upper or lower case.
fn named<T: Copy>(all: &[T], name: fn(T) -> &'static str, text: &str) -> Result<T, &'static str> {
    all.iter().copied().find(|&one| name(one).eq_ignore_ascii_case(text)).ok_or("no such name")
}

/// A parser of a whole number within `range`.
pub(super) fn whole<T>(range: RangeInclusive<T>) -> impl TypedValueParser<Value = T>
where
    T: Copy + Display + FromStr + PartialOrd + Send + Sync + 'static,
{
    move |text: &str| {
        let number = text.parse().ok().filter(|number| range.contains(number));
        number.ok_or_else(|| format!("expected a whole number from {} to {}", range.start(), range.end()))
    }
}

/// Reads a length of 0 or more.
pub(super) fn length(text: &str) -> Result<f64, &'static str> {
    let length = text.parse().ok().filter(|length: &f64| length.is_finite() && *length >= 0.0);
    length.ok_or("expected a length of 0 or more")
}

/// Reads a length above 0.
pub(super) fn distance(text: &str) -> Result<f64, &'static str> {
    length(text).ok().filter(|length| *length > 0.0).ok_or("expected a length above 0")
}

/// The models that are put side by side.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Models(pub Vec<Model>);

/// Reads names with commas between them, or `all`.
impl FromStr for Models {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text.eq_ignore_ascii_case("all") {
            return Ok(Self(Model::ALL.to_vec()));
        }
        let known = || Model::ALL.iter().map(|model| model.name()).collect::<Vec<_>>().join(", ");
        let model = |name: &str| {
            let named = |model: &&Model| model.name().eq_ignore_ascii_case(name.trim());
            let model = Model::ALL.iter().find(named).copied();
            model.ok_or_else(|| {
                format!("expected all, or models with commas between them, of {}; found {name:?}", known())
            })
        };
        text.split(',').map(model).collect::<Result<_, _>>().map(Self)
    }
}
