//! The imports of a source file, as paths from the root of its crate.

use core::iter::Peekable;
use core::str::Chars;

use super::Module;

/// A token of Rust, as far as imports need it.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Token {
    Word(String),
    /// `::`
    Path,
    Sign(char),
}

/// Returns what `source` imports by `use crate::`, `use super::` and `use self::`, also in groups: paths from the root of the
/// crate, of modules and of what is in them. `file` is the module that the file is.
pub(super) fn of(source: &str, file: &[String]) -> Vec<Module> {
    let tokens = tokens(source);
    let mut tokens = tokens.iter().peekable();
    let mut imports = Vec::new();
    // Modules within the file, with how many braces are open around each.
    let mut inner: Vec<(String, usize)> = Vec::new();
    let mut braces = 0;
    while let Some(token) = tokens.next() {
        match token {
            Token::Sign('{') => braces += 1,
            Token::Sign('}') => {
                braces -= 1;
                inner.retain(|(_, around)| *around < braces);
            }
            Token::Word(word) if word == "mod" => {
                if let Some(Token::Word(name)) = tokens.next()
                    && tokens.peek() == Some(&&Token::Sign('{'))
                {
                    inner.push((name.clone(), braces));
                }
            }
            Token::Word(word) if word == "use" => {
                let here: Module = file.iter().chain(inner.iter().map(|(name, _)| name)).cloned().collect();
                tree(&mut tokens, &[], &mut |path| imports.extend(absolute(&here, path)));
            }
            _ => {}
        }
    }
    imports
}

/// Reads a tree of imports up to its end, and calls `see` with each path in it.
fn tree<'t>(
    tokens: &mut Peekable<impl Iterator<Item = &'t Token>>,
    before: &[String],
    see: &mut dyn FnMut(&[String]),
) {
    let mut path = before.to_vec();
    let mut is_named = false;
    loop {
        match tokens.peek() {
            Some(Token::Word(word)) if word == "as" => is_named = true,
            Some(Token::Word(word)) if !is_named => path.push(word.clone()),
            Some(Token::Word(_) | Token::Path | Token::Sign('*')) => {}
            Some(Token::Sign('{')) => {
                tokens.next();
                while !matches!(tokens.peek(), None | Some(Token::Sign('}'))) {
                    tree(tokens, &path, see);
                    if tokens.peek() == Some(&&Token::Sign(',')) {
                        tokens.next();
                    }
                }
                tokens.next();
                return;
            }
            _ => {
                see(&path);
                return;
            }
        }
        tokens.next();
    }
}

/// Returns a path from the root of the crate, if it is one of the crate's own; `here` is the module that imports it.
fn absolute(here: &[String], path: &[String]) -> Option<Module> {
    let mut base = match path.first()?.as_str() {
        "crate" => Module::new(),
        "self" | "super" => here.to_vec(),
        _ => return None,
    };
    for part in path {
        match part.as_str() {
            "crate" | "self" => {}
            "super" => drop(base.pop()),
            _ => base.push(part.clone()),
        }
    }
    Some(base)
}

/// Returns the tokens of a source, without comments, strings and characters.
fn tokens(source: &str) -> Vec<Token> {
    let mut tokens = Vec::new();
    let mut chars = source.chars().peekable();
    while let Some(c) = chars.next() {
        match c {
            '/' if chars.peek() == Some(&'/') => while chars.next_if(|c| *c != '\n').is_some() {},
            '/' if chars.peek() == Some(&'*') => skip_comment(&mut chars),
            '"' => skip_string(&mut chars),
            'r' if matches!(chars.peek(), Some('"' | '#')) && skip_raw(&mut chars) => {}
            '\'' => skip_character(&mut chars),
            ':' if chars.next_if_eq(&':').is_some() => tokens.push(Token::Path),
            c if c.is_alphanumeric() || c == '_' => {
                let mut word = String::from(c);
                while let Some(c) = chars.next_if(|c| c.is_alphanumeric() || *c == '_') {
                    word.push(c);
                }
                tokens.push(Token::Word(word));
            }
            c if c.is_whitespace() => {}
            c => tokens.push(Token::Sign(c)),
        }
    }
    tokens
}

fn skip_comment(chars: &mut Peekable<Chars>) {
    let mut open = 1;
    chars.next();
    while let Some(c) = chars.next() {
        match c {
            '/' if chars.next_if_eq(&'*').is_some() => open += 1,
            '*' if chars.next_if_eq(&'/').is_some() => open -= 1,
            _ => {}
        }
        if open == 0 {
            return;
        }
    }
}

fn skip_string(chars: &mut Peekable<Chars>) {
    while let Some(c) = chars.next() {
        match c {
            '\\' => drop(chars.next()),
            '"' => return,
            _ => {}
        }
    }
}

/// Skips a raw string after its `r`; false where it is a raw name.
fn skip_raw(chars: &mut Peekable<Chars>) -> bool {
    let mut hashes = 0;
    while chars.next_if_eq(&'#').is_some() {
        hashes += 1;
    }
    if chars.next_if_eq(&'"').is_none() {
        return false;
    }
    while let Some(c) = chars.next() {
        if c == '"' && (0..hashes).all(|_| chars.next_if_eq(&'#').is_some()) {
            break;
        }
    }
    true
}

/// Skips a character after its quote; of a lifetime, only that.
fn skip_character(chars: &mut Peekable<Chars>) {
    let mut ahead = chars.clone();
    let length = match (ahead.next(), ahead.next()) {
        (Some('\\'), Some(_)) => 2 + ahead.take_while(|c| *c != '\'').count() + 1,
        (Some(_), Some('\'')) => 2,
        _ => return,
    };
    for _ in 0..length {
        chars.next();
    }
}

#[test]
fn imports_are_read() {
    let source = "
        //! use crate::not::this;
        /* use crate::nor::this; /* nested */ use crate::nor::that; */
        use std::fs;
        pub(crate) use crate::a::{b::C, d::{self, E as F}, g::*};
        use super::h;
        const TEXT: &str = \"use crate::text;\"; const RAW: &str = r#\"use crate::raw;\"#;
        fn quoted<'a>(c: char) -> bool { c == '\"' || c == '\\'' }
        mod inner {
            use super::i;
            use self::j;
            mod innermost { use super::super::{k, l}; }
        }
        use self::{m, crate_like::n};
        macro_rules! path { () => { $crate::o::p } }
    ";
    let file = ["x", "y"].map(str::to_owned);
    let found: Vec<_> = of(source, &file).iter().map(|path| path.join("::")).collect();
    let wanted = [
        "a::b::C",
        "a::d",
        "a::d::E",
        "a::g",
        "x::h",
        "x::y::i",
        "x::y::inner::j",
        "x::y::k",
        "x::y::l",
        "x::y::m",
        "x::y::crate_like::n",
    ];
    assert_eq!(found, wanted);
}
