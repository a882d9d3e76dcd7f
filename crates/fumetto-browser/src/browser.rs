use std::{
    env, thread,
    time::{Duration, Instant},
};

use serde_json::{Value, json};

use crate::{BrowserError, connection::Connection};

/// Time between two looks at whether something has come about.
const GLANCE: Duration = Duration::from_millis(50);

/// A browser with one page open.
pub struct Browser {
    connection: Connection,
    session: String,
}

impl Browser {
    /// Starts a browser and opens the page at `url`. Where there is none, it says that `test` is skipped; unless
    /// `FUMETTO_BROWSER_REQUIRED` is set, which forbids that.
    ///
    /// # Errors
    /// When there is no browser though there has to be one, or it fails.
    pub fn open_for(test: &str, url: &str) -> Result<Option<Self>, BrowserError> {
        match Self::open(url) {
            Err(BrowserError::Missing) if env::var_os("FUMETTO_BROWSER_REQUIRED").is_none() => {
                eprintln!("{test} is skipped: {}", BrowserError::Missing);
                Ok(None)
            }
            opened => opened.map(Some),
        }
    }

    fn open(url: &str) -> Result<Self, BrowserError> {
        let mut connection = Connection::open()?;
        let target = connection.call(None, "Target.createTarget", &json!({ "url": "about:blank" }))?;
        let attach = json!({ "targetId": target["targetId"], "flatten": true });
        let attached = connection.call(None, "Target.attachToTarget", &attach)?;
        let session = attached["sessionId"].as_str().unwrap_or_default().to_owned();
        let mut browser = Self { connection, session };
        browser.call("Page.navigate", &json!({ "url": url }))?;
        Ok(browser)
    }

    fn call(&mut self, method: &str, params: &Value) -> Result<Value, BrowserError> {
        self.connection.call(Some(&self.session), method, params)
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
}

/// What an exception says, with where it came from.
fn thrown_text(details: &Value) -> String {
    let described = details["exception"]["description"].as_str();
    described.or(details["text"].as_str()).unwrap_or("something").to_owned()
}
