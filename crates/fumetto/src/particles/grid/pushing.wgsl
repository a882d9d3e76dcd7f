// What pushes the air in a cell, as half floats: acceleration in m/s², and how much air appears, per second.

// Half floats end here.
const MOST: f32 = 6e4;

fn push_at(c: vec3u) -> vec4f {
    let both = push[cell_index(c)];
    return vec4f(unpack2x16float(both.x), unpack2x16float(both.y));
}

fn set_push(c: vec3u, value: vec4f) {
    let four = clamp(value, vec4f(-MOST), vec4f(MOST));
    push[cell_index(c)] = vec2u(pack2x16float(four.xy), pack2x16float(four.zw));
}

fn add_push(c: vec3u, acceleration: vec3f) {
    set_push(c, push_at(c) + vec4f(acceleration, 0.0));
}
