// The outward direction of the object's form at a place, of length up to 1; short where unsure.
fn form_at(place: vec3f, object: u32) -> vec3f {
    let grid = grids[object];
    let at = clamp((place - grid.origin) / grid.cell, vec3f(0.5), vec3f(grid.cells) - 0.5);
    let uvw = (at + vec3f(0.0, 0.0, f32(object) * sampling.form_side))
        / (sampling.form_side * vec3f(1.0, 1.0, sampling.form_objects));
    let outward = textureSampleLevel(form_field, linear, uvw, 0.0).xyz;
    let steep = length(outward);
    return outward * (min(steep * 8.0, 1.0) / max(steep, 1e-6));
}
