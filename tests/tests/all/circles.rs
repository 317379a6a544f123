//! How the source is built: no files import each other in a circle, none is long, and the crates that firmware is built from
//! know no SIMD.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

mod imports;

/// The crates' folders, from the root of the repository.
const CRATES: [&str; 10] = [
    "core",
    "drivers",
    "scenes",
    "host",
    "host/args",
    "host/golden",
    "host/packets",
    "host/paired",
    "host/web",
    "tests",
];
/// The most lines of a file.
const MAX_LINES: usize = 330;
/// The most functions of the core that are inlined wherever they are called.
const MAX_INLINED: usize = 20;
/// Names that belong to SIMD registers.
const SIMD: [&str; 8] =
    ["target_feature", "LANES", "Vec4", "BVec4", "Simd", "core::arch", "std::arch", "std::simd"];

/// A module by its path from the root of its crate.
type Module = Vec<String>;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Returns the `.rs` files below a folder, but for what is built and for packages that are no members.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let Ok(entries) = fs::read_dir(folder) else { return found };
    for entry in entries {
        let path = entry.expect("a folder can be read").path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if path.is_dir() {
            if name != "target" && !name.starts_with('.') {
                found.extend(sources(&path));
            }
        } else if name.ends_with(".rs") {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// Returns the module that a file of a `src` folder is; nothing where it is the root of a program.
fn module(source: &Path, file: &Path) -> Option<Module> {
    let below = file.strip_prefix(source).ok()?.with_extension("");
    let mut module: Module = below.iter().map(|part| part.to_string_lossy().into_owned()).collect();
    match module.first().map(String::as_str) {
        Some("bin") => return None,
        Some("main") if module.len() == 1 => return None,
        Some("lib") if module.len() == 1 => module.clear(),
        _ => {}
    }
    if module.last().is_some_and(|last| last == "mod") {
        module.pop();
    }
    Some(module)
}

/// Returns for each module of a crate those that it imports from, but for its own descendants and ancestors.
fn edges(source: &Path) -> BTreeMap<Module, BTreeSet<Module>> {
    let files: BTreeMap<Module, PathBuf> =
        sources(source).into_iter().filter_map(|file| Some((module(source, &file)?, file))).collect();
    let imported = |from: &Module, file: &PathBuf| {
        let text = fs::read_to_string(file).expect("a source file can be read");
        let paths = imports::of(&text, from);
        // The file that a path leads into: the longest module that it begins with.
        let resolved = paths.into_iter().filter_map(|path| {
            (0..=path.len())
                .rev()
                .filter_map(|end| path.get(..end))
                .find(|part| files.contains_key(*part))
                .map(<[_]>::to_vec)
        });
        resolved.filter(|to| !to.starts_with(from) && !from.starts_with(to)).collect()
    };
    files.iter().map(|(from, file)| (from.clone(), imported(from, file))).collect()
}

/// Returns the modules that lead to themselves, in groups that lead to each other.
fn circles(edges: &BTreeMap<Module, BTreeSet<Module>>) -> Vec<Vec<Module>> {
    let reached = |from: &Module| {
        let mut reached = BTreeSet::new();
        let mut next: Vec<_> = edges.get(from).into_iter().flatten().collect();
        while let Some(module) = next.pop() {
            if reached.insert(module.clone()) {
                next.extend(edges.get(module).into_iter().flatten());
            }
        }
        reached
    };
    let reached: BTreeMap<_, _> = edges.keys().map(|from| (from.clone(), reached(from))).collect();
    let mut groups = BTreeSet::new();
    for (from, to) in &reached {
        if to.contains(from) {
            let group = to.iter().filter(|to| reached.get(*to).is_some_and(|back| back.contains(from)));
            groups.insert(group.cloned().collect::<Vec<_>>());
        }
    }
    groups.into_iter().collect()
}

#[test]
fn no_files_import_each_other_in_a_circle() {
    let mut wrong = Vec::new();
    for name in CRATES {
        let edges = edges(&root().join(name).join("src"));
        assert!(!edges.is_empty(), "{name} has modules");
        for group in circles(&edges) {
            wrong.push(format!("{name}/src:"));
            for from in &group {
                let to = edges.get(from).into_iter().flatten().filter(|to| group.contains(to));
                let to: Vec<_> = to.map(|to| to.join("::")).collect();
                wrong.push(format!("    {} imports from {}", from.join("::"), to.join(", ")));
            }
        }
    }
    assert!(wrong.is_empty(), "files import each other in a circle:\n{}", wrong.join("\n"));
}

#[test]
fn circles_are_found() {
    let module = |name: &str| name.split("::").map(str::to_owned).collect::<Module>();
    let graph = |edges: &[(&str, &[&str])]| {
        edges.iter().map(|(from, to)| (module(from), to.iter().map(|to| module(to)).collect())).collect()
    };
    assert!(circles(&graph(&[("a", &["b", "c"]), ("b", &["c"]), ("c", &[])])).is_empty());
    let round = graph(&[("a", &["b"]), ("b", &["c::d"]), ("c::d", &["a"]), ("e", &["a"]), ("f", &[])]);
    assert_eq!(circles(&round), [["a", "b", "c::d"].map(module)]);
}

#[test]
fn no_file_is_long() {
    let lines = |file: PathBuf| {
        let lines = fs::read_to_string(&file).expect("a source file can be read").lines().count();
        (lines > MAX_LINES).then(|| format!("{}: {lines} lines", file.display()))
    };
    let files = ["core", "drivers", "scenes", "host", "tests"].map(|folder| sources(&root().join(folder)));
    let long: Vec<_> = files.into_iter().flatten().filter_map(lines).collect();
    assert!(long.is_empty(), "longer than {MAX_LINES} lines:\n{}", long.join("\n"));
}

#[test]
fn little_of_the_core_is_inlined_everywhere() {
    let count = |file: &PathBuf| {
        let text = fs::read_to_string(file).expect("a source file can be read");
        text.matches("inline(always)").count()
    };
    let inlined: usize = sources(&root().join("core/src")).iter().map(count).sum();
    assert!(inlined <= MAX_INLINED, "{inlined} functions of the core are inline(always)");
}

#[test]
fn what_firmware_is_built_from_knows_no_simd() {
    let mut found = Vec::new();
    for folder in ["core/src", "scenes/src"] {
        for file in sources(&root().join(folder)) {
            let text = fs::read_to_string(&file).expect("a source file can be read");
            for (number, line) in (1..).zip(text.lines()) {
                // LANES is no part of PLANES.
                let begins =
                    |at: usize| !line.get(..at).is_some_and(|before| before.ends_with(char::is_alphanumeric));
                if SIMD.iter().any(|name| line.match_indices(name).any(|(at, _)| begins(at))) {
                    found.push(format!("{}:{number}: {line}", file.display()));
                }
            }
        }
    }
    assert!(found.is_empty(), "SIMD is for host/packets:\n{}", found.join("\n"));
}
