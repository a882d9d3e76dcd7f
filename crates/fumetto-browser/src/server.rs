//! Hands a page to a browser on this machine.

use std::{
    io::{self, BufRead as _, BufReader, Write as _},
    net::{Ipv4Addr, SocketAddr, TcpListener, TcpStream},
    thread,
};

/// A page that is served.
#[derive(Debug)]
pub struct Server {
    address: SocketAddr,
}

impl Server {
    /// Serves `page`, in HTML, at a free port of this machine.
    ///
    /// # Errors
    /// When there is none.
    pub fn new(page: &'static str) -> io::Result<Self> {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0))?;
        let address = listener.local_addr()?;
        thread::Builder::new().name("server".to_owned()).spawn(move || {
            for stream in listener.incoming().flatten() {
                // A browser opens more connections than it uses, so none may be waited for.
                let answerer = thread::Builder::new().name("server's answer".to_owned());
                answerer.spawn(move || answer(&stream, page).ok()).ok();
            }
        })?;
        Ok(Self { address })
    }

    /// Address of the page.
    #[must_use]
    pub fn url(&self) -> String {
        format!("http://{}/", self.address)
    }
}

/// Answers one request and hangs up.
fn answer(mut stream: &TcpStream, page: &str) -> io::Result<()> {
    // A browser expects its request to be read.
    for line in BufReader::new(stream).lines() {
        if line?.is_empty() {
            break;
        }
    }
    let length = page.len();
    write!(
        stream,
        "HTTP/1.1 200 OK\r\nContent-Type: text/html; charset=utf-8\r\nContent-Length: {length}\r\n\
         Connection: close\r\n\r\n{page}"
    )
}
