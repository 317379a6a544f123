//! The language for people, from the table of statements.

use core::fmt::Write;

use super::builtin;
use super::models;
use super::statements;
use super::table::{Kind, Need, Part, Statement, Value};
use crate::numbers::Range;

const BEGINNING: &str = "\
The scene language, .rta: one thing a line.

    rta 1                                        # a first scene
    camera at 0 -8 2  look 0 1 -.1  lens 1.2
    sky horizon .8 .87 .97  zenith .15 .3 .65
    floor .9 .9 .9  .1 .1 .1
    lamp at -5 -6 8  power 75
    ambient grey .25
    sphere at 0 0 1  radius 1  color .9 .2 .1  of shiny
    sphere at 2 1 1  radius 1  of crown

A file begins with rta 1. A line that begins with white space goes on with the line before; # begins a comment. In a statement the
values without a keyword come first, then the keywords in any order, each once; what is shown further in stays behind its values. Names
are defined above their use. x is to the right, y ahead, z up; angles are degrees; light is linear. A colour is three numbers, or
grey N, srgb R G B (0 to 255), white or black.
";

/// Returns the whole language as a text for people: every statement with its keywords, values, ranges and defaults, and the materials that
/// are built in.
#[must_use]
pub fn help() -> String {
    let mut text = BEGINNING.to_owned();
    for statement in statements::all() {
        describe(statement, &mut text);
    }
    text += "\nMaterials that every scene knows\n";
    let names: Vec<_> = builtin::names().collect();
    for names in names.chunks(8) {
        let _ = writeln!(text, "    {}", names.join(", "));
    }
    text
}

fn describe(statement: &Statement, text: &mut String) {
    let once = if statement.once { ", once" } else { "" };
    // A String takes all that is written to it.
    let _ = writeln!(text, "\n{}: {}{once}", statement.keyword, statement.about);
    for part in statement.parts {
        self::part(part, 4, text);
    }
}

fn part(part: &Part, indent: usize, text: &mut String) {
    let mut words: Vec<String> = vec![part.keyword.to_owned()];
    words.extend(part.values.iter().map(shape));
    let (more, most) = part.more;
    if !more.is_empty() {
        let more: Vec<_> = more.iter().map(shape).collect();
        words.push(format!("[{}]{}", more.join(" "), if most > 1 { "..." } else { "" }));
    }
    words.retain(|word| !word.is_empty());
    let usage = words.join(" ");
    let need = match part.need {
        Need::Must => "; needed",
        Need::One(_) => "; this or another",
        Need::May | Need::AtMost(_) => "",
    };
    let ranges: Vec<_> = part.values.iter().filter_map(range).collect();
    let range = ranges.first().map_or(String::new(), |range| format!(" ({range})"));
    let default =
        if part.default.is_empty() { String::new() } else { format!("; otherwise {}", part.default) };
    let about = format!("{}{range}{need}{default}", part.about);
    let _ = writeln!(text, "{:indent$}{usage:26}  {about}", "");
    if part.values.iter().any(|Value(_, kind)| matches!(kind, Kind::Options)) {
        for line in models::lines() {
            let _ = writeln!(text, "{:indent$}    - {line}", "");
        }
    }
    for tail in part.tail {
        self::part(tail, indent + 4, text);
    }
}

/// Returns how a value is written.
fn shape(Value(what, kind): &Value) -> String {
    match kind {
        Kind::Vector(_) => "X Y Z".into(),
        Kind::Color(_) => "COLOUR".into(),
        Kind::Spectrum(_) => "N|COLOUR".into(),
        Kind::File => "\"FILE\"".into(),
        Kind::Axis => "x|y|z".into(),
        Kind::Offset => "[offset N]".into(),
        Kind::Options => "[OPTION [N]]...".into(),
        Kind::New | Kind::Name(_) => "NAME".into(),
        Kind::Number(Range::Angle | Range::Gloss) => "DEGREES".into(),
        Kind::Number(_) if what.len() < 3 => (*what).into(),
        Kind::Number(_) | Kind::Share | Kind::Whole(..) => "N".into(),
    }
}

/// Returns what a number may be, where that needs to be said.
fn range(Value(_, kind): &Value) -> Option<String> {
    match kind {
        Kind::Number(Range::Any) | Kind::Vector(Range::Any) | Kind::Color(Range::NotNegative) => None,
        Kind::Number(range) | Kind::Vector(range) | Kind::Color(range) | Kind::Spectrum(range) => Some(
            range.to_string().trim_start_matches("a number ").trim_start_matches("a number, ").to_owned(),
        ),
        Kind::Share => Some("0 to 1".into()),
        Kind::Whole(least, most) => Some(format!("{least} to {most}")),
        _ => None,
    }
}
