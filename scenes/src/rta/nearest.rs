//! Words in errors: lists of them, and the known one that is nearest to what stands there.

use crate::error::Found;

/// Returns what stands there, in quotes, with the nearest of the known words if one is near.
pub(super) fn found(word: &str, known: impl IntoIterator<Item = impl AsRef<str>>) -> Found {
    let shown = Found::show(word);
    let near = (word.chars().count() / 2).max(1);
    let away = |other: &str| strsim::damerau_levenshtein(word, other);
    let known = known.into_iter().map(|other| (away(other.as_ref()), other));
    // Long words cannot be near, and would take long to be compared.
    let nearest = if word.len() > 64 { None } else { known.min_by_key(|(away, _)| *away) };
    match nearest.filter(|(away, _)| *away <= near) {
        Some((_, other)) => Found::Told(format!("\"{shown}\" (did you mean \"{}\"?)", other.as_ref())),
        None => Found::word(word),
    }
}

/// Returns words in quotes, with "or" before the last: `"at", "look" or "to"`.
pub(super) fn any_of(words: &[&str]) -> String {
    let quoted: Vec<String> = words.iter().map(|word| format!("\"{word}\"")).collect();
    match quoted.as_slice() {
        [others @ .., last] if !others.is_empty() => format!("{} or {last}", others.join(", ")),
        _ => quoted.concat(),
    }
}
