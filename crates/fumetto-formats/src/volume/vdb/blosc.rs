//! Blosc's container, format 2, with LZ4 or zlib inside and bytes shuffled: all that OpenVDB writes.
//!
//! After c-blosc's `README_HEADER.rst` and, for the splitting of blocks, `blosc_d` of its `blosc.c`.

use super::codec::inflate;

/// Bytes of the header.
const HEADER: usize = 16;

/// Types with more bytes are never split.
const MAX_SPLITS: usize = 16;

/// Blocks with fewer values are never split.
const MIN_SPLIT_VALUES: usize = 128;

/// The header's flags.
const SHUFFLED: u8 = 0x01;
const COPIED: u8 = 0x02;
const BIT_SHUFFLED: u8 = 0x04;
const NOT_SPLIT: u8 = 0x10;

/// How the values of a buffer are packed.
struct Packing {
    flags: u8,
    /// Bytes of a value.
    type_size: usize,
    /// Bytes of a block, but for the last one.
    block_size: usize,
}

/// Fills `out` with what `packed` holds.
pub(super) fn decompress(packed: &[u8], out: &mut [u8]) -> Result<(), String> {
    let header = packed.first_chunk::<HEADER>().ok_or("its header is cut off")?;
    let &[_version, _codec_version, flags, type_size, ..] = header;
    let size = u32_at(packed, 4)? as usize;
    let packing = Packing { flags, type_size: type_size.into(), block_size: u32_at(packed, 8)? as usize };
    if size != out.len() {
        return Err(format!("it has {size} bytes instead of {}", out.len()));
    }
    if flags & COPIED != 0 {
        let copy = packed[HEADER..].get(..size).ok_or("it is cut off")?;
        out.copy_from_slice(copy);
        return Ok(());
    }
    if size == 0 {
        return Ok(());
    }
    if packing.block_size == 0 || packing.type_size == 0 {
        return Err("its blocks have no size".to_owned());
    }
    if flags & BIT_SHUFFLED != 0 {
        return Err("its bits are shuffled, which is not supported".to_owned());
    }
    let mut shuffled = vec![0; packing.block_size.min(size)];
    for (block, out) in out.chunks_mut(packing.block_size).enumerate() {
        let start = u32_at(packed, HEADER + 4 * block)? as usize;
        let source = packed.get(start..).ok_or("a block starts behind its end")?;
        if flags & SHUFFLED != 0 && packing.type_size > 1 {
            let shuffled = &mut shuffled[..out.len()];
            packing.unpack_block(source, shuffled)?;
            unshuffle(packing.type_size, shuffled, out);
        } else {
            packing.unpack_block(source, out)?;
        }
    }
    Ok(())
}

impl Packing {
    /// Unpacks a block: one piece for each byte of a value, or a single one.
    fn unpack_block(&self, mut source: &[u8], out: &mut [u8]) -> Result<(), String> {
        let split = self.flags & NOT_SPLIT == 0
            && self.type_size <= MAX_SPLITS
            && out.len() == self.block_size
            && out.len() / self.type_size >= MIN_SPLIT_VALUES;
        let pieces = if split { self.type_size } else { 1 };
        if !out.len().is_multiple_of(pieces) {
            return Err("its blocks do not hold whole values".to_owned());
        }
        for piece in out.chunks_mut(out.len() / pieces) {
            let length = u32_at(source, 0)? as usize;
            let packed = source[4..].get(..length).ok_or("a block is cut off")?;
            source = &source[4 + length..];
            if length == piece.len() {
                piece.copy_from_slice(packed);
            } else {
                self.unpack_piece(packed, piece)?;
            }
        }
        Ok(())
    }

    fn unpack_piece(&self, packed: &[u8], out: &mut [u8]) -> Result<(), String> {
        let codec = match self.flags >> 5 {
            1 => {
                let count =
                    lz4_flex::block::decompress_into(packed, out).map_err(|error| error.to_string())?;
                return if count == out.len() { Ok(()) } else { Err("a block is too short".to_owned()) };
            }
            3 => return inflate(packed, out),
            0 => "BloscLZ",
            2 => "Snappy",
            4 => "Zstandard",
            _ => "an unknown codec",
        };
        Err(format!("Blosc was used with {codec}, and only LZ4 and zlib are supported"))
    }
}

/// Puts the bytes of each value together again: all first bytes come first, then all second ones. What is
/// left over at the end is as it was.
fn unshuffle(type_size: usize, shuffled: &[u8], out: &mut [u8]) {
    let values = shuffled.len() / type_size;
    let whole = values * type_size;
    for (value, bytes) in out[..whole].chunks_exact_mut(type_size).enumerate() {
        for (byte, out) in bytes.iter_mut().enumerate() {
            *out = shuffled[byte * values + value];
        }
    }
    out[whole..].copy_from_slice(&shuffled[whole..]);
}

fn u32_at(bytes: &[u8], at: usize) -> Result<u32, String> {
    let number = bytes.get(at..).and_then(<[u8]>::first_chunk);
    number.map(|number| u32::from_le_bytes(*number)).ok_or_else(|| "it is cut off".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The floats 0, 1, 2, 3 over and over, cut off in the middle of one.
    fn numbers(length: usize) -> Vec<u8> {
        (0..1027).flat_map(|i| ((i % 4) as f32).to_le_bytes()).take(length).collect()
    }

    fn bytes(hex: &str) -> Vec<u8> {
        let digits = hex.as_bytes().as_chunks::<2>().0;
        let byte = |pair: &[u8; 2]| u8::from_str_radix(std::str::from_utf8(pair).unwrap_or_default(), 16);
        digits.iter().map(|pair| byte(pair).unwrap_or_default()).collect()
    }

    fn unpacked(packed: &[u8], length: usize) -> Result<Vec<u8>, String> {
        let mut out = vec![0; length];
        decompress(packed, &mut out).map(|()| out)
    }

    // What c-blosc 1.21.3 makes of `numbers`, by `blosc_compress_ctx`.
    const LZ4: &str = "020121040a100000081000006c00000018000000660000000e0000001f000100ffffffec5000000000000e000000\
                       1f000100ffffffec500000000000110000004f008000400400ffffffe9508000400080110000004f003f40400400\
                       ffffffe9503f4040003f020000000000";
    const WIDE: &str = "0201210c0a10000008100000f000000018000000ea0000000c0000001f000100ff3e5000000000000c0000001f00\
                       0100ff3e5000000000000f0000004f004000800400ff3b5040008000400f0000004f0040403f0400ff3b5040403f\
                       00400c0000001f000100ff3e5000000000000c0000001f000100ff3e5000000000000f0000004f800040000400ff\
                       3b5000400080000f0000004f3f0040400400ff3b500040403f000c0000001f000100ff3e5000000000000c000000\
                       1f000100ff3e5000000000000f0000004f008000400400ff3b5080004000800f0000004f403f00400400ff3b503f\
                       0040403f020000000000";
    const MANY: &str = "020131045602000000010000700000001c0000003800000054000000180000001f0001006d3f80004004002a2f3f\
                       400400255040003f4040180000001f0001006d3f80004004002a2f3f400400255040003f4040180000001f000100\
                       173d80004004004a003f40400400504040000000";
    const ZLIB: &str = "020161040a100000081000007800000018000000720000001100000078da63601805a360148c5c00000402000111\
                       00000078da63601805a360148c5c0000040200011400000078da636860706018c5a378148f500c00db11c0811400\
                       000078da63b077706018c5a378148f500c0097b2bf40020000000000";
    const ZSTD: &str = "020191040a10000000040000b200000024000000440000006400000084000000a40000001c00000028b52ffd6000\
                       0395000030008000403f4003007a4061bd4b4dbf0aae1c00000028b52ffd60000395000030008000403f4003007a\
                       4061bd4b4dbf0aae1c00000028b52ffd60000395000030008000403f4003007a4061bd4b4dbf0aae1c00000028b5\
                       2ffd60000395000030008000403f4003007a4061bd4b4dbf0aae0a000000000000000080003f0000";

    #[test]
    fn blocks_are_split_and_shuffled_back() {
        for packed in [LZ4, WIDE, ZLIB, MANY] {
            let packed = bytes(packed);
            let length = u32_at(&packed, 4).unwrap_or_default() as usize;
            assert_eq!(unpacked(&packed, length), Ok(numbers(length)));
        }
    }

    #[test]
    fn small_buffers_are_copied() {
        let header = [2, 1, 0x33, 4, 8, 0, 0, 0, 8, 0, 0, 0, 24, 0, 0, 0];
        let packed = [&header[..], b"12345678"].concat();
        assert_eq!(unpacked(&packed, 8), Ok(b"12345678".to_vec()));
        assert_eq!(unpacked(&packed[..23], 8), Err("it is cut off".to_owned()));
        assert_eq!(unpacked(&[2, 1, 0x33, 4, 0, 0, 0, 0, 0, 0, 0, 0, 16, 0, 0, 0], 0), Ok(vec![]));
    }

    #[test]
    fn what_is_not_supported_is_named() {
        let other = unpacked(&bytes(ZSTD), 4106);
        assert_eq!(
            other,
            Err("Blosc was used with Zstandard, and only LZ4 and zlib are supported".to_owned())
        );
        let mut bits = bytes(LZ4);
        bits[2] ^= SHUFFLED | BIT_SHUFFLED;
        assert_eq!(unpacked(&bits, 4106), Err("its bits are shuffled, which is not supported".to_owned()));
    }

    #[test]
    fn every_damage_is_noticed_or_harmless() {
        for packed in [LZ4, WIDE, ZLIB, MANY].map(bytes) {
            let length = u32_at(&packed, 4).unwrap_or_default() as usize;
            assert!(unpacked(&packed, length + 1).is_err());
            for end in 0..packed.len() {
                assert!(unpacked(&packed[..end], length).is_err(), "{end} of {} bytes", packed.len());
            }
            for (at, value) in (0..packed.len()).flat_map(|at| [0, 1, 127, 128, 255].map(|value| (at, value)))
            {
                let mut damaged = packed.clone();
                damaged[at] = value;
                let _ = unpacked(&damaged, length);
            }
        }
    }
}
