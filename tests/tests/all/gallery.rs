//! The pictures of the documents: `rta gallery` draws each of them, and nothing else, as it lies in the repository.
//!
//! Here only those are drawn that soon are; `rta gallery --check .` compares all, and CI runs it.
//!
//! ```text
//! RTA_BLESS=1 cargo test -p rta-tests --test all gallery
//! ```
//!
//! draws all and puts them in their places, but for diagrams of what was measured.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use clap::Parser;
use rta::args::Cli;
use rta::commands::gallery::{self, check, list, page};
use rta_scenes::shipped;

use super::readme::blocks;

/// Kinds of picture files, by their extensions.
const KINDS: [&str; 4] = ["png", "gif", "jpg", "svg"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Returns the Markdown files below a folder, each as its path from the root of the repository, but for what is built.
fn documents(folder: &str) -> Vec<String> {
    let mut found = Vec::new();
    for entry in fs::read_dir(root().join(folder)).expect("a folder") {
        let entry = entry.expect("an entry");
        let name = entry.file_name().to_string_lossy().into_owned();
        let path = if folder.is_empty() { name.clone() } else { format!("{folder}/{name}") };
        if entry.path().is_dir() {
            if name != "target" && !name.starts_with('.') {
                found.extend(documents(&path));
            }
        } else if name.ends_with(".md") {
            found.push(path);
        }
    }
    found
}

/// Returns the pictures that a document shows: their files from the root of the repository, and the texts that stand for them.
fn shown(document: &str) -> Vec<(String, String)> {
    let text = fs::read_to_string(root().join(document)).expect("a text");
    assert!(!text.contains("<img"), "{document}: a picture that is shown in HTML is not found by this test");
    let folder = document.rsplit_once('/').map_or("", |(folder, _)| folder);
    let parts: Vec<_> = text.split("](").collect();
    let pairs = parts.iter().zip(parts.iter().skip(1));
    let pictures = pairs.filter_map(|(before, after)| {
        let (_, alt) = before.rsplit_once('[').filter(|(before, _)| before.ends_with('!'))?;
        let link = after.split(')').next()?;
        let is_here = KINDS.iter().any(|kind| link.ends_with(kind)) && !link.contains("://");
        let file = if folder.is_empty() { link.to_owned() } else { format!("{folder}/{link}") };
        is_here.then(|| (file, alt.to_owned()))
    });
    pictures.collect()
}

#[test]
fn the_gallery_has_what_the_documents_show() {
    let documents = documents("");
    assert!(documents.len() > 10, "{documents:?}");
    let shown: BTreeMap<_, _> = documents.iter().flat_map(|document| shown(document)).collect();
    let listed: BTreeMap<_, _> = list::all().into_iter().map(|picture| (picture.file, picture.alt)).collect();
    assert_eq!(shown, listed);
    assert_eq!(list::all().len(), listed.len(), "a picture is listed twice");
    // Nothing is kept that nobody shows, but for the pictures that scenes name.
    let named: BTreeSet<_> = shipped::PICTURES.iter().map(|(name, _)| format!("scenes/{name}")).collect();
    for folder in ["scenes", "scenes/pictures"] {
        for entry in fs::read_dir(root().join(folder)).expect("a folder") {
            let file = format!("{folder}/{}", entry.expect("an entry").file_name().to_string_lossy());
            let is_picture = KINDS.iter().any(|kind| file.ends_with(&format!(".{kind}")));
            assert!(
                !is_picture || listed.contains_key(&file) || named.contains(&file),
                "nobody shows {file}"
            );
        }
    }
}

#[test]
fn the_main_readme_has_the_commands_of_the_gallery() {
    let page = fs::read_to_string(root().join("README.md")).expect("a text");
    let commands: BTreeMap<_, _> =
        list::all().into_iter().map(|picture| (picture.file, picture.command)).collect();
    let mut told = 0;
    for line in blocks(&page, "sh").into_iter().flat_map(str::lines) {
        let output = line.split(" -o ").nth(1).and_then(|after| after.split(' ').next());
        if let Some(command) = output.and_then(|output| commands.get(output)) {
            assert_eq!(line, *command);
            told += 1;
        }
    }
    assert!(told >= 4, "{told} commands");
}

#[test]
fn the_pictures_are_those_of_the_commands() {
    let folder = tempfile::tempdir().expect("a folder");
    let is_blessed = std::env::var_os("RTA_BLESS").is_some_and(|value| !value.is_empty() && value != "0");
    let mut pictures = list::all();
    let is_soon_drawn =
        |command: &str| ["rta render ", "rta juggle "].iter().any(|one| command.starts_with(one));
    pictures.retain(|picture| !picture.is_measured() && (is_blessed || is_soon_drawn(picture.command)));
    assert!(pictures.len() > 10, "{pictures:?}");
    gallery::draw(&pictures, folder.path()).expect("pictures");
    if is_blessed {
        for picture in &pictures {
            fs::copy(folder.path().join(&picture.made), root().join(&picture.file)).expect("a copy");
        }
    }
    let told = |picture: &list::Picture| {
        check::difference(picture, folder.path(), &root()).map(|told| format!("{}: {told}", picture.file))
    };
    let differences: Vec<_> = pictures.iter().filter_map(told).collect();
    assert!(differences.is_empty(), "{differences:#?}");
}

#[test]
fn the_page_shows_every_picture_with_its_command() {
    let (folder, pictures) = (tempfile::tempdir().expect("a folder"), list::all());
    for picture in &pictures {
        let place = folder.path().join(&picture.made);
        fs::create_dir_all(place.parent().expect("a folder")).expect("it is made");
        fs::copy(root().join(&picture.file), place).expect("a copy");
    }
    let page = page::html(&pictures, folder.path()).expect("a page");
    is_sound(&page);
    let sources: Vec<_> = attributes(&page, "src").collect();
    assert_eq!(sources, pictures.iter().map(|picture| picture.made.as_str()).collect::<Vec<_>>());
    // The book of figures lies beside its pictures.
    assert_eq!(attributes(&page, "href").collect::<Vec<_>>(), ["figures/index.html"]);
    let commands = page.split("<pre><code>").skip(1).filter_map(|rest| rest.split("</code>").next());
    let commands: Vec<_> = commands.collect();
    assert_eq!(commands, pictures.iter().map(|picture| picture.command).collect::<Vec<_>>());
    for command in commands {
        if let Err(error) = Cli::try_parse_from(command.split(' ')) {
            panic!("{command}: {error}");
        }
    }
    // As a PS/2 shows it, whose pixels are higher than they are wide.
    for shape in ["width=\"320\" height=\"240\" style", "width=\"160\" height=\"120\" style"] {
        assert!(page.contains(shape), "{shape}");
    }
}

/// Returns the values of an attribute, in their order.
fn attributes<'a>(page: &'a str, name: &str) -> impl Iterator<Item = &'a str> {
    let parts: Vec<_> = page.split(&format!(" {name}=\"")).skip(1).collect();
    parts.into_iter().filter_map(|rest| rest.split('"').next())
}

/// Checks that a page begins as HTML does, that its elements are closed in the order in which they were opened, that no text has what
/// is markup, that every picture has a text for those who do not see it, and that no two elements have one name.
fn is_sound(page: &str) {
    let body = page.strip_prefix("<!DOCTYPE html>\n<html lang=\"en\">\n").expect("its type and language");
    let mut open = vec!["html"];
    for part in body.split('<').skip(1) {
        let (tag, text) = part.split_once('>').unwrap_or_else(|| panic!("a tag without an end: {part}"));
        assert!(!text.contains('>'), "{text}");
        let text = text.replace("&amp;", "").replace("&lt;", "").replace("&gt;", "").replace("&quot;", "");
        assert!(!text.contains('&'), "{text}");
        assert_eq!(tag.matches('"').count() % 2, 0, "{tag}");
        let name = tag.split(' ').next().unwrap_or_default();
        match name.strip_prefix('/') {
            Some(name) => assert_eq!(open.pop(), Some(name), "{part}"),
            None if ["meta", "img"].contains(&name) => {}
            None => open.push(name),
        }
        let has_text = attributes(tag, "alt").next().is_some_and(|alt| !alt.is_empty());
        assert!(name != "img" || has_text, "{tag}");
        assert_ne!(name, "script", "it needs a script");
    }
    assert!(open.is_empty(), "not closed: {open:?}");
    let names: Vec<_> = attributes(page, "id").collect();
    assert_eq!(names.iter().collect::<BTreeSet<_>>().len(), names.len(), "two elements of one name");
}
