use crate::Transform;

/// A volume out of a file, and where it stands.
#[derive(Clone, Debug, PartialEq)]
pub struct Imported {
    /// Path of a .vdb, .nrrd or .npy file, or of raw numbers; `####` or `{}` in it numbers a sequence by frame.
    pub file: String,
    /// Name of the grid that is the density.
    pub density: Option<String>,
    /// Name of the grid that tells how hot matter is.
    pub heat: Option<String>,
    /// Numbers of the file that mean density 0 and density 1, which differ.
    pub range: Option<[f32; 2]>,
    /// Numbers of the file that mean heat 0 and heat 1, which differ.
    pub heat_range: [f32; 2],
    /// Numbers of a sequence's first and last file.
    pub frames: Option<[u32; 2]>,
    /// Whether a sequence begins anew after its last file.
    pub repeats: bool,
    /// Of a file without a header.
    pub raw: Option<Raw>,
    /// Whether the file's z axis points up, not its y axis.
    pub z_up: bool,
    /// Where it stands.
    pub place: Transform,
}

/// How the numbers of a file without a header lie in it: along x first, then y, then z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Raw {
    /// Voxels along the axes; none is 0.
    pub size: [u32; 3],
    /// What a number is.
    pub number: RawNumber,
    /// Whether a number's greatest byte comes first.
    pub big_endian: bool,
    /// Sides of a voxel; above zero.
    pub voxel_m: [f32; 3],
    /// Where the middle of the first voxel lies.
    pub origin_m: [f32; 3],
    /// Bytes before the first number.
    pub skip: u32,
}

/// What a number in a file without a header is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "they are called as they are in Rust")]
pub enum RawNumber {
    U8,
    I8,
    U16,
    I16,
    U32,
    I32,
    F16,
    F32,
    F64,
}

impl Imported {
    /// The number of the file that `frame` shows.
    #[must_use]
    pub fn number_at(&self, frame: u32) -> u32 {
        match self.frames {
            None => frame,
            Some([first, last]) if self.repeats && frame > last => {
                first + (frame - first) % (last - first).saturating_add(1)
            }
            Some([first, last]) => frame.clamp(first, last),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers(frames: Option<[u32; 2]>, repeats: bool) -> Vec<u32> {
        let imported = Imported {
            file: String::new(),
            density: None,
            heat: None,
            range: None,
            heat_range: [0.0, 1.0],
            frames,
            repeats,
            raw: None,
            z_up: false,
            place: Transform::default(),
        };
        (0..9).map(|frame| imported.number_at(frame)).collect()
    }

    #[test]
    fn sequences_hold_their_ends_or_begin_anew() {
        assert_eq!(numbers(None, false), [0, 1, 2, 3, 4, 5, 6, 7, 8]);
        assert_eq!(numbers(Some([2, 4]), false), [2, 2, 2, 3, 4, 4, 4, 4, 4]);
        assert_eq!(numbers(Some([2, 4]), true), [2, 2, 2, 3, 4, 2, 3, 4, 2]);
        assert_eq!(numbers(Some([3, 3]), true), [3; 9]);
    }
}
