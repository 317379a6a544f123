//! JSON, as far as the answers of the module need it.

use core::fmt::Write;

/// Returns a text as a JSON string.
pub(crate) fn text(text: &str) -> String {
    let mut json = String::with_capacity(text.len() + 2);
    json.push('"');
    for character in text.chars() {
        match character {
            '"' | '\\' => json.extend(['\\', character]),
            // Writing to a string does not fail.
            control if control < ' ' => drop(write!(json, "\\u{:04x}", u32::from(control))),
            other => json.push(other),
        }
    }
    json.push('"');
    json
}

/// Returns a number; null where it is infinite or undefined, which JSON cannot say.
pub(crate) fn number(number: f64) -> String {
    if number.is_finite() { number.to_string() } else { "null".into() }
}

/// Returns a list of values that are JSON already.
pub(crate) fn list(values: impl IntoIterator<Item = String>) -> String {
    format!("[{}]", values.into_iter().collect::<Vec<_>>().join(","))
}

/// Returns an object of names and values, which are JSON already.
pub(crate) fn object<const N: usize>(members: [(&str, String); N]) -> String {
    let members = members.map(|(name, value)| format!("{}:{value}", text(name)));
    format!("{{{}}}", members.join(","))
}

/// Returns a value that may be missing: null then.
pub(crate) fn or_null<T>(value: Option<T>, json: impl FnOnce(T) -> String) -> String {
    value.map_or_else(|| "null".into(), json)
}

#[cfg(test)]
mod tests {
    use super::{list, number, object, or_null, text};

    #[test]
    fn values_are_written_as_json_has_them() {
        assert_eq!(text("a \"b\" \\ \n\u{1} é"), r#""a \"b\" \\ \u000a\u0001 é""#);
        assert_eq!(number(0.1), "0.1");
        assert_eq!(number(1e300), format!("1{}", "0".repeat(300)));
        assert_eq!(number(f64::INFINITY), "null");
        let inner = list([number(1.0), or_null(None::<f64>, number), or_null(Some(2.5), number)]);
        assert_eq!(object([("a", inner), ("b", text(""))]), r#"{"a":[1,null,2.5],"b":""}"#);
    }
}
