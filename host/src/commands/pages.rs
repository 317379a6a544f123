//! `rta completions` and `rta man`: what shells and `man` know of the command line, made from its definition.

use clap::CommandFactory;
use clap_mangen::Man;

use crate::args::{Cli, CompletionsArgs, ManArgs};
use crate::engine::interrupt;
use crate::error::Error;
use crate::picture::output::{self, Inputs, Output};

/// Runs `rta completions`.
///
/// # Errors
/// Those of writing to standard output.
pub fn completions(args: &CompletionsArgs) -> Result<(), Error> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut Cli::command(), "rta", &mut script);
    Ok(output::print(&String::from_utf8_lossy(&script), Inputs::NONE)?)
}

/// Runs `rta man`: writes `rta.1`, and `rta-render.1` and its like for all commands that are in the help.
///
/// # Errors
/// Those of writing the files.
pub fn man(args: &ManArgs) -> Result<(), Error> {
    let folder = &args.output;
    output::make_folder(folder)?;
    // From here on a signal waits until the pages are there.
    interrupt::watch();
    let mut all = Cli::command();
    // Gives commands their full names.
    all.build();
    let commands =
        all.get_subcommands().filter(|command| !command.is_hide_set() && command.get_name() != "help");
    for command in core::iter::once(&all).chain(commands) {
        let name = command.get_display_name().unwrap_or(command.get_name()).to_owned();
        let page = Man::new(command.clone().name(name.clone()));
        let output = Output::open(&folder.join(format!("{name}.1")), Inputs::NONE)?;
        output.fill(|mut out| Ok::<_, output::Failure<Error>>(page.render(&mut out)?))?;
    }
    Ok(())
}
