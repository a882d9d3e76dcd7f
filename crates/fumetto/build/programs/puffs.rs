use super::Programs;

pub(super) const PROGRAMS: Programs = &[
    ("shapes/puffs/atlas", &["gpu/fullscreen", "shapes/puffs/atlas"]),
    (
        "shapes/puffs/present",
        &["gpu/random", "particles/state", "shapes/puffs/puff", "shapes/puffs/look", "shapes/puffs/present"],
    ),
    (
        "shapes/puffs/project",
        &[
            "gpu/view",
            "object",
            "shapes/puffs/puff",
            "shapes/puffs/sprite",
            "shapes/puffs/billboard",
            "shapes/puffs/projected",
            "shapes/puffs/bins",
            "light/lights",
            "ink/width",
            "ink/pen",
            "shapes/puffs/project",
        ],
    ),
    ("shapes/puffs/bin", &["gpu/view", "shapes/puffs/projected", "shapes/puffs/bins", "shapes/puffs/bin"]),
    (
        "shapes/puffs/nearest",
        &[
            "gpu/view",
            "shapes/puffs/projected",
            "shapes/puffs/bins",
            "shapes/puffs/walk",
            "shapes/puffs/nearest",
        ],
    ),
    ("shapes/puffs/fill", &["shapes/puffs/bins", "shapes/puffs/covered", "shapes/puffs/fill"]),
    ("shapes/puffs/heights", &["gpu/fullscreen", "shapes/puffs/heights"]),
    ("shapes/puffs/reduce", &["shapes/puffs/pyramid", "shapes/puffs/reduce"]),
    ("shapes/puffs/form", &["object", "shapes/puffs/puff", "shapes/puffs/form_grid", "shapes/puffs/form"]),
    (
        "shapes/puffs/normal",
        &[
            "gpu/view",
            "gpu/fullscreen",
            "object",
            "shapes/puffs/puff",
            "shapes/puffs/sprite",
            "shapes/puffs/billboard",
            "shapes/puffs/form_grid",
            "shapes/puffs/form_at",
            "gpu/octahedral",
            "shapes/puffs/normal",
        ],
    ),
];
