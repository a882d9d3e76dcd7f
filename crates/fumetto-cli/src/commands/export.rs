//! `fumetto export`

use std::path::Path;
use std::process::ExitCode;

use fumetto_formats::write_png;

use crate::args::ExportArgs;
use crate::render::with_part;
use crate::stage::Stage;
use crate::{console, output, scene};

pub(crate) fn run(args: &ExportArgs) -> anyhow::Result<ExitCode> {
    let opened = scene::open(&args.scene)?;
    output::check(Path::new(&args.out))?;
    let stage = Stage::new(&args.scene.scene, opened.scene, opened.folder)?;
    for (part, image) in stage.atlas()? {
        let name = with_part(&args.out, part);
        output::write(Path::new(&name), |draft| write_png(&image, draft))?;
        console::say(&format!("wrote {name}: {} x {} pixels", image.width, image.height));
    }
    Ok(ExitCode::SUCCESS)
}
