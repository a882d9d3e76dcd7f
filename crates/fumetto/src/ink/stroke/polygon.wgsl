// Draws strokes: textured quads along lines, pushed outward from the body by a share of their height (Álvarez et al.
// 2007, section 4). What hides lines and bodies is asked of the depth layer, which stands for the paper's second
// iteration: it draws the mesh once more, as a mask.
//
// Ours: the hand. It strays and presses by noise that lies in space, so that a stroke keeps its ways while the camera
// moves; what it leaves depends on the paper's tooth, which lies on the picture.

@group(0) @binding(1) var<uniform> strokes: array<StrokeStyle, MAX_PENS>;
@group(0) @binding(2) var<uniform> pens: array<Pen, MAX_PENS>;
@group(0) @binding(3) var<storage, read> joints: array<Joint>;
@group(0) @binding(4) var<storage, read> shapes: array<Shape>;
@group(0) @binding(5) var<storage, read> triangles: array<Triangle>;
@group(0) @binding(6) var<storage, read> parts: array<Part>;
@group(0) @binding(7) var id_layer: texture_2d<u32>;
@group(0) @binding(8) var depth_layer: texture_depth_2d;
@group(0) @binding(9) var textures: texture_2d_array<f32>;
@group(0) @binding(10) var tooth: texture_2d<f32>;
@group(0) @binding(11) var repeating: sampler;
@group(0) @binding(12) var<uniform> paper: Paper;

struct Paper {
    // Pixels of the paper's tooth to one of the picture.
    scale: f32,
}

struct Corner {
    @builtin(position) position: vec4f,
    // Along the stroke in heights, then across from its outer side, 0 to 1.
    @location(0) @interpolate(linear) place: vec2f,
    // Height in pixels; how hard the hand presses.
    @location(1) @interpolate(linear) height_pressure: vec2f,
    @location(2) @interpolate(linear) depth: f32,
    // Pixels beyond the end of what is seen of the line.
    @location(3) @interpolate(linear) beyond: f32,
    // Pen and pass.
    @location(4) @interpolate(flat) marks: vec2u,
}

// Wavelengths, in heights, at which the hand strays and presses.
const WOBBLE_LENGTH: f32 = 14.0;
const PRESSURE_LENGTH: f32 = 22.0;
// Heights of a radius at which `curvature` counts fully.
const BEND: f32 = 4.0;
// Texels across a stroke's texture. Also in `textures.rs`.
const TEXELS_ACROSS: f32 = 64.0;
// How much darker paper must be pressed to fill its next deeper pores.
const SOFTNESS: f32 = 0.16;
// Strokes that cover less than this are not there.
const FAINTEST: f32 = 1.0 / 64.0;

// Noise that lies in space, whose waves are about `length` metres long. Two octaves mix, so that it neither slides nor
// jumps while that changes.
fn hand(place: vec3f, length: f32, seed: u32) -> f32 {
    let octave = -log2(length);
    let part = octave - floor(octave);
    let scale = exp2(floor(octave));
    return mix(noise(place * scale, seed).w, noise(place * 2.0 * scale, seed).w, part);
}

// A joint as one pass of the hand goes through it.
struct Touch {
    px: vec2f,
    // Half across, toward the outside.
    outward: vec2f,
    height: f32,
    pressure: f32,
    beyond: f32,
}

fn world_of(joint: Joint) -> vec3f {
    return (view.world_from_view * vec4f(ray_of(joint.px - view.first_px) * distance_of(joint.depth), 1.0)).xyz;
}

// `ends` are the pixels to the beginning and the end of what is seen of the line.
fn touch_of(index: u32, side: f32, ends: vec2f, pass_number: u32) -> Touch {
    let joint = joints[index];
    let shape = shapes[index];
    let style = strokes[joint.pen];
    let full = stroke_height_px(style, distance_of(joint.depth));
    let place = world_of(joint);
    let metre = full * distance_of(joint.depth) / view.focal_px;
    let seed = pcg(style.seed + 7919u * pass_number);
    let strays = hand(place, WOBBLE_LENGTH * metre, seed);
    let presses = hand(place, PRESSURE_LENGTH * metre, pcg(seed));

    // Each pass goes on beyond the ends as far as it likes.
    let reach = style.overshoot * full * vec2f(random(seed, 1u), random(seed, 2u));
    let is_end = ends <= vec2f(0.0);
    let shift = select(0.0, reach.y, is_end.y) - select(0.0, reach.x, is_end.x);
    let to_tip = min(ends.x + select(reach.x, 0.0, is_end.x), ends.y + select(reach.y, 0.0, is_end.y));
    let taper = style.taper * full;
    let tapered = select(1.0, sqrt(clamp(to_tip / max(taper, 1e-3), 0.0, 1.0)), taper > 0.0);

    let pressure = mix(1.0, clamp(0.55 + 0.9 * presses, 0.1, 1.0), style.pressure);
    let bent = 1.0 + style.curvature * min(BEND * full * abs(shape.bend), 1.0);
    let kept = 1.0 - pens[joint.pen].lit_thinning * joint.lit;
    let lit = kept * smoothstep(FINEST, 2.0 * FINEST, kept);
    // Later passes come and go.
    let comes = select(smoothstep(-0.15, 0.2, presses), 1.0, pass_number == 0u);
    let height = full * bent * lit * tapered * mix(1.0, pressure, 0.6) * comes;
    let across = vec2f(-shape.tangent.y, shape.tangent.x) * side;
    return Touch(
        shape.px + shift * shape.tangent + across * (style.wobble * full * strays),
        across,
        height,
        pressure * mix(0.6, 1.0, tapered),
        select(-1.0, abs(shift), any(is_end)),
    );
}

@vertex
fn vertex(@builtin(vertex_index) index: u32, @builtin(instance_index) instance: u32) -> Corner {
    let piece = index / 6u;
    let corner = array(0u, 1u, 2u, 0u, 2u, 3u)[index % 6u];
    let joint = joints[piece];
    let style = strokes[joint.pen];
    let shape = shapes[piece];
    if piece == joint.last || shape.shows == 0u || instance >= style.passes {
        return Corner(vec4f(0.0, 0.0, 0.0, 1.0), vec2f(0.0), vec2f(0.0), 0.0, 0.0, vec2u(0u));
    }
    // All of a piece has its outside on one side.
    let along = joints[piece + 1u].px - joint.px;
    let side = select(-1.0, 1.0, dot(vec2f(-along.y, along.x), unpack2x16snorm(joint.outward)) >= 0.0);
    let at_end = corner == 1u || corner == 2u;
    let outer = corner >= 2u;
    let step = length(along);
    let ends = vec2f(shape.before, shape.after) + select(vec2f(0.0, step), vec2f(step, 0.0), at_end);
    let at = piece + u32(at_end);
    let touch = touch_of(at, side, ends, instance);
    let reach = select(style.outward - 1.0, style.outward, outer) * touch.height;
    let px = touch.px + touch.outward * reach - view.first_px;
    return Corner(
        clip_of(px, 0.5),
        vec2f(joints[at].along, select(1.0, 0.0, outer)),
        vec2f(touch.height, touch.pressure),
        joints[at].depth,
        touch.beyond,
        vec2u(joint.pen, instance),
    );
}

struct Mark {
    @location(0) mark: vec2u,
    @builtin(frag_depth) depth: f32,
}

// How much of a place is covered.
fn covered(corner: Corner, style: StrokeStyle, px: vec2f) -> f32 {
    let height = corner.height_pressure.x;
    let seed = pcg(style.seed + 7919u * corner.marks.y);
    let u = corner.place.x / style.length + random(seed, 3u);
    let level = max(log2(TEXELS_ACROSS / max(height, 1.0)), 0.0);
    let ink = textureSampleLevel(textures, repeating, vec2f(u, corner.place.y), style.layer, level).x;
    let pressed = ink * corner.height_pressure.y;
    let lies = (px + view.first_px) * paper.scale;
    let pores = textureSampleLevel(tooth, repeating, lies / vec2f(textureDimensions(tooth)), max(log2(paper.scale), 0.0)).x;
    let grained = smoothstep(-SOFTNESS, SOFTNESS, pressed - pores) * smoothstep(0.0, 0.1, pressed);
    return mix(ink, grained, style.grain);
}

@fragment
fn fragment(corner: Corner) -> Mark {
    let px = corner.position.xy;
    let pen = pens[corner.marks.x];
    let style = strokes[corner.marks.x];
    let share = covered(corner, style, px);
    if share < FAINTEST || corner.height_pressure.x < 0.25 {
        discard;
    }
    let period = pen.dash_px.x + pen.dash_px.y;
    if period > 0.0 {
        let along = corner.place.x * stroke_height_px(style, distance_of(corner.depth));
        if along - floor(along / period) * period >= pen.dash_px.x {
            discard;
        }
    }
    let own = textureLoad(depth_layer, vec2i(px), 0);
    let id = textureLoad(id_layer, vec2i(px), 0).x;
    let reach = max(style.outward, 1.0 - style.outward) * corner.height_pressure.x;
    let bulge = select(OWN_BULGE, OTHER_BULGE, is_other(id, corner.marks.x / KINDS));
    if corner.beyond < 0.0 && own > corner.depth * (1.0 + DEPTH_TOLERANCE + bulge * reach / view.focal_px) {
        discard;
    }
    // Where strokes cross, the darkest stays.
    let rank = RANKS[corner.marks.x % KINDS];
    let over = max(own, corner.depth) * (1.0 + RANK_STEP * (0.5 + rank + share));
    return Mark(vec2u(corner.marks.x + 1u, u32(round(255.0 * share))), min(over, 1.0));
}
