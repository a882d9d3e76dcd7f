//! Caches of simulated frames: a file a frame, of numbers only Fumetto itself can make sense of.
//!
//! ```text
//! "fumetto cache\n" · version · fingerprint · frame · LZ4 frame of the parts · CRC-32 of all before it
//! ```
//!
//! All numbers are little-endian. The bytes of a part's 32-bit words are sorted by their place in the word, first all
//! lowest ones: those of floating-point numbers that are alike then lie together, and become smaller.

use std::io::{self, Read, Write};

use flate2::{Crc, CrcWriter};
use lz4_flex::frame::{FrameDecoder, FrameEncoder};

/// What every such file begins with.
const MAGIC: &[u8; 14] = b"fumetto cache\n";

/// Of the file's layout and of the simulation: numbers of another version mean something else.
const VERSION: u32 = 1;

/// Bytes before the parts.
const HEADER: usize = MAGIC.len() + 4 + 16 + 4;

/// More parts than any scene has.
const MOST_PARTS: u32 = 1 << 16;

/// The state of a simulation at one frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CachedFrame {
    /// Of the scene that was simulated: equal where the simulation is.
    pub fingerprint: u128,
    /// From 0.
    pub frame: u32,
    /// The contents of buffers, each a number of 32-bit words.
    pub parts: Vec<Vec<u8>>,
}

/// Why a file is no frame of a cache. The caller knows the file's name.
#[derive(Debug, thiserror::Error)]
pub enum CacheError {
    /// It begins otherwise.
    #[error("this is no cache of Fumetto's; leave it out, or name another folder")]
    Foreign,
    /// It was written by another version.
    #[error("this cache is of version {found}, and {VERSION} is read here; bake it anew into another folder")]
    Version {
        /// As the file says.
        found: u32,
    },
    /// It ends too early, or was changed.
    #[error("this cache is damaged ({0}); delete the file and bake again")]
    Damaged(String),
}

/// Writes a frame of a cache.
///
/// # Errors
/// When `out` does not take it.
pub fn write_cached_frame(cached: &CachedFrame, out: impl Write) -> io::Result<()> {
    let mut out = CrcWriter::new(out);
    out.write_all(MAGIC)?;
    out.write_all(&VERSION.to_le_bytes())?;
    out.write_all(&cached.fingerprint.to_le_bytes())?;
    out.write_all(&cached.frame.to_le_bytes())?;
    let mut packed = FrameEncoder::new(&mut out);
    packed.write_all(&(cached.parts.len() as u32).to_le_bytes())?;
    for part in &cached.parts {
        packed.write_all(&(part.len() as u64).to_le_bytes())?;
        packed.write_all(&sorted(part))?;
    }
    packed.finish()?;
    let sum = out.crc().sum();
    let mut out = out.into_inner();
    out.write_all(&sum.to_le_bytes())?;
    out.flush()
}

/// Reads a frame of a cache. Asks for no more memory than the file's content takes.
///
/// # Errors
/// When `bytes` are something else, of another version, or damaged.
pub fn read_cached_frame(bytes: &[u8]) -> Result<CachedFrame, CacheError> {
    let fingerprint = read_cache_fingerprint(bytes)?;
    let content = summed(bytes)?;
    let frame = u32::from_le_bytes(array(&content[HEADER - 4..])?);
    let damaged = |error: io::Error| CacheError::Damaged(error.to_string());
    let mut packed = FrameDecoder::new(&content[HEADER..]);
    let count = u32::from_le_bytes(next(&mut packed).map_err(damaged)?);
    if count > MOST_PARTS {
        return Err(CacheError::Damaged(format!("it has {count} parts")));
    }
    let mut parts = Vec::new();
    for _ in 0..count {
        let length = u64::from_le_bytes(next(&mut packed).map_err(damaged)?);
        let mut part = Vec::new();
        (&mut packed).take(length).read_to_end(&mut part).map_err(damaged)?;
        if part.len() as u64 != length {
            return Err(CacheError::Damaged("a part ends too early".to_owned()));
        }
        parts.push(restored(&part));
    }
    Ok(CachedFrame { fingerprint, frame, parts })
}

/// The fingerprint of a cached frame, of which the first bytes will do.
///
/// # Errors
/// When `bytes` begin otherwise or are too few.
pub fn read_cache_fingerprint(bytes: &[u8]) -> Result<u128, CacheError> {
    if !bytes.starts_with(MAGIC) {
        return Err(CacheError::Foreign);
    }
    if bytes.len() < HEADER {
        return Err(CacheError::Damaged("it ends too early".to_owned()));
    }
    let found = u32::from_le_bytes(array(&bytes[MAGIC.len()..])?);
    if found != VERSION {
        return Err(CacheError::Version { found });
    }
    Ok(u128::from_le_bytes(array(&bytes[MAGIC.len() + 4..])?))
}

/// What the checksum at the end is of, if it is right.
fn summed(bytes: &[u8]) -> Result<&[u8], CacheError> {
    let (content, sum) =
        bytes.split_last_chunk().ok_or_else(|| CacheError::Damaged("it ends too early".to_owned()))?;
    let mut crc = Crc::new();
    crc.update(content);
    if content.len() < HEADER || crc.sum() != u32::from_le_bytes(*sum) {
        return Err(CacheError::Damaged("its checksum is wrong".to_owned()));
    }
    Ok(content)
}

/// Bytes of a file that tell its fingerprint.
pub const CACHE_HEADER_BYTES: usize = HEADER;

fn array<const N: usize>(bytes: &[u8]) -> Result<[u8; N], CacheError> {
    bytes.first_chunk().copied().ok_or_else(|| CacheError::Damaged("it ends too early".to_owned()))
}

fn next<const N: usize>(from: &mut impl Read) -> io::Result<[u8; N]> {
    let mut bytes = [0; N];
    from.read_exact(&mut bytes)?;
    Ok(bytes)
}

/// All first bytes of words, all second ones, and so on; then what is left.
fn sorted(part: &[u8]) -> Vec<u8> {
    let (words, rest) = part.as_chunks::<4>();
    let planes = (0..4).flat_map(|place| words.iter().map(move |word| word[place]));
    planes.chain(rest.iter().copied()).collect()
}

/// The part of which `sorted` made this.
fn restored(planes: &[u8]) -> Vec<u8> {
    let count = planes.len() / 4;
    let (sorted, rest) = planes.split_at(4 * count);
    let words = (0..count).flat_map(|at| [0, 1, 2, 3].map(|place| sorted[place * count + at]));
    words.chain(rest.iter().copied()).collect()
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]
mod tests {
    use super::*;

    fn cached() -> CachedFrame {
        let floats: Vec<u8> = (0..1000).flat_map(|n| (n as f32 * 0.1).to_le_bytes()).collect();
        CachedFrame {
            fingerprint: 7 << 90,
            frame: 12,
            parts: vec![floats, vec![], vec![0; 4096], vec![1, 2, 3]],
        }
    }

    fn written(cached: &CachedFrame) -> Vec<u8> {
        let mut bytes = Vec::new();
        write_cached_frame(cached, &mut bytes).unwrap();
        bytes
    }

    #[test]
    fn what_is_written_is_read() {
        let cached = cached();
        let bytes = written(&cached);
        assert_eq!(read_cached_frame(&bytes).unwrap(), cached);
        assert_eq!(read_cache_fingerprint(&bytes[..CACHE_HEADER_BYTES]).unwrap(), 7 << 90);
        let raw: usize = cached.parts.iter().map(Vec::len).sum();
        assert!(bytes.len() < raw / 2, "{} of {raw}", bytes.len());
    }

    #[test]
    fn any_damage_is_told() {
        let bytes = written(&cached());
        for length in 0..bytes.len() {
            assert!(read_cached_frame(&bytes[..length]).is_err(), "{length}");
        }
        for at in 0..bytes.len() {
            let mut changed = bytes.clone();
            changed[at] ^= 0x10;
            assert!(read_cached_frame(&changed).is_err(), "{at}");
        }
        assert!(matches!(read_cached_frame(b"\x89PNG"), Err(CacheError::Foreign)));
        let mut newer = bytes;
        newer[MAGIC.len()] = 9;
        assert!(matches!(read_cached_frame(&newer), Err(CacheError::Version { found: 9 })));
    }
}
