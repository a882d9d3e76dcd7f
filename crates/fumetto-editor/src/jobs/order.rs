use std::path::{Path, PathBuf};

/// Layers that can be written beside pictures, as the command line calls them.
pub(crate) const LAYERS: [&str; 5] = ["normal", "depth", "id", "alpha", "ink"];

/// The last frame that is made: names number frames with up to six digits, and ten hours are longer than a film.
pub(crate) const LAST_FRAME: u32 = 999_999;

/// What is to be made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Work {
    /// One picture of the frame that is shown.
    #[default]
    Picture,
    /// A picture of each frame.
    Sequence,
    /// One moving picture.
    Animation,
    /// Closed shapes and lines, for designers.
    Drawing,
    /// The same as a page to print.
    Page,
    /// Triangles.
    Mesh,
    /// Particles as a table.
    Particles,
    /// Volumes for other programs.
    Volume,
}

impl Work {
    pub(crate) const ALL: [Self; 8] = [
        Self::Picture,
        Self::Sequence,
        Self::Animation,
        Self::Drawing,
        Self::Page,
        Self::Mesh,
        Self::Particles,
        Self::Volume,
    ];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Picture => "Picture (PNG)",
            Self::Sequence => "Sequence (PNG)",
            Self::Animation => "Animation (GIF)",
            Self::Drawing => "Drawing (SVG)",
            Self::Page => "Page (PDF)",
            Self::Mesh => "Meshes (GLB)",
            Self::Particles => "Particles (CSV)",
            Self::Volume => "Volumes (VDB)",
        }
    }

    /// How the name of its files ends.
    pub(crate) fn ending(self) -> &'static str {
        match self {
            Self::Picture => ".png",
            Self::Sequence => ".####.png",
            Self::Animation => ".gif",
            Self::Drawing => ".svg",
            Self::Page => ".pdf",
            Self::Mesh => ".glb",
            Self::Particles => ".csv",
            Self::Volume => ".vdb",
        }
    }

    pub(crate) fn is_rendered(self) -> bool {
        matches!(self, Self::Picture | Self::Sequence | Self::Animation)
    }

    /// Whether it shows one frame.
    pub(crate) fn is_still(self) -> bool {
        !matches!(self, Self::Sequence | Self::Animation)
    }

    /// Whether it is seen by a camera, and so has a size.
    pub(crate) fn has_size(self) -> bool {
        self.is_rendered() || matches!(self, Self::Drawing | Self::Page)
    }
}

/// Everything that is said of a rendering or an export before it begins.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Order {
    pub(crate) work: Work,
    /// From the root: the command runs elsewhere.
    pub(crate) out: PathBuf,
    /// The frame of what is still.
    pub(crate) frame: u32,
    /// The first and the last of what moves.
    pub(crate) frames: [u32; 2],
    pub(crate) size: [u32; 2],
    pub(crate) antialias: u32,
    /// Which of [`LAYERS`] are written too.
    pub(crate) layers: [bool; 5],
    /// Whether frames that are there already are left alone.
    pub(crate) resume: bool,
}

impl Order {
    /// What the `fumetto` program is told; the scene itself comes by a pipe.
    pub(crate) fn arguments(&self) -> Vec<String> {
        let verb = if self.work.is_rendered() { "render" } else { "export" };
        let mut arguments: Vec<String> = vec![verb.into(), "-".into(), "--json".into()];
        let mut say = |flag: &str, value: String| arguments.extend([flag.to_owned(), value]);
        say("--output", self.out.display().to_string());
        if self.work.is_still() {
            say("--frame", self.frame.to_string());
        } else {
            say("--frames", format!("{}..{}", self.frames[0], self.frames[1]));
        }
        if self.work.has_size() {
            say("--size", format!("{}x{}", self.size[0], self.size[1]));
        }
        if self.work.is_rendered() {
            say("--antialias", self.antialias.to_string());
        }
        let layers: Vec<&str> = LAYERS
            .into_iter()
            .zip(self.layers)
            .filter_map(|(layer, wanted)| wanted.then_some(layer))
            .collect();
        if matches!(self.work, Work::Picture | Work::Sequence) && !layers.is_empty() {
            say("--layers", layers.join(","));
        }
        if self.work == Work::Sequence && self.resume {
            arguments.push("--resume".into());
        }
        arguments
    }

    /// How many frames there are to do.
    pub(crate) fn count(&self) -> u32 {
        if self.work.is_still() { 1 } else { self.frames[1].saturating_sub(self.frames[0]).saturating_add(1) }
    }
}

/// A name for what is made of the scene `scene`, beside it.
pub(crate) fn name_for(scene: &Path, work: Work) -> PathBuf {
    let stem = scene.file_stem().unwrap_or(scene.as_os_str()).to_string_lossy();
    scene.with_file_name(format!("{stem}{}", work.ending()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn order(work: Work) -> Order {
        Order {
            work,
            out: name_for(Path::new("/a/b.toml"), work),
            frame: 7,
            frames: [2, 5],
            size: [64, 36],
            antialias: 2,
            layers: [true, false, false, false, true],
            resume: true,
        }
    }

    #[test]
    fn an_order_is_what_a_hand_would_type() {
        let typed = |work| order(work).arguments().join(" ");
        assert_eq!(
            typed(Work::Sequence),
            "render - --json --output /a/b.####.png --frames 2..5 --size 64x36 --antialias 2 --layers normal,ink --resume"
        );
        assert_eq!(
            typed(Work::Animation),
            "render - --json --output /a/b.gif --frames 2..5 --size 64x36 --antialias 2"
        );
        assert_eq!(typed(Work::Drawing), "export - --json --output /a/b.svg --frame 7 --size 64x36");
        assert_eq!(typed(Work::Mesh), "export - --json --output /a/b.glb --frame 7");
        assert_eq!((order(Work::Sequence).count(), order(Work::Mesh).count()), (4, 1));
        let endless = Order { frames: [0, u32::MAX], ..order(Work::Animation) };
        assert_eq!(endless.count(), u32::MAX);
    }
}
