// The scene's lights.

struct Light {
    // Direction toward a sun, or place of a point light.
    vector: vec3f,
    // 1 for a point light.
    is_point: f32,
    intensity: f32,
    // Channel of the shadow layer, or -1.
    channel: i32,
    pad: vec2f,
}

struct Lights {
    light: array<Light, 8>,
    count: u32,
}

// From a place toward a light.
fn toward(light: Light, place: vec3f) -> vec3f {
    return normalize(light.vector - place * light.is_point);
}
