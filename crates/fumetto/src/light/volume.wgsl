// Nailboard shadow volumes (McGuire & Fein 2004, section 1.4): for each puff the volume that it keeps
// from a light, as one front and one back polygon that coincide in image space. Every pixel's depth is
// displaced by the puff's own height, so that shadows end along wavy curves.
//
// Ours: both depths come from where the pixel's ray passes the volume's axis, so that the two polygons
// agree in perspective too, and a polygon that would pass behind the camera just covers the screen: the
// camera may stand inside a volume. The passage is worked out for every pixel: between corners it does not
// change evenly.

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
    // In the atlas: texel of the puff's middle, and texels from there to the volume's side.
    @location(0) @interpolate(flat) cut: vec4f,
    // Beginning (in the puff's height) and end along the axis, erosion, radius.
    @location(1) @interpolate(flat) span: vec4f,
    @location(2) @interpolate(flat) middle: vec3f,
    @location(3) @interpolate(flat) axis: vec3f,
    // 1 on the back polygon.
    @location(4) @interpolate(flat) back: u32,
}

// Closest approach of a ray from the camera and the axis: how far to the axis's side (in radii), along the
// ray, along the axis.
fn passage_of(ray: vec3f, middle: vec3f, axis: vec3f, radius: f32) -> vec3f {
    let normal = cross(ray, axis);
    let sine2 = max(dot(normal, normal), 1e-8);
    let side = dot(middle, normal) * inverseSqrt(sine2) / radius;
    return vec3f(side, dot(cross(middle, axis), normal) / sine2, dot(cross(middle, ray), normal) / sine2);
}

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> Corner {
    let puff = puffs[list[index / 8u]];
    let style = styles[puff_object(puff)];
    let volume = volume_of(puff, style, lights.light[casting.light]);
    // Back polygon first: what it adds, the front one may take away again. Their windings differ.
    let is_back = index % 8u < 4u;
    let corner = SQUARE[index % 4u];
    let side = select(-corner.y, corner.y, is_back);
    let px = volume.px + volume.along_px * corner.x + volume.side_px * side;
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
    return Corner(
        clip_of(px, 0.5),
        vec4f(middle * texels, (rim - middle) * texels),
        vec4f(volume.first, volume.last, puff_fade(puff).x, volume.radius),
        volume.middle,
        volume.axis,
        u32(is_back),
    );
}

@fragment
fn fragment(corner: Corner) -> @builtin(frag_depth) f32 {
    let ray = ray_of(corner.position.xy * casting.step);
    let passage = passage_of(ray, corner.middle, corner.axis, corner.span.w);
    let normal = cross(ray, corner.axis);
    let along = dot(ray, corner.axis);
    // Metres along the ray to one across the volume, and to one along the axis.
    let slope = vec2f(inverseSqrt(max(dot(normal, normal), 1e-8)), 1.0 / select(along, 1e-6, abs(along) < 1e-6));
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
    return depth_of(select(near, far, corner.back == 1u));
}
