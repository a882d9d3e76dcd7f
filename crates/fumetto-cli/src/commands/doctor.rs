//! `fumetto doctor`

use std::process::ExitCode;

use wgpu::{Adapter, Backends, DeviceType, Instance, InstanceDescriptor};

use crate::{console, gpu};

pub(crate) fn run() -> anyhow::Result<ExitCode> {
    let instance = Instance::new(InstanceDescriptor::new_without_display_handle_from_env());
    let adapters = pollster::block_on(instance.enumerate_adapters(Backends::PRIMARY));
    for adapter in &adapters {
        console::print(&describe(adapter))?;
    }
    match gpu::open() {
        Ok((gpu, _)) => {
            let limits = gpu.device.limits();
            console::print(&format!("fumetto draws with: {}", gpu::describe(&gpu.adapter)))?;
            console::print(&limits_words("  uses at most", &limits))?;
            if gpu.adapter.device_type == DeviceType::Cpu {
                console::print(
                    "That is the processor: pictures are right, but slow to draw. If there is a graphics",
                )?;
                console::print("card, install its driver.")?;
            }
            Ok(ExitCode::SUCCESS)
        }
        Err(error) => {
            if adapters.is_empty() {
                console::print("no graphics adapter was found")?;
            }
            console::print(&format!("fumetto cannot draw here: {error}"))?;
            console::print(INSTALL)?;
            Ok(ExitCode::FAILURE)
        }
    }
}

fn describe(adapter: &Adapter) -> String {
    let info = adapter.get_info();
    let kind = match info.device_type {
        DeviceType::DiscreteGpu => "graphics card",
        DeviceType::IntegratedGpu => "graphics in the processor's chip",
        DeviceType::VirtualGpu => "virtual graphics card",
        DeviceType::Cpu => "software, on the processor",
        DeviceType::Other => "of unknown type",
    };
    let driver = format!("{} {}", info.driver, info.driver_info);
    let limits = limits_words("  limits  ", &adapter.limits());
    format!("{}\n  type     {kind}\n  driver   {}\n{limits}", gpu::describe(&info), driver.trim())
}

/// The limits that decide how large a picture and how many particles there can be.
fn limits_words(title: &str, limits: &wgpu::Limits) -> String {
    let side = limits.max_texture_dimension_2d;
    let binding = indicatif::BinaryBytes(limits.max_storage_buffer_binding_size);
    format!("{title} {side} samples along a picture's side, {binding} in one buffer")
}

#[cfg(target_os = "linux")]
const INSTALL: &str = "\
A driver for Vulkan is what is needed. On Debian and Ubuntu
  sudo apt install mesa-vulkan-drivers
has those for AMD and Intel, and one that draws with the processor where there is no graphics card.
For NVIDIA install the maker's driver. Inside a container, pass the graphics card in as well.";

#[cfg(target_os = "macos")]
const INSTALL: &str = "Metal is what is needed: macOS has it on every machine since 2012.";

#[cfg(target_os = "windows")]
const INSTALL: &str = "\
A driver for Direct3D 12 or Vulkan is what is needed: install the newest one of your graphics card's maker.";

#[cfg(not(any(target_os = "linux", target_os = "macos", target_os = "windows")))]
const INSTALL: &str = "A driver for Vulkan is what is needed.";
