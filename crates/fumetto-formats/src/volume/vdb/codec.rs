//! How arrays are packed: not at all, by zlib, or by Blosc (OpenVDB's `io/Compression.cc`).

use flate2::{Decompress, FlushDecompress, Status};

use super::bytes::Bytes;
use super::{Trouble, blosc};

/// How a grid's arrays are packed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Compression {
    pub(super) codec: Codec,
    /// Whether inactive values are left out.
    pub(super) active_mask: bool,
}

/// What makes arrays smaller.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Codec {
    None,
    Zip,
    Blosc,
}

/// The bits that a grid's compression is stored as.
pub(super) const ZIP: u32 = 0x1;
pub(super) const ACTIVE_MASK: u32 = 0x2;
const BLOSC: u32 = 0x4;

impl Compression {
    pub(super) fn read(bytes: &mut Bytes<'_>) -> Result<Self, Trouble> {
        let flags = bytes.u32()?;
        if flags & !(ZIP | ACTIVE_MASK | BLOSC) != 0 {
            return Err(Trouble::Unsupported(format!(
                "its compression {flags:#x} is not known; save it with zip or Blosc, or without compression"
            )));
        }
        let codec = match flags {
            _ if flags & BLOSC != 0 => Codec::Blosc,
            _ if flags & ZIP != 0 => Codec::Zip,
            _ => Codec::None,
        };
        Ok(Self { codec, active_mask: flags & ACTIVE_MASK != 0 })
    }
}

impl Codec {
    /// Fills `out` with an array.
    pub(super) fn read(self, bytes: &mut Bytes<'_>, out: &mut [u8]) -> Result<(), Trouble> {
        if self == Self::None {
            out.copy_from_slice(bytes.take(out.len())?);
            return Ok(());
        }
        let stored = bytes.i64()?;
        // A negative count is that of bytes that could not be made fewer.
        let length = usize::try_from(stored.unsigned_abs()).unwrap_or(usize::MAX);
        let packed = bytes.take(length)?;
        let done = match self {
            _ if stored <= 0 => copy(packed, out),
            Self::Blosc => blosc::decompress(packed, out),
            Self::Zip | Self::None => inflate(packed, out),
        };
        done.map_err(|problem| {
            Trouble::Damaged(format!("a node cannot be decompressed ({problem}); export the file again"))
        })
    }
}

/// Takes bytes as they are.
fn copy(packed: &[u8], out: &mut [u8]) -> Result<(), String> {
    if packed.len() != out.len() {
        return Err(format!("it has {} bytes instead of {}", packed.len(), out.len()));
    }
    out.copy_from_slice(packed);
    Ok(())
}

/// Unpacks what zlib packed.
pub(super) fn inflate(packed: &[u8], out: &mut [u8]) -> Result<(), String> {
    let mut inflater = Decompress::new(true);
    let status =
        inflater.decompress(packed, out, FlushDecompress::Finish).map_err(|error| error.to_string())?;
    if status != Status::StreamEnd || inflater.total_out() != out.len() as u64 {
        return Err(format!("it does not unpack to {} bytes", out.len()));
    }
    Ok(())
}
