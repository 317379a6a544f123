//! Builds the boards' images, boots them under emulation and compares what they draw with the engine, byte for byte.

use core::sync::atomic::{AtomicUsize, Ordering};
use std::collections::BTreeMap;
use std::fs;
use std::panic::resume_unwind;
use std::path::PathBuf;
use std::process::{Command, ExitCode, Stdio};
use std::time::Instant;

use clap::Parser;
use rta::engine::Format;
use rta_core::color::Rgb;
use rta_tests::boards::board::{ALL, Board, Output, Picture, TARGET_FOLDERS};
use rta_tests::boards::expected::{self, Indexed};
use rta_tests::boards::footprint::{self, Footprint};
use rta_tests::boards::machine::{self, Outcome, Screendump};
use rta_tests::boards::toolchain::Toolchain;
use rta_tests::boards::{Failure, elf, folder};

/// Boots the boards under emulation and compares what they draw with the engine, byte for byte
///
/// The status is 1 where anything differs or fails. A board whose emulator or compiler is missing is skipped and counted;
/// where the environment has CI, that is a failure. `tests/boards/setup` installs what Debian offers.
#[derive(Parser)]
struct Args {
    /// Boards [default: all]
    boards: Vec<String>,
    /// Draws less: opaque and glass-2 in q16 and the Juggler in f32, on two boards every scene in q16, and on two one
    /// program for any scene
    #[arg(long)]
    brief: bool,
    /// Writes tests/boards/FOOTPRINT.md anew instead of comparing with it
    #[arg(long)]
    write: bool,
    /// Keeps what each board wrote, its screendumps too, in this folder
    #[arg(long, value_name = "FOLDER")]
    keep: Option<PathBuf>,
}

/// Primitives that the opaque scene does not have, by the names of their modules.
const PRIMITIVES: [&str; 2] = ["cylinder", "ellipsoid"];

/// A picture that came out right.
struct Row {
    board: Board,
    picture: Picture,
    hash: u64,
    stack: Option<u64>,
    /// Names of primitives that its functions have.
    primitives: Vec<&'static str>,
    footprint: Option<Footprint>,
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
    let (rows, failures) = work(&jobs, args);
    print_table(&rows);
    let mut failures: Vec<String> = failures.iter().map(ToString::to_string).collect();
    failures.extend(superfluous(&rows));
    let footprints: Vec<Footprint> = rows.iter().filter_map(|row| row.footprint.clone()).collect();
    let page = folder().join("FOOTPRINT.md");
    if args.write {
        if args.brief || !args.boards.is_empty() || !skipped.is_empty() || !failures.is_empty() {
            return Err("footprints are written of all boards at once, and when nothing fails".into());
        }
        fs::write(&page, footprint::page(&footprints, &version))?;
    } else {
        failures.extend(drift(&footprints, &footprint::parse(&fs::read_to_string(&page)?)?, &version));
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

/// The compiler for a board whose emulator is there.
fn ready(board: &Board) -> Result<Toolchain, Failure> {
    let probe =
        Command::new(board.emulator).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    if probe.is_err() {
        return Err(format!("no {}: see tests/boards/setup", board.emulator).into());
    }
    Toolchain::find(board)
}

/// What is drawn: a board, what builds its image, and the picture.
type Job = (Board, Toolchain, Picture);

/// All jobs, each in its board's target folder. A thread works through each folder, so two targets are built at once, and
/// an image runs while one of the other folder is built.
fn work(jobs: &[Job], args: &Args) -> (Vec<Row>, Vec<Failure>) {
    let finished = AtomicUsize::new(0);
    let one = |(board, toolchain, picture): &Job| {
        let begin = Instant::now();
        let name = title(board, picture);
        let row = draw(*board, *toolchain, picture.clone(), args);
        let row = row.map_err(|failure| -> Failure { format!("{name}: {failure}").into() });
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

fn needs(picture: &Picture) -> &'static str {
    if picture.baked { "baked" } else { "Everything" }
}

fn title(board: &Board, picture: &Picture) -> String {
    format!("{} {} {} {}", board.name, picture.scene, picture.format, needs(picture))
}

/// Builds, boots and compares one picture.
fn draw(board: Board, toolchain: Toolchain, picture: Picture, args: &Args) -> Result<Row, Failure> {
    let room = tempfile::tempdir()?;
    let image = room.path().join("image");
    fs::copy(toolchain.build(&board, &picture)?, &image)?;
    let outcome = machine::run(&board, &image, room.path())?;
    if let Some(keep) = &args.keep {
        let folder = keep.join(title(&board, &picture).replace(' ', "-"));
        fs::create_dir_all(&folder)?;
        for file in fs::read_dir(room.path())?.flatten().filter(|file| file.path().is_file()) {
            fs::copy(file.path(), folder.join(file.file_name()))?;
        }
    }
    let want = expected::shown(&picture, board.output)?;
    compare(&outcome.drawn, &want)?;
    if let (Some(dump), Output::Screen { screen, zoom, .. }) = (&outcome.screendump, board.output) {
        compare_screen(dump, &want, picture.size, screen, zoom as usize)?;
    }
    let streamed = (160, 100);
    let hash = expected::streamed(&picture, streamed)?.hash(streamed)?;
    let own = outcome.hash.map_or_else(|| outcome.drawn.hash(picture.size), Ok)?;
    if own != hash {
        return Err(format!("its hash is {own:016x}, not {hash:016x}").into());
    }
    let image = fs::read(&image)?;
    let footprint = footprint_of(&board, &picture, &outcome, &image)?;
    let mut primitives = Vec::new();
    if footprint.is_some() {
        for name in PRIMITIVES {
            if elf::mentions(&image, name)? {
                primitives.push(name);
            }
        }
    }
    Ok(Row { board, picture, hash, stack: outcome.stack, primitives, footprint })
}

fn compare(got: &Indexed, want: &Indexed) -> Result<(), Failure> {
    let used = want.colors.len();
    if got.colors.get(..used) != Some(want.colors.as_slice()) {
        return Err("its colour table differs".into());
    }
    if got.pixels.len() != want.pixels.len() {
        return Err(format!("{} pixels, not {}", got.pixels.len(), want.pixels.len()).into());
    }
    match got.pixels.iter().zip(&want.pixels).filter(|(got, want)| got != want).count() {
        0 => Ok(()),
        wrong => Err(format!("{wrong} of {} pixels differ", want.pixels.len()).into()),
    }
}

/// Compares what the screen shows with the picture: in its middle where the picture is smaller, black around it.
fn compare_screen(
    dump: &Screendump,
    want: &Indexed,
    (width, height): (u32, u32),
    (across, down, gun_max): (u32, u32, u8),
    zoom: usize,
) -> Result<(), Failure> {
    let (across, down) = (across as usize, down as usize);
    if dump.size != (across * zoom, down * zoom) {
        return Err(format!("the screendump has {:?} pixels", dump.size).into());
    }
    let (width, height) = (width as usize, height as usize);
    let (left, top) = ((across - width) / 2, (down - height) / 2);
    // QEMU's DAC of 6 bits: the lowest bit fills both that are missing.
    let light = |level: u8| if gun_max == 63 { level << 2 | (level & 1) << 1 | level & 1 } else { level };
    let shown = |x: usize, y: usize| {
        let inside = x >= left && y >= top && x < left + width && y < top + height;
        let index = if inside { want.pixels.get((y - top) * width + x - left) } else { Some(&0) };
        let color = index.and_then(|&index| want.colors.get(usize::from(index))).copied().unwrap_or_default();
        let Rgb { r, g, b } = color.map(light);
        [r, g, b]
    };
    let rows = dump.pixels.chunks(across * zoom).enumerate();
    let places = rows.flat_map(|(y, row)| row.iter().enumerate().map(move |(x, pixel)| (x, y, pixel)));
    match places.filter(|&(x, y, pixel)| *pixel != shown(x / zoom, y / zoom)).count() {
        0 => Ok(()),
        wrong => Err(format!("{wrong} pixels of the screendump differ").into()),
    }
}

fn footprint_of(
    board: &Board,
    picture: &Picture,
    outcome: &Outcome,
    image: &[u8],
) -> Result<Option<Footprint>, Failure> {
    let (Some(stack), Some(instructions)) = (outcome.stack, outcome.instructions) else { return Ok(None) };
    let elf::Sizes { text, rodata, ram } = elf::sizes(image)?;
    let (width, height) = picture.size;
    let instructions = instructions / (u64::from(width) * u64::from(height));
    let key = [board.name, picture.scene, &picture.format.to_string(), needs(picture)].map(str::to_owned);
    Ok(Some(Footprint { key, text, rodata, ram, stack, instructions }))
}

/// What programs that hold only what the opaque scene needs have in them that they should not have.
fn superfluous(rows: &[Row]) -> Vec<String> {
    let of = |board: &Board, format, baked| {
        rows.iter().find(|row| {
            let Picture { scene, format: this, baked: own, .. } = row.picture;
            row.board == *board && (scene, this, own) == ("opaque", format, baked)
        })
    };
    let mut found = Vec::new();
    for baked in rows.iter().filter(|row| row.picture.scene == "opaque" && row.picture.baked) {
        let name = title(&baked.board, &baked.picture);
        if !baked.primitives.is_empty() {
            found.push(format!("{name}: it has functions of {}", baked.primitives.join(", ")));
        }
        let Some(everything) = of(&baked.board, baked.picture.format, false) else { continue };
        if baked.picture.format == Format::Q16 && everything.primitives != PRIMITIVES {
            found.push(format!("{name}: names of functions tell nothing, as Everything's do not"));
        }
        if let (Some(few), Some(all)) = (&baked.footprint, &everything.footprint)
            && few.text * 100 > all.text * 65
        {
            found.push(format!("{name}: {} bytes of code, of {} with Everything", few.text, all.text));
        }
    }
    found
}

fn drift(now: &[Footprint], (compiler, then): &(String, Vec<Footprint>), version: &str) -> Vec<String> {
    if compiler != version {
        println!("footprints were recorded with {compiler}: not compared with {version}");
        return Vec::new();
    }
    let recorded = |row: &Footprint| then.iter().find(|then| then.key == row.key);
    now.iter()
        .flat_map(|row| match recorded(row) {
            Some(then) => row.drift(then),
            None => vec![format!("{}: not in FOOTPRINT.md", row.key.join(" "))],
        })
        .collect()
}

fn print_table(rows: &[Row]) {
    println!(
        "\n{:12} {:12} {:8} {:4} {:10} {:>9} {:>6} {:>6} {:>8}  hash at 160x100",
        "board", "processor", "scene", "", "needs", "raster", "stack", ".text", "a pixel"
    );
    for Row { board, picture, hash, stack, footprint, .. } in rows {
        let (width, height) = picture.size;
        let word = |figure: Option<u64>| figure.map_or_else(String::new, |figure| figure.to_string());
        println!(
            "{:12} {:12} {:8} {:4} {:10} {:>9} {:>6} {:>6} {:>8}  {hash:016x}",
            board.name,
            board.processor,
            picture.scene,
            picture.format.to_string(),
            needs(picture),
            format!("{width}x{height}"),
            word(*stack),
            word(footprint.as_ref().map(|row| row.text)),
            word(footprint.as_ref().map(|row| row.instructions)),
        );
    }
    println!();
}
