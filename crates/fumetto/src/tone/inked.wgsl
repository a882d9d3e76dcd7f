// A sample of a cel with its ink, linear and times its alpha; both are straight and encoded.
fn inked(cel: vec4f, line: Line) -> vec4f {
    return mix(multiplied(cel), multiplied(line.colour), line.share);
}

fn multiplied(colour: vec4f) -> vec4f {
    return vec4f(decoded(colour.rgb) * colour.a, colour.a);
}
