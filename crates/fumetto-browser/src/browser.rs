use std::{
    env, fs,
    path::PathBuf,
    thread,
    time::{Duration, Instant},
};

use base64::{Engine as _, prelude::BASE64_STANDARD};
use serde_json::{Value, json};

use crate::{BrowserError, connection::Connection};

/// Time between two looks at whether something has come about.
const GLANCE: Duration = Duration::from_millis(50);

/// A browser with one page open.
pub struct Browser {
    connection: Connection,
    session: String,
    complaints: Vec<String>,
    chooser: Option<Value>,
}

impl Browser {
    /// Starts a browser whose page is `size` pixels wide and high, and opens the page at `url`.
    ///
    /// # Errors
    /// When there is no browser, or it fails.
    pub fn open(url: &str, size: [u32; 2]) -> Result<Self, BrowserError> {
        let mut connection = Connection::open(size)?;
        let target = connection.call(None, "Target.createTarget", &json!({ "url": "about:blank" }))?;
        let attach = json!({ "targetId": target["targetId"], "flatten": true });
        let attached = connection.call(None, "Target.attachToTarget", &attach)?;
        let session = attached["sessionId"].as_str().unwrap_or_default().to_owned();
        let mut browser = Self { connection, session, complaints: Vec::new(), chooser: None };
        for domain in ["Runtime.enable", "Page.enable", "Log.enable", "DOM.enable"] {
            browser.call(domain, &json!({}))?;
        }
        let [width, height] = size;
        browser.call(
            "Emulation.setDeviceMetricsOverride",
            &json!({ "width": width, "height": height, "deviceScaleFactor": 1, "mobile": false }),
        )?;
        browser.call("Page.setInterceptFileChooserDialog", &json!({ "enabled": true }))?;
        let folder = browser.downloads();
        fs::create_dir_all(&folder)?;
        let downloads = json!({ "behavior": "allow", "downloadPath": folder });
        browser.connection.call(None, "Browser.setDownloadBehavior", &downloads)?;
        browser.go_to(url)?;
        Ok(browser)
    }

    /// As [`open`](Self::open), but without a browser it says that `test` is skipped; unless
    /// `FUMETTO_BROWSER_REQUIRED=1` forbids that.
    ///
    /// # Errors
    /// When there is no browser though there has to be one, or it fails.
    pub fn open_for(test: &str, url: &str, size: [u32; 2]) -> Result<Option<Self>, BrowserError> {
        match Self::open(url, size) {
            Err(BrowserError::Missing) if env::var_os("FUMETTO_BROWSER_REQUIRED").is_none() => {
                eprintln!("{test} is skipped: {}", BrowserError::Missing);
                Ok(None)
            }
            opened => opened.map(Some),
        }
    }

    pub(crate) fn call(&mut self, method: &str, params: &Value) -> Result<Value, BrowserError> {
        self.connection.call(Some(&self.session), method, params)
    }

    /// Opens the page at `url`.
    ///
    /// # Errors
    /// When the browser fails.
    pub fn go_to(&mut self, url: &str) -> Result<(), BrowserError> {
        self.call("Page.navigate", &json!({ "url": url })).map(|_| ())
    }

    /// Loads the page again.
    ///
    /// # Errors
    /// When the browser fails.
    pub fn reload(&mut self) -> Result<(), BrowserError> {
        self.call("Page.reload", &json!({})).map(|_| ())
    }

    /// Runs a script on every page that is opened from now on, before the page's own.
    ///
    /// # Errors
    /// When the browser fails.
    pub fn begin_pages_with(&mut self, script: &str) -> Result<(), BrowserError> {
        self.call("Page.addScriptToEvaluateOnNewDocument", &json!({ "source": script })).map(|_| ())
    }

    /// What a script gives; a promise is waited for.
    ///
    /// # Errors
    /// When the script throws, or the browser fails.
    pub fn evaluate(&mut self, script: &str) -> Result<Value, BrowserError> {
        let params = json!({ "expression": script, "awaitPromise": true, "returnByValue": true });
        let mut answer = self.call("Runtime.evaluate", &params)?;
        match answer.get("exceptionDetails") {
            Some(thrown) => Err(BrowserError::Threw(thrown_text(thrown))),
            None => Ok(answer["result"]["value"].take()),
        }
    }

    /// Waits until a script gives what is `wanted`, and answers with it. Where the page is just being loaded,
    /// scripts may throw.
    ///
    /// # Errors
    /// When it has not come about after `patience`, or the browser fails.
    pub fn wait_for(
        &mut self,
        script: &str,
        wanted: impl Fn(&Value) -> bool,
        patience: Duration,
    ) -> Result<Value, BrowserError> {
        let deadline = Instant::now() + patience;
        let mut last = Value::Null;
        while Instant::now() < deadline {
            match self.evaluate(script) {
                Ok(value) if wanted(&value) => return Ok(value),
                Ok(value) => last = value,
                Err(BrowserError::Threw(_) | BrowserError::Refused { .. }) => {}
                Err(error) => return Err(error),
            }
            thread::sleep(GLANCE);
        }
        Err(BrowserError::TooLate { what: format!("`{script}`, which is {last}"), secs: patience.as_secs() })
    }

    /// What the page shows, as a PNG.
    ///
    /// # Errors
    /// When the browser fails.
    pub fn screenshot(&mut self) -> Result<Vec<u8>, BrowserError> {
        let answer = self.call("Page.captureScreenshot", &json!({ "format": "png" }))?;
        let text = answer["data"].as_str().unwrap_or_default();
        BASE64_STANDARD.decode(text).map_err(|error| BrowserError::Threw(error.to_string()))
    }

    /// The next file that the page hands to the user, with its name; it is taken away from the folder of downloads.
    ///
    /// # Errors
    /// When none has come after `patience`, or it cannot be read.
    pub fn download(&mut self, patience: Duration) -> Result<(String, Vec<u8>), BrowserError> {
        let deadline = Instant::now() + patience;
        while Instant::now() < deadline {
            for entry in fs::read_dir(self.downloads())? {
                let path = entry?.path();
                let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
                // While it is on its way, it is called otherwise.
                if !name.ends_with(".crdownload") && !name.starts_with('.') {
                    let bytes = fs::read(&path)?;
                    fs::remove_file(&path)?;
                    return Ok((name, bytes));
                }
            }
            thread::sleep(GLANCE);
        }
        Err(BrowserError::TooLate { what: "a download".to_owned(), secs: patience.as_secs() })
    }

    fn downloads(&self) -> PathBuf {
        self.connection.folder().join("downloads")
    }

    /// Chooses a file with the name and contents in the dialog that the page has opened.
    ///
    /// # Errors
    /// When no dialog has opened after `patience`, or the browser fails.
    pub fn choose(&mut self, name: &str, contents: &[u8], patience: Duration) -> Result<(), BrowserError> {
        let path = self.connection.folder().join(name);
        fs::write(&path, contents)?;
        let deadline = Instant::now() + patience;
        while self.chooser.is_none() && self.hear(deadline)? {}
        let Some(node) = self.chooser.take() else {
            return Err(BrowserError::TooLate {
                what: "a dialog for files".to_owned(),
                secs: patience.as_secs(),
            });
        };
        let files = json!({ "files": [path], "backendNodeId": node });
        self.call("DOM.setFileInputFiles", &files).map(|_| ())
    }

    /// Errors and warnings that the page has written since this was last asked.
    ///
    /// # Errors
    /// When the browser fails.
    pub fn complaints(&mut self) -> Result<Vec<String>, BrowserError> {
        // An answer comes after all that was told before it.
        self.evaluate("0")?;
        while self.hear(Instant::now())? {}
        Ok(std::mem::take(&mut self.complaints))
    }

    /// Takes in one thing that the browser tells; whether there was any until `deadline`.
    fn hear(&mut self, deadline: Instant) -> Result<bool, BrowserError> {
        let Some(event) = self.connection.event(deadline)? else { return Ok(false) };
        let params = &event["params"];
        match event["method"].as_str().unwrap_or_default() {
            "Runtime.exceptionThrown" => self.complaints.push(thrown_text(&params["exceptionDetails"])),
            "Runtime.consoleAPICalled"
                if matches!(params["type"].as_str(), Some("error" | "warning" | "assert")) =>
            {
                let words = params["args"].as_array().into_iter().flatten();
                let words = words.map(|word| {
                    word["value"].as_str().map_or_else(|| word["description"].to_string(), str::to_owned)
                });
                self.complaints.push(words.collect::<Vec<_>>().join(" "));
            }
            "Log.entryAdded" if matches!(params["entry"]["level"].as_str(), Some("error" | "warning")) => {
                self.complaints.push(params["entry"]["text"].as_str().unwrap_or_default().to_owned());
            }
            "Page.fileChooserOpened" => self.chooser = Some(params["backendNodeId"].clone()),
            _ => {}
        }
        Ok(true)
    }
}

/// What an exception says, with where it came from.
fn thrown_text(details: &Value) -> String {
    let described = details["exception"]["description"].as_str();
    described.or(details["text"].as_str()).unwrap_or("something").to_owned()
}
