//! The files that a model needs beside itself: where they are, and their bytes.

use std::borrow::Cow;
use std::io;

use base64::Engine;
use base64::alphabet::STANDARD;
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};
use percent_encoding::percent_decode_str;

/// Base64 as data URIs have it; some writers leave out the padding.
const BASE64: GeneralPurpose = GeneralPurpose::new(
    &STANDARD,
    GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent),
);

/// Reads the files that a model names.
pub(super) struct Companions<'a> {
    model: &'a str,
    read: &'a mut dyn FnMut(&str) -> io::Result<Vec<u8>>,
}

/// Where the bytes are that a URI stands for.
#[derive(Debug, PartialEq)]
pub(super) enum Location {
    /// In the URI itself.
    Inside(Vec<u8>),
    /// In a file at this path.
    File(String),
}

impl<'a> Companions<'a> {
    /// Of the file at `model`.
    pub(super) fn new(model: &'a str, read: &'a mut dyn FnMut(&str) -> io::Result<Vec<u8>>) -> Self {
        Self { model, read }
    }

    /// The bytes of the file at `path`, which [`locate`](Self::locate) or [`beside`](Self::beside) told.
    pub(super) fn read(&mut self, path: &str) -> io::Result<Vec<u8>> {
        (self.read)(path)
    }

    /// Finds what a URI of glTF stands for, or says what is wrong with it.
    pub(super) fn locate(&self, uri: &str) -> Result<Location, &'static str> {
        if let Some(data) = uri.strip_prefix("data:") {
            return decode_data(data).map(Location::Inside);
        }
        let decoded = percent_decode_str(uri).decode_utf8_lossy();
        // One letter before the colon is a drive; `beside` looks for the file's name alone then.
        let scheme = decoded.split_once(':').map_or("", |(scheme, _)| scheme);
        if scheme.len() > 1 && !scheme.contains(['/', '\\']) {
            return Err("is not a file beside the model; export it with its files, or as one `.glb`");
        }
        Ok(Location::File(self.beside(&decoded)))
    }

    /// The path of the file that the model calls `name`, seen from where the model's path starts.
    ///
    /// A path that starts at the root was true on the machine that wrote it and there only, so the name
    /// alone is looked for in the model's folder.
    pub(super) fn beside(&self, name: &str) -> String {
        let name = name.replace('\\', "/");
        let drive = name.as_bytes().get(1) == Some(&b':');
        let name =
            if drive || name.starts_with('/') { name.rsplit('/').next().unwrap_or_default() } else { &name };
        let folder = self.model.rfind(['/', '\\']).map_or("", |end| &self.model[..=end]);
        tidy(&format!("{folder}{name}"))
    }
}

/// The same path without `.` and without folders that are left again.
fn tidy(path: &str) -> String {
    let mut steps: Vec<&str> = Vec::new();
    for step in path.split('/') {
        match step {
            "." => {}
            ".." if steps.last().is_some_and(|last| !["", ".."].contains(last)) => {
                steps.pop();
            }
            _ => steps.push(step),
        }
    }
    steps.join("/")
}

/// The bytes of a data URI, from behind `data:`.
fn decode_data(uri: &str) -> Result<Vec<u8>, &'static str> {
    let (kind, data) = uri.split_once(',').ok_or("is a data URI without data; export the model again")?;
    if !kind.ends_with(";base64") {
        return Ok(percent_decode_str(data).collect());
    }
    let data: Cow<'_, [u8]> = percent_decode_str(data).into();
    BASE64.decode(data).map_err(|_| "is a data URI whose base64 is damaged; export the model again")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(model: &str, uri: &str) -> Result<Location, &'static str> {
        Companions::new(model, &mut |_| unreachable!("nothing is read")).locate(uri)
    }

    fn file(path: &str) -> Result<Location, &'static str> {
        Ok(Location::File(path.to_owned()))
    }

    #[test]
    fn files_are_sought_in_the_model_s_folder() {
        assert_eq!(at("a.gltf", "b.bin"), file("b.bin"));
        assert_eq!(at("models/a.gltf", "./wall%201.png"), file("models/wall 1.png"));
        assert_eq!(at("models/a.gltf", "../b/c.bin"), file("b/c.bin"));
        assert_eq!(at("a.gltf", "../../b.bin"), file("../../b.bin"));
        assert_eq!(at("/srv/a.gltf", "t\\b.png"), file("/srv/t/b.png"));
        assert_eq!(at("/srv/a.gltf", "C:\\work\\b.png"), file("/srv/b.png"));
        assert_eq!(at("m/a.gltf", "/home/somebody/b.png"), file("m/b.png"));
        assert!(at("a.gltf", "https://example.org/b.png").is_err());
    }

    #[test]
    fn data_uris_hold_their_bytes() {
        let octets = "data:application/octet-stream;base64";
        let inside = |bytes: &[u8]| Ok(Location::Inside(bytes.to_vec()));
        assert_eq!(at("a.gltf", &format!("{octets},Zm9v")), inside(b"foo"));
        assert_eq!(at("a.gltf", &format!("{octets},aGk=")), inside(b"hi"));
        assert_eq!(at("a.gltf", &format!("{octets},aGk")), inside(b"hi"));
        assert_eq!(at("a.gltf", "data:,a%00b"), inside(b"a\0b"));
        assert!(at("a.gltf", &format!("{octets},Zm9v*")).is_err());
        assert!(at("a.gltf", "data:nothing").is_err());
    }
}
