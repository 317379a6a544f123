//! ELF files of images: sizes of sections, names of functions, and bytes by address.

use std::collections::BTreeSet;

use object::{Object, ObjectSection, ObjectSegment, ObjectSymbol, SectionFlags, SectionKind, SymbolKind};

use super::Failure;

/// Bytes of an image by kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sizes {
    /// Code.
    pub text: u64,
    /// Constants.
    pub rodata: u64,
    /// Static RAM: initialised and zeroed variables.
    pub ram: u64,
}

/// Returns the sums of the sections' sizes of an ELF file; symbols and notes for debuggers do not count.
///
/// # Errors
/// The bytes are no ELF file.
pub fn sizes(file: &[u8]) -> Result<Sizes, Failure> {
    let mut sizes = Sizes::default();
    for section in object::File::parse(file)?.sections() {
        let SectionFlags::Elf { sh_flags } = section.flags() else { continue };
        if sh_flags & u64::from(object::elf::SHF_ALLOC) == 0 || section.name()?.starts_with(".stack") {
            continue;
        }
        let total = match section.kind() {
            SectionKind::Text => &mut sizes.text,
            SectionKind::Data | SectionKind::UninitializedData => &mut sizes.ram,
            _ => &mut sizes.rodata,
        };
        *total += section.size();
    }
    Ok(sizes)
}

/// Returns whether the name of a function of an image has `word` in it.
///
/// # Errors
/// The bytes are no ELF file.
pub fn mentions(file: &[u8], word: &str) -> Result<bool, Failure> {
    let elf = object::File::parse(file)?;
    Ok(elf.symbols().any(|symbol| {
        symbol.kind() == SymbolKind::Text && symbol.name().is_ok_and(|name| name.contains(word))
    }))
}

/// Returns the source files in a folder that the code of an image is from, inlined code too, by their paths from the folder's name on: the
/// file names of the image's line table, which names no file without code.
///
/// # Errors
/// The bytes are no ELF file.
pub fn sources(file: &[u8], folder: &str) -> Result<BTreeSet<String>, Failure> {
    let mut found = BTreeSet::new();
    for section in object::File::parse(file)?.sections() {
        // The names are in the table itself up to DWARF 4, from DWARF 5 on beside it.
        if !matches!(section.name()?, ".debug_line" | ".debug_line_str") {
            continue;
        }
        for text in section.data()?.split(|&byte| byte == 0).filter_map(|text| str::from_utf8(text).ok()) {
            let path = text.find(folder).and_then(|start| text.get(start..));
            found.extend(path.filter(|path| path.ends_with(".rs")).map(str::to_owned));
        }
    }
    Ok(found)
}

/// Returns the contents of the loadable segments as one block of memory, from the address `base` on.
///
/// # Errors
/// The bytes are no ELF file, or a segment lies below `base` or takes more than 4 MiB.
pub fn flat(file: &[u8], base: u64) -> Result<Vec<u8>, Failure> {
    let elf = object::read::elf::ElfFile32::<object::Endianness>::parse(file)?;
    let endian = elf.endian();
    let mut memory = Vec::new();
    for segment in elf.segments() {
        let bytes = segment.data()?;
        if bytes.is_empty() {
            continue;
        }
        let address = u64::from(segment.elf_program_header().p_paddr.get(endian));
        let start = address.checked_sub(base).and_then(|start| usize::try_from(start).ok());
        let start =
            start.filter(|start| start + bytes.len() <= 4 << 20).ok_or("a segment is out of reach")?;
        if memory.len() < start + bytes.len() {
            memory.resize(start + bytes.len(), 0);
        }
        memory.iter_mut().skip(start).zip(bytes).for_each(|(to, from)| *to = *from);
    }
    Ok(memory)
}
