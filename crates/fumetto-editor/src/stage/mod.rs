//! The scene as it is played and seen: the engine's own picture, drawn whenever something has changed.

mod canvas;
mod gallery;
mod pace;

use std::time::Duration;

use eframe::egui_wgpu::RenderState;
use egui::TextureId;
use fumetto::{Assets, Engine, Gpu, Player, Shot, Trouble};
use fumetto_scene::{Background, Camera, Colour, Scene};

use self::{canvas::Canvas, gallery::Gallery, pace::Pace};

/// Frames that the simulation may go on at once while its picture is waited for: what lies farther away is reached in
/// several goes, between which the hand is heard.
const FRAMES_AT_A_TIME: u32 = 4;

/// How often the device is asked whether a picture is done.
const POLL: Duration = Duration::from_millis(8);

/// What is to be seen.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Wish {
    pub(crate) frame: u32,
    pub(crate) camera: Camera,
    /// In pixels of the screen.
    pub(crate) size: [u32; 2],
    /// Whether something still moves, so that soon is better than fine.
    pub(crate) in_motion: bool,
}

/// The device, the scene on it, and its picture.
pub(crate) struct Stage {
    engine: Engine,
    trouble: Trouble,
    canvas: Canvas,
    gallery: Gallery,
    pace: Pace,
    player: Option<Player>,
    /// What the picture shows, and how coarsely.
    shown: Option<(Wish, u32)>,
    picture: Option<TextureId>,
    wake: egui::Context,
    failures: Failures,
}

/// What went wrong last, each until it goes right.
#[derive(Default)]
struct Failures {
    play: Option<String>,
    draw: Option<String>,
    gallery: Option<String>,
}

impl Stage {
    /// On the device that egui draws with.
    pub(crate) fn new(render: RenderState, wake: egui::Context) -> Self {
        let gpu = Gpu {
            device: render.device.clone(),
            queue: render.queue.clone(),
            adapter: render.adapter.get_info(),
        };
        let trouble = Trouble::of(&gpu);
        Self {
            engine: Engine::new(gpu),
            trouble,
            gallery: Gallery::new(render.clone()),
            canvas: Canvas::new(render),
            pace: Pace::default(),
            player: None,
            shown: None,
            picture: None,
            wake,
            failures: Failures::default(),
        }
    }

    /// Plays `scene` from now on. Where its files are missing or it does not fit the device, the scene before it
    /// stays.
    pub(crate) fn play(&mut self, scene: Scene, assets: Box<dyn Assets>) {
        let scene = before_grey(scene);
        let played = match &mut self.player {
            Some(player) => self.engine.renew(player, scene, assets),
            None => self.engine.play(scene, assets).map(|player| self.player = Some(player)),
        };
        self.failures = Failures { play: said(&played), ..Failures::default() };
        self.shown = None;
    }

    /// The scene that is played.
    pub(crate) fn scene(&self) -> Option<&Scene> {
        self.player.as_ref().map(Player::scene)
    }

    /// What went wrong last, until it goes right.
    pub(crate) fn errors(&self) -> impl Iterator<Item = &str> {
        let Failures { play, draw, gallery } = &self.failures;
        [play, draw, gallery].into_iter().flat_map(Option::as_deref)
    }

    /// What the files that were read give reason to say.
    pub(crate) fn notes(&self) -> &[String] {
        self.player.as_ref().map_or(&[], Player::notes)
    }

    /// The frame that the picture shows.
    pub(crate) fn frame(&self) -> Option<u32> {
        self.shown.as_ref().map(|(wish, _)| wish.frame)
    }

    /// Whether the picture is done, shows `frame` as `camera` sees it, and gets no finer.
    pub(crate) fn shows(&self, frame: u32, camera: &Camera) -> bool {
        !self.pace.is_busy()
            && self
                .shown
                .as_ref()
                .is_some_and(|(wish, _)| !wish.in_motion && wish.frame == frame && wish.camera == *camera)
    }

    /// Whether the picture is as fine as it gets.
    fn is_at_rest(&self) -> bool {
        self.shown.as_ref().is_some_and(|(wish, _)| !wish.in_motion)
    }

    /// How long the last picture took.
    pub(crate) fn took(&self) -> Option<Duration> {
        self.pace.took()
    }

    /// A pixel of the picture is as wide as this many of the screen.
    pub(crate) fn coarseness(&self) -> u32 {
        self.shown.as_ref().map_or(1, |(_, coarseness)| *coarseness)
    }

    /// Brings the picture nearer to `wish`, if the device is free, and gives the picture as far as it has come.
    pub(crate) fn show(&mut self, wish: &Wish) -> Option<TextureId> {
        // Browsers do this by themselves.
        let _ = self.engine.gpu().device.poll(wgpu::PollType::Poll);
        if self.pace.is_free() && self.is_behind(wish) {
            let drawn = self.draw(wish);
            if drawn.is_err() {
                // It will not go better the next time.
                self.shown = Some((wish.clone(), 1));
            }
            self.failures.draw = said(&drawn);
        }
        if let Err(error) = self.trouble.check() {
            self.failures.draw = Some(error.to_string());
        }
        if self.pace.is_busy() {
            // The device tells that it is done only to those who ask.
            self.wake.request_repaint_after(POLL);
        }
        self.picture
    }

    fn is_behind(&self, wish: &Wish) -> bool {
        self.shown.as_ref().is_none_or(|(shown, _)| {
            let same = Wish { in_motion: wish.in_motion, ..shown.clone() } == *wish;
            !same || (shown.in_motion && !wish.in_motion)
        })
    }

    fn draw(&mut self, wish: &Wish) -> Result<(), fumetto::Error> {
        let Some(player) = &mut self.player else { return Ok(()) };
        if !self.engine.pre_roll(player, wish.frame, FRAMES_AT_A_TIME) {
            let wake = self.wake.clone();
            self.pace.begin(&self.engine.gpu().queue, false, move || wake.request_repaint());
            return Ok(());
        }
        let next = match player.reached() {
            // What lies before is reached from the start.
            Some(reached) => {
                let from = if reached <= wish.frame { reached } else { 0 };
                // A drawing that is held longer has to be left all the same.
                wish.frame.min(from + FRAMES_AT_A_TIME.max(player.scene().time.hold))
            }
            None => wish.frame,
        };
        self.engine.seek(player, next)?;
        let is_there = next == wish.frame;
        let coarseness = if wish.in_motion || !is_there { self.pace.coarseness() } else { 1 };
        let antialias = if coarseness == 1 && !wish.in_motion { player.scene().output.antialias } else { 1 };
        let shot = Shot {
            camera: wish.camera.clone(),
            size: wish.size.map(|side| side.div_ceil(coarseness).max(1)),
            antialias,
        };
        let texture = self.canvas.texture(shot.size);
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        self.engine.draw(player, &shot, &view)?;
        self.picture = self.canvas.show();
        self.shown = Some((Wish { frame: next, ..wish.clone() }, coarseness));
        let wake = self.wake.clone();
        let counts = wish.in_motion;
        self.pace.begin(&self.engine.gpu().queue, counts, move || wake.request_repaint());
        Ok(())
    }
}

/// A scene without a background is shown before this, for a window has no alpha of its own.
const GREY: Colour = Colour { linear: [0.12, 0.12, 0.12] };

fn before_grey(mut scene: Scene) -> Scene {
    if scene.background == Background::Transparent {
        scene.background = Background::Colour(GREY);
    }
    scene
}

/// What went wrong, with what led to it.
fn said<T>(result: &Result<T, fumetto::Error>) -> Option<String> {
    let error: &dyn std::error::Error = result.as_ref().err()?;
    let causes = std::iter::successors(error.source(), |cause| cause.source());
    Some(causes.fold(error.to_string(), |text, cause| format!("{text}: {cause}")))
}
