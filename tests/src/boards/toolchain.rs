//! The compilers that build the images of boards.

use std::env;
use std::path::PathBuf;
use std::process::Command;

use rta_scenes::sampler::Lamps;

use super::board::Board;
use super::picture::{Picture, way};
use super::{Failure, folder};

/// A compiler that has the target, or the sources of `core` to build it from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Toolchain {
    /// The compiler that built this program, with the target installed (`rustup target add`).
    Installed,
    /// Debian's rustc-web and cargo-web with rust-web-src.
    Debian,
}

/// Where Debian keeps the sources of the standard library.
const DEBIAN_SOURCES: &str = "/usr/lib/rustlib/src/rust/library/core";

impl Toolchain {
    /// Returns the compiler for a board.
    ///
    /// # Errors
    /// Neither has the target: what is missing, in words.
    pub fn find(board: &Board) -> Result<Self, Failure> {
        // Targets that are not in the compiler's distribution are always built from sources.
        let distributed = !matches!(board.package, "pc" | "sparc");
        if distributed && has_core(board.target) {
            return Ok(Self::Installed);
        }
        if PathBuf::from("/usr/bin/cargo").exists() && sources().is_some() {
            return Ok(Self::Debian);
        }
        Err(format!("no compiler for {}: see tests/boards/setup", board.target).into())
    }

    /// Returns the version of the compiler.
    ///
    /// # Errors
    /// It cannot be run.
    pub fn version(self) -> Result<String, Failure> {
        let rustc = match self {
            Self::Installed => "rustc",
            Self::Debian => "/usr/bin/rustc",
        };
        let output = Command::new(rustc).arg("--version").output()?;
        Ok(String::from_utf8_lossy(&output.stdout).split_whitespace().take(2).collect::<Vec<_>>().join(" "))
    }

    /// Builds the image of a board that draws `picture` and returns where it is.
    ///
    /// # Errors
    /// The compiler's.
    pub fn build(self, board: &Board, picture: &Picture) -> Result<PathBuf, Failure> {
        self.build_with(board, picture, None)
    }

    /// Builds an image as [`build`](Self::build) does; a DOS program with the scene files `scenes` of the folder of shipped ones, if they
    /// are given, with colons between them.
    ///
    /// # Errors
    /// The compiler's.
    pub fn build_with(
        self,
        board: &Board,
        picture: &Picture,
        scenes: Option<&str>,
    ) -> Result<PathBuf, Failure> {
        let package = folder().join(board.package);
        let target_dir = target_dir(board);
        let upper = board.target.to_uppercase().replace('-', "_");
        let mut cargo = match self {
            Self::Installed => Command::new(env::var_os("CARGO").unwrap_or("cargo".into())),
            Self::Debian => {
                let mut cargo = Command::new("/usr/bin/cargo");
                cargo.env("RUSTC", "/usr/bin/rustc").env("RUSTC_BOOTSTRAP", "1");
                cargo.env("CARGO_UNSTABLE_BUILD_STD", "core");
                cargo.env("CARGO_UNSTABLE_BUILD_STD_FEATURES", "compiler-builtins-mem");
                cargo.env("CARGO_UNSTABLE_JSON_TARGET_SPEC", "true");
                cargo.env(format!("CARGO_TARGET_{upper}_LINKER"), board.linker);
                cargo
            }
        };
        // The program that runs this is itself run by a cargo that has its own ideas of compilers and flags.
        for variable in ["RUSTFLAGS", "CARGO_ENCODED_RUSTFLAGS", "RUSTUP_TOOLCHAIN", "CARGO_BUILD_TARGET"] {
            if self == Self::Debian || variable != "RUSTUP_TOOLCHAIN" {
                cargo.env_remove(variable);
            }
        }
        let json = package.join(board.target).with_extension("json");
        let target = if json.exists() { json.into_os_string() } else { board.target.into() };
        cargo.args(["build", "--release", "--locked", "--quiet", "--target"]).arg(target);
        if let Some(feature) = board.feature {
            cargo.args(["--features", feature]);
        }
        match scenes {
            Some(scenes) => cargo.env("RTA_SCENES", scenes),
            None => cargo.env_remove("RTA_SCENES"),
        };
        cargo.env_remove("RTA_SAMPLES");
        let (width, height) = picture.size;
        cargo
            .current_dir(&package)
            .env("CARGO_TARGET_DIR", &target_dir)
            .env("RTA_SCENE", &picture.file)
            .env("RTA_MODEL", picture.model.map_or("", |model| model.name()))
            .env("RTA_FORMAT", picture.format.to_string())
            .env("RTA_LAMPS", if picture.lamps == Lamps::Point { "point" } else { "area" })
            .env("RTA_AA", picture.antialiased.map_or("none", way))
            .env("RTA_LIGHT", if picture.solves { "radiosity" } else { "lamps" })
            .env("RTA_EYE", if picture.buffered { "buffer" } else { "rays" })
            .env("RTA_NEEDS", if picture.baked { "baked" } else { "everything" })
            .env("RTA_COLORS", picture.colors.name())
            .env("RTA_SIZE", format!("{width}x{height}"));
        let output = cargo.output()?;
        if !output.status.success() {
            let words = String::from_utf8_lossy(&output.stderr).into_owned();
            return Err(format!("{} cannot be built:\n{words}", board.name).into());
        }
        let release = target_dir.join(board.target).join("release");
        let name = format!("{}-board", board.package);
        Ok(match board.package {
            "wasm" => release.join("wasm_board.wasm"),
            _ => release.join(name),
        })
    }
}

/// Returns the target folder of a board's images, which lies in that of the workspace.
fn target_dir(board: &Board) -> PathBuf {
    let target = env::var_os("CARGO_TARGET_DIR").map_or_else(|| folder().join("../../target"), PathBuf::from);
    target.join("boards").join(board.target_folder().to_string())
}

/// Returns whether the installed compiler has `core` for a target.
fn has_core(target: &str) -> bool {
    let printed = Command::new("rustc").args(["--print", "target-libdir", "--target", target]).output();
    let Ok(printed) = printed else { return false };
    let folder = PathBuf::from(String::from_utf8_lossy(&printed.stdout).trim());
    let Ok(files) = folder.read_dir() else { return false };
    files.flatten().any(|file| file.file_name().to_string_lossy().starts_with("libcore-"))
}

/// Returns the folder of the standard library's sources of Debian's compiler, if it has them.
fn sources() -> Option<PathBuf> {
    let root = Command::new("/usr/bin/rustc").args(["--print", "sysroot"]).output().ok()?;
    let root = PathBuf::from(String::from_utf8_lossy(&root.stdout).trim());
    let library = root.join("lib/rustlib/src/rust/library/core");
    [library, DEBIAN_SOURCES.into()].into_iter().find(|path| path.exists())
}
