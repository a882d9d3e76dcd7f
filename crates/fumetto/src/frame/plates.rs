//! A picture's cels one by one, read back as they are before anything is averaged or laid over another.

use glam::Vec3;

use super::{Drawn, Painter, Setting};
use crate::{
    Player, Shot,
    cels::{Cel, cels},
    gpu::{Frame, Gpu, GpuError, Region, Target, TexturePool, Transient, read_texture_async},
    ink::INK_FORMAT,
    layers::Layers,
    shapes::puffs::Subject,
    tone::{CEL_FORMAT, Inked},
};

/// One cel, sample by sample, row by row from the top.
#[derive(Debug)]
pub(crate) struct Plate {
    /// Numbers of its objects.
    pub(crate) members: Vec<usize>,
    pub(crate) size: [usize; 2],
    /// Which puff or triangle is seen; 0 where there is none.
    pub(crate) ids: Vec<u32>,
    /// Reverse-Z.
    pub(crate) depth: Vec<f32>,
    /// Flat colours without lines: straight alpha, encoded.
    pub(crate) tones: Vec<[u8; 4]>,
    /// Number of the pen + 1 where there is a line that is long enough to read, and its opacity.
    pub(crate) ink: Vec<[u8; 2]>,
    /// The same of those lines alone that follow edges and contours of triangles; empty without any.
    pub(crate) edges: Vec<[u8; 2]>,
}

/// What is drawn of a cel before it is read back.
struct Unread {
    layers: Layers,
    /// In colours of its own, where it is not in any picture.
    tones: Option<Transient>,
    ink: Transient,
    edges: Option<Transient>,
    /// Alpha where lines are kept.
    kept: Transient,
}

impl Painter {
    /// Draws all cels with a sample for each of the shot's pixels.
    pub(crate) async fn plates(
        &mut self,
        gpu: &Gpu,
        pool: &TexturePool,
        player: &Player,
        shot: &Shot,
    ) -> Result<Vec<Plate>, GpuError> {
        let setting = self.set(gpu, player, shot, Region::whole(shot.size));
        let mut opaque: Option<Layers> = None;
        let mut plates = Vec::new();
        for cel in cels(player.scene(), Vec3::from(shot.camera.eye)) {
            setting.write_styles(gpu, &cel);
            let mut frame = Frame::new(gpu, pool, "plate");
            let drawn = self.draw_plate(&mut frame, &setting, &cel, opaque.as_ref());
            frame.submit();
            plates.push(drawn.read(gpu, cel).await?);
            opaque = opaque.or(Some(drawn.layers));
        }
        Ok(plates)
    }

    fn draw_plate(
        &self,
        frame: &mut Frame<'_>,
        setting: &Setting<'_>,
        cel: &Cel,
        opaque: Option<&Layers>,
    ) -> Unread {
        let room = self.room.as_ref().expect("room is made before a cel is painted");
        let (view, lights, pens) = setting.buffers(frame, &cel.members);
        let Player { puffs: scene, meshes, .. } = setting.player;
        let subject = Subject { scene, meshes, view: &view, lights: &lights, pens: &pens };

        let filled = (&setting.player.volumes, &*cel.members, setting.view.size);
        let layers = self.fill(frame, subject, room, filled, opaque);
        let shadow = self.shadow(frame, subject, setting, room, &layers);
        let seen = (&layers, &shadow, opaque);
        let Drawn { tones, ink, around } = self.draw(frame, subject, setting, cel, seen, None);
        let kept = frame.texture("plate.kept", layers.size, CEL_FORMAT);
        frame.clear("plate.kept", Target::colour(&kept, Some(wgpu::Color::TRANSPARENT)));
        let inked = Inked { ink: &ink, around: &around, known: None };
        self.compose.lines(frame, subject, inked, setting.sheet, &kept);

        let along_edges = setting.pens(&cel.members).iter().any(crate::ink::Pen::follows_edges);
        let edges = along_edges.then(|| {
            let edges = frame.texture("plate.edges", layers.size, INK_FORMAT);
            frame.clear("plate.edges", Target::colour(&edges, Some(wgpu::Color::TRANSPARENT)));
            self.vector.record(frame, subject, &self.compact, (&layers, &cel.members), &edges);
            edges
        });
        Unread { layers, tones, ink, edges, kept }
    }
}

impl Unread {
    async fn read(&self, gpu: &Gpu, cel: Cel) -> Result<Plate, GpuError> {
        let read = |texture: &Transient| read_texture_async(gpu, texture.texture());
        let pairs = |bytes: &[u8]| bytes.as_chunks().0.to_vec();
        let tones = self.tones.as_ref().map(read);
        let edges = self.edges.as_ref().map(read);
        let mut ink: Vec<[u8; 2]> = pairs(&read(&self.ink).await?);
        let kept = read(&self.kept).await?;
        for (mark, kept) in ink.iter_mut().zip(kept.as_chunks::<4>().0) {
            if kept[3] == 0 {
                *mark = [0, 0];
            }
        }
        Ok(Plate {
            members: cel.members,
            size: self.layers.size.map(|side| side as usize),
            ids: bytemuck::pod_collect_to_vec(&read(&self.layers.id).await?),
            depth: bytemuck::pod_collect_to_vec(&read(&self.layers.depth).await?),
            tones: match tones {
                Some(tones) => tones.await?.as_chunks().0.to_vec(),
                None => Vec::new(),
            },
            ink,
            edges: match edges {
                Some(edges) => pairs(&edges.await?),
                None => Vec::new(),
            },
        })
    }
}
