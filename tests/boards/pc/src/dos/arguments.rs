//! The command line of a DOS program.

/// What the command line asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Wish<'a> {
    /// The scene of this number.
    Scene(usize),
    /// What the program can do.
    Help,
    /// Something that is no scene.
    Unknown(&'a [u8]),
}

/// Reads what stands after the program's name, with the blanks around it: the name of a scene in any case, the first of
/// them where it is empty.
pub(crate) fn wish<'a>(tail: &'a [u8], names: &[&str]) -> Wish<'a> {
    match tail.trim_ascii() {
        b"" => Wish::Scene(0),
        b"/?" => Wish::Help,
        word => {
            let place = names.iter().position(|name| word.eq_ignore_ascii_case(name.as_bytes()));
            place.map_or(Wish::Unknown(word), Wish::Scene)
        }
    }
}
