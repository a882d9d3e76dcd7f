// Ink where a surface is seen edge-on: where the cosine between its normal and the viewer is small
// (Real-Time Rendering, section 11.2: surface angle). Lines get wider where the surface bends slowly.

@group(0) @binding(1) var<uniform> styles: array<ObjectStyle, MAX_OBJECTS>;
@group(0) @binding(2) var<uniform> lights: Lights;
@group(0) @binding(3) var<storage, read> puffs: array<Puff>;
@group(0) @binding(4) var<uniform> pens: array<Pen, MAX_PENS>;
@group(0) @binding(5) var<storage, read> sources: array<Source>;
@group(0) @binding(6) var<storage, read> vertices: array<Vertex>;
@group(0) @binding(7) var<storage, read> triangles: array<Triangle>;
@group(0) @binding(8) var<storage, read> parts: array<Part>;
@group(0) @binding(9) var textures: texture_2d_array<f32>;
@group(0) @binding(10) var textures_sampler: sampler;
@group(0) @binding(11) var id_layer: texture_2d<u32>;
@group(0) @binding(12) var depth_layer: texture_depth_2d;
@group(0) @binding(13) var normals: texture_2d<f32>;

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec2u {
    let px = vec2i(position.xy);
    let id = textureLoad(id_layer, px, 0).x;
    if id == 0u {
        discard;
    }
    let is_puff = (id & TRIANGLE_BIT) == 0u;
    let puff = puffs[select(0u, id - 1u, is_puff)];
    let object = select(parts[triangles[select(id & ~TRIANGLE_BIT, 0u, is_puff)].part].object, puff_object(puff), is_puff);
    let style = styles[object];
    let number = pen_number(object, SILHOUETTE);
    if (style.flags & ANGLE_INK) == 0u || (pens[number].flags & DRAWS) == 0u {
        discard;
    }
    let ray = world_ray(position.xy);
    let place = view.world_from_view[3].xyz + ray * distance_of(textureLoad(depth_layer, px, 0));
    let toward_viewer = -normalize(ray);
    var normal = textureLoad(normals, px, 0).xyz;
    var facing = 0.0;
    if is_puff {
        // Bent toward the form of the cloud, normals may look away where a puff does not.
        facing = max(dot(normal, toward_viewer), dot(normalize(place - puff.center), toward_viewer));
    } else {
        normal = mesh_surface(id & ~TRIANGLE_BIT, position.xy).normal;
        facing = dot(normal, toward_viewer);
    }
    if facing >= style.ink_facing * thinned(style, normal, place) {
        discard;
    }
    let opacity = select(1.0, puff_fade(puff).y, is_puff);
    return vec2u(number + 1u, u32(round(255.0 * opacity)));
}
