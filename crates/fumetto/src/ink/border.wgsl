// The line that one pixel has toward a neighbour which shows something else. Uses `styles` and `pens` of the
// program that it is part of.

// Distance from a plane, in pixels, beyond which a neighbour lies on something else.
const STEP_PX: f32 = 1.5;

// Distance from a puff, in its radii, within which shapes run into each other.
const TOUCH: f32 = 0.5;

// Cosine of the angle, 15 degrees, under which pieces that run into each other look like one.
const TURN: f32 = 0.966;

// None where its share of the pen's width is 0.
struct Border {
    kind: u32,
    share: f32,
}

fn border(kind: u32, share: f32, owned: bool) -> Border {
    return Border(kind, select(0.0, share, owned));
}

// Whether an object has a line where it runs into another; `turned` where the two do not look like one.
fn meets(flags: u32, turned: bool) -> bool {
    return (flags & IMAGE_INK) != 0u || (turned && (flags & HYBRID_INK) != 0u);
}

// Where two objects run into each other, the later one of the scene has the line.
fn meeting(p: Seen, q: Seen, turned: bool, share: f32) -> Border {
    return border(SILHOUETTE, share, meets(p.flags, turned) && (p.object > q.object || !meets(q.flags, turned)));
}

// The line that `p` has toward `q`, where one of them is a puff.
fn puff_border(p: Seen, q: Seen) -> Border {
    let is_image = (p.flags & IMAGE_INK) != 0u;
    let nearer_radius = select(q.radius, p.radius, p.distance < q.distance);
    let step = (q.distance - p.distance) / select(max(p.radius, q.radius), nearer_radius, nearer_radius > 0.0);
    if p.object == q.object {
        // As with ink billboards: the farther apart puffs are, the wider.
        let style = styles[p.object];
        return border(SILHOUETTE, style.ink_inner * clamp(step - 2.0 * style.ink_offset, 0.0, 1.0), is_image);
    }
    if abs(step) > TOUCH {
        return border(SILHOUETTE, 1.0, is_image && step > 0.0);
    }
    let one_is_solid = p.radius == 0.0 || q.radius == 0.0;
    return meeting(p, q, one_is_solid, select(1.0 - abs(step) / TOUCH, 1.0, is_image));
}

// The same between triangles.
fn mesh_border(p: Seen, q: Seen) -> Border {
    let is_image = (p.flags & IMAGE_INK) != 0u;
    let apart = q.place - p.place;
    let off_plane = min(abs(dot(apart, p.normal)), abs(dot(apart, q.normal)));
    if off_plane > STEP_PX * min(p.distance, q.distance) / view.focal_px {
        return border(SILHOUETTE, 1.0, is_image && p.distance < q.distance);
    }
    let turn = dot(p.normal, q.normal);
    let merged = p.piece != q.piece && turn < TURN;
    if p.object != q.object {
        return meeting(p, q, merged, 1.0);
    }
    // Of two faces, the one that is seen better has the line: that does not change from pixel to pixel.
    let owned = p.facing > q.facing || (p.facing == q.facing && p.id > q.id);
    if is_image && p.material != q.material && (pens[pen_number(p.object, MATERIAL)].flags & DRAWS) != 0u {
        return border(MATERIAL, 1.0, owned);
    }
    let is_sharp = meets(p.flags, merged) && (merged || turn < styles[p.object].ink_crease);
    return border(CREASE, 1.0, owned && is_sharp);
}

fn border_of(p: Seen, q: Seen) -> Border {
    if q.id == 0u {
        // Not where something that is drawn already hides how `p` goes on.
        return border(SILHOUETTE, 1.0, (p.flags & IMAGE_INK) != 0u && q.distance > p.distance);
    }
    if p.radius > 0.0 || q.radius > 0.0 {
        return puff_border(p, q);
    }
    return mesh_border(p, q);
}
