// The camera, as every pass sees it.

struct View {
    view_from_world: mat4x4f,
    world_from_view: mat4x4f,
    // Of what is drawn, samples included: the picture, or a tile of it.
    size_px: vec2f,
    // Pixels per metre at a distance of one metre.
    focal_px: f32,
    // Distance of the near plane in metres.
    near: f32,
    // From the picture's top left: its middle, and where what is drawn begins.
    middle_px: vec2f,
    first_px: vec2f,
}

@group(0) @binding(0) var<uniform> view: View;

// Reverse-Z with an infinite far plane: 1 at the near plane, 0 infinitely far.
fn depth_of(distance: f32) -> f32 {
    return view.near / max(distance, view.near);
}

fn distance_of(depth: f32) -> f32 {
    return view.near / depth;
}

// A place in view space (looking along -z) to pixels from the top left of what is drawn. It is rounded as a
// place in the picture, so that neighbouring tiles agree on it.
fn px_of(position: vec3f) -> vec2f {
    return view.middle_px + vec2f(position.x, -position.y) * (view.focal_px / -position.z) - view.first_px;
}

// The ray through a pixel, one metre deep.
fn ray_of(px: vec2f) -> vec3f {
    let offset = (px + view.first_px - view.middle_px) / view.focal_px;
    return vec3f(offset.x, -offset.y, -1.0);
}

// The same in the world.
fn world_ray(px: vec2f) -> vec3f {
    return (view.world_from_view * vec4f(ray_of(px), 0.0)).xyz;
}

// Pixels to clip space at a given depth.
fn clip_of(px: vec2f, depth: f32) -> vec4f {
    let ndc = px / view.size_px * 2.0 - 1.0;
    return vec4f(ndc.x, -ndc.y, depth, 1.0);
}

// A place in view space, or a direction in which `near` is 0, to clip space. A tile sees its part of the picture
// at an angle.
fn clip_of_view(p: vec3f, near: f32) -> vec4f {
    let aside = (2.0 * (view.middle_px - view.first_px) / view.size_px - 1.0) * vec2f(1.0, -1.0);
    return vec4f(2.0 * view.focal_px / view.size_px * p.xy + aside * -p.z, near, -p.z);
}

// A place in the world to clip space.
fn clip_from_world(position: vec3f) -> vec4f {
    return clip_of_view((view.view_from_world * vec4f(position, 1.0)).xyz, view.near);
}
