//! OpenVDB files, the volumes of film and simulation (`.vdb`).
//!
//! There is no paper that describes the format: it is what OpenVDB's own sources read and write. Read here
//! after `io/Archive.cc` (header, table of grids), `io/GridDescriptor.cc` (entries of the table),
//! `MetaMap.cc` (metadata), `math/Maps.h` (transforms), `tree/RootNode.h`, `InternalNode.h` and `LeafNode*.h`
//! (topology and voxels) and `io/Compression.h` (codecs, and inactive values that are left out) of
//! <https://github.com/AcademySoftwareFoundation/openvdb>, versions 10 (which writes version 224 of the file
//! format) and 13 (225). All numbers are little-endian.
//!
//! ```text
//! file      magic, versions, offsets or not, UUID │ metadata │ count │ grids …
//! grid      name, type, parent │ start, blocks, end │ compression │ metadata │ transform │ topology │ voxels
//! topology  background │ tiles … │ children: masks, values of tiles, children: …
//! voxels    for each leaf: mask, what is left out, values
//! ```
//!
//! A grid of a kind that is not read is left aside with a note as long as there are others.

mod archive;
mod blosc;
mod bytes;
mod codec;
mod transform;
mod tree;
mod values;
mod write;

use std::collections::BTreeMap;
use std::sync::Arc;

use self::archive::{Entry, Head};
pub use self::write::{VdbOptions, write_vdb};
use super::MAX_VOLUME_NUMBERS;
use super::grid::{Grid, Volume, Voxels};
use crate::FormatError;
use crate::excerpt::list;
use crate::notes::Notes;

/// Why a grid, or a file, cannot be read.
enum Trouble {
    /// Its bytes are not as the format asks.
    Damaged(String),
    /// It is in order, but of a kind that is not read.
    Unsupported(String),
    /// It takes up more numbers than are allowed.
    TooLarge,
}

impl Trouble {
    /// The error about the part of `file` that is called `element`, or about all of it.
    fn of(self, file: &str, element: Option<String>) -> FormatError {
        let file = file.to_owned();
        match (self, element) {
            (Self::TooLarge, _) => FormatError::VolumeTooLarge { file, allowed: MAX_VOLUME_NUMBERS },
            (Self::Damaged(problem) | Self::Unsupported(problem), Some(element)) => {
                FormatError::Element { file, element, problem }
            }
            (Self::Damaged(problem) | Self::Unsupported(problem), None) => {
                FormatError::Malformed { file, position: None, problem }
            }
        }
    }
}

/// Reads the grids that are `wanted`, or all if none is named.
pub(super) fn read(file: &str, bytes: &[u8], wanted: &[&str]) -> Result<Volume, FormatError> {
    let entries = archive::entries(bytes).map_err(|(element, trouble)| trouble.of(file, element))?;
    let mut reader = Reader { trees: BTreeMap::new(), allowed: MAX_VOLUME_NUMBERS, notes: Notes::new(file) };
    let owners = entries.iter().enumerate().filter(|(_, entry)| entry.parent.is_empty());
    let owners: BTreeMap<_, _> = owners.map(|(place, entry)| (entry.unique_name, place)).collect();
    let mut grids = Vec::new();
    let mut refused = None;
    for (place, entry) in entries.iter().enumerate() {
        let name = entry.name();
        if !wanted.is_empty() && !wanted.contains(&name.as_str()) {
            continue;
        }
        // A grid that shares its voxels shares those of a grid that has some of its own.
        let owner = if entry.parent.is_empty() { Some(place) } else { owners.get(entry.parent).copied() };
        match reader.grid(entry, owner.map(|owner| (owner, &entries[owner]))) {
            Ok(grid) => grids.push(grid),
            Err(Trouble::Unsupported(problem)) => {
                reader.notes.say(&entry.shown(), format!("it is left aside: {problem}"));
                refused.get_or_insert((entry.shown(), problem));
            }
            Err(trouble) => return Err(trouble.of(file, Some(entry.shown()))),
        }
    }
    if grids.is_empty() {
        return Err(match refused {
            Some((element, problem)) => Trouble::Unsupported(problem).of(file, Some(element)),
            None => {
                let names: Vec<_> = entries.iter().map(Entry::name).collect();
                let found =
                    if names.is_empty() { "none".to_owned() } else { list(names.iter().map(String::as_str)) };
                FormatError::NoGrids { file: file.to_owned(), wanted: list(wanted.iter().copied()), found }
            }
        });
    }
    Ok(Volume { grids, notes: reader.notes.finish() })
}

/// Reads the grids of one file.
struct Reader {
    /// Voxels that were read, by the place of the grid whose own they are.
    trees: BTreeMap<usize, Arc<Voxels>>,
    /// How many numbers may follow.
    allowed: u64,
    notes: Notes,
}

impl Reader {
    /// Reads a grid whose voxels are those of `owner`.
    fn grid(&mut self, entry: &Entry<'_>, owner: Option<(usize, &Entry<'_>)>) -> Result<Grid, Trouble> {
        let head = Head::read(&mut entry.body.clone())?;
        let (place, owner) = owner.ok_or_else(|| {
            Trouble::Damaged("the grid whose voxels it shares is not there; export the file again".to_owned())
        })?;
        let voxels = match self.trees.get(&place) {
            Some(voxels) => Arc::clone(voxels),
            None => {
                let voxels = self.voxels(owner)?;
                self.trees.insert(place, Arc::clone(&voxels));
                voxels
            }
        };
        Ok(Grid { name: entry.name(), class: head.class, world_from_index: head.world_from_index, voxels })
    }

    /// Reads the voxels of a grid that has its own.
    fn voxels(&mut self, owner: &Entry<'_>) -> Result<Arc<Voxels>, Trouble> {
        let mut bytes = owner.body.clone();
        let head = Head::read(&mut bytes)?;
        let tree = tree::read(&mut bytes, owner, head.compression, &mut self.allowed)?;
        if tree.not_finite > 0 {
            let count = tree.not_finite;
            let what =
                format!("{count} of its values are infinite or no numbers; they became its background");
            self.notes.say(&owner.shown(), what);
        }
        Ok(Arc::new(tree.voxels))
    }
}
