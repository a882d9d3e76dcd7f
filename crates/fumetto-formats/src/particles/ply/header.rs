//! The header: which elements the file holds, how many of each, and what their rows are made of.

use std::str::SplitWhitespace;

use crate::excerpt::excerpt;
use crate::{FormatError, Position};

/// A header that was understood.
pub(super) struct Header {
    pub(super) encoding: Encoding,
    elements: Vec<Element>,
    /// Its length in bytes: where the rows start.
    pub(super) length: usize,
    /// Its length in lines.
    pub(super) lines: u64,
    /// The last byte of every line.
    pub(super) line_end: u8,
}

/// How rows are written.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Encoding {
    Ascii,
    LittleEndian,
    BigEndian,
}

/// A kind of row.
pub(super) struct Element {
    name: String,
    pub(super) count: u64,
    pub(super) properties: Vec<Property>,
}

/// A value of a row, or a list of values.
pub(super) struct Property {
    name: String,
    pub(super) kind: Kind,
}

/// What a property holds.
#[derive(Clone, Copy)]
pub(super) enum Kind {
    Scalar(Scalar),
    List { length: Scalar, item: Scalar },
}

/// The types of numbers.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Header {
    /// Reads the header at the start of `bytes`.
    pub(super) fn read(file: &str, bytes: &[u8]) -> Result<Self, FormatError> {
        let mut lines = Lines::new(bytes);
        let malformed = |line: u64, problem: String| FormatError::Malformed {
            file: file.to_owned(),
            position: Some(Position::Line(line)),
            problem,
        };
        if lines.next().as_deref().map(str::trim) != Some("ply") {
            return Err(malformed(1, "not a PLY file: its first line is not `ply`".to_owned()));
        }
        let mut encoding = None;
        let mut elements: Vec<Element> = Vec::new();
        loop {
            let Some(line) = lines.next() else {
                let problem = "the file ends before `end_header`; it is cut off, so export or copy it again";
                return Err(malformed(lines.number, problem.to_owned()));
            };
            let mut words = line.split_whitespace();
            let understood = match words.next() {
                Some("format") => Encoding::parse(words).map(|found| encoding = Some(found)),
                Some("element") => Element::parse(words).map(|element| elements.push(element)),
                Some("property") => Property::parse(words).and_then(|property| {
                    elements.last_mut().map(|element| element.properties.push(property))
                }),
                Some("comment" | "obj_info") | None => Some(()),
                Some("end_header") => break,
                Some(_) => None,
            };
            if understood.is_none() {
                let problem = format!(
                    "`{}` is no line of a PLY header; export the file again",
                    excerpt(line.trim().as_bytes())
                );
                return Err(malformed(lines.number, problem));
            }
        }
        let encoding = encoding.ok_or_else(|| {
            malformed(lines.number, "the header has no line `format`; export the file again".to_owned())
        })?;
        Ok(Self { encoding, elements, length: lines.consumed, lines: lines.number, line_end: lines.end })
    }

    /// The element `vertex`, and those whose rows come before it.
    pub(super) fn vertex(&self) -> Option<(&Element, &[Element])> {
        let at = self.elements.iter().position(|element| element.name == "vertex")?;
        Some((&self.elements[at], &self.elements[..at]))
    }
}

impl Encoding {
    fn parse(mut words: SplitWhitespace<'_>) -> Option<Self> {
        match words.next()? {
            "ascii" => Some(Self::Ascii),
            "binary_little_endian" => Some(Self::LittleEndian),
            "binary_big_endian" => Some(Self::BigEndian),
            _ => None,
        }
    }
}

impl Element {
    fn parse(mut words: SplitWhitespace<'_>) -> Option<Self> {
        let name = words.next()?.to_owned();
        let count = words.next()?.parse().ok()?;
        Some(Self { name, count, properties: Vec::new() })
    }

    /// The name, fit for a message.
    pub(super) fn shown_name(&self) -> String {
        excerpt(self.name.as_bytes())
    }

    /// The fewest bytes that a row can take.
    pub(super) fn least_row_bytes(&self, encoding: Encoding) -> u64 {
        let least = |property: &Property| match (encoding, property.kind) {
            (Encoding::Ascii, _) => 2, // a digit and a separator
            (_, Kind::Scalar(scalar) | Kind::List { length: scalar, .. }) => scalar.size() as u64,
        };
        self.properties.iter().map(least).sum()
    }

    /// Its row's size in binary, if all rows have the same.
    pub(super) fn fixed_row_bytes(&self) -> Option<usize> {
        let size = |property: &Property| match property.kind {
            Kind::Scalar(scalar) => Some(scalar.size()),
            Kind::List { .. } => None,
        };
        self.properties.iter().map(size).sum()
    }
}

impl Property {
    fn parse(mut words: SplitWhitespace<'_>) -> Option<Self> {
        let kind = match words.next()? {
            "list" => {
                let length = Scalar::parse(words.next()?)?;
                let item = Scalar::parse(words.next()?)?;
                if matches!(length, Scalar::F32 | Scalar::F64) {
                    return None;
                }
                Kind::List { length, item }
            }
            scalar => Kind::Scalar(Scalar::parse(scalar)?),
        };
        Some(Self { name: words.next()?.to_owned(), kind })
    }

    /// The name that a particle's value is looked up by: a list is none.
    pub(super) fn column_name(&self) -> String {
        match self.kind {
            Kind::Scalar(_) => self.name.clone(),
            Kind::List { .. } => format!("list {}", self.name),
        }
    }
}

impl Scalar {
    /// The type of a name: the format's own, or the one with the size in it that many programs write.
    fn parse(name: &str) -> Option<Self> {
        Some(match name {
            "char" | "int8" => Self::I8,
            "uchar" | "uint8" => Self::U8,
            "short" | "int16" => Self::I16,
            "ushort" | "uint16" => Self::U16,
            "int" | "int32" => Self::I32,
            "uint" | "uint32" => Self::U32,
            "float" | "float32" => Self::F32,
            "double" | "float64" => Self::F64,
            _ => return None,
        })
    }

    /// Its size in bytes.
    pub(super) fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }
}

/// The lines of a header: their end is the first one's, as what follows `end_header` may be binary.
struct Lines<'a> {
    rest: &'a [u8],
    end: u8,
    consumed: usize,
    number: u64,
}

impl<'a> Lines<'a> {
    fn new(bytes: &'a [u8]) -> Self {
        let first_end = bytes.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
        let old_mac = first_end.is_some_and(|at| bytes[at] == b'\r' && bytes.get(at + 1) != Some(&b'\n'));
        Self { rest: bytes, end: if old_mac { b'\r' } else { b'\n' }, consumed: 0, number: 0 }
    }

    /// The next line that has an end. Comments need not be UTF-8.
    fn next(&mut self) -> Option<String> {
        let length = self.rest.iter().position(|&byte| byte == self.end)? + 1;
        let (line, rest) = self.rest.split_at(length);
        self.rest = rest;
        self.consumed += length;
        self.number += 1;
        Some(String::from_utf8_lossy(line).into_owned())
    }
}
