//! The pictures of a model.

use rustc_hash::FxHashMap;

use super::companions::{Companions, Location};
use crate::excerpt::excerpt_path;
use crate::jpeg::read_jpeg;
use crate::notes::Notes;
use crate::{FormatError, Image, MAX_IMAGE_SIDE, read_png};

/// Most pixels that a model's textures may have together: eight of 4096 × 4096. They take 512 MB.
const MAX_PIXELS: u64 = 2 * MAX_IMAGE_SIDE as u64 * MAX_IMAGE_SIDE as u64;

/// A model's pictures as they are asked for, each read once.
pub(super) struct Textures {
    images: Vec<Image>,
    known: FxHashMap<String, Option<usize>>,
    pixels: u64,
}

impl Textures {
    pub(super) fn new() -> Self {
        Self { images: Vec::new(), known: FxHashMap::default(), pixels: 0 }
    }

    /// The place of the picture at `location`, unless it cannot be read, which is noted.
    pub(super) fn at(
        &mut self,
        element: &str,
        location: Location,
        companions: &mut Companions<'_>,
        notes: &mut Notes,
    ) -> Option<usize> {
        match location {
            Location::Inside(bytes) => self.within(element, element, &bytes, notes),
            Location::File(path) => {
                if let Some(&known) = self.known.get(&path) {
                    return known;
                }
                let shown = excerpt_path(&path);
                let image = match companions.read(&path) {
                    Ok(bytes) => self.within(element, &shown, &bytes, notes),
                    Err(error) => {
                        notes.say(
                            element,
                            format!("goes without its picture, for `{shown}` cannot be read ({error})"),
                        );
                        None
                    }
                };
                self.known.insert(path, image);
                image
            }
        }
    }

    /// The same for a picture that is `bytes`; `name` is for messages.
    pub(super) fn within(
        &mut self,
        element: &str,
        name: &str,
        bytes: &[u8],
        notes: &mut Notes,
    ) -> Option<usize> {
        match decode(name, bytes) {
            Ok(image) => {
                let pixels = u64::from(image.width) * u64::from(image.height);
                if self.pixels + pixels > MAX_PIXELS {
                    notes.say(
                        element,
                        format!(
                            "goes without its picture, for all textures together have more than the {MAX_PIXELS} \
                             pixels that are allowed; scale them down"
                        ),
                    );
                    return None;
                }
                self.pixels += pixels;
                self.images.push(image);
                Some(self.images.len() - 1)
            }
            Err(error) => {
                notes.say(element, format!("goes without its picture: {error}"));
                None
            }
        }
    }

    /// All pictures that could be read.
    pub(super) fn finish(self) -> Vec<Image> {
        self.images
    }
}

/// Reads a picture of a format that its first bytes tell; its name may lie, and often does.
fn decode(name: &str, bytes: &[u8]) -> Result<Image, FormatError> {
    if bytes.starts_with(&[0xff, 0xd8]) {
        return read_jpeg(name, bytes);
    }
    if bytes.starts_with(b"\x89PNG") {
        return read_png(name, bytes);
    }
    Err(FormatError::Malformed {
        file: name.to_owned(),
        position: None,
        problem: "it is neither PNG nor JPEG; convert it to either".to_owned(),
    })
}
