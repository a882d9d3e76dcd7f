// Brings a mesh's own colours to a few, for a drawing that is filled with paint from few pots (Lake et al.
// 2000): so many values, so many strengths of each hue. Hues stay, save for a few degrees, so that steps in
// value do not change them. Works on encoded colours, in which steps look even.

// Hues round the circle: as many as a large box of paint has.
const HUES: f32 = 24.0;

fn hue_of(c: vec3f, value: f32, chroma: f32) -> f32 {
    let d = max(chroma, 1e-6);
    let from_red = (c.g - c.b) / d;
    let from_green = 2.0 + (c.b - c.r) / d;
    let from_blue = 4.0 + (c.r - c.g) / d;
    return select(select(from_blue, from_green, c.g == value), from_red, c.r == value) / 6.0;
}

fn quantised(linear: vec3f, steps: f32) -> vec3f {
    let c = encoded(clamp(linear, vec3f(0.0), vec3f(1.0)));
    let value = max(c.r, max(c.g, c.b));
    let chroma = value - min(c.r, min(c.g, c.b));
    let hue = fract(round(hue_of(c, value, chroma) * HUES) / HUES + 1.0);
    let strength = round(chroma / max(value, 1e-6) * steps) / steps;
    let pure = clamp(abs(fract(vec3f(hue) + vec3f(1.0, 2.0 / 3.0, 1.0 / 3.0)) * 6.0 - 3.0) - 1.0, vec3f(0.0), vec3f(1.0));
    return decoded(round(value * steps) / steps * mix(vec3f(1.0), pure, strength));
}
