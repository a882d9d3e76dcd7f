//! Volumes out of files.

use super::{At, mesh::transform, morph::is_sequence};
use crate::file::{
    ByteOrderFile, ImportedFile, ObjectFile, RawFile, RawNumberFile, ReadFile, ShapeFile, UpFile,
};
use crate::{Imported, Raw, RawNumber, Transform};

/// Formats with a header that volumes are read from.
const EXTENSIONS: [&str; 3] = [".vdb", ".nrrd", ".npy"];

/// The volume of an object of kind "volume".
pub(super) fn imported(at: &At<'_>, file: &ObjectFile) -> Imported {
    let at_volume = at.key("volume");
    let read = match &file.volume {
        Some(ImportedFile::Read(read)) => (**read).clone(),
        Some(ImportedFile::Path(path)) => of_path(path.clone()),
        None => {
            let message = format!("the volume {:?} has no file", file.name);
            at.error("no-volume", message, "write volume = \"smoke.vdb\", the path of a file");
            of_path("none.vdb".to_owned())
        }
    };
    check_file(&at_volume, &read);
    check_sequence(&at_volume, &read);
    let at_place = at.key("transform");
    let places = file.transform.as_ref().map_or(&[][..], |transforms| transforms.as_slice());
    if at_place.exists() && places.len() != 1 {
        let message = format!("the volume {:?} stands at one place, not {}", file.name, places.len());
        at_place.error("one-place", message, "write an object for each copy");
    }
    Imported {
        raw: read.raw.map(raw),
        file: read.file,
        density: read.density,
        heat: read.heat,
        range: read.range,
        heat_range: read.heat_range,
        frames: read.frames,
        repeats: read.repeats,
        z_up: file.up == Some(UpFile::Z),
        place: places.first().map_or_else(Transform::default, |place| transform(&at_place.item(0), place)),
    }
}

fn of_path(file: String) -> ReadFile {
    let (range, heat_range) = (None, [0.0, 1.0]);
    ReadFile { file, density: None, heat: None, range, heat_range, frames: None, repeats: false, raw: None }
}

fn check_file(at: &At<'_>, read: &ReadFile) {
    let ReadFile { file: path, density, heat, range, heat_range, .. } = read;
    let lower = path.to_lowercase();
    let place = if at.key("file").exists() { at.key("file") } else { *at };
    if !at.key("raw").exists() && !EXTENSIONS.iter().any(|extension| lower.ends_with(extension)) {
        let message = format!("{path:?} is neither a .vdb, nor an .nrrd, nor an .npy file");
        let help = "export the volume as OpenVDB, or say with `raw` how its numbers lie in the file";
        place.error("unknown-format", message, help);
    }
    let has_grids = !at.key("raw").exists() && lower.ends_with(".vdb");
    for (key, name) in [("density", density), ("heat", heat)] {
        if name.is_some() && !has_grids {
            let message = format!("`{key}` names a grid, and only a .vdb file has several");
            at.key(key).error("no-grids", message, "leave it out");
        }
    }
    for (key, ends) in [("range", range.as_ref()), ("heat_range", Some(heat_range))] {
        if let Some([low, high]) = ends
            && low == high
        {
            let message = format!("`{key}` begins and ends at {low}");
            at.key(key).error("empty-range", message, "write two numbers that differ, as in [0, 255]");
        }
    }
    if heat.is_none() && at.key("heat_range").exists() {
        let message = "`heat_range` has no meaning without `heat`".to_owned();
        at.key("heat_range").error("no-heat", message, "name the grid that tells how hot matter is");
    }
}

fn check_sequence(at: &At<'_>, read: &ReadFile) {
    for key in ["frames", "loop"] {
        if at.key(key).exists() && !is_sequence(&read.file) {
            let message = format!("`{key}` is for sequences, and {:?} is one file", read.file);
            at.key(key).error("no-sequence", message, "number the files, as in smoke.####.vdb");
        }
    }
    match read.frames {
        Some([first, last]) if first > last => {
            let message = format!("`frames` runs from {first} back to {last}");
            at.key("frames").error("falling-range", message, format!("write [{last}, {first}]"));
        }
        None if read.repeats => {
            let message = "`loop` needs to know which file is the last".to_owned();
            at.key("loop").error(
                "endless-loop",
                message,
                "write `frames` with the first and the last number",
            );
        }
        _ => {}
    }
}

/// Refuses shapes that such a volume cannot have, and keys that only shapes of particles have.
pub(super) fn check_shape(at: &At<'_>, file: &ObjectFile) {
    let at_shape = at.key("shape");
    let (shape, keys): (_, &[&str]) = match &file.shape {
        Some(ShapeFile::Puffs(_)) => {
            let message = "a volume out of a file has no particles to be drawn like that".to_owned();
            let help = "write shape = { volume = {} } or shape = { surface = {} }, or leave `shape` out";
            return at_shape.error("wrong-shape", message, help);
        }
        Some(ShapeFile::Surface(_)) => {
            let at_heat = at.key("volume").key("heat");
            if at_heat.exists() {
                let help = "leave it out, or write shape = { volume = {} }";
                at_heat.error("wrong-kind", "`heat` is not seen on a surface".to_owned(), help);
            }
            ("surface", &["size", "per_radius", "detail"])
        }
        Some(ShapeFile::Volume(_)) => ("volume", &["profile", "edge", "size", "noise", "cells"]),
        None => return,
    };
    for key in keys {
        let at = at_shape.key(shape).key(key);
        if at.exists() {
            let message = format!("`{key}` is for particles, and this volume is read from a file");
            at.error("wrong-kind", message, "leave it out: the file tells where matter is");
        }
    }
}

fn raw(file: RawFile) -> Raw {
    let number = match file.number {
        RawNumberFile::U8 => RawNumber::U8,
        RawNumberFile::I8 => RawNumber::I8,
        RawNumberFile::U16 => RawNumber::U16,
        RawNumberFile::I16 => RawNumber::I16,
        RawNumberFile::U32 => RawNumber::U32,
        RawNumberFile::I32 => RawNumber::I32,
        RawNumberFile::F16 => RawNumber::F16,
        RawNumberFile::F32 => RawNumber::F32,
        RawNumberFile::F64 => RawNumber::F64,
    };
    Raw {
        size: file.size,
        number,
        big_endian: file.order == ByteOrderFile::Big,
        voxel_m: file.voxel,
        origin_m: file.origin,
        skip: file.skip,
    }
}
