//! The page of the thesis, in HTML.

use core::fmt::Write;

use super::appendix::{FORMATS, MACHINES, REPORTED, Run};
use super::counted::{self, Counted, PROCESSORS};
use super::drawn::{Cost, Drawn, REFERENCE};
use super::technique::{Against, Technique, Way};
use super::{Content, FOLDER, Thousands};
use crate::study::html::{self, escaped};

const INTRODUCTION: &str = "\
<p>A thesis in mathematics at the Universidad Nacional Autónoma de México, of the early 1990s, on models of illumination for image
synthesis, ends in a ray tracer, which this program founds again. Here two of its tables are run again: the techniques of
<a href=\"#techniques\">table 3.1</a>, each as a picture of one room, and the times of its <a href=\"#appendix\">appendix</a>, beside
those of today. Its figures are on <a href=\"index.html\">the first page</a>.</p>
";

const TECHNIQUES: &str = "\
<h2 id=\"techniques\">Table 3.1: techniques, 1969 to 1988</h2>
<p>The thesis's table is known to us by three of its rows alone, those with a misprint; they are marked. The other rows are the techniques
that its chapters 1 to 3 review. Each draws the same room: diffuse walls, a flat lamp under the ceiling, a metal ball on a box, a
glazed ball, a ball of green glass.</p>
<p>The <b>error</b> is the root of the mean square of the differences of linear light, cut to 0 to 1, over all pixels and registers, from
<a href=\"#paths\">paths of light</a>, which have all that surfaces send each other. An old technique is not wrong because its error is
large: it leaves out what it never set out to find, and in its place has an ambient term that somebody chose (0.3 here). The
<b>cost</b> is counted: rays of all kinds, for radiosity those of solving before (+), and for algorithms without rays the steps of
<code>rta visibility</code>. It is the same in every run. <b>Seconds</b> are of this machine, one thread. All traced pictures but those whose
words say otherwise have 16 samples a pixel and the lamp as one place in its middle, so that neither stairs nor noise are counted as
light.</p>
";

const APPENDIX: &str = "\
<h2 id=\"appendix\">The appendix: machines, compositions, times</h2>
<p>What the thesis says of its machines' displays and of its times, as it is known to us. Processors and clocks are from their makers'
descriptions, not from the thesis.</p>
";

const OURS: &str = "\
<p>The compositions' scene files are not known to us. Ours have as many objects of such kinds and are none of the thesis's:
<code>glass-2.dat</code> and <code>hall-22.dat</code> come with the program, are drawn with the thesis's model at depth 5, and are shown
through its three displays with their own colours. So the times beside each other are of like work, not of the same work.</p>
";

const INSTRUCTIONS: &str = "\
<h3>On the machines' kin, emulated</h3>
<p>The same program without an operating system, on two machines under QEMU, which draw on their own displays (<code>tests/boards</code>).
Instructions were counted there, by the machines' own timers, and are recorded in the program: this page does not run the emulators. Instructions
are not cycles: the emulator has neither pipeline nor caches. The i486 works <code>f32</code> out by integers, as one without a coprocessor;
the SPARC has one, which makes <code>f32</code> the row that is like the thesis's. The estimates take a mean number of cycles for each instruction:</p>
";

/// Returns the page.
pub(super) fn html(content: &Content) -> String {
    let mut page = INTRODUCTION.to_owned() + TECHNIQUES;
    table(&mut page, content);
    let whole = content.references.whole();
    for (technique, drawn) in &content.rows {
        row(&mut page, technique, drawn.as_ref());
    }
    let noise = whole.error.unwrap_or(0.0);
    let words = format!(
        "Two pictures of paths by other seeds than those above, and their mean. The difference of the two tells that the mean itself is off by \
         about {noise:.4}: what is nearer to it than that cannot be told from it."
    );
    let caption = format!("<p>{words}</p>\n{}", commands(whole));
    figure(&mut page, REFERENCE, "The reference: paths of light", whole, &caption);
    page += APPENDIX;
    machines(&mut page);
    times(&mut page, content);
    instructions(&mut page);
    compositions(&mut page, content);
    html::page("The thesis, run again", &page)
}

/// Writes to a string, which does not fail.
macro_rules! put {
    ($page:expr, $($words:tt)*) => { let _ = write!($page, $($words)*); };
}

/// Returns the words of what a picture takes.
fn cost(cost: &Cost) -> String {
    let unit = if cost.is_steps { "steps" } else { "rays" };
    let solving = if cost.solving == 0 { String::new() } else { format!(" + {}", Thousands(cost.solving)) };
    format!("{}{solving} {unit}", Thousands(cost.rays))
}

fn seconds(seconds: f64) -> String {
    format!("<span class=\"seconds\">{seconds:.2}</span>")
}

fn error(drawn: &Drawn) -> String {
    drawn.error.map_or_else(|| "not told".to_owned(), |error| format!("{error:.4}"))
}

fn table(page: &mut String, content: &Content) {
    *page += "<table>\n<tr><th>year</th><th>technique</th><th>by</th><th>error</th><th>cost</th><th>seconds</th></tr>\n";
    for (technique, drawn) in &content.rows {
        let Technique { name, year, title, .. } = technique;
        let [title, authors] = [*title, technique.authors()].map(escaped);
        put!(page, "<tr><td>{year}</td><td><a href=\"#{name}\">{title}</a></td><td>{authors}</td>");
        match drawn {
            Some(drawn) => {
                put!(page, "<td>{}</td><td>{}</td>", error(drawn), cost(&drawn.cost));
                put!(page, "<td>{}</td></tr>\n", seconds(drawn.cost.seconds));
            }
            None => *page += "<td colspan=\"3\">not drawn</td></tr>\n",
        }
    }
    *page += "</table>\n";
}

fn commands(drawn: &Drawn) -> String {
    let commands: Vec<_> = drawn.commands.iter().map(|command| escaped(command)).collect();
    format!("<pre><code>{}</code></pre>\n", commands.join("\n"))
}

fn figure(page: &mut String, name: &str, title: &str, drawn: &Drawn, caption: &str) {
    let title = escaped(title);
    // Each pixel is seen, twice as large.
    let (width, height) =
        (2 * drawn.size.width(), (f64::from(2 * drawn.size.width()) / drawn.aspect).round());
    put!(
        page,
        "<figure id=\"{name}\">\n<h3>{title}</h3>\n<img src=\"{FOLDER}/{name}.png\" alt=\"{title}\" width=\"{width}\" height=\"{height}\" \
         style=\"image-rendering: pixelated\">\n<figcaption>\n{caption}</figcaption>\n</figure>\n"
    );
}

fn row(page: &mut String, technique: &Technique, drawn: Option<&Drawn>) {
    let Technique { name, year, title, paper, words, printed, way } = technique;
    let title = format!("{year}: {title}");
    let mut caption = format!("<p>{}</p>\n", escaped(words));
    if let Some(printed) = printed {
        put!(caption, "<p>In the thesis's table, which prints {}.</p>\n", escaped(printed));
    }
    let source = format!("<p class=\"source\">{}, {year}.</p>\n", escaped(paper));
    match (way, drawn) {
        (Way::Absent(why), _) => {
            put!(
                page,
                "<section id=\"{name}\">\n<h3>{}</h3>\n{caption}<p><b>{}</b></p>\n{source}</section>\n",
                escaped(&title),
                escaped(why)
            );
        }
        (_, Some(drawn)) => {
            let against = match way {
                Way::Traced { against: Against::OwnPaths, .. } => " from paths of its own",
                _ => "",
            };
            put!(
                caption,
                "<p>Error {}{against}; {}; {} s.</p>\n{}{source}",
                error(drawn),
                cost(&drawn.cost),
                seconds(drawn.cost.seconds),
                commands(drawn)
            );
            figure(page, name, &title, drawn, &caption);
        }
        (_, None) => {}
    }
}

fn machines(page: &mut String) {
    *page += "<table>\n<tr><th>machine</th><th>display</th><th>processor</th><th>here</th></tr>\n";
    for machine in MACHINES {
        let cells = [machine.name, machine.display, machine.processor, machine.here].map(escaped);
        put!(page, "<tr><td>{}</td></tr>\n", cells.join("</td><td>"));
    }
    *page += "</table>\n";
    *page += OURS;
}

fn times(page: &mut String, content: &Content) {
    let run = |name: &str| content.compositions.iter().find(|(own, _)| own.name == name);
    let [first, second] = FORMATS;
    put!(
        page,
        "<table>\n<tr><th>machine</th><th>picture</th><th>the thesis</th><th>ours</th><th>rays</th><th>this host, {first}, s</th><th>{second}, \
         s</th></tr>\n"
    );
    for reported in REPORTED {
        let cells = [reported.machine, reported.picture, reported.time].map(escaped);
        put!(page, "<tr><td>{}</td>", cells.join("</td><td>"));
        match reported.ours.and_then(run) {
            Some((composition, Run { rays, seconds: [f32, q16], .. })) => {
                put!(
                    page,
                    "<td><a href=\"#{}\">{}</a></td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                    composition.name,
                    escaped(composition.file),
                    Thousands(*rays),
                    seconds(*f32),
                    seconds(*q16)
                );
            }
            None => *page += "<td colspan=\"4\">nothing to compare</td></tr>\n",
        }
    }
    *page += "</table>\n";
}

/// Writes what emulated machines count, and what that would have taken.
fn instructions(page: &mut String) {
    *page += INSTRUCTIONS;
    *page += "<ul>\n";
    for processor in PROCESSORS {
        put!(page, "<li>{}.</li>\n", escaped(processor.words));
    }
    *page += "</ul>\n<table>\n<tr><th>machine</th><th>picture</th><th>format</th><th>instructions</th><th>a pixel</th><th>estimate</th></tr>\n";
    for Counted { board, scene, format, size: (width, height), instructions } in counted::ALL {
        let Some(processor) = PROCESSORS.iter().find(|processor| processor.board == *board) else { continue };
        put!(
            page,
            "<tr><td>{}</td><td>{scene}, {width} x {height}</td><td>{format}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
            processor.name,
            Thousands(*instructions),
            Thousands(instructions / (u64::from(*width) * u64::from(*height))),
            duration(processor.seconds(*instructions))
        );
    }
    *page += "</table>\n";
}

/// Returns a time in words, to two or three digits.
fn duration(seconds: f64) -> String {
    if seconds < 100.0 { format!("{seconds:.0} s") } else { format!("{:.1} min", seconds / 60.0) }
}

fn compositions(page: &mut String, content: &Content) {
    for (composition, Run { shown, .. }) in &content.compositions {
        let title = format!("{} on the display of the {}", composition.file, composition.machine);
        let (width, height) = (shown.size.width(), (f64::from(shown.size.width()) / shown.aspect).round());
        put!(
            page,
            "<figure id=\"{name}\">\n<h3>{title}</h3>\n<img src=\"{FOLDER}/{name}.png\" alt=\"{what}\" width=\"{width}\" height=\"{height}\" \
             style=\"aspect-ratio: {width} / {height}\">\n<figcaption>\n<p>{what}; {size} pixels.</p>\n</figcaption>\n</figure>\n",
            name = composition.name,
            title = escaped(&title),
            what = escaped(composition.what),
            size = shown.size,
        );
    }
}
