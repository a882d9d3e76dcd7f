"""Writes `scenes/shading.glb`: a dragon's hatchling, to try shadings on.

Large smooth lobes, grown together, show how a shading turns a form; scales, the belly's plates and the
rings of the horns are the fine relief that some shadings bring out and others lose. The skin is the
surface round a field; its relief is finer than its triangles, and lies in the normals.

Run it from the repository's root: `python3 tools/scenes/shading.py`; it needs NumPy.
"""

import numpy as np

from glb import Glb, unit
from solids import ball, gradient, lathe, smooth_union, surface, tube, warp

CELL = 0.042
EYE_AT, EYE_RADIUS = np.array([0.235, 1.66, 0.415]), 0.15


def ellipsoid(points, centre, radii):
    """Nearly the distance to an ellipsoid (Quilez's bound, which is exact for balls)."""
    p = points - centre
    far = np.linalg.norm(p / radii, axis=1)
    return far * (far - 1.0) / np.maximum(np.linalg.norm(p / np.square(radii), axis=1), 1e-9)


def capsule(points, start, end, radius_start, radius_end):
    start, end = np.asarray(start, float), np.asarray(end, float)
    along = end - start
    t = np.clip((points - start) @ along / (along @ along), 0.0, 1.0)
    return np.linalg.norm(points - start - t[:, None] * along, axis=1) - (radius_start + t * (radius_end - radius_start))


TAIL = [
    ((0.0, 0.3, -0.42), 0.34), ((0.22, 0.2, -0.78), 0.26), ((0.62, 0.15, -0.92), 0.2), ((1.0, 0.14, -0.7), 0.16),
    ((1.16, 0.14, -0.28), 0.125), ((1.05, 0.15, 0.12), 0.1), ((0.82, 0.2, 0.36), 0.08), ((0.72, 0.33, 0.46), 0.06),
]
SPIKES = [
    # Along the middle, from the brow over the back: foot, height and length, leaning back.
    ((1.98, 0.02), 0.13), ((1.93, -0.24), 0.16), ((1.72, -0.42), 0.17), ((1.44, -0.44), 0.17),
    ((1.16, -0.46), 0.18), ((0.88, -0.56), 0.19), ((0.6, -0.64), 0.18), ((0.38, -0.72), 0.14),
]


def body(points):
    """Both halves at once: x is folded over, save for the tail."""
    p = points * (1.0, 1.0, 1.0)
    p[:, 0] = np.abs(p[:, 0])
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
    smile_y = 1.395 + 0.25 * p[:, 0] ** 2 + 0.55 * np.clip(p[:, 0] - 0.2, 0.0, 1.0) ** 2
    smile = np.maximum(np.abs(p[:, 1] - smile_y) - 0.014, np.maximum(0.22 - p[:, 2], -(head + 0.05)))
    head = -smooth_union([-head, smile], 0.03)
    nostril = ellipsoid(p, (0.15, 1.585, 0.745), (0.034, 0.028, 0.05))
    head = -smooth_union([-head, nostril], 0.02)
    ears = ear(p)
    tail = smooth_union([
        capsule(points, a, b, ra, rb) for (a, ra), (b, rb) in zip(TAIL, TAIL[1:])
    ], 0.05)
    whole = smooth_union([trunk, *toes], 0.05)
    whole = smooth_union([whole, *arms], 0.06)
    whole = smooth_union([whole, tail], 0.12)
    whole = smooth_union([whole, head], 0.07)
    whole = smooth_union([whole, ears, wing(p)], 0.05)
    spikes = [capsule(p, (0.0, y, z), (0.0, y + 1.1 * tall * (0.9 if y > 1.5 else 0.55), z - tall * (0.5 if y > 1.8 else 1.0)), 0.085, 0.018)
              for (y, z), tall in SPIKES]
    return smooth_union([whole, *spikes], 0.05)


def fan(p, root, tips, thick, web):
    """Ribs from a root, with skin between them that hangs in: ears and wings."""
    root, tips = np.asarray(root, float), np.asarray(tips, float)
    distances = [capsule(p, root, tip, thick, 0.6 * thick) for tip in tips]
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
        middle = 0.5 * (a + b)
        bay = 0.62 * np.linalg.norm(a - b) - np.linalg.norm(p - (middle + 0.32 * (middle - root) / np.linalg.norm(middle - root) * np.linalg.norm(a - b)), axis=1)
        distances.append(np.maximum.reduce([flat, *sides, bay, np.linalg.norm(p - root, axis=1) - 1.2]))
    return smooth_union(distances, 0.03)


def ear(p):
    return fan(p, (0.4, 1.62, -0.02), [(0.74, 1.96, -0.2), (0.84, 1.68, -0.22), (0.72, 1.42, -0.16)], 0.055, 0.035)


def wing(p):
    return fan(p, (0.26, 1.02, -0.38), [(0.86, 1.5, -0.72), (1.02, 1.14, -0.74), (0.88, 0.8, -0.7), (0.6, 0.66, -0.62)], 0.055, 0.035)


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


def smoothstep(low, high, value):
    t = np.clip((value - low) / (high - low), 0.0, 1.0)
    return t * t * (3.0 - 2.0 * t)


def bare(points):
    """Where the skin has no scales: 0 on the face, the belly, fans and paws; 1 on crown, back, tail."""
    x, y, z = np.abs(points[:, 0]), points[:, 1], points[:, 2]
    scaly = smoothstep(0.3, -0.05, z) * smoothstep(0.0, 0.16, y)
    scaly = np.maximum(scaly, smoothstep(1.84, 1.98, y) * smoothstep(0.5, 0.3, z))
    scaly = np.maximum(scaly, smoothstep(0.36, 0.5, x) * smoothstep(0.5, 0.25, z) * smoothstep(1.3, 1.1, y))
    for fan_field in (ear, wing):
        scaly = scaly * smoothstep(0.02, 0.1, fan_field(np.stack([x, y, z], axis=1)))
    tail_z = np.where(points[:, 0] > 0.78, smoothstep(0.6, 0.3, z), 0.0)
    return np.maximum(scaly, tail_z * smoothstep(0.5, 0.4, y))


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
        height = 0.2 * bare(points) * scales(points)
        # The belly's plates lap over each other like tiles, from the chest down.
        across = smoothstep(0.36, 0.26, np.abs(x)) * smoothstep(0.2, 0.36, z) * smoothstep(1.24, 1.16, y) * smoothstep(0.1, 0.2, y)
        lap = (y + 0.25 * x * x) / 0.135 % 1.0
        height += 0.035 * across * smoothstep(0.0, 0.22, lap) * (1.0 - 0.55 * lap)
        # Wrinkles over the snout.
        snout = smoothstep(0.26, 0.12, np.abs(x)) * smoothstep(0.46, 0.52, z) * smoothstep(0.68, 0.6, z) * smoothstep(1.5, 1.56, y)
        return height + 0.008 * snout * np.cos(2.0 * np.pi * z / 0.055)

    return relief


def skin():
    places, triangles = surface(body, (-1.2, -0.12, -1.3), (1.5, 2.35, 1.0), CELL)
    rng = np.random.default_rng(5)
    spacing = 0.105 + 0.05 * smoothstep(0.9, 0.5, np.abs(places[:, 1] - 0.75)) - 0.045 * smoothstep(0.7, 1.1, places[:, 0])
    relief = relief_of(*spread(places, spacing, rng))
    normals = unit(gradient(body, places, 4e-3))
    raised = places + relief(places)[:, None] * normals
    # The slope of the relief along the skin turns the normal against it.
    across = unit(np.cross(normals, np.where(np.abs(normals[:, :1]) < 0.7, [[1.0, 0.0, 0.0]], [[0.0, 1.0, 0.0]])))
    for direction in (across, np.cross(normals, across)):
        step = 0.008
        rise = (relief(places + step * direction) - relief(places - step * direction)) / (2.0 * step)
        normals = normals - rise[:, None] * direction
    return raised, triangles, unit(normals)


def horn(side):
    """Curved back, ringed, tapering."""
    t = np.linspace(0.0, 1.0, 26)
    path = np.stack([side * (0.27 + 0.3 * t - 0.1 * t * t), 1.94 + 0.52 * t - 0.06 * t * t, 0.0 - 0.18 * t - 0.22 * t * t], axis=1)
    rings = 1.0 + 0.1 * np.abs(np.sin(7.0 * np.pi * t**0.8)) * (1.0 - t)
    return tube(path, 0.115 * (1.0 - t) ** 0.75 * rings + 0.012, 16)


def claws():
    for side in (-1, 1):
        for dx in (-0.13, 0.0, 0.13):
            foot = np.array([side * (0.5 + dx), 0.075, 0.82])
            yield tube([foot, foot + (0, 0.0, 0.06), foot + (0, -0.03, 0.115)], [0.045, 0.035, 0.006], 8)


def tail_tip():
    places, triangles = lathe([(0.0, -0.06), (0.13, 0.02), (0.1, 0.12), (0.0, 0.3)], 12)
    return warp((places, triangles), lambda p: p * (1.0, 1.0, 0.45) + (0.715, 0.38, 0.47))


def main():
    glb = Glb()
    hide = glb.material("hide", "#79b39a")
    horns = glb.material("horn", "#f0dfc0")
    pupil = glb.material("pupil", "#3b2f45")
    glb.node("hatchling", [(hide, skin())])
    parts = [(horns, horn(side)) for side in (-1, 1)]
    parts += [(horns, claw) for claw in claws()] + [(horns, tail_tip())]
    glb.node("horns", parts, crease_degrees=60)
    eyes = []
    for side in (-1, 1):
        centre = EYE_AT * (side, 1.0, 1.0)
        eyes.append((horns, ball(centre, (EYE_RADIUS,) * 3, 18)))
        # A pupil looks ahead and a little to the side, as a shallow dome on the eye.
        look = unit(np.array([0.16 * side + 0.1, -0.02, 1.0]))
        eyes.append((pupil, ball(centre + 0.052 * look, (0.092, 0.112, 0.108), 16)))
    glb.node("eyes", eyes, crease_degrees=80)
    glb.save("scenes/shading.glb")


main()
