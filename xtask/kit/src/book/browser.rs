//! A headless Chromium, controlled through a pipe: messages of the `DevTools` protocol, each terminated by a zero byte.

use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use anyhow::{Context as _, Result, bail, ensure};
use serde_json::{Value, json};
use tempfile::TempDir;

/// The program, with its name in Debian.
const PROGRAM: &str = "chromium";

/// The pipe is read from file descriptor 3 and written to 4. Without the other switches the browser would access the network.
const SWITCHES: &str = "--headless=new --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-sync \
    --disable-background-networking --disable-component-update --disable-dev-shm-usage --remote-debugging-pipe";

/// The time limit for an answer.
const PATIENCE: Duration = Duration::from_mins(4);

/// The size of a screen.
#[derive(Clone, Copy, Debug)]
pub(super) struct Screen {
    width: u32,
    height: u32,
    mobile: bool,
}

/// A small phone.
pub(super) const PHONE: Screen = Screen { width: 360, height: 740, mobile: true };

/// A desktop screen.
pub(super) const DESK: Screen = Screen { width: 1280, height: 900, mobile: false };

/// A sheet of A4 between margins of 10 mm, at 96 pixels an inch.
pub(super) const SHEET: Screen = Screen { width: 718, height: 1047, mobile: false };

/// A browser with one page, with the width of a small phone.
pub(super) struct Browser {
    child: Child,
    commands: ChildStdin,
    messages: Receiver<Value>,
    session: Option<String>,
    sent: u64,
    /// Errors of the page's scripts, and its console output.
    pub(super) errors: Vec<String>,
    _profile: TempDir,
}

/// If this is set, a browser must be available.
const REQUIRED: &str = "JOINTPROOF_REQUIRE_CHROMIUM";

/// Whether the browser is available.
///
/// # Errors
/// If it is required but not available.
pub(super) fn is_here_or_not_required() -> Result<bool> {
    let is_here = is_here();
    ensure!(is_here || std::env::var_os(REQUIRED).is_none(), "{REQUIRED} is set, but {PROGRAM} is not found");
    Ok(is_here)
}

fn is_here() -> bool {
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
        let answers = BufReader::new(child.stdout.take().context("the browser has no pipe to read from")?);
        let (sender, messages) = channel();
        std::thread::spawn(move || {
            for bytes in answers.split(0).map_while(Result::ok) {
                if serde_json::from_slice(&bytes).is_ok_and(|message| sender.send(message).is_err()) {
                    return;
                }
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
        // The print page opens a dialogue, which nobody would answer here.
        let unasked = json!({ "source": "window.print = () => {};" });
        browser.call("Page.addScriptToEvaluateOnNewDocument", &unasked)?;
        browser.screen(PHONE)?;
        Ok(browser)
    }

    /// Sets the size of the screen.
    pub(super) fn screen(&mut self, screen: Screen) -> Result<()> {
        let Screen { width, height, mobile } = screen;
        let metrics = json!({ "width": width, "height": height, "deviceScaleFactor": if mobile { 2 } else { 1 }, "mobile": mobile });
        self.call("Emulation.setDeviceMetricsOverride", &metrics).map(drop)
    }

    /// Sets the reader's preferences for pages opened from now on: dark colours, and reduced motion.
    pub(super) fn prefer(&mut self, dark: bool, still: bool) -> Result<()> {
        let feature = |name: &str, value: &str| json!({ "name": name, "value": value });
        let scheme = feature("prefers-color-scheme", if dark { "dark" } else { "light" });
        let motion = feature("prefers-reduced-motion", if still { "reduce" } else { "no-preference" });
        self.call("Emulation.setEmulatedMedia", &json!({ "media": "", "features": [scheme, motion] })).map(drop)
    }

    /// Shows the page as it is printed, until preferences are set again.
    pub(super) fn print(&mut self) -> Result<()> {
        self.screen(SHEET)?;
        self.call("Emulation.setEmulatedMedia", &json!({ "media": "print" })).map(drop)
    }

    /// A screenshot, as PNG.
    pub(super) fn screenshot(&mut self) -> Result<Vec<u8>> {
        let answer = self.call("Page.captureScreenshot", &json!({ "format": "png" }))?;
        base64(answer["data"].as_str().unwrap_or_default()).context("the browser sends another picture than PNG")
    }

    /// Presses the tab key.
    pub(super) fn press_tab(&mut self) -> Result<()> {
        for way in ["keyDown", "keyUp"] {
            self.call("Input.dispatchKeyEvent", &json!({ "type": way, "key": "Tab", "windowsVirtualKeyCode": 9 }))?;
        }
        Ok(())
    }

    /// Opens a page from its file, and waits until it is loaded.
    pub(super) fn open(&mut self, page: &Path) -> Result<()> {
        // Navigating within the same page would not load anything.
        self.load("about:blank")?;
        self.load(&format!("file://{}", page.display()))
    }

    fn load(&mut self, url: &str) -> Result<()> {
        let answer = self.call("Page.navigate", &json!({ "url": url }))?;
        if let Some(error) = answer["errorText"].as_str() {
            bail!("{url} cannot be opened: {error}");
        }
        let until = Instant::now() + PATIENCE;
        while self.next(until)?["method"] != "Page.loadEventFired" {}
        Ok(())
    }

    /// The value of an expression; promises are awaited.
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

    /// The next message; errors of the page are recorded.
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

/// Decodes base 64.
fn base64(text: &str) -> Option<Vec<u8>> {
    let digit = |c: u8| match c {
        b'A'..=b'Z' => Some(c - b'A'),
        b'a'..=b'z' => Some(c - b'a' + 26),
        b'0'..=b'9' => Some(c - b'0' + 52),
        b'+' => Some(62),
        b'/' => Some(63),
        _ => None,
    };
    let mut bytes = Vec::new();
    let (mut held, mut bits) = (0_u32, 0);
    for c in text.bytes().filter(|c| *c != b'=') {
        held = held << 6 | u32::from(digit(c)?);
        bits += 6;
        if bits >= 8 {
            bits -= 8;
            bytes.push((held >> bits & 0xff) as u8);
        }
    }
    Some(bytes)
}

/// The text of an exception.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_comes_in_base_64() {
        let cases: [(&str, &[u8]); 4] = [
            ("", b""),
            ("U2xvdA==", b"Slot"),
            ("VUpPSU5U", b"UJOINT"),
            ("AP+/zK/6yvc=", &[0, 255, 191, 204, 175, 250, 202, 247]),
        ];
        for (text, bytes) in cases {
            assert_eq!(base64(text).as_deref(), Some(bytes), "{text}");
        }
        assert_eq!(base64("no~"), None);
    }

    #[test]
    fn the_browser_is_here_if_it_is_in_the_search_path() {
        let path = std::env::var_os("PATH").unwrap_or_default();
        let is_there = std::env::split_paths(&path).any(|folder| folder.join(PROGRAM).is_file());
        assert_eq!(is_here(), is_there);
    }

    #[test]
    fn errors_of_a_page_are_noted_and_nothing_else() {
        if !is_here_or_not_required().unwrap() {
            return;
        }
        let folder = tempfile::tempdir().unwrap();
        let page = folder.path().join("page.html");
        let text = "<!DOCTYPE html><meta name=viewport content=\"width=device-width\"><script>console.log('fine'); console.error('bad')</script><img src=\"none.png\">
            <script>console.warn('fine'); throw new Error('thrown');</script>";
        std::fs::write(&page, text).unwrap();
        let mut browser = Browser::start().unwrap();
        browser.open(&page).unwrap();
        assert_eq!(browser.evaluate("Promise.resolve(innerWidth)").unwrap(), PHONE.width);
        let found = |part: &str| browser.errors.iter().filter(|error| error.contains(part)).count();
        assert_eq!((found("\"bad\""), found("Error: thrown\n"), found("none.png")), (1, 1, 1), "{:?}", browser.errors);
        assert_eq!(browser.errors.len(), 3, "{:?}", browser.errors);
        let error = browser.evaluate("(() => { throw new Error('asked for') })()").unwrap_err().to_string();
        assert!(error.starts_with("the page threw Error: asked for"), "{error}");
        assert!(browser.open(&folder.path().join("no.html")).unwrap_err().to_string().contains("cannot be opened"));
    }
}
