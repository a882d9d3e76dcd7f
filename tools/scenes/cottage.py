"""Writes `scenes/cottage.glb`: a storybook cottage on a round of ground.

Nothing in it is square: walls lean out, the roof sags between its tips and flares at the eaves, the
chimney stands askew. Every part is a closed solid, so that outlines and shadows can trust it; parts
stick into each other rather than touch, so that no two faces lie in one place.

Run it from the repository's root: `python3 tools/scenes/cottage.py`; it needs NumPy. It prints where
the chimney's mouth is.
"""

import random

import numpy as np

from glb import Glb
from solids import ball, box, circle, extrude, lathe, loft, move, smooth_union, surface, surround, tube, warp

GROUND_RADIUS = 6.8
# The walls: half their width and depth at the foot and under the eaves.
FOOT, EAVES = (2.0, 1.55), (2.2, 1.72)
EAVES_Y, GABLE_Y = 2.05, 4.5
DOOR_X, DORMER_X = -0.75, 0.8
RIDGE_Y, ROOF_THICK = 4.72, 0.24
# Rows of shingles on each slope, shingles in a row, and straight pieces of a shingle's round edge.
COURSES, SHINGLES, STEPS = 5, 11, 4
EAVES_Z, HANG = 2.16, 0.14
CHIMNEY_FOOT, CHIMNEY_TOP = np.array([-1.15, 2.9, -0.35]), np.array([-1.42, 6.15, -0.32])

# Trunks: x, y, z and radius. Crowns: the same of their lobes, large ones within and small ones on the rim.
OAK_TRUNK = [(0, -0.4, 0, 0.46), (0.02, 0.0, 0, 0.29), (0.14, 0.6, 0, 0.21), (0.1, 1.2, 0, 0.18),
    (-0.08, 1.7, 0, 0.17), (-0.05, 2.3, 0, 0.13)]
OAK = [
    (0.0, 2.75, 0.0, 0.95), (-0.85, 2.3, 0.15, 0.62), (0.9, 2.25, 0.1, 0.7), (0.35, 3.5, 0.0, 0.72),
    (-0.5, 3.3, 0.15, 0.6), (0.25, 2.25, 0.7, 0.6), (-0.1, 2.4, -0.7, 0.65), (1.15, 2.95, 0.0, 0.42),
    (-1.15, 2.85, 0.1, 0.36), (0.0, 4.0, 0.05, 0.4), (-0.3, 1.95, 0.55, 0.42), (0.45, 3.0, 0.75, 0.42),
]
POPLAR_TRUNK = [(0, -0.4, 0, 0.26), (0.0, 0.0, 0, 0.15), (-0.05, 0.5, 0, 0.11), (0.0, 1.2, 0, 0.09)]
POPLAR = [
    (0.0, 1.15, 0.0, 0.6), (0.04, 1.85, 0.0, 0.58), (0.0, 2.55, 0.02, 0.44), (0.08, 3.1, 0.0, 0.29),
    (0.42, 1.4, 0.15, 0.34), (-0.42, 1.3, 0.15, 0.36), (-0.38, 2.0, 0.1, 0.34), (0.36, 2.2, 0.1, 0.3),
    (0.05, 1.45, 0.45, 0.34), (-0.2, 2.75, 0.1, 0.27),
]
BUSH = [
    (2.8, 0.0, 1.4, 0.4), (3.2, -0.05, 0.9, 0.5), (3.1, -0.1, 1.75, 0.3), (2.88, 0.27, 1.02, 0.36),
    (3.35, 0.28, 0.75, 0.27), (3.5, -0.2, 1.3, 0.28),
]

rng = random.Random(7)


def crooked(places):
    """The whole house leans a little, more the higher it goes."""
    x, y, z = places.T
    return np.stack([x + 0.018 * y * np.abs(y), y, z + 0.02 * y], axis=1)


def ground_y(x, z):
    """A knoll: level under the house, then falling away."""
    away = np.clip((np.hypot(x, z) - 2.4) / (GROUND_RADIUS - 2.4), 0.0, 1.0)
    return -1.15 * away**2 + 0.05 * np.sin(1.3 * x + 0.4) * np.cos(1.1 * z)


def ground():
    count = 40
    angles = 2.0 * np.pi * np.arange(count) / count
    reach = GROUND_RADIUS * (1.0 + 0.025 * np.sin(3 * angles + 1.0) + 0.02 * np.sin(7 * angles))
    rings = []
    for share in (0.2, 0.4, 0.56, 0.7, 0.84, 1.0):
        x, z = share * reach * np.cos(angles), share * reach * np.sin(angles)
        rings.append(np.stack([x, ground_y(x, z), z], axis=1))
    # Rounded over at the rim and tucked in below, like a scoop out of a lawn.
    x, z = reach * np.cos(angles), reach * np.sin(angles)
    for share, drop in ((1.01, 0.14), (0.97, 0.36), (0.7, 0.66)):
        rings.append(np.stack([share * x, np.full(count, -1.15 - drop), share * z], axis=1))
    return loft(rings)


def walls():
    """A house-shaped ring at each end and between them, leaning out from foot to eaves."""
    rings = []
    for share in (-1.0, -0.4, 0.25, 1.0):
        ring = [(share * FOOT[0], -0.35, FOOT[1]), (share * EAVES[0], EAVES_Y, EAVES[1])]
        ring += [(share * (EAVES[0] + 0.04), GABLE_Y, 0.0)]
        ring += [(share * EAVES[0], EAVES_Y, -EAVES[1]), (share * FOOT[0], -0.35, -FOOT[1])]
        rings.append(ring)
    return warp(loft(rings), crooked)


def roof_y(x, z, rise=0.0):
    """The roof's outer side: steep at the ridge, flared at the eaves, sagging between its tips, and
    lifted like an eyebrow over the upper window."""
    down = np.abs(z) / 2.3
    y = RIDGE_Y + 0.16 * (np.abs(x) / 2.4) ** 2.2 - 3.62 * down + 0.72 * down**2
    brow = np.exp(-(np.abs((x - DORMER_X) / 0.92) ** 3)) * np.clip((z - 0.3) / 1.7, 0.0, 1.0) ** 1.3
    return y + 1.1 * brow + rise


def course_edge(course, column, slips):
    """How far down the slope a course ends: round shingles, staggered, none hung quite straight."""
    number, inside = divmod(column / STEPS + 0.5 * (course % 2), 1.0)
    slip = slips[course, int(number)]
    if inside == 0.0:
        slip = min(slip, slips[course, int(number) - 1])
    hang = HANG * np.sqrt(1.0 - (2.0 * inside - 1.0) ** 2)
    return EAVES_Z * (course + 1) / COURSES + hang + slip


def slope(column, slips):
    """From the ridge down to the eaves: places down the slope, and how far they stand off it. Each
    course thickens toward its lower edge, where the skin steps in to the next."""
    line = []
    for course in range(COURSES):
        edge = course_edge(course, column, slips)
        line += [(edge, 0.085), (edge - 0.004, 0.0)]
    return line[:-1]


def roof():
    """Both slopes as one closed skin, sewn together from gable to gable."""
    columns = SHINGLES * STEPS
    slips = [
        {(course, k): rng.uniform(-0.03, 0.03) for course in range(COURSES) for k in range(-1, SHINGLES + 1)}
        for _ in range(2)
    ]
    rings = []
    for column in range(columns + 1):
        front, back = (slope(column, side) for side in slips)
        line = front[::-1] + [(0.0, 0.09)] + [(-z, lift) for z, lift in back]
        outer, inner = [], []
        for z, lift in line:
            # The tips of the ridge reach out farther than the eaves.
            x = (2.0 * column / columns - 1.0) * (2.78 - 0.3 * min(abs(z) / 2.2, 1.0))
            y = roof_y(x, z)
            outer.append((x, y + lift, z))
            inner.append((x, y - ROOF_THICK, 0.985 * z))
        rings.append(outer + inner[::-1])
    return warp(loft(rings, caps="strip"), crooked)


def ridge_cap():
    """A bolster along the ridge, which hides where the two slopes meet."""
    xs = np.linspace(-2.9, 2.9, 13)
    return warp(tube([(x, roof_y(x, 0.0) + 0.05, 0.0) for x in xs], 0.15 + 0.05 * (np.abs(xs) / 2.9) ** 6, 8), crooked)


def chimney(glb, brick, soot):
    """A tapering stack, open at its mouth; returns the mouth's middle and the half of its width."""
    def middle(y):
        share = (y - CHIMNEY_FOOT[1]) / (CHIMNEY_TOP[1] - CHIMNEY_FOOT[1])
        return CHIMNEY_FOOT + share * (CHIMNEY_TOP - CHIMNEY_FOOT)

    def frame(y, half):
        corners = [(-1, 1), (1, 1), (1, -1), (-1, -1)]
        return [middle(y) + (half * x, 0.0, half * z) for x, z in corners]

    top = CHIMNEY_TOP[1]
    # Up the outside, over the lip, down the flue; the foot and the flue's end are capped.
    outside = [(2.9, 0.5), (5.5, 0.37), (5.54, 0.46), (5.74, 0.47), (5.76, 0.4), (top - 0.14, 0.39), (top - 0.1, 0.5),
        (top, 0.51)]
    mouth_half = 0.33
    flue = [(top, mouth_half), (top - 0.5, 0.3)]
    parts = [(brick, loft([frame(y, half) for y, half in outside + flue]))]
    # A few bricks stand proud of the wall.
    for y, front, shift in ((4.92, True, 0.15), (5.12, True, -0.16), (5.33, True, 0.1), (5.0, False, -0.12),
        (5.27, False, 0.14)):
        reach = 0.5 - 0.05 * (y - 2.9)
        at = middle(y) + ((shift, 0.0, reach) if front else (reach, 0.0, shift))
        half = np.array((0.12, 0.06, 0.04) if front else (0.04, 0.06, 0.12))
        parts.append((brick, box(at - half, at + half)))
    at, half = middle(top - 0.42), np.array((0.36, 0.02, 0.36))
    parts.append((soot, box(at - half, at + half)))
    glb.node("chimney", [(material, warp(mesh, crooked)) for material, mesh in parts], crease_degrees=30)
    return crooked(CHIMNEY_TOP[None])[0], mouth_half


def arch(half, foot, spring, steps=8):
    """A doorway's outline: anticlockwise from its foot on the right."""
    turn = np.linspace(0.0, np.pi, steps + 1)
    return [(half, foot)] + [(half * np.cos(a), spring + half * np.sin(a)) for a in turn] + [(-half, foot)]


def facing(meshes, x, z, lean, turn=0.0):
    """Puts what was built on the plane z = 0 onto a wall that leans out by `lean` a metre."""
    def change(places):
        out = places[:, 2] + lean * places[:, 1]
        u = places[:, 0]
        return crooked(np.stack([
            x + u * np.cos(turn) + out * np.sin(turn), places[:, 1],
            z - u * np.sin(turn) + out * np.cos(turn)], axis=1))
    return [(material, warp(mesh, change)) for material, mesh in meshes]


def door(wood, frame, metal, glass):
    parts = []
    inner, outer = arch(0.44, -0.05, 1.12), arch(0.6, -0.05, 1.14)
    parts.append((frame, extrude(outer + inner[::-1], -0.1, 0.14, caps="strip")))
    # Planks, each as long as the arch leaves room for.
    for k in range(4):
        x0, x1 = -0.45 + 0.225 * k, -0.45 + 0.225 * (k + 1) - 0.018
        tops = [1.12 + np.sqrt(max(0.47**2 - x * x, 0.0)) for x in (x0, 0.5 * (x0 + x1), x1)]
        outline = [(x0, -0.04), (x1, -0.04), (x1, tops[2]), (0.5 * (x0 + x1), tops[1]), (x0, tops[0])]
        parts.append((wood, extrude(outline, -0.1, 0.05 + 0.012 * (k % 2))))
    parts.append((metal, ball((0.3, 0.66, 0.1), (0.055, 0.055, 0.055), 8)))
    for y in (0.3, 1.05):
        parts.append((metal, extrude([(-0.43, y), (0.12, y + 0.03), (0.12, y + 0.07), (-0.43, y + 0.1)], 0.0, 0.085)))
    parts.append((frame, move(surround(circle(0.15, 12), circle(0.1, 12), 0.0, 0.1), (0.0, 1.18, 0.0))))
    parts.append((glass, move(extrude(circle(0.12, 12), 0.0, 0.08), (0.0, 1.18, 0.0))))
    return parts


def window(frame, glass, shutter, y, half_width=0.4, half_height=0.46, round_top=False):
    """A frame with a cross, its pane, and a shutter on each side."""
    w, h, b = half_width, half_height, 0.09
    parts = [(glass, extrude([(w, y - h), (w, y + h), (-w, y + h), (-w, y - h)], -0.1, 0.03))]
    outer = [(w + b, y - h - b), (w + 0.8 * b, y + h + b), (-w - 0.8 * b, y + h + b + 0.02), (-w - b, y - h - b)]
    inner = [(w, y - h), (w, y + h), (-w, y + h), (-w, y - h)]
    if round_top:
        outer, inner = arch(w + b, y - h - b, y + h), arch(w, y - h, y + h)
        parts[0] = (glass, extrude(inner, -0.1, 0.03))
    parts.append((frame, surround(outer, inner, -0.1, 0.1)))
    top = y + h + (w - 0.01 if round_top else 0.02)
    parts.append((frame, beam((0.0, y - h - 0.02), (0.0, top), 0.03, (-0.05, 0.07))))
    cross = y + (0.3 * h if not round_top else 0.6 * h)
    parts.append((frame, beam((-w - 0.02, cross + 0.03), (w + 0.02, cross + 0.03), 0.03, (-0.05, 0.06))))
    parts.append((frame, beam((-w - 0.17, y - h - 0.115), (w + 0.17, y - h - 0.115), 0.055, (-0.1, 0.17))))
    if shutter is None:
        return parts
    for side in (1, -1):
        near, far = side * (w + 0.12), side * (w + 0.47)
        skew = 0.03 * side
        low, high = y - h - 0.06, y + h + 0.08
        leaf = [(near, low), (far + skew, low - 0.02), (far - skew, high + 0.02), (near, high)]
        parts.append((shutter, extrude(leaf, -0.05, 0.07)))
        for at in (-0.24, 0.26):
            inset = 0.05 * side
            parts.append((shutter, beam((near + inset, y + at), (far - inset, y + at), 0.045, (0.0, 0.11))))
    return parts


def flower_box(wood, leaf, petals, y, half):
    trough = [(half - 0.05, y - 0.14), (half, y + 0.1), (-half, y + 0.1), (-half + 0.05, y - 0.14)]
    parts = [(wood, extrude(trough, 0.02, 0.32))]
    for k in range(5):
        x = half * (-0.78 + 0.39 * k)
        r = rng.uniform(0.11, 0.15)
        middle = (x, y + 0.13 + rng.uniform(0.0, 0.06), 0.2)
        parts.append((leaf if k % 2 else petals, ball(middle, (r, 0.85 * r, 0.9 * r), 8)))
    return parts


def beam(p, q, half=0.08, out=(0.0, 0.06)):
    """A board on the plane z = 0 from p to q."""
    p, q = np.array(p, float), np.array(q, float)
    side = np.array([p[1] - q[1], q[0] - p[0]])
    side *= half / np.linalg.norm(side)
    return extrude([p - side, q - 0.9 * side, q + 0.9 * side, p + side], *out)


def timber(glb, wood):
    """Posts at the corners, and beams over the gable that faces the camera."""
    parts = []
    lean_x, lean_z = (EAVES[0] - FOOT[0]) / 2.4, (EAVES[1] - FOOT[1]) / 2.4
    for sx in (1, -1):
        for sz in (1, -1):
            rings = []
            for y in (-0.2, 1.0, EAVES_Y + 0.05):
                x, z = sx * (FOOT[0] + lean_x * (y + 0.35)), sz * (FOOT[1] + lean_z * (y + 0.35))
                corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
                rings.append([(x + 0.11 * a - 0.05 * sx, y, z + 0.11 * b - 0.05 * sz) for a, b in corners])
            parts.append((wood, warp(loft(rings, caps="strip"), crooked)))
    gable = [
        (wood, beam((-1.8, 2.08), (1.8, 2.02), 0.1, (-0.08, 0.09))),
        (wood, beam((0.0, 2.0), (0.0, 4.3), 0.09, (-0.08, 0.07))),
        (wood, beam((-1.15, 2.05), (-0.25, 3.55), 0.075, (-0.08, 0.05))),
        (wood, beam((1.15, 2.05), (0.25, 3.55), 0.075, (-0.08, 0.05))),
    ]
    parts += facing(gable, FOOT[0] + 0.35 * lean_x, 0.0, lean_x, 0.5 * np.pi)
    front = [(wood, beam((-2.1, 2.0), (2.1, 2.04), 0.08, (-0.08, 0.06)))]
    parts += facing(front, 0.0, FOOT[1] + 0.35 * lean_z, lean_z)
    glb.node("timber", parts)


def dormer():
    """The wall under the eyebrow, which ends inside the roof."""
    turn = np.linspace(0.0, np.pi, 9)
    outline = [(0.85, 1.9)] + [(0.85 * np.cos(a), 2.2 + 0.72 * np.sin(a)) for a in turn] + [(-0.85, 1.9)]
    return extrude(outline, -1.1, 0.02)


def stones(stone):
    """The plinth, and boulders that break its line."""
    parts = [(stone, warp(box((-2.12, -0.45, -1.67), (2.12, 0.22, 1.67), 1.0), crooked))]
    for x, z, r in ((2.1, 1.2, 0.2), (2.12, 0.5, 0.15), (2.1, -0.2, 0.19), (2.1, -0.95, 0.16), (1.75, 1.66, 0.2),
        (1.2, 1.66, 0.15), (0.62, 1.66, 0.18), (-1.6, 1.66, 0.2), (-2.1, 1.2, 0.17)):
        parts.append((stone, ball((x, 0.02 + 0.3 * r, z), (1.25 * r, 0.8 * r, 1.1 * r), 8)))
    return parts


def steps(stone):
    parts = []
    for k, (radius, top) in enumerate(((0.95, 0.02), (0.72, 0.14))):
        disc = lathe([(radius, -0.4), (radius, top - 0.04), (radius - 0.04, top)], 18)
        parts.append((stone, move((disc[0] * (1.0, 1.0, 0.85), disc[1]), (DOOR_X, 0.0, 1.75))))
    return parts


def path(stone):
    """Flagstones that wander down to the gate."""
    parts = []
    for k in range(8):
        t = k / 7.0
        x, z = DOOR_X - 0.05 + 0.55 * np.sin(2.6 * t) * t + 0.12 * (-1) ** k, 2.75 + 2.9 * t
        radius = 0.26 + 0.04 * rng.random() + 0.05 * t
        turn = 6.3 * rng.random()
        rings = []
        for share, lift in ((1.0, -0.15), (1.0, 0.035), (0.86, 0.06)):
            angles = turn + 2.0 * np.pi * np.arange(7) / 7
            reach = radius * share * np.array([1.0, 0.9, 1.06, 0.94, 1.08, 0.92, 1.02])
            u, v = x + 1.3 * reach * np.cos(angles), z + 0.85 * reach * np.sin(angles)
            rings.append(np.stack([u, ground_y(u, v) + lift, v], axis=1))
        parts.append((stone, loft(rings)))
    return parts


def fence(paint):
    """Pickets round the front of the knoll, with a gap for the path; two rails behind them."""
    parts = []
    reach = 0.7 * GROUND_RADIUS
    for start, end, count in ((14.0, 80.0, 14), (106.0, 146.0, 9)):
        angles = np.radians(np.linspace(start, end, count))
        for k, angle in enumerate(angles):
            x, z = reach * np.cos(angle), reach * np.sin(angle)
            tall = rng.uniform(0.68, 0.8) + (0.16 if k in (0, count - 1) else 0.0)
            wide = 0.085 if k not in (0, count - 1) else 0.11
            tilt = rng.uniform(-0.07, 0.07)
            half = [(wide, -0.25), (wide, tall - 0.12)]
            picket = half + [(0.0, tall)] + [(-u, v) for u, v in half[::-1]]
            picket = extrude(picket, -0.035, 0.035)
            def stand(places, x=x, z=z, angle=angle, tilt=tilt):
                u = places[:, 0] + tilt * places[:, 1]
                v = places[:, 2]
                return np.stack([x - u * np.sin(angle) + v * np.cos(angle), places[:, 1] + ground_y(x, z),
                    z + u * np.cos(angle) + v * np.sin(angle)], axis=1)
            parts.append((paint, warp(picket, stand)))
        for height in (0.2, 0.48):
            line = []
            for angle in np.radians(np.linspace(start - 1.0, end + 1.0, 8)):
                x, z = (reach - 0.06) * np.cos(angle), (reach - 0.06) * np.sin(angle)
                y = ground_y(x, z) + height
                section = ((-0.025, -0.045), (0.025, -0.045), (0.025, 0.045), (-0.025, 0.045))
                line.append([(x + a * np.cos(angle), y + b, z + a * np.sin(angle)) for a, b in section])
            parts.append((paint, loft(line, caps="strip")))
    return parts


def crown(lobes, cell):
    """Lobes grown together, with soft valleys between them."""
    lobes = np.array(lobes, float)
    def field(points):
        flattened = [(points - lobe[:3]) / (1.0, 0.92, 1.0) for lobe in lobes]
        return smooth_union([np.linalg.norm(p, axis=1) - lobe[3] for p, lobe in zip(flattened, lobes)], 0.2)
    reach = lobes[:, 3:] + 0.2
    return surface(field, (lobes[:, :3] - reach).min(axis=0), (lobes[:, :3] + reach).max(axis=0), cell)


def tree(glb, name, bark, leaf, x, z, trunk, lobes, cell=0.2):
    y = float(ground_y(x, z))
    path, radii = zip(*[((px, py, pz), r) for px, py, pz, r in trunk])
    glb.node(name, [(bark, tube(path, radii, 9)), (leaf, crown(lobes, cell))], translation=(x, y, z), crease_degrees=50)


def main():
    glb = Glb()
    plaster = glb.material("plaster", "#f2dcb3")
    shingle = glb.material("shingle", "#b5647a")
    ridge = glb.material("ridge", "#8f4c6b")
    wood = glb.material("timber", "#8a6152")
    brick = glb.material("brick", "#cf6f57")
    stone = glb.material("stone", "#b8aeb6")
    teal = glb.material("paint", "#4f9c97")
    glass = glb.material("lamplight", "#ffd981")
    white = glb.material("picket", "#f4ead6")
    grass = glb.material("grass", "#a3bf69")
    leaf = glb.material("leaf", "#6fa567")
    autumn = glb.material("autumn", "#e2a44f")
    soot = glb.material("soot", "#54414f")

    glb.node("ground", [(grass, ground())])
    glb.node("path", path(stone))
    lean_z, lean_x = (EAVES[1] - FOOT[1]) / 2.4, (EAVES[0] - FOOT[0]) / 2.4
    front, side = FOOT[1] + 0.35 * lean_z, FOOT[0] + 0.35 * lean_x
    house = [(plaster, walls())] + facing([(plaster, dormer())], DORMER_X, front, lean_z) + stones(stone)
    glb.node("house", house, crease_degrees=30)
    glb.node("roof", [(shingle, roof()), (ridge, ridge_cap())])
    timber(glb, wood)
    glb.node("door", facing(door(teal, stone, glass, glass), DOOR_X, front, lean_z))
    glb.node("steps", steps(stone))
    lower = window(white, glass, teal, 1.12) + flower_box(wood, leaf, brick, 0.5, 0.5)
    glb.node("window front", facing(lower, 1.05, front, lean_z))
    glb.node("window dormer", facing(window(white, glass, None, 2.3, 0.34, 0.17, True), DORMER_X, front + 0.03, lean_z))
    glb.node("window side", facing(window(white, glass, teal, 1.15, 0.36, 0.42), side, -0.1, lean_x, 0.5 * np.pi))
    mouth, radius = chimney(glb, brick, soot)
    glb.node("fence", fence(white))
    tree(glb, "tree", wood, leaf, 3.9, -1.9, OAK_TRUNK, OAK, 0.18)
    tree(glb, "poplar", wood, autumn, -3.75, 0.3, POPLAR_TRUNK, POPLAR, 0.17)
    glb.node("bush", [(leaf, crown(BUSH, 0.15))])
    glb.save("scenes/cottage.glb")
    print(f"chimney's mouth: {mouth.round(3).tolist()}, radius {radius}")


main()
