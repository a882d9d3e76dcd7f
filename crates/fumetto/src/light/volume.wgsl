// Nailboard shadow volumes (McGuire & Fein 2004, section 1.4): for each puff the volume that it keeps
// from a light, as one front and one back polygon that coincide in image space. Every pixel's depth is
// displaced by the puff's own height, so that shadows end along wavy curves.
//
// Ours: both depths come from where the pixel's ray passes the volume's axis, so that the two polygons
// agree in perspective too, and a polygon that would pass behind the camera just covers the screen: the
// camera may stand inside a volume.

// Work out the ray's passage for every pixel instead of between corners: for volumes about the camera,
// where it does not change evenly over the screen.
override EXACT: bool = false;

struct Casting {
    light: u32,
    // Pixels of the picture to one of the stencil's.
    step: f32,
}

@group(0) @binding(1) var<uniform> atlas: Atlas;
@group(0) @binding(2) var<uniform> casting: Casting;
@group(0) @binding(3) var<uniform> lights: Lights;
@group(0) @binding(4) var<storage, read> puffs: array<Puff>;
@group(0) @binding(5) var<storage, read> list: array<u32>;
@group(0) @binding(6) var<storage, read> styles: array<ObjectStyle>;
@group(0) @binding(7) var atlas_texture: texture_2d<f32>;

struct Corner {
    @builtin(position) position: vec4f,
    // Where the ray passes the axis: to its side (in radii), along the ray, along the axis.
    @location(0) passage: vec3f,
    // In the atlas: texel of the puff's middle, and texels from there to the volume's side.
    @location(1) @interpolate(flat) cut: vec4f,
    // Beginning (in the puff's height) and end along the axis, erosion, radius.
    @location(2) @interpolate(flat) span: vec4f,
    // Metres along the ray to one across the volume, and to one along the axis; 1 on the back polygon.
    @location(3) @interpolate(flat) slope: vec3f,
    @location(4) @interpolate(flat) middle: vec3f,
    @location(5) @interpolate(flat) axis: vec3f,
}

// Closest approach of a ray from the camera and the axis.
fn passage_of(ray: vec3f, middle: vec3f, axis: vec3f, radius: f32) -> vec3f {
    let normal = cross(ray, axis);
    let sine2 = max(dot(normal, normal), 1e-8);
    let side = dot(middle, normal) * inverseSqrt(sine2) / radius;
    return vec3f(side, dot(cross(middle, axis), normal) / sine2, dot(cross(middle, ray), normal) / sine2);
}

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> Corner {
    let puff = puffs[list[index / 12u]];
    let style = styles[puff_object(puff)];
    let volume = volume_of(puff, style, lights.light[casting.light]);
    // Back polygon first: what it adds, the front one may take away again. Their windings differ.
    let is_back = index % 12u < 6u;
    let corner = index % 6u;
    let along = select(-1.0, 1.0, corner == 1u || corner == 2u || corner == 4u);
    let upper = corner == 2u || corner == 4u || corner == 5u;
    let side = select(-1.0, 1.0, upper == is_back);
    let px = volume.px + volume.along_px * along + volume.side_px * side;
    // The puff's picture, cut through its middle across the light's direction.
    let to_middle = volume.middle / max(-volume.middle.z, view.near);
    let normal = cross(to_middle, volume.axis);
    let across = -normalize(normal.xy + vec2f(1e-9, 0.0));
    let rotation = puff_rotation(puff);
    let own = vec2f(rotation.x * across.x + rotation.y * across.y, rotation.x * across.y - rotation.y * across.x);
    let level = atlas_level(volume.radius * view.focal_px / max(-volume.middle.z, view.near), atlas);
    let middle = atlas_uv(vec2f(0.0), f32(puff_variant(puff)), level, atlas);
    let rim = atlas_uv(own, f32(puff_variant(puff)), level, atlas);
    let texels = vec2f(atlas.variants, 2.0) * atlas.tile_px;
    let slope = dot(to_middle, volume.axis);
    return Corner(
        clip_of(px, 0.5),
        passage_of(ray_of(px), volume.middle, volume.axis, volume.radius),
        vec4f(middle * texels, (rim - middle) * texels),
        vec4f(volume.first, volume.last, puff_fade(puff).x, volume.radius),
        vec3f(inverseSqrt(max(dot(normal, normal), 1e-8)), 1.0 / select(slope, 1e-6, abs(slope) < 1e-6), f32(is_back)),
        volume.middle,
        volume.axis,
    );
}

@fragment
fn fragment(corner: Corner) -> @builtin(frag_depth) f32 {
    var passage = corner.passage;
    var slope = corner.slope.xy;
    if EXACT {
        let ray = ray_of(corner.position.xy * casting.step);
        passage = passage_of(ray, corner.middle, corner.axis, corner.span.w);
        let normal = cross(ray, corner.axis);
        let along = dot(ray, corner.axis);
        slope = vec2f(inverseSqrt(max(dot(normal, normal), 1e-8)), 1.0 / select(along, 1e-6, abs(along) < 1e-6));
    }
    let texel = textureLoad(atlas_texture, vec2i(corner.cut.xy + corner.cut.zw * clamp(passage.x, -1.0, 1.0)), 0);
    let reach = texel.z * corner.span.w;
    let half = reach * slope.x;
    // Between the beginning, which bulges as the puff does, and the end.
    let first = passage.y + (corner.span.x * reach - passage.z) * slope.y;
    let last = passage.y + (corner.span.y - passage.z) * slope.y;
    let near = max(passage.y - half, min(first, last));
    let far = min(passage.y + half, max(first, last));
    if abs(passage.x) >= 1.0 || texel_margin(texel) <= corner.span.z || near >= far || far <= view.near {
        discard;
    }
    return depth_of(select(near, far, corner.slope.z == 1.0));
}
