use std::path::Path;

use fumetto_disk as disk;
use fumetto_formats::{
    Drawing, Grid, Solid, VdbOptions, write_glb, write_mtl, write_obj, write_particles_csv,
    write_particles_ply, write_pdf, write_solids_ply, write_svg, write_vdb,
};
use fumetto_scene::Particle;
use serde_json::{Value, json};

use super::{Plan, drawings};
use crate::args::{Format, What};
use crate::stage::Stage;

/// Half floats are as exact as what rays go through.
const PACKED: VdbOptions = VdbOptions { zip: true, half: true };

/// What a file will hold.
pub(super) enum Contents {
    Meshes { solids: Vec<Solid>, notes: Vec<String> },
    Particles(Vec<Particle>),
    Volumes(Vec<Grid>),
    Drawing(Box<Drawing>),
}

impl Contents {
    /// Of the moment that `stage` is at.
    pub(super) fn of(plan: &Plan, stage: &mut Stage) -> anyhow::Result<Self> {
        if plan.what == What::Drawings {
            return Ok(Self::Drawing(Box::new(stage.vector(&plan.shot, &plan.options)?)));
        }
        if plan.what == What::Particles {
            let mut particles = Vec::new();
            for &object in &plan.objects {
                particles.extend(stage.particles(object)?);
            }
            return Ok(Self::Particles(particles));
        }
        if plan.what == What::Volumes {
            return Ok(Self::Volumes(volumes(plan, stage)?));
        }
        let (mut solids, mut notes) = (Vec::new(), Vec::new());
        for &object in &plan.objects {
            if let Some(export) = stage.solid(object)? {
                solids.push(export.solid);
                notes.extend(export.notes);
            }
        }
        Ok(Self::Meshes { solids, notes })
    }

    pub(super) fn notes(&self) -> &[String] {
        match self {
            Self::Meshes { notes, .. } => notes,
            Self::Particles(_) | Self::Volumes(_) | Self::Drawing(_) => &[],
        }
    }

    pub(super) fn write(&self, plan: &Plan, file: &str) -> anyhow::Result<()> {
        let path = Path::new(file);
        match self {
            Self::Particles(particles) if plan.target.format == Format::Csv => {
                disk::write(path, |draft| write_particles_csv(particles, draft))
            }
            Self::Particles(particles) => disk::write(path, |draft| write_particles_ply(particles, draft)),
            Self::Volumes(grids) => disk::write(path, |draft| write_vdb(grids, PACKED, draft)),
            Self::Drawing(drawing) if plan.target.format == Format::Pdf => {
                let page = std::slice::from_ref(&**drawing);
                disk::write(path, |draft| write_pdf(page, draft))
            }
            Self::Drawing(drawing) => disk::write(path, |draft| write_svg(drawing, draft)),
            Self::Meshes { solids, .. } => match plan.target.format {
                Format::Obj => write_obj_and_mtl(solids, path),
                Format::Ply => disk::write(path, |draft| write_solids_ply(solids, draft)),
                _ => disk::write(path, |draft| write_glb(solids, draft)),
            },
        }
    }

    /// In words, and for programs.
    pub(super) fn told(&self) -> (String, Value) {
        match self {
            Self::Particles(particles) => {
                (format!("{} particles", particles.len()), json!({ "particles": particles.len() }))
            }
            Self::Volumes(grids) => {
                let voxels: u64 = grids.iter().map(|grid| grid.voxels.active_count()).sum();
                let names: Vec<&str> = grids.iter().map(|grid| grid.name.as_str()).collect();
                (
                    format!("{voxels} voxels in {}", names.join(", ")),
                    json!({ "voxels": voxels, "grids": names }),
                )
            }
            Self::Drawing(drawing) => drawings::told(drawing),
            Self::Meshes { solids, notes } => {
                let triangles: usize = solids.iter().map(Solid::triangle_count).sum();
                let vertices: usize = solids.iter().map(|solid| solid.positions.len()).sum();
                let objects: Vec<Value> = solids.iter().map(solid_json).collect();
                let words = format!("{triangles} triangles, {vertices} vertices");
                (
                    words,
                    json!({ "triangles": triangles, "vertices": vertices, "objects": objects, "notes": notes }),
                )
            }
        }
    }
}

/// The grids of all objects. What other programs look for by its name is left to one object; those of several are
/// called after them.
fn volumes(plan: &Plan, stage: &Stage) -> anyhow::Result<Vec<Grid>> {
    let mut all = Vec::new();
    for &object in &plan.objects {
        let mut grids = stage.volume(object)?;
        if plan.objects.len() > 1 {
            let name = stage.name_of(object);
            grids.iter_mut().for_each(|grid| grid.name = format!("{name}.{}", grid.name));
        }
        all.extend(grids);
    }
    Ok(all)
}

fn solid_json(solid: &Solid) -> Value {
    json!({ "name": solid.name, "triangles": solid.triangle_count(), "vertices": solid.positions.len() })
}

/// The materials come first: where the .obj is, they are.
fn write_obj_and_mtl(solids: &[Solid], path: &Path) -> anyhow::Result<()> {
    let library = path.with_extension("mtl");
    let name = library.file_name().unwrap_or_default().to_string_lossy().into_owned();
    disk::write(&library, |draft| write_mtl(solids, draft))?;
    disk::write(path, |draft| write_obj(solids, &name, draft))
}
