//! Links each shader program from its listed modules, and checks it.
//!
//! WGSL has no imports, so a program is the plain concatenation of its modules. A program that
//! does not parse or validate fails the build, with the module's own file name and line.

use std::{env, fs, path::Path, process::ExitCode};

use naga::valid::{Capabilities, ValidationFlags, Validator};

/// Every program: its name, then its modules (`src/….wgsl`), what is used before what uses it.
const PROGRAMS: &[(&str, &[&str])] = &[
    ("gpu/compact", &["gpu/compact"]),
    (
        "particles/step",
        &[
            "gpu/random",
            "gpu/noise",
            "gpu/basis",
            "particles/state",
            "particles/air",
            "particles/motion",
            "particles/vortex/tree",
            "particles/vortex/induced",
            "particles/vortex/moved",
            "particles/step",
        ],
    ),
    (
        "particles/step_in_grid",
        &[
            "gpu/random",
            "gpu/noise",
            "gpu/basis",
            "particles/state",
            "particles/air",
            "particles/grid/grid",
            "particles/grid/around",
            "particles/grid/sample",
            "particles/grid/solid",
            "particles/grid/moved",
            "particles/step",
        ],
    ),
    (
        "particles/grid/guess_x",
        &[
            "particles/grid/grid",
            "particles/grid/around",
            "particles/grid/across_x",
            "particles/grid/carry",
            "particles/grid/guess",
        ],
    ),
    (
        "particles/grid/correct_x",
        &[
            "particles/grid/grid",
            "particles/grid/around",
            "particles/grid/across_x",
            "particles/grid/carry",
            "particles/grid/blocks",
            "particles/grid/correct",
        ],
    ),
    (
        "particles/grid/guess_y",
        &[
            "particles/grid/grid",
            "particles/grid/around",
            "particles/grid/across_y",
            "particles/grid/carry",
            "particles/grid/guess",
        ],
    ),
    (
        "particles/grid/correct_y",
        &[
            "particles/grid/grid",
            "particles/grid/around",
            "particles/grid/across_y",
            "particles/grid/carry",
            "particles/grid/blocks",
            "particles/grid/correct",
        ],
    ),
    (
        "particles/grid/guess_z",
        &[
            "particles/grid/grid",
            "particles/grid/around",
            "particles/grid/across_z",
            "particles/grid/carry",
            "particles/grid/guess",
        ],
    ),
    (
        "particles/grid/correct_z",
        &[
            "particles/grid/grid",
            "particles/grid/around",
            "particles/grid/across_z",
            "particles/grid/carry",
            "particles/grid/blocks",
            "particles/grid/correct",
        ],
    ),
    (
        "particles/grid/busy",
        &["particles/grid/grid", "particles/grid/blocks", "particles/grid/source", "particles/grid/busy"],
    ),
    (
        "particles/grid/heat",
        &["particles/grid/grid", "particles/grid/around", "particles/grid/blocks", "particles/grid/heat"],
    ),
    (
        "particles/grid/feed",
        &["particles/grid/grid", "particles/grid/blocks", "particles/grid/source", "particles/grid/feed"],
    ),
    (
        "particles/grid/push",
        &[
            "gpu/random",
            "gpu/noise",
            "particles/air",
            "particles/grid/grid",
            "particles/grid/blocks",
            "particles/grid/source",
            "particles/grid/pushing",
            "particles/grid/push",
        ],
    ),
    ("particles/grid/curl", &["particles/grid/grid", "particles/grid/blocks", "particles/grid/curl"]),
    (
        "particles/grid/confine",
        &["particles/grid/grid", "particles/grid/blocks", "particles/grid/pushing", "particles/grid/confine"],
    ),
    (
        "particles/grid/ride",
        &[
            "gpu/random",
            "particles/state",
            "particles/grid/grid",
            "particles/grid/around",
            "particles/grid/sample",
            "particles/grid/eddy",
            "particles/grid/ride",
        ],
    ),
    (
        "particles/grid/stir",
        &[
            "particles/grid/grid",
            "particles/grid/blocks",
            "particles/grid/pushing",
            "particles/grid/eddy",
            "particles/grid/stir",
        ],
    ),
    (
        "particles/grid/divergence",
        &[
            "particles/grid/grid",
            "particles/grid/pushing",
            "particles/grid/pushed",
            "particles/grid/divergence",
        ],
    ),
    ("particles/grid/smooth", &["particles/grid/level", "particles/grid/smooth"]),
    ("particles/grid/coarsen", &["particles/grid/level", "particles/grid/coarsen"]),
    ("particles/grid/refine", &["particles/grid/level", "particles/grid/refine"]),
    ("particles/grid/coarsest", &["particles/grid/level", "particles/grid/coarsest"]),
    ("particles/grid/hold", &["particles/grid/grid", "particles/grid/solid", "particles/grid/hold"]),
    ("particles/grid/project", &["particles/grid/grid", "particles/grid/pushing", "particles/grid/project"]),
    (
        "particles/vortex/rings",
        &["gpu/random", "gpu/basis", "particles/vortex/vortex", "particles/vortex/rings"],
    ),
    (
        "particles/vortex/order",
        &["particles/vortex/vortex", "particles/vortex/tree", "particles/vortex/order"],
    ),
    ("particles/vortex/sort", &["particles/vortex/sort"]),
    (
        "particles/vortex/build",
        &["particles/vortex/vortex", "particles/vortex/tree", "particles/vortex/build"],
    ),
    (
        "particles/vortex/carry",
        &[
            "gpu/random",
            "gpu/noise",
            "particles/air",
            "particles/motion",
            "particles/vortex/vortex",
            "particles/vortex/tree",
            "particles/vortex/induced",
            "particles/vortex/carry",
        ],
    ),
    ("shapes/mesh/place", &["gpu/octahedral", "shapes/mesh/mesh", "shapes/mesh/place"]),
    (
        "shapes/mesh/body",
        &["gpu/view", "gpu/octahedral", "shapes/mesh/mesh", "shapes/mesh/surface", "shapes/mesh/body"],
    ),
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
    (
        "shapes/surface/bounds",
        &[
            "shapes/puffs/puff",
            "shapes/surface/recipe",
            "shapes/surface/lattice",
            "shapes/surface/reach",
            "shapes/surface/blob",
            "shapes/surface/bounds",
        ],
    ),
    (
        "shapes/surface/order",
        &["shapes/surface/recipe", "shapes/surface/lattice", "shapes/surface/blob", "shapes/surface/order"],
    ),
    (
        "shapes/surface/bins",
        &[
            "shapes/surface/recipe",
            "shapes/surface/lattice",
            "shapes/surface/reach",
            "shapes/surface/blob",
            "shapes/surface/around",
            "shapes/surface/bins",
        ],
    ),
    (
        "shapes/surface/regions",
        &[
            "shapes/surface/recipe",
            "shapes/surface/lattice",
            "shapes/surface/reach",
            "shapes/surface/blob",
            "shapes/surface/around",
            "shapes/surface/regions",
        ],
    ),
    ("shapes/surface/scan_words", &["shapes/surface/scan_words", "shapes/surface/scan"]),
    ("shapes/surface/scan_fours", &["shapes/surface/scan_fours", "shapes/surface/scan"]),
    (
        "shapes/surface/blocks",
        &[
            "shapes/surface/recipe",
            "shapes/surface/lattice",
            "shapes/surface/blob",
            "shapes/surface/kept",
            "shapes/surface/blocks",
        ],
    ),
    (
        "shapes/surface/enlist",
        &["shapes/surface/recipe", "shapes/surface/lattice", "shapes/surface/kept", "shapes/surface/enlist"],
    ),
    (
        "shapes/surface/dispatch",
        &["shapes/surface/lattice", "shapes/surface/folded", "shapes/surface/dispatch"],
    ),
    (
        "shapes/surface/signs",
        &[
            "gpu/random",
            "gpu/noise",
            "shapes/surface/recipe",
            "shapes/surface/lattice",
            "shapes/surface/blob",
            "shapes/surface/units",
            "shapes/surface/field",
            "shapes/surface/signs",
        ],
    ),
    (
        "shapes/surface/cells",
        &[
            "shapes/surface/lattice",
            "shapes/surface/recipe",
            "shapes/surface/cell",
            "shapes/surface/chunk",
            "shapes/surface/corners",
            "shapes/surface/cells",
        ],
    ),
    (
        "shapes/surface/vertices",
        &[
            "gpu/random",
            "gpu/noise",
            "gpu/octahedral",
            "shapes/surface/recipe",
            "shapes/surface/lattice",
            "shapes/surface/blob",
            "shapes/mesh/mesh",
            "shapes/surface/cell",
            "shapes/surface/chunk",
            "shapes/surface/chunk_at",
            "shapes/surface/units",
            "shapes/surface/skin",
            "shapes/surface/field",
            "shapes/surface/four",
            "shapes/surface/hard",
            "shapes/surface/vertices",
        ],
    ),
    (
        "shapes/surface/careful",
        &[
            "gpu/random",
            "gpu/noise",
            "gpu/octahedral",
            "shapes/surface/recipe",
            "shapes/surface/lattice",
            "shapes/surface/blob",
            "shapes/mesh/mesh",
            "shapes/surface/cell",
            "shapes/surface/units",
            "shapes/surface/skin",
            "shapes/surface/field",
            "shapes/surface/near",
            "shapes/surface/crossing",
            "shapes/surface/careful",
        ],
    ),
    (
        "shapes/surface/triangles",
        &[
            "shapes/surface/recipe",
            "shapes/surface/lattice",
            "shapes/mesh/mesh",
            "shapes/surface/cell",
            "shapes/surface/chunk",
            "shapes/surface/chunk_at",
            "shapes/surface/corners",
            "shapes/surface/triangles",
        ],
    ),
    (
        "shapes/surface/adjacent",
        &[
            "shapes/surface/recipe",
            "shapes/surface/lattice",
            "shapes/surface/cell",
            "shapes/surface/chunk",
            "shapes/surface/chunk_at",
            "shapes/surface/adjacent",
        ],
    ),
    (
        "shapes/surface/counters",
        &[
            "shapes/surface/recipe",
            "shapes/surface/lattice",
            "shapes/surface/folded",
            "shapes/surface/hard",
            "shapes/surface/counters",
        ],
    ),
    (
        "shapes/volume/bounds",
        &[
            "shapes/puffs/puff",
            "shapes/volume/recipe",
            "shapes/volume/grid",
            "shapes/volume/ball",
            "shapes/volume/bounds",
        ],
    ),
    (
        "shapes/volume/matter",
        &[
            "gpu/random",
            "gpu/noise",
            "shapes/puffs/puff",
            "shapes/volume/recipe",
            "shapes/volume/grid",
            "shapes/volume/ball",
            "shapes/volume/fbm",
            "shapes/volume/density",
            "shapes/volume/matter",
        ],
    ),
    ("shapes/volume/occupied", &["shapes/volume/grid", "shapes/volume/occupied"]),
    (
        "shapes/volume/transmit",
        &[
            "shapes/volume/recipe",
            "shapes/volume/walk",
            "shapes/volume/grid",
            "shapes/volume/cells",
            "light/lights",
            "shapes/volume/transmit",
        ],
    ),
    (
        "shapes/volume/bricks/transmit",
        &[
            "shapes/volume/recipe",
            "shapes/volume/walk",
            "shapes/volume/bricks/bricks",
            "light/lights",
            "shapes/volume/transmit",
        ],
    ),
    (
        "shapes/volume/march",
        &[
            "gpu/view",
            "gpu/fullscreen",
            "gpu/octahedral",
            "shapes/volume/recipe",
            "shapes/volume/walk",
            "shapes/volume/grid",
            "shapes/volume/cells",
            "shapes/volume/owners",
            "light/lights",
            "shapes/volume/march",
        ],
    ),
    (
        "shapes/volume/bricks/march",
        &[
            "gpu/view",
            "gpu/fullscreen",
            "gpu/octahedral",
            "shapes/volume/recipe",
            "shapes/volume/walk",
            "shapes/volume/bricks/bricks",
            "shapes/volume/bricks/numbers",
            "light/lights",
            "shapes/volume/march",
        ],
    ),
    ("shapes/volume/place", &["gpu/fullscreen", "shapes/volume/place"]),
    ("paint/cells", &["gpu/random", "paint/order", "paint/cells"]),
    ("paint/spread", &["gpu/random", "gpu/noise", "paint/body", "paint/order", "paint/spread"]),
    ("paint/measure", &["paint/body", "paint/measure"]),
    ("paint/mask", &["gpu/view", "paint/body", "paint/coat", "paint/sphere", "paint/mask"]),
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
    (
        "ink/outline",
        &[
            "gpu/view",
            "shapes/puffs/billboard",
            "shapes/puffs/projected",
            "shapes/puffs/bins",
            "shapes/puffs/walk",
            "ink/outline",
        ],
    ),
    ("ink/outlined", &["shapes/puffs/bins", "shapes/puffs/covered", "ink/outlined"]),
    (
        "ink/angle",
        &[
            "gpu/view",
            "gpu/fullscreen",
            "gpu/octahedral",
            "object",
            "shapes/puffs/puff",
            "shapes/mesh/mesh",
            "shapes/mesh/surface",
            "light/lights",
            "ink/pen",
            "ink/thinned",
            "ink/angle",
        ],
    ),
    (
        "ink/shell",
        &[
            "gpu/view",
            "gpu/octahedral",
            "object",
            "shapes/mesh/mesh",
            "light/lights",
            "ink/pen",
            "ink/thinned",
            "ink/shell",
        ],
    ),
    (
        "ink/image",
        &[
            "gpu/view",
            "object",
            "shapes/puffs/puff",
            "shapes/mesh/mesh",
            "light/lights",
            "ink/pen",
            "ink/thinned",
            "ink/seed",
            "ink/tiles",
            "ink/piece",
            "ink/seen",
            "ink/border",
            "ink/image",
        ],
    ),
    ("ink/borders", &["gpu/fullscreen", "shapes/mesh/mesh", "ink/piece", "ink/tiles", "ink/borders"]),
    ("ink/flood", &["ink/seed", "ink/tiles", "ink/flood"]),
    (
        "ink/flooded",
        &[
            "gpu/view",
            "shapes/puffs/puff",
            "shapes/mesh/mesh",
            "ink/object_of",
            "ink/pen",
            "ink/seed",
            "ink/tiles",
            "ink/flooded",
        ],
    ),
    (
        "ink/others",
        &["gpu/fullscreen", "object", "shapes/puffs/puff", "shapes/mesh/mesh", "ink/object_of", "ink/others"],
    ),
    (
        "ink/edges",
        &[
            "gpu/view",
            "gpu/octahedral",
            "shapes/mesh/mesh",
            "shapes/mesh/candidate",
            "ink/pen",
            "ink/known",
            "ink/segment",
            "ink/edges",
        ],
    ),
    (
        "ink/contours",
        &[
            "gpu/view",
            "gpu/octahedral",
            "shapes/mesh/mesh",
            "shapes/mesh/candidate",
            "ink/pen",
            "ink/made",
            "ink/segment",
            "ink/edges",
        ],
    ),
    (
        "ink/strip",
        &[
            "gpu/view",
            "gpu/octahedral",
            "shapes/mesh/mesh",
            "shapes/mesh/candidate",
            "light/lights",
            "ink/pen",
            "ink/known",
            "ink/segment",
            "ink/planes",
            "ink/hidden",
            "ink/before",
            "ink/strip",
        ],
    ),
    (
        "ink/contour_strip",
        &[
            "gpu/view",
            "gpu/octahedral",
            "shapes/mesh/mesh",
            "shapes/mesh/candidate",
            "light/lights",
            "ink/pen",
            "ink/made",
            "ink/segment",
            "ink/planes",
            "ink/hidden",
            "ink/before",
            "ink/strip",
        ],
    ),
    ("ink/stroke/count", &["ink/stroke/record", "ink/stroke/count"]),
    (
        "ink/stroke/pieces",
        &[
            "gpu/view",
            "gpu/octahedral",
            "shapes/mesh/mesh",
            "shapes/mesh/candidate",
            "light/lights",
            "ink/pen",
            "ink/known",
            "ink/segment",
            "ink/planes",
            "ink/stroke/style",
            "ink/stroke/record",
            "ink/stroke/meeting",
            "ink/stroke/pieces",
        ],
    ),
    (
        "ink/stroke/pieces_made",
        &[
            "gpu/view",
            "gpu/octahedral",
            "shapes/mesh/mesh",
            "shapes/mesh/candidate",
            "light/lights",
            "ink/pen",
            "ink/made",
            "ink/segment",
            "ink/planes",
            "ink/stroke/style",
            "ink/stroke/record",
            "ink/stroke/meeting_made",
            "ink/stroke/pieces",
        ],
    ),
    ("ink/stroke/meet", &["gpu/random", "gpu/octahedral", "ink/stroke/record", "ink/stroke/meet"]),
    ("ink/stroke/chain", &["ink/stroke/record", "ink/stroke/turn", "ink/stroke/chain"]),
    ("ink/stroke/starts", &["ink/stroke/record", "ink/stroke/joint", "ink/stroke/starts"]),
    ("ink/stroke/place", &["ink/stroke/record", "ink/stroke/turn", "ink/stroke/joint", "ink/stroke/place"]),
    (
        "ink/stroke/see",
        &[
            "gpu/view",
            "shapes/mesh/mesh",
            "shapes/mesh/candidate",
            "ink/known",
            "ink/planes",
            "ink/hidden",
            "ink/stroke/record",
            "ink/stroke/joint",
            "ink/stroke/see",
        ],
    ),
    (
        "ink/stroke/see_made",
        &[
            "gpu/view",
            "shapes/mesh/mesh",
            "shapes/mesh/candidate",
            "ink/made",
            "ink/planes",
            "ink/hidden",
            "ink/stroke/record",
            "ink/stroke/joint",
            "ink/stroke/see",
        ],
    ),
    (
        "ink/stroke/bridge",
        &[
            "gpu/view",
            "ink/pen",
            "ink/stroke/style",
            "ink/stroke/record",
            "ink/stroke/joint",
            "ink/stroke/walk",
            "ink/stroke/bridge",
        ],
    ),
    (
        "ink/stroke/smooth",
        &[
            "gpu/view",
            "ink/pen",
            "ink/stroke/style",
            "ink/stroke/record",
            "ink/stroke/joint",
            "ink/stroke/walk",
            "ink/stroke/shape",
            "ink/stroke/smooth",
        ],
    ),
    (
        "ink/stroke/polygon",
        &[
            "gpu/view",
            "gpu/random",
            "gpu/noise",
            "shapes/mesh/mesh",
            "ink/pen",
            "ink/before",
            "ink/hidden",
            "ink/stroke/style",
            "ink/stroke/joint",
            "ink/stroke/shape",
            "ink/stroke/polygon",
        ],
    ),
    ("ink/share", &["gpu/fullscreen", "ink/share"]),
    ("ink/around", &["gpu/fullscreen", "ink/around"]),
    (
        "tone/flat",
        &[
            "gpu/view",
            "gpu/fullscreen",
            "object",
            "shapes/puffs/puff",
            "shapes/puffs/form_grid",
            "shapes/puffs/form_at",
            "gpu/octahedral",
            "shapes/mesh/mesh",
            "shapes/mesh/surface",
            "light/lights",
            "tone/tones",
            "tone/ramp",
            "tone/srgb",
            "tone/shades",
            "tone/material",
            "tone/exaggerate",
            "gpu/random",
            "gpu/basis",
            "tone/hatching",
            "tone/twice",
            "tone/grain",
            "tone/strokes",
            "tone/laid",
            "tone/flat",
        ],
    ),
    ("tone/ground", &["gpu/view", "gpu/fullscreen", "tone/ground"]),
    ("tone/turns", &["gpu/view", "gpu/fullscreen", "tone/twice", "tone/turns"]),
    ("tone/slopes", &["gpu/view", "gpu/fullscreen", "tone/slopes"]),
    (
        "tone/sprites",
        &[
            "gpu/view",
            "gpu/fullscreen",
            "object",
            "shapes/puffs/billboard",
            "light/lights",
            "tone/ramp",
            "tone/sprite_tile",
            "tone/sprites",
        ],
    ),
    (
        "tone/copied",
        &[
            "gpu/view",
            "gpu/fullscreen",
            "object",
            "shapes/puffs/billboard",
            "shapes/puffs/projected",
            "light/lights",
            "tone/ramp",
            "tone/sprite_tile",
            "tone/copied",
        ],
    ),
    (
        "tone/compose",
        &[
            "gpu/fullscreen",
            "ink/pen",
            "tone/srgb",
            "tone/monochrome",
            "tone/composing",
            "tone/line",
            "tone/inked",
            "tone/under",
            "tone/compose",
        ],
    ),
    (
        "tone/reveal",
        &[
            "gpu/fullscreen",
            "ink/pen",
            "tone/srgb",
            "tone/monochrome",
            "tone/composing",
            "tone/line",
            "tone/inked",
            "paint/coat",
            "paint/marks",
            "tone/reveal",
        ],
    ),
    ("tone/veil", &["gpu/fullscreen", "tone/srgb", "tone/veil"]),
    ("tone/lay", &["gpu/fullscreen", "tone/composing", "tone/under", "tone/lay"]),
    ("tone/lines", &["ink/pen", "tone/composing", "tone/line", "tone/lines"]),
];

/// What every `WebGPU` adapter can do: `pack2x16float` counts as a capability of its own here.
const CAPABILITIES: Capabilities = Capabilities::SHADER_FLOAT16_IN_FLOAT32;

fn main() -> ExitCode {
    println!("cargo::rerun-if-changed=build.rs");
    let out = env::var("OUT_DIR").expect("cargo sets OUT_DIR");
    let mut broken = 0;
    for (name, modules) in PROGRAMS {
        let program = Program::link(modules);
        if let Err(message) = program.check() {
            println!("cargo::error={name}: {message}");
            broken += 1;
        }
        let path = Path::new(&out).join(format!("{name}.wgsl"));
        fs::create_dir_all(path.parent().expect("the path has a folder")).expect("OUT_DIR is writable");
        fs::write(&path, &program.text).expect("OUT_DIR is writable");
    }
    if broken == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// A linked program and where its lines come from.
struct Program {
    text: String,
    /// Each module with the number of its first line in `text`, from 0.
    starts: Vec<(&'static str, u32)>,
}

impl Program {
    fn link(modules: &[&'static str]) -> Self {
        let mut program = Self { text: String::new(), starts: Vec::new() };
        let mut lines = 0;
        for module in modules {
            let path = format!("src/{module}.wgsl");
            println!("cargo::rerun-if-changed={path}");
            let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
            program.starts.push((module, lines));
            lines += u32::try_from(text.lines().count()).expect("a shader has fewer lines than u32");
            program.text.push_str(&text);
        }
        program
    }

    fn check(&self) -> Result<(), String> {
        let module = naga::front::wgsl::parse_str(&self.text)
            .map_err(|error| self.place(error.location(&self.text), error.message()))?;
        Validator::new(ValidationFlags::all(), CAPABILITIES).validate(&module).map(|_| ()).map_err(|error| {
            let causes =
                std::iter::successors(std::error::Error::source(error.as_inner()), |cause| cause.source());
            let message = causes.fold(error.to_string(), |text, cause| format!("{text}: {cause}"));
            self.place(error.location(&self.text), &message)
        })
    }

    /// `message` with the module and line that it is about.
    fn place(&self, location: Option<naga::SourceLocation>, message: &str) -> String {
        let Some(location) = location else { return message.to_owned() };
        let line = location.line_number - 1;
        let (module, start) =
            self.starts.iter().rfind(|(_, start)| *start <= line).expect("the first module starts at 0");
        format!("src/{module}.wgsl:{}:{}: {message}", line - start + 1, location.line_position)
    }
}
