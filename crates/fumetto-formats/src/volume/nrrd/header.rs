//! The header: lines of text up to an empty one.

use glam::{DMat4, DVec3, DVec4};

use crate::excerpt::excerpt;
use crate::volume::array::{Number, malformed};
use crate::{FormatError, Position};

/// What of a header counts here.
pub(super) struct Header {
    pub(super) number: Number,
    pub(super) encoding: Encoding,
    pub(super) big_endian: bool,
    /// Bytes before the numbers; -1 if those are the file's last bytes.
    pub(super) byte_skip: i64,
    sizes: Vec<u32>,
    /// The distance of voxels, or the way from one to the next, along each axis; `None` is not told.
    spacings: Vec<Option<f64>>,
    directions: Vec<Option<DVec3>>,
    origin: Option<DVec3>,
}

/// How numbers are written.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Encoding {
    Raw,
    Gzip,
    Text,
}

impl Header {
    /// Reads the header; what follows it are the numbers.
    pub(super) fn read<'a>(file: &str, bytes: &'a [u8]) -> Result<(Self, &'a [u8]), FormatError> {
        if !bytes.starts_with(b"NRRD000") {
            return Err(malformed(
                file,
                "not an NRRD file: its first line does not start with `NRRD000`".to_owned(),
            ));
        }
        let mut header = Self {
            number: Number::F32,
            encoding: Encoding::Raw,
            big_endian: false,
            byte_skip: 0,
            sizes: Vec::new(),
            spacings: Vec::new(),
            directions: Vec::new(),
            origin: None,
        };
        let mut found = [false; 3];
        let mut rest = bytes;
        for number in 1.. {
            let Some(end) = rest.iter().position(|&byte| byte == b'\n') else {
                let problem =
                    "the file ends before an empty line ends its header; it is cut off, so export it again";
                return Err(malformed(file, problem.to_owned()));
            };
            let line = String::from_utf8_lossy(rest[..end].trim_ascii()).into_owned();
            rest = &rest[end + 1..];
            if line.is_empty() {
                break;
            }
            // Comments, and values that are anybody's.
            if number == 1 || line.starts_with('#') || line.contains(":=") {
                continue;
            }
            let understood = header.take(&line, &mut found);
            understood.map_err(|problem| FormatError::Malformed {
                file: file.to_owned(),
                position: Some(Position::Line(number)),
                problem: format!("`{}`: {problem}", excerpt(line.as_bytes())),
            })?;
        }
        for (found, field) in found.iter().zip(["type", "sizes", "encoding"]) {
            if !found {
                return Err(malformed(
                    file,
                    format!("its header has no line `{field}`; export the file again"),
                ));
            }
        }
        Ok((header, rest))
    }

    /// Takes a line of the header, and notes which of type, sizes and encoding it tells.
    fn take(&mut self, line: &str, found: &mut [bool; 3]) -> Result<(), &'static str> {
        let (field, value) = line.split_once(':').ok_or("a line is `field: value`; export the file again")?;
        let value = value.trim();
        match field.trim().to_ascii_lowercase().as_str() {
            "type" => {
                self.number = number(value).ok_or("this type is not read; export numbers")?;
                found[0] = true;
            }
            "sizes" => {
                let sizes: Option<_> = value.split_whitespace().map(|size| size.parse().ok()).collect();
                self.sizes = sizes.ok_or("sizes are counts of voxels; export the file again")?;
                found[1] = true;
            }
            "encoding" => {
                self.encoding = encoding(value).ok_or("this encoding is not read; export raw or gzip")?;
                found[2] = true;
            }
            "endian" => self.big_endian = value.eq_ignore_ascii_case("big"),
            "spacings" => {
                let spacing = |word: &str| word.parse().ok().filter(|spacing: &f64| spacing.is_finite());
                self.spacings = value.split_whitespace().map(spacing).collect();
            }
            "space directions" => self.directions = vectors(value),
            "space origin" => self.origin = vectors(value).into_iter().next().flatten(),
            "byte skip" | "byteskip" => {
                let skip = value.parse().ok().filter(|skip| *skip >= -1);
                self.byte_skip = skip.ok_or("as many bytes cannot be skipped; export the file again")?;
            }
            "line skip" | "lineskip" if value != "0" => {
                return Err("lines are not skipped; export raw or gzip");
            }
            "data file" | "datafile" => {
                return Err(
                    "the numbers are in another file; export them into one, with the extension `.nrrd`",
                );
            }
            _ => {}
        }
        Ok(())
    }

    /// Voxels along each axis, and numbers of a voxel.
    pub(super) fn shape(&self, file: &str) -> Result<([u32; 3], usize), FormatError> {
        match self.sizes[..] {
            [x, y, z] => Ok(([x, y, z], 1)),
            [channels @ (1 | 3), x, y, z] => Ok(([x, y, z], channels as usize)),
            _ => {
                let problem = "and volumes have three, behind one of length 3 if they hold vectors";
                Err(malformed(
                    file,
                    format!("its axes have the sizes {}, {problem}", excerpt_sizes(&self.sizes)),
                ))
            }
        }
    }

    /// Where voxels are; `None` if neither spacings nor directions are told.
    pub(super) fn world_from_index(&self) -> Option<DMat4> {
        // The axes of space are the last ones.
        let along = |axis: usize| {
            let place = (self.sizes.len() + axis).checked_sub(3)?;
            let direction = self.directions.get(place).copied().flatten();
            let spacing = self.spacings.get(place).copied().flatten();
            direction.or_else(|| spacing.map(|spacing| DVec3::AXES[axis] * spacing))
        };
        let axes = [along(0), along(1), along(2)];
        if axes == [None; 3] && self.origin.is_none() {
            return None;
        }
        let column = |axis: usize| axes[axis].unwrap_or(DVec3::AXES[axis]).extend(0.0);
        let origin = self.origin.unwrap_or_default();
        Some(DMat4::from_cols(column(0), column(1), column(2), DVec4::from((origin, 1.0))))
    }
}

/// The type of a name: of C, or with its size in it.
fn number(name: &str) -> Option<Number> {
    Some(match name {
        "uchar" | "unsigned char" | "uint8" | "uint8_t" => Number::U8,
        "signed char" | "int8" | "int8_t" => Number::I8,
        "ushort" | "unsigned short" | "unsigned short int" | "uint16" | "uint16_t" => Number::U16,
        "short" | "short int" | "signed short" | "signed short int" | "int16" | "int16_t" => Number::I16,
        "uint" | "unsigned int" | "uint32" | "uint32_t" => Number::U32,
        "int" | "signed int" | "int32" | "int32_t" => Number::I32,
        "ulonglong" | "unsigned long long" | "unsigned long long int" | "uint64" | "uint64_t" => Number::U64,
        "longlong" | "long long" | "long long int" | "signed long long" | "int64" | "int64_t" => Number::I64,
        "float" => Number::F32,
        "double" => Number::F64,
        _ => return None,
    })
}

fn encoding(name: &str) -> Option<Encoding> {
    match name.to_ascii_lowercase().as_str() {
        "raw" => Some(Encoding::Raw),
        "gzip" | "gz" => Some(Encoding::Gzip),
        "ascii" | "text" | "txt" => Some(Encoding::Text),
        _ => None,
    }
}

/// Vectors such as `(1,0,0) none (0,2.5,0)`; what is no vector of three numbers is `None`.
fn vectors(text: &str) -> Vec<Option<DVec3>> {
    let mut vectors = Vec::new();
    let mut rest = text.trim_start();
    while !rest.is_empty() {
        let end = if rest.starts_with('(') {
            rest.find(')').map(|end| end + 1)
        } else {
            rest.find(char::is_whitespace)
        };
        let (word, after) = rest.split_at(end.unwrap_or(rest.len()));
        let numbers: Vec<f64> = word
            .trim_matches(['(', ')'])
            .split(',')
            .filter_map(|number| number.trim().parse().ok())
            .collect();
        vectors.push(<[f64; 3]>::try_from(numbers).ok().map(DVec3::from_array));
        rest = after.trim_start();
    }
    vectors
}

/// The sizes as a line tells them.
fn excerpt_sizes(sizes: &[u32]) -> String {
    let words: Vec<_> = sizes.iter().take(8).map(u32::to_string).collect();
    format!("`{}`", excerpt(words.join(" ").as_bytes()))
}
