//! What the DOS program does besides its pictures: how it stops, what it says where it cannot go on, and that it is an .EXE file where it
//! does not fit a segment.

use std::fs;
use std::path::Path;

use super::board::Board;
use super::dosbox::{self, Drive, Key, Session};
use super::picture::Picture;
use super::toolchain::Toolchain;
use super::{Failure, compare, expected};

/// What must come of a session.
struct Case<'a> {
    name: &'static str,
    session: Session<'a>,
    /// The errorlevel, and words that the program must say.
    level: u8,
    said: &'a [&'a str],
}

/// Scenes of a program that is larger than a segment; the last of them is drawn.
const MANY: &str = "juggler.dat:hall-22.dat:glass-2.dat:metals.rta:mesh.rta";

/// Returns, in words, what the program does that it must not.
///
/// # Errors
/// It cannot be built.
pub fn failures(board: &Board, toolchain: Toolchain, picture: &Picture) -> Result<Vec<String>, Failure> {
    let room = tempfile::tempdir()?;
    let mut failures = Vec::new();
    let many = toolchain.build_with(board, picture, Some(MANY))?;
    note(
        &mut failures,
        "an .EXE file",
        large(&dosbox::drive(&many, &room.path().join("exe"))?, picture, board),
    );
    let image = toolchain.build(board, picture)?;
    let fresh = |number: usize| dosbox::drive(&image, &room.path().join(number.to_string()));
    let none = |arguments| Session { key: Key::None, ..Session::new(arguments) };
    let names = ["JUGGLER", "HALL-22", "GLASS-2"];
    let cases = [
        Case {
            name: "a key in the middle",
            // The whole picture would take minutes.
            session: Session { cycles: "fixed 3000", key: Key::Early, ..Session::new("hall-22") },
            level: 1,
            said: &["stopped"],
        },
        Case {
            name: "an unknown name",
            session: none("teapot"),
            level: 2,
            said: &[&names[..], &["teapot"]].concat(),
        },
        Case { name: "a question", session: none("/?"), level: 2, said: &names },
        Case {
            name: "a full disk",
            session: Session { limit: Some(4096), ..none("glass-2") },
            level: 3,
            said: &["no room"],
        },
        Case {
            name: "too little memory",
            // Some 50 KiB of 632 are left: the file fits, its stacks do not.
            session: Session { before: "loadfix -580 > nul", ..none("glass-2") },
            level: 5,
            said: &["too little memory"],
        },
    ];
    for (number, case) in cases.iter().enumerate() {
        let drive = fresh(number)?;
        let well = case
            .check(&drive)
            .and_then(|()| if drive.has_picture() { Err("it leaves a file RTA.PCX".into()) } else { Ok(()) });
        note(&mut failures, case.name, well);
    }
    let drive = fresh(cases.len())?;
    let case =
        Case { name: "no file possible", session: none("glass-2"), level: 3, said: &["cannot be made"] };
    // A folder has the name of the file: it must stay.
    let folder = drive.folder.join("RTA.PCX");
    fs::create_dir(&folder)?;
    let well = case.check(&drive).and_then(|()| {
        if Path::is_dir(&folder) { Ok(()) } else { Err("it removes what has the file's name".into()) }
    });
    note(&mut failures, case.name, well);
    Ok(failures)
}

/// Prints how a case ended, and notes it where it failed.
fn note(failures: &mut Vec<String>, name: &str, well: Result<(), Failure>) {
    println!("pc-dos, {name}: {}", if well.is_ok() { "as it must be" } else { "FAILED" });
    failures.extend(well.err().map(|failure| format!("pc-dos, {name}: {failure}")));
}

/// Compares the last picture of a program that is larger than a segment.
fn large(drive: &Drive, picture: &Picture, board: &Board) -> Result<(), Failure> {
    if drive.program != "RTA.EXE" {
        return Err("the program fits a segment, so this tells nothing".into());
    }
    let ended = drive.run(&Session::new("mesh"))?;
    if ended.level != 0 {
        return Err(format!("errorlevel {}: {}", ended.level, ended.said).into());
    }
    let file = super::folder().join("../../scenes/mesh.rta");
    let want = expected::shown(&Picture { scene: "mesh", file, ..picture.clone() }, board.output)?;
    compare::picture(&drive.picture()?, &want)
}

impl Case<'_> {
    fn check(&self, drive: &Drive) -> Result<(), Failure> {
        let ended = drive.run(&self.session)?;
        if ended.level != self.level {
            return Err(format!("errorlevel {}, not {}: {}", ended.level, self.level, ended.said).into());
        }
        match self.said.iter().find(|words| !ended.said.contains(*words)) {
            None => Ok(()),
            Some(words) => Err(format!("it does not say `{words}` but: {}", ended.said).into()),
        }
    }
}
