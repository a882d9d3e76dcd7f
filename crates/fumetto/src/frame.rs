//! How a picture is drawn: the page that reads as it happens, top to bottom.

use fumetto_scene::{Matter, Object};
use glam::Vec3;

use crate::{
    Player, Shot,
    gpu::{Compact, DrawList, Frame, Gpu, TexturePool, Transient, View},
    ink::{Gather, Outline},
    layers::Layers,
    light::{LightsUniform, Shadows, Soften, Stencil},
    object::ObjectStyle,
    shapes::puffs::{Body, FRONT, Form, INK, Normal, Occlusion, PuffScene, Pyramid, REST, VERTICES},
    tone::{CEL_FORMAT, Compose, Flat, Under},
};

/// Shadows are cleaned over this many times the length that tones are: their specks come of single puffs,
/// which are larger than the bumps on them.
const SETTLE: f32 = 3.0;

/// All passes of a picture.
pub(crate) struct Painter {
    compact: Compact,
    occlusion: Occlusion,
    form: Form,
    body: Body,
    normal: Normal,
    shadows: Shadows,
    soften: Soften,
    outline: Outline,
    gather: Gather,
    flat: Flat,
    compose: Compose,
    room: Option<Room>,
}

/// What is needed for pictures of one size and scenes of one number of puffs.
struct Room {
    count: u32,
    pyramid: Pyramid,
    flags: wgpu::Buffer,
    /// For one pass after another.
    list: DrawList,
    inks: DrawList,
}

/// What all cels of one picture share.
struct Setting<'a> {
    player: &'a Player,
    view: View,
    lights: LightsUniform,
    samples: u32,
}

/// Objects that are drawn into layers of their own, like an animator's cels.
struct Cel {
    members: Vec<usize>,
}

impl Painter {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        Self {
            compact: Compact::new(gpu),
            occlusion: Occlusion::new(gpu),
            form: Form::new(gpu),
            body: Body::new(gpu),
            normal: Normal::new(gpu),
            shadows: Shadows::new(gpu),
            soften: Soften::new(gpu),
            outline: Outline::new(gpu),
            gather: Gather::new(gpu),
            flat: Flat::new(gpu),
            compose: Compose::new(gpu),
            room: None,
        }
    }

    /// Draws the moment that `player` is at.
    pub(crate) fn paint(
        &mut self,
        gpu: &Gpu,
        pool: &TexturePool,
        player: &Player,
        shot: &Shot,
        target: &wgpu::TextureView,
    ) {
        let view = View::new(&shot.camera, shot.size.map(|pixels| pixels * shot.antialias));
        let scene = player.scene();
        let shadows = scene.objects.iter().any(|object| object.visible && object.style.shadow.on);
        let lights = LightsUniform::new(&scene.lights, shadows);
        let setting = Setting { player, view, lights, samples: shot.antialias };
        self.make_room(gpu, &player.puffs, view.size);

        let mut picture: Option<Transient> = None;
        let mut opaque: Option<Layers> = None;
        let cels = cels(&scene.objects, Vec3::from(shot.camera.eye));
        for (index, cel) in cels.iter().enumerate() {
            write_styles(gpu, &setting, cel);
            let mut frame = Frame::new(gpu, pool, "frame");
            let under = picture.as_ref().map_or(Under::Backdrop(&player.backdrop), |p| Under::Picture(p));
            let is_last = index + 1 == cels.len();
            let next = (!is_last).then(|| frame.texture("frame.picture", shot.size, CEL_FORMAT));
            let to = next.as_deref().unwrap_or(target);
            let layers = self.paint_cel(&mut frame, &setting, opaque.as_ref(), under, to);
            frame.submit();
            // Transparent cels are drawn over the opaque one, and are hidden by it where it is nearer.
            opaque = opaque.or(Some(layers));
            picture = next;
        }
    }

    /// Draws one cel over what lies under it. Answers with the layers it filled.
    fn paint_cel(
        &self,
        frame: &mut Frame<'_>,
        setting: &Setting<'_>,
        opaque: Option<&Layers>,
        under: Under<'_>,
        target: &wgpu::TextureView,
    ) -> Layers {
        let room = self.room.as_ref().expect("room is made before a cel is painted");
        let scene = &setting.player.puffs;
        let view = frame.uniform("frame.view", &setting.view.uniform);
        let lights = frame.uniform("frame.lights", &setting.lights);
        let step = if setting.clean_px() >= 2.0 { 2 } else { 1 };

        if opaque.is_none() {
            self.form.record(frame, scene);
        }
        let layers = Layers::new(frame, setting.view.size);
        layers.begin(frame, opaque);
        self.occlusion.front(frame, &view, scene, &room.pyramid, &room.flags);
        self.compact.record(frame, &room.flags, scene.count, FRONT, VERTICES, &room.list);
        self.body.record(frame, &view, scene, &room.list, layers.target());
        self.occlusion.rest(frame, &view, scene, &room.pyramid, &room.flags, &layers.depth);
        self.compact.record(frame, &room.flags, scene.count, REST, VERTICES, &room.list);
        self.body.record(frame, &view, scene, &room.list, layers.target());
        self.compact.record(frame, &room.flags, scene.count, INK, VERTICES, &room.inks);

        let normal = self.normal.record(frame, &view, scene, &layers, step);
        let stencil = Stencil {
            compact: &self.compact,
            flags: &room.flags,
            list: &room.list,
            pyramid: &room.pyramid,
            step: setting.stencil_step(),
            settle: (SETTLE * setting.clean_px() / setting.stencil_step() as f32).round() as u32,
        };
        let shadow = self.shadows.record(frame, &view, (&setting.lights, &lights), scene, &layers, &stencil);
        let normal = self.soften(frame, setting, normal, step);
        let cel = self.flat.record(
            frame,
            &view,
            &lights,
            scene,
            &layers,
            (&normal, &shadow),
            step,
            &setting.player.ramps,
        );
        let ink = self.outline.record(frame, &view, &lights, scene, &room.inks, &layers);
        let around = self.gather.record(frame, &ink, layers.size, setting.ink_length_px());
        self.compose.record(
            frame,
            scene,
            &cel,
            (&ink, &around),
            under,
            (setting.samples, opaque.is_none()),
            target,
        );
        layers
    }

    fn soften(
        &self,
        frame: &mut Frame<'_>,
        setting: &Setting<'_>,
        normal: Transient,
        step: u32,
    ) -> Transient {
        let radius = (setting.clean_px() / step as f32).round() as u32;
        if radius == 0 { normal } else { self.soften.record(frame, &setting.view, normal, radius, step) }
    }

    fn make_room(&mut self, gpu: &Gpu, scene: &PuffScene, size: [u32; 2]) {
        let fits = |room: &Room| room.count == scene.count && room.pyramid.size == size;
        if !self.room.as_ref().is_some_and(fits) {
            let list = |label| DrawList::new(gpu, label, scene.count);
            self.room = Some(Room {
                count: scene.count,
                pyramid: Pyramid::new(gpu, size),
                flags: gpu.device.create_buffer(&wgpu::BufferDescriptor {
                    label: Some("frame.flags"),
                    size: u64::from(scene.count.max(4)) * 4,
                    usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC,
                    mapped_at_creation: false,
                }),
                list: list("frame.list"),
                inks: list("frame.inks"),
            });
        }
    }
}

impl Setting<'_> {
    /// Length of the shortest line that any object keeps, in samples.
    fn ink_length_px(&self) -> f32 {
        let objects = (0..).zip(&self.player.scene().objects);
        let style = |(index, object)| ObjectStyle::new(object, index, self.view.size[1], true);
        objects.map(|object| style(object).shortest_line_px()).fold(0.0, f32::max)
    }

    /// Samples to one of the stencil's: shadows need not be finer than the least tone.
    fn stencil_step(&self) -> u32 {
        match self.clean_px() {
            fine if fine < 1.5 => 1,
            medium if medium < 3.0 => 2,
            _ => 4,
        }
    }

    /// Least size of a tone's shape, in samples: the largest that any object wants.
    fn clean_px(&self) -> f32 {
        let scale = |height_px| self.view.size[1] as f32 / height_px;
        let objects = &self.player.scene().objects;
        objects.iter().map(|object| object.style.clean_px * scale(object.style.height_px)).fold(0.0, f32::max)
    }
}

/// Opaque objects share the first cel; every object that light goes through has its own, the farthest
/// first.
fn cels(objects: &[Object], eye: Vec3) -> Vec<Cel> {
    let (mut opaque, mut clear) = (Vec::new(), Vec::new());
    for (index, object) in objects.iter().enumerate().filter(|(_, object)| object.visible) {
        if is_opaque(object) { opaque.push(index) } else { clear.push(index) }
    }
    clear.sort_by(|&a, &b| {
        let distance = |index: usize| anchor(&objects[index]).distance(eye);
        distance(b).total_cmp(&distance(a))
    });
    let clear = clear.into_iter().map(|index| Cel { members: vec![index] });
    std::iter::once(Cel { members: opaque }).chain(clear).collect()
}

fn is_opaque(object: &Object) -> bool {
    let fades = match &object.matter {
        Matter::Smoke(smoke) => smoke
            .emitters
            .iter()
            .any(|emitter| emitter.opacity_over_life.points.iter().any(|&[_, opacity]| opacity < 1.0)),
        Matter::Still(_) | Matter::File(_) => false,
    };
    object.opacity >= 1.0 && !fades
}

/// Where an object roughly is, to order cels by.
fn anchor(object: &Object) -> Vec3 {
    use fumetto_scene::EmitterShape as Shape;
    let mean = |places: &mut dyn Iterator<Item = Vec3>| {
        let (sum, count) = places.fold((Vec3::ZERO, 0.0), |(sum, count), place| (sum + place, count + 1.0));
        sum / f32::max(count, 1.0)
    };
    match &object.matter {
        Matter::Still(particles) => mean(&mut particles.iter().map(|particle| particle.center.into())),
        Matter::File(_) => Vec3::ZERO,
        Matter::Smoke(smoke) => mean(&mut smoke.emitters.iter().map(|emitter| match emitter.shape {
            Shape::Point { center }
            | Shape::Disc { center, .. }
            | Shape::Sphere { center, .. }
            | Shape::Box { center, .. } => center.into(),
            Shape::Line { from, to } => 0.5 * (Vec3::from(from) + Vec3::from(to)),
        })),
    }
}

fn write_styles(gpu: &Gpu, setting: &Setting<'_>, cel: &Cel) {
    let objects = &setting.player.scene().objects;
    let styles: Vec<_> = (0..)
        .zip(objects)
        .map(|(index, object)| {
            let in_cel = cel.members.contains(&(index as usize));
            ObjectStyle::new(object, index, setting.view.size[1], in_cel)
        })
        .collect();
    gpu.queue.write_buffer(&setting.player.puffs.styles, 0, bytemuck::cast_slice(&styles));
}
