// Variant and rotation come from the number of the particle's birth, so that it keeps them for life.
fn puff_look(birth: u32, seed: u32, first_variant: u32, variants: u32, object: u32) -> u32 {
    let key = pcg(birth + pcg(seed));
    let variant = first_variant + key % variants;
    return variant | (object << 8u) | (pcg(key) & 0xffff0000u);
}
