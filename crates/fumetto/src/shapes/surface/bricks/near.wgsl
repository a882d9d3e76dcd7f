// The density that a file tells. `near.wgsl` says the same of particles.

struct Near {
    units: Units,
}

// Gradient and value of the density, which is linear between voxels; the gradient over a voxel to either side, which is
// without jumps.
fn density_at(place: vec3f) -> vec4f {
    let at = cell_of(place);
    let step = vec2f(1.0, 0.0);
    let rises = vec3f(
        density_of(sample_at(at + step.xyy)) - density_of(sample_at(at - step.xyy)),
        density_of(sample_at(at + step.yxy)) - density_of(sample_at(at - step.yxy)),
        density_of(sample_at(at + step.yyx)) - density_of(sample_at(at - step.yyx)),
    );
    return vec4f(slope_in_world(0.5 * rises), density_of(sample_at(at)));
}

fn field_at(place: vec3f, near: Near) -> vec4f {
    return field_of(density_at(place), place);
}
