//! Every bound of the scene file, in one place: the schema prints them, the checks refuse by them.

use schemars::{Schema, transform::Transform};
use serde_json::Value;

/// Most bytes of a scene's text: a list of half a million particles.
pub const MAX_TEXT_BYTES: usize = 16 << 20;

/// Most steps that can be undone.
pub const MAX_HISTORY_STEPS: usize = 1000;

/// Most bytes of text that are kept for undoing.
pub const MAX_HISTORY_BYTES: usize = 64 << 20;

/// Bytes of simulation state a particle takes on the GPU.
pub const PARTICLE_BYTES: u64 = 64 + 32;

/// Most particles one object may hold. At 64 bytes each their motion fills 92 MiB, and WebGPU's default for
/// one storage binding is 128 MiB.
pub const MAX_PARTICLES: u64 = 1_500_000;

/// Most vortex particles one object may hold: workgroups make their tree in two rounds of eight levels.
pub const MAX_VORTICES: u64 = 65_536;

/// Vortex particles that there is room for at least. Also in the engine's `tree.wgsl`.
pub const MIN_VORTEX_ROOM: u64 = 2048;

/// Most cells of a grid: two numbers for each fill WebGPU's default for one storage binding, 128 MiB.
pub const MAX_GRID_CELLS: u64 = 1 << 24;

/// Most cells along a side of the coarsest level of a grid's pressure: 16³ fill a workgroup's memory. Also in the
/// engine's `coarsest.wgsl`.
pub const MAX_COARSEST_CELLS: u32 = 16;

/// Most objects in a scene: each has four pens, and the ink layer tells 255 of them apart.
pub const MAX_OBJECTS: usize = 63;

/// Most lights in a scene: a uniform holds them all, and the first four that throw shadows have a channel each.
pub const MAX_LIGHTS: usize = 8;

/// Most tones in a ramp (Álvarez draws with 32).
pub const MAX_TONES: usize = 32;

/// Most pictures that strokes are drawn with: with the named textures they fill an array of 256 layers, which is
/// WebGPU's default.
pub const MAX_STROKE_PICTURES: usize = 251;

/// Most colours that a volume's puffs choose from.
pub const MAX_COLOURS: usize = 8;

/// Most bytes that a volume's grids may take.
pub const MAX_VOLUME_BYTES: u64 = 512 << 20;

/// Most layers of paint in a scene, each wash counted singly: a pixel has a bit for each, and four more.
pub const MAX_PAINT_LAYERS: u32 = 12;

/// Most volumes of all paint: every tile of the picture asks each of them whether it comes near.
pub const MAX_PAINT_VOLUMES: u64 = 16_384;

/// Most vertices of all paint's volumes: 64 MiB of them.
pub const MAX_PAINT_VERTICES: u64 = 8_388_608;

/// Most pours of all paint: every cell asks each of them.
pub const MAX_PAINT_POURS: u64 = 1024;

/// Most points of a radius of paint over time: each piece of a stroke keeps them.
pub const MAX_PAINT_POINTS: usize = 256;

/// Most parts into which a step is cut for paint that is stiff.
pub const MAX_PAINT_SUBSTEPS: u32 = 1000;

/// The least length of a direction. Its square must not underflow in 32 bits.
pub const MIN_DIRECTION: f32 = 1e-9;

/// The least angle between the camera's `up` and its line of sight, as the sine of it.
pub const MIN_UP_SINE: f32 = 1e-4;

/// Any number that has no bounds of its own: its square stays finite in 32 bits.
pub const NUMBER: Limit = Limit::closed(-1e9, 1e9);
/// Lengths above zero, in metres.
pub const LENGTH: Limit = Limit::above(0.0, 1e9);
/// The camera's vertical field of view, in degrees.
pub const FOV_DEG: Limit = Limit::open(0.0, 180.0);
/// Shares of a whole.
pub const SHARE: Limit = Limit::closed(0.0, 1.0);
/// Shares of a whole of which something must be left.
pub const PART: Limit = Limit::above(0.0, 1.0);
/// Powers that something is raised to.
pub const EXPONENT: Limit = Limit::above(0.0, 10_000.0);
/// Lengths that may be zero, in metres.
pub const DISTANCE: Limit = Limit::closed(0.0, 1e9);
/// Tones between two colours, both counted.
pub const STEPS: Limit = Limit::closed(2.0, MAX_TONES as f64);
/// Values that a mesh's colours are brought to; 0 keeps all.
pub const MATERIAL_STEPS: Limit = Limit::closed(0.0, 32.0);
/// Sizes of relief that are told apart.
pub const SCALES: Limit = Limit::closed(1.0, 8.0);
/// What multiplies something else.
pub const FACTOR: Limit = Limit::closed(0.0, 1e6);
/// What multiplies something else and must leave some of it.
pub const SCALE: Limit = Limit::above(0.0, 1e6);
/// A particle's mass.
pub const MASS: Limit = Limit::above(0.0, 1e9);
/// Brightness of a light.
pub const INTENSITY: Limit = Limit::closed(0.0, 1e6);
/// Lengths in pixels that may be zero.
pub const PIXELS: Limit = Limit::closed(0.0, 8192.0);
/// Widths of lines in pixels.
pub const WIDTH_PX: Limit = Limit::above(0.0, 1024.0);
/// Widths of lines in metres.
pub const WIDTH_WORLD: Limit = Limit::above(0.0, 1e9);
/// Sides of a picture in pixels: a band of tiles of the widest fills 512 MiB.
pub const PICTURE_PX: Limit = Limit::closed(1.0, 32_768.0);
/// Samples along each side of a pixel.
pub const ANTIALIAS: Limit = Limit::closed(1.0, 4.0);
/// Frames in a second.
pub const FPS: Limit = Limit::above(0.0, 1000.0);
/// Frames for which a drawing is held.
pub const HOLD: Limit = Limit::closed(1.0, 1000.0);
/// Simulation steps in a frame.
pub const SUBSTEPS: Limit = Limit::closed(1.0, 16.0);
/// Different puffs of an object.
pub const VARIANTS: Limit = Limit::closed(1.0, 16.0);
/// Balls in a puff.
pub const SPHERES: Limit = Limit::closed(1.0, 256.0);
/// Width of a puff's picture in pixels; a power of two besides. All variants side by side must fit
/// WebGPU's default for one side of a texture: 16 × 512 = 8192.
pub const TILE_PX: Limit = Limit::closed(16.0, 512.0);
/// Seconds that a particle lives.
pub const LIFE_SECS: Limit = Limit::above(0.0, 1e6);
/// Seconds that are simulated before frame 0: enough for what lives long, few enough to wait for.
pub const PRE_ROLL_SECS: Limit = Limit::closed(0.0, 600.0);
/// Moments in seconds.
pub const SECONDS: Limit = Limit::closed(0.0, 1e6);
/// Lengths of time in seconds that may not be zero.
pub const PERIOD_SECS: Limit = Limit::above(0.0, 1e6);
/// Events in a second.
pub const RATE: Limit = Limit::closed(0.0, 1e9);
/// Half angle of an emitter's cone.
pub const SPREAD_DEG: Limit = Limit::closed(0.0, 180.0);
/// Speeds of air.
pub const SPEED: Limit = Limit::closed(-1e6, 1e6);
/// Accelerations.
pub const ACCELERATION: Limit = Limit::closed(-1e6, 1e6);
/// Directions that strokes have.
pub const HATCHING_LAYERS: Limit = Limit::closed(1.0, 4.0);
/// How far the planes that cut strokes lean.
pub const TILT_DEG: Limit = Limit::closed(0.0, 90.0);
/// Lengths along strokes, in their heights: so far runs of visible line are followed.
pub const STROKE_LENGTH: Limit = Limit::closed(0.0, 64.0);
/// How far strokes stray from their lines, in their heights.
pub const STROKE_WOBBLE: Limit = Limit::closed(0.0, 8.0);
/// What multiplies the length of a stroke's texture.
pub const STROKE_SCALE: Limit = Limit::closed(0.01, 1000.0);
/// How much heavier strokes are in bends.
pub const STROKE_CURVATURE: Limit = Limit::closed(0.0, 8.0);
/// How often strokes are drawn.
pub const STROKE_PASSES: Limit = Limit::closed(1.0, 8.0);
/// Frames for which strokes stay.
pub const STROKE_BOIL: Limit = Limit::closed(0.0, 1000.0);
/// Angles between faces.
pub const ANGLE_DEG: Limit = Limit::closed(0.0, 180.0);
/// What stretches a model; 0 is refused besides.
pub const STRETCH: Limit = Limit::closed(-1e6, 1e6);
/// Cells of a surface along its longest side.
pub const SUBDIVISIONS: Limit = Limit::closed(1.0, 512.0);
/// Cells of a surface on the picture.
pub const CELL_PX: Limit = Limit::closed(1.0, 512.0);
/// Cells of a surface to a particle's radius.
pub const PER_RADIUS: Limit = Limit::above(0.0, 100.0);
/// Strength of a surface's noise, in thresholds.
pub const AMPLITUDE: Limit = Limit::closed(0.0, 100.0);
/// Thickness of a ring's line, as a share of its radius.
pub const CORE: Limit = Limit::closed(0.05, 1.0);
/// Vortex particles in a ring.
pub const SEGMENTS: Limit = Limit::closed(8.0, 128.0);
/// Cells of a grid along its longest side.
pub const GRID_CELLS: Limit = Limit::closed(8.0, 512.0);
/// Share of a grid's divergence that may be left.
pub const RESIDUAL: Limit = Limit::above(0.0, 0.5);
/// Vortex particles that one emitter brings into a grid.
pub const EDDIES: Limit = Limit::closed(1.0, 4096.0);
/// Volumes of air that appear in a second.
pub const EXPANSION: Limit = Limit::closed(-1e4, 1e4);
/// Octaves of turbulence and of a surface's noise.
pub const OCTAVES: Limit = Limit::closed(1.0, 6.0);

/// What matter takes from light, per metre.
pub const EXTINCTION: Limit = Limit::above(0.0, 1e6);
/// Shares of a whole of which something must be taken and something left.
pub const INSIDE: Limit = Limit::open(0.0, 1.0);
/// Cells of a volume's density along its longest side.
pub const VOLUME_CELLS: Limit = Limit::closed(8.0, 512.0);
/// Cells of the light in it.
pub const LIGHT_CELLS: Limit = Limit::closed(4.0, 256.0);
/// Sides of the squares of pixels that share a line of sight.
pub const VOLUME_PIXELS: Limit = Limit::closed(1.0, 8.0);
/// Voxels along a side of a file without a header.
pub const RAW_SIDE: Limit = Limit::closed(1.0, 65_536.0);
/// What multiplies these.
pub const QUALITY: Limit = Limit::above(0.0, 4.0);
/// How far noise displaces a puff's surface, in its radii.
pub const DISPLACEMENT: Limit = Limit::closed(0.0, 10.0);
/// Bumps to a puff's radius.
pub const FREQUENCY: Limit = Limit::above(0.0, 100.0);
/// Octaves of a volume's noise.
pub const VOLUME_OCTAVES: Limit = Limit::closed(1.0, 8.0);
/// Each octave's frequency over that of the one before.
pub const LACUNARITY: Limit = Limit::closed(1.0, 8.0);
/// Pieces along each edge of the icosahedron that volumes of paint are made of.
pub const SPHERE_PIECES: Limit = Limit::closed(1.0, 16.0);
/// How hard paint is pressed.
pub const STIFFNESS: Limit = Limit::above(0.0, 1e6);
/// How hard it is pulled back.
pub const ELASTICITY: Limit = Limit::closed(0.0, 1e6);
/// Friction as a share of what is critical.
pub const FRICTION: Limit = Limit::above(0.0, 10.0);
/// How hard the slope of what it lies on draws it.
pub const DOWNHILL: Limit = Limit::closed(0.0, 1e6);
/// How far grain moves a border, as a share of the radius.
pub const GRAIN: Limit = Limit::closed(0.0, 0.9);
/// Lights in place of one.
pub const CLUSTER: Limit = Limit::closed(2.0, 16.0);
/// How far suns in place of one stand from their middle.
pub const CLUSTER_DEG: Limit = Limit::above(0.0, 45.0);
/// Things of which there is at least one.
pub const COUNT: Limit = Limit::closed(1.0, 1_500_000.0);
/// Volumes of paint in each other.
pub const WASHES: Limit = Limit::closed(1.0, 8.0);

/// The range of a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limit {
    min: f64,
    max: f64,
    min_excluded: bool,
    max_excluded: bool,
}

impl Limit {
    const fn closed(min: f64, max: f64) -> Self {
        Self { min, max, min_excluded: false, max_excluded: false }
    }

    const fn above(min: f64, max: f64) -> Self {
        Self { min_excluded: true, ..Self::closed(min, max) }
    }

    const fn open(min: f64, max: f64) -> Self {
        Self { max_excluded: true, ..Self::above(min, max) }
    }

    /// Whether `value` is inside; not-a-number never is.
    #[must_use]
    pub fn contains(&self, value: f64) -> bool {
        let above = if self.min_excluded { value > self.min } else { value >= self.min };
        let below = if self.max_excluded { value < self.max } else { value <= self.max };
        above && below
    }

    /// The least, which may itself be excluded.
    #[must_use]
    pub fn min(&self) -> f64 {
        self.min
    }

    /// The greatest, which may itself be excluded.
    #[must_use]
    pub fn max(&self) -> f64 {
        self.max
    }

    /// The nearest value that is within closed ends.
    #[must_use]
    pub fn clamped(&self, value: f64) -> f64 {
        value.clamp(self.min, self.max)
    }

    /// What `value`, which is outside, should be; reads on from "must be". A far end that nobody
    /// meets by intent is only named to those who passed it.
    #[must_use]
    pub fn wanted(&self, value: f64) -> String {
        let (min, max) = (self.min, self.max);
        let above = if self.min_excluded { format!("above {min}") } else { format!("at least {min}") };
        let below = if self.max_excluded { format!("below {max}") } else { format!("at most {max}") };
        if max >= FAR && value < max {
            above
        } else if min <= -FAR {
            below
        } else if self.min_excluded || self.max_excluded {
            format!("{above} and {below}")
        } else {
            format!("from {min} to {max}")
        }
    }

    /// The bounds of numbers of type `float` or `uint32`, narrowed by the keywords of `schemas`.
    pub(crate) fn from_schemas(whole: bool, schemas: &[&Value]) -> Self {
        let mut limit = if whole { Self::closed(0.0, f64::from(u32::MAX)) } else { NUMBER };
        for schema in schemas {
            let bound = |key: &str| schema[key].as_f64();
            if let Some(min) = bound("minimum").or(bound("exclusiveMinimum")) {
                (limit.min, limit.min_excluded) = (min, bound("minimum").is_none());
            }
            if let Some(max) = bound("maximum").or(bound("exclusiveMaximum")) {
                (limit.max, limit.max_excluded) = (max, bound("maximum").is_none());
            }
        }
        limit
    }
}

/// From here on a bound is a guard against overflow, not a choice.
const FAR: f64 = 1e6;

/// Writes the range into the JSON Schema of a number, or of the numbers of an array.
impl Transform for &Limit {
    fn transform(&mut self, schema: &mut Schema) {
        let bounds = [
            (if self.min_excluded { "exclusiveMinimum" } else { "minimum" }, self.min),
            (if self.max_excluded { "exclusiveMaximum" } else { "maximum" }, self.max),
        ];
        let schema = schema.ensure_object();
        let schema = match schema.get_mut("items") {
            Some(Value::Object(_)) => schema["items"].as_object_mut(),
            _ => Some(schema),
        };
        let Some(schema) = schema else { return };
        for (key, bound) in bounds {
            let whole = bound.fract() == 0.0;
            schema.insert(key.into(), if whole { (bound as i64).into() } else { bound.into() });
        }
    }
}
