//! Wavefront OBJ.

use super::companions::Companions;
use super::{Model, ModelOptions};
use crate::FormatError;

pub(super) fn read(
    path: &str,
    _bytes: &[u8],
    _options: ModelOptions,
    _companions: Companions<'_>,
) -> Result<Model, FormatError> {
    Err(FormatError::NoTriangles { file: path.to_owned() })
}
