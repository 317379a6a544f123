//! The page of all figures, in HTML.

use core::fmt::Write;

use super::Figure;
use super::keywords::Example;

const HEAD: &str = "\
<!DOCTYPE html>
<html lang=\"en\">
<head>
<meta charset=\"utf-8\">
<meta name=\"viewport\" content=\"width=device-width\">
<title>The book of figures</title>
<style>
body { max-width: 60em; margin: 2em auto; padding: 0 1em; font: 17px/1.5 serif; }
figure { margin: 3em 0; }
img { max-width: 100%; height: auto; }
pre { overflow-x: auto; font-size: 75%; }
.formula { font-style: italic; }
.source { font-size: 85%; color: #444; }
</style>
</head>
<body>
<h1>The book of figures</h1>
<p>The curves are those of the functions that pictures are made with, in double precision; the pictures are traced.</p>
";

/// Returns the page.
pub(super) fn html(figures: &[Figure], examples: &[Example]) -> String {
    let mut page = HEAD.to_owned();
    for figure in figures {
        let Figure { name, place, title, caption, formula, source, .. } = figure;
        let [place, title, caption, formula, source] =
            [place, title, caption, formula, source].map(|text| escaped(text));
        let (shown, files) = if figure.is_diagram() {
            ("svg", format!("<a href=\"{name}.svg\">SVG</a>, <a href=\"{name}.png\">PNG</a>"))
        } else {
            ("png", format!("<a href=\"{name}.png\">PNG</a>"))
        };
        // Writing to a string does not fail.
        let _ = write!(
            page,
            "<figure id=\"{name}\">\n<h2>{place}: {title}</h2>\n<img src=\"{name}.{shown}\" alt=\"{title}\">\n<figcaption>\n\
             <p>{caption}</p>\n<p class=\"formula\">{formula}</p>\n<p class=\"source\">{source} {files}</p>\n\
             </figcaption>\n</figure>\n"
        );
    }
    page += "<h2>The words of the scene language</h2>\n<p>Each scene needs nothing but its lines.</p>\n";
    for Example { name, text } in examples {
        let text = escaped(text);
        let _ = write!(
            page,
            "<figure id=\"keyword-{name}\">\n<img src=\"keywords/{name}.png\" alt=\"{name}\">\n<figcaption>\n<pre>{text}</pre>\n\
             </figcaption>\n</figure>\n"
        );
    }
    page + "</body>\n</html>\n"
}

/// Returns a text with what HTML takes for markup written as entities.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
