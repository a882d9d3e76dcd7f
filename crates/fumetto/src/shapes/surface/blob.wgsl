// A particle as the field sees it: everything that a puff's radius and mass depend on is settled here.
struct Blob {
    center: vec3f,
    // Zero when there is none.
    radius: f32,
    mass: f32,
    // 1 / radius².
    inverse_square: f32,
}

// As it lies in memory: a processor that draws takes as long to read one number as to read four.
struct PackedBlob {
    ball: vec4f,
    weight: vec4f,
}

fn packed(blob: Blob) -> PackedBlob {
    return PackedBlob(vec4f(blob.center, blob.radius), vec4f(blob.mass, blob.inverse_square, 0.0, 0.0));
}

fn unpacked(blob: PackedBlob) -> Blob {
    return Blob(blob.ball.xyz, blob.ball.w, blob.weight.x, blob.weight.y);
}

// Beyond this (in metres, and in units of mass) single floats no longer hold squares and sums; below it,
// inverses. NaN is beyond it too.
const MOST: f32 = 1e12;
const LEAST: f32 = 1e-6;

// Compares bits, for compilers may assume that there is no NaN.
fn is_sane(value: f32) -> bool {
    return (bitcast<u32>(value) & 0x7fffffffu) <= bitcast<u32>(MOST);
}
