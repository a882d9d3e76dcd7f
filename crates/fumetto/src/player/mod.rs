//! Time: one scene, played to one moment.

mod imported;
mod looks;
mod matter;
mod motion;
mod obstacles;
mod paints;
mod puffs;
mod renew;
mod surfaces;
mod volumes;

pub use imported::{ImportedSize, imported_size};
pub(crate) use imported::{load as load_imported, path as imported_path};
pub(crate) use looks::Look;
pub(crate) use matter::{PlayedMatter, PlayedModel, PlayedObject};

use std::ops::Range;

use fumetto_formats::sequence_path;
use fumetto_scene::{Ink, Matter, Object, Particle, Scene, Shape};

use crate::{
    Assets, Error,
    assets::load_particles,
    details::{Details, Layer},
    gpu::{Frame, Gpu},
    ink::StrokeTextures,
    paint::{PaintScene, Surroundings},
    particles::Plume,
    shapes::{
        mesh::{Geometry, MeshScene, Shells, candidates, seams},
        puffs::{Placement, PuffScene, still_puffs},
        surface::SurfaceScene,
        volume::VolumeScene,
    },
    tone::Backdrop,
};
use looks::{crease_degs, exaggerated_scales, has_strokes, load_backdrop, load_strokes, wants_shell};
use matter::{note_on_nothing, play_matter, play_mesh, seed_of};
use paints::notes_on_paint;
use puffs::{atlas, check_room, place, variants_of};
use surfaces::{add_surface, has_contours, surfaces};
use volumes::volumes;

/// A scene at one moment, with all that it takes to draw it.
pub struct Player {
    scene: Scene,
    assets: Box<dyn Assets>,
    pub(crate) objects: Vec<PlayedObject>,
    pub(crate) puffs: PuffScene,
    pub(crate) meshes: MeshScene,
    pub(crate) surfaces: SurfaceScene,
    pub(crate) details: Details,
    pub(crate) volumes: VolumeScene,
    pub(crate) geometry: Geometry,
    pub(crate) paints: PaintScene,
    /// The first is the scene's own; the others are those of paints.
    pub(crate) looks: Vec<Look>,
    pub(crate) backdrop: Backdrop,
    /// Where anything has strokes.
    pub(crate) strokes: Option<StrokeTextures>,
    /// Steps of the simulation done so far.
    pub(crate) steps: u64,
    /// Whether all is there that the next step needs, and not only what pictures show.
    pub(crate) can_go_on: bool,
    /// The frame that is shown.
    pub(crate) shown: Option<u32>,
    notes: Vec<String>,
}

impl Player {
    pub(crate) fn new(gpu: &Gpu, scene: Scene, assets: Box<dyn Assets>) -> Result<Self, Error> {
        check_room(gpu, &scene)?;
        let mut notes = Vec::new();
        let first_frame = scene.time.frames[0] - scene.time.frames[0] % scene.time.hold;
        let (variants, atlas) = atlas(gpu, &scene)?;
        let mut objects = Vec::with_capacity(scene.objects.len());
        let mut geometry = Geometry::default();
        for (index, object) in (0..).zip(&scene.objects) {
            let matter = match &object.matter {
                Matter::Mesh(mesh) => {
                    let scales = exaggerated_scales(&scene, index as usize);
                    play_mesh(mesh, scales, &*assets, &mut geometry, &mut notes)?
                }
                _ => play_matter(gpu, &scene, object, index, &*assets, first_frame, &mut notes)?,
            };
            notes.extend(note_on_nothing(object, &matter));
            match object.shape.surface() {
                Some(surface) => {
                    let has_lines = scene.styles_of(index as usize).any(|style| has_contours(&style.ink));
                    add_surface(&mut geometry, &scene, object, (surface, has_lines), &matter);
                }
                None if matter.is_model() => {}
                None => geometry.add_nothing(),
            }
            let capacity = matter.count() as u32;
            let placement = Placement {
                first: 0,
                object: index,
                first_variant: variants[index as usize],
                variants: variants_of(&object.shape),
                size: object.shape.size(),
                seed: seed_of(&scene, index),
            };
            objects.push(PlayedObject { matter, placement, capacity });
        }
        let details = Details::new(&scene);
        for Layer { object, detail, .. } in details.layers() {
            let (object, matter) = (&scene.objects[*object], &objects[*object].matter);
            add_surface(&mut geometry, &scene, object, (&detail.surface, has_contours(&detail.ink)), matter);
        }
        for (index, object) in scene.objects.iter().enumerate() {
            if matches!(object.matter, Matter::Mesh(_)) && wants_shell(&scene, index) {
                geometry.find_pushes(index);
            }
        }
        notes.extend(obstacles::check(&scene, &objects)?);
        let puffs = place(gpu, &scene, &mut objects, atlas)?;
        let surfaces = surfaces(gpu, &scene, &details, &objects)?;
        let volumes = volumes(gpu, &scene, &objects)?;
        // Layers of detail come after the scene's objects, and throw no shadows.
        let casts =
            |object: u32| scene.objects.get(object as usize).is_some_and(|object| scene.casts(object));
        let shells = Shells::new(&geometry, casts);
        let has_strokes = has_strokes(&scene);
        let seams = if has_strokes { seams(&geometry) } else { Vec::new() };
        let candidates = candidates(&geometry, &crease_degs(&scene));
        let meshes = MeshScene::new(gpu, &geometry, &shells, &candidates, &seams)?;
        let strokes = if has_strokes { Some(load_strokes(gpu, &scene, &*assets)?) } else { None };
        let emissions = |index: usize| match objects.get(index).map(|object: &PlayedObject| &object.matter) {
            Some(PlayedMatter::Smoke(plume)) => &*plume.emissions,
            _ => &[],
        };
        let around = Surroundings { geometry: &geometry, emissions: &emissions };
        let paints = PaintScene::new(gpu, &scene, around, |index| seed_of(&scene, index as u32));
        notes.extend(notes_on_paint(&scene, &objects, &geometry, &paints));
        let looks = Look::all(gpu, &scene, &details, &*assets)?;
        let backdrop = load_backdrop(gpu, &scene, &*assets)?;
        let (steps, can_go_on, shown) = (0, true, None);
        Ok(Self {
            scene,
            assets,
            objects,
            puffs,
            meshes,
            surfaces,
            details,
            volumes,
            geometry,
            paints,
            looks,
            backdrop,
            strokes,
            steps,
            can_go_on,
            shown,
            notes,
        })
    }

    /// The scene that is played.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Where the files that the scene names come from.
    pub(crate) fn assets(&self) -> &dyn Assets {
        &*self.assets
    }

    /// The scene's objects, then the layers of detail in them, in the scene's own look.
    pub(crate) fn drawn(&self) -> Vec<&Object> {
        self.looks[0].drawn().iter().collect()
    }

    /// The frame that the simulation has come to; `None` where nothing is simulated, and every frame is as near.
    #[must_use]
    pub fn reached(&self) -> Option<u32> {
        let steps = if self.can_go_on { self.steps } else { 0 };
        let time = self.scene.time;
        let frames = steps.saturating_sub(time.pre_roll_steps()) / u64::from(time.substeps);
        self.simulates().then(|| u32::try_from(frames).unwrap_or(u32::MAX))
    }

    /// Things to tell the user about the files that were read.
    #[must_use]
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// Room for this many puffs in all.
    #[must_use]
    pub fn capacity(&self) -> u32 {
        self.puffs.count
    }

    /// All smoke.
    pub(crate) fn plumes(&self) -> impl Iterator<Item = &Plume> {
        self.objects.iter().filter_map(|object| match &object.matter {
            PlayedMatter::Smoke(plume) => Some(&**plume),
            PlayedMatter::Still(_)
            | PlayedMatter::Sequence(..)
            | PlayedMatter::Morph(_)
            | PlayedMatter::Model(_)
            | PlayedMatter::Imported(_)
            | PlayedMatter::Paint => None,
        })
    }

    /// For each volume out of a file, the numbers of the puffs that stand for it.
    pub(crate) fn lobes(&self) -> Vec<Range<u32>> {
        let imported =
            self.objects.iter().filter(|object| matches!(object.matter, PlayedMatter::Imported(_)));
        let lobes = imported.map(|object| {
            let first = object.placement.first;
            first..first + object.capacity
        });
        lobes.collect()
    }

    /// The number of the drawing that `frame` shows: frames that are held share one, and so do all frames
    /// of a scene in which nothing moves.
    #[must_use]
    pub fn drawing(&self, frame: u32) -> u32 {
        let drifts = |object: &Object| match &object.shape {
            Shape::Puffs(_) => false,
            Shape::Surface(surface) => surface.drifts(),
            Shape::Volume(volume) => volume.drifts(),
        };
        let boils = self.scene.inks().flat_map(Ink::strokes).any(|stroke| stroke.boil > 0);
        let stands = |object: &PlayedObject| match &object.matter {
            PlayedMatter::Still(_) => !drifts(&self.scene.objects[object.placement.object as usize]),
            PlayedMatter::Sequence(..)
            | PlayedMatter::Morph(_)
            | PlayedMatter::Smoke(_)
            | PlayedMatter::Paint => false,
            PlayedMatter::Model(played) => !played.model.is_animated(),
            PlayedMatter::Imported(volume) => !volume.is_sequence(),
        };
        if self.objects.iter().all(stands) && !boils { 0 } else { self.held(frame) }
    }

    /// The frame whose state is drawn when `frame` is asked for: every second one on twos.
    pub(crate) fn held(&self, frame: u32) -> u32 {
        frame - frame % self.scene.time.hold
    }

    /// Reads the files that sequences have for `frame`, and makes room for what is in them.
    pub(crate) fn read_sequences(&mut self, gpu: &Gpu, frame: u32) -> Result<(), Error> {
        let mut grown = false;
        for (number, object) in self.objects.iter_mut().enumerate() {
            match &mut object.matter {
                PlayedMatter::Sequence(pattern, particles) => {
                    *particles = load_particles(&*self.assets, &sequence_path(pattern, frame))?.particles;
                    grown |= particles.len() as u32 > object.capacity;
                    object.capacity = object.capacity.max(particles.len() as u32);
                }
                PlayedMatter::Imported(volume) => {
                    if volume.seek(gpu, &*self.assets, frame)? {
                        self.volumes.renew(number, volume.field.clone());
                        self.surfaces.renew(number, &volume.field);
                    }
                }
                PlayedMatter::Paint
                | PlayedMatter::Still(_)
                | PlayedMatter::Morph(_)
                | PlayedMatter::Smoke(_)
                | PlayedMatter::Model(_) => {}
            }
        }
        if grown {
            let (_, atlas) = atlas(gpu, &self.scene)?;
            self.puffs = place(gpu, &self.scene, &mut self.objects, atlas)?;
            self.surfaces = surfaces(gpu, &self.scene, &self.details, &self.objects)?;
            self.volumes = volumes(gpu, &self.scene, &self.objects)?;
            self.upload_still(gpu);
        }
        self.upload_moving(gpu, frame);
        Ok(())
    }

    /// Moves the parts of animated models to where they are at `frame`.
    pub(crate) fn animate(&mut self, gpu: &Gpu, frame: u32) {
        let time_secs = self.secs(frame);
        for object in &self.objects {
            if let PlayedMatter::Model(played) = &object.matter
                && played.model.is_animated()
            {
                self.geometry.animate(played.parts.clone(), &played.mesh, &played.model, time_secs);
            }
        }
        self.meshes.upload_parts(gpu, &self.geometry.parts);
    }

    /// Writes the puffs of what does not move.
    pub(crate) fn upload_still(&self, gpu: &Gpu) {
        for object in &self.objects {
            if let PlayedMatter::Still(particles) = &object.matter {
                self.upload(gpu, object, particles);
            }
        }
    }

    fn upload_moving(&self, gpu: &Gpu, frame: u32) {
        for object in &self.objects {
            match &object.matter {
                PlayedMatter::Sequence(_, particles) => self.upload(gpu, object, particles),
                PlayedMatter::Morph(tracks) => self.upload(gpu, object, &tracks.at(self.secs(frame))),
                PlayedMatter::Imported(volume) => self.upload(gpu, object, &volume.balls),
                PlayedMatter::Still(_)
                | PlayedMatter::Smoke(_)
                | PlayedMatter::Model(_)
                | PlayedMatter::Paint => {}
            }
        }
    }

    /// Puts obstacles to where they are in a step. Models move with frames, also before frame 0.
    pub(crate) fn place_obstacles(&self, frame: &mut Frame<'_>, plume: &Plume, step: u64, dt: f64) {
        let time = (step as f64 - self.scene.time.pre_roll_steps() as f64) * dt;
        obstacles::place(frame, &self.objects, plume, step == 0, (time, dt));
    }

    /// The moment of a frame.
    pub(crate) fn secs(&self, frame: u32) -> f32 {
        frame as f32 / self.scene.time.fps
    }

    fn upload(&self, gpu: &Gpu, object: &PlayedObject, particles: &[Particle]) {
        let mut puffs = still_puffs(particles, object.placement);
        // What an earlier, longer frame left behind must not stay.
        puffs.resize(object.capacity as usize, bytemuck::Zeroable::zeroed());
        let offset = u64::from(object.placement.first) * size_of_val(&puffs[0]) as u64;
        gpu.queue.write_buffer(&self.puffs.puffs, offset, bytemuck::cast_slice(&puffs));
    }
}
