//! The two parts of a binary glTF file (glTF 2.0, section 4).

use crate::FormatError;

const MAGIC: &[u8] = b"glTF";
const JSON: u32 = u32::from_le_bytes(*b"JSON");
const BINARY: u32 = u32::from_le_bytes(*b"BIN\0");

/// What Windows programs start UTF-8 with, though glTF forbids it.
const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// A file's JSON, and the bytes of its first buffer if it holds them.
pub(super) struct Container<'a> {
    pub(super) json: &'a [u8],
    pub(super) binary: Option<&'a [u8]>,
}

impl<'a> Container<'a> {
    /// Takes a file of either kind apart: text is all JSON.
    pub(super) fn split(file: &str, bytes: &'a [u8]) -> Result<Self, FormatError> {
        let malformed =
            |problem: String| FormatError::Malformed { file: file.to_owned(), position: None, problem };
        let Some(after_magic) = bytes.strip_prefix(MAGIC) else {
            let json = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(bytes);
            return Ok(Self { json, binary: None });
        };
        let cut_off =
            || malformed("it is cut off within its first bytes; copy or export it again".to_owned());
        let (version, rest) = number(after_magic).ok_or_else(cut_off)?;
        let (length, rest) = number(rest).ok_or_else(cut_off)?;
        if version != 2 {
            return Err(malformed(format!("it is binary glTF {version}; export it as glTF 2.0")));
        }
        let missing = u64::from(length).saturating_sub(bytes.len() as u64);
        if missing > 0 {
            return Err(malformed(format!(
                "its header promises {length} bytes, of which the last {missing} are missing; copy or export it again"
            )));
        }

        // What follows after the promised length is none of the file's.
        let header = bytes.len() - rest.len();
        let rest = rest.get(..(length as usize).saturating_sub(header)).unwrap_or_default();
        let no_json = || malformed("it does not start with its JSON; export it again".to_owned());
        let (kind, json, rest) = chunk(rest).ok_or_else(no_json)?;
        if kind != JSON {
            return Err(no_json());
        }
        let binary = chunk(rest).and_then(|(kind, bytes, _)| (kind == BINARY).then_some(bytes));
        Ok(Self { json, binary })
    }
}

/// The first chunk's kind and bytes, and what follows it.
fn chunk(bytes: &[u8]) -> Option<(u32, &[u8], &[u8])> {
    let (length, rest) = number(bytes)?;
    let (kind, rest) = number(rest)?;
    let (body, rest) = rest.split_at_checked(length as usize)?;
    Some((kind, body, rest))
}

fn number(bytes: &[u8]) -> Option<(u32, &[u8])> {
    let (number, rest) = bytes.split_first_chunk::<4>()?;
    Some((u32::from_le_bytes(*number), rest))
}
