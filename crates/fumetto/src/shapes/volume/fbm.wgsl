// Fractal noise (Perlin, "An Image Synthesizer", 1985). Uses `recipe` of the program that it is part of.

// What several octaves together hardly ever exceed; the rest is cut off.
const REACHED: f32 = 2.0 / 3.0;

// Octaves of noise, each weaker by the persistence and finer by the lacunarity: from -1 to 1, or from 0 where
// octaves billow.
fn fbm(p: vec3f, seed: u32) -> f32 {
    var sum = 0.0;
    var most = 0.0;
    var strength = 1.0;
    var at = p;
    for (var octave = 0u; octave < recipe.octaves; octave++) {
        let value = noise(at, seed + octave).w;
        sum += strength * select(value, abs(value), recipe.billow != 0u);
        most += strength;
        strength *= recipe.persistence;
        at *= recipe.lacunarity;
    }
    return clamp(sum / (REACHED * max(most, 1e-6)), -1.0, 1.0);
}
