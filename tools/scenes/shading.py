"""Writes `scenes/shading.glb`: a dragon's hatchling, to try shadings on.

Large smooth lobes, grown together, show how a shading turns a form; scales, the belly's plates and the
rings of the horns are the fine relief that some shadings bring out and others lose. The skin is the
surface round a field; its relief is finer than its triangles, and lies in the normals.

Run it from the repository's root: `python3 tools/scenes/shading.py`; it needs NumPy.
"""

import numpy as np

from glb import Glb, unit
from solids import ball, gradient, lathe, smooth_union, surface, tube, turned

CELL = 0.043
EYE_AT, EYE_RADIUS = np.array([0.235, 1.66, 0.415]), 0.15


def smoothstep(low, high, value):
    t = np.clip((value - low) / (high - low), 0.0, 1.0)
    return t * t * (3.0 - 2.0 * t)


def ellipsoid(points, centre, radii):
    """Nearly the distance to an ellipsoid (Quilez's bound, which is exact for balls)."""
    p = points - centre
    far = np.linalg.norm(p / radii, axis=1)
    return far * (far - 1.0) / np.maximum(np.linalg.norm(p / np.square(radii), axis=1), 1e-9)


def capsule(points, start, end, radius_start, radius_end):
    start, end = np.asarray(start, float), np.asarray(end, float)
    along = end - start
    t = np.clip((points - start) @ along / (along @ along), 0.0, 1.0)
    away = np.linalg.norm(points - start - t[:, None] * along, axis=1)
    return away - (radius_start + t * (radius_end - radius_start))


# The tail's line: x, y, z and radius.
TAIL = np.array([
    (0.0, 0.3, -0.42, 0.34), (0.25, 0.2, -0.74, 0.26), (0.68, 0.16, -0.82, 0.2), (1.06, 0.15, -0.58, 0.165),
    (1.27, 0.2, -0.22, 0.135), (1.38, 0.38, 0.02, 0.11), (1.4, 0.62, 0.1, 0.088), (1.3, 0.84, 0.1, 0.066),
])
SPIKES = [
    # Along the middle, from the brow over the back: foot, height and length, leaning back.
    ((1.98, 0.02), 0.13), ((1.93, -0.24), 0.16), ((1.72, -0.42), 0.17), ((1.44, -0.44), 0.17),
    ((1.16, -0.46), 0.18), ((0.88, -0.56), 0.19), ((0.6, -0.64), 0.18), ((0.38, -0.72), 0.14),
]


def through(points, pieces):
    """More points on a smooth line through these (Catmull–Rom)."""
    ends = np.concatenate([[2.0 * points[0] - points[1]], points, [2.0 * points[-1] - points[-2]]])
    line = []
    for p0, p1, p2, p3 in zip(ends, ends[1:], ends[2:], ends[3:]):
        for t in np.arange(pieces) / pieces:
            line.append(0.5 * (
                2 * p1 + (p2 - p0) * t + (2 * p0 - 5 * p1 + 4 * p2 - p3) * t**2
                + (3 * p1 - p0 - 3 * p2 + p3) * t**3))
    return np.array(line + [points[-1]])


def folded(points):
    return np.abs(points) * (1.0, 0.0, 0.0) + points * (0.0, 1.0, 1.0)


def body(points):
    """Both halves at once: x is folded over, save for the tail."""
    p = folded(points)
    trunk = smooth_union([
        ellipsoid(p, (0.0, 0.6, -0.02), (0.58, 0.62, 0.54)),
        ellipsoid(p, (0.0, 0.52, 0.16), (0.47, 0.47, 0.44)),
        ellipsoid(p, (0.0, 1.12, -0.08), (0.32, 0.36, 0.3)),
        ellipsoid(p, (0.44, 0.3, 0.16), (0.3, 0.31, 0.4)),
        ellipsoid(p, (0.5, 0.1, 0.54), (0.2, 0.13, 0.26)),
    ], 0.12)
    toes = [ellipsoid(p, (0.5 + dx, 0.08, 0.74), (0.085, 0.085, 0.11)) for dx in (-0.13, 0.0, 0.13)]
    arms = [
        capsule(p, (0.4, 0.98, 0.12), (0.52, 0.74, 0.36), 0.14, 0.115),
        capsule(p, (0.52, 0.74, 0.36), (0.34, 0.66, 0.58), 0.11, 0.105),
    ]
    head = smooth_union([
        ellipsoid(p, (0.0, 1.66, 0.06), (0.5, 0.44, 0.45)),
        ellipsoid(p, (0.0, 1.45, 0.44), (0.33, 0.2, 0.32)),
        ellipsoid(p, (0.29, 1.48, 0.22), (0.22, 0.2, 0.24)),
        ellipsoid(p, (0.13, 1.56, 0.67), (0.1, 0.085, 0.09)),
        capsule(p, (0.1, 1.8, 0.43), (0.4, 1.86, 0.26), 0.055, 0.075),
    ], 0.1)
    # Sockets for the eyes, a smile, nostrils.
    head = -smooth_union([-head, ellipsoid(p, EYE_AT + (0.0, 0.0, 0.035), (0.165, 0.165, 0.15))], 0.04)
    smile_y = 1.385 + 0.25 * p[:, 0] ** 2 + 0.55 * np.clip(p[:, 0] - 0.2, 0.0, 1.0) ** 2
    lips = np.exp(-(((p[:, 1] - smile_y) / 0.034) ** 2))
    lips *= smoothstep(0.1, 0.22, p[:, 2]) * smoothstep(0.1, 0.02, np.abs(head))
    head = head + 0.062 * lips
    nostril = ellipsoid(p, (0.15, 1.585, 0.745), (0.046, 0.036, 0.06))
    head = -smooth_union([-head, nostril], 0.035)
    ears = ear(p)
    line = through(TAIL, 3)
    tail = smooth_union([
        capsule(points, a[:3], b[:3], a[3], b[3]) for a, b in zip(line, line[1:])
    ], 0.06)
    whole = smooth_union([trunk, *toes], 0.05)
    whole = smooth_union([whole, *arms], 0.06)
    whole = smooth_union([whole, tail], 0.12)
    whole = smooth_union([whole, head], 0.07)
    whole = smooth_union([whole, ears, wing(p)], 0.05)
    spikes = [capsule(p, (0.0, y, z), (0.0, y + 1.1 * tall * (0.9 if y > 1.5 else 0.55),
        z - tall * (0.5 if y > 1.8 else 1.0)), 0.09, 0.042)
              for (y, z), tall in SPIKES]
    return smooth_union([whole, *spikes], 0.05)


def fan(p, root, tips, thick, web):
    """Ribs from a root, with skin between them that hangs in: ears and wings."""
    root, tips = np.asarray(root, float), np.asarray(tips, float)
    distances = [capsule(p, root, tip, thick, 0.75 * thick) for tip in tips]
    normal = np.cross(tips[0] - root, tips[-1] - root)
    normal /= np.linalg.norm(normal)
    for a, b in zip(tips, tips[1:]):
        # The web between two ribs: inside both of their lines, and short of a bay between the tips.
        flat = np.abs((p - root) @ normal) - web
        sides = []
        for tip, other in ((a, b), (b, a)):
            inward = np.cross(normal, tip - root)
            inward *= np.sign(inward @ (other - root)) / np.linalg.norm(inward)
            sides.append(-((p - root) @ inward))
        gap, middle = np.linalg.norm(a - b), 0.5 * (a + b)
        outward = unit(middle - root)
        bay = 0.62 * gap - np.linalg.norm(p - (middle + 0.32 * gap * outward), axis=1)
        distances.append(np.maximum.reduce([flat, *sides, bay, (p - middle) @ outward]))
    return smooth_union(distances, 0.03)


def ear(p):
    return fan(p, (0.4, 1.62, -0.02), [(0.74, 1.96, -0.2), (0.84, 1.68, -0.22), (0.72, 1.42, -0.16)], 0.06, 0.042)


def wing(p):
    return fan(p, (0.26, 1.02, -0.38), [(0.86, 1.5, -0.72), (1.02, 1.14, -0.74), (0.88, 0.8, -0.7),
        (0.6, 0.66, -0.62)], 0.06, 0.042)


def spread(points, spacing, rng):
    """Points of a skin that keep `spacing` from each other, which may vary over it: darts thrown in
    a random order."""
    kept, kept_spacing = [], []
    for k in rng.permutation(len(points)):
        if kept:
            gaps = np.linalg.norm(np.array(kept) - points[k], axis=1)
            if (gaps < 0.5 * (np.array(kept_spacing) + spacing[k])).any():
                continue
        kept.append(points[k])
        kept_spacing.append(spacing[k])
    return np.array(kept), np.array(kept_spacing)


def scaly(points):
    """Where the skin has scales: 0 on the face, the belly, fans and paws; 1 on crown, back, tail."""
    x, y, z = folded(points).T
    where = smoothstep(0.3, -0.05, z) * smoothstep(0.0, 0.16, y)
    where = np.maximum(where, smoothstep(1.84, 1.98, y) * smoothstep(0.5, 0.3, z))
    where = np.maximum(where, smoothstep(0.36, 0.5, x) * smoothstep(0.5, 0.25, z) * smoothstep(1.3, 1.1, y))
    for fan_field in (ear, wing):
        where = where * smoothstep(0.02, 0.1, fan_field(folded(points)))
    tail = smoothstep(0.9, 1.0, points[:, 0]) * smoothstep(0.78, 0.68, y)
    return np.maximum(where, tail)


def relief_of(centres, spacing):
    """Height of the skin's fine relief at places on it, in metres."""
    def scales(points):
        best = np.full((len(points), 2), np.inf)
        width = np.ones(len(points))
        for start in range(0, len(points), 2000):
            part = points[start : start + 2000]
            gaps = np.linalg.norm(part[:, None] - centres[None], axis=2) / spacing[None]
            near = np.argpartition(gaps, 1, axis=1)[:, :2]
            pair = np.take_along_axis(gaps, near, axis=1)
            first = np.where(pair[:, 0] <= pair[:, 1], near[:, 0], near[:, 1])
            best[start : start + 2000] = np.sort(pair, axis=1)
            width[start : start + 2000] = spacing[first]
        # High in the middle of a scale, low where two are as near.
        return width * smoothstep(0.0, 0.55, best[:, 1] - best[:, 0])

    def relief(points):
        x, y, z = points.T
        height = 0.17 * scaly(points) * scales(points)
        # The belly's plates lap over each other like tiles, from the chest down.
        across = smoothstep(0.36, 0.26, np.abs(x)) * smoothstep(0.2, 0.36, z)
        across *= smoothstep(1.24, 1.16, y) * smoothstep(0.1, 0.2, y)
        lap = (y + 0.25 * x * x) / 0.16 % 1.0
        height += 0.05 * across * smoothstep(0.0, 0.4, lap) * smoothstep(1.4, 0.4, lap)
        # Wrinkles over the snout.
        snout = smoothstep(0.26, 0.12, np.abs(x)) * smoothstep(1.5, 1.56, y)
        snout *= smoothstep(0.46, 0.52, z) * smoothstep(0.68, 0.6, z)
        return height + 0.008 * snout * np.cos(2.0 * np.pi * z / 0.055)

    return relief


def facing_out(normals, places, triangles):
    """Where lobes all but touch, the field's slope says little: there the triangles' own side counts."""
    a, b, c = (places[triangles[:, k]] for k in range(3))
    sides = np.zeros(places.shape)
    for k in range(3):
        np.add.at(sides, triangles[:, k], np.cross(b - a, c - a))
    sides = unit(sides)
    agree = np.einsum("ij,ij->i", normals, sides)[:, None]
    return np.where(agree > 0.3, normals, sides)


def skin():
    places, triangles = surface(body, (-1.2, -0.12, -1.3), (1.6, 2.35, 1.0), CELL)
    rng = np.random.default_rng(5)
    # Large scales on the back, small ones on the crown and toward the tail's end.
    spacing = 0.105 + 0.05 * smoothstep(0.9, 0.5, np.abs(places[:, 1] - 0.75))
    spacing -= 0.02 * smoothstep(0.9, 1.3, places[:, 0])
    relief = relief_of(*spread(places, spacing, rng))
    normals = unit(gradient(body, places, 4e-3))
    # Less than half of its height goes into the outline, all of it into the light.
    raised = places + 0.4 * relief(places)[:, None] * normals
    # The slope of the relief along the skin turns the normal against it.
    across = unit(np.cross(normals, np.where(np.abs(normals[:, :1]) < 0.7, [[1.0, 0.0, 0.0]], [[0.0, 1.0, 0.0]])))
    for direction in (across, np.cross(normals, across)):
        step = 0.008
        rise = (relief(places + step * direction) - relief(places - step * direction)) / (2.0 * step)
        normals = normals - rise[:, None] * direction
    return raised, triangles, facing_out(unit(normals), raised, triangles)


def horn(side):
    """Curved back, ringed, tapering."""
    t = np.linspace(0.0, 1.0, 26)
    path = np.stack([side * (0.27 + 0.3 * t - 0.1 * t * t), 1.94 + 0.52 * t - 0.06 * t * t,
        0.0 - 0.18 * t - 0.22 * t * t], axis=1)
    rings = 1.0 + 0.1 * np.abs(np.sin(7.0 * np.pi * t**0.8)) * (1.0 - t)
    return tube(path, 0.115 * (1.0 - t) ** 0.75 * rings + 0.012, 16)


def claws():
    for side in (-1, 1):
        for dx in (-0.13, 0.0, 0.13):
            foot = np.array([side * (0.5 + dx), 0.075, 0.82])
            yield tube([foot, foot + (0, 0.0, 0.06), foot + (0, -0.03, 0.115)], [0.045, 0.035, 0.006], 8)


def tail_tip():
    spade = lathe([(0.0, -0.06), (0.14, 0.02), (0.11, 0.12), (0.0, 0.32)], 14)
    return turned((spade[0] * (1.0, 1.0, 0.5), spade[1]), (-0.45, 0.9, 0.0), np.array([1.28, 0.88, 0.1]))


def eye(side, white, pupil):
    """Rings of the white and of the pupil lie along the gaze, so that they meet in a clean circle."""
    centre = EYE_AT * (side, 1.0, 1.0)
    gaze = unit(np.array([0.1 * side + 0.24, 0.06, 1.0]))
    yield white, turned(ball((0, 0, 0), (EYE_RADIUS,) * 3, 24), gaze, centre)
    yield pupil, turned(ball((0, 0, 0), (0.105,) * 3, 24), gaze, centre + 0.062 * gaze)
    yield white, ball(centre + 0.155 * gaze + (-0.03, 0.045, 0.0), (0.024,) * 3, 10)


def main():
    glb = Glb()
    hide = glb.material("hide", "#79b39a")
    horns = glb.material("horn", "#f0dfc0")
    pupil = glb.material("pupil", "#3b2f45")
    glb.node("hatchling", [(hide, skin())])
    parts = [(horns, horn(side)) for side in (-1, 1)]
    parts += [(horns, claw) for claw in claws()] + [(horns, tail_tip())]
    glb.node("horns", parts, crease_degrees=60)
    eyes = [*eye(-1, horns, pupil), *eye(1, horns, pupil)]
    glb.node("eyes", eyes, crease_degrees=80)
    glb.save("scenes/shading.glb")


main()
