//! `fumetto render`

use std::process::ExitCode;
use std::time::Instant;

use crate::args::{RenderArgs, TargetKind};
use crate::interrupt::Interrupt;
use crate::progress::Progress;
use crate::render::{Drawing, Picture, Plan, Sink};
use crate::scene;
use crate::stage::Stage;

pub(crate) fn run(args: &RenderArgs) -> anyhow::Result<ExitCode> {
    Plan::check(args)?;
    let opened = scene::open(&args.scene)?;
    let plan = Plan::new(args, &opened.scene)?;
    let interrupt = Interrupt::listen()?;
    let mut sink = Sink::open(&plan, &opened.scene)?;

    let everything_is_done = plan.frames.iter().all(|frame| plan.is_done(frame));
    let mut stage = if everything_is_done {
        None
    } else {
        let mut stage = Stage::new(&args.scene.scene, opened.scene, opened.folder)?;
        stage.use_cache(args.cache.as_deref())?;
        Some(stage)
    };

    let mut progress = Progress::new(plan.frames, |frame| plan.file(frame), args.json);
    let mut shown: Option<Drawing> = None;
    for frame in plan.frames.iter() {
        interrupt.check()?;
        let start = Instant::now();
        match &mut stage {
            Some(stage) if !plan.is_done(frame) => {
                let mut drawing = match shown.take() {
                    Some(held) if held.number == stage.drawing(frame) => held,
                    _ => draw(stage, &plan, frame, &interrupt)?,
                };
                sink.write(&plan, frame, &mut drawing, &mut |print| {
                    interrupt.check()?;
                    let band = stage.draw_tile(print)?;
                    progress.drew_tile(print);
                    Ok(band)
                })?;
                shown = Some(drawing);
                progress.wrote(frame, start.elapsed(), plan.layer_files(frame))?;
            }
            _ => progress.skipped(frame)?,
        }
    }
    sink.finish(&plan)?;
    progress.finish(stage.map(|stage| stage.adapter()).as_deref())?;
    Ok(ExitCode::SUCCESS)
}

fn draw(stage: &mut Stage, plan: &Plan, frame: u32, interrupt: &Interrupt) -> anyhow::Result<Drawing> {
    stage.seek(frame, interrupt)?;
    let layers = plan.layers.iter().map(|&layer| stage.layer(&plan.shot, layer)).collect::<Result<_, _>>()?;
    let may_be_tiles = plan.target.kind != TargetKind::Animation;
    let picture = match if may_be_tiles { stage.print(&plan.shot)? } else { None } {
        Some(print) => Picture::Tiles(Box::new(print)),
        None => Picture::Drawn(stage.picture(&plan.shot)?),
    };
    Ok(Drawing { number: stage.drawing(frame), picture, layers })
}
