use super::At;
use crate::file::{ColourFile, CurveFile, RangeFile};
use crate::limits::{Limit, MIN_DIRECTION, SHARE};
use crate::{Colour, Curve};

const BLACK: Colour = Colour { linear: [0.0; 3] };

pub(super) fn colour(at: &At<'_>, file: &ColourFile) -> Colour {
    match file {
        ColourFile::Hex(text) => hex_colour(at, text),
        ColourFile::Linear(linear) => Colour { linear: *linear },
    }
}

pub(super) fn hex_colour(at: &At<'_>, text: &str) -> Colour {
    let digits = text
        .strip_prefix('#')
        .filter(|digits| digits.len() == 6 && digits.bytes().all(|digit| digit.is_ascii_hexdigit()));
    let Some(packed) = digits.and_then(|digits| u32::from_str_radix(digits, 16).ok()) else {
        let message = format!("{text:?} is not a colour");
        at.error("bad-colour", message, "write a `#` and six hexadecimal digits, as in \"#c8d4e0\"");
        return BLACK;
    };
    let [_, red, green, blue] = packed.to_be_bytes();
    Colour::from_srgb8([red, green, blue])
}

/// Least and most, both inside `limit`.
pub(super) fn range(at: &At<'_>, file: RangeFile, limit: &Limit, help: &str) -> [f32; 2] {
    match file {
        RangeFile::One(value) => {
            at.within(value, limit, help);
            [value, value]
        }
        RangeFile::Range([least, most]) => {
            at.item(0).within(least, limit, help);
            at.item(1).within(most, limit, help);
            if least > most {
                let message = format!("`{}` runs from {least} down to {most}", at.name());
                at.error(
                    "falling-range",
                    message,
                    format!("write the smaller number first: [{most}, {least}]"),
                );
            }
            [least, most]
        }
    }
}

/// A curve whose values are inside `limit`.
pub(super) fn curve(at: &At<'_>, file: &CurveFile, limit: &Limit, help: &str) -> Curve {
    let points = match file {
        CurveFile::One(value) => {
            at.within(*value, limit, help);
            return Curve::constant(*value);
        }
        CurveFile::Points(points) => points.clone(),
    };
    if points.is_empty() {
        let message = format!("the curve `{}` has no points", at.name());
        at.error("empty-curve", message, "write one number, or points as in [[0, 0.3], [1, 2.0]]");
    }
    let mut last_age = f32::NEG_INFINITY;
    for (i, &[age, value]) in points.iter().enumerate() {
        let point = at.item(i);
        point.item(0).within(age, &SHARE, "ages run from 0 (birth) to 1 (death)");
        point.item(1).within(value, limit, help);
        if age <= last_age {
            let message = format!("in the curve `{}` age {age} comes after age {last_age}", at.name());
            point.error(
                "curve-not-rising",
                message,
                "order the points by age, and give each an age of its own",
            );
        }
        last_age = age;
    }
    Curve { points }
}

/// A vector that must point somewhere.
pub(super) fn direction(at: &At<'_>, vector: [f32; 3]) -> [f32; 3] {
    if length(vector) < MIN_DIRECTION {
        let message = format!("`{}` points nowhere: its length is zero", at.name());
        at.error("zero-direction", message, "give at least one component that is not 0, as in [0, -1, 0]");
    }
    vector
}

pub(super) fn length(vector: [f32; 3]) -> f32 {
    vector.iter().map(|component| component * component).sum::<f32>().sqrt()
}

/// The vector at length 1.
pub(super) fn unit(vector: [f32; 3]) -> [f32; 3] {
    let length = length(vector);
    vector.map(|component| component / length)
}

pub(super) fn cross(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
