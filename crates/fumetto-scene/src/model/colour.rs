/// A colour in linear Rec. 709, each channel from 0 to 1.
///
/// An 8-bit sRGB colour survives the way here and back exactly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Colour {
    /// Red, green, blue; linear.
    pub linear: [f32; 3],
}

impl Colour {
    /// The colour of three 8-bit sRGB channels.
    #[must_use]
    pub fn from_srgb8(srgb: [u8; 3]) -> Self {
        Self { linear: srgb.map(|channel| decode(f32::from(channel) / 255.0)) }
    }

    /// The nearest 8-bit sRGB channels.
    #[must_use]
    pub fn to_srgb8(self) -> [u8; 3] {
        self.linear.map(|channel| (encode(channel.clamp(0.0, 1.0)) * 255.0).round() as u8)
    }
}

/// sRGB's electro-optical transfer function (IEC 61966-2-1).
fn decode(encoded: f32) -> f32 {
    if encoded <= 0.04045 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) }
}

/// The inverse of [`decode`].
fn encode(linear: f32) -> f32 {
    if linear <= 0.003_130_8 { linear * 12.92 } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 }
}
