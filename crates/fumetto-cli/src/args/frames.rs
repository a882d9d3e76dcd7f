use std::str::FromStr;

/// Frames from the first to the last, both included.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(crate) struct FrameRange {
    pub(crate) first: u32,
    pub(crate) last: u32,
}

impl FrameRange {
    /// One frame.
    pub(crate) fn one(frame: u32) -> Self {
        Self { first: frame, last: frame }
    }

    /// The frames that are asked for; without any, one file shows the last of the scene's `frames`.
    pub(crate) fn chosen(
        frame: Option<u32>,
        range: Option<Self>,
        is_one_file: bool,
        [first, last]: [u32; 2],
    ) -> Self {
        match (frame, range) {
            (Some(frame), _) => Self::one(frame),
            (None, Some(range)) => range,
            (None, None) if is_one_file => Self::one(last),
            (None, None) => Self { first, last },
        }
    }

    pub(crate) fn iter(self) -> impl Iterator<Item = u32> {
        self.first..=self.last
    }

    /// How many frames; at least one.
    pub(crate) fn len(self) -> u64 {
        u64::from(self.last - self.first) + 1
    }
}

impl FromStr for FrameRange {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wanted = "write the first and the last frame as in 0..119";
        let (first, last) = text.split_once("..").ok_or(wanted)?;
        let frame =
            |number: &str| number.parse::<u32>().map_err(|_| format!("{number:?} is no frame; {wanted}"));
        let (first, last) = (frame(first)?, frame(last)?);
        if first > last {
            return Err(format!("frame {first} comes after {last}; {wanted}"));
        }
        Ok(Self { first, last })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_ends_belong_to_a_range() {
        let range = FrameRange { first: 3, last: 5 };
        assert_eq!("3..5".parse(), Ok(range));
        assert_eq!(range.iter().collect::<Vec<_>>(), [3, 4, 5]);
        assert_eq!(range.len(), 3);
    }

    #[test]
    fn the_longest_range_can_be_counted() {
        assert_eq!(FrameRange { first: 0, last: u32::MAX }.len(), 1 << 32);
    }

    #[test]
    fn what_is_no_range_is_refused() {
        for text in ["", "5", "..", "1..", "..2", "5..4", "-1..2", "0..4294967296", "0...3", "a..b"] {
            assert!(text.parse::<FrameRange>().is_err(), "{text}");
        }
    }
}
