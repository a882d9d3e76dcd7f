// Outlines: a second, larger billboard behind each puff (McGuire & Fein 2004, section 1.3). The margin in the
// atlas makes it larger by the same width all round. It hides no body; of several at one pixel the nearest is
// drawn.
//
// Ours: lines taper where what lies behind comes close, and thin toward the light.

@group(0) @binding(9) var id_layer: texture_2d<u32>;
@group(0) @binding(10) var depth_layer: texture_depth_2d;

// How far away is what each pixel shows, and a bit for each that shows anything of this cel.
var<private> behind: array<vec4f, 4>;
var<private> filled: u32;
// What the ink layer will hold.
var<private> marks: array<vec4u, 4>;

// No ink billboard is less far behind the nearest point of its puff.
var<private> ink_behind: f32;

// An ink billboard seen from a block.
struct Line {
    // Of the first pixel: from the puff's middle in pixels, and in the atlas.
    offset: vec2f,
    texel: vec2f,
    picture: Picture,
    // Radii to a pixel.
    radii: f32,
    // Texels from the middle as far as the atlas tells.
    extent: f32,
    distance: f32,
    // Share of their full width that lines gain for each metre to what lies behind.
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

// Looks at the line from a row of the block.
fn look(line: Line, row: u32) {
    let across = vec4f(ACROSS);
    let down = f32(row);
    let offset_x = line.offset.x + across;
    let offset_y = line.offset.y + down;
    let step = line.picture.step;
    let texel_x = line.texel.x + across * step.x - down * step.y;
    let texel_y = line.texel.y + across * step.y + down * step.x;
    let stored = vec4f(
        margin_at(vec2f(texel_x.x, texel_y.x)),
        margin_at(vec2f(texel_x.y, texel_y.y)),
        margin_at(vec2f(texel_x.z, texel_y.z)),
        margin_at(vec2f(texel_x.w, texel_y.w)),
    );
    let middle = line.picture.middle - 0.5;
    let aside = max(abs(texel_x - middle.x), abs(texel_y - middle.y));
    let away2 = max(offset_x * offset_x + offset_y * offset_y, vec4f(1e-6));
    let per_away = inverseSqrt(away2);
    // Farther out than the atlas tells, a puff is much like a disc.
    let outside = (stored < vec4f(2.5)) | (aside > vec4f(line.extent));
    let margin = select(stored, margin_bytes(0.9 - away2 * per_away * line.radii), outside);
    let lit = max((offset_x * line.light.x + offset_y * line.light.y) * per_away, vec4f(0.0));
    let taper = clamp((behind[row] - line.distance) * line.taper, vec4f(0.0), vec4f(1.0));
    let outer = line.widths.x * (1.0 - line.thinning * lit);
    let inner = line.widths.y * taper * (1.0 - line.thinning * min(2.0 * lit, vec4f(1.0)));
    let is_filled = ((vec4u(filled) >> (4u * row + ACROSS)) & vec4u(1u)) != vec4u(0u);
    let width = select(outer, inner, is_filled);
    let before = distances[row];
    let here = vec4f(line.distance);
    let mark = vec4u(line.mark);
    let nearer = (here < before) | ((here == before) & (mark < marks[row]));
    let inked = nearer & (margin > margin_bytes(line.picture.erosion - width));
    distances[row] = select(before, here, inked);
    marks[row] = select(marks[row], mark, inked);
}

fn begin_pixel(at: vec2u, row: u32, across: u32, is_over: bool) {
    let distance = min(distance_of(textureLoad(depth_layer, at, 0)), NOWHERE);
    behind[row][across] = select(0.0, distance, all(vec2f(at) < view.size_px));
    var shows = distance < NOWHERE;
    if is_over {
        shows = textureLoad(id_layer, at, 0).x != 0u;
    }
    filled |= u32(shows) << (4u * row + across);
}

fn begin(px: vec2u, is_over: bool) {
    filled = 0u;
    for (var row = 0u; row < 4u; row++) {
        begin_pixel(px + vec2u(0u, row), row, 0u, is_over);
        begin_pixel(px + vec2u(1u, row), row, 1u, is_over);
        begin_pixel(px + vec2u(2u, row), row, 2u, is_over);
        begin_pixel(px + vec2u(3u, row), row, 3u, is_over);
        distances[row] = behind[row];
        marks[row] = vec4u(0u);
    }
}

// The next puff + 1 whose ink billboard is nearer than something that is seen within its reach.
fn next_line(list: ptr<function, List>, place: vec2f) -> u32 {
    measure_rows();
    let rank = rank_limit(farthest_of(rows) - ink_behind);
    loop {
        let id = next_of(list, rank);
        if id == 0u {
            break;
        }
        let middle = bitcast<vec2f>(textureLoad(projected, projected_at(id - 1u, 0u)).xy);
        let ink = bitcast<vec4f>(textureLoad(projected, projected_at(id - 1u, 2u)));
        // A pixel more: between texels the atlas is mixed.
        let reach_px = ink.x + 1.0;
        if ink.w < NOWHERE && reaches(place - middle, reach_px * reach_px, ink.w) {
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
        1.0 / at.z,
        (TILE_EXTENT - 0.05) * length(picture.step) * at.z,
        distance,
        focal_px / (at.z * at.w),
        unpack2x16snorm(ink.x),
        unpack2x16float(ink.y),
        bitcast<f32>(ink.z),
        ink.w,
    );
}

fn walk(slot: u32, lane: u32, is_over: bool) {
    let px = block_px(slot, lane);
    begin_walk();
    ink_behind = bitcast<f32>(~summary.ink_behind);
    begin(px, is_over);
    let place = vec2f(px) + 0.5;
    // Some level has a list, or the tile would not be walked. The loop ends with its test: software rasterisers go
    // through what follows one once more, though for nobody.
    var levels = summary.levels;
    loop {
        var list = list_of(firstTrailingBit(levels), px);
        loop {
            let id = next_line(&list, place);
            if id == 0u {
                break;
            }
            let line = line_of(id, place);
            look(line, 0u);
            look(line, 1u);
            look(line, 2u);
            look(line, 3u);
        }
        levels &= levels - 1u;
        if levels == 0u {
            break;
        }
    }
    // Eight pixels to a texel.
    for (var row = 0u; row < 4u; row += 2u) {
        let left = vec4u(marks[row].xz, marks[row + 1u].xz);
        let right = vec4u(marks[row].yw, marks[row + 1u].yw);
        textureStore(found, vec2u(px.x / 4u, (px.y + row) / 2u), left | (right << vec4u(16u)));
    }
}

@compute @workgroup_size(64)
fn first(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let slot = slot_of(group, groups, lane);
    if slot < summary.covered {
        walk(slot, lane, false);
    }
}

// Where what is nearer may be of another cel.
@compute @workgroup_size(64)
fn over(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let slot = slot_of(group, groups, lane);
    if slot < summary.covered {
        walk(slot, lane, true);
    }
}
