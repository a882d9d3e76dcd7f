//! The document: what is in the JSON, with the bytes that it speaks of.

use std::borrow::Cow;
use std::cell::Cell;

use gltf_json::{Buffer, Root};

use super::container::Container;
use crate::FormatError;
use crate::excerpt::{excerpt, excerpt_path, list};
use crate::model::companions::{Companions, Location};
use crate::notes::Notes;

/// Extensions that are understood, or that change nothing in what Fumetto draws: it lights things in
/// its own way.
const KNOWN_EXTENSIONS: [&str; 18] = [
    "EXT_mesh_gpu_instancing",
    "KHR_lights_punctual",
    "KHR_materials_anisotropy",
    "KHR_materials_clearcoat",
    "KHR_materials_dispersion",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_iridescence",
    "KHR_materials_sheen",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_volume",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
    "KHR_xmp_json_ld",
    "MSFT_packing_normalRoughnessMetallic",
    "MSFT_packing_occlusionRoughnessMetallic",
];

/// Most items of four numbers that may be read, other than corners of triangles: more than 24 hours of
/// 50 bones at every frame, and 270 MB. Small files get beyond by having many accessors share their bytes.
const MAX_ITEMS: u64 = 1 << 24;

/// Most objects in the JSON: two hundred times what large scenes have. Each may take some 450 bytes of
/// memory, though `{}` is written with two.
const MAX_OBJECTS: usize = 1_000_000;

/// A glTF document with its buffers.
pub(super) struct Document<'a> {
    pub(super) path: &'a str,
    pub(super) root: Root,
    buffers: Vec<Cow<'a, [u8]>>,
    items_left: Cell<u64>,
}

impl<'a> Document<'a> {
    pub(super) fn read(
        path: &'a str,
        bytes: &'a [u8],
        companions: &mut Companions<'_>,
        notes: &mut Notes,
    ) -> Result<Self, FormatError> {
        let container = Container::split(path, bytes)?;
        check_objects(path, container.json)?;
        let root: Root = gltf_json::deserialize::from_slice(container.json).map_err(|error| {
            let error = excerpt_of_error(&error.to_string());
            let problem = format!("not a readable glTF 2.0 document ({error}); export it again as glTF 2.0");
            FormatError::Malformed { file: path.to_owned(), position: None, problem }
        })?;
        let mut document = Self { path, root, buffers: Vec::new(), items_left: Cell::new(MAX_ITEMS) };
        document.check_version()?;
        document.check_extensions(notes)?;
        document.buffers = document.read_buffers(container.binary, companions)?;
        Ok(document)
    }

    /// The error that something is not as it has to be.
    pub(super) fn wrong(&self, element: &str, problem: impl Into<String>) -> FormatError {
        FormatError::Element {
            file: self.path.to_owned(),
            element: element.to_owned(),
            problem: problem.into(),
        }
    }

    fn check_version(&self) -> Result<(), FormatError> {
        let asset = &self.root.asset;
        let version = asset.min_version.as_ref().unwrap_or(&asset.version);
        if version.split('.').next() == Some("2") {
            return Ok(());
        }
        let version = excerpt(version.as_bytes());
        Err(self.wrong("asset", format!("it is glTF {version}; export it as glTF 2.0")))
    }

    fn check_extensions(&self, notes: &mut Notes) -> Result<(), FormatError> {
        let unknown = |names: &'_ &String| !KNOWN_EXTENSIONS.contains(&names.as_str());
        let required: Vec<&str> =
            self.root.extensions_required.iter().filter(unknown).map(String::as_str).collect();
        if !required.is_empty() {
            let names = list(required.into_iter());
            return Err(FormatError::RequiredExtensions { file: self.path.to_owned(), names });
        }
        let ignored: Vec<&str> =
            self.root.extensions_used.iter().filter(unknown).map(String::as_str).collect();
        if !ignored.is_empty() {
            notes.say_of_all(format!("ignored the extensions {}", list(ignored.into_iter())));
        }
        Ok(())
    }

    fn read_buffers(
        &self,
        binary: Option<&'a [u8]>,
        companions: &mut Companions<'_>,
    ) -> Result<Vec<Cow<'a, [u8]>>, FormatError> {
        let buffers = self.root.buffers.iter().enumerate();
        buffers.map(|(index, buffer)| self.read_buffer(index, buffer, binary, companions)).collect()
    }

    fn read_buffer(
        &self,
        index: usize,
        buffer: &Buffer,
        binary: Option<&'a [u8]>,
        companions: &mut Companions<'_>,
    ) -> Result<Cow<'a, [u8]>, FormatError> {
        let element = label("buffer", index, buffer.name.as_deref());
        let Some(uri) = &buffer.uri else {
            // Only the first buffer may be the one within the file.
            let within = binary.filter(|_| index == 0).map(Cow::Borrowed);
            return within.ok_or_else(|| {
                self.wrong(&element, "it has neither a `uri` nor bytes in the file; export it again")
            });
        };
        let location = companions
            .locate(uri)
            .map_err(|problem| self.wrong(&element, format!("`{}` {problem}", excerpt(uri.as_bytes()))))?;
        match location {
            Location::Inside(bytes) => Ok(Cow::Owned(bytes)),
            Location::File(path) => companions.read(&path).map(Cow::Owned).map_err(|error| {
                let path = excerpt_path(&path);
                FormatError::Companion { file: self.path.to_owned(), element, path, error }
            }),
        }
    }

    /// The bytes of a buffer view, and how far apart the items are in it if it says so.
    pub(super) fn view(&self, element: &str, index: usize) -> Result<(&[u8], Option<usize>), FormatError> {
        let view =
            self.root.buffer_views.get(index).ok_or_else(|| self.absent(element, "buffer view", index))?;
        let buffer = view.buffer.value();
        let bytes = self.buffers.get(buffer).ok_or_else(|| self.absent(element, "buffer", buffer))?;
        let offset = view.byte_offset.unwrap_or_default().0;
        let length = view.byte_length.0;
        let seen = part(bytes, offset, length).ok_or_else(|| {
            self.wrong(
                element,
                format!(
                    "buffer view {index} takes {length} bytes from byte {offset} of buffer {buffer}, which has only {}; \
                     the file is cut off or damaged, so export or copy it again",
                    bytes.len()
                ),
            )
        })?;
        Ok((seen, view.byte_stride.map(|stride| stride.0)))
    }

    /// The error that something refers to what is not there.
    pub(super) fn absent(&self, element: &str, kind: &str, index: usize) -> FormatError {
        self.wrong(element, format!("it needs {kind} {index}, which is not there; export the model again"))
    }

    /// The bytes of all buffers together.
    pub(super) fn buffer_bytes(&self) -> u64 {
        self.buffers.iter().map(|bytes| bytes.len() as u64).sum()
    }

    /// Counts items that will be read, before they are.
    pub(super) fn take_items(&self, element: &str, count: usize) -> Result<(), FormatError> {
        let left = self.items_left.get().checked_sub(count as u64).ok_or_else(|| {
            self.wrong(
                element,
                format!(
                    "with it, there are more than {MAX_ITEMS} key frames, instances and sparse items; simplify them"
                ),
            )
        })?;
        self.items_left.set(left);
        Ok(())
    }
}

/// Refuses JSON of more objects than fit into a reasonable memory, before it is read.
fn check_objects(file: &str, json: &[u8]) -> Result<(), FormatError> {
    // Those in names count, too, which hurts nobody.
    let objects = json.iter().filter(|&&byte| byte == b'{').count();
    if objects <= MAX_OBJECTS {
        return Ok(());
    }
    let problem = format!(
        "it has {objects} objects, more than the {MAX_OBJECTS} that are allowed; join meshes, or split the model"
    );
    Err(FormatError::Malformed { file: file.to_owned(), position: None, problem })
}

/// `length` bytes from `offset`, if there are so many.
pub(super) fn part(bytes: &[u8], offset: u64, length: u64) -> Option<&[u8]> {
    let start = usize::try_from(offset).ok()?;
    let length = usize::try_from(length).ok()?;
    bytes.get(start..)?.get(..length)
}

/// How messages call a thing: by its number, and its name if it has one.
pub(super) fn label(kind: &str, index: usize, name: Option<&str>) -> String {
    match name.filter(|name| !name.is_empty()) {
        Some(name) => format!("{kind} {index} \"{}\"", excerpt(name.as_bytes())),
        None => format!("{kind} {index}"),
    }
}

/// What the JSON reader says, of which the place at the end matters as much as the start.
fn excerpt_of_error(error: &str) -> String {
    match error.rsplit_once(" at line ") {
        Some((what, place)) => format!("{} at line {place}", excerpt(what.as_bytes())),
        None => excerpt(error.as_bytes()),
    }
}
