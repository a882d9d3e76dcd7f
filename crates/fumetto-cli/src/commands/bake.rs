//! `fumetto bake`

use std::fs;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use anyhow::{Context as _, bail};
use fumetto::Extent;

use crate::args::{BakeArgs, FrameRange};
use crate::cache::{Cache, Found};
use crate::exit::Stop;
use crate::interrupt::Interrupt;
use crate::progress::Progress;
use crate::scene;
use crate::stage::Stage;

/// So often is kept what the simulation can go on from: what a crash may cost.
const KEEP_EVERY: Duration = Duration::from_secs(60);

pub(crate) fn run(args: &BakeArgs) -> anyhow::Result<ExitCode> {
    let opened = scene::open(&args.scene)?;
    let frames = FrameRange::chosen(None, args.frames, false, opened.scene.time.frames);
    let hold = opened.scene.time.hold;
    let interrupt = Interrupt::listen()?;
    let mut stage = Stage::new(&args.scene.scene, opened.scene, opened.folder)?;
    if !stage.player().simulates() {
        bail!(
            "{}: there is neither smoke nor paint in it, so there is nothing to bake",
            args.scene.scene.display()
        );
    }
    fs::create_dir_all(&args.out)
        .with_context(|| format!("cannot make the folder {}", args.out.display()))?;
    let cache = Cache::open(&args.out, stage.player().fingerprint())?;

    // On twos every other frame is that before it.
    let drawn = |frame: &u32| frame.is_multiple_of(hold);
    let drawn: Vec<u32> = (frames.first - frames.first % hold..=frames.last).filter(drawn).collect();
    check(&cache, &drawn)?;
    let mut baking = Baking { cache: &cache, kept: Instant::now(), is_ahead: false };
    let file = |frame: u32| cache.file(frame - frame % hold).display().to_string();
    let span = FrameRange { first: drawn[0], last: drawn[drawn.len() - 1] };
    let mut progress = Progress::new(span, file, args.json).of(drawn.len());
    let baked = baking.frames(&mut stage, &drawn, &interrupt, &mut progress);
    // Whoever goes on, after Ctrl-C or with more frames, begins where this ended.
    if baked.as_ref().map_or_else(anyhow::Error::is::<Stop>, |()| true) {
        baking.keep(&stage)?;
    }
    baked?;
    progress.finish(Some(&stage.adapter()))?;
    Ok(ExitCode::SUCCESS)
}

/// Refuses to mix two scenes in one folder.
fn check(cache: &Cache, frames: &[u32]) -> anyhow::Result<()> {
    for &frame in frames {
        if cache.find(frame)? == Found::Other {
            bail!(
                "{} is of another scene, or of this one before it was changed; bake into another folder, or remove \
                 this one",
                cache.file(frame).display()
            );
        }
    }
    Ok(())
}

/// What has been done in a folder.
struct Baking<'a> {
    cache: &'a Cache,
    /// When it was kept last what the simulation can go on from.
    kept: Instant,
    /// Whether the simulation has gone on since.
    is_ahead: bool,
}

impl Baking<'_> {
    fn frames(
        &mut self,
        stage: &mut Stage,
        frames: &[u32],
        interrupt: &Interrupt,
        progress: &mut Progress<'_>,
    ) -> anyhow::Result<()> {
        let mut has_begun = false;
        for &frame in frames {
            interrupt.check()?;
            let start = Instant::now();
            if self.cache.find(frame)? == Found::Ours {
                progress.skipped(frame)?;
                continue;
            }
            if !has_begun {
                self.begin(stage, frame)?;
                has_begun = true;
            }
            self.is_ahead = true;
            stage.seek(frame, interrupt)?;
            self.cache.write(stage.snapshot(Extent::Shown)?)?;
            progress.wrote(frame, start.elapsed(), Vec::new())?;
            if self.kept.elapsed() > KEEP_EVERY {
                self.keep(stage)?;
            }
        }
        Ok(())
    }

    /// Goes on from what an earlier run kept, if that leads to `frame`.
    fn begin(&self, stage: &mut Stage, frame: u32) -> anyhow::Result<()> {
        match self.cache.checkpoint()? {
            Some(checkpoint) if checkpoint.frame <= frame => stage.go_on_from(&checkpoint),
            _ => Ok(()),
        }
    }

    fn keep(&mut self, stage: &Stage) -> anyhow::Result<()> {
        if self.is_ahead {
            self.cache.keep(stage.snapshot(Extent::Whole)?)?;
            (self.kept, self.is_ahead) = (Instant::now(), false);
        }
        Ok(())
    }
}
