//! `fumetto info`

mod json;
mod text;

use std::process::ExitCode;

use anyhow::Context as _;
use fumetto::{Assets as _, ImportedSize, Tiling, imported_size};
use fumetto_formats::{ModelOptions, is_sequence, read_model, read_particles, sequence_path};
use fumetto_scene::limits::PARTICLE_BYTES;
use fumetto_scene::{
    Background, Given, GridPlan, Light, LightKind, Matter, Object, Particle, Scene, Surface, SurfaceRoom,
    VolumeRoom, vortex_bytes,
};

use crate::args::InfoArgs;
use crate::console;
use crate::scene;
use fumetto_disk::SceneFolder;

pub(crate) fn run(args: &InfoArgs) -> anyhow::Result<ExitCode> {
    let opened = scene::open(&args.scene)?;
    let name = args.scene.scene.display().to_string();
    let loads = loads(&opened.scene, &opened.folder).with_context(|| name.clone())?;
    let text = if args.json {
        json::of(&name, &opened.scene, &loads).to_string()
    } else {
        text::of(&name, &opened.scene, &loads)
    };
    console::print(&text)?;
    Ok(ExitCode::SUCCESS)
}

/// How much one object holds.
#[derive(Clone, Default)]
struct Load {
    /// Most of them at once; of a sequence of files those of the first.
    particles: u64,
    /// Vortex particles, likewise.
    vortices: u64,
    /// The grid that its air is in.
    grid: Option<GridPlan>,
    /// Copies counted singly.
    triangles: u64,
    /// Room for a surface round the particles.
    surface: Option<SurfaceRoom>,
    casts: bool,
    /// Room for the layers of detail in it.
    details: Vec<SurfaceRoom>,
    /// Room for a volume's grids.
    volume: Option<VolumeRoom>,
    /// What a volume out of a file holds.
    imported: Option<ImportedSize>,
    paint: Option<PaintRoom>,
}

/// What paint takes.
#[derive(Clone, Copy)]
struct PaintRoom {
    volumes: u64,
    bytes: u64,
}

impl Load {
    fn of_file(object: &Object, path: &str, particles: &[Particle]) -> Self {
        let room = |surface: &Surface| planned(surface, path, particles);
        let surface = object.shape.surface().map(room);
        let details = object.details.iter().map(|detail| room(&detail.surface)).collect();
        let volume = object
            .shape
            .volume()
            .map(|volume| if is_sequence(path) { volume.moving_room() } else { volume.room(particles) });
        Self { particles: particles.len() as u64, surface, details, volume, ..Self::default() }
    }

    /// Bytes of the surface, and of what it throws shadows with.
    fn surface_bytes(&self) -> u64 {
        let shadows = |room: SurfaceRoom| if self.casts { room.shadow_bytes() } else { 0 };
        self.surface.map_or(0, |room| room.bytes().saturating_add(shadows(room)))
    }

    /// Of particles that become those of the next set, and so on.
    fn of_sets(object: &Object, sets: &[Vec<Particle>]) -> Self {
        let sets: Vec<&[Particle]> = sets.iter().map(Vec::as_slice).collect();
        let room = object.shape.surface().map(|surface| surface.plan_morph(&sets).room);
        let particles = sets.iter().map(|set| set.len() as u64).sum();
        let volume = object.shape.volume().map(fumetto_scene::Volume::moving_room);
        Self { particles, surface: room, volume, ..Self::default() }
    }

    fn bytes(&self) -> u64 {
        let details =
            self.details.iter().map(SurfaceRoom::bytes).fold(self.surface_bytes(), u64::saturating_add);
        let puffs = self.volume.map_or(0, |room| room.bytes());
        let volume = puffs.saturating_add(self.imported.as_ref().map_or(0, |size| size.bytes));
        self.particles
            .saturating_mul(PARTICLE_BYTES)
            .saturating_add(vortex_bytes(self.vortices))
            .saturating_add(self.grid.map_or(0, |grid| grid.bytes()))
            .saturating_add(details)
            .saturating_add(volume)
            .saturating_add(self.paint.map_or(0, |room| room.bytes))
    }
}

/// Room for a surface of particles that a file tells.
fn planned(surface: &Surface, path: &str, particles: &[Particle]) -> SurfaceRoom {
    let plan = if is_sequence(path) { surface.plan_sequence(particles) } else { surface.plan(particles) };
    plan.room
}

/// What each object holds.
fn loads(scene: &Scene, folder: &SceneFolder) -> anyhow::Result<Vec<Load>> {
    let read = |path: &str| folder.read(path).with_context(|| format!("cannot read `{path}`"));
    let loads = scene.objects.iter().zip(scene.requirements()).map(|(object, cost)| match &object.matter {
        Matter::File(path) => {
            let first = sequence_path(path, scene.time.frames[0]);
            Ok(Load::of_file(object, path, &read_particles(&first, &read(&first)?)?.particles))
        }
        Matter::Morph(morph) => {
            let mut sets = Vec::new();
            for given in morph.all() {
                sets.push(match given {
                    Given::Listed(particles) => particles.clone(),
                    Given::File(path) => read_particles(path, &read(path)?)?.particles,
                });
            }
            Ok(Load::of_sets(object, &sets))
        }
        Matter::Mesh(mesh) => {
            let options = ModelOptions { smooth_degrees: mesh.smooth_deg };
            let bytes = read(&mesh.model)?;
            let model = read_model(&mesh.model, &bytes, options, &mut |beside| folder.read(beside))?;
            let triangles = model.triangle_count() * mesh.copies.len() as u64;
            Ok(Load { triangles, ..Load::default() })
        }
        Matter::Imported(imported) => {
            let size = imported_size(folder, imported, scene.time.frames[0])?;
            let room = |surface: &Surface| planned(surface, &imported.file, &size.cover);
            Ok(Load { surface: object.shape.surface().map(room), imported: Some(size), ..Load::default() })
        }
        Matter::Paint(paint) => {
            let (volumes, bytes) = (paint.volumes(), paint.bytes());
            Ok(Load { paint: Some(PaintRoom { volumes, bytes }), ..Load::default() })
        }
        Matter::Still(_) | Matter::Smoke(_) => {
            let particles = cost.particles.unwrap_or_default();
            Ok(Load {
                particles,
                vortices: cost.vortices,
                grid: cost.grid,
                surface: cost.surface,
                details: cost.details,
                volume: cost.volume,
                ..Load::default()
            })
        }
    });
    let mut loads = loads.collect::<anyhow::Result<Vec<_>>>()?;
    for (load, object) in loads.iter_mut().zip(&scene.objects) {
        load.casts = scene.casts(object);
    }
    Ok(loads)
}

fn duration_secs(scene: &Scene) -> f64 {
    let [first, last] = scene.time.frames;
    (f64::from(last - first) + 1.0) / f64::from(scene.time.fps)
}

/// Whether the scene's picture is too large to be drawn at once by `WebGPU`'s default limits.
fn is_by_tiles(scene: &Scene) -> bool {
    let samples = scene.output.size.map(|pixels| pixels * scene.output.antialias);
    !Tiling::default().takes(samples, wgpu::Limits::default().max_texture_dimension_2d)
}

/// Of all objects together.
struct Sum {
    particles: u64,
    triangles: u64,
    bytes: u64,
}

fn sum(loads: &[Load]) -> Sum {
    let sum = |of: fn(&Load) -> u64| loads.iter().map(of).fold(0, u64::saturating_add);
    Sum {
        particles: sum(|load| load.particles),
        triangles: sum(|load| load.triangles),
        bytes: sum(Load::bytes),
    }
}

fn light_kind(light: &Light) -> &'static str {
    match light.kind {
        LightKind::Sun { .. } => "sun",
        LightKind::Point { .. } => "point",
    }
}

fn background(scene: &Scene) -> String {
    match &scene.background {
        Background::Transparent => "transparent".to_owned(),
        Background::Colour(colour) => hex(colour.to_srgb8()),
        Background::Gradient { top, bottom } => {
            format!("{} to {}", hex(top.to_srgb8()), hex(bottom.to_srgb8()))
        }
        Background::Image(path) => path.clone(),
        Background::Paper(colour) => format!("paper {}", hex(colour.to_srgb8())),
    }
}

fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}
