// What a line of sight finds.
struct Marched {
    // Of the surface: puff + 1, bits of the depth, normal, and colour. 0 where there is none.
    @location(0) hit: vec4u,
    // How much of each light that throws shadows reaches what is seen of the surface.
    @location(1) light: vec4f,
    // What a camera would see: linear, times its opacity.
    @location(2) soft: vec4f,
}
