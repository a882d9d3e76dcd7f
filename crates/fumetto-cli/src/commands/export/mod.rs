//! `fumetto export`

mod contents;
mod drawings;
mod plan;

use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use fumetto_disk as disk;
use fumetto_formats::write_png;
use serde_json::json;

use self::{contents::Contents, plan::Plan};
use crate::args::{ExportArgs, What};
use crate::interrupt::Interrupt;
use crate::render::with_part;
use crate::stage::Stage;
use crate::{console, scene};

pub(crate) fn run(args: &ExportArgs) -> anyhow::Result<ExitCode> {
    let what = plan::what(args)?;
    let opened = scene::open(&args.scene)?;
    let plan = Plan::new(args, what, &opened.scene)?;
    let interrupt = Interrupt::listen()?;
    disk::check(Path::new(&plan.file(plan.frames.first)))?;
    let mut stage = Stage::new(&args.scene.scene, opened.scene, opened.folder)?;
    stage.use_cache(args.cache.as_deref())?;

    let start = Instant::now();
    let files = match what {
        What::Sprites => sprites(&plan, &stage)?,
        What::Drawings if plan.is_one_of_many() => drawings::together(&plan, &mut stage, &interrupt)?,
        What::Meshes | What::Particles | What::Volumes | What::Drawings => {
            frames(&plan, &mut stage, &interrupt)?
        }
    };
    plan.tell(&json!({
        "done": true,
        "files": files,
        "seconds": (start.elapsed().as_secs_f64() * 1e3).round() / 1e3,
        "adapter": stage.adapter(),
    }))?;
    Ok(ExitCode::SUCCESS)
}

/// The puffs' pictures, which are the same in all frames.
fn sprites(plan: &Plan, stage: &Stage) -> anyhow::Result<u64> {
    let mut files = 0;
    for (part, image) in stage.atlas()? {
        let name = with_part(&plan.target.name, part);
        disk::write(Path::new(&name), |draft| write_png(&image, draft))?;
        console::say(&format!("wrote {name}: {} x {} pixels", image.width, image.height));
        plan.tell(&json!({ "file": name, "width": image.width, "height": image.height }))?;
        files += 1;
    }
    Ok(files)
}

/// A file for each frame.
fn frames(plan: &Plan, stage: &mut Stage, interrupt: &Interrupt) -> anyhow::Result<u64> {
    let mut held: Option<(u32, Contents)> = None;
    for frame in plan.frames.iter() {
        interrupt.check()?;
        let start = Instant::now();
        let drawing = stage.drawing(frame);
        let contents = match held.take() {
            Some((number, contents)) if number == drawing => contents,
            _ => {
                stage.seek(frame, interrupt)?;
                Contents::of(plan, stage)?
            }
        };
        let file = plan.file(frame);
        contents.write(plan, &file)?;
        let (words, mut line) = contents.told();
        for note in contents.notes() {
            console::say(&format!("note: frame {frame}: {note}"));
        }
        console::say(&format!("wrote {file}: {words}"));
        line["frame"] = frame.into();
        line["file"] = file.into();
        line["ms"] = ((start.elapsed().as_secs_f64() * 1e5).round() / 1e2).into();
        plan.tell(&line)?;
        held = Some((drawing, contents));
    }
    Ok(plan.frames.len())
}
