//! A scene on the graphics device, and pictures of it.

use std::path::Path;

use anyhow::Context as _;
use fumetto::{
    DrawingOptions, Engine, Export, Extent, Layer, Player, Print, Shot, Snapshot, Tiling, Trouble,
};
use fumetto_formats::{Drawing, Grid, Image, is_sequence};
use fumetto_scene::{Matter, Particle, Scene};

use crate::cache::{Cache, Found};
use crate::console;
use crate::gpu;
use crate::interrupt::Interrupt;
use fumetto_disk::SceneFolder;

/// Frames that are simulated before Ctrl-C is asked for and the device is waited for: few enough to
/// stop within moments, enough to keep the device busy.
const FRAMES_AT_A_TIME: usize = 8;

/// A scene at one moment, ready to be drawn.
pub(crate) struct Stage {
    engine: Engine,
    player: Player,
    trouble: Trouble,
    /// The scene file's name.
    name: String,
    /// The frame that it is at.
    frame: u32,
    reads_sequences: bool,
    /// Frames that need not be simulated.
    cache: Option<Cache>,
}

impl Stage {
    /// Opens the device and takes the scene to its beginning; `path` is the scene file's.
    pub(crate) fn new(path: &Path, scene: Scene, folder: SceneFolder) -> anyhow::Result<Self> {
        let name = path.display().to_string();
        let (gpu, trouble) = gpu::open()?;
        let engine = Engine::new(gpu);
        let reads_sequences = scene.objects.iter().any(|object| match &object.matter {
            Matter::File(path) => is_sequence(path),
            Matter::Imported(imported) => is_sequence(&imported.file),
            _ => false,
        });
        let player = engine.play(scene, Box::new(folder)).with_context(|| name.clone())?;
        trouble.check()?;
        for note in player.notes() {
            console::say(&format!("note: {note}"));
        }
        Ok(Self { engine, player, trouble, name, frame: 0, reads_sequences, cache: None })
    }

    /// Takes what moves out of a folder that was baked, if one is named.
    pub(crate) fn use_cache(&mut self, folder: Option<&Path>) -> anyhow::Result<()> {
        if let Some(folder) = folder {
            self.cache = Some(Cache::open(folder, self.player.fingerprint())?);
        }
        Ok(())
    }

    /// The scene at this moment.
    pub(crate) fn player(&self) -> &Player {
        &self.player
    }

    /// The graphics adapter in words.
    pub(crate) fn adapter(&self) -> String {
        gpu::describe(&self.engine.gpu().adapter)
    }

    /// Takes the scene to `frame`.
    pub(crate) fn seek(&mut self, frame: u32, interrupt: &Interrupt) -> anyhow::Result<()> {
        let held = frame - frame % self.player.scene().time.hold;
        if let Some(snapshot) = self.cached(held)? {
            // What comes after what is only shown is simulated from the start.
            self.frame = 0;
            return self.recall(&snapshot);
        }
        let at_most = FRAMES_AT_A_TIME as u32;
        while !self.engine.pre_roll(&mut self.player, frame, at_most) {
            self.engine.gpu().wait()?;
            interrupt.check()?;
        }
        // Sequences of files need not have the frames before the first that is drawn.
        if !self.reads_sequences {
            for stop in (self.frame..frame).step_by(FRAMES_AT_A_TIME) {
                self.engine.seek(&mut self.player, stop)?;
                self.engine.gpu().wait()?;
                interrupt.check()?;
            }
        }
        self.engine.seek(&mut self.player, frame).with_context(|| self.name.clone())?;
        self.frame = frame;
        Ok(self.trouble.check()?)
    }

    /// What the cache has of a frame.
    fn cached(&mut self, frame: u32) -> anyhow::Result<Option<Snapshot>> {
        let Some(cache) = &self.cache else { return Ok(None) };
        let folder = cache.folder().display();
        match cache.find(frame)? {
            Found::Ours => Ok(Some(cache.read(frame)?)),
            Found::Nothing => {
                console::say(&format!("note: frame {frame} is not in {folder}: it is simulated"));
                Ok(None)
            }
            Found::Other => {
                console::say(&format!(
                    "note: {folder} holds another scene's simulation, or this one's before it was changed: all is \
                     simulated"
                ));
                self.cache = None;
                Ok(None)
            }
        }
    }

    /// Goes on from a snapshot of all that moves.
    pub(crate) fn go_on_from(&mut self, snapshot: &Snapshot) -> anyhow::Result<()> {
        self.frame = snapshot.frame;
        self.recall(snapshot)
    }

    fn recall(&mut self, snapshot: &Snapshot) -> anyhow::Result<()> {
        self.engine.recall(&mut self.player, snapshot).with_context(|| self.name.clone())?;
        Ok(self.trouble.check()?)
    }

    /// What moves, at this moment.
    pub(crate) fn snapshot(&self, extent: Extent) -> anyhow::Result<Snapshot> {
        let snapshot = self.engine.snapshot(&self.player, extent);
        self.trouble.check()?;
        snapshot.with_context(|| self.name.clone())
    }

    /// The number of the drawing that `frame` shows.
    pub(crate) fn drawing(&self, frame: u32) -> u32 {
        self.player.drawing(frame)
    }

    /// The picture of this moment.
    pub(crate) fn picture(&mut self, shot: &Shot) -> anyhow::Result<Image> {
        let picture = self.engine.picture(&self.player, shot);
        self.trouble.check()?;
        Ok(picture?)
    }

    /// A picture of this moment that is drawn tile by tile, if it is too large to be drawn at once.
    pub(crate) fn print(&mut self, shot: &Shot) -> anyhow::Result<Option<Print>> {
        let print = self.engine.print(&self.player, shot, Tiling::default())?;
        Ok((print.tile_count() > 1).then_some(print))
    }

    /// The next rows of such a picture, where its next tile completes any.
    pub(crate) fn draw_tile(&mut self, print: &mut Print) -> anyhow::Result<Option<Image>> {
        let band = print.draw_tile(&mut self.engine, &self.player);
        self.trouble.check()?;
        Ok(band?)
    }

    /// This moment as a drawing of closed shapes and lines.
    pub(crate) fn vector(&mut self, shot: &Shot, options: &DrawingOptions) -> anyhow::Result<Drawing> {
        let drawing = self.engine.drawing(&self.player, shot, options);
        self.trouble.check()?;
        Ok(drawing?)
    }

    /// One layer of what the picture of this moment is made from.
    pub(crate) fn layer(&mut self, shot: &Shot, layer: Layer) -> anyhow::Result<Image> {
        let picture = self.engine.layer(&self.player, shot, layer);
        self.trouble.check()?;
        Ok(picture?)
    }

    /// The pictures of all puffs side by side, each with its name.
    pub(crate) fn atlas(&self) -> anyhow::Result<Vec<(&'static str, Image)>> {
        let pictures = self.engine.atlas(&self.player);
        self.trouble.check()?;
        Ok(pictures?)
    }

    /// The triangles of an object at this moment, if it has any.
    pub(crate) fn solid(&self, object: usize) -> anyhow::Result<Option<Export>> {
        let export = self.engine.solid(&self.player, object);
        self.trouble.check()?;
        Ok(export?)
    }

    /// The volume of an object at this moment, if it is one.
    pub(crate) fn volume(&self, object: usize) -> anyhow::Result<Vec<Grid>> {
        let grids = self.engine.volume(&self.player, object);
        self.trouble.check()?;
        Ok(grids?)
    }

    /// What an object is called.
    pub(crate) fn name_of(&self, object: usize) -> &str {
        &self.player.scene().objects[object].name
    }

    /// The particles of an object at this moment.
    pub(crate) fn particles(&self, object: usize) -> anyhow::Result<Vec<Particle>> {
        let particles = self.engine.particles(&self.player, object);
        self.trouble.check()?;
        Ok(particles?)
    }
}
