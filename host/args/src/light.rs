//! Light that was solved ahead.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

/// Light that was solved ahead.
#[derive(Args, Clone, Debug, Default)]
pub struct LightArgs {
    /// Radiosity that rta radiosity solved for this scene, in its file
    #[arg(long, value_name = "FILE")]
    pub light: Option<PathBuf>,
    /// How the solved radiosity is shown
    #[arg(long, value_enum, ignore_case = true, default_value_t = Shown::Indirect, requires = "light")]
    pub light_as: Shown,
}

/// How solved radiosity is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Shown {
    #[default]
    /// In two passes: the light of lamps is traced, and the solved indirect light takes the place of ambient light
    Indirect,
    /// All light is the solved one, between the vertices of patches, and lamps are not asked
    All,
}
