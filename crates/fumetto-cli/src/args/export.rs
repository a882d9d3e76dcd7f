use std::str::FromStr;

use clap::ValueEnum;

use super::target::extension_of;

/// Where an export goes; its name says what format that is.
#[derive(Clone, Debug, Eq, PartialEq)]
pub(crate) struct ExportTarget {
    /// As the user wrote it.
    pub(crate) name: String,
    pub(crate) format: Format,
}

/// A format that is exported to.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(crate) enum Format {
    Png,
    Glb,
    Obj,
    Ply,
    Csv,
    Vdb,
    Svg,
    Pdf,
}

/// What is exported.
#[derive(Clone, Copy, Debug, Eq, PartialEq, ValueEnum)]
pub(crate) enum What {
    /// Surfaces and models, as triangles with normals and materials.
    Meshes,
    /// Particles: centre, radius and mass, as scenes read them.
    Particles,
    /// The pictures of all puffs.
    Sprites,
    /// Volumes, as grids of density and temperature.
    Volumes,
    /// Closed shapes of flat colours, and lines.
    Drawings,
}

impl Format {
    /// What may be in it; the first unless something else is asked for.
    pub(crate) fn holds(self) -> &'static [What] {
        match self {
            Self::Png => &[What::Sprites],
            Self::Glb | Self::Obj => &[What::Meshes],
            Self::Ply => &[What::Meshes, What::Particles],
            Self::Csv => &[What::Particles],
            Self::Vdb => &[What::Volumes],
            Self::Svg | Self::Pdf => &[What::Drawings],
        }
    }
}

impl FromStr for ExportTarget {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        let format = match extension_of(name).as_deref() {
            Some("png") => Format::Png,
            Some("glb") => Format::Glb,
            Some("obj") => Format::Obj,
            Some("ply") => Format::Ply,
            Some("csv") => Format::Csv,
            Some("vdb") => Format::Vdb,
            Some("svg") => Format::Svg,
            Some("pdf") => Format::Pdf,
            _ => {
                let known = "end its name in .svg or .pdf (drawings), .glb, .obj or .ply (triangles), .csv \
                             (particles), .vdb (volumes) or .png (the pictures of all puffs)";
                return Err(format!("its extension does not say what to export; {known}"));
            }
        };
        Ok(Self { name: name.to_owned(), format })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_name_says_what_is_exported() {
        let format = |name: &str| name.parse::<ExportTarget>().map(|target| target.format).ok();
        assert_eq!(format("out/a.####.GLB"), Some(Format::Glb));
        assert_eq!(format("a.ply"), Some(Format::Ply));
        assert_eq!(format("a.csv"), Some(Format::Csv));
        assert_eq!(format("a.####.vdb"), Some(Format::Vdb));
        assert_eq!(format("a.####.svg"), Some(Format::Svg));
        for name in ["", "glb", "a", "a.gltf", "a.glb/b", "a.eps"] {
            assert_eq!(format(name), None, "{name}");
        }
    }
}
