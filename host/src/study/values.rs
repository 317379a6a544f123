//! `rta values`: what the functions of the illumination models return, beside the values that a text states.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use rta_scenes::in_format;
use rta_scenes::narrow::Narrow;

use super::error::StudyError;
use crate::args::ValuesArgs;
use crate::engine::Format;
use crate::picture::output::{Inputs, print};

mod albedo;
mod frame;
mod functions;
mod mesh;
mod notation;
mod radiosity;
mod spectrum;
mod spreading;
mod texture;

pub use functions::Function;
pub use notation::{Statement, statements};

/// The longest text that is read, in bytes.
const LIMIT: u64 = 64 << 20;

/// A stated value beside the one that is computed.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// What the text states.
    pub stated: Statement,
    /// What the program computes.
    pub computed: f64,
    /// Whether they agree.
    pub agrees: bool,
}

impl Comparison {
    /// Returns the error of what is computed, as a part of what is stated, or in itself where 0 is stated.
    #[must_use]
    pub fn error(&self) -> f64 {
        let difference = (self.computed - self.stated.value).abs();
        if self.stated.value == 0.0 { difference } else { difference / self.stated.value.abs() }
    }
}

/// Returns all functions, as they are computed in the format `S`.
fn all<S: Narrow>() -> Vec<Function> {
    [functions::all::<S>(), texture::all::<S>(), mesh::all::<S>(), spreading::all::<S>(), radiosity::all()]
        .concat()
}

/// Returns the names of all functions.
#[must_use]
pub fn names() -> Vec<&'static str> {
    all::<f64>().iter().map(|function| function.name).collect()
}

/// Returns what a function that is known by this name returns in f64 for as many numbers as it has arguments; no number for a name
/// that is not known.
pub(super) fn value(name: &str) -> impl Fn(&[f64]) -> f64 {
    let known = all::<f64>().into_iter().find(|function| function.name == name);
    move |numbers| known.map_or(f64::NAN, |function| (function.compute)(numbers))
}

/// Compares all values that a text states with what the program computes in a number format. They agree where they differ by at
/// most `tolerance` times the value, or by 1e-9 in f64, 1e-6 in f32, 2^-16 in fixed point. Without a tolerance it is 1e-6 in
/// f64, 1e-5 in f32 and the function's own in fixed point.
///
/// # Errors
/// [`StudyError::Function`] for a name that is not known, and [`StudyError::Arguments`] for too few or too many of them.
pub fn compare(text: &str, format: Format, tolerance: Option<f64>) -> Result<Vec<Comparison>, StudyError> {
    let known = in_format!(format, S => all::<S>());
    let statements = statements(text).into_iter();
    // All names are looked up before anything is computed.
    let found = statements.map(|stated| function(&known, &stated).map(|function| (stated, function)));
    let found = found.collect::<Result<Vec<_>, _>>()?;
    let comparisons = found.into_iter().map(|(stated, function)| {
        let (relative, absolute) = match format {
            Format::F64 => (1e-6, 1e-9),
            Format::F32 => (1e-5, 1e-6),
            Format::Q16 | Format::Q20 => (function.fixed, 1.0 / 65_536.0),
        };
        let sensitive = if format == Format::F32 { function.single(&stated.numbers) } else { 0.0 };
        let relative = tolerance.unwrap_or(relative).max(function.always).max(sensitive);
        let computed = (function.compute)(&stated.numbers);
        let difference = (computed - stated.value).abs();
        let agrees = difference <= absolute || difference <= relative * stated.value.abs();
        Comparison { stated, computed, agrees }
    });
    Ok(comparisons.collect())
}

fn function(known: &[Function], stated: &Statement) -> Result<Function, StudyError> {
    let (line, name) = (stated.line, stated.name.clone());
    let Some(function) = known.iter().find(|function| function.name == name) else {
        let names = known.iter().map(|function| function.name).collect::<Vec<_>>().join(", ");
        return Err(StudyError::Function { line, name, names });
    };
    if function.arguments.len() == stated.numbers.len() {
        Ok(*function)
    } else {
        Err(StudyError::Arguments {
            line,
            name,
            arguments: function.arguments.join(","),
            found: stated.numbers.len(),
        })
    }
}

/// Returns the comparisons as a table, and their number.
fn table(comparisons: &[Comparison], format: Format) -> String {
    let name = |c: &Comparison| format!("{}({})", c.stated.name, c.stated.arguments);
    let width = comparisons.iter().map(|c| name(c).len()).max().unwrap_or(0);
    let mut text = String::new();
    for comparison in comparisons {
        let verdict = if comparison.agrees { "ok" } else { "OFF" };
        let (computed, stated) = (nine_digits(comparison.computed), nine_digits(comparison.stated.value));
        text += &format!(
            "{:width$}  {computed:>15}  {stated:>15}  {:8.1e}  {verdict}\n",
            name(comparison),
            comparison.error()
        );
    }
    let off = comparisons.iter().filter(|c| !c.agrees).count();
    text + &format!("{} values in {format}: {} ok, {off} OFF\n", comparisons.len(), comparisons.len() - off)
}

/// Formats a number with nine digits.
fn nine_digits(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    if !(1e-4..1e9).contains(&value.abs()) {
        return format!("{value:.8e}");
    }
    let decimals = (0..13_u8).find(|&n| value.abs() * 10f64.powi(i32::from(n)) >= 1e8).unwrap_or(12);
    format!("{value:.*}", usize::from(decimals))
}

/// Runs `rta values`: prints each stated value beside the one that is computed.
///
/// # Errors
/// [`StudyError::Text`] for a text that cannot be read, those of [`compare`] and of writing to standard output, and
/// [`StudyError::Off`] where a value is off.
pub fn run(args: &ValuesArgs) -> Result<(), StudyError> {
    let (text, inputs) = read(&args.text)?;
    let comparisons = compare(&text, args.format, args.tolerance)?;
    print(&table(&comparisons, args.format), &inputs)?;
    if comparisons.iter().all(|comparison| comparison.agrees) { Ok(()) } else { Err(StudyError::Off) }
}

/// Reads a text, or standard input if its name is `-`.
fn read(path: &Path) -> Result<(String, Inputs), StudyError> {
    let (name, bytes, inputs) = if path == Path::new("-") {
        ("standard input".to_owned(), read_from(io::stdin().lock()), Inputs::stdin())
    } else {
        let file = File::open(path);
        let inputs = file.as_ref().map_or_else(|_| Inputs::default(), Inputs::file);
        (path.display().to_string(), file.and_then(read_from), inputs)
    };
    let bytes = bytes.map_err(|source| StudyError::Text { name, source })?;
    Ok((String::from_utf8_lossy(&bytes).into_owned(), inputs))
}

fn read_from(file: impl Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    file.take(LIMIT + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > LIMIT { Err(io::Error::other("larger than 64 MiB")) } else { Ok(bytes) }
}
