//! McGuire's puffs: every particle is a billboard of a pre-rendered bundle of balls that carries
//! normals and depth.
//!
//! McGuire & Fein, "Real-Time Cartoon Rendering of Smoke", 2004. Ours, beyond the poster: puffs that
//! something solid hides are not drawn at all, what a pixel looks like is worked out once however many
//! puffs lie behind it, and normals may bend toward the form of the whole cloud.

mod atlas;
mod bins;
mod body;
mod bundle;
mod form;
mod normal;
mod present;
mod pyramid;
mod scene;

pub(crate) use atlas::{Atlas, AtlasError, HEIGHTS_SLOT};
pub(crate) use bins::{Binning, Bins, WALK_SLOTS};
pub(crate) use body::Body;
pub(crate) use form::Form;
pub(crate) use normal::Normal;
pub(crate) use present::{Placement, Present, Puff, still_puffs};
pub(crate) use pyramid::{Pyramid, Reduce};
pub(crate) use scene::{PuffObject, PuffScene, Subject};
