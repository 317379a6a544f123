//! Pages in HTML that need nothing but themselves and the pictures beside them.

const HEAD: &str = "\
<!DOCTYPE html>
<html lang=\"en\">
<head>
<meta charset=\"utf-8\">
<meta name=\"viewport\" content=\"width=device-width\">
";

const STYLE: &str = "\
<style>
body { max-width: 60em; margin: 2em auto; padding: 0 1em; font: 17px/1.5 serif; }
figure { margin: 3em 0; }
img { max-width: 100%; height: auto; }
pre { overflow-x: auto; font-size: 75%; }
code { white-space: pre-wrap; }
.formula { font-style: italic; }
th, td { padding-right: .8em; text-align: left; vertical-align: top; }
.source { font-size: 85%; color: #444; }
</style>
</head>
";

/// Returns a page with this title and body.
#[must_use]
pub fn page(title: &str, body: &str) -> String {
    let title = escaped(title);
    format!("{HEAD}<title>{title}</title>\n{STYLE}<body>\n<h1>{title}</h1>\n{body}</body>\n</html>\n")
}

/// Returns a text with what HTML takes for markup written as entities.
#[must_use]
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
