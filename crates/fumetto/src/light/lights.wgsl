// The scene's lights.

struct Light {
    // Direction toward a sun, or place of a point light.
    vector: vec3f,
    // 1 for a point light.
    is_point: f32,
    intensity: f32,
    // Channel of the shadow layer, or -1.
    channel: i32,
    // Lights of the cluster that it stands for; 0 where it is one light.
    members: f32,
    pad: f32,
}

struct Lights {
    light: array<Light, 8>,
    count: u32,
}

// What share of a light is kept away: all or nothing, or of a cluster as many as it has lights.
fn kept_of(light: Light, shadow: vec4f) -> f32 {
    if light.channel < 0 {
        return 0.0;
    }
    let share = shadow[light.channel];
    return select(step(0.5, share), round(share * light.members) / max(light.members, 1.0), light.members > 0.0);
}

// From a place toward a light.
fn toward(light: Light, place: vec3f) -> vec3f {
    return normalize(light.vector - place * light.is_point);
}
