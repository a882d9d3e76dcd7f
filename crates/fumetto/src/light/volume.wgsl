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
    // Middle of the puff in view space, radius of the volume.
    @location(0) @interpolate(flat) ball: vec4f,
    // In pairs: texel of the puff's middle in the atlas, in eighths; texels from there to the volume's side;
    // beginning (in the puff's height) and end along the axis; erosion, and 1 on the back polygon. Packed,
    // because a software rasteriser sets up each value that a triangle carries.
    @location(1) @interpolate(flat) cut: vec4u,
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
    let eighths = vec2u(round(middle * texels * 8.0));
    return Corner(
        clip_of(px, 0.5),
        vec4f(volume.middle, volume.radius),
        vec4u(
            eighths.x | (eighths.y << 16u),
            pack2x16float((rim - middle) * texels),
            pack2x16float(vec2f(volume.first, volume.last)),
            pack2x16unorm(vec2f(puff_fade(puff).x, f32(is_back))),
        ),
    );
}

@fragment
fn fragment(corner: Corner) -> @builtin(frag_depth) f32 {
    let ray = ray_of(corner.position.xy * casting.step);
    let axis = axis_of(corner.ball.xyz, lights.light[casting.light]);
    let passage = passage_of(ray, corner.ball.xyz, axis, corner.ball.w);
    let normal = cross(ray, axis);
    let along = dot(ray, axis);
    // Metres along the ray to one across the volume, and to one along the axis.
    let slope = vec2f(inverseSqrt(max(dot(normal, normal), 1e-8)), 1.0 / select(along, 1e-6, abs(along) < 1e-6));
    let middle = vec2f(vec2u(corner.cut.x & 0xffffu, corner.cut.x >> 16u)) / 8.0;
    let at = middle + unpack2x16float(corner.cut.y) * clamp(passage.x, -1.0, 1.0);
    let span = unpack2x16float(corner.cut.z);
    let erosion_back = unpack2x16unorm(corner.cut.w);
    let texel = textureLoad(atlas_texture, vec2i(at), 0);
    let reach = texel.z * corner.ball.w;
    let half = reach * slope.x;
    // Between the beginning, which bulges as the puff does, and the end.
    let first = passage.y + (span.x * reach - passage.z) * slope.y;
    let last = passage.y + (span.y - passage.z) * slope.y;
    let near = max(passage.y - half, min(first, last));
    let far = min(passage.y + half, max(first, last));
    if abs(passage.x) >= 1.0 || texel_margin(texel) <= erosion_back.x || near >= far || far <= view.near {
        discard;
    }
    return depth_of(select(near, far, erosion_back.y == 1.0));
}
