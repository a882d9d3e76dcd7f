// Where pre-shaded sprites lie: a column a variant, a row a rotation, objects below each other.
const SPRITE_PX: f32 = 64.0;
const ROTATIONS: u32 = 16u;
