//! Paths as SVG writes them, short.
//!
//! Places are rounded first and then told relative to each other, so that what two paths share stays the same
//! to the last digit.

use kurbo::{BezPath, PathEl, Point};

/// Steps to a pixel that places are rounded to: at eight times the size, an eighth of a pixel would show.
const STEPS: f64 = 100.0;

/// A path as the `d` of an SVG `path`.
pub(super) fn path_data(path: &BezPath) -> String {
    let mut data = Data::default();
    for element in path.elements() {
        match *element {
            PathEl::MoveTo(to) => data.command('m', &[to]),
            PathEl::LineTo(to) => data.command('l', &[to]),
            PathEl::QuadTo(bend, to) => data.command('q', &[bend, to]),
            PathEl::CurveTo(first, second, to) => data.command('c', &[first, second, to]),
            PathEl::ClosePath => data.close(),
        }
    }
    data.text
}

#[derive(Default)]
struct Data {
    text: String,
    last: Option<char>,
    at: [i64; 2],
    start: [i64; 2],
}

impl Data {
    fn command(&mut self, letter: char, places: &[Point]) {
        let is_new = self.last != Some(letter) || letter == 'm';
        if is_new {
            self.text.push(letter);
        }
        for (index, place) in places.iter().enumerate() {
            let place = [place.x, place.y].map(|along| (along * STEPS).round() as i64);
            for (axis, (to, from)) in place.into_iter().zip(self.at).enumerate() {
                let is_first = is_new && index == 0 && axis == 0;
                self.number(to - from, is_first);
            }
            if index + 1 == places.len() {
                self.at = place;
            }
        }
        if letter == 'm' {
            self.start = self.at;
        }
        self.last = Some(letter);
    }

    fn close(&mut self) {
        self.text.push('z');
        self.at = self.start;
        self.last = None;
    }

    /// A number of hundredths; where it does not begin with a sign, something has to keep it apart.
    fn number(&mut self, steps: i64, is_first: bool) {
        if steps < 0 {
            self.text.push('-');
        } else if !is_first {
            self.text.push(' ');
        }
        let (whole, part) = (steps.unsigned_abs() / 100, steps.unsigned_abs() % 100);
        if whole > 0 || part == 0 {
            self.text.push_str(&whole.to_string());
        }
        if part > 0 {
            let digits = format!(".{part:02}");
            self.text.push_str(digits.trim_end_matches('0'));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_told_relative_to_each_other() {
        let mut path = BezPath::new();
        path.move_to((10.0, 20.5));
        path.line_to((10.25, 20.0));
        path.line_to((11.0, 20.004));
        path.curve_to((11.0, 21.0), (12.0, 22.0), (9.0, 20.0));
        path.close_path();
        path.move_to((-1.0, 0.0));
        assert_eq!(path_data(&path), "m10 20.5l.25-.5 .75 0c0 1 1 2-2 0zm-11-20.5");
    }
}
