//! The graphics device and what every pass needs of it. Knows nothing of smoke.

mod compact;
mod device;
mod kernels;
#[cfg(test)]
mod layout;
mod lazy;
mod pass;
mod pool;
mod readback;
mod shader;
mod trouble;
mod view;

pub use device::{Gpu, GpuError};
#[cfg(test)]
pub(crate) use layout::{assert_twins, layout_test};
#[cfg(test)]
pub(crate) use lazy::AT_ONCE;
#[cfg(test)]
pub(crate) use readback::read_buffer;
pub(crate) use readback::read_items;
#[cfg(not(target_arch = "wasm32"))]
pub use readback::read_texture;
pub use readback::read_texture_async;
pub use trouble::Trouble;

pub(crate) use compact::{Compact, DrawList, Listing};
pub(crate) use device::{folded, linear_sampler, workgroups};
pub(crate) use kernels::{Slot, kernels, kernels_with};
pub(crate) use lazy::{ComputePipeline, Module, RenderPipeline};
pub(crate) use pass::{Frame, RasterPipeline, Target};
pub(crate) use pool::{TexturePool, Transient};
pub(crate) use shader::shader;
pub(crate) use view::{Region, View};
