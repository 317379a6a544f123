//! What the READMEs say holds: their figures are those that were measured, their commands are the program's, and their code
//! is shown whole. That the code compiles and runs is tested with the examples of the documentation (`cargo test --doc`).

use clap::Parser;
use rta::args::Cli;
use rta_core::needs::Used;

const MAIN: &str = include_str!("../../../README.md");
const CORE: &str = include_str!("../../../core/README.md");
const PAGES: [(&str, &str); 10] = [
    ("README.md", MAIN),
    ("core/README.md", CORE),
    ("drivers/README.md", include_str!("../../../drivers/README.md")),
    ("scenes/README.md", include_str!("../../../scenes/README.md")),
    ("host/README.md", include_str!("../../../host/README.md")),
    ("host/args/README.md", include_str!("../../../host/args/README.md")),
    ("host/golden/README.md", include_str!("../../../host/golden/README.md")),
    ("host/packets/README.md", include_str!("../../../host/packets/README.md")),
    ("host/paired/README.md", include_str!("../../../host/paired/README.md")),
    ("tests/README.md", include_str!("../../README.md")),
];

/// Returns the text of the blocks whose language begins with `language`.
pub(super) fn blocks<'a>(page: &'a str, language: &str) -> Vec<&'a str> {
    let inside = page.split("```").skip(1).step_by(2);
    inside.filter_map(|block| block.strip_prefix(language)?.split_once('\n').map(|(_, text)| text)).collect()
}

/// Returns a page as one line, wherever its lines end.
fn one_line(page: &str) -> String {
    page.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// An image of the table of footprints: its name, scene, format and needs, and the bytes of code, constants, RAM and stack.
struct Footprint {
    image: [&'static str; 4],
    bytes: [u32; 4],
}

fn footprints() -> Vec<Footprint> {
    let table = include_str!("../../boards/FOOTPRINT.md").lines().filter(|line| line.starts_with("| "));
    let images = table.skip(2).map(|line| {
        let cells: Vec<_> = line.trim_matches('|').split('|').map(str::trim).collect();
        let [image @ .., text, rodata, ram, stack, _, _] = cells.as_slice() else { panic!("{line}") };
        Footprint {
            image: image.try_into().expect("four words"),
            bytes: [text, rodata, ram, stack].map(|cell| cell.parse().expect("bytes")),
        }
    });
    images.collect()
}

#[test]
fn the_figures_are_those_of_the_boards() {
    let images = footprints();
    let juggler = ["microbit", "juggler", "q16", "baked"];
    let [text, rodata, _, stack] = images.iter().find(|image| image.image == juggler).expect("a row").bytes;
    let most = |needs: [&str; 2]| {
        let of_kind = |image: &&Footprint| needs.contains(&image.image[3]);
        images.iter().filter(of_kind).map(|image| image.bytes[3]).max().expect("rows")
    };
    // Palette and Z-buffer are on the stack.
    let (plain, palette, buffer) =
        (most(["baked", "Everything"]), most(["sampled", "dithered"]), most(["Z-buffer"; 2]));
    assert!(images.len() > 60, "{} rows", images.len());
    let page = one_line(MAIN);
    for said in [
        format!("the Juggler takes {text} bytes of code, {rodata} of constants and {stack} of stack"),
        format!("no image there takes more than {plain} bytes of stack at depth 5"),
        format!("the Z-buffer of a row makes it {buffer}"),
        format!("A palette made on the board from 1024 samples takes up to {palette} bytes of stack"),
    ] {
        assert!(page.contains(&said), "the README does not say: {said}");
    }
    assert!(images.iter().all(|image| image.bytes[2] == 0), "there is static RAM");
}

#[test]
fn the_constants_of_needs_are_counted() {
    let said = format!("{} constants in all", Used::default().named().len());
    assert!(one_line(CORE).contains(&said), "{said}");
}

#[test]
fn code_is_shown_whole() {
    let mut shown = 0;
    for (name, page) in PAGES {
        for block in blocks(page, "rust") {
            let hidden = block.lines().find(|line| line.trim() == "#" || line.trim().starts_with("# "));
            assert_eq!(hidden, None, "{name}");
            shown += 1;
        }
    }
    assert!(shown >= 6, "{shown} blocks");
}

#[test]
fn commands_are_those_of_the_program() {
    let mut tried = 0;
    for (name, page) in PAGES {
        let lines = blocks(page, "sh").into_iter().flat_map(str::lines);
        for line in lines.filter(|line| line.starts_with("rta ")) {
            let words = line.split(" #").next().unwrap_or_default().split_whitespace();
            if let Err(error) = Cli::try_parse_from(words) {
                panic!("{name}: {line}: {error}");
            }
            tried += 1;
        }
    }
    assert!(tried >= 10, "{tried} commands");
}

/// A registry shows the README of a package without the files beside it, and the text that describes a picture in place of the picture.
#[test]
fn what_a_registry_shows_has_no_links_into_the_repository() {
    for (name, page) in PAGES.into_iter().filter(|(name, _)| !["README.md", "tests/README.md"].contains(name))
    {
        let parts: Vec<_> = page.split("](").collect();
        for pair in parts.windows(2) {
            let [before, after] = pair else { continue };
            let link = after.split(')').next().unwrap_or_default();
            let text = before.rsplit('[').next().unwrap_or_default();
            if before.ends_with(&format!("![{text}")) && !text.is_empty() && link.starts_with("pictures/") {
                continue;
            }
            assert!(link.starts_with("https://") || link.starts_with('#'), "{name}: {link}");
        }
    }
}
