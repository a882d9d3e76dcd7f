// Outlines: a second, larger billboard behind each puff (McGuire & Fein 2004, section 1.3). The margin in the
// atlas makes it larger by the same width all round. It hides no body; of several at one pixel the nearest is
// drawn.
//
// Ours: lines taper where what lies behind comes close, and thin toward the light.

@group(0) @binding(10) var id_layer: texture_2d<u32>;
@group(0) @binding(11) var depth_layer: texture_depth_2d;

// How far away is what each pixel shows, and a bit for each that shows anything of this cel.
var<private> behind: array<f32, 16>;
var<private> filled: u32;
// What the ink layer will hold.
var<private> marks: array<u32, 16>;

// An ink billboard seen from a block.
struct Line {
    offset: vec2f,
    texel: vec2f,
    picture: Picture,
    // Pixels to a radius.
    radius_px: f32,
    distance: f32,
    // Distance behind it at which lines have their full width.
    taper: f32,
    light: vec2f,
    // Of outlines and of inner lines, in the puff's margin.
    widths: vec2f,
    thinning: f32,
    // What the ink layer holds of it.
    mark: u32,
}

// In parts of 255.
fn margin_at(texel: vec2f) -> f32 {
    let first = floor(texel);
    let share = texel - first;
    let four = textureLoad(heights, vec2i(first)).xy;
    let left = vec2f(vec2u((four.x >> 8u) & 0xffu, (four.y >> 8u) & 0xffu));
    let right = vec2f(vec2u(four.x >> 24u, four.y >> 24u));
    let across = mix(left, right, share.x);
    return mix(across.x, across.y, share.y);
}

fn look(line: Line, pixel: u32) {
    let step = vec2f(pixel_of(pixel));
    let offset = line.offset + step;
    let picture = line.picture;
    let texel = line.texel + step.x * picture.step + step.y * vec2f(-picture.step.y, picture.step.x);
    let stored = margin_at(texel);
    // Texels to a radius.
    let p = (texel + 0.5 - picture.middle) / (length(picture.step) * line.radius_px);
    let away = max(length(offset), 1e-3);
    // Farther out than the atlas tells, a puff is much like a disc.
    let outside = stored < 2.5 || any(abs(p) > vec2f(TILE_EXTENT - 0.05));
    let margin = select(stored, margin_byte(0.9 - away / line.radius_px), outside);
    let lit = max(dot(offset, line.light) / away, 0.0);
    let taper = clamp((behind[pixel] - line.distance) / line.taper, 0.0, 1.0);
    let outer = line.widths.x * (1.0 - line.thinning * lit);
    let inner = line.widths.y * taper * (1.0 - line.thinning * min(2.0 * lit, 1.0));
    let width = select(outer, inner, (filled & (1u << pixel)) != 0u);
    let before = distances[pixel];
    let nearer = line.distance < before || (line.distance == before && line.mark < marks[pixel]);
    let inked = nearer && margin > margin_byte(picture.erosion - width);
    distances[pixel] = select(before, line.distance, inked);
    marks[pixel] = select(marks[pixel], line.mark, inked);
}

fn begin(px: vec2u, is_over: bool) {
    filled = 0u;
    for (var pixel = 0u; pixel < 16u; pixel++) {
        let at = px + pixel_of(pixel);
        let distance = min(distance_of(textureLoad(depth_layer, at, 0)), NOWHERE);
        behind[pixel] = select(0.0, distance, all(vec2f(at) < view.size_px));
        distances[pixel] = behind[pixel];
        marks[pixel] = 0u;
        var shows = distance < NOWHERE;
        if is_over {
            shows = textureLoad(id_layer, at, 0).x != 0u;
        }
        filled |= u32(shows) << pixel;
    }
}

// The next puff + 1 whose ink billboard is nearer than something that is seen.
fn next_line(list: ptr<function, List>) -> u32 {
    let far = farthest();
    let rank = rank_limit(far);
    loop {
        let id = next_of(list, rank);
        if id == 0u || bitcast<f32>(textureLoad(projected, projected_at(id - 1u, 2u)).w) < far {
            return id;
        }
    }
    return 0u;
}

fn line_of(id: u32, place: vec2f) -> Line {
    let at = bitcast<vec4f>(textureLoad(projected, projected_at(id - 1u, 0u)));
    let picture = picture_unpacked(textureLoad(projected, projected_at(id - 1u, 1u)));
    let distance = bitcast<f32>(textureLoad(projected, projected_at(id - 1u, 2u)).w);
    let ink = textureLoad(projected, projected_at(id - 1u, 3u));
    let offset = place - at.xy;
    return Line(
        offset,
        texel_of(picture, offset),
        picture,
        at.z,
        distance,
        at.z * at.w / view.focal_px,
        unpack2x16snorm(ink.x),
        unpack2x16float(ink.y),
        bitcast<f32>(ink.z),
        ink.w,
    );
}

fn walk(slot: u32, lane: u32, is_over: bool) {
    let px = block_px(slot, lane);
    begin(px, is_over);
    for (var levels = summary.levels; levels != 0u; levels &= levels - 1u) {
        var list = list_of(firstTrailingBit(levels), px);
        loop {
            let id = next_line(&list);
            if id == 0u {
                break;
            }
            let line = line_of(id, vec2f(px) + 0.5);
            look(line, 0u);
            look(line, 1u);
            look(line, 2u);
            look(line, 3u);
            look(line, 4u);
            look(line, 5u);
            look(line, 6u);
            look(line, 7u);
            look(line, 8u);
            look(line, 9u);
            look(line, 10u);
            look(line, 11u);
            look(line, 12u);
            look(line, 13u);
            look(line, 14u);
            look(line, 15u);
        }
    }
    // Eight pixels to a texel.
    for (var pixel = 0u; pixel < 16u; pixel += 8u) {
        let left = vec4u(marks[pixel], marks[pixel + 2u], marks[pixel + 4u], marks[pixel + 6u]);
        let right = vec4u(marks[pixel + 1u], marks[pixel + 3u], marks[pixel + 5u], marks[pixel + 7u]);
        textureStore(found, (px + pixel_of(pixel)) / vec2u(4u, 2u), left | (right << vec4u(16u)));
    }
}

@compute @workgroup_size(64)
fn first(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let slot = slot_of(group, groups, lane);
    if slot < draw[1] {
        walk(slot, lane, false);
    }
}

// Where what is nearer may be of another cel.
@compute @workgroup_size(64)
fn over(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let slot = slot_of(group, groups, lane);
    if slot < draw[1] {
        walk(slot, lane, true);
    }
}
