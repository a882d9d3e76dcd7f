//! Frames of drawings that go into one file.

use std::path::Path;
use std::time::Instant;

use fumetto_disk as disk;
use fumetto_formats::{Drawing, write_animated_svg, write_pdf};
use serde_json::{Value, json};

use super::Plan;
use crate::args::Format;
use crate::console;
use crate::interrupt::Interrupt;
use crate::stage::Stage;

/// An .svg that moves, or a .pdf with a page for each frame.
pub(super) fn together(plan: &Plan, stage: &mut Stage, interrupt: &Interrupt) -> anyhow::Result<u64> {
    let start = Instant::now();
    let mut drawn: Vec<(u32, Drawing)> = Vec::new();
    let mut held: Option<u32> = None;
    for frame in plan.frames.iter() {
        interrupt.check()?;
        let number = stage.drawing(frame);
        match drawn.last().filter(|_| held == Some(number)) {
            Some((_, same)) => drawn.push((frame, same.clone())),
            None => {
                stage.seek(frame, interrupt)?;
                drawn.push((frame, stage.vector(&plan.shot, &plan.options)?));
            }
        }
        held = Some(number);
    }
    let file = &plan.target.name;
    let path = Path::new(file);
    if plan.target.format == Format::Pdf {
        let pages: Vec<Drawing> = drawn.into_iter().map(|(_, drawing)| drawing).collect();
        disk::write(path, |draft| write_pdf(&pages, draft))?;
    } else {
        disk::write(path, |draft| write_animated_svg(&drawn, 1.0 / f64::from(plan.fps), draft))?;
    }
    let frames = plan.frames.len();
    console::say(&format!("wrote {file}: {frames} frames"));
    let ms = (start.elapsed().as_secs_f64() * 1e5).round() / 1e2;
    plan.tell(&json!({ "file": file, "frames": frames, "ms": ms }))?;
    Ok(1)
}

/// A drawing in words, and for programs.
pub(super) fn told(drawing: &Drawing) -> (String, Value) {
    let (shapes, segments) = (drawing.shape_count(), drawing.segment_count());
    (format!("{shapes} shapes, {segments} segments"), json!({ "shapes": shapes, "segments": segments }))
}
