//! `fumetto-editor`: the editor in a window.

use std::path::PathBuf;
use std::sync::Arc;

use clap::Parser;
use eframe::egui_wgpu::{WgpuConfiguration, WgpuSetup, WgpuSetupCreateNew};
use fumetto_editor::{App, Project};

/// Draws smoke, clouds and fog as a cartoonist would.
#[derive(Parser)]
#[command(name = "fumetto-editor", version)]
struct Args {
    /// The scene to open.
    scene: Option<PathBuf>,
}

fn main() -> anyhow::Result<()> {
    let args = Args::parse();
    let scene = args.scene.as_deref().map(Project::open).transpose()?;
    let options = eframe::NativeOptions {
        viewport: egui::ViewportBuilder::default().with_inner_size([1280.0, 800.0]).with_app_id("fumetto"),
        wgpu_options: WgpuConfiguration { wgpu_setup: setup(), ..WgpuConfiguration::default() },
        ..eframe::NativeOptions::default()
    };
    eframe::run_native(
        "Fumetto",
        options,
        Box::new(move |creation| {
            let folder = eframe::storage_dir("fumetto").unwrap_or_else(std::env::temp_dir);
            let mut app = App::new(creation, &folder.join("unsaved"));
            if let Some(scene) = scene {
                app.show(scene);
            }
            Ok(Box::new(app))
        }),
    )
    .map_err(|error| anyhow::anyhow!("{error}").context("cannot open a window"))
}

/// The limits that `WebGPU` promises everywhere, as all of Fumetto has them, so that what is seen here can be seen in a
/// browser.
fn setup() -> WgpuSetup {
    WgpuSetup::CreateNew(WgpuSetupCreateNew {
        device_descriptor: Arc::new(|_| wgpu::DeviceDescriptor {
            label: Some("editor.device"),
            ..wgpu::DeviceDescriptor::default()
        }),
        ..WgpuSetupCreateNew::without_display_handle()
    })
}
