use thiserror::Error;

/// Invocations in one workgroup of every kernel that runs over a list.
pub(crate) const WORKGROUP: u32 = 256;

/// A device to draw with, which somebody else may own as well: handles are cheap to clone.
#[derive(Clone, Debug)]
pub struct Gpu {
    /// Makes resources.
    pub device: wgpu::Device,
    /// Takes work.
    pub queue: wgpu::Queue,
    /// Which adapter it is.
    pub adapter: wgpu::AdapterInfo,
}

/// Why there is no device.
#[derive(Debug, Error)]
pub enum GpuError {
    /// No driver offers what is needed.
    #[error(
        "no Vulkan, Metal, Direct3D 12 or WebGPU driver was found ({0}); `fumetto doctor` says what to install"
    )]
    NoAdapter(#[from] wgpu::RequestAdapterError),
    /// The driver refused.
    #[error("the graphics driver refused a device: {0}")]
    NoDevice(#[from] wgpu::RequestDeviceError),
    /// The device went away or failed while it worked.
    #[error("the graphics device was lost or failed: {0}")]
    Lost(String),
}

impl Gpu {
    /// Opens the best adapter that there is, without a window.
    ///
    /// Asks for `WebGPU`'s default limits and no features, so that whatever is drawn here can be
    /// drawn in a browser.
    ///
    /// # Errors
    /// When there is no driver, or it refuses.
    pub async fn headless() -> Result<Self, GpuError> {
        let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle_from_env();
        // Whoever else links `wgpu` may have built it with OpenGL, which has not all that is needed.
        descriptor.backends.remove(wgpu::Backends::GL);
        let instance = wgpu::Instance::new(descriptor);
        let adapter = instance
            .request_adapter(&wgpu::RequestAdapterOptions {
                power_preference: wgpu::PowerPreference::HighPerformance,
                ..Default::default()
            })
            .await?;
        let (device, queue) = adapter
            .request_device(&wgpu::DeviceDescriptor { label: Some("fumetto.device"), ..Default::default() })
            .await?;
        Ok(Self { device, queue, adapter: adapter.get_info() })
    }

    /// Waits until everything submitted has been done. For export and measurement only.
    ///
    /// # Errors
    /// When the device is lost.
    pub fn wait(&self) -> Result<(), GpuError> {
        self.device
            .poll(wgpu::PollType::wait_indefinitely())
            .map(|_| ())
            .map_err(|error| GpuError::Lost(error.to_string()))
    }
}

/// Workgroups that cover `items`, in rows as [`folded`] tells.
pub(crate) fn workgroups(items: u32) -> [u32; 3] {
    folded(items.div_ceil(WORKGROUP))
}

/// As many workgroups, or a few more.
///
/// Beyond the 65,535 that `WebGPU` allows along one axis they fold into rows; kernels get their item from
/// `row * columns + column`.
pub(crate) fn folded(groups: u32) -> [u32; 3] {
    let groups = groups.max(1);
    let rows = groups.div_ceil(65_535);
    [groups.div_ceil(rows), rows, 1]
}

/// A sampler that filters and clamps.
pub(crate) fn linear_sampler(gpu: &Gpu) -> wgpu::Sampler {
    gpu.device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("gpu.linear"),
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        // Its textures have one level: said here, software rasterisers need not look for others.
        lod_max_clamp: 0.0,
        ..Default::default()
    })
}
