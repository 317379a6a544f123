//! Hands the linker the script of the way to boot, and bakes the scenes of the DOS program.

use std::env;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = env::var("CARGO_MANIFEST_DIR")?;
    let script = match (env::var_os("CARGO_FEATURE_DOS"), env::var_os("CARGO_FEATURE_FLOPPY")) {
        (Some(_), _) => "dos.ld",
        (None, Some(_)) => "floppy.ld",
        (None, None) => "multiboot.ld",
    };
    println!("cargo:rustc-link-arg=-T{folder}/{script}");
    println!("cargo:rerun-if-changed={script}");
    #[cfg(feature = "dos")]
    scenes::bake(&folder)?;
    Ok(())
}

/// The scenes of the DOS program.
#[cfg(feature = "dos")]
mod scenes {
    use std::env;
    use std::error::Error;
    use std::fmt::Write;
    use std::fs;
    use std::path::{Path, PathBuf};

    use rta_scenes::bake::Format;

    /// The scenes where the environment variable `RTA_SCENES` does not name others: the thesis's own. The first is drawn
    /// unless one is asked for.
    const SCENES: &str = "juggler.dat:hall-22.dat:glass-2.dat";

    /// Bakes each scene into a module and writes the list of their names and the function that draws them by number.
    pub(super) fn bake(folder: &str) -> Result<(), Box<dyn Error>> {
        println!("cargo::rerun-if-env-changed=RTA_SCENES");
        let scenes = env::var("RTA_SCENES").unwrap_or_else(|_| SCENES.to_owned());
        let shipped = Path::new(folder).join("../../../scenes");
        let (mut modules, mut names, mut arms) = (String::new(), String::new(), String::new());
        let count = scenes.split(':').count();
        for (number, file) in scenes.split(':').enumerate() {
            let file = shipped.join(file);
            let name = file.file_stem().ok_or("RTA_SCENES has files of scenes, with colons between")?;
            let name = name.to_string_lossy().to_uppercase();
            let baked = rta_scenes::bake::bake(&file, Format::Q16)?;
            writeln!(modules, "mod scene_{number} {{\n    include!({baked:?});\n}}")?;
            write!(names, "{name:?}, ")?;
            let pattern = if number + 1 == count { "_".to_owned() } else { number.to_string() };
            writeln!(
                arms,
                "        {pattern} => {{\n            use scene_{number}::*;\n            \
                 const {{ assert!(WEIGHTS.is_empty(), \"a scene of several wavelengths\") }}\n            \
                 const {{ assert!(SAMPLES.is_none(), \"a scene whose rays are spread\") }}\n            \
                 let [model, ..] = models();\n            \
                 paint(Needs, &SCENE, model, &CAMERA, target)\n        }}"
            )?;
        }
        let text = format!(
            "{modules}\n/// The names of the scenes.\n\
             pub(crate) const NAMES: [&str; {count}] = [{names}];\n\n\
             /// Draws the scene of a number, the last where there is none of it.\n///\n\
             /// # Errors\n/// Those of the tracer and of the display.\n\
             pub(crate) fn draw<D: Display>(\n    scene: usize,\n    display: D,\n    table: Adaptive,\n\
             ) -> Result<D, DrawError<D::Error>> {{\n    let target = (display, table);\n    match scene {{\n{arms}    }}\n}}\n"
        );
        fs::write(PathBuf::from(env::var("OUT_DIR")?).join("scenes.rs"), text)?;
        Ok(())
    }
}
