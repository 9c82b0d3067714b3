//! A headless Chromium, driven through its pipe: messages of the `DevTools` protocol, each ended by a zero byte.

use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use anyhow::{Context as _, Result, bail};
use serde_json::{Value, json};
use tempfile::TempDir;

/// The program, as Debian calls it.
const PROGRAM: &str = "chromium";

/// The pipe is read from file 3 and written to file 4. Without the other switches it looks for hosts on the network.
const SWITCHES: &str = "--headless=new --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-sync \
    --disable-background-networking --disable-component-update --disable-dev-shm-usage --remote-debugging-pipe";

/// How long an answer may take.
const PATIENCE: Duration = Duration::from_mins(2);

/// A browser with one page, as wide as on a small phone.
pub(super) struct Browser {
    child: Child,
    commands: ChildStdin,
    messages: Receiver<Value>,
    session: Option<String>,
    sent: u64,
    /// Errors of the page's scripts and its console.
    pub(super) errors: Vec<String>,
    _profile: TempDir,
}

/// Whether the browser is here.
pub(super) fn is_here() -> bool {
    let version = Command::new(PROGRAM).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    version.is_ok_and(|status| status.success())
}

impl Browser {
    pub(super) fn start() -> Result<Self> {
        let profile = tempfile::tempdir()?;
        let line = format!(
            "exec {PROGRAM} {SWITCHES} --user-data-dir=\"$0\" about:blank 3<&0 4>&1 < /dev/null > /dev/null 2>&1"
        );
        let mut child = Command::new("sh")
            .args(["-c", &line])
            .arg(profile.path())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .context("sh cannot be started")?;
        let commands = child.stdin.take().context("the browser has no pipe to write to")?;
        let mut answers = BufReader::new(child.stdout.take().context("the browser has no pipe to read from")?);
        let (sender, messages) = channel();
        std::thread::spawn(move || {
            let mut bytes = Vec::new();
            while answers.read_until(0, &mut bytes).is_ok_and(|count| count > 0) {
                let message = serde_json::from_slice(bytes.strip_suffix(&[0]).unwrap_or(&bytes));
                if message.is_ok_and(|message| sender.send(message).is_err()) {
                    return;
                }
                bytes.clear();
            }
        });
        let (session, errors) = (None, Vec::new());
        let mut browser = Self { child, commands, messages, session, sent: 0, errors, _profile: profile };
        let target = browser.call("Target.createTarget", &json!({ "url": "about:blank" }))?;
        let attached =
            browser.call("Target.attachToTarget", &json!({ "targetId": target["targetId"], "flatten": true }))?;
        browser.session = attached["sessionId"].as_str().map(String::from);
        for domain in ["Page", "Runtime", "Log"] {
            browser.call(&format!("{domain}.enable"), &json!({}))?;
        }
        let phone = json!({ "width": 360, "height": 740, "deviceScaleFactor": 2, "mobile": true });
        browser.call("Emulation.setDeviceMetricsOverride", &phone)?;
        Ok(browser)
    }

    /// Opens a page from its file, and waits until it is loaded.
    pub(super) fn open(&mut self, page: &Path) -> Result<()> {
        let answer = self.call("Page.navigate", &json!({ "url": format!("file://{}", page.display()) }))?;
        if let Some(error) = answer["errorText"].as_str() {
            bail!("{} cannot be opened: {error}", page.display());
        }
        let until = Instant::now() + PATIENCE;
        while self.next(until)?["method"] != "Page.loadEventFired" {}
        Ok(())
    }

    /// The value of an expression, a promise being awaited.
    pub(super) fn evaluate(&mut self, expression: &str) -> Result<Value> {
        let asked = json!({ "expression": expression, "awaitPromise": true, "returnByValue": true });
        let mut answer = self.call("Runtime.evaluate", &asked)?;
        if let Some(thrown) = answer.get("exceptionDetails") {
            bail!("the page threw {}", said(thrown));
        }
        Ok(answer["result"]["value"].take())
    }

    fn call(&mut self, method: &str, parameters: &Value) -> Result<Value> {
        self.sent += 1;
        let id = self.sent;
        let mut message = json!({ "id": id, "method": method, "params": parameters });
        if let Some(session) = &self.session {
            message["sessionId"] = session.as_str().into();
        }
        write!(self.commands, "{message}\0").and_then(|()| self.commands.flush()).context("the browser has ended")?;
        let until = Instant::now() + PATIENCE;
        loop {
            let mut answer = self.next(until)?;
            if answer["id"] == id {
                if let Some(error) = answer.get("error") {
                    bail!("{method}: {error}");
                }
                return Ok(answer["result"].take());
            }
        }
    }

    /// The next message; errors of the page are noted.
    fn next(&mut self, until: Instant) -> Result<Value> {
        let left = until.saturating_duration_since(Instant::now());
        let message = self.messages.recv_timeout(left).context("the browser does not answer")?;
        let parameters = &message["params"];
        match message["method"].as_str() {
            Some("Runtime.exceptionThrown") => self.errors.push(said(&parameters["exceptionDetails"])),
            Some("Runtime.consoleAPICalled") if parameters["type"] == "error" => {
                self.errors.push(parameters["args"].to_string());
            }
            Some("Log.entryAdded") if parameters["entry"]["level"] == "error" => {
                self.errors.push(format!("{} {}", parameters["entry"]["text"], parameters["entry"]["url"]));
            }
            _ => {}
        }
        Ok(message)
    }
}

/// What an exception says.
fn said(details: &Value) -> String {
    let described = details["exception"]["description"].as_str().or(details["text"].as_str());
    described.map_or_else(|| details.to_string(), String::from)
}

impl Drop for Browser {
    fn drop(&mut self) {
        let _ = self.call("Browser.close", &json!({}));
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
