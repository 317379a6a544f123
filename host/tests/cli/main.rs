//! The program from outside, and the picture of its window: what is refused and how, and what comes out.
//!
//! It is one program, since linking takes longer than most of these tests.
#![allow(clippy::indexing_slicing, reason = "a test may panic")]

use std::process::Output;

mod bench;
mod cones;
mod figures;
mod film;
mod firmware;
mod folder;
mod gallery;
mod language;
mod light_report;
#[cfg(all(unix, feature = "image"))] // what the system says, and the names of all picture files
mod mistakes;
mod nff;
mod outputs;
mod palette;
mod parts;
mod pictures;
mod pipes;
mod radiosity;
mod refused;
mod report;
mod show;
mod spread_report;
mod spreading;
mod textures;
mod tolerance;
mod until;
mod visibility;
mod window;

use folder::Folder;
use rta::engine::Model;

#[test]
fn help_and_version_go_to_standard_output() {
    let folder = Folder::new();
    for (args, word) in
        [(&["--help"][..], "Examples"), (&["render", "--help"], "--aspect"), (&["--version"], "rta 0")]
    {
        let Output { status, stdout, stderr } = folder.rta(args);
        assert!(status.success() && stderr.is_empty());
        assert!(String::from_utf8(stdout).unwrap().contains(word), "{args:?}");
    }
    folder.refuses(&["paint"], &["paint"]);
    folder.refuses(&["render"], &["SCENE"]);
}

#[test]
fn every_model_of_the_list_is_in_the_help_and_can_be_drawn_and_baked() {
    let folder = Folder::new();
    let help = folder.prints(&["render", "--help"]);
    for model in Model::ALL {
        let name = model.to_string();
        assert!(help.contains(&format!("- {name}:")), "{name} in {help}");
        let hash = folder.prints(&["hash", "scene.dat", "--size", "32x20", "--model", &name]);
        assert!(hash.contains(&format!("model {name},")), "{hash}");
        let source = folder.prints(&["bake", "scene.dat", "-o", "-", "--model", &name]);
        assert!(source.contains("pub const SCENE: "), "{name}");
    }
}
