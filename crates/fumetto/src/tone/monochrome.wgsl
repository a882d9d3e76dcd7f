// The grey that is as bright as an encoded colour: its luminance by the weights of Rec. 709, encoded.
fn monochrome(colour: vec3f) -> vec3f {
    return encoded(vec3f(dot(decoded(colour), vec3f(0.2126, 0.7152, 0.0722))));
}
