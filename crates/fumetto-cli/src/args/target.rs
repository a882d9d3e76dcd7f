use std::str::FromStr;

use fumetto_formats::is_sequence;

/// Where a rendering goes; its name says what kind of file that is.
#[derive(Clone, Debug, Eq, PartialEq)]
pub(crate) struct Target {
    /// As the user wrote it.
    pub(crate) name: String,
    pub(crate) kind: TargetKind,
}

#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(crate) enum TargetKind {
    /// One .png.
    Picture,
    /// A .png for each frame.
    Sequence,
    /// One .gif of all frames.
    Animation,
}

impl FromStr for Target {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        let kind = match extension_of(name).as_deref() {
            Some("png") if is_sequence(name) => TargetKind::Sequence,
            Some("png") => TargetKind::Picture,
            Some("gif") if is_sequence(name) => {
                return Err("a .gif holds all frames; leave the place for their number out".to_owned());
            }
            Some("gif") => TargetKind::Animation,
            _ => {
                let known = "end its name in .png (one picture, or one a frame as in smoke.####.png) or .gif";
                return Err(format!("its extension does not say what to write; {known}"));
            }
        };
        Ok(Self { name: name.to_owned(), kind })
    }
}

/// The extension in lower case.
pub(super) fn extension_of(name: &str) -> Option<String> {
    let file = name.rsplit(['/', '\\']).next().unwrap_or(name);
    file.rsplit_once('.').map(|(_, extension)| extension.to_ascii_lowercase())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_name_says_what_is_written() {
        let kind = |name: &str| name.parse::<Target>().map(|target| target.kind).ok();
        assert_eq!(kind("a.png"), Some(TargetKind::Picture));
        assert_eq!(kind("out/a.####.PNG"), Some(TargetKind::Sequence));
        assert_eq!(kind("a{}.png"), Some(TargetKind::Sequence));
        assert_eq!(kind("a.gif"), Some(TargetKind::Animation));
        for name in ["", "png", "a", "a.bmp", "a.png/b", "a.##.gif", "a.png.txt"] {
            assert_eq!(kind(name), None, "{name}");
        }
    }
}
