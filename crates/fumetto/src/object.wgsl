// How one object is drawn; an array of these, by the object's number, goes with every frame. It is uniform:
// software rasterisers read it several times faster than storage.
struct ObjectStyle {
    // Width of an outline: the larger of the two counts.
    ink_width_px: f32,
    ink_width_m: f32,
    // Distance of the ink billboard behind its puff, in the puff's widths.
    ink_offset: f32,
    ink_inner: f32,
    ink_lit_thinning: f32,
    form: f32,
    wrap: f32,
    opacity: f32,
    // Which row of the ramp texture.
    ramp_row: f32,
    shadow_reach: f32,
    shadow_start: f32,
    shadow_size: f32,
    // Bit 0: has ink billboards. Bit 1: throws shadows. Bit 2: is drawn in this cel. Bits 3 to 5: how else
    // its lines are found. Bit 6: shows shadows. Bit 7: is a volume. Bit 8: is
    // not painted.
    flags: u32,
    form_scale: f32,
    // Share of a mesh's own colours.
    material: f32,
    // Cosine between the surface and the viewer under which there is ink.
    ink_facing: f32,
    // Cosine of the angle above which faces make a crease.
    ink_crease: f32,
    // Layers of detail inside.
    details: u32,
    // Of a volume: how much its normals count for tones.
    relief: f32,
    // Of a volume: light that it gives off by itself.
    glow: f32,
}

const HAS_INK: u32 = 1u;
const THROWS_SHADOW: u32 = 2u;
const IN_CEL: u32 = 4u;
const ANGLE_INK: u32 = 8u;
const IMAGE_INK: u32 = 16u;
const HYBRID_INK: u32 = 32u;
const SHOWS_SHADOWS: u32 = 64u;
const IS_VOLUME: u32 = 128u;
const IS_MASK: u32 = 256u;

// Objects that there is room for.
const MAX_OBJECTS: u32 = 64u;
