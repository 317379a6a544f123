//! The command line as people type it: a scene without a command, and advice where an option is another program's or another
//! command's.

use std::ffi::{OsStr, OsString};
use std::path::Path;

use clap::builder::StyledStr;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Command, CommandFactory, Parser};

use super::Cli;

/// What other programs call the options of rta: ours, how it is used, and their names.
const ELSEWHERE: [(&str, &str, &str); 9] = [
    ("size", "--size 640x480 sets width and height", "width height w W H resolution res geometry dimensions"),
    (
        "samples",
        "--samples 4 takes that many samples of a pixel",
        "spp antialias anti-aliasing antialiasing supersample supersampling quality n",
    ),
    ("threads", "--threads 4 traces with so many threads", "jobs j cores cpus parallel T"),
    (
        "depth",
        "--depth 5 follows so many reflections and refractions",
        "max-depth recursion recursion-depth bounces max-bounces reflections",
    ),
    ("output", "-o FILE names the output", "out outfile out-file output-file O"),
    ("as", "--as png names the kind of picture", "type output-format file-format filetype"),
    (
        "table",
        "--table uniform chooses the colour table",
        "palette colors colours colormap colortable color-table",
    ),
    ("model", "--model phong chooses the illumination", "shader lighting illumination"),
    ("format", "--format q16 chooses the number format", "precision number-format fixed fixed-point"),
];

/// Options that no command has, or not these, and why.
const NOWHERE: [(&str, &[&str], &str); 5] = [
    ("gamma", &[], "light is linear, and rta applies no gamma"),
    ("force overwrite yes y", &[], "a file that is there already is replaced without asking"),
    ("verbose v", &[], "there is nothing more to say; rta explain tells all about a pixel"),
    (
        "s size d device",
        &["check", "bake"],
        "whether a scene fits does not depend on size or device, but on --aspect",
    ),
    ("d device t table", &["explain"], "a pixel is explained as it is before any device"),
];

/// Tells whether a value looks like one of some kind.
type Likeness = fn(&str) -> bool;

/// Values that belong to another option: of which option, what they look like, and where they belong.
const MISPLACED: [(&str, Likeness, &str); 3] = [
    ("--device", is_whole, "--depth sets the number of reflections"),
    ("--table", is_whole, "--threads sets the number of threads"),
    ("--format", is_picture, "this is the number format; --as sets the kind of picture"),
];

/// Reads a command line, whose first word is the program. Without a command it is `show`: with a scene, with options or with
/// neither.
///
/// # Errors
/// What is wrong with it, and how it should be; help and version, too, are errors here.
pub fn parse(args: impl IntoIterator<Item = OsString>) -> Result<Cli, clap::Error> {
    let mut args: Vec<OsString> = args.into_iter().collect();
    let all = Cli::command();
    if args.len() == 3
        && args.get(1).is_some_and(|word| word == "help")
        && args.get(2).is_some_and(|word| word == "scene")
    {
        args.splice(1.., ["language".into()]);
    }
    if args.get(1).is_some_and(|first| is_for_show(first, &all)) {
        args.insert(1, "show".into());
    }
    let command = args.get(1).and_then(|name| all.find_subcommand(name)).unwrap_or(&all);
    Cli::try_parse_from(&args).map_err(|error| advised(error, command, &args))
}

/// Returns whether the first word is for `rta show`: an option of it, or a scene and no misspelt command.
fn is_for_show(first: &OsStr, all: &Command) -> bool {
    let text = first.to_string_lossy();
    if text.starts_with('-') {
        return !["-h", "--help", "-V", "--version"].contains(&&*text);
    }
    let is_command = text == "help" || all.find_subcommand(first).is_some();
    !is_command && (text.contains(['.', '/', '\\']) || Path::new(first).exists())
}

/// Adds a tip to an error about the arguments of `command`, if there is one that helps.
fn advised(mut error: clap::Error, command: &Command, args: &[OsString]) -> clap::Error {
    let context = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => text.clone(),
        _ => String::new(),
    };
    let word = context(ContextKind::InvalidArg);
    let tip = match error.kind() {
        // How to pass an option as a scene's name, which is what clap would tell, is no help.
        ErrorKind::UnknownArgument => {
            error.remove(ContextKind::Suggested);
            let name = word.trim_start_matches('-').split('=').next().unwrap_or_default();
            if name.len() == word.len() { spare(&word, command, args) } else { unknown(&word, name, command) }
        }
        ErrorKind::InvalidValue => {
            let value = context(ContextKind::InvalidValue);
            let other = MISPLACED.iter().find(|(option, like, _)| word.starts_with(option) && like(&value));
            other.map(|(_, _, tip)| (*tip).to_owned())
        }
        _ => None,
    };
    if let Some(tip) = tip {
        error.remove(ContextKind::SuggestedArg);
        error.remove(ContextKind::SuggestedValue);
        error.remove(ContextKind::Usage);
        error.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![StyledStr::from(tip)]));
    }
    error
}

/// Returns a tip about a word that is neither an option nor the value of one.
fn spare(word: &str, command: &Command, args: &[OsString]) -> Option<String> {
    let given = |name: &str| args.iter().any(|arg| arg.to_string_lossy().starts_with(name));
    if has(command, "size") && (given("-s") || given("--size")) && is_whole(word) {
        return Some("a size is one word, such as 640x480".to_owned());
    }
    // Where it is optional, the word may well be meant for an input.
    let needs_output =
        command.get_opts().any(|own| own.get_long() == Some("output") && own.is_required_set());
    if needs_output && !given("-o") && !given("--output") {
        return Some(format!("-o {word} makes it the output"));
    }
    let takes = command.get_positionals().next().map(|only| format!("one {}", only.get_id()));
    Some(format!("rta {} takes {}", command.get_name(), takes.as_deref().unwrap_or("nothing but options")))
}

/// Returns a tip about an option that `command` does not have.
fn unknown(option: &str, name: &str, command: &Command) -> Option<String> {
    let among = |names: &str, name: &str| names.split(' ').any(|other| other == name);
    let elsewhere = ELSEWHERE.iter().find(|(_, _, names)| among(names, name));
    let ours = elsewhere.map_or(name, |(ours, _, _)| *ours);
    let all = Cli::command();
    if name.starts_with(|first: char| first.is_ascii_digit()) {
        return Some("no option takes a number below 0".to_owned());
    }
    let of_this = |of: &[&str]| of.is_empty() || of.contains(&command.get_name());
    if let Some((_, _, tip)) = NOWHERE.iter().find(|(names, of, _)| among(names, ours) && of_this(of)) {
        return Some((*tip).to_owned());
    }
    let lower = name.to_lowercase();
    if lower != name && has(command, &lower) {
        return Some(format!("it is {} in lower case", option.to_lowercase()));
    }
    let having = all.get_subcommands().filter(|command| !command.is_hide_set() && has(command, ours));
    let having: Vec<_> = having.map(|command| format!("rta {}", command.get_name())).collect();
    let [others @ .., last] = having.as_slice() else { return None };
    let listed = if others.is_empty() { last.clone() } else { format!("{} and {last}", others.join(", ")) };
    match elsewhere {
        Some((ours, tip, _)) if has(command, ours) => Some((*tip).to_owned()),
        Some((_, tip, _)) => Some(format!("{tip}, in {listed}")),
        None => Some(format!("{option} is an option of {listed}")),
    }
}

/// Returns whether a command has an option of this name, long or short, that it tells of.
fn has(command: &Command, name: &str) -> bool {
    command.get_opts().chain(command.get_arguments()).filter(|own| !own.is_hide_set()).any(|own| {
        own.get_long() == Some(name) || own.get_short().is_some_and(|short| name == short.to_string())
    })
}

fn is_whole(value: &str) -> bool {
    value.parse::<u64>().is_ok()
}

fn is_picture(value: &str) -> bool {
    crate::value::file_type::FileType::of_extension(value).is_some()
}

#[cfg(test)]
mod tests {
    use super::{ELSEWHERE, NOWHERE, has, parse};
    use crate::{Cli, Command};
    use clap::CommandFactory;

    #[test]
    fn a_scene_alone_is_shown() {
        for args in
            [&["rta", "a.nff"][..], &["rta", "-s", "9x9", "a.nff"], &["rta", "show", "a.nff", "--size=9x9"]]
        {
            let cli = parse(args.iter().map(Into::into)).expect("a scene to show");
            assert!(
                matches!(&cli.command, Some(Command::Show(show)) if show.scene == Some("a.nff".into())),
                "{args:?}"
            );
        }
        assert!(parse(["rta"].map(Into::into)).expect("the Juggler").command.is_none());
        for args in [["rta", "rendr"], ["rta", "--help"], ["rta", "-V"], ["rta", "help"]] {
            assert!(parse(args.map(Into::into)).is_err(), "{args:?}");
        }
    }

    #[test]
    fn what_others_call_an_option_is_none_of_ours() {
        let all = Cli::command();
        for name in NOWHERE.iter().take(3).flat_map(|(names, ..)| names.split(' ')) {
            assert!(!all.get_subcommands().any(|command| has(command, name)), "{name}");
        }
        for (ours, tip, names) in ELSEWHERE {
            // Another command may have an option of that name: `rta bake --palette`.
            for name in names.split(' ') {
                assert!(
                    !all.get_subcommands().any(|command| has(command, ours) && has(command, name)),
                    "{name}"
                );
            }
            let option = if ours == "output" { "-o" } else { &format!("--{ours}") };
            assert!(
                tip.starts_with(option) && all.get_subcommands().any(|command| has(command, ours)),
                "{ours}"
            );
        }
    }
}
