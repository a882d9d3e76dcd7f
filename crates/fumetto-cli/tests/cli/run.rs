//! A folder with a small scene in it, and `fumetto` run there.

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

use fumetto_formats::{Image, read_png};
use tempfile::TempDir;

/// Smoke on twos that fills the picture's middle, small enough for a processor to draw.
pub(crate) const SMOKE: &str = r##"
format = 1
[camera]
eye = [0, 1, 5]
target = [0, 1, 0]
[[light]]
kind = "sun"
direction = [-0.4, -1, -0.3]
[background]
colour = "#f3ead8"
[time]
fps = 10
frames = [0, 5]
hold = 2
[output]
size = [64, 36]
antialias = 1
[style]
tones = ["#8fa3b8", "#c3cfda", "#f4f7f9"]
[[object]]
name = "smoke"
kind = "smoke"
[object.emitter]
shape = { disc = { center = [0, 0.3, 0], radius = 0.3 } }
bursts = [{ at = 0, count = 8 }]
rate = 20
velocity = [0, 1.5, 0]
radius = 0.5
"##;

/// What a run came to.
pub(crate) struct Ran {
    pub(crate) code: Option<i32>,
    pub(crate) out: String,
    pub(crate) err: String,
}

impl Ran {
    pub(crate) fn of(output: &Output) -> Self {
        let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
        let ran = Self { code: output.status.code(), out: text(&output.stdout), err: text(&output.stderr) };
        for bug in ["panicked", "RUST_BACKTRACE", "has a bug"] {
            assert!(!ran.err.contains(bug) && !ran.out.contains(bug), "{}", ran.err);
        }
        ran
    }

    /// Asserts that it ended with `code`.
    #[track_caller]
    pub(crate) fn ends(self, code: i32) -> Self {
        assert_eq!(self.code, Some(code), "stdout:\n{}\nstderr:\n{}", self.out, self.err);
        self
    }

    /// Asserts that standard error holds each of `parts`.
    #[track_caller]
    pub(crate) fn says(self, parts: &[&str]) -> Self {
        for part in parts {
            assert!(self.err.contains(part), "{part:?} is not in:\n{}", self.err);
        }
        self
    }
}

/// A folder that is gone after the test.
pub(crate) struct Folder(TempDir);

impl Folder {
    /// With [`SMOKE`] in `smoke.toml`.
    pub(crate) fn with_smoke() -> Self {
        let folder = Self(tempfile::tempdir().unwrap());
        folder.put("smoke.toml", SMOKE);
        folder
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub(crate) fn put(&self, name: &str, content: impl AsRef<[u8]>) {
        fs::write(self.path(name), content).unwrap();
    }

    pub(crate) fn bytes(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    pub(crate) fn png(&self, name: &str) -> Image {
        read_png(name, &self.bytes(name)).unwrap()
    }

    /// Every file but the scene, hidden ones too, sorted.
    pub(crate) fn files(&self) -> Vec<String> {
        let entries = fs::read_dir(self.0.path()).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.retain(|name| name != "smoke.toml");
        names.sort();
        names
    }

    /// `fumetto` with these arguments, in this folder.
    pub(crate) fn command(&self, args: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_fumetto"));
        command.args(args).current_dir(self.0.path()).stdin(Stdio::null()).env_remove("RUST_BACKTRACE");
        command
    }

    pub(crate) fn run(&self, args: &[&str]) -> Ran {
        Ran::of(&self.command(args).output().unwrap())
    }
}
