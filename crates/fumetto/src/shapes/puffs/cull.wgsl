// Finds the puffs whose body, and whose ink, something solid does not surely hide.

struct Range {
    first: u32,
    count: u32,
}

// Bits of a puff's flags.
const BODY: u32 = 1u;
const INK: u32 = 2u;

@group(0) @binding(1) var<uniform> range: Range;
@group(0) @binding(2) var<uniform> pyramid: Pyramid;
@group(0) @binding(3) var<storage, read> puffs: array<Puff>;
@group(0) @binding(4) var<storage, read> styles: array<ObjectStyle>;
@group(0) @binding(5) var<storage, read> nearness: array<u32>;
@group(0) @binding(6) var<storage, read_write> flags: array<u32>;

@compute @workgroup_size(256)
fn cull(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let item = (group.y * groups.x + group.x) * 256u + lane;
    if item >= range.count {
        return;
    }
    let puff = puffs[item];
    let style = styles[puff_object(puff)];
    let sprite = sprite_of(puff);
    let fade = puff_fade(puff);
    var seen = 0u;
    if sprite.distance > 0.0 && fade.x < 1.0 && fade.y > 0.0 && (style.flags & IN_CEL) != 0u {
        if visible(sprite.px, vec2f(sprite.radius_px), sprite.distance - puff.radius) {
            seen |= BODY;
        }
        let width_px = ink_width_px(style, sprite.distance);
        let behind = sprite.distance + style.ink_offset * 2.0 * puff.radius;
        if (style.flags & HAS_INK) != 0u && visible(sprite.px, vec2f(sprite.radius_px + width_px), behind) {
            seen |= INK;
        }
    }
    flags[item] = seen;
}
