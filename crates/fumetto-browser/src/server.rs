//! Hands a folder's files to a browser on this machine.

use std::{
    fs,
    io::{self, BufRead as _, BufReader, Write as _},
    net::{Ipv4Addr, SocketAddr, TcpListener, TcpStream},
    path::{Component, Path, PathBuf},
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
    thread,
};

/// A folder that is served.
#[derive(Debug)]
pub struct Server {
    address: SocketAddr,
    is_gone: Arc<AtomicBool>,
}

impl Server {
    /// Serves `folder` at a free port of this machine.
    ///
    /// # Errors
    /// When there is none.
    pub fn new(folder: impl Into<PathBuf>) -> io::Result<Self> {
        let folder = folder.into();
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0))?;
        let address = listener.local_addr()?;
        let is_gone = Arc::new(AtomicBool::new(false));
        let told = Arc::clone(&is_gone);
        thread::Builder::new().name("server".to_owned()).spawn(move || {
            for stream in listener.incoming().flatten().filter(|_| !told.load(Ordering::Relaxed)) {
                let folder = folder.clone();
                // A browser opens more connections than it uses, so none may be waited for.
                let answerer = thread::Builder::new().name("server's answer".to_owned());
                answerer.spawn(move || answer(&stream, &folder).ok()).ok();
            }
        })?;
        Ok(Self { address, is_gone })
    }

    /// Hangs up on everybody from now on, as if there were no network.
    pub fn go(&self) {
        self.is_gone.store(true, Ordering::Relaxed);
    }

    /// Address of the file at `path`, which begins without a slash.
    #[must_use]
    pub fn url(&self, path: &str) -> String {
        format!("http://{}/{path}", self.address)
    }
}

/// Answers one request and hangs up.
fn answer(mut stream: &TcpStream, folder: &Path) -> io::Result<()> {
    let mut lines = BufReader::new(stream).lines();
    let request = lines.next().transpose()?.unwrap_or_default();
    // A browser expects its headers to be read.
    for line in lines {
        if line?.is_empty() {
            break;
        }
    }
    let path = request.split(' ').nth(1).unwrap_or("/");
    let path = path.split(['?', '#']).next().unwrap_or("/").trim_start_matches('/');
    let path = Path::new(if path.is_empty() { "index.html" } else { path });
    let is_inside = path.components().all(|part| matches!(part, Component::Normal(_)));
    let found = if is_inside { fs::read(folder.join(path)).ok() } else { None };
    let (status, body) = match found {
        Some(body) => ("200 OK", body),
        None => ("404 Not Found", b"there is no such file".to_vec()),
    };
    let (kind, length) = (media_type(path), body.len());
    write!(
        stream,
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {length}\r\nConnection: close\r\n\r\n"
    )?;
    stream.write_all(&body)
}

fn media_type(path: &Path) -> &'static str {
    match path.extension().and_then(|extension| extension.to_str()) {
        Some("html") => "text/html; charset=utf-8",
        Some("css") => "text/css",
        Some("js") => "text/javascript",
        Some("json" | "webmanifest") => "application/json",
        Some("svg") => "image/svg+xml",
        Some("png") => "image/png",
        Some("wasm") => "application/wasm",
        _ => "application/octet-stream",
    }
}
