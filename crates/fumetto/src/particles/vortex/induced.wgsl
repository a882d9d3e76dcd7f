// The velocity that all vortices together give to a place: Biot and Savart's sum, by a walk through the tree
// that takes a node for all that is below it where it is far enough away (Barnes & Hut 1986).

const FOUR_PI: f32 = 12.566371;

// Velocity around a vortex is this times strength × offset / 4π: the high-order algebraic kernel of
// Winckelmans & Leonard 1993, "Contributions to vortex particle methods".
fn near_kernel(distance2: f32, core2: f32) -> f32 {
    let inverse = inverseSqrt(distance2 + core2);
    let inverse2 = inverse * inverse;
    return (distance2 + 2.5 * core2) * inverse2 * inverse2 * inverse;
}

// Its derivative by distance, over distance.
fn near_slope(distance2: f32, core2: f32) -> f32 {
    let inverse = inverseSqrt(distance2 + core2);
    let inverse2 = inverse * inverse;
    return -3.0 * (distance2 + 3.5 * core2) * inverse2 * inverse2 * inverse2 * inverse;
}

fn of_leaf(leaf: Leaf, p: vec3f) -> vec3f {
    let offset = p - leaf.position;
    return near_kernel(dot(offset, offset), leaf.core2) * cross(leaf.strength, offset);
}

// The first two terms of Taylor's series about the node's centre.
fn of_node(node: Node, offset: vec3f, distance2: f32) -> vec3f {
    let turned = vec3f(
        node.dipole_y.z - node.dipole_z.y,
        node.dipole_z.x - node.dipole_x.z,
        node.dipole_x.y - node.dipole_y.x,
    );
    let along = vec3f(dot(node.dipole_x, offset), dot(node.dipole_y, offset), dot(node.dipole_z, offset));
    return near_kernel(distance2, node.core2) * (cross(node.strength, offset) - turned)
        - near_slope(distance2, node.core2) * cross(along, offset);
}

fn induced(p: vec3f, places: u32) -> vec3f {
    var sum = vec3f(0.0);
    if places == 0u {
        return sum;
    }
    var at = 1u;
    loop {
        if at >= places {
            sum += of_leaf(leaves[at - places], p);
        } else {
            let offset = p - nodes[at].center;
            let distance2 = dot(offset, offset);
            let opening = nodes[at].opening;
            // A place that is not a number is not near anything: it must not visit every leaf.
            if opening > 0.0 && distance2 < opening * opening {
                at *= 2u;
                continue;
            }
            if opening >= 0.0 {
                sum += of_node(nodes[at], offset, distance2);
            }
        }
        // To the next one that is not below: up as long as this was the second of two.
        at++;
        at >>= countTrailingZeros(at);
        if at == 1u {
            break;
        }
    }
    return sum / FOUR_PI;
}
