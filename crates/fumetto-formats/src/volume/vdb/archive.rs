//! The file's header and table of grids.

use super::bytes::Bytes;
use super::codec::Compression;
use super::{Trouble, transform, tree};
use crate::excerpt::excerpt;
use crate::volume::MAX_VOLUME_NUMBERS;
use crate::volume::grid::GridClass;

/// The number 0x56444220 as eight bytes: " BDV" and four zeros.
pub(super) const MAGIC: u64 = 0x5644_4220;

/// The file versions that are read: since 222, the codec and what it leaves out is told for each grid and
/// node; 225 added half floats as a type of their own.
const VERSIONS: std::ops::RangeInclusive<u32> = 222..=225;

/// Length of the file's unique identifier, as text.
const UUID_BYTES: usize = 36;

/// What stands between a grid's name and the number that tells it from others of the same name.
pub(super) const NAME_SEPARATOR: u8 = 0x1e;

/// What follows a tree's type if its values are stored as half floats.
pub(super) const HALF_SUFFIX: &[u8] = b"_HalfFloat";

/// Where the bytes of a grid are, and what they are.
pub(super) struct Entry<'a> {
    /// The grid's name, and a number if others have the same.
    pub(super) unique_name: &'a [u8],
    /// The tree's type, as in `Tree_float_5_4_3`.
    pub(super) tree_type: &'a [u8],
    /// Whether its values are stored as half floats.
    pub(super) half: bool,
    /// The unique name of the grid whose tree this one shares; empty if it has a tree of its own.
    pub(super) parent: &'a [u8],
    /// The grid itself. It may go on behind the grid's end if the file does not say where that is.
    pub(super) body: Bytes<'a>,
}

impl<'a> Entry<'a> {
    /// The grid's name.
    pub(super) fn name(&self) -> String {
        let end = self.unique_name.iter().position(|&byte| byte == NAME_SEPARATOR);
        String::from_utf8_lossy(&self.unique_name[..end.unwrap_or(self.unique_name.len())]).into_owned()
    }

    /// The grid as it is called in messages.
    pub(super) fn shown(&self) -> String {
        format!("grid `{}`", excerpt(self.name().as_bytes()))
    }

    fn read(bytes: &mut Bytes<'a>) -> Result<(Self, [i64; 3]), Trouble> {
        let unique_name = bytes.string()?;
        let stored_type = bytes.string()?;
        let tree_type = stored_type.strip_suffix(HALF_SUFFIX);
        let entry = Self {
            unique_name,
            tree_type: tree_type.unwrap_or(stored_type),
            half: tree_type.is_some(),
            parent: bytes.string()?,
            body: bytes.clone(),
        };
        let positions = [bytes.i64()?, bytes.i64()?, bytes.i64()?];
        Ok((Self { body: bytes.clone(), ..entry }, positions))
    }
}

/// All grids of a file, in its order.
///
/// An error comes with the grid that it is about, where there is one.
pub(super) fn entries<'a>(all: &'a [u8]) -> Result<Vec<Entry<'a>>, (Option<String>, Trouble)> {
    let mut bytes = Bytes::new(all);
    let of_file = |trouble| (None, trouble);
    let has_offsets = read_header(&mut bytes).map_err(of_file)?;
    read_metadata(&mut bytes).map_err(of_file)?;
    let count = bytes.u32().map_err(of_file)?;
    let mut entries = Vec::new();
    for _ in 0..count {
        let (mut entry, positions) = Entry::read(&mut bytes).map_err(of_file)?;
        let found = if has_offsets { locate(&mut bytes, positions) } else { walk(&mut bytes, &entry) };
        entry.body = found.map_err(|trouble| (Some(entry.shown()), trouble))?;
        entries.push(entry);
    }
    Ok(entries)
}

/// Reads the header; whether the file says where grids start and end.
fn read_header(bytes: &mut Bytes<'_>) -> Result<bool, Trouble> {
    let magic = bytes.i64().map(i64::cast_unsigned);
    if magic.ok() != Some(MAGIC) {
        return Err(Trouble::Damaged("not an OpenVDB file: it does not start as those do".to_owned()));
    }
    let version = bytes.u32()?;
    if !VERSIONS.contains(&version) {
        return Err(Trouble::Damaged(format!(
            "it has version {version} of OpenVDB's format, and versions {} to {} are read; open it with OpenVDB's \
             tools and save it again",
            VERSIONS.start(),
            VERSIONS.end()
        )));
    }
    let _library_version = [bytes.u32()?, bytes.u32()?];
    let has_offsets = bytes.u8()? != 0;
    bytes.take(UUID_BYTES)?;
    Ok(has_offsets)
}

/// Goes behind metadata; the grid's class, if they tell it.
pub(super) fn read_metadata(bytes: &mut Bytes<'_>) -> Result<GridClass, Trouble> {
    let mut class = GridClass::Unknown;
    for _ in 0..bytes.u32()? {
        let name = bytes.string()?;
        let _type_name = bytes.string()?;
        let value = bytes.string()?;
        if name == b"class" {
            class = match value {
                b"fog volume" => GridClass::FogVolume,
                b"level set" => GridClass::LevelSet,
                b"staggered" => GridClass::Staggered,
                _ => GridClass::Unknown,
            };
        }
    }
    Ok(class)
}

/// The bytes of the grid which start and end where `positions` says, behind its entry; `bytes` goes on
/// behind them. As grids lie one behind the other, they cannot overlap.
fn locate<'a>(bytes: &mut Bytes<'a>, [start, _blocks, end]: [i64; 3]) -> Result<Bytes<'a>, Trouble> {
    let position = |offset: i64| usize::try_from(offset).ok();
    let (Some(start), Some(end)) = (position(start), position(end)) else {
        return Err(Trouble::Damaged("its place in the file is negative; export the file again".to_owned()));
    };
    if start < bytes.position() || end < start {
        return Err(Trouble::Damaged(format!(
            "bytes {start} to {end} of the file are said to be its own, but it cannot start before byte {}; export \
             the file again",
            bytes.position()
        )));
    }
    bytes.section(start)?;
    bytes.section(end)
}

/// The bytes of the grid that starts here, if only reading it tells where it ends.
fn walk<'a>(bytes: &mut Bytes<'a>, entry: &Entry<'a>) -> Result<Bytes<'a>, Trouble> {
    let body = bytes.clone();
    let head = Head::read(bytes)?;
    if entry.parent.is_empty() {
        let mut allowed = MAX_VOLUME_NUMBERS;
        tree::read(bytes, entry, head.compression, &mut allowed)?;
    }
    Ok(body)
}

/// What stands before a grid's tree.
pub(super) struct Head {
    pub(super) compression: Compression,
    pub(super) class: GridClass,
    pub(super) world_from_index: [[f64; 4]; 4],
}

impl Head {
    pub(super) fn read(bytes: &mut Bytes<'_>) -> Result<Self, Trouble> {
        let compression = Compression::read(bytes)?;
        let class = read_metadata(bytes)?;
        let world_from_index = transform::read(bytes)?;
        Ok(Self { compression, class, world_from_index })
    }
}
