//! The illumination models by name, with the options that a scene may give them.

use super::nearest::{any_of, found};
use super::said::{Datum, Said};
use crate::description::{Model, ModelOption};
use crate::error::{Found, SceneError};
use crate::numbers::Range;

/// An option: its name, and the range of each number that may follow it.
type Choice = (&'static str, &'static [Range]);

const FACETS: Range = Range::Between(1.0, 1000.0);
const POSITIVE: &[Range] = &[Range::Positive];
const STEPS: Range = Range::Whole(1, 3);
const EDGE: &[Range] = &[STEPS, Range::Share, Range::Share];
const GLOSS: &[Range] = &[Range::Gloss];

/// The options of the models that have some.
const OPTIONS: &[(&str, &[Choice])] = &[
    ("bouknight", &[("mach", &[STEPS]), ("p", &[Range::Between(1.0, 2.0)])]),
    ("romney", &[("p", &[Range::Between(1.0, 100.0)])]),
    ("newell", &[("edge", EDGE)]),
    (
        "blinn-full",
        &[
            ("power", &[FACETS]),
            ("gauss", POSITIVE),
            ("trowbridge", &[Range::Part]),
            ("gloss", GLOSS),
            ("lobes", &[]),
        ],
    ),
    (
        "cook-torrance",
        &[
            ("sancer", &[]),
            ("exact", &[]),
            ("published", &[]),
            ("mirror", &[Range::Share]),
            ("gloss", GLOSS),
            ("lobes", &[]),
        ],
    ),
    ("hall-greenberg", &[("cutoff", &[Range::Share])]),
];

/// Returns a line for each model that has options: its name, and each option with what the numbers that may follow it may be.
pub(super) fn lines() -> impl Iterator<Item = String> {
    let option = |(name, ranges): &Choice| {
        let ranges = ranges.iter().map(|range| format!(" [{}]", range.to_string().replace("a number ", "")));
        ranges.fold((*name).to_owned(), |line, range| line + &range)
    };
    OPTIONS
        .iter()
        .map(move |(name, own)| format!("{name}: {}", own.iter().map(option).collect::<Vec<_>>().join(", ")))
}

/// Reads the name of a model.
pub(super) fn model(said: &Said<'_>) -> Result<Model, SceneError> {
    let (name, place) = said.part("").map_or(("", said.place), |part| part.word(0));
    let model = Model::ALL.iter().copied().find(|model| model.name() == name);
    model.ok_or_else(|| {
        let all: Vec<_> = Model::ALL.iter().map(|model| model.name()).collect();
        said.error(place, format!("a model (one of {})", all.join(", ")), found(name, all))
    })
}

/// Reads the options of a model.
pub(super) fn options(said: &Said<'_>, model: &str) -> Result<Vec<ModelOption>, SceneError> {
    let own = OPTIONS.iter().find(|(name, _)| *name == model).map_or(&[] as &[Choice], |(_, own)| own);
    let mut data: &[Datum<'_>] = said.part("").map_or(&[], |part| part.data.get(1..).unwrap_or_default());
    let mut options: Vec<ModelOption> = Vec::new();
    while let Some((first, rest)) = data.split_first() {
        let known: Vec<_> = own.iter().map(|(name, _)| *name).collect();
        let Some((name, ranges)) = own.iter().find(|(name, _)| *name == first.word) else {
            let expected = match known.as_slice() {
                [] => format!("nothing more of the model {model}, which has no options"),
                _ => format!("an option of the model {model} ({})", any_of(&known)),
            };
            return Err(said.error(first.place, expected, found(first.word, known)));
        };
        if options.iter().any(|option| option.name == *name) {
            let second = Found::Told(format!("a second \"{name}\""));
            return Err(said.error(first.place, "nothing more of the model", second));
        }
        let numbers = rest.iter().take_while(|datum| datum.is_number).take(ranges.len());
        for (datum, range) in numbers.clone().zip(*ranges) {
            if !range.holds(datum.number) {
                let expected = format!("the {name} of the model {model} ({range})");
                return Err(said.error(datum.place, expected, Found::token(datum.word)));
            }
        }
        let numbers: Vec<f64> = numbers.map(|datum| datum.number).collect();
        data = rest.get(numbers.len()..).unwrap_or_default();
        options.push(ModelOption { name: (*name).into(), numbers });
    }
    Ok(options)
}
