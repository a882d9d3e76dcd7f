use std::str::FromStr;

use fumetto_scene::limits::PICTURE_PX;

/// Width and height in pixels, each one that a scene may have.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(crate) struct Size(pub(crate) [u32; 2]);

/// A width on paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Millimetres(pub(crate) f64);

/// The widest paper in millimetres: as large as PDF's viewers show.
const WIDEST_MM: f64 = 5080.0;

impl FromStr for Millimetres {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let width: Option<f64> = text.parse().ok();
        let in_range = width.filter(|width| (1.0..=WIDEST_MM).contains(width));
        in_range
            .map(Self)
            .ok_or_else(|| format!("write a width from 1 to {WIDEST_MM} millimetres, as in 210"))
    }
}

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wanted = "write width and height as in 1280x720";
        let (width, height) = text.split_once(['x', 'X']).ok_or(wanted)?;
        Ok(Self([side("width", width)?, side("height", height)?]))
    }
}

fn side(name: &str, text: &str) -> Result<u32, String> {
    let pixels: u32 =
        text.parse().map_err(|_| format!("the {name} {text:?} is no number of pixels; write 1280x720"))?;
    if !PICTURE_PX.contains(pixels.into()) {
        return Err(format!("the {name} must be {}", PICTURE_PX.wanted(pixels.into())));
    }
    Ok(pixels)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_width_and_height() {
        assert_eq!("64x36".parse(), Ok(Size([64, 36])));
        assert_eq!("32768X32768".parse(), Ok(Size([32_768, 32_768])));
    }

    #[test]
    fn widths_are_in_millimetres() {
        assert_eq!("297.5".parse(), Ok(Millimetres(297.5)));
        for text in ["", "0", "-3", "NaN", "inf", "1e9", "21cm"] {
            assert!(text.parse::<Millimetres>().is_err(), "{text}");
        }
    }

    #[test]
    fn sizes_that_cannot_be_drawn_are_refused() {
        for text in ["", "64", "x", "64x", "0x0", "0x36", "64x0", "32769x1", "100000x100000", "-1x1", "1x1x1"]
        {
            assert!(text.parse::<Size>().is_err(), "{text}");
        }
    }
}
