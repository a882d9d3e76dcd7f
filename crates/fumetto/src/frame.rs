//! How a picture is drawn: the page that reads as it happens, top to bottom.

mod plates;

pub(crate) use plates::Plate;

use glam::Vec3;

use crate::{
    Player, Shot,
    cels::{Cel, cels},
    gpu::{Compact, DrawList, Frame, Gpu, Region, Target, TexturePool, Transient, View},
    ink::{
        Angle, Gather, INK_FORMAT, Image, InkAround, Inner, Methods, Moment, Outline, Pen, Shell, Strokes,
        Vector,
    },
    layers::Layers,
    lengths::SETTLE,
    light::{Casting, Clusters, LightsUniform, Murk, Shadows, Soften, Volumes},
    paint::Mask,
    player::Look,
    proof::Proof,
    setting::Setting,
    shapes::mesh,
    shapes::puffs::{Binning, Bins, Body, Form, Normal, PuffScene, Pyramid, Reduce, Subject},
    shapes::volume::{March, VolumeScene},
    tiles::Part,
    tone::{
        CEL_FORMAT, Canvas, Compose, Copied, Features, Flat, Ground, Hatched, Inked, Reveal, Sheet, Sprites,
        Turns, Under, Veil,
    },
};

/// All passes of a picture.
pub(crate) struct Painter {
    compact: Compact,
    reduce: Reduce,
    form: Form,
    meshes: mesh::Body,
    binning: Binning,
    body: Body,
    march: March,
    normal: Normal,
    shadows: Shadows,
    murk: Murk,
    volumes: Volumes,
    clusters: Clusters,
    soften: Soften,
    outline: Outline,
    vector: Vector,
    angle: Angle,
    shell: Shell,
    image: Image,
    inner: Inner,
    gather: Gather,
    ground: Ground,
    turns: Turns,
    flat: Flat,
    sprites: Sprites,
    copied: Copied,
    veil: Veil,
    mask: Mask,
    reveal: Reveal,
    compose: Compose,
    /// Once a scene has any.
    pub(crate) strokes: Option<Strokes>,
    room: Option<Room>,
}

/// The ink around in all of the picture, by the number of the look, and the side of its cells in samples of what is
/// drawn.
type Known<'a> = &'a dyn Fn(usize) -> Option<(&'a InkAround, f32)>;

/// What a cel shows: its layers, the shadows on it, and the layers of the opaque cel if that is another.
type Seen<'a> = (&'a Layers, &'a Transient, Option<&'a Layers>);

/// A cel in one look.
struct Drawn {
    /// `None` where they are in the picture.
    tones: Option<Transient>,
    ink: Transient,
    around: InkAround,
}

/// What lies behind everything.
fn backdrop(player: &Player) -> Under<'_> {
    let is_grey = !player.paints.is_empty() && player.paints.coats.is_grey_outside();
    if is_grey { Under::GreyBackdrop(&player.backdrop) } else { Under::Backdrop(&player.backdrop) }
}

/// What is needed for pictures of one size and scenes of one number of puffs.
struct Room {
    bins: Bins,
    /// These three are for shadows.
    pyramid: Pyramid,
    flags: wgpu::Buffer,
    list: DrawList,
}

impl Painter {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        Self {
            compact: Compact::new(gpu),
            reduce: Reduce::new(gpu),
            form: Form::new(gpu),
            meshes: mesh::Body::new(gpu),
            binning: Binning::new(gpu),
            body: Body::new(gpu),
            march: March::new(gpu),
            normal: Normal::new(gpu),
            shadows: Shadows::new(gpu),
            murk: Murk::new(gpu),
            volumes: Volumes::new(gpu),
            clusters: Clusters::new(gpu),
            soften: Soften::new(gpu),
            outline: Outline::new(gpu),
            vector: Vector::new(gpu),
            angle: Angle::new(gpu),
            shell: Shell::new(gpu),
            image: Image::new(gpu),
            inner: Inner::new(gpu),
            gather: Gather::new(gpu),
            ground: Ground::new(gpu),
            turns: Turns::new(gpu),
            flat: Flat::new(gpu),
            sprites: Sprites::new(gpu),
            copied: Copied::new(gpu),
            veil: Veil::new(gpu),
            mask: Mask::new(gpu),
            reveal: Reveal::new(gpu),
            compose: Compose::new(gpu),
            strokes: None,
            room: None,
        }
    }

    /// Draws the moment that `player` is at, or a part of its picture. Answers with the ink around in each cel.
    pub(crate) fn paint(
        &mut self,
        gpu: &Gpu,
        pool: &TexturePool,
        player: &Player,
        shot: &Shot,
        part: Part<'_>,
        target: &wgpu::TextureView,
    ) -> Vec<InkAround> {
        let setting = self.set(gpu, player, shot, part.region);
        let scene = player.scene();
        let size = part.region.size.map(|side| side / shot.antialias);

        let mut picture: Option<Transient> = None;
        let mut opaque: Option<Layers> = None;
        let mut arounds = Vec::new();
        let cels = cels(scene, Vec3::from(shot.camera.eye));
        for (index, cel) in cels.iter().enumerate() {
            setting.write_styles(gpu, cel);
            let mut frame = Frame::new(gpu, pool, "frame");
            let under = picture.as_ref().map_or(backdrop(player), |picture| Under::Picture(picture));
            let is_last = index + 1 == cels.len();
            let next = (!is_last).then(|| frame.texture("frame.picture", size, CEL_FORMAT));
            let to = next.as_deref().unwrap_or(target);
            let known = |look| {
                let number = index * player.looks.len() + look;
                part.survey.and_then(|survey| survey.around(number, part.region))
            };
            let (layers, around) =
                self.paint_cel(&mut frame, &setting, (cel, &known), opaque.as_ref(), under, to);
            frame.submit();
            arounds.extend(around);
            // Transparent cels are drawn over the opaque one, and are hidden by it where it is nearer.
            opaque = opaque.or(Some(layers));
            picture = next;
        }
        arounds
    }

    /// Fills the layers with all objects at once, to be looked at.
    pub(crate) fn proof(&mut self, gpu: &Gpu, pool: &TexturePool, player: &Player, shot: &Shot) -> Proof {
        let setting = self.set(gpu, player, shot, Region::whole(shot.samples()));
        let visible = |index: &usize| player.scene().objects[*index].visible;
        let members = (0..player.scene().objects.len()).filter(visible).collect();
        let cel = Cel { members, pre_shaded: false };
        setting.write_styles(gpu, &cel);
        let mut frame = Frame::new(gpu, pool, "proof");
        let (view, lights, pens) = setting.buffers(&frame, &cel.members);
        let Player { puffs: scene, meshes, .. } = player;
        let subject = Subject { scene, meshes, view: &view, lights: &lights, pens: &pens };
        let room = self.room.as_ref().expect("setting makes room");
        let filled = (&player.volumes, &*cel.members, setting.view.size);
        let layers = self.fill(&mut frame, subject, room, filled, None);
        self.form.record(&mut frame, subject.scene, &cel.members);
        let normal = self.normal.record(&mut frame, subject, &layers, 1);
        let ink = self.ink(&mut frame, subject, &setting, &cel.members, (&layers, None, &room.bins));
        frame.submit();
        Proof { depth: layers.depth, id: layers.id, normal, ink, lobes: player.lobes() }
    }

    /// Looks at the scene, and makes room for what it takes to draw it.
    fn set<'a>(&mut self, gpu: &Gpu, player: &'a Player, shot: &Shot, region: Region) -> Setting<'a> {
        let view = View::new(&shot.camera, region);
        self.make_room(gpu, &player.puffs, view.size);
        if player.strokes.is_some() {
            self.strokes
                .get_or_insert_with(|| Strokes::new(gpu, &player.meshes))
                .make_room(gpu, &player.meshes);
        }
        let scene = player.scene();
        let lights = LightsUniform::of(scene);
        let features = |look: &Look| Features::of(look.drawn(), !player.meshes.is_empty());
        for look in &player.looks {
            self.flat.prepare(features(look));
        }
        let look = &player.looks[0];
        let sheet = Sheet { region, samples: shot.antialias };
        let moment = Moment {
            frame: player.shown.unwrap_or(0),
            picture_height: view.picture_height,
            reference_m: Vec3::from(shot.camera.eye).distance(shot.camera.target.into()),
        };
        Setting { player, look, view, lights, features: features(look), sheet, moment }
    }

    /// Draws one cel over what lies under it; `known` tells for each look the ink around in all of the picture, if
    /// that is known. Answers with the layers it filled and the ink around in each look.
    fn paint_cel(
        &self,
        frame: &mut Frame<'_>,
        setting: &Setting<'_>,
        (cel, known): (&Cel, Known<'_>),
        opaque: Option<&Layers>,
        under: Under<'_>,
        target: &wgpu::TextureView,
    ) -> (Layers, Vec<InkAround>) {
        let room = self.room.as_ref().expect("room is made before a cel is painted");
        let (view, lights, pens) = setting.buffers(frame, &cel.members);
        let Player { puffs: scene, meshes, .. } = setting.player;
        let subject = Subject { scene, meshes, view: &view, lights: &lights, pens: &pens };

        let filled = (&setting.player.volumes, &*cel.members, setting.view.size);
        let layers = self.fill(frame, subject, room, filled, opaque);
        let shadow = self.shadow(frame, subject, setting, room, &layers);
        let seen = (&layers, &shadow, opaque);
        if !setting.player.paints.is_empty() {
            let arounds = self.reveal(frame, setting, (cel, known), seen, under, target);
            return (layers, arounds);
        }
        // Where nothing is averaged or half transparent, tones go straight into the picture.
        let blends = opaque.is_some() || setting.drawing(&cel.members).is_some();
        let is_picture = setting.sheet.samples == 1 && !blends;
        if is_picture {
            self.compose.lay(frame, under, setting.sheet, target);
        }
        let Drawn { tones, ink, around } =
            self.draw(frame, subject, setting, cel, seen, is_picture.then_some(target));
        let inked = Inked { ink: &ink, around: &around, known: known(0) };
        match tones {
            Some(tones) => self.compose.record(frame, subject, (&tones, inked), under, setting.sheet, target),
            None => self.compose.lines(frame, subject, inked, setting.sheet, target),
        }
        (layers, vec![around])
    }

    /// Draws one cel as paint shows it: in every look from the same layers, of which each pixel takes one.
    fn reveal(
        &self,
        frame: &mut Frame<'_>,
        setting: &Setting<'_>,
        (cel, known): (&Cel, Known<'_>),
        seen: Seen<'_>,
        under: Under<'_>,
        target: &wgpu::TextureView,
    ) -> Vec<InkAround> {
        let (layers, _, _) = seen;
        let Player { puffs: scene, meshes, paints, looks, .. } = setting.player;
        let room = self.room.as_ref().expect("room is made before a cel is painted");
        let mut arounds = Vec::with_capacity(looks.len());
        let mut revealed: Option<Transient> = None;
        let mut marks = None;
        for (number, look) in looks.iter().enumerate() {
            let setting = setting.in_look(look);
            let (view, lights, pens) = setting.buffers(frame, &cel.members);
            let subject = Subject { scene, meshes, view: &view, lights: &lights, pens: &pens };
            let marks = marks.get_or_insert_with(|| {
                self.mask.record(frame, paints, subject.view, layers, setting.view.picture_height)
            });
            if number > 0 {
                frame.flush("frame.look");
                setting.write_styles(frame.gpu, cel);
                self.binning.record(frame, subject, &room.bins);
            }
            let Drawn { tones, ink, around } = self.draw(frame, subject, &setting, cel, seen, None);
            let tones = tones.expect("what is drawn into no picture has a cel of its own");
            let inked = Inked { ink: &ink, around: &around, known: known(number) };
            let from = (layers, &*marks, setting.sheet);
            let shown = (number, revealed.as_ref());
            revealed = Some(self.reveal.record(frame, subject, (&tones, inked), from, shown));
            arounds.push(around);
        }
        if let (Some(cel), Some(around)) = (revealed, arounds.last()) {
            let inked = Reveal::nothing_inked(frame);
            let inked = Inked { ink: &inked, around, known: None };
            let (view, lights, pens) = setting.buffers(frame, &[]);
            let subject = Subject { scene, meshes, view: &view, lights: &lights, pens: &pens };
            self.compose.record(frame, subject, (&cel, inked), under, setting.sheet, target);
        }
        arounds
    }

    /// Draws a cel in the setting's look: into `picture`, or onto a cel of its own.
    fn draw(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        setting: &Setting<'_>,
        cel: &Cel,
        (layers, shadow, opaque): Seen<'_>,
        picture: Option<&wgpu::TextureView>,
    ) -> Drawn {
        let room = self.room.as_ref().expect("room is made before a cel is painted");
        let own = picture.is_none().then(|| frame.texture("tone.cel", layers.size, CEL_FORMAT));
        if let Some(view) = picture.or(own.as_deref()) {
            let canvas = Canvas { view, is_picture: picture.is_some() };
            self.tone(frame, subject, setting, (cel, room), (layers, shadow), canvas);
        }
        let tones = own.map(|own| self.veil.record(frame, setting.objects(cel), layers, own));
        let ink = self.ink(frame, subject, setting, &cel.members, (layers, opaque, &room.bins));
        let around = self.gather.record(frame, &ink, layers.size, setting.ink_length_px(&cel.members));
        Drawn { tones, ink, around }
    }

    /// Fills the layers.
    fn fill(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        room: &Room,
        (volumes, members, size): (&VolumeScene, &[usize], [u32; 2]),
        nearer: Option<&Layers>,
    ) -> Layers {
        let mut layers = Layers::new(frame, size);
        layers.begin(frame, nearer.map(|nearer| &nearer.depth));
        self.meshes.record(frame, subject, members, layers.target());
        let is_empty = !layers.is_over && subject.meshes.is_empty();
        if subject.scene.count > 0 {
            self.binning.record(frame, subject, &room.bins);
            self.body.record(frame, subject, &room.bins, &layers, is_empty);
        }
        self.march.record(frame, subject, (volumes, members), &mut layers);
        layers
    }

    /// Finds which lights are kept away.
    fn shadow(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        setting: &Setting<'_>,
        room: &Room,
        layers: &Layers,
    ) -> Transient {
        let step = setting.shadow_step();
        let casting = Casting {
            compact: &self.compact,
            reduce: &self.reduce,
            flags: &room.flags,
            list: &room.list,
            pyramid: &room.pyramid,
            step,
            settle: (SETTLE * setting.clean_px() / step as f32).round() as u32,
        };
        let volumes = &setting.player.volumes;
        let cast = |frame: &mut Frame<'_>, lights: &LightsUniform, subject: Subject<'_>| {
            let shadow = self.shadows.record(frame, subject, lights, layers, &casting);
            let shadow = self.murk.record(frame, subject, (volumes, lights), layers, shadow);
            self.volumes.record(frame, subject, lights, layers, shadow)
        };
        let shadow = cast(frame, &setting.lights, subject);
        let clusters = setting.lights.clusters(setting.player.scene());
        self.clusters.record(frame, layers, &clusters, shadow, |frame, member| {
            let lights = frame.uniform("light.member", member);
            cast(frame, member, Subject { lights: &lights, ..subject })
        })
    }

    /// Paints flat colours onto `canvas`.
    fn tone(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        setting: &Setting<'_>,
        (cel, room): (&Cel, &Room),
        (layers, shadow): (&Layers, &Transient),
        canvas: Canvas<'_>,
    ) {
        let ramps = &setting.look.ramps;
        if cel.pre_shaded {
            let sprites = self.sprites.record(frame, subject, ramps, setting.bytes(cel));
            let shadow = setting.lights.have_shadows().then_some(shadow);
            return self.copied.record(
                frame,
                subject,
                (layers, shadow),
                (&sprites, &room.bins.projected),
                ramps,
                canvas,
            );
        }
        let step = if setting.clean_px() >= 2.0 { 2 } else { 1 };
        let radius = (setting.clean_px() / step as f32).round() as u32;
        self.form.record(frame, subject.scene, &cel.members);
        let normal = self.normal.record(frame, subject, layers, step);
        let normal =
            if radius == 0 { normal } else { self.soften.record(frame, &setting.view, normal, radius, step) };
        let ground = self.ground.record(frame, subject.view, layers, setting.smooth_px());
        let turns = self.turns.record(frame, subject.view, &ground, setting.wants_turns());
        let styles = setting.hatching(frame);
        let hatched = Hatched { styles: styles.as_ref(), ground: &ground, turns: &turns };
        let light = (&normal, shadow, hatched);
        self.flat.record(frame, subject, layers, light, (step, ramps, setting.features), canvas);
    }

    /// Draws lines: first those inside surfaces, and over them those of the objects themselves.
    fn ink(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        setting: &Setting<'_>,
        members: &[usize],
        (layers, nearer, bins): (&Layers, Option<&Layers>, &Bins),
    ) -> Transient {
        let ink = frame.texture("ink.lines", layers.size, INK_FORMAT);
        frame.clear("ink.begin", Target::colour(&ink, Some(wgpu::Color::TRANSPARENT)));
        let details = &setting.player.details;
        for level in details.levels(members) {
            let inside = details.members(members, level);
            let from = (layers, nearer.map(|nearer| &nearer.depth));
            let inner = self.inner.record(frame, subject, &self.meshes, (level, &inside), from);
            self.lines(frame, subject, setting, (&inside, &inner, None), &ink);
        }
        self.lines(frame, subject, setting, (members, layers, Some(bins)), &ink);
        ink
    }

    /// Adds to `ink` the lines of what `layers` show of some objects, each one's as its style finds them, and
    /// those of the puffs that `bins` lists.
    fn lines(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        setting: &Setting<'_>,
        (members, layers, bins): (&[usize], &Layers, Option<&Bins>),
        ink: &Transient,
    ) {
        let methods = Methods::of(&setting.drawn(), members, setting.view.picture_height);
        let along_edges = setting.pens(members).iter().any(Pen::follows_edges);
        let lines =
            along_edges.then(|| self.vector.record(frame, subject, &self.compact, (layers, members), ink));
        if let (Some(strokes), Some(drawing), Some(depth)) = (&self.strokes, setting.drawing(members), &lines)
        {
            let seen = (layers, members);
            strokes.record(frame, subject, &self.compact, &drawing, seen, (ink, depth));
        }
        if let Some(bins) = bins.filter(|_| methods.outline) {
            let depth = lines.as_ref().unwrap_or(&layers.depth);
            self.outline.record(frame, subject, bins, (layers, depth), ink);
        }
        if methods.angle {
            self.form.record(frame, subject.scene, members);
            let normal = self.normal.record(frame, subject, layers, 1);
            self.angle.record(frame, subject, layers, &normal, ink);
        }
        self.shell.record(frame, subject, &methods.shells, layers, ink);
        self.image.record(frame, subject, &methods, layers, ink);
    }

    fn make_room(&mut self, gpu: &Gpu, scene: &PuffScene, size: [u32; 2]) {
        let fits = |room: &Room| room.bins.count == scene.count && room.bins.size == size;
        if !self.room.as_ref().is_some_and(fits) {
            self.room = Some(Room {
                bins: Bins::new(gpu, scene.count, size),
                pyramid: Pyramid::new(gpu, size),
                flags: gpu.device.create_buffer(&wgpu::BufferDescriptor {
                    label: Some("frame.flags"),
                    size: u64::from(scene.count.max(4)) * 4,
                    usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC,
                    mapped_at_creation: false,
                }),
                list: DrawList::without_indices(gpu, "frame.list", scene.count),
            });
        }
    }
}
