//! NRRD files, the volumes of medicine and science (`.nrrd`), after the definition of the format at
//! <https://teem.sourceforge.net/nrrd/format.html>: three axes, or vectors of three on three axes, with the
//! numbers behind the header (section 3), as raw bytes, packed by gzip, or as text (section 6).

mod header;

use std::io::Read;

use flate2::read::MultiGzDecoder;

use self::header::{Encoding, Header};
use super::array::{Array, malformed};
use super::dense::Strides;
use super::grid::Volume;
use crate::FormatError;

/// Deflate never makes data smaller than this many times (zlib's "Maximum Compression Factor").
const MAX_DEFLATE_FACTOR: usize = 1032;

/// Reads a volume.
pub(super) fn read(file: &str, bytes: &[u8]) -> Result<Volume, FormatError> {
    let (header, body) = Header::read(file, bytes)?;
    let (size, channels) = header.shape(file)?;
    let world_from_index = header.world_from_index();
    let array = Array { file, size, channels, world_from_index };
    let count = array.count()?;
    let length = count * header.number.size();
    let skip = usize::try_from(header.byte_skip).ok();
    if header.encoding != Encoding::Raw && skip != Some(0) {
        let problem = "its header skips bytes, which is understood before raw numbers only; export it as raw";
        return Err(malformed(file, problem.to_owned()));
    }
    let cut_off = |found: usize| {
        malformed(
            file,
            format!("its numbers take {length} bytes, but only {found} follow; the file is cut off"),
        )
    };
    let values = match header.encoding {
        Encoding::Raw => {
            let numbers = match skip {
                Some(skip) => body.get(skip..).and_then(|body| body.get(..length)),
                // They are the file's last bytes.
                None => body.len().checked_sub(length).map(|start| &body[start..]),
            };
            header.number.decode(numbers.ok_or_else(|| cut_off(body.len()))?, header.big_endian)
        }
        Encoding::Gzip => {
            if length / MAX_DEFLATE_FACTOR > body.len() {
                return Err(cut_off(body.len()));
            }
            let mut numbers = vec![0; length];
            let mut decoder = MultiGzDecoder::new(body);
            // The checksum is compared where the numbers end.
            let unpacked = decoder.read_exact(&mut numbers).and_then(|()| decoder.read(&mut [0]));
            unpacked.map_err(|error| {
                malformed(file, format!("its numbers cannot be unpacked ({error}); export the file again"))
            })?;
            header.number.decode(&numbers, header.big_endian)
        }
        Encoding::Text => read_text(file, body, count)?,
    };
    let strides = Strides::x_first(size, channels);
    array.volume(values, strides.unwrap_or(Strides { axes: [0; 3], channel: 0 }))
}

/// Reads `count` numbers with spaces or commas between them.
fn read_text(file: &str, body: &[u8], count: usize) -> Result<Vec<f32>, FormatError> {
    let words =
        body.split(|&byte| byte.is_ascii_whitespace() || byte == b',').filter(|word| !word.is_empty());
    let number = |word: &[u8]| std::str::from_utf8(word).ok()?.parse().ok();
    let values: Option<Vec<f32>> = words.take(count).map(number).collect();
    values.filter(|values| values.len() == count).ok_or_else(|| {
        malformed(
            file,
            format!("its header promises {count} numbers, which do not follow; export the file again"),
        )
    })
}
