//! Arguments of the commands that tell others about the command line: `rta completions` and `rta man`.

use std::path::PathBuf;

use clap::Args;
use clap_complete::Shell;

/// `rta completions`.
#[derive(Args, Debug)]
pub struct CompletionsArgs {
    /// The shell
    #[arg(value_enum, ignore_case = true)]
    pub shell: Shell,
}

/// `rta man`.
#[derive(Args, Debug)]
pub struct ManArgs {
    /// Folder that the pages are written to; it is made if it is not there
    #[arg(short, long, value_name = "FOLDER")]
    pub output: PathBuf,
}
