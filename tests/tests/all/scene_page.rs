//! The page about the scene language: its pictures are those of its scenes, and it tells every keyword.
//!
//! ```text
//! RTA_BLESS=1 cargo test -p rta-tests --test all scene_page
//! ```
//!
//! draws the pictures anew; `rta figures` and `rta gallery` draw them too.

use core::sync::atomic::AtomicBool;
use std::fs;
use std::path::Path;

use rta::bands;
use rta::study::figures::Tracing;
use rta::study::figures::keywords::examples;
use rta_tests::golden::check_file;

const PAGE: &str = rta_scenes::shipped::PAGE;
/// What all pictures of the page may take, in bytes.
const MOST: u64 = 448 << 10;
/// What is said of a statement or a keyword that is read and does nothing.
const KEPT: &str = "not drawn yet";

#[test]
fn the_pictures_are_those_of_the_scenes() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/pictures");
    let (mut bytes, mut shown) = (0, 0);
    let pool = bands::pool(Some(1)).expect("a thread");
    let tracing = Tracing { pool: &pool, stop: &AtomicBool::new(false) };
    let examples = examples(PAGE);
    // A scene without a picture is the ground of others.
    for head in PAGE.split("\n```rta ").skip(1).filter_map(|block| block.lines().next()) {
        let name = head.split(' ').next().expect("a name");
        let is_ground = ["in", "after"].iter().any(|how| PAGE.contains(&format!(" {how} {name}\n")));
        assert!(is_ground || examples.iter().any(|example| example.name == name), "{head} is not shown");
    }
    for example in examples {
        let file = format!("{}.png", example.name);
        let picture =
            example.picture(&folder.join(".."), &tracing).unwrap_or_else(|error| panic!("{file}: {error}"));
        check_file(&folder.join(&file), "format q16, 256 colours", &picture);
        bytes += fs::metadata(folder.join(&file)).expect("it is there").len();
        shown += 1;
    }
    assert!(bytes <= MOST, "{bytes} bytes");
    assert_eq!(fs::read_dir(&folder).expect("a folder").count(), shown, "pictures that nobody shows");
}

/// A statement of `rta help scene`: its line, and that of each of its keywords.
struct Statement {
    keyword: &'static str,
    line: &'static str,
    parts: Vec<(&'static str, &'static str)>,
}

fn statements(help: &'static str) -> Vec<Statement> {
    let mut all: Vec<Statement> = Vec::new();
    let told = help.split("white or black.\n").nth(1).expect("statements");
    for line in told.split("\nMaterials that").next().expect("statements").lines() {
        let keyword = line.split_whitespace().next().unwrap_or_default();
        if !line.starts_with(' ') && !line.is_empty() {
            all.push(Statement { keyword: keyword.trim_end_matches(':'), line, parts: Vec::new() });
        } else if keyword.starts_with(|c: char| c.is_ascii_lowercase()) {
            all.last_mut().expect("a statement").parts.push((keyword, line));
        }
    }
    all
}

/// Returns the keywords that a paragraph begins to tell: the first word of what is both bold and code.
fn told(paragraph: &str) -> Vec<&str> {
    let bold = paragraph.split("**`").skip(1).filter_map(|rest| rest.split_once("`**"));
    // A keyword may be told with those that stay behind it.
    bold.flat_map(|(code, _)| code.split_whitespace())
        .filter(|word| word.starts_with(|c: char| c.is_ascii_lowercase()))
        .collect()
}

#[test]
fn every_keyword_has_its_place() {
    let help: &'static str = Box::leak(rta_scenes::rta::help().into_boxed_str());
    let statements = statements(help);
    assert!(statements.len() >= 19, "{} statements", statements.len());
    for Statement { keyword, line, parts } in &statements {
        let heading = format!("\n#### `{keyword}`\n");
        let section = PAGE.split_once(&heading).unwrap_or_else(|| panic!("no section about {keyword}")).1;
        let section = section.split("\n#### ").next().expect("text").split("\n### ").next().expect("text");
        if line.contains(KEPT) {
            assert!(is_kept(section), "{keyword} is {KEPT}, which the page does not say");
        }
        let paragraphs: Vec<_> = section.split("\n\n").collect();
        for (part, about) in parts {
            let place = paragraphs.iter().find(|paragraph| told(paragraph).contains(part));
            let place = place.unwrap_or_else(|| panic!("the page does not tell {part} of {keyword}"));
            if about.contains(KEPT) {
                assert!(is_kept(place), "{part} of {keyword} is {KEPT}, which the page does not say");
            }
        }
        let any = parts.iter().any(|(_, about)| about.contains(KEPT)) || line.contains(KEPT);
        assert!(any || !is_kept(section) || *keyword == "material", "all of {keyword} is drawn");
    }
}

/// Returns whether a text says of something that it is not drawn yet, wherever its lines end.
fn is_kept(text: &str) -> bool {
    text.split_whitespace().collect::<Vec<_>>().join(" ").contains(KEPT)
}

#[test]
fn every_material_is_told() {
    let help = rta_scenes::rta::help();
    let names = help.split_once("Materials that every scene knows\n").expect("names").1;
    let page = PAGE.split_once("### Materials that every scene knows").expect("a section").1;
    let page = page.split("\n## ").next().expect("text");
    for name in names.split([',', '\n']).map(str::trim).filter(|name| !name.is_empty()) {
        assert!(page.contains(&format!("`{name}`")), "{name}");
    }
}
