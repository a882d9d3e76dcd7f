//! Scenes as text, files in memory, and pictures to look at.

use std::{
    collections::{BTreeMap, BTreeSet},
    fmt::Write as _,
    io,
    sync::{LazyLock, Mutex, MutexGuard, PoisonError},
};

use fumetto::{Assets, Engine, Error, Gpu, Player, Shot};
use fumetto_formats::Image;
use fumetto_scene::{Scene, SceneText};

/// Building all pipelines takes longer than most tests do: they share one engine.
static ENGINE: LazyLock<Mutex<Engine>> =
    LazyLock::new(|| Mutex::new(Engine::new(pollster::block_on(Gpu::headless()).unwrap())));

pub(crate) fn engine() -> MutexGuard<'static, Engine> {
    ENGINE.lock().unwrap_or_else(PoisonError::into_inner)
}

pub(crate) type Rgb = [u8; 3];

/// What lies behind in every scene that does not say otherwise.
pub(crate) const BACKGROUND: Rgb = [0x20, 0x60, 0x30];

/// Sides of the picture where a scene does not say otherwise.
pub(crate) const SIDE: u32 = 512;

/// Distance of the camera from the origin.
pub(crate) const DISTANCE: f32 = 10.0;

/// Metres at the origin to pixels: the camera's field of view has a half angle whose tangent is 1/2.
pub(crate) const PX_PER_METRE: f32 = SIDE as f32 / DISTANCE;

/// Radius of the ball that a puff of one ball is, over the puff's radius.
pub(crate) const CORE: f32 = 0.62;

/// A scene that looks along -z at puffs of one ball each, in exact tones, without ink and shadows, lit
/// from the camera. Parts are replaced as a test wants.
#[derive(Clone, Debug)]
pub(crate) struct Stage {
    pub(crate) camera: String,
    pub(crate) light: String,
    pub(crate) background: String,
    pub(crate) output: String,
    pub(crate) time: String,
    pub(crate) style: String,
    pub(crate) objects: String,
}

impl Default for Stage {
    fn default() -> Self {
        Self {
            camera: format!("eye = [0, 0, {DISTANCE}], target = [0, 0, 0], fov = 53.130102"),
            light: "kind = \"sun\", direction = [0, 0, -1]".into(),
            background: "background = { colour = \"#206030\" }".into(),
            output: format!("size = [{SIDE}, {SIDE}], antialias = 1"),
            time: "fps = 24, frames = [0, 100]".into(),
            style: style(&["#ffffff"], ""),
            objects: String::new(),
        }
    }
}

/// A style without ink, shadows, form and cleaning; `more` may change that.
pub(crate) fn style(tones: &[&str], more: &str) -> String {
    let mut text = format!("form = 0, clean = {{ px = 0 }}, height = {SIDE}, tones = {tones:?}");
    for (key, plain) in
        [("wrap", "0"), ("ink", "{ on = false }"), ("shadow", "{ on = false }"), ("shading", "\"per-pixel\"")]
    {
        if !more.contains(key) {
            write!(text, ", {key} = {plain}").unwrap();
        }
    }
    if more.is_empty() { text } else { format!("{text}, {more}") }
}

impl Stage {
    /// Adds a cloud of `[x, y, z, radius]` puffs of one ball each; `more` are further keys.
    pub(crate) fn balls(self, name: &str, puffs: &[[f32; 4]], more: &str) -> Self {
        self.cloud(name, puffs, "spheres = 1, variants = 1, tile = 512", more)
    }

    /// Adds a cloud of `[x, y, z, radius]` particles.
    pub(crate) fn cloud(self, name: &str, particles: &[[f32; 4]], shape: &str, more: &str) -> Self {
        self.shaped(name, particles, &format!("puffs = {{ {shape} }}"), more)
    }

    /// Adds a surface round `[x, y, z, radius]` particles.
    pub(crate) fn surface(self, name: &str, particles: &[[f32; 4]], shape: &str, more: &str) -> Self {
        self.shaped(name, particles, &format!("surface = {{ {shape} }}"), more)
    }

    /// Adds a volume of `[x, y, z, radius]` particles.
    pub(crate) fn volume(self, name: &str, particles: &[[f32; 4]], shape: &str, more: &str) -> Self {
        self.shaped(name, particles, &format!("volume = {{ {shape} }}"), more)
    }

    fn shaped(mut self, name: &str, puffs: &[[f32; 4]], shape: &str, more: &str) -> Self {
        let list: Vec<_> = puffs
            .iter()
            .map(|[x, y, z, radius]| format!("{{ center = [{x}, {y}, {z}], radius = {radius} }}"))
            .collect();
        let list = list.join(", ");
        write!(
            self.objects,
            "[[object]]\nname = \"{name}\"\nkind = \"cloud\"\nshape = {{ {shape} }}\n\
             particles = [{list}]\n{more}\n"
        )
        .unwrap();
        self
    }

    /// Adds the model of the file `model`; `more` are further keys.
    pub(crate) fn mesh(mut self, name: &str, model: &str, more: &str) -> Self {
        write!(self.objects, "[[object]]\nname = \"{name}\"\nkind = \"mesh\"\nmodel = \"{model}\"\n{more}\n")
            .unwrap();
        self
    }

    pub(crate) fn scene(&self) -> Scene {
        let Self { camera, light, background, output, time, style, objects } = self;
        let toml = format!(
            "format = 1\ncamera = {{ {camera} }}\nlight = [{{ {light} }}]\n{background}\n\
             output = {{ {output} }}\ntime = {{ {time} }}\nstyle = {{ {style} }}\n{objects}"
        );
        let text = SceneText { name: "test", toml: &toml, ..Default::default() };
        let loaded = Scene::load(&text, &mut |_| Err("there are no styles".into()));
        loaded.unwrap_or_else(|report| panic!("{}", report.render(false))).0
    }

    /// The picture of frame 0.
    pub(crate) fn picture(&self) -> Picture {
        self.picture_with(Files::default())
    }

    /// The picture of frame 0, of a scene that names files.
    pub(crate) fn picture_with(&self, files: Files) -> Picture {
        let mut engine = engine();
        let mut player = self.play(&engine, files).unwrap();
        picture_at(&mut engine, &mut player, 0).unwrap()
    }

    pub(crate) fn play(&self, engine: &Engine, files: Files) -> Result<Player, Error> {
        engine.play(self.scene(), Box::new(files))
    }
}

/// The picture of one frame.
pub(crate) fn picture_at(engine: &mut Engine, player: &mut Player, frame: u32) -> Result<Picture, Error> {
    engine.seek(player, frame)?;
    let shot = Shot::of(player.scene());
    Ok(Picture(engine.picture(player, &shot)?))
}

/// Files in memory.
#[derive(Debug, Default)]
pub(crate) struct Files(pub(crate) BTreeMap<String, Vec<u8>>);

impl Files {
    pub(crate) fn with(mut self, path: &str, bytes: impl Into<Vec<u8>>) -> Self {
        self.0.insert(path.to_owned(), bytes.into());
        self
    }
}

impl Assets for Files {
    fn read(&self, path: &str) -> io::Result<Vec<u8>> {
        self.0.get(path).cloned().ok_or_else(|| io::ErrorKind::NotFound.into())
    }
}

/// A picture and questions about it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Picture(pub(crate) Image);

impl Picture {
    /// Straight red, green, blue, alpha.
    pub(crate) fn rgba(&self, x: u32, y: u32) -> [u8; 4] {
        let at = 4 * (y * self.0.width + x) as usize;
        [0, 1, 2, 3].map(|channel| self.0.pixels[at + channel])
    }

    pub(crate) fn rgb(&self, x: u32, y: u32) -> Rgb {
        let [r, g, b, _] = self.rgba(x, y);
        [r, g, b]
    }

    /// All places, row by row.
    pub(crate) fn places(&self) -> impl Iterator<Item = (u32, u32)> + use<> {
        let width = self.0.width;
        (0..self.0.height).flat_map(move |y| (0..width).map(move |x| (x, y)))
    }

    pub(crate) fn count(&self, colour: Rgb) -> usize {
        self.places().filter(|&(x, y)| self.rgb(x, y) == colour).count()
    }

    /// Pixels that are not background.
    pub(crate) fn drawn(&self) -> usize {
        self.0.pixels.len() / 4 - self.count(BACKGROUND)
    }

    pub(crate) fn colours(&self) -> BTreeSet<Rgb> {
        self.places().map(|(x, y)| self.rgb(x, y)).collect()
    }
}

/// The same numbers from the same seed everywhere, from 0 to 1 (`SplitMix64`).
#[derive(Debug)]
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn next(&mut self) -> f32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((bits ^ (bits >> 31)) >> 40) as f32 / (1 << 24) as f32
    }

    pub(crate) fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.next()
    }
}
