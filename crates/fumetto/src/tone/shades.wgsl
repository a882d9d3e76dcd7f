// From light to colour in other ways than along a ramp's only row.

// The highlight's term (Blinn 1977) of one light on a surface that it reaches.
fn blinn_phong(light: Light, normal: vec3f, toward_light: vec3f, toward_eye: vec3f, gloss: f32) -> f32 {
    let between = normalize(toward_light + toward_eye);
    let shine = pow(max(dot(normal, between), 1e-6), gloss);
    return select(0.0, light.intensity * shine, dot(normal, toward_light) > 0.0);
}

// Gooch et al., "A Non-Photorealistic Lighting Model for Automatic Technical Illustration", 1998, equation 2;
// on encoded colours, as in the paper. `own` is the mesh's own colour, linear.
fn cool_to_warm(tone: ToneStyle, own: vec3f, amount: f32) -> vec3f {
    let paint = select(encoded(decoded(tone.paint) * own), tone.paint, all(own == vec3f(1.0)));
    return mix(min(tone.cool + tone.alpha * paint, vec3f(1.0)), min(tone.warm + tone.beta * paint, vec3f(1.0)), min(amount, 1.0));
}

// The row of a ramp that has several (Barla, Thollot & Markosian, "X-Toon", 2006, section 3).
fn row_of(tone: ToneStyle, facing: f32, place: vec3f, distance: f32) -> f32 {
    let ends = tone.axis_ends;
    var down = 0.0;
    if tone.axis == AXIS_DEPTH {
        down = log(distance / ends.x) / log(ends.y / ends.x);
    } else if tone.axis == AXIS_FACING {
        down = 1.0 - pow(max(facing, 1e-6), ends.x);
    } else {
        down = (length(place - tone.focus) - ends.x) / (ends.y - ends.x);
    }
    return f32(tone.first_row + clamp(i32(floor(down * f32(tone.row_count))), 0, tone.row_count - 1));
}
