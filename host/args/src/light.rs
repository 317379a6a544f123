//! Light that was solved ahead.

use core::fmt;
use core::str::FromStr;
use std::path::PathBuf;

use clap::Args;
use rta_scenes::solution::{Caching, Shown};

/// Light that was solved ahead.
#[derive(Args, Clone, Debug, Default)]
pub struct LightArgs {
    /// Radiosity that rta radiosity solved for this scene, in its file; or solve
    ///
    /// solve: the picture's own format, 64 rays a patch, as a board does that solves by itself.
    #[arg(long, value_name = "FILE")]
    pub light: Option<PathBuf>,
    /// How the solved radiosity is shown: indirect, cache, cache:RAYS, cache:RAYS:ERROR or all
    ///
    /// indirect: in two passes, the light of lamps is traced, and the solved indirect light takes the place of ambient light. cache: so too, but
    /// indirect light is gathered anew by RAYS (64) from some of the places that the eye sees, whose distance is ERROR (.2) of the
    /// harmonic mean distance of what they see, and mixed between them (an irradiance cache, Ward, Rubinstein and Clear 1988). all: all light
    /// is the solved one, between the vertices of patches, and lamps are not asked.
    #[arg(long, value_name = "HOW", default_value_t, requires = "light", verbatim_doc_comment)]
    pub light_as: ShownValue,
}

/// How solved radiosity is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ShownValue(pub Shown);

/// The most rays from a place.
const MOST_RAYS: u32 = 1 << 16;

impl FromStr for ShownValue {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let text = text.to_ascii_lowercase();
        let caching = |words: &str| {
            let (rays, error) =
                words.split_once(':').map_or((words, None), |(rays, error)| (rays, Some(error)));
            let rays = rays.parse().ok().filter(|rays| (1..=MOST_RAYS).contains(rays))?;
            let error = match error {
                Some(error) => error.parse().ok().filter(|error| *error >= 0.01 && *error <= 1.0)?,
                None => Caching::default().error,
            };
            Some(Shown::Cache(Caching { rays, error }))
        };
        let shown = match (&*text, text.strip_prefix("cache:")) {
            ("indirect", _) => Some(Shown::Indirect),
            ("all", _) => Some(Shown::All),
            ("cache", _) => Some(Shown::Cache(Caching::default())),
            (_, Some(words)) => caching(words),
            _ => None,
        };
        shown
            .map(Self)
            .ok_or("expected indirect, all, cache, cache:RAYS (1 to 65536) or cache:RAYS:ERROR (.01 to 1)")
    }
}

impl fmt::Display for ShownValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Shown::Indirect => f.write_str("indirect"),
            Shown::All => f.write_str("all"),
            Shown::Cache(Caching { rays, error }) => write!(f, "cache:{rays}:{error}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Caching, Shown, ShownValue};

    #[test]
    fn words_come_back() {
        for (word, want) in [
            ("indirect", Shown::Indirect),
            ("ALL", Shown::All),
            ("cache", Shown::Cache(Caching::default())),
            ("cache:64", Shown::Cache(Caching { rays: 64, ..Caching::default() })),
            ("cache:64:.3", Shown::Cache(Caching { rays: 64, error: 0.3 })),
        ] {
            let read: ShownValue = word.parse().expect(word);
            assert_eq!(read, ShownValue(want));
            assert_eq!(read.to_string().parse(), Ok(read));
        }
        for word in ["", "cach", "cache:", "cache:0", "cache:1:0", "cache:1:2", "cache:64:.3:1", "cache::.3"]
        {
            assert!(word.parse::<ShownValue>().is_err(), "{word}");
        }
    }
}
