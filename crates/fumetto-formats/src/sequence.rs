//! Names of numbered files: `clouds/puff.####.png` stands for `clouds/puff.0001.png` and its kin.

use std::ops::Range;

/// Whether `pattern` names a numbered sequence: its file name holds `####` (any run of `#`) or `{}`.
#[must_use]
pub fn is_sequence(pattern: &str) -> bool {
    marker(pattern).is_some()
}

/// The path of `frame` in the sequence that `pattern` names.
///
/// A run of `#` becomes the number, padded with zeros to the run's length; a number that is longer
/// keeps all its digits. `{}` becomes the number without padding. Only the file name is looked at,
/// never the folders, and if it holds several such places the last one counts. A pattern without any
/// comes back as it is.
///
/// ```
/// use fumetto_formats::sequence_path;
///
/// assert_eq!(sequence_path("out/puff.####.png", 7), "out/puff.0007.png");
/// assert_eq!(sequence_path("out/puff{}.png", 7), "out/puff7.png");
/// assert_eq!(sequence_path("out/puff.png", 7), "out/puff.png");
/// ```
#[must_use]
pub fn sequence_path(pattern: &str, frame: u32) -> String {
    let Some(place) = marker(pattern) else { return pattern.to_owned() };
    let width = if pattern[place.clone()].starts_with('#') { place.len() } else { 0 };
    format!("{}{frame:0width$}{}", &pattern[..place.start], &pattern[place.end..])
}

/// Where the number goes: the last `{}` or run of `#` in the file name.
fn marker(pattern: &str) -> Option<Range<usize>> {
    let name_start = pattern.rfind(['/', '\\']).map_or(0, |separator| separator + 1);
    let name = &pattern[name_start..];
    let braces = name.rfind("{}").map(|start| start..start + 2);
    let hashes = name.rfind('#').map(|last| {
        let before = &name[..last];
        before.trim_end_matches('#').len()..last + 1
    });
    let place = match (braces, hashes) {
        (Some(braces), Some(hashes)) => Some(if braces.start > hashes.start { braces } else { hashes }),
        (braces, hashes) => braces.or(hashes),
    }?;
    Some(name_start + place.start..name_start + place.end)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hashes_pad_to_their_number() {
        assert_eq!(sequence_path("a.####.png", 12), "a.0012.png");
        assert_eq!(sequence_path("#.png", 12), "12.png");
        assert_eq!(sequence_path("###", 12345), "12345");
        assert_eq!(sequence_path("é##.gif", 3), "é03.gif");
    }

    #[test]
    fn a_pad_wider_than_any_number_is_kept() {
        assert_eq!(sequence_path(&"#".repeat(100), 1), format!("{:0100}", 1));
    }

    #[test]
    fn braces_do_not_pad() {
        assert_eq!(sequence_path("a{}.png", 0), "a0.png");
    }

    #[test]
    fn the_last_place_counts() {
        assert_eq!(sequence_path("take#2_####.png", 5), "take#2_0005.png");
        assert_eq!(sequence_path("{}_##.png", 5), "{}_05.png");
        assert_eq!(sequence_path("##_{}.png", 5), "##_5.png");
    }

    #[test]
    fn folders_are_left_alone() {
        assert_eq!(sequence_path("take#2/{}/a.png", 5), "take#2/{}/a.png");
        assert!(!is_sequence("take#2/a.png"));
        assert!(!is_sequence("take#2\\a.png"));
        assert!(is_sequence("take#2\\a#.png"));
    }
}
