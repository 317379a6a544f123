//! The page of all figures, in HTML.

use core::fmt::Write;

use super::Figure;
use super::keywords::Example;
use crate::study::html::{self, escaped};

const INTRODUCTION: &str = "\
<p>The curves are those of the functions that pictures are made with, in double precision; the pictures are traced. On
<a href=\"thesis.html\">a second page</a> the thesis's techniques and times are run again.</p>
";

/// Returns the page.
pub(super) fn html(figures: &[Figure], examples: &[Example]) -> String {
    let mut page = INTRODUCTION.to_owned();
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
    for Example { name, alt, text } in examples {
        let [alt, text] = [alt, text].map(|text| escaped(text));
        let _ = write!(
            page,
            "<figure id=\"keyword-{name}\">\n<img src=\"keywords/{name}.png\" alt=\"{alt}\">\n<figcaption>\n<pre>{text}</pre>\n\
             </figcaption>\n</figure>\n"
        );
    }
    html::page("The book of figures", &page)
}
