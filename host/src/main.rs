//! A Whitted ray tracer in fixed point and float, on the displays of 1990.
#![forbid(unsafe_code)]

use std::io::{self, Write};
use std::panic;
use std::process::{self, ExitCode};

use rta::args::{self, Command, ShowArgs};
use rta::commands::show::window;
use rta::commands::{bake, check, convert, explain, gallery, hash, merge, pages, radiosity, render};
use rta::engine::interrupt;
use rta::error::Error;
use rta::study::{
    bench, compare, difference, figures, models, palette, report, stability, values, visibility,
};

/// Exit status after a comparison that found a difference, which is no error of the program's.
const DIFFERENT: u8 = 1;
/// Exit status after any error.
const FAILED: u8 = 2;

fn main() -> ExitCode {
    let cli = match args::parse(std::env::args_os()) {
        Ok(cli) => cli,
        Err(usage) if usage.use_stderr() => {
            complain(&usage.render().to_string());
            return FAILED.into();
        }
        // Help and version; whoever does not read them to the end has seen enough.
        Err(help) => {
            let _ = help.print();
            return ExitCode::SUCCESS;
        }
    };
    interrupt::forgo_file_limit();
    tell_of_broken_pictures();
    match run(cli.command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) if error.is_broken_pipe() => ExitCode::SUCCESS,
        Err(error) if error.is_difference() => DIFFERENT.into(),
        Err(error) if error.is_interruption() => interrupt::STATUS.into(),
        Err(error) => {
            complain(&format!("error: {error}\n"));
            FAILED.into()
        }
    }
}

/// Ends the program with an error where a picture's decoder panics, in a build whose panics would abort it.
fn tell_of_broken_pictures() {
    if cfg!(panic = "abort") {
        let others = panic::take_hook();
        panic::set_hook(Box::new(move |info| match rta_scenes::pictures::decoded() {
            Some(path) => {
                complain(&format!("error: {}: its decoder does not expect what it holds\n", path.display()));
                process::exit(FAILED.into());
            }
            None => others(info),
        }));
    }
}

fn run(command: Option<Command>) -> Result<(), Error> {
    match command {
        None => window::run(&ShowArgs::default())?,
        Some(Command::Show(args)) => window::run(&args)?,
        Some(Command::Render(args)) => render::run(&args)?,
        Some(Command::Radiosity(args)) => radiosity::run(&args)?,
        Some(Command::Juggle(args)) => render::juggle(&args)?,
        Some(Command::Merge(args)) => merge::run(&args)?,
        Some(Command::Report(args)) => report::run(&args)?,
        Some(Command::Figures(args)) => figures::run(&args)?,
        Some(Command::Gallery(args)) => gallery::run(&args)?,
        Some(Command::Instructions(args)) if args.light => report::light::counting::run(&args)?,
        Some(Command::Instructions(args)) => report::instructions::run(&args)?,
        Some(Command::Bench(args)) => bench::run(&args)?,
        Some(Command::Traced(args)) => bench::child::run(&args)?,
        Some(Command::Stability(args)) => stability::run(&args)?,
        Some(Command::Values(args)) => values::run(&args)?,
        Some(Command::Check(args)) => check::run(&args)?,
        Some(Command::Bake(args)) => bake::run(&args)?,
        Some(Command::Convert(args)) => convert::run(&args)?,
        Some(Command::Language) => convert::language()?,
        Some(Command::Hash(args)) => hash::run(&args)?,
        Some(Command::Explain(args)) => explain::run(&args)?,
        Some(Command::Models) => models::run()?,
        Some(Command::Compare(args)) => compare::run(&args)?,
        Some(Command::Palette(args)) => palette::run(&args)?,
        Some(Command::Indexing(args)) => palette::instructions::run(&args)?,
        Some(Command::Difference(args)) => difference::run(&args)?,
        Some(Command::Visibility(args)) => visibility::run(&args)?,
        Some(Command::Completions(args)) => pages::completions(&args)?,
        Some(Command::Man(args)) => pages::man(&args)?,
    }
    Ok(())
}

/// Writes to standard error. If that is closed too there is nobody left to tell.
fn complain(text: &str) {
    let _ = write!(io::stderr(), "rta: {text}");
}
