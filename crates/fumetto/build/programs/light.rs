use super::Programs;

pub(super) const PROGRAMS: Programs = &[
    (
        "light/casters",
        &[
            "gpu/view",
            "object",
            "shapes/puffs/puff",
            "shapes/puffs/pyramid",
            "shapes/puffs/visible",
            "light/lights",
            "light/sweep",
            "light/casting",
            "light/casters",
        ],
    ),
    (
        "light/cast",
        &[
            "gpu/view",
            "object",
            "shapes/puffs/puff",
            "shapes/puffs/billboard",
            "light/lights",
            "light/sweep",
            "light/casting",
            "light/cast",
        ],
    ),
    ("light/depths", &["gpu/fullscreen", "light/casting", "light/depths"]),
    ("light/shadowed", &["gpu/fullscreen", "light/casting", "light/shadowed"]),
    (
        "light/extrude",
        &[
            "gpu/view",
            "shapes/mesh/mesh",
            "shapes/mesh/shells",
            "light/lights",
            "light/volumes",
            "light/facing",
            "light/faces",
            "light/extrude",
        ],
    ),
    (
        "light/extrude_closed",
        &[
            "gpu/view",
            "gpu/octahedral",
            "shapes/mesh/mesh",
            "light/lights",
            "light/volumes",
            "light/facing",
            "light/faces",
            "light/extrude_closed",
        ],
    ),
    (
        "light/cap",
        &["gpu/view", "shapes/mesh/mesh", "light/lights", "light/volumes", "light/face", "light/cap"],
    ),
    (
        "light/side",
        &["gpu/view", "shapes/mesh/mesh", "light/lights", "light/volumes", "light/face", "light/side"],
    ),
    ("light/counted", &["gpu/fullscreen", "shapes/mesh/mesh", "light/facing", "light/counted"]),
    ("light/settle", &["gpu/fullscreen", "light/settle"]),
    ("light/soften", &["gpu/fullscreen", "light/soften"]),
];
