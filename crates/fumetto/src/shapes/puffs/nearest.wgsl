// The nearest puff of every pixel: nailboards, billboards whose pixels carry depth (Schaufler 1997; McGuire
// & Fein 2004, section 1.4). Each list is walked until nothing can be nearer than what is seen. Writes puff + 1
// and the bits of the depth. What the puff looks like there is worked out once per pixel afterwards.

@group(0) @binding(9) var depth_layer: texture_depth_2d;

// What each pixel sees: a puff + 1.
var<private> ids: array<vec4u, 4>;

// A puff seen from a block.
struct Seen {
    // Of the first pixel: from the puff's middle in pixels, and in the atlas.
    offset: vec2f,
    texel: vec2f,
    picture: Picture,
    radius_px2: f32,
    distance: f32,
    // In parts of 255.
    radius: f32,
    // More than this is inside.
    margin: f32,
    id: u32,
}

// Four texels for each of four pixels; of each a byte, mixed.
fn mixed(upper: vec4u, lower: vec4u, byte: u32, across: vec4f, down: vec4f) -> vec4f {
    let left = vec4u(8u * byte);
    let right = vec4u(8u * byte + 16u);
    let bits = vec4u(0xffu);
    let above = mix(vec4f((upper >> left) & bits), vec4f((upper >> right) & bits), across);
    let below = mix(vec4f((lower >> left) & bits), vec4f((lower >> right) & bits), across);
    return mix(above, below, down);
}

fn heights_at(x: f32, y: f32) -> vec2u {
    return textureLoad(heights, vec2i(vec2f(x, y))).xy;
}

// Looks at the puff from a row of the block.
fn look(seen: Seen, row: u32) {
    let across = vec4f(ACROSS);
    let down = f32(row);
    let offset_x = seen.offset.x + across;
    let offset_y = seen.offset.y + down;
    let step = seen.picture.step;
    let texel_x = seen.texel.x + across * step.x - down * step.y;
    let texel_y = seen.texel.y + across * step.y + down * step.x;
    let first_x = floor(texel_x);
    let first_y = floor(texel_y);
    let a = heights_at(first_x.x, first_y.x);
    let b = heights_at(first_x.y, first_y.y);
    let c = heights_at(first_x.z, first_y.z);
    let d = heights_at(first_x.w, first_y.w);
    let upper = vec4u(a.x, b.x, c.x, d.x);
    let lower = vec4u(a.y, b.y, c.y, d.y);
    let height = mixed(upper, lower, 0u, texel_x - first_x, texel_y - first_y);
    let margin = mixed(upper, lower, 1u, texel_x - first_x, texel_y - first_y);
    let in_reach = offset_x * offset_x + offset_y * offset_y <= vec4f(seen.radius_px2);
    let distance = seen.distance - height * seen.radius;
    let before = distances[row];
    let id = vec4u(seen.id);
    let is_first = (distance < before) | ((distance == before) & (id < ids[row]));
    let nearer = in_reach & (margin > vec4f(seen.margin)) & is_first;
    distances[row] = select(before, distance, nearer);
    ids[row] = select(ids[row], id, nearer);
}

fn begin(px: vec2u, is_empty: bool) {
    for (var row = 0u; row < 4u; row++) {
        let at = vec2u(px.x, px.y + row);
        // Nothing is nearer than what lies beyond the screen.
        let on_screen = (vec4f(at.x + ACROSS) < vec4f(view.size_px.x)) & vec4<bool>(f32(at.y) < view.size_px.y);
        distances[row] = select(vec4f(0.0), vec4f(NOWHERE), on_screen);
        ids[row] = vec4u(0u);
        if !is_empty {
            let depths = vec4f(
                textureLoad(depth_layer, at, 0),
                textureLoad(depth_layer, at + vec2u(1u, 0u), 0),
                textureLoad(depth_layer, at + vec2u(2u, 0u), 0),
                textureLoad(depth_layer, at + vec2u(3u, 0u), 0),
            );
            distances[row] = min(near / depths, distances[row]);
        }
    }
}

// The next puff + 1 that may be the nearest in any pixel; 0 when there is none.
fn next_seen(list: ptr<function, List>, place: vec2f) -> u32 {
    measure_rows();
    let rank = rank_limit(farthest_of(rows));
    loop {
        let id = next_of(list, rank);
        if id == 0u {
            break;
        }
        let at = bitcast<vec4f>(textureLoad(projected, projected_at(id - 1u, 0u)));
        // A little more than its radius, for rounding.
        let radius = at.z * at.w * (1.001 / focal_px);
        if reaches(place - at.xy, at.z * at.z, at.w - radius) {
            return id;
        }
    }
    return 0u;
}

fn seen_of(id: u32, place: vec2f) -> Seen {
    let at = bitcast<vec4f>(textureLoad(projected, projected_at(id - 1u, 0u)));
    let picture = picture_unpacked(textureLoad(projected, projected_at(id - 1u, 1u)));
    let offset = place - at.xy;
    let radius = at.z * at.w / (focal_px * 255.0);
    let margin = margin_bytes(vec4f(picture.erosion)).x;
    return Seen(offset, texel_of(picture, offset), picture, at.z * at.z, at.w, radius, margin, id);
}

fn walk(slot: u32, lane: u32, is_empty: bool) {
    let px = block_px(slot, lane);
    begin_walk();
    begin(px, is_empty);
    let place = vec2f(px) + 0.5;
    // Some level has a list, or the tile would not be walked. The loop ends with its test: software rasterisers go
    // through what follows one once more, though for nobody.
    var levels = summary.levels;
    loop {
        var list = list_of(firstTrailingBit(levels), px);
        loop {
            let id = next_seen(&list, place);
            if id == 0u {
                break;
            }
            let seen = seen_of(id, place);
            // Spelled out, so that what each pixel sees stays in registers.
            look(seen, 0u);
            look(seen, 1u);
            look(seen, 2u);
            look(seen, 3u);
        }
        levels &= levels - 1u;
        if levels == 0u {
            break;
        }
    }
    // Two pixels to a texel.
    for (var row = 0u; row < 4u; row++) {
        let id = ids[row];
        let depth = bitcast<vec4u>(near / max(distances[row], vec4f(near)));
        let at = vec2u(px.x / 2u, px.y + row);
        textureStore(found, at, vec4u(id.x, depth.x, id.y, depth.y));
        textureStore(found, at + vec2u(1u, 0u), vec4u(id.z, depth.z, id.w, depth.w));
    }
}

@compute @workgroup_size(64)
fn alone(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let slot = slot_of(group, groups, lane);
    if slot < summary.covered {
        walk(slot, lane, true);
    }
}

// Where the depth layer holds something already.
@compute @workgroup_size(64)
fn among(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let slot = slot_of(group, groups, lane);
    if slot < summary.covered {
        walk(slot, lane, false);
    }
}
