// The colour that an object's ramp has for an amount of light.
fn ramp_colour(ramps: texture_2d<f32>, amount: f32, row: f32) -> vec3f {
    let columns = i32(textureDimensions(ramps).x);
    let column = clamp(i32(amount * f32(columns)), 0, columns - 1);
    return textureLoad(ramps, vec2i(column, i32(row)), 0).rgb;
}

// What one light adds on a surface that it reaches.
fn diffuse(light: Light, normal: vec3f, toward_light: vec3f, wrap: f32) -> f32 {
    return light.intensity * max((dot(normal, toward_light) + wrap) / (1.0 + wrap), 0.0);
}
