//! Programs and pipelines that are made when they are first used. A scene needs a few of all that there are, and
//! drivers take their time over each.

use std::sync::{Arc, LazyLock};

use super::Gpu;

/// What the device makes when it is first used.
type Lazy<T> = LazyLock<T, Box<dyn FnOnce() -> T + Send>>;

/// A compute pipeline, made when it is first used.
pub(crate) type ComputePipeline = Lazy<wgpu::ComputePipeline>;

/// A render pipeline, made when it is first used.
pub(crate) type RenderPipeline = Lazy<wgpu::RenderPipeline>;

/// A program on the device, made when the first of its pipelines is.
#[derive(Clone, Debug)]
pub(crate) struct Module {
    device: wgpu::Device,
    module: Arc<Lazy<wgpu::ShaderModule>>,
}

impl Gpu {
    /// The program, for pipelines to come.
    pub(crate) fn module(&self, program: wgpu::ShaderModuleDescriptor<'static>) -> Module {
        let device = self.device.clone();
        let made = {
            let device = device.clone();
            Lazy::new(Box::new(move || device.create_shader_module(program)))
        };
        Module { device, module: Arc::new(made) }
    }
}

impl Module {
    /// Something that will be made of the program.
    pub(crate) fn later<T>(
        &self,
        make: impl FnOnce(&wgpu::Device, &wgpu::ShaderModule) -> T + Send + 'static,
    ) -> Lazy<T> {
        let Self { device, module } = self.clone();
        let made: Lazy<T> = Lazy::new(Box::new(move || make(&device, &module)));
        #[cfg(test)]
        if AT_ONCE.get() {
            LazyLock::force(&made);
        }
        made
    }
}

#[cfg(test)]
thread_local! {
    /// Whether all is made at once on this thread, so that a test sees what no scene of the tests may need.
    pub(crate) static AT_ONCE: std::cell::Cell<bool> = const { std::cell::Cell::new(false) };
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]
mod tests {
    use super::*;
    use crate::gpu::{Slot, kernels};

    #[test]
    fn a_program_is_made_once_and_only_when_it_is_used() {
        let gpu = pollster::block_on(Gpu::headless()).unwrap();
        let program = |wgsl: &'static str| wgpu::ShaderModuleDescriptor {
            label: Some("test"),
            source: wgpu::ShaderSource::Wgsl(wgsl.into()),
        };
        // A device that nobody listens to ends the test where it is asked for something that cannot be made.
        let _broken = kernels(&gpu, program("this is no program"), &[Slot::Write], ["main"]);
        let whole = "@group(0) @binding(0) var<storage, read_write> a: u32;
            @compute @workgroup_size(1) fn main() { a = 1u; }";
        let [used, _nowhere] = kernels(&gpu, program(whole), &[Slot::Write], ["main", "nowhere"]);
        let first: &wgpu::ComputePipeline = &used;
        assert!(std::ptr::eq(first, &raw const *used));
    }

    #[test]
    #[should_panic(expected = "this is no program")]
    fn what_cannot_be_made_is_told_when_it_is_used() {
        let gpu = pollster::block_on(Gpu::headless()).unwrap();
        let source = wgpu::ShaderSource::Wgsl("this is no program".into());
        let program = wgpu::ShaderModuleDescriptor { label: Some("test"), source };
        let [broken] = kernels(&gpu, program, &[Slot::Write], ["main"]);
        LazyLock::force(&broken);
    }
}
