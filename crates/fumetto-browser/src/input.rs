//! Mouse and keys.

use serde_json::json;

use crate::{Browser, BrowserError};

/// Places between the ends of a drag.
const STEPS: u32 = 8;

impl Browser {
    /// Clicks at a place of the page, in pixels from the top left.
    ///
    /// # Errors
    /// When the browser fails.
    pub fn click(&mut self, place: [f64; 2]) -> Result<(), BrowserError> {
        self.drag(place, place)
    }

    /// Presses the left button at `from`, moves to `to`, and lets go.
    ///
    /// # Errors
    /// When the browser fails.
    pub fn drag(&mut self, from: [f64; 2], to: [f64; 2]) -> Result<(), BrowserError> {
        self.mouse("mouseMoved", from, false)?;
        self.mouse("mousePressed", from, true)?;
        for step in 1..=STEPS {
            let share = f64::from(step) / f64::from(STEPS);
            self.mouse("mouseMoved", [0, 1].map(|axis| from[axis] + share * (to[axis] - from[axis])), true)?;
        }
        self.mouse("mouseReleased", to, false)
    }

    fn mouse(&mut self, kind: &str, [x, y]: [f64; 2], is_down: bool) -> Result<(), BrowserError> {
        let button = if kind == "mouseMoved" && !is_down { "none" } else { "left" };
        let event = json!({
            "type": kind, "x": x, "y": y, "button": button, "buttons": u32::from(is_down), "clickCount": 1,
        });
        self.call("Input.dispatchMouseEvent", &event).map(|_| ())
    }

    /// Turns the wheel at a place, by pixels; down is positive.
    ///
    /// # Errors
    /// When the browser fails.
    pub fn scroll(&mut self, [x, y]: [f64; 2], by: f64) -> Result<(), BrowserError> {
        let event = json!({ "type": "mouseWheel", "x": x, "y": y, "deltaX": 0, "deltaY": by });
        self.call("Input.dispatchMouseEvent", &event).map(|_| ())
    }

    /// Presses a key and lets go, as `KeyboardEvent.key` names it, while Ctrl and Shift are held where wanted.
    ///
    /// # Errors
    /// When the browser fails.
    pub fn press(&mut self, key: &str, ctrl: bool, shift: bool) -> Result<(), BrowserError> {
        let letter = key.chars().next().filter(|letter| key.len() == 1 && letter.is_ascii_alphanumeric());
        let code = match letter {
            Some(digit) if digit.is_ascii_digit() => format!("Digit{digit}"),
            Some(letter) => format!("Key{}", letter.to_ascii_uppercase()),
            None => key.to_owned(),
        };
        let mut event = json!({ "type": "keyDown", "key": key, "code": code, "modifiers": 2 * u32::from(ctrl) + 8 * u32::from(shift) });
        if letter.is_some() && !ctrl {
            event["text"] = key.into();
        }
        self.call("Input.dispatchKeyEvent", &event)?;
        event["type"] = "keyUp".into();
        self.call("Input.dispatchKeyEvent", &event).map(|_| ())
    }

    /// Types a text.
    ///
    /// # Errors
    /// When the browser fails.
    pub fn write(&mut self, text: &str) -> Result<(), BrowserError> {
        self.call("Input.insertText", &json!({ "text": text })).map(|_| ())
    }
}
