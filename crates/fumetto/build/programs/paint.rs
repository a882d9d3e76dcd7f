use super::Programs;

pub(super) const PROGRAMS: Programs = &[
    ("paint/cells", &["gpu/random", "paint/order", "paint/cells"]),
    ("paint/touch", &["particles/state", "paint/order", "paint/ground", "paint/touch"]),
    (
        "paint/spread",
        &[
            "gpu/random",
            "gpu/noise",
            "paint/body",
            "paint/order",
            "paint/ground",
            "paint/downhill",
            "paint/spread",
        ],
    ),
    ("paint/measure", &["paint/body", "paint/measure"]),
    (
        "paint/mask",
        &["gpu/view", "paint/body", "paint/coat", "paint/sphere", "paint/find", "paint/known", "paint/mask"],
    ),
];
