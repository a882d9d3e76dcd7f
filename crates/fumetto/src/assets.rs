use std::io;

use fumetto_formats::{Image, Model, ModelOptions, ParticleTable, read_model, read_particles, read_png};

use crate::Error;

/// Where the files that a scene names come from: a disk, a browser, memory.
pub trait Assets {
    /// The bytes of the file that the scene calls `path`.
    ///
    /// # Errors
    /// When there is no such file, or it cannot be read.
    fn read(&self, path: &str) -> io::Result<Vec<u8>>;
}

pub(crate) fn load_particles(assets: &dyn Assets, path: &str) -> Result<ParticleTable, Error> {
    Ok(read_particles(path, &read(assets, path)?)?)
}

pub(crate) fn load_image(assets: &dyn Assets, path: &str) -> Result<Image, Error> {
    Ok(read_png(path, &read(assets, path)?)?)
}

pub(crate) fn load_model(assets: &dyn Assets, path: &str, options: ModelOptions) -> Result<Model, Error> {
    Ok(read_model(path, &read(assets, path)?, options, &mut |beside| assets.read(beside))?)
}

pub(crate) fn read(assets: &dyn Assets, path: &str) -> Result<Vec<u8>, Error> {
    assets.read(path).map_err(|source| Error::Asset { path: path.to_owned(), source })
}
