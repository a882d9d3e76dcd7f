//! What goes along when a scene is saved elsewhere.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::{self, BufRead, BufReader, Write as _};
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use anyhow::{Context as _, bail};
use fumetto_formats::{is_sequence, sequence_path};
use fumetto_scene::edit::{Document, Value};

use super::Files;

/// Files that a scene needs and its new folder does not have.
#[derive(Debug, Default)]
pub(crate) struct Luggage(Vec<(PathBuf, Source)>);

#[derive(Debug)]
enum Source {
    Memory(Arc<[u8]>),
    Disk(PathBuf),
}

impl Files {
    /// What has to be put into `folder` so that the scene finds its files there.
    ///
    /// # Errors
    /// When another file has such a name, or one would lie outside the folder; nothing was written then.
    pub(crate) fn luggage(&self, folder: &Path, document: &Document) -> anyhow::Result<Luggage> {
        let mut luggage = Luggage::default();
        for (name, bytes) in &self.memory {
            if document.text().contains(name) {
                luggage.take(folder, name, Source::Memory(bytes.clone()))?;
            }
        }
        if let Some(before) = self.folder().filter(|before| *before != folder) {
            for name in needed(before, document, self.shelf.names()) {
                luggage.take(folder, &name, Source::Disk(before.join(&name)))?;
            }
        }
        Ok(luggage)
    }

    /// The files of the scene, now that it lies at `scene` with its luggage.
    pub(crate) fn moved(&self, scene: &Path) -> Self {
        let mut memory = self.memory.clone();
        memory.retain(|name, bytes| {
            !Source::Memory(bytes.clone()).is_at(&scene.with_file_name(name)).unwrap_or(false)
        });
        Self { memory, scene: Some(scene.to_owned()), shelf: self.shelf.clone() }
    }

    /// Notes anew which files the scene needs while `check` reads it. Unless it finds a scene, those before count too.
    pub(crate) fn noting(&self, check: impl FnOnce() -> bool) {
        let before = self.shelf.forget_names();
        if !check() {
            before.iter().for_each(|name| self.shelf.note(name));
        }
    }
}

impl Luggage {
    fn take(&mut self, folder: &Path, name: &str, source: Source) -> anyhow::Result<()> {
        let place = folder.join(name);
        if place.exists() {
            if source.is_at(&place).unwrap_or(false) {
                return Ok(());
            }
            bail!(
                "the scene needs its file {name}, but {} is another file; save the scene into another folder",
                place.display()
            );
        }
        let is_inside = |part| matches!(part, Component::Normal(_) | Component::CurDir);
        if !Path::new(name).components().all(is_inside) {
            bail!(
                "the scene needs the file {name}, which is not found from {}; copy it there, or name it from the root",
                folder.display()
            );
        }
        self.0.push((place, source));
        Ok(())
    }

    /// Copies it. Each file appears whole or not at all.
    pub(crate) fn unpack(&self) -> anyhow::Result<()> {
        for (place, source) in &self.0 {
            if let Some(folder) = place.parent() {
                fs::create_dir_all(folder).with_context(|| format!("cannot make {}", folder.display()))?;
            }
            fumetto_disk::write(place, |draft| match source {
                Source::Memory(bytes) => draft.write_all(bytes),
                Source::Disk(from) => io::copy(&mut File::open(from)?, draft).map(drop),
            })?;
        }
        Ok(())
    }
}

impl Source {
    /// Whether the file at `place` says the same.
    fn is_at(&self, place: &Path) -> io::Result<bool> {
        let mut other = BufReader::new(File::open(place)?);
        match self {
            Self::Memory(bytes) => is_same(&mut &**bytes, &mut other),
            Self::Disk(from) => is_same(&mut BufReader::new(File::open(from)?), &mut other),
        }
    }
}

fn is_same(a: &mut impl BufRead, b: &mut impl BufRead) -> io::Result<bool> {
    loop {
        let (left, right) = (a.fill_buf()?, b.fill_buf()?);
        let len = left.len().min(right.len());
        if len == 0 || left[..len] != right[..len] {
            return Ok(left.is_empty() && right.is_empty());
        }
        a.consume(len);
        b.consume(len);
    }
}

/// The files in `folder` that the scene names, and those that were `read` for it: what a model or a style names.
fn needed(folder: &Path, document: &Document, read: BTreeSet<String>) -> BTreeSet<String> {
    let mut names = read;
    if let Some(scene) = document.get(&fumetto_scene::edit::Path::root()) {
        collect(&scene, folder, &mut names);
    }
    names.retain(|name| !Path::new(name).is_absolute() && folder.join(name).is_file());
    names
}

fn collect(value: &Value, folder: &Path, names: &mut BTreeSet<String>) {
    match value {
        Value::Table(table) => table.values().for_each(|inner| collect(inner, folder, names)),
        Value::Array(items) => items.iter().for_each(|inner| collect(inner, folder, names)),
        // What has no ending may be the name of anything.
        Value::String(text) if Path::new(text).extension().is_some() => {
            if is_sequence(text) {
                names.extend(frames(folder, text));
            }
            names.insert(text.clone());
        }
        _ => {}
    }
}

/// The files of a sequence.
fn frames(folder: &Path, pattern: &str) -> Vec<String> {
    let place = Path::new(pattern).parent().unwrap_or(Path::new(""));
    let Ok(entries) = fs::read_dir(folder.join(place)) else { return Vec::new() };
    let is_frame = |entry: io::Result<fs::DirEntry>| {
        let name = entry.ok()?.file_name().into_string().ok()?;
        let name = place.join(name).to_str()?.to_owned();
        let mut numbers = name.split(|letter: char| !letter.is_ascii_digit()).flat_map(str::parse);
        numbers.any(|number| sequence_path(pattern, number) == name).then_some(name)
    };
    entries.filter_map(is_frame).collect()
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]
mod tests {
    use super::*;

    fn document(names: &[&str]) -> Document {
        let objects = names.iter().map(|name| format!("[[object]]\nmodel = \"{name}\"\n"));
        Document::open(objects.collect::<String>()).unwrap()
    }

    #[test]
    fn what_the_scene_names_goes_along() {
        let (old, new) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        fs::create_dir(old.path().join("parts")).unwrap();
        for name in ["parts/a.glb", "smoke.007.vdb", "smoke.12.vdb", "smoke.012.vdb", "other.csv", "bin"] {
            fs::write(old.path().join(name), name).unwrap();
        }
        let files = Files::beside(&old.path().join("scene.toml"));
        files.shelf.note("bin");
        let document = document(&["parts/a.glb", "smoke.###.vdb", "missing.csv"]);
        files.luggage(new.path(), &document).unwrap().unpack().unwrap();
        for name in ["parts/a.glb", "smoke.007.vdb", "smoke.012.vdb", "bin"] {
            assert_eq!(fs::read_to_string(new.path().join(name)).unwrap(), name);
        }
        assert!(!new.path().join("other.csv").exists() && !new.path().join("smoke.12.vdb").exists());
        assert!(files.luggage(new.path(), &document).unwrap().0.is_empty(), "it is there already");
        assert!(files.luggage(old.path(), &document).unwrap().0.is_empty(), "nothing moves");
    }

    #[test]
    fn another_file_of_the_name_is_left_alone() {
        let (old, new) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        let mut files = Files::default();
        files.add("a.csv", *b"mine");
        fs::write(new.path().join("a.csv"), "yours").unwrap();
        let refusal = files.luggage(new.path(), &document(&["a.csv"])).unwrap_err().to_string();
        assert!(refusal.contains("is another file"), "{refusal}");
        fs::create_dir(old.path().join("scenes")).unwrap();
        fs::write(old.path().join("b.csv"), "mine").unwrap();
        let files = Files::beside(&old.path().join("scenes/scene.toml"));
        let refusal = files.luggage(new.path(), &document(&["../b.csv"])).unwrap_err().to_string();
        assert!(refusal.contains("../b.csv"), "{refusal}");
    }
}
