//! How far a rendering is: a bar on a terminal, JSON for programs.

use std::time::{Duration, Instant};

use fumetto::Print;
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::json;

use crate::args::FrameRange;
use crate::console;

/// Tells what has been done.
pub(crate) struct Progress<'a> {
    frames: FrameRange,
    /// The file that a frame goes to.
    file: Box<dyn Fn(u32) -> String + 'a>,
    /// Not drawn unless standard error is a terminal.
    bar: ProgressBar,
    json: bool,
    start: Instant,
    written: u64,
    skipped: u64,
}

impl<'a> Progress<'a> {
    /// Of `frames`, each of which goes to a `file`.
    pub(crate) fn new(frames: FrameRange, file: impl Fn(u32) -> String + 'a, json: bool) -> Self {
        let bar = ProgressBar::new(frames.len());
        if let Ok(style) = ProgressStyle::with_template("{bar:30} {pos}/{len} frames{msg}, {eta} left") {
            bar.set_style(style);
        }
        bar.enable_steady_tick(Duration::from_millis(200));
        Self { frames, file: Box::new(file), bar, json, start: Instant::now(), written: 0, skipped: 0 }
    }

    /// Of those frames only so many differ.
    pub(crate) fn of(self, count: usize) -> Self {
        self.bar.set_length(count as u64);
        self
    }

    /// A tile of the frame at hand has been drawn.
    pub(crate) fn drew_tile(&self, print: &Print) {
        let (drawn, all) = (print.drawn_count(), print.tile_count());
        self.bar.set_message(if drawn < all { format!(" and {drawn}/{all} tiles") } else { String::new() });
    }

    /// `frame` has been written, and files of its `layers` with it.
    pub(crate) fn wrote(&mut self, frame: u32, took: Duration, layers: Vec<String>) -> anyhow::Result<()> {
        self.written += 1;
        self.bar.inc(1);
        let mut line = json!({ "frame": frame, "file": (self.file)(frame), "ms": millis(took) });
        if !layers.is_empty() {
            line["layers"] = layers.into();
        }
        self.print(&line)
    }

    /// `frame` was there already.
    pub(crate) fn skipped(&mut self, frame: u32) -> anyhow::Result<()> {
        self.skipped += 1;
        self.bar.inc(1);
        // What takes no time says nothing about the rest.
        self.bar.reset_eta();
        self.print(&json!({ "frame": frame, "file": (self.file)(frame), "ms": 0.0, "skipped": true }))
    }

    /// All is done, by `adapter` if anything was drawn.
    pub(crate) fn finish(self, adapter: Option<&str>) -> anyhow::Result<()> {
        self.bar.finish_and_clear();
        let secs = self.start.elapsed().as_secs_f64();
        self.print(&json!({
            "done": true,
            "frames": self.written,
            "skipped": self.skipped,
            "seconds": (secs * 1e3).round() / 1e3,
            "adapter": adapter,
        }))?;
        console::say(&self.summary(secs, adapter));
        Ok(())
    }

    fn summary(&self, secs: f64, adapter: Option<&str>) -> String {
        let files = match ((self.file)(self.frames.first), (self.file)(self.frames.last)) {
            (first, last) if first == last => first,
            (first, last) => format!("{first} to {last}"),
        };
        let Some(adapter) = adapter else {
            return format!("nothing to do: {files} exist already");
        };
        let frames = match self.written {
            1 => "1 frame".to_owned(),
            written => format!("{written} frames"),
        };
        let skipped = match self.skipped {
            0 => String::new(),
            skipped => format!(", {skipped} were there already"),
        };
        format!("wrote {files}: {frames} in {secs:.1} s{skipped}, on {adapter}")
    }

    fn print(&self, line: &serde_json::Value) -> anyhow::Result<()> {
        if self.json {
            self.bar.suspend(|| console::print(&line.to_string()))?;
        }
        Ok(())
    }
}

fn millis(time: Duration) -> f64 {
    (time.as_secs_f64() * 1e5).round() / 1e2
}
