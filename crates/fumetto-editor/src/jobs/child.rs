use std::io::{self, BufRead as _, BufReader, Read as _, Write as _};
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread;
use std::time::Duration;

use anyhow::Context as _;
use egui::Context;
use tempfile::TempDir;
use web_time::Instant;

use super::Order;
use crate::project::Project;

/// How far a job is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum State {
    Running,
    Done,
    Stopped,
    /// With what the program said.
    Failed(String),
}

/// A rendering or an export that is under way, or has ended.
pub(crate) struct Job {
    pub(crate) order: Order,
    pub(crate) state: State,
    /// Frames that are done.
    done: u32,
    start: Instant,
    /// None once it was waited for.
    child: Option<Child>,
    news: Receiver<News>,
    /// Holds the scene's files that are on no disk, as long as the job needs them.
    files: Option<TempDir>,
}

enum News {
    Frame,
    /// The program has ended; what it said besides.
    End(String),
}

impl Job {
    /// Hands the project as it is now to the `fumetto` program, which lies beside this one.
    pub(crate) fn start(order: Order, project: &Project, ctx: &Context) -> anyhow::Result<Self> {
        let (folder, files) = folder_for(project)?;
        let program = program()?;
        let mut child = Command::new(&program)
            .args(order.arguments())
            .current_dir(&folder)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .with_context(|| format!("cannot start {}", program.display()))?;
        let (sender, news) = channel();
        listen(&mut child, project.document().text().to_owned(), sender, ctx.clone())
            .context("cannot listen to the program that renders")?;
        let (state, child) = (State::Running, Some(child));
        Ok(Self { order, state, done: 0, start: Instant::now(), child, news, files })
    }

    /// Hears what has become of it.
    pub(crate) fn hear(&mut self) {
        while let Ok(news) = self.news.try_recv() {
            match news {
                News::Frame => self.done += 1,
                News::End(said) => {
                    let ended = self.child.take().and_then(|mut child| child.wait().ok());
                    let succeeded = ended.is_some_and(|status| status.success());
                    if self.state == State::Running {
                        self.state = if succeeded { State::Done } else { State::Failed(said) };
                    }
                }
            }
        }
    }

    /// Ends it; files that are whole stay.
    pub(crate) fn stop(&mut self) {
        if self.state == State::Running {
            self.state = State::Stopped;
            self.child.iter_mut().for_each(interrupt);
        }
    }

    /// From 0 to 1.
    pub(crate) fn share(&self) -> f32 {
        self.done as f32 / self.order.count() as f32
    }

    /// How long it still takes, going by the frames before.
    pub(crate) fn left(&self) -> Option<Duration> {
        let frames = self.order.count().saturating_sub(self.done);
        (self.done > 0).then(|| self.start.elapsed() / self.done * frames)
    }
}

impl Drop for Job {
    fn drop(&mut self) {
        self.stop();
        let (child, files) = (self.child.take(), self.files.take());
        if let Some(mut child) = child {
            // It tidies up first, and the window goes on. Without a thread nobody waits for it.
            let _ = thread::Builder::new().name("job.end".into()).spawn(move || {
                let _ = child.wait();
                drop(files);
            });
        }
    }
}

/// As Ctrl-C does: the program takes away what is half-written. It may have ended already.
#[cfg(unix)]
fn interrupt(child: &mut Child) {
    use rustix::process::{Pid, Signal, kill_process};
    let _ = kill_process(Pid::from_child(child), Signal::INT);
}

/// Files get their names when they are whole, so nothing half-written has one.
#[cfg(not(unix))]
fn interrupt(child: &mut Child) {
    let _ = child.kill();
}

/// The scene's own folder, or one with those of its files that are on no disk.
fn folder_for(project: &Project) -> anyhow::Result<(PathBuf, Option<TempDir>)> {
    if let Some(folder) = project.files.folder() {
        return Ok((folder.to_owned(), None));
    }
    let folder = tempfile::tempdir().context("cannot put the scene's files anywhere")?;
    for (name, bytes) in project.files.in_memory() {
        std::fs::write(folder.path().join(name), bytes).context("cannot put the scene's files anywhere")?;
    }
    Ok((folder.path().to_owned(), Some(folder)))
}

fn program() -> anyhow::Result<PathBuf> {
    let own = std::env::current_exe().context("cannot find out where the editor itself lies")?;
    let name = format!("fumetto{}", std::env::consts::EXE_SUFFIX);
    // Tests run from a folder below the one that programs are built into.
    let folders = own.ancestors().skip(1).take(2);
    folders.map(|folder| folder.join(&name)).find(|program| program.exists()).with_context(|| {
        format!(
            "the program that renders is not installed: there is no {}",
            own.with_file_name(&name).display()
        )
    })
}

/// Sends the scene and hears the program, each on a thread of its own: pipes that nobody empties stop a program.
fn listen(child: &mut Child, scene: String, sender: Sender<News>, ctx: Context) -> io::Result<()> {
    let (input, output, errors) = (child.stdin.take(), child.stdout.take(), child.stderr.take());
    let named = |name: &str| thread::Builder::new().name(name.into());
    named("job.scene").spawn(move || {
        if let Some(mut input) = input {
            // A program that has ended early says why itself.
            let _ = input.write_all(scene.as_bytes());
        }
    })?;
    let said = named("job.errors").spawn(move || {
        let mut said = String::new();
        if let Some(mut errors) = errors {
            let _ = errors.read_to_string(&mut said);
        }
        said
    })?;
    named("job.frames").spawn(move || {
        let lines = output.map(|output| BufReader::new(output).lines());
        for line in lines.into_iter().flatten().map_while(Result::ok) {
            if line.contains("\"frame\"") {
                let _ = sender.send(News::Frame);
                ctx.request_repaint();
            }
        }
        let said = said.join().unwrap_or_default();
        let _ = sender.send(News::End(said.trim().to_owned()));
        ctx.request_repaint();
    })?;
    Ok(())
}

#[cfg(all(test, target_os = "linux"))]
#[expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]
mod tests {
    use super::*;
    use crate::jobs::Work;

    #[test]
    fn a_stopped_job_is_waited_for_off_the_list_too() {
        let child = Command::new("sleep").arg("0.1").spawn().unwrap();
        let process = PathBuf::from(format!("/proc/{}", child.id()));
        let order = Order {
            work: Work::Picture,
            out: "/a.png".into(),
            frame: 0,
            frames: [0, 0],
            size: [1, 1],
            antialias: 1,
            layers: [false; 5],
            resume: false,
        };
        let (state, child, start) = (State::Running, Some(child), Instant::now());
        let (_, news) = channel();
        let mut job = Job { order, state, done: 0, start, child, news, files: None };
        job.stop();
        drop(job);
        while process.exists() {
            assert!(start.elapsed() < Duration::from_secs(20), "nobody waits for it");
            thread::sleep(Duration::from_millis(10));
        }
    }
}
