// Nailboard shadow volumes (McGuire & Fein 2004, section 1.4): for each puff the volume that it keeps
// from a light, as one front and one back polygon that coincide in image space. Every pixel's depth is
// displaced by the puff's own height, so that shadows end along wavy curves.
//
// Ours: both depths come from the ray through the pixel, so that the two polygons agree exactly in
// perspective too, and a polygon that would pass behind the camera just covers the screen: the camera
// may stand inside a volume.

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
@group(0) @binding(8) var atlas_sampler: sampler;

struct Corner {
    @builtin(position) position: vec4f,
    // Middle of the puff in view space, radius of the volume.
    @location(0) @interpolate(flat) middle: vec4f,
    // Direction in which the light travels in view space; 1 on the back polygon.
    @location(1) @interpolate(flat) axis: vec4f,
    // Beginning and end of the volume along its axis, erosion, level of the atlas.
    @location(2) @interpolate(flat) span: vec4f,
    // Cosine and sine of the puff's rotation, variant.
    @location(3) @interpolate(flat) look: vec3f,
}

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> Corner {
    let puff = puffs[list[index / 12u]];
    let style = styles[puff_object(puff)];
    let volume = volume_of(puff, style, lights.light[casting.light]);
    // Back polygon first: what it adds, the front one may take away again. Their windings differ.
    let is_back = index % 12u < 6u;
    let corner = index % 6u;
    let right = (corner == 1u || corner == 2u || corner == 4u);
    let upper = (corner == 2u || corner == 4u || corner == 5u);
    let along = select(-1.0, 1.0, right);
    let side = select(-1.0, 1.0, upper == is_back);
    let px = volume.px + volume.along_px * along + volume.side_px * side;
    return Corner(
        clip_of(px, 0.5),
        vec4f(volume.middle, volume.radius),
        vec4f(volume.axis, f32(is_back)),
        vec4f(volume.first, volume.last, puff_fade(puff).x, atlas_level(volume.radius * view.focal_px / max(-volume.middle.z, view.near), atlas)),
        vec3f(puff_rotation(puff), f32(puff_variant(puff))),
    );
}

@fragment
fn fragment(corner: Corner) -> @builtin(frag_depth) f32 {
    let ray = ray_of(corner.position.xy * casting.step);
    let middle = corner.middle.xyz;
    let axis = corner.axis.xyz;
    // Closest approach of the ray and the axis: at `t` along the ray and `s` along the axis.
    let normal = cross(ray, axis);
    let sine2 = max(dot(normal, normal), 1e-8);
    let lateral = dot(middle, normal) * inverseSqrt(sine2) / corner.middle.w;
    let t = dot(cross(middle, axis), normal) / sine2;
    let s = dot(cross(middle, ray), normal) / sine2;
    // The puff's height where its picture is cut across the light's direction.
    let flat_axis = normalize(vec2f(axis.x, axis.y) + vec2f(1e-6, 0.0));
    let facing = sign(dot(normal, vec3f(-flat_axis.y, flat_axis.x, 0.0)));
    let p = vec2f(-flat_axis.y, flat_axis.x) * lateral * facing;
    let rotation = corner.look.xy;
    let own = vec2f(rotation.x * p.x + rotation.y * p.y, rotation.x * p.y - rotation.y * p.x);
    let uv = atlas_uv(own, corner.look.z, corner.span.w, atlas);
    let texel = textureSampleLevel(atlas_texture, atlas_sampler, uv, corner.span.w);
    let reach = texel.z * corner.middle.w;
    let half = reach * inverseSqrt(sine2);
    var near = t - half;
    var far = t + half;
    // Between the beginning, which bulges as the puff does, and the end.
    let slope = dot(ray, axis);
    let inverse = 1.0 / select(slope, 1e-6, abs(slope) < 1e-6);
    let first = t + (corner.span.x * reach - s) * inverse;
    let last = t + (corner.span.y - s) * inverse;
    near = max(near, min(first, last));
    far = min(far, max(first, last));
    if abs(lateral) >= 1.0 || texel.w <= corner.span.z || near >= far || far <= view.near {
        discard;
    }
    return depth_of(select(near, far, corner.axis.w == 1.0));
}
