use super::Programs;

pub(super) const PROGRAMS: Programs = &[
    ("shapes/mesh/place", &["gpu/octahedral", "shapes/mesh/mesh", "shapes/mesh/place"]),
    (
        "shapes/mesh/body",
        &["gpu/view", "gpu/octahedral", "shapes/mesh/mesh", "shapes/mesh/surface", "shapes/mesh/body"],
    ),
];
