//! The picture in the window, and the hand that turns it.

mod brush;
mod gizmo;
mod handles;
mod navigation;
mod orbit;
mod overlay;
mod viewport;

pub(crate) use brush::Brush;
pub(crate) use gizmo::Gizmo;
pub(crate) use handles::{Handle, ball, handles, handles_of_selected};
pub(crate) use navigation::Navigation;
pub(crate) use orbit::{Orbit, Side};
pub(crate) use viewport::{Hand, Viewport};
