//! What was read before, so that a number that is dragged reads no file anew.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::time::SystemTime;
use std::{fs, io};

/// Files are kept up to this many bytes together: many clouds and pictures, but not a long sequence of volumes.
const MOST_BYTES: usize = 256 << 20;

/// Files as they were read, and what the scene calls those it needs.
#[derive(Debug, Default)]
pub(super) struct Shelf {
    content: RefCell<Content>,
}

#[derive(Debug, Default)]
struct Content {
    kept: BTreeMap<PathBuf, Kept>,
    /// Grows with every file that is asked for.
    now: u64,
    names: BTreeSet<String>,
}

#[derive(Debug)]
struct Kept {
    bytes: Vec<u8>,
    stamp: Stamp,
    /// When it was asked for last.
    used: u64,
}

/// When a file was written last, and its length: where both are as before, so is the file.
type Stamp = (SystemTime, u64);

fn stamp(place: &Path) -> Option<Stamp> {
    let metadata = fs::metadata(place).ok().filter(fs::Metadata::is_file)?;
    Some((metadata.modified().ok()?, metadata.len()))
}

impl Shelf {
    /// The bytes of the file at `place`; `read` fetches them where they are not here, or not as they are on the disk.
    pub(super) fn read(
        &self,
        place: &Path,
        read: impl FnOnce() -> io::Result<Vec<u8>>,
    ) -> io::Result<Vec<u8>> {
        let stamp = stamp(place);
        let mut content = self.content.borrow_mut();
        content.now += 1;
        let now = content.now;
        if let Some(kept) = content.kept.get_mut(place).filter(|kept| Some(kept.stamp) == stamp) {
            kept.used = now;
            return Ok(kept.bytes.clone());
        }
        content.kept.remove(place);
        let bytes = read()?;
        if let Some(stamp) = stamp.filter(|_| bytes.len() <= MOST_BYTES) {
            content.make_room(bytes.len());
            content.kept.insert(place.to_owned(), Kept { bytes: bytes.clone(), stamp, used: now });
        }
        Ok(bytes)
    }

    /// The scene needs the file that it calls `name`.
    pub(super) fn note(&self, name: &str) {
        self.content.borrow_mut().names.insert(name.to_owned());
    }

    /// What the files are called that the scene has needed, until they are forgotten.
    pub(super) fn names(&self) -> BTreeSet<String> {
        self.content.borrow().names.clone()
    }

    /// What is needed will be noted anew; what was noted before.
    pub(super) fn forget_names(&self) -> BTreeSet<String> {
        std::mem::take(&mut self.content.borrow_mut().names)
    }
}

impl Content {
    /// Lets go of what was not asked for longest, until so many more bytes may be kept.
    fn make_room(&mut self, bytes: usize) {
        let mut sum: usize = self.kept.values().map(|kept| kept.bytes.len()).sum();
        while sum + bytes > MOST_BYTES {
            let oldest = self.kept.iter().min_by_key(|(_, kept)| kept.used);
            let Some(oldest) = oldest.map(|(place, _)| place.clone()) else { return };
            sum -= self.kept.remove(&oldest).map_or(0, |kept| kept.bytes.len());
        }
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_read_once_until_it_changes() {
        let folder = tempfile::tempdir().unwrap();
        let place = folder.path().join("a.csv");
        fs::write(&place, "one").unwrap();
        let shelf = Shelf::default();
        assert_eq!(shelf.read(&place, || fs::read(&place)).unwrap(), b"one");
        assert_eq!(shelf.read(&place, || unreachable!("it is kept")).unwrap(), b"one");
        fs::write(&place, "three").unwrap();
        assert_eq!(shelf.read(&place, || fs::read(&place)).unwrap(), b"three");
        fs::remove_file(&place).unwrap();
        assert!(shelf.read(&place, || fs::read(&place)).is_err());
    }

    #[test]
    fn what_was_not_asked_for_longest_makes_room() {
        let kept = |used| Kept { bytes: vec![0; 8], stamp: (SystemTime::UNIX_EPOCH, 8), used };
        let mut content = Content::default();
        for (name, used) in [("a", 2), ("b", 1), ("c", 3)] {
            content.kept.insert(name.into(), kept(used));
        }
        content.make_room(MOST_BYTES - 16);
        assert_eq!(content.kept.keys().map(|place| place.to_str().unwrap()).collect::<Vec<_>>(), ["a", "c"]);
    }
}
