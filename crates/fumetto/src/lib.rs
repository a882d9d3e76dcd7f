//! The Fumetto engine: simulates smoke and draws it as a cartoonist would.
//!
//! ```text
//! Scene ─▶ Player ─▶ particles ─▶ puffs ─▶ layers ─▶ light ─▶ ink ─▶ tone ─▶ picture
//! ```
//!
//! The engine takes a `wgpu` device that somebody else may own and draws into a texture view; it knows
//! no window and opens no file. [`Engine`] holds what lives long, [`Player`] one scene at one moment.
//!
//! ```no_run
//! use fumetto::{Assets, Engine, Error, Gpu, Shot};
//! use fumetto_formats::Image;
//! use fumetto_scene::Scene;
//!
//! /// The picture of a scene at frame 24; its files come from `files`.
//! fn draw(scene: Scene, files: Box<dyn Assets>) -> Result<Image, Error> {
//!     let mut engine = Engine::new(pollster::block_on(Gpu::headless())?);
//!     let mut player = engine.play(scene, files)?;
//!     engine.seek(&mut player, 24)?;
//!     let shot = Shot::of(player.scene());
//!     engine.picture(&player, &shot)
//! }
//! ```

mod assets;
#[cfg(not(target_arch = "wasm32"))]
mod blocking;
mod cels;
mod details;
mod engine;
mod error;
mod export;
mod export_volume;
mod frame;
mod gpu;
mod ink;
mod layers;
mod lengths;
mod light;
mod morph;
mod object;
mod paint;
mod particles;
mod player;
mod print;
mod proof;
mod setting;
mod shapes;
mod simulation;
mod snapshot;
mod tiles;
mod tone;
mod vector;

pub use assets::Assets;
pub use engine::{Engine, PICTURE_FORMAT, Shot};
pub use error::Error;
pub use export::Export;
#[cfg(not(target_arch = "wasm32"))]
pub use gpu::read_texture;
pub use gpu::{Gpu, GpuError, Trouble, read_texture_async};
pub use particles::{AirTimes, TooManyFacets};
pub use player::{ImportedSize, Player, imported_size};
pub use print::Print;
pub use proof::{Layer, UnknownLayer};
pub use shapes::surface::SurfaceSize;
pub use shapes::volume::ImportError;
pub use snapshot::{Extent, Snapshot};
pub use tiles::Tiling;
pub use vector::{DrawingOptions, LineModel};
