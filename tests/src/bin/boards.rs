//! Builds the boards' images, boots them under emulation and compares what they draw with the engine, byte for byte.

use core::sync::atomic::{AtomicUsize, Ordering};
use std::collections::BTreeMap;
use std::fs;
use std::panic::resume_unwind;
use std::path::PathBuf;
use std::process::{Command, ExitCode, Stdio};
use std::time::Instant;

use clap::Parser;
use rta_tests::boards::board::{ALL, Board, DOS, TARGET_FOLDERS};
use rta_tests::boards::dos;
use rta_tests::boards::footprint::{self, Footprint};
use rta_tests::boards::models;
use rta_tests::boards::picture::Picture;
use rta_tests::boards::report;
use rta_tests::boards::row::Row;
use rta_tests::boards::toolchain::Toolchain;
use rta_tests::boards::{Failure, folder};

/// Boots the boards under emulation and compares what they draw with the engine, byte for byte
///
/// The status is 1 where anything differs or fails. A board whose emulator or compiler is missing is skipped and
/// counted; where the environment has CI, that is a failure. `tests/boards/setup` installs what Debian offers.
#[derive(Parser)]
struct Args {
    /// Boards [default: all]
    boards: Vec<String>,
    /// Draws less: opaque and glass-2 in q16 and the Juggler in f32, on two boards every scene in q16, and on two one
    /// program for any scene; on three boards three illumination models, and the programs whose sizes have a limit
    #[arg(long)]
    brief: bool,
    /// Writes tests/boards/FOOTPRINT.md anew instead of comparing with it
    #[arg(long)]
    write: bool,
    /// Keeps what each board wrote, its screendumps too, in this folder
    #[arg(long, value_name = "FOLDER")]
    keep: Option<PathBuf>,
}

fn main() -> ExitCode {
    let args = Args::parse();
    match run(&args) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(failure) => {
            eprintln!("boards: {failure}");
            ExitCode::from(2)
        }
    }
}

fn run(args: &Args) -> Result<bool, Failure> {
    if let Some(unknown) = args.boards.iter().find(|name| ALL.iter().all(|board| board.name != name.as_str()))
    {
        let names: Vec<_> = ALL.iter().map(|board| board.name).collect();
        return Err(format!("there is no board {unknown}; there are {}", names.join(", ")).into());
    }
    let wanted = |board: &&Board| args.boards.is_empty() || args.boards.iter().any(|name| name == board.name);
    let (mut skipped, mut jobs) = (Vec::new(), Vec::new());
    for board in ALL.iter().filter(wanted) {
        match ready(board) {
            Ok(toolchain) => {
                println!("{}: {} by {}", board.name, board.processor, toolchain.version()?);
                let pictures = board.pictures().into_iter();
                let wanted = pictures.filter(|picture| !args.brief || picture.is_brief(board));
                jobs.extend(wanted.map(|picture| (*board, toolchain, picture)));
            }
            Err(reason) => skipped.push(format!("{}: {reason}", board.name)),
        }
    }
    let version = jobs.first().map_or(Ok(String::new()), |(_, toolchain, _)| toolchain.version())?;
    let begin = Instant::now();
    let (rows, mut failures) = work(&jobs, args);
    report::print_table(&rows);
    failures.extend(report::superfluous(&rows));
    failures.extend(report::miscounted(&rows, &version));
    failures.extend(models::strange(&rows)?);
    failures.extend(models::large(&rows));
    if !args.brief
        && let Some((board, toolchain, picture)) = jobs.iter().find(|(board, ..)| *board == DOS)
    {
        failures.extend(dos::failures(board, *toolchain, picture)?);
    }
    let recorded = rows.iter().filter(|row| row.picture.model.is_none());
    let footprints: Vec<Footprint> = recorded.filter_map(|row| row.footprint.clone()).collect();
    let page = folder().join("FOOTPRINT.md");
    if args.write {
        if args.brief || !args.boards.is_empty() || !skipped.is_empty() || !failures.is_empty() {
            return Err("footprints are written of all boards at once, and when nothing fails".into());
        }
        fs::write(&page, footprint::page(&footprints, &version))?;
    } else {
        failures.extend(report::drift(
            &footprints,
            &footprint::parse(&fs::read_to_string(&page)?)?,
            &version,
        ));
    }
    for reason in &skipped {
        println!("SKIPPED {reason}");
    }
    for failure in &failures {
        println!("FAILED {failure}");
    }
    let seconds = begin.elapsed().as_secs();
    println!(
        "boards: {} pictures right, {} failed, {} boards skipped, {seconds} s",
        rows.len(),
        failures.len(),
        skipped.len()
    );
    Ok(failures.is_empty() && (skipped.is_empty() || std::env::var_os("CI").is_none()))
}

/// Returns the compiler for a board, or an error where its emulator or its compiler is missing.
fn ready(board: &Board) -> Result<Toolchain, Failure> {
    for program in board.programs() {
        let probe =
            Command::new(program).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
        if probe.is_err() {
            return Err(format!("no {program}: see tests/boards/setup").into());
        }
    }
    Toolchain::find(board)
}

/// A picture to be drawn: the board, the compiler of its image, and the picture.
type Job = (Board, Toolchain, Picture);

/// Does all jobs, each in its board's target folder. One thread works through each folder, so that two targets are
/// built at once, and an image runs while one of the other folder is built.
fn work(jobs: &[Job], args: &Args) -> (Vec<Row>, Vec<String>) {
    let finished = AtomicUsize::new(0);
    let one = |(board, toolchain, picture): &Job| {
        let begin = Instant::now();
        let name = picture.title(board);
        let row = Row::draw(*board, *toolchain, picture.clone(), args.keep.as_deref());
        let row = row.map_err(|failure| format!("{name}: {failure}"));
        let (seconds, verdict) = (begin.elapsed().as_secs(), if row.is_ok() { "" } else { ": FAILED" });
        let number = finished.fetch_add(1, Ordering::Relaxed) + 1;
        println!("[{number}/{}] {name}, {seconds} s{verdict}", jobs.len());
        row
    };
    let done = std::thread::scope(|scope| {
        let threads = (0..TARGET_FOLDERS).map(|folder| {
            scope.spawn(move || {
                let jobs = jobs.iter().enumerate().filter(|(_, (board, ..))| board.target_folder() == folder);
                jobs.map(|(place, job)| (place, one(job))).collect::<Vec<_>>()
            })
        });
        let threads: Vec<_> = threads.collect();
        let joined =
            threads.into_iter().map(|thread| thread.join().unwrap_or_else(|panic| resume_unwind(panic)));
        joined.flatten().collect::<BTreeMap<_, _>>()
    });
    let (mut rows, mut failures) = (Vec::new(), Vec::new());
    for row in done.into_values() {
        match row {
            Ok(row) => rows.push(row),
            Err(failure) => failures.push(failure),
        }
    }
    (rows, failures)
}
