// Adds the hard shadows that one light of a cluster throws to those that are known.

struct Gathering {
    // 1 in channels that hold shares already; the others tell of hard shadows, where they are above one half.
    soft: vec4f,
    // 1 in the cluster's channel.
    channel: vec4f,
    // Of the picture, in samples.
    size: vec2f,
    // Lights of the cluster.
    members: f32,
}

@group(0) @binding(0) var<uniform> gathering: Gathering;
@group(0) @binding(1) var known: texture_2d<f32>;
@group(0) @binding(2) var kept: texture_2d<f32>;
@group(0) @binding(3) var linear: sampler;

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let at = position.xy / gathering.size;
    let before = textureSampleLevel(known, linear, at, 0.0);
    let hard = select(vec4f(0.0), vec4f(1.0), before >= vec4f(0.5));
    let shadow = select(hard, before, gathering.soft > vec4f(0.5));
    let one = select(0.0, 1.0, textureSampleLevel(kept, linear, at, 0.0).x >= 0.5);
    // Counted in whole lights: eight bits hold shares of few exactly enough.
    let own = select(vec4f(0.0), shadow, gathering.soft > vec4f(0.5));
    let count = round(own * gathering.members) + one;
    return select(shadow, count / gathering.members, gathering.channel > vec4f(0.5));
}
