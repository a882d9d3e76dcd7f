//! The `DevTools` protocol: JSON with a zero byte after each message, over the browser's inherited files 3 and 4.

use std::{
    env,
    fs::{self, File},
    io::{self, BufRead as _, BufReader, Write as _},
    path::PathBuf,
    process::{Child, ChildStdin, ChildStdout, Command, Stdio},
    sync::mpsc::{self, Receiver, RecvTimeoutError},
    thread,
    time::{Duration, Instant},
};

use serde_json::{Value, json};
use tempfile::TempDir;

use crate::BrowserError;

/// Longest that one answer may take: `SwiftShader` compiles all pipelines within one.
const PATIENCE: Duration = Duration::from_secs(120);

/// Time for a browser that was asked to end, and between two looks at whether it has.
const FAREWELL: Duration = Duration::from_secs(10);
const GLANCE: Duration = Duration::from_millis(20);

/// Programs that are Chromium, in the order in which they are looked for; scripts/setup.sh asks for the same. The last
/// may be a script of Ubuntu's that only tells of a snap.
const NAMES: [&str; 4] = ["chromium", "google-chrome", "google-chrome-stable", "chromium-browser"];

/// `WebGPU` on the processor, and nothing that asks or updates.
const FLAGS: [&str; 9] = [
    "--headless=new",
    // Tests may run as root, and the page is our own.
    "--no-sandbox",
    "--remote-debugging-pipe",
    "--no-first-run",
    "--disable-background-networking",
    "--enable-unsafe-webgpu",
    "--use-webgpu-adapter=swiftshader",
    "--enable-features=Vulkan",
    "--use-vulkan=swiftshader",
];

/// A browser's process; it does not outlive this.
struct Process(Child);

/// A running browser.
pub(crate) struct Connection {
    process: Process,
    requests: ChildStdin,
    messages: Receiver<Value>,
    last_id: u64,
    // It leaves its folder alone once it has gone: this is dropped after the process.
    folder: TempDir,
}

impl Connection {
    /// Starts the browser.
    pub(crate) fn open() -> Result<Self, BrowserError> {
        let folder = tempfile::tempdir()?;
        // A shell brings standard input and output to where the browser expects them.
        let process = Command::new("sh")
            .args(["-c", r#"exec "$@" 3<&0 4>&1 1>&2"#, "sh"])
            .arg(program()?)
            .args(FLAGS)
            .arg(format!("--user-data-dir={}", folder.path().join("profile").display()))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(File::create(folder.path().join("log"))?)
            .spawn()?;
        let mut process = Process(process);
        let (Some(requests), Some(answers)) = (process.0.stdin.take(), process.0.stdout.take()) else {
            return Err(BrowserError::Missing);
        };
        let messages = listen(answers)?;
        Ok(Self { process, requests, messages, last_id: 0, folder })
    }

    /// Asks for `method` and waits for the answer.
    pub(crate) fn call(
        &mut self,
        session: Option<&str>,
        method: &str,
        params: &Value,
    ) -> Result<Value, BrowserError> {
        self.last_id += 1;
        let mut request = json!({ "id": self.last_id, "method": method, "params": params });
        if let Some(session) = session {
            request["sessionId"] = session.into();
        }
        let mut bytes = request.to_string().into_bytes();
        bytes.push(0);
        if self.requests.write_all(&bytes).and_then(|()| self.requests.flush()).is_err() {
            return Err(self.ended());
        }
        let deadline = Instant::now() + PATIENCE;
        loop {
            let Some(mut message) = self.next(deadline)? else {
                return Err(BrowserError::TooLate { what: method.to_owned(), secs: PATIENCE.as_secs() });
            };
            if message["id"] != self.last_id {
                // It tells of many things unasked.
                continue;
            }
            if let Some(error) = message["error"]["message"].as_str() {
                let message = error.to_owned();
                return Err(BrowserError::Refused { method: method.to_owned(), message });
            }
            return Ok(message["result"].take());
        }
    }

    fn next(&self, deadline: Instant) -> Result<Option<Value>, BrowserError> {
        match self.messages.recv_timeout(deadline.saturating_duration_since(Instant::now())) {
            Ok(message) => Ok(Some(message)),
            Err(RecvTimeoutError::Timeout) => Ok(None),
            Err(RecvTimeoutError::Disconnected) => Err(self.ended()),
        }
    }

    fn ended(&self) -> BrowserError {
        let log = fs::read_to_string(self.folder.path().join("log")).unwrap_or_default();
        let lines: Vec<&str> = log.lines().collect();
        BrowserError::Ended(lines[lines.len().saturating_sub(8)..].join("\n"))
    }
}

impl Drop for Connection {
    fn drop(&mut self) {
        if self.call(None, "Browser.close", &json!({})).is_err() {
            self.process.0.kill().ok();
        }
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        let deadline = Instant::now() + FAREWELL;
        while Instant::now() < deadline {
            if !matches!(self.0.try_wait(), Ok(None)) {
                return;
            }
            thread::sleep(GLANCE);
        }
        self.0.kill().ok();
        self.0.wait().ok();
    }
}

/// Hands over messages as they come, until there are no more.
fn listen(answers: ChildStdout) -> io::Result<Receiver<Value>> {
    let (tell, messages) = mpsc::channel();
    thread::Builder::new().name("browser's answers".to_owned()).spawn(move || {
        let split = BufReader::new(answers).split(0).map_while(Result::ok);
        for message in split.filter_map(|bytes| serde_json::from_slice(&bytes).ok()) {
            if tell.send(message).is_err() {
                return;
            }
        }
    })?;
    Ok(messages)
}

/// The browser's program.
fn program() -> Result<PathBuf, BrowserError> {
    if let Some(named) = env::var_os("FUMETTO_CHROMIUM") {
        return Ok(named.into());
    }
    let folders: Vec<PathBuf> =
        env::var_os("PATH").map(|path| env::split_paths(&path).collect()).unwrap_or_default();
    let mac = "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome";
    let on_path = NAMES.iter().flat_map(|name| folders.iter().map(move |folder| folder.join(name)));
    on_path.chain([mac.into()]).find(|program| program.is_file()).ok_or(BrowserError::Missing)
}
