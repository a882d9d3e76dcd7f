// Nailboard shadow volumes (McGuire & Fein 2004, section 1.4): for each puff the volume that it keeps
// from a light, between a front and a back polygon that coincide in image space. Every pixel's depth is
// displaced by the puff's own height, so that shadows end along wavy curves.
//
// Ours: both depths come from where the pixel's ray passes the volume's axis, so that the two polygons
// agree in perspective too, and the camera may stand inside a volume. They are not counted in the stencil
// but compared with what is seen at once: what lies between any two of them is in shadow. Volumes are
// many and small, and a software rasteriser spends more on setting up their triangles than on what they
// cover.

@group(0) @binding(1) var<uniform> atlas: Atlas;
@group(0) @binding(2) var<uniform> casting: Casting;
@group(0) @binding(3) var<uniform> lights: Lights;
@group(0) @binding(4) var<storage, read> puffs: array<Puff>;
@group(0) @binding(5) var<storage, read> list: array<u32>;
// The sixth is how many are listed.
@group(0) @binding(6) var<storage, read> draw: array<u32, 6>;
@group(0) @binding(7) var<uniform> styles: array<ObjectStyle, MAX_OBJECTS>;
@group(0) @binding(8) var heights: texture_storage_2d<rg32uint, read>;
// One for each texel of the mask.
@group(0) @binding(9) var depths: texture_storage_2d<r32float, read>;
@group(0) @binding(10) var<storage, read_write> mask: array<atomic<u32>>;

// Invocations that share a large volume.
const TEAM: u32 = 64u;

// A line of texels, both ends included; empty where the first is beyond the last.
struct Span {
    first: i32,
    last: i32,
}

// The texels of a row whose middles lie in the volume's rectangle.
fn span_of(volume: Volume, row: i32) -> Span {
    let middle = volume.px / casting.step - 0.5;
    let y = f32(row) - middle.y;
    // The rectangle is what is between two pairs of lines, one along it and one across.
    var low = -1.0;
    var high = f32(casting.size.x);
    for (var pair = 0; pair < 2; pair++) {
        let half = select(volume.along_px, volume.side_px, pair == 1) / casting.step;
        let reach = dot(half, half);
        let steep = abs(half.x) > 1e-3 * abs(half.y);
        let slope = select(1.0, half.x, steep);
        let a = (-reach - half.y * y) / slope;
        let b = (reach - half.y * y) / slope;
        low = select(low, max(low, min(a, b) + middle.x), steep);
        high = select(high, min(high, max(a, b) + middle.x), steep);
    }
    return Span(max(i32(ceil(low)), 0), min(i32(floor(high)), i32(casting.size.x) - 1));
}

// The puff's picture, cut through its middle across the light's direction.
struct Cut {
    // Texel of the puff's middle in the atlas; texels from there to the volume's side.
    middle: vec2f,
    side: vec2f,
    // Erosion, as the atlas holds margins.
    margin: f32,
}

fn cut_of(puff: Puff, volume: Volume) -> Cut {
    let to_middle = volume.middle / max(-volume.middle.z, view.near);
    let normal = cross(to_middle, volume.axis);
    let across = -normalize(normal.xy + vec2f(1e-9, 0.0));
    let rotation = puff_rotation(puff);
    let own = vec2f(rotation.x * across.x + rotation.y * across.y, rotation.x * across.y - rotation.y * across.x);
    let level = atlas_level(volume.radius * view.focal_px / max(-volume.middle.z, view.near), atlas);
    let middle = atlas_uv(vec2f(0.0), f32(puff_variant(puff)), level, atlas);
    let rim = atlas_uv(own, f32(puff_variant(puff)), level, atlas);
    let texels = vec2f(atlas.variants, 2.0) * atlas.tile_px;
    return Cut(middle * texels, (rim - middle) * texels, (puff_fade(puff).x + 0.5) * (255.0 / 1.5));
}

// Whether what is seen at a texel of the mask lies in the volume.
fn shadowed(at: vec2i, volume: Volume, cut: Cut) -> bool {
    let depth = textureLoad(depths, at).x;
    let ray = ray_of((vec2f(at) + 0.5) * casting.step);
    // Closest approach of the ray and the axis: how far to the axis's side (in radii), along the ray, along
    // the axis.
    let normal = cross(ray, volume.axis);
    let sine2 = max(dot(normal, normal), 1e-8);
    let side = dot(volume.middle, normal) * inverseSqrt(sine2) / volume.radius;
    let along_ray = dot(cross(volume.middle, volume.axis), normal) / sine2;
    let along_axis = dot(cross(volume.middle, ray), normal) / sine2;
    let texel = textureLoad(heights, vec2i(cut.middle + cut.side * clamp(side, -1.0, 1.0))).x;
    let reach = f32(texel & 0xffu) * (volume.radius / 255.0);
    let half = reach * inverseSqrt(sine2);
    // Between the beginning, which bulges as the puff does, and the end.
    let along = dot(ray, volume.axis);
    let slope = 1.0 / select(along, 1e-6, abs(along) < 1e-6);
    let first = along_ray + (volume.first * reach - along_axis) * slope;
    let last = along_ray + (volume.last - along_axis) * slope;
    let near = max(along_ray - half, min(first, last));
    let far = min(along_ray + half, max(first, last));
    let is_there = abs(side) < 1.0 && f32((texel >> 8u) & 0xffu) > cut.margin && near < far && far > view.near;
    return is_there && depth_of(far) <= depth && depth_of(near) > depth;
}

// Marks what one puff shadows, in every `step`-th row from the `first` one on.
fn mark(item: u32, first: i32, step: i32) {
    let puff = puffs[item];
    let volume = volume_of(puff, styles[puff_object(puff)], lights.light[casting.light]);
    let cut = cut_of(puff, volume);
    let half = (abs(volume.along_px.y) + abs(volume.side_px.y)) / casting.step;
    let middle = volume.px.y / casting.step - 0.5;
    let end = min(i32(floor(middle + half)), i32(casting.size.y) - 1);
    var row = max(i32(ceil(middle - half)), 0) + first;
    var span = span_of(volume, row);
    while row <= end {
        if span.first <= span.last {
            let at = vec2i(span.first, row);
            if shadowed(at, volume, cut) {
                let index = u32(at.y) * casting.size.x + u32(at.x);
                atomicOr(&mask[index / (32u / TEXEL_BITS)], casting.channel << (index % (32u / TEXEL_BITS) * TEXEL_BITS));
            }
            span.first++;
        }
        if span.first > span.last {
            row += step;
            span = span_of(volume, row);
        }
    }
}

// An invocation for every puff.
@compute @workgroup_size(256)
fn small(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let index = (group.y * groups.x + group.x) * 256u + lane;
    if index < draw[5] {
        mark(list[index], 0, 1);
    }
}

// A workgroup for every puff, one after another.
@compute @workgroup_size(TEAM)
fn large(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    for (var index = group.x; index < draw[5]; index += groups.x) {
        mark(list[index], i32(lane), i32(TEAM));
    }
}
