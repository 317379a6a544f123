//! The notation of stated values: `name(arguments) = number` anywhere in a text.

/// A value that a text states.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// Line of the text, from 1.
    pub line: usize,
    /// Name of the function, in lower case.
    pub name: String,
    /// The arguments as they are written.
    pub arguments: String,
    /// The arguments.
    pub numbers: Vec<f64>,
    /// The value of the function.
    pub value: f64,
}

/// Returns all values that a text states. A name begins with a letter, is in lower case and has no letter, digit or underscore
/// before it; all arguments are numbers. Everything else is passed over.
#[must_use]
pub fn statements(text: &str) -> Vec<Statement> {
    let mut all = Vec::new();
    for (open, _) in text.match_indices('(') {
        let (before, after) = (text.get(..open).unwrap_or(""), text.get(open + 1..).unwrap_or(""));
        let name = before.rsplit(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or("");
        let is_name = name.starts_with(|c: char| c.is_ascii_lowercase())
            && name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_');
        let Some((arguments, rest)) = after.split_once(')').filter(|_| is_name) else { continue };
        let numbers: Option<Vec<f64>> = arguments.split(',').map(|part| number(part.trim())).collect();
        let value = rest.trim_start().strip_prefix('=').and_then(leading_number);
        if let (Some(numbers), Some(value)) = (numbers, value) {
            let line = 1 + before.matches('\n').count();
            let arguments = arguments.split(',').map(str::trim).collect::<Vec<_>>().join(",");
            all.push(Statement { line, name: name.to_owned(), arguments, numbers, value });
        }
    }
    all
}

/// Returns a finite number that begins with a digit, a sign or a point: no `inf`, no `nan`.
fn number(text: &str) -> Option<f64> {
    let is_number = text.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c));
    text.parse().ok().filter(|number: &f64| is_number && number.is_finite())
}

/// Returns the longest number that a text begins with, after white space. A point that ends a sentence is no part of it, but
/// changes nothing.
fn leading_number(text: &str) -> Option<f64> {
    let text = text.trim_start();
    let end = text.find(|c: char| !c.is_ascii_digit() && !"+-.eE".contains(c)).unwrap_or(text.len());
    // A digit or letter that follows makes it something else.
    if text.get(end..).is_some_and(|rest| rest.starts_with(|c: char| c.is_alphanumeric() || c == '_')) {
        return None;
    }
    (1..=end).rev().find_map(|end| number(text.get(..end)?))
}

#[cfg(test)]
mod tests {
    use super::statements;

    #[test]
    fn values_are_found_in_prose() {
        let text = "> d_gauss(c,a): d_gauss(4, 10) = 0.614228745; F(0) = 1, g( -.5,1e2 )=\n -2.5e-7.\n\
            exp(-s d) = 3, 2f(1) = 5 and f(1) = x; h(inf) = 1, h(2) = 3.";
        let all = statements(text);
        let found: Vec<_> =
            all.iter().map(|s| (s.line, s.name.as_str(), s.numbers.as_slice(), s.value)).collect();
        let want: [(_, _, &[f64], _); 3] = [
            (1, "d_gauss", &[4.0, 10.0], 0.614_228_745),
            (1, "g", &[-0.5, 100.0], -2.5e-7),
            (3, "h", &[2.0], 3.0),
        ];
        assert_eq!(found, want);
        assert_eq!(all.first().expect("three").arguments, "4,10");
    }
}
