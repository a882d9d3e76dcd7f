//! Arrays of `numpy` (`.npy`), after its `numpy.lib.format`: versions 1 to 3.
//!
//! `array[x, y, z]` is the voxel (x, y, z), as for OpenVDB's own `copyFromArray`; a fourth axis of length 3
//! holds the components of vectors.

use super::array::{Array, Number, malformed};
use super::dense::Strides;
use super::grid::Volume;
use crate::FormatError;
use crate::excerpt::excerpt;

/// How arrays are stored, as the header's dictionary tells it.
struct Header {
    number: Number,
    big_endian: bool,
    /// Whether the first axis is the one along which numbers follow each other.
    fortran_order: bool,
    shape: Vec<u32>,
}

/// Reads an array of three axes, or of vectors on three axes.
pub(super) fn read(file: &str, bytes: &[u8]) -> Result<Volume, FormatError> {
    let malformed = |problem: String| malformed(file, problem);
    let (text, body) = split(bytes).ok_or_else(|| {
        malformed("not a whole npy file of version 1, 2 or 3; write it again with `numpy.save`".to_owned())
    })?;
    let header = Header::parse(&text).map_err(malformed)?;
    let (size, channels) = match header.shape[..] {
        [x, y, z] => ([x, y, z], 1),
        [x, y, z, channels @ (1 | 3)] => ([x, y, z], channels as usize),
        _ => {
            let problem =
                format!("its shape is {:?}, and volumes have (x, y, z) or (x, y, z, 3)", header.shape);
            return Err(malformed(problem));
        }
    };
    let array = Array { file, size, channels, world_from_index: None };
    let length = array.count()? * header.number.size();
    let numbers = body.get(..length).ok_or_else(|| {
        malformed(format!(
            "its array takes {length} bytes, but only {} follow; the file is cut off",
            body.len()
        ))
    })?;
    let [x, y, z] = size.map(|side| side as usize);
    let strides = if header.fortran_order {
        Strides { axes: [1, x, x * y], channel: x * y * z }
    } else {
        Strides { axes: [channels * z * y, channels * z, channels], channel: 1 }
    };
    array.volume(header.number.decode(numbers, header.big_endian), strides)
}

/// The header's text, and what follows it.
fn split(bytes: &[u8]) -> Option<(String, &[u8])> {
    let bytes = bytes.strip_prefix(b"\x93NUMPY")?;
    let (&[major, _minor], bytes) = bytes.split_first_chunk()?;
    let (length, bytes) = match major {
        1 => bytes.split_first_chunk().map(|(length, rest)| (u16::from_le_bytes(*length).into(), rest))?,
        2 | 3 => {
            bytes.split_first_chunk().map(|(length, rest)| (u32::from_le_bytes(*length) as usize, rest))?
        }
        _ => return None,
    };
    let (text, body) = bytes.split_at_checked(length)?;
    Some((String::from_utf8_lossy(text).into_owned(), body))
}

impl Header {
    /// Reads the dictionary, such as `{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3, 4), }`.
    fn parse(text: &str) -> Result<Self, String> {
        let value = |key: &str| {
            let (_, after) = text.split_once(&format!("'{key}':"))?;
            Some(after.trim_start())
        };
        let missing =
            |key: &str| format!("its header does not tell its `{key}`; write it again with `numpy.save`");
        let kind = value("descr").and_then(|text| text.strip_prefix('\'')?.split('\'').next());
        let kind = kind.ok_or_else(|| missing("descr"))?;
        let (order, kind) = kind.split_at_checked(1).unwrap_or(("", kind));
        let number = match kind {
            "b1" | "u1" => Number::U8,
            "i1" => Number::I8,
            "u2" => Number::U16,
            "i2" => Number::I16,
            "u4" => Number::U32,
            "i4" => Number::I32,
            "u8" => Number::U64,
            "i8" => Number::I64,
            "f2" => Number::F16,
            "f4" => Number::F32,
            "f8" => Number::F64,
            _ => {
                let kind = excerpt(kind.as_bytes());
                return Err(format!("its numbers are of type `{kind}`, which is not read; write it as `f4`"));
            }
        };
        let fortran_order = match value("fortran_order") {
            Some(text) if text.starts_with("True") => true,
            Some(text) if text.starts_with("False") => false,
            _ => return Err(missing("fortran_order")),
        };
        let shape = value("shape").and_then(|text| text.strip_prefix('(')?.split(')').next());
        let sides =
            shape.ok_or_else(|| missing("shape"))?.split(',').map(str::trim).filter(|side| !side.is_empty());
        let shape: Option<_> = sides.map(|side| side.parse().ok()).collect();
        let shape = shape.ok_or_else(|| missing("shape"))?;
        Ok(Self { number, big_endian: order == ">", fortran_order, shape })
    }
}
