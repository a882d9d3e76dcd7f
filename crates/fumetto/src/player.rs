//! Time: one scene, played to one moment.

use std::{collections::BTreeMap, ops::Range};

use fumetto_formats::{Model, ModelOptions, is_sequence, sequence_path};
use fumetto_scene::{
    Given, Ink, InkMethod, Matter, Mesh, Object, Particle, Puffs, Ramp, RampImage, Scene, Shape, Style,
    Surface, SurfacePlan,
};
use wgpu::util::DeviceExt as _;

use crate::{
    Assets, Error,
    assets::{load_image, load_model, load_particles},
    details::{Details, Layer},
    gpu::Gpu,
    light::LightsUniform,
    morph::Tracks,
    object::ObjectStyle,
    particles::Plume,
    shapes::{
        mesh::{Geometry, MeshScene, Shells, candidates},
        puffs::{Atlas, Placement, PuffObject, PuffScene, still_puffs},
        surface::{SurfaceObject, SurfaceScene, peak_of_nothing},
        volume::{VolumeObject, VolumeScene},
    },
    tone::{Backdrop, Ramps},
};

/// Bytes of the largest record that there is one of for each particle.
const RECORD_BYTES: u64 = 64;

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
    pub(crate) ramps: Ramps,
    pub(crate) backdrop: Backdrop,
    /// Steps of the simulation done so far.
    pub(crate) steps: u64,
    /// The frame that is shown.
    pub(crate) shown: Option<u32>,
    notes: Vec<String>,
}

/// One object as it is played.
pub(crate) struct PlayedObject {
    pub(crate) matter: PlayedMatter,
    pub(crate) placement: Placement,
    /// Room for this many puffs.
    capacity: u32,
}

pub(crate) enum PlayedMatter {
    Still(Vec<Particle>),
    /// A numbered sequence of particle files, and the particles of the frame that is shown.
    Sequence(String, Vec<Particle>),
    /// Particles that become others.
    Morph(Box<Tracks>),
    Smoke(Box<Plume>),
    Model(Box<PlayedModel>),
}

/// A model with its copies, and which parts of the scene's geometry they are.
pub(crate) struct PlayedModel {
    mesh: Mesh,
    pub(crate) model: Model,
    pub(crate) parts: Range<usize>,
}

impl PlayedMatter {
    fn count(&self) -> u64 {
        match self {
            Self::Still(particles) | Self::Sequence(_, particles) => particles.len() as u64,
            Self::Morph(tracks) => tracks.slots() as u64,
            Self::Smoke(plume) => plume.emissions.iter().map(|emission| u64::from(emission.capacity())).sum(),
            Self::Model(_) => 0,
        }
    }

    fn is_model(&self) -> bool {
        matches!(self, Self::Model(_))
    }
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
                Matter::Mesh(mesh) => play_mesh(mesh, &object.style, &*assets, &mut geometry, &mut notes)?,
                _ => play_matter(gpu, &scene, object, index, &*assets, first_frame, &mut notes)?,
            };
            notes.extend(note_on_nothing(object, &matter));
            match object.shape.surface() {
                Some(surface) => {
                    add_surface(&mut geometry, &scene, object, (surface, &object.style.ink), &matter);
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
            add_surface(&mut geometry, &scene, object, (&detail.surface, &detail.ink), matter);
        }
        for (index, object) in scene.objects.iter().enumerate() {
            if matches!(object.matter, Matter::Mesh(_)) && object.style.ink.method == InkMethod::Shell {
                geometry.find_pushes(index);
            }
        }
        let puffs = place(gpu, &scene, &mut objects, atlas)?;
        let surfaces = surfaces(gpu, &scene, &details, &objects)?;
        let volumes = volumes(gpu, &scene, &objects)?;
        // Layers of detail come after the scene's objects, and throw no shadows.
        let casts =
            |object: u32| scene.objects.get(object as usize).is_some_and(|object| scene.casts(object));
        let shells = Shells::new(&geometry, casts);
        let meshes = MeshScene::new(gpu, &geometry, &shells, &candidates(&geometry, &crease_degs(&scene)))?;
        let ramps = load_ramps(gpu, &scene, &*assets)?;
        let backdrop = load_backdrop(gpu, &scene, &*assets)?;
        let (steps, shown) = (0, None);
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
            ramps,
            backdrop,
            steps,
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

    /// The scene's objects, then the layers of detail in them.
    pub(crate) fn drawn(&self) -> Vec<&Object> {
        self.scene.objects.iter().chain(self.details.objects()).collect()
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
            | PlayedMatter::Model(_) => None,
        })
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
        let stands = |object: &PlayedObject| match &object.matter {
            PlayedMatter::Still(_) => !drifts(&self.scene.objects[object.placement.object as usize]),
            PlayedMatter::Sequence(..) | PlayedMatter::Morph(_) | PlayedMatter::Smoke(_) => false,
            PlayedMatter::Model(played) => !played.model.is_animated(),
        };
        if self.objects.iter().all(stands) { 0 } else { self.held(frame) }
    }

    /// The frame whose state is drawn when `frame` is asked for: every second one on twos.
    pub(crate) fn held(&self, frame: u32) -> u32 {
        frame - frame % self.scene.time.hold
    }

    /// Reads the files that sequences have for `frame`, and makes room for their particles.
    pub(crate) fn read_sequences(&mut self, gpu: &Gpu, frame: u32) -> Result<(), Error> {
        let mut grown = false;
        for object in &mut self.objects {
            if let PlayedMatter::Sequence(pattern, particles) = &mut object.matter {
                *particles = load_particles(&*self.assets, &sequence_path(pattern, frame))?.particles;
                grown |= particles.len() as u32 > object.capacity;
                object.capacity = object.capacity.max(particles.len() as u32);
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
                PlayedMatter::Still(_) | PlayedMatter::Smoke(_) | PlayedMatter::Model(_) => {}
            }
        }
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

/// Refuses a scene whose particles would not fit, before anything is allocated.
fn check_room(gpu: &Gpu, scene: &Scene) -> Result<(), Error> {
    let asked = scene.requirements().iter().filter_map(|cost| cost.particles).sum();
    let allowed = gpu.device.limits().max_storage_buffer_binding_size / RECORD_BYTES;
    if asked > allowed { Err(Error::TooMany { asked, allowed }) } else { Ok(()) }
}

/// The atlas of all objects' puffs, and where in it each object's variants begin.
fn atlas(gpu: &Gpu, scene: &Scene) -> Result<(Vec<u32>, Atlas), Error> {
    let mut kinds: Vec<Puffs> = Vec::new();
    let mut firsts = Vec::with_capacity(scene.objects.len());
    for object in &scene.objects {
        let (Shape::Puffs(puffs), false) = (&object.shape, matches!(object.matter, Matter::Mesh(_))) else {
            firsts.push(0);
            continue;
        };
        let puffs = Puffs { size: 1.0, ..*puffs };
        let known = kinds.iter().position(|kind| *kind == puffs).unwrap_or_else(|| {
            kinds.push(puffs);
            kinds.len() - 1
        });
        firsts.push(kinds[..known].iter().map(|kind| kind.variants).sum());
    }
    Ok((firsts, Atlas::new(gpu, &kinds)?))
}

/// For each object the angle from which on edges are creases, where it wants lines along them.
fn crease_degs(scene: &Scene) -> Vec<Option<f32>> {
    let wanted = |ink: &Ink| ink.on && matches!(ink.method, InkMethod::Vector | InkMethod::Hybrid);
    let inks = scene.objects.iter().map(|object| &object.style.ink);
    inks.map(|ink| wanted(ink).then_some(ink.crease_deg)).collect()
}

fn seed_of(scene: &Scene, index: u32) -> u32 {
    scene.seed.wrapping_mul(0x85eb_ca6b).wrapping_add(index.wrapping_mul(0xc2b2_ae35))
}

fn play_mesh(
    mesh: &Mesh,
    style: &Style,
    assets: &dyn Assets,
    geometry: &mut Geometry,
    notes: &mut Vec<String>,
) -> Result<PlayedMatter, Error> {
    let model = load_model(assets, &mesh.model, ModelOptions { smooth_degrees: mesh.smooth_deg })?;
    notes.extend(model.notes.iter().cloned());
    let parts = geometry.add(mesh, &model);
    if style.exaggerate.amount > 0.0 {
        geometry.smooth(&parts, style.exaggerate.scales);
    }
    Ok(PlayedMatter::Model(Box::new(PlayedModel { mesh: mesh.clone(), model, parts })))
}

fn play_matter(
    gpu: &Gpu,
    scene: &Scene,
    object: &Object,
    index: u32,
    assets: &dyn Assets,
    first_frame: u32,
    notes: &mut Vec<String>,
) -> Result<PlayedMatter, Error> {
    Ok(match &object.matter {
        Matter::Still(particles) => PlayedMatter::Still(particles.clone()),
        Matter::File(path) => {
            let table = load_particles(assets, &sequence_path(path, first_frame))?;
            notes.extend(table.notes);
            if is_sequence(path) {
                PlayedMatter::Sequence(path.clone(), table.particles)
            } else {
                PlayedMatter::Still(table.particles)
            }
        }
        Matter::Morph(morph) => {
            let mut sets = Vec::with_capacity(morph.changes.len() + 1);
            for given in morph.all() {
                sets.push(match given {
                    Given::Listed(particles) => particles.clone(),
                    Given::File(path) => {
                        let table = load_particles(assets, path)?;
                        notes.extend(table.notes);
                        table.particles
                    }
                });
            }
            PlayedMatter::Morph(Box::new(Tracks::new(morph, sets)))
        }
        Matter::Smoke(smoke) => {
            let seed = seed_of(scene, index);
            PlayedMatter::Smoke(Box::new(Plume::new(gpu, smoke, seed, scene.time.step_secs())))
        }
        Matter::Mesh(_) => unreachable!("models are played with the scene's geometry"),
    })
}

/// Gives every object its place in the list of puffs.
fn place(gpu: &Gpu, scene: &Scene, objects: &mut [PlayedObject], atlas: Atlas) -> Result<PuffScene, Error> {
    let asked = objects.iter().map(|object| u64::from(object.capacity)).sum();
    let allowed = gpu.device.limits().max_storage_buffer_binding_size / RECORD_BYTES;
    if asked > allowed {
        return Err(Error::TooMany { asked, allowed });
    }
    let mut first = 0;
    let mut ranges = Vec::with_capacity(objects.len());
    for (played, object) in objects.iter_mut().zip(&scene.objects) {
        played.placement.first = first;
        let range = first..first + played.capacity;
        first = range.end;
        ranges.push(PuffObject { range, wants_form: object.visible && wants_form(object) });
    }
    Ok(PuffScene::new(gpu, atlas, ranges, size_of::<ObjectStyle>() as u64))
}

/// Normals of puffs and volumes bend toward the form, and relief is what stands out from it.
fn wants_form(object: &Object) -> bool {
    let bends = object.style.form > 0.0 && object.shape.surface().is_none();
    bends || object.style.exaggerate.amount > 0.0
}

/// How many kinds of puffs an object's particles choose from: bundles of balls, or colours. Particles of a surface
/// are never drawn singly.
fn variants_of(shape: &Shape) -> u32 {
    match shape {
        Shape::Puffs(puffs) => puffs.variants,
        Shape::Volume(volume) => volume.colours.len().max(1) as u32,
        Shape::Surface(_) => 1,
    }
}

/// All volumes, of puffs that have their places.
fn volumes(gpu: &Gpu, scene: &Scene, objects: &[PlayedObject]) -> Result<VolumeScene, Error> {
    let mut volumes = Vec::new();
    for (index, (object, played)) in scene.objects.iter().zip(objects).enumerate() {
        let Some(volume) = object.shape.volume() else { continue };
        let room = match &played.matter {
            PlayedMatter::Still(particles) => volume.room(particles),
            PlayedMatter::Sequence(..) | PlayedMatter::Morph(_) | PlayedMatter::Smoke(_) => {
                volume.moving_room()
            }
            PlayedMatter::Model(_) => continue,
        };
        let first = played.placement.first;
        let volume = VolumeObject {
            object: index,
            volume: volume.clone(),
            room,
            puffs: first..first + played.capacity,
            moves: !matches!(played.matter, PlayedMatter::Still(_)),
            shadows: object.style.shadow.on,
        };
        volume.check().map_err(|source| Error::Volume { object: object.name.clone(), source })?;
        volumes.push(volume);
    }
    let lights = gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
        label: Some("player.lights"),
        contents: bytemuck::bytes_of(&LightsUniform::of(scene)),
        usage: wgpu::BufferUsages::UNIFORM,
    });
    Ok(VolumeScene::new(gpu, volumes, lights))
}

/// Makes room for a surface of an object's `matter` and for the lines that are drawn of it.
fn add_surface(
    geometry: &mut Geometry,
    scene: &Scene,
    object: &Object,
    (surface, ink): (&Surface, &Ink),
    matter: &PlayedMatter,
) {
    let has_lines = ink.on && ink.method == InkMethod::Vector;
    match plan(scene, object, surface, matter) {
        Some(plan) => geometry.add_surface(plan.room.vertices, plan.room.triangles, has_lines),
        None => geometry.add_nothing(),
    }
}

/// What a surface of an object's `matter` is made with.
fn plan(scene: &Scene, object: &Object, surface: &Surface, matter: &PlayedMatter) -> Option<SurfacePlan> {
    match (matter, &object.matter) {
        (PlayedMatter::Still(particles), _) => Some(surface.plan(particles)),
        (PlayedMatter::Morph(tracks), _) => Some(surface.plan_morph(&tracks.sets())),
        (PlayedMatter::Sequence(_, particles), _) => Some(surface.plan_sequence(particles)),
        (PlayedMatter::Smoke(_), Matter::Smoke(smoke)) => {
            Some(surface.plan_smoke(smoke, scene.time.step_secs()))
        }
        _ => None,
    }
}

/// Says so where a cloud is too thin for its surface.
fn note_on_nothing(object: &Object, matter: &PlayedMatter) -> Option<String> {
    let (Some(surface), PlayedMatter::Still(particles)) = (object.shape.surface(), matter) else {
        return None;
    };
    let peak = peak_of_nothing(surface, particles)?;
    Some(format!(
        "the surface of `{}` is empty: its particles are at most about {peak} dense, and its `threshold` is {}",
        object.name, surface.threshold
    ))
}

/// All surfaces, of puffs that have their places: those of the objects, then the layers of detail in them.
fn surfaces(
    gpu: &Gpu,
    scene: &Scene,
    details: &Details,
    objects: &[PlayedObject],
) -> Result<SurfaceScene, Error> {
    let outer = (0..)
        .zip(&scene.objects)
        .filter_map(|(number, object)| Some((number, *object.shape.surface()?, 1.0)));
    let inner = details.layers().iter().map(|layer| (layer.object, layer.detail.surface, layer.detail.mass));
    let mut surfaces = Vec::new();
    for (number, surface, mass) in outer.chain(inner) {
        let (object, played) = (&scene.objects[number], &objects[number]);
        let Some(plan) = plan(scene, object, &surface, &played.matter) else { continue };
        let first = played.placement.first;
        let puffs = first..first + played.capacity;
        let still = match &played.matter {
            PlayedMatter::Still(particles) if !surface.drifts() => Some(particles.as_slice()),
            _ => None,
        };
        let scales = [surface.size / played.placement.size, mass];
        let surface = SurfaceObject { surface, scales, plan, puffs, still };
        surface.check(gpu).map_err(|source| Error::Surface { object: object.name.clone(), source })?;
        surfaces.push(surface);
    }
    Ok(SurfaceScene::new(gpu, &surfaces))
}

fn load_ramps(gpu: &Gpu, scene: &Scene, assets: &dyn Assets) -> Result<Ramps, Error> {
    // Objects often share a ramp image; each file is read once.
    let mut images = BTreeMap::new();
    for object in &scene.objects {
        if let Ramp::Image(RampImage { path, .. }) = &object.style.ramp
            && !images.contains_key(path)
        {
            images.insert(path.clone(), load_image(assets, path)?);
        }
    }
    Ok(Ramps::new(gpu, &scene.objects, &images))
}

fn load_backdrop(gpu: &Gpu, scene: &Scene, assets: &dyn Assets) -> Result<Backdrop, Error> {
    let image = match &scene.background {
        fumetto_scene::Background::Image(path) => Some(load_image(assets, path)?),
        _ => None,
    };
    Ok(Backdrop::new(gpu, &scene.background, image.as_ref()))
}
