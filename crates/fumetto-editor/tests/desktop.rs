//! The program itself, in a real window on a display that nobody sees.
#![cfg(target_os = "linux")]
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

use std::collections::BTreeSet;
use std::io::Read as _;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use x11rb::connection::Connection as _;
use x11rb::protocol::xproto::{ConnectionExt as _, ImageFormat};

/// The slowest processor shows a picture by then.
const PATIENCE: Duration = Duration::from_secs(90);

const SIZE: [u16; 2] = [1280, 800];

/// Ends the program that it holds, however the test ends.
struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// A display of its own, and what it is called.
fn display() -> (Running, String) {
    let mut server = Command::new("Xvfb")
        .args(["-displayfd", "1", "-screen", "0", "1280x800x24", "-nolisten", "tcp"])
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("Xvfb is installed: `scripts/setup.sh --tests` sees to it");
    let mut output = server.stdout.take().unwrap();
    let server = Running(server);
    let mut number = String::new();
    while !number.ends_with('\n') {
        let mut byte = [0];
        output.read_exact(&mut byte).expect("Xvfb tells its number");
        number.push(byte[0].into());
    }
    (server, format!(":{}", number.trim()))
}

/// The different colours on the display.
fn colours(display: &str) -> BTreeSet<[u8; 3]> {
    let (connection, screen) = x11rb::connect(Some(display)).unwrap();
    let root = connection.setup().roots[screen].root;
    let image = connection
        .get_image(ImageFormat::Z_PIXMAP, root, 0, 0, SIZE[0], SIZE[1], u32::MAX)
        .unwrap()
        .reply()
        .unwrap();
    image.data.chunks_exact(4).map(|pixel| [pixel[2], pixel[1], pixel[0]]).collect()
}

#[test]
fn a_window_shows_the_scene_that_was_named() {
    let (_server, display) = display();
    let home = tempfile::tempdir().unwrap();
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/cumulus.toml");
    let editor = Command::new(env!("CARGO_BIN_EXE_fumetto-editor"))
        .arg(scene)
        .env("DISPLAY", &display)
        .env_remove("WAYLAND_DISPLAY")
        .env("XDG_DATA_HOME", home.path())
        .spawn()
        .unwrap();
    let mut editor = Running(editor);
    // The cloud's brightest tone, which nothing else in the window has.
    let tone = [0xfb, 0xf8, 0xee];
    let start = Instant::now();
    loop {
        assert!(editor.0.try_wait().unwrap().is_none(), "the editor ended");
        let seen = colours(&display);
        if seen.contains(&tone) {
            break;
        }
        assert!(start.elapsed() < PATIENCE, "no cloud among {} colours", seen.len());
        sleep(Duration::from_millis(200));
    }
}

#[test]
fn a_scene_that_cannot_be_read_is_told_without_a_window() {
    let home = tempfile::tempdir().unwrap();
    let scene = home.path().join("gone.toml");
    let ended = Command::new(env!("CARGO_BIN_EXE_fumetto-editor")).arg(&scene).output().unwrap();
    let said = String::from_utf8(ended.stderr).unwrap();
    assert!(!ended.status.success());
    assert!(said.contains(&format!("cannot open {}", scene.display())), "{said}");
    assert!(said.contains("No such file") && !said.contains("window"), "{said}");
}
