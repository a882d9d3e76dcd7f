"""Writes `scenes/square.glb`: a small town square for paint to spread over.

Six crooked houses stand in an arc round a fountain; there are a tree, a café with two parasols, lamps, tubs of
flowers and a line of pennants. Everything has a colour of its own, so that it shows where paint has come. Every part
is a closed solid; parts stick into each other rather than touch.

Run it from the repository's root: `python3 tools/scenes/square.py`; it needs NumPy.
"""

import random

import numpy as np

from glb import Glb
from solids import ball, box, circle, extrude, lathe, loft, move, surround, tube, warp

RADIUS = 9.6
rng = random.Random(11)
model = Glb()


def placed(mesh, x, z, turn):
    """Moves what was built facing +z at the origin."""
    c, s = np.cos(turn), np.sin(turn)

    def change(places):
        u, y, v = places.T
        return np.stack([x + u * c + v * s, y, z - u * s + v * c], axis=1)

    return warp(mesh, change)


def crooked(mesh, lean, bow):
    """Leans to one side and bulges, more the higher it goes."""
    def change(places):
        u, y, v = places.T
        return np.stack([u + lean * y + bow * np.sin(0.9 * y), y, v + 0.4 * lean * y], axis=1)

    return warp(mesh, change)


def gable(width, depth, eaves, ridge):
    outline = [(width, -0.3), (width * 1.03, eaves), (0.0, ridge), (-width * 1.03, eaves), (-width, -0.3)]
    return extrude(outline, -depth, depth)


def roof(width, depth, eaves, ridge, thick=0.2, out=0.34):
    """Two slopes of one skin, a little curved, that reach out over walls and gables."""
    def line(rise):
        down = np.linspace(1.0, 0.0, 5)
        half = [((width + out) * t, ridge + (eaves - out - ridge) * t + 0.22 * t * (t - 1.0) + rise) for t in down]
        return half + [(-x, y) for x, y in half[-2::-1]]

    outline = line(thick) + line(0.02)[::-1]
    return extrude(outline, -depth - 0.2, depth + 0.24, caps="strip")


def pane(x, y, half, high, front):
    return extrude([(x + half, y - high), (x + half, y + high), (x - half, y + high), (x - half, y - high)],
        front - 0.1, front + 0.03)


def window(frame, glass, shutter, x, y, front, half=0.27, high=0.38):
    outer = [(x + half + 0.07, y - high - 0.07), (x + half + 0.07, y + high + 0.07), (x - half - 0.07, y + high + 0.07),
        (x - half - 0.07, y - high - 0.07)]
    inner = [(x + half, y - high), (x + half, y + high), (x - half, y + high), (x - half, y - high)]
    parts = [(glass, pane(x, y, half, high, front)), (frame, surround(outer, inner, front - 0.1, front + 0.08))]
    parts.append((frame, box((x - 0.025, y - high, front - 0.05), (x + 0.025, y + high, front + 0.06))))
    parts.append((frame, box((x - half, y + 0.06, front - 0.05), (x + half, y + 0.11, front + 0.055))))
    sill = box((x - half - 0.14, y - high - 0.14, front - 0.1), (x + half + 0.14, y - high - 0.06, front + 0.15))
    parts.append((frame, sill))
    for side in (-1, 1):
        near, far = x + side * (half + 0.1), x + side * (half + 0.36)
        low, high_x = min(near, far), max(near, far)
        parts.append((shutter, box((low, y - high - 0.03, front - 0.05), (high_x, y + high + 0.04, front + 0.05))))
    return parts


def door(wood, frame, x, front, half=0.38, top=1.55):
    turn = np.linspace(0.0, np.pi, 7)
    inner = [(x + half, -0.1)] + [(x + half * np.cos(a), top + half * np.sin(a)) for a in turn] + [(x - half, -0.1)]
    wide = half + 0.12
    outer = [(x + wide, -0.1)] + [(x + wide * np.cos(a), top + wide * np.sin(a)) for a in turn] + [(x - wide, -0.1)]
    return [
        (frame, extrude(outer + inner[::-1], front - 0.1, front + 0.12, caps="strip")),
        (wood, extrude(inner, front - 0.1, front + 0.04)),
        (frame, ball((x + 0.6 * half, 0.85, front + 0.07), (0.05, 0.05, 0.05), 8)),
    ]


def awning(cloth, stripe, x, y, front, half=1.05, reach=0.95):
    """Stripes that slope down from the wall, each with a rounded tip."""
    parts, count = [], 8
    for k in range(count):
        a, b = x - half + 2 * half * k / count, x - half + 2 * half * (k + 1) / count
        low, mid = y - 0.5, 0.5 * (a + b)
        rows = [(front - 0.05, y + 0.03), (front + reach, low + 0.03), (front + reach, low - 0.13),
            (front + reach - 0.03, low - 0.13), (front + reach - 0.03, low), (front - 0.05, y)]
        outline = np.array([(v, w) for v, w in rows])
        ring = lambda u, drop: [(u, w - (drop if i in (2, 3) else 0.0), v) for i, (v, w) in enumerate(outline)]
        parts.append((cloth if k % 2 else stripe, loft([ring(a, -0.06), ring(mid, 0.03), ring(b, -0.06)])))
    return parts


def house(name, x, z, turn, width, eaves, ridge, colours, kind):
    wall, tiles, shutter = (model.material(f"{name} {what}", colour) for what, colour in
        zip(("wall", "roof", "shutter"), colours))
    depth = 1.35
    front = depth + 0.004
    parts = [(wall, gable(width, depth, eaves, ridge)), (tiles, roof(width, depth, eaves, ridge))]
    plinth = box((-width - 0.06, -0.3, -depth - 0.06), (width + 0.06, 0.32, depth + 0.06))
    parts.append((stone, plinth))
    storeys = [y for y in (2.75, 4.15) if y + 0.6 < eaves]
    for y in storeys:
        for side in (-1, 1):
            parts += window(white, glass, shutter, side * 0.52 * width, y, front)
    # One in the gable.
    parts += window(white, glass, shutter, 0.0, eaves + 0.36 * (ridge - eaves) - 0.18, front, 0.2, 0.26)
    if kind == "café":
        parts += door(wood, white, -0.62 * width, front, 0.33)
        parts.append((glass, pane(0.28 * width, 1.1, 0.62, 0.55, front + 0.02)))
        parts += awning(cream, red, 0.12, 2.05, front, 0.98 * width, 0.9)
    elif kind == "shop":
        parts += door(wood, white, 0.5 * width, front)
        parts += awning(cream, teal, -0.32 * width, 2.0, front, 0.55 * width, 0.7)
        parts.append((glass, pane(-0.32 * width, 1.05, 0.42 * width, 0.5, front + 0.02)))
    else:
        parts += door(wood, white, 0.0, front)
        parts += window(white, glass, shutter, -0.66 * width, 1.25, front, 0.2, 0.34)
        parts += window(white, glass, shutter, 0.66 * width, 1.25, front, 0.2, 0.34)
    stack = 0.45 * width * rng.choice((-1, 1))
    top = ridge + 0.5
    parts.append((brick, box((stack - 0.22, eaves, -0.6), (stack + 0.22, top, -0.16), 0.9)))
    parts.append((stone, box((stack - 0.28, top - 0.06, -0.66), (stack + 0.28, top + 0.1, -0.1))))
    lean, bow = rng.uniform(-0.022, 0.022), rng.uniform(-0.05, 0.05)
    parts = [(material, placed(crooked(mesh, lean, bow), x, z, turn)) for material, mesh in parts]
    model.node(name, parts, crease_degrees=35)


def ground():
    count = 56
    angles = 2.0 * np.pi * np.arange(count) / count
    reach = RADIUS * (1.0 + 0.012 * np.sin(5 * angles) + 0.01 * np.sin(9 * angles + 1.0))
    rings = []
    for share, y in ((1.0, 0.0), (1.012, -0.1), (0.99, -0.34), (0.9, -0.5)):
        rings.append(np.stack([share * reach * np.cos(angles), np.full(count, y), share * reach * np.sin(angles)], axis=1))
    return loft(rings)


def paving():
    """Rings of slabs round the fountain, a finger high, with gaps between them."""
    parts = []
    for ring, (inner, outer) in enumerate(((1.95, 2.75), (2.83, 3.65), (3.73, 4.6))):
        count = 14 + 6 * ring
        for k in range(count):
            gap = 0.028 / inner
            a0, a1 = 2 * np.pi * (k + 0.5 * (ring % 2)) / count + gap, 2 * np.pi * (k + 1 + 0.5 * (ring % 2)) / count - gap
            arc = np.linspace(a0, a1, 4)
            edge = [(outer * np.cos(a), outer * np.sin(a)) for a in arc]
            edge += [(inner * np.cos(a), inner * np.sin(a)) for a in arc[::-1]]
            rise = 0.045 + 0.012 * rng.random()
            rings = [[(x, y, z) for x, z in edge] for y in (-0.05, rise)]
            parts.append((slab if rng.random() < 0.62 else slab_dark, loft(rings, caps="strip")))
    return parts


def fountain():
    basin = lathe([(0.0, -0.1), (1.5, -0.1), (1.62, 0.1), (1.55, 0.5), (1.72, 0.56), (1.72, 0.68), (1.4, 0.68),
        (1.36, 0.3), (0.0, 0.3)], 28)
    water = lathe([(0.0, 0.2), (1.42, 0.2), (1.42, 0.54), (0.0, 0.54)], 28)
    column = lathe([(0.0, 0.1), (0.42, 0.1), (0.36, 0.7), (0.18, 0.95), (0.2, 1.5), (0.32, 1.62), (0.0, 1.62)], 16)
    bowl = lathe([(0.0, 1.5), (0.3, 1.5), (0.78, 1.86), (0.84, 2.0), (0.72, 2.02), (0.3, 1.8), (0.0, 1.8)], 24)
    upper = lathe([(0.0, 1.86), (0.72, 1.86), (0.72, 1.95), (0.0, 1.95)], 24)
    finial = lathe([(0.0, 1.7), (0.12, 1.7), (0.09, 2.3), (0.2, 2.45), (0.16, 2.62), (0.0, 2.85)], 14)
    jets = [(water_blue, tube([(0.72 * np.cos(a) * r, 1.98 - 1.45 * (r - 1.0) ** 1.6 / 0.72 ** 0.0, 0.72 * np.sin(a) * r)
        for r in (1.0, 1.12, 1.26, 1.42, 1.6)], [0.05, 0.05, 0.055, 0.06, 0.065], 8)) for a in
        2 * np.pi * np.arange(6) / 6 + 0.26]
    return [(stone, basin), (stone, column), (stone, bowl), (stone, finial), (water_blue, water), (water_blue, upper)] + jets


def tree(x, z):
    trunk = tube([(x, -0.2, z), (x + 0.05, 0.8, z), (x - 0.06, 1.7, z), (x, 2.6, z)], [0.3, 0.2, 0.17, 0.12], 10)
    parts = [(bark, trunk)]
    lobes = [(0, 3.1, 0, 1.05), (-0.8, 2.75, 0.2, 0.72), (0.82, 2.8, 0.1, 0.76), (0.15, 3.85, 0, 0.78),
        (-0.45, 3.6, 0.3, 0.6), (0.55, 3.45, 0.45, 0.6), (0.1, 2.7, 0.65, 0.62), (-1.15, 3.2, 0.1, 0.42),
        (1.15, 3.35, 0.0, 0.4)]
    for k, (u, y, v, r) in enumerate(lobes):
        parts.append((leaf if k % 3 else leaf_light, ball((x + u, y, z + v), (r, 0.94 * r, r), 16)))
    ring = lathe([(0.0, -0.1), (0.75, -0.1), (0.78, 0.22), (0.62, 0.22), (0.6, 0.14), (0.0, 0.14)], 20)
    parts.append((stone, move(ring, (x, 0.0, z))))
    return parts


def parasol(x, z, cloth, stripe):
    parts = [(wood, tube([(x, -0.05, z), (x, 2.5, z)], 0.045, 8))]
    count = 8
    for k in range(count):
        a, b = 2 * np.pi * k / count, 2 * np.pi * (k + 1) / count
        ring = lambda angle: [(x + r * np.cos(angle), y, z + r * np.sin(angle)) for r, y in
            ((0.02, 2.5), (0.7, 2.28), (1.16, 1.98), (1.16, 1.84), (1.12, 1.84), (1.11, 1.95), (0.68, 2.22), (0.02, 2.42))]
        parts.append((cloth if k % 2 else stripe, loft([ring(a), ring(0.5 * (a + b)), ring(b)])))
    parts.append((wood, move(lathe([(0.0, 0.72), (0.52, 0.72), (0.52, 0.78), (0.0, 0.78)], 18), (x, 0, z))))
    parts.append((wood, move(lathe([(0.0, 0.0), (0.22, 0.0), (0.2, 0.06), (0.0, 0.06)], 12), (x, 0, z))))
    for angle in (0.5, 2.3, 4.4):
        cx, cz = x + 0.85 * np.cos(angle), z + 0.85 * np.sin(angle)
        parts.append((stripe, box((cx - 0.19, 0.42, cz - 0.19), (cx + 0.19, 0.48, cz + 0.19))))
        for u in (-0.15, 0.15):
            for v in (-0.15, 0.15):
                parts.append((iron, tube([(cx + u * 1.2, -0.02, cz + v * 1.2), (cx + u, 0.44, cz + v)], 0.025, 6)))
        back = [(cx + 0.2 * np.cos(angle) + u * np.sin(angle), cz + 0.2 * np.sin(angle) - u * np.cos(angle)) for u in (-0.18, 0.18)]
        parts.append((stripe, tube([(back[0][0], 0.45, back[0][1]), (back[0][0], 0.85, back[0][1]),
            (back[1][0], 0.85, back[1][1]), (back[1][0], 0.45, back[1][1])], 0.035, 6)))
    return parts


def lamp(x, z):
    post = lathe([(0.0, -0.1), (0.2, -0.1), (0.18, 0.18), (0.07, 0.32), (0.055, 2.6), (0.1, 2.68), (0.0, 2.68)], 12)
    lantern = lathe([(0.0, 2.68), (0.13, 2.68), (0.24, 3.1), (0.0, 3.1)], 6)
    hat = lathe([(0.0, 3.06), (0.3, 3.08), (0.12, 3.28), (0.05, 3.38), (0.0, 3.42)], 6)
    return [(iron, move(post, (x, 0, z))), (lamp_glass, move(lantern, (x, 0, z))), (iron, move(hat, (x, 0, z)))]


def tub(x, z, petals, scale=1.0):
    pot = lathe([(0.0, -0.05), (0.26, -0.05), (0.34, 0.36), (0.4, 0.38), (0.4, 0.48), (0.0, 0.48)], 14)
    parts = [(clay, move((pot[0] * scale, pot[1]), (x, 0.0, z)))]
    for k in range(7):
        angle, r = 2 * np.pi * k / 6, 0.0 if k == 6 else 0.24
        middle = (x + scale * r * np.cos(angle), scale * (0.58 + (0.12 if k == 6 else 0.05 * (k % 2))), z + scale * r * np.sin(angle))
        size = scale * rng.uniform(0.16, 0.21)
        parts.append((petals if k % 2 == 0 else leaf, ball(middle, (size, size, size), 10)))
    return parts


def pennants(start, end, sag, count, colours):
    """A string that hangs, and triangles on it."""
    start, end = np.array(start, float), np.array(end, float)
    def at(t):
        return start + (end - start) * t + (0.0, -sag * 4.0 * t * (1.0 - t), 0.0)
    parts = [(iron, tube([at(t) for t in np.linspace(0.0, 1.0, 17)], 0.022, 6))]
    for k in range(count):
        t = (k + 0.5) / count
        p, along = at(t), at(t + 0.01) - at(t - 0.01)
        along /= np.linalg.norm(along)
        out = np.cross(along, (0.0, 1.0, 0.0)) * 0.016
        flag = [p - 0.19 * along, p + 0.19 * along, p + (0.0, -0.5, 0.0)]
        parts.append((colours[k % len(colours)], loft([[q - out for q in flag], [q + out for q in flag]])))
    return parts


stone = model.material("stone", "#cfc3ae")
slab, slab_dark = model.material("slab", "#d9b48f"), model.material("dark slab", "#c58f6c")
earth = model.material("ground", "#e3cfa4")
white, glass = model.material("white", "#fbf4e6"), model.material("glass", "#7fb4c9")
wood, brick, iron = (model.material(*m) for m in (("wood", "#7a4a2c"), ("brick", "#b5523b"), ("iron", "#2f4858")))
cream, red, teal = (model.material(*m) for m in (("cream", "#fff3d6"), ("red", "#d8432f"), ("teal", "#1f8a8a")))
leaf, leaf_light, bark = (model.material(*m) for m in (("leaf", "#4f9a4a"), ("light leaf", "#7cb84f"), ("bark", "#6b4a33")))
water_blue, clay = model.material("water", "#4aa3d8"), model.material("clay", "#c8683f")
lamp_glass, yellow = model.material("lamp", "#ffe28a"), model.material("yellow", "#f4b72e")
pink, violet = model.material("pink", "#e8679a"), model.material("violet", "#8b5fbf")

model.node("ground", [(earth, ground())])
model.node("paving", paving())
model.node("fountain", fountain(), crease_degrees=40)
house("left", -7.3, -0.9, 1.15, 1.25, 3.6, 5.3, ("#f2a65a", "#a8462f", "#2f6f8f"), "house")
house("rose", -5.2, -3.9, 0.62, 1.3, 4.9, 6.5, ("#e88d8d", "#8f4a3a", "#5a7d4f"), "shop")
house("blue", -1.85, -5.6, 0.2, 1.45, 5.1, 6.9, ("#8fc1d9", "#b5533c", "#e0b040"), "house")
house("yellow", 1.75, -5.7, -0.18, 1.3, 3.7, 5.6, ("#f6d365", "#a04a3f", "#3f7f6f"), "house")
house("mint", 5.05, -4.1, -0.6, 1.5, 4.9, 6.7, ("#a8d5a2", "#9c4436", "#c2553f"), "café")
house("right", 7.5, -1.0, -1.12, 1.25, 3.5, 5.2, ("#c9a7dd", "#86483f", "#3d5a80"), "house")
model.node("tree", tree(-5.1, 2.6))
model.node("parasols", parasol(4.3, 0.5, cream, red) + parasol(6.0, 2.5, cream, teal), crease_degrees=30)
model.node("lamps", lamp(-2.9, -2.7) + lamp(3.1, -2.8) + lamp(-2.7, 4.3))
model.node("tubs", tub(-3.3, -3.2, red) + tub(0.0, -4.0, pink) + tub(3.2, 4.4, violet, 1.25) + tub(-7.0, 1.6, yellow)
    + tub(2.2, 5.0, yellow, 0.95))
flags = (red, yellow, teal, pink, water_blue)
model.node("pennants", pennants((-4.6, 4.6, -2.6), (0.0, 4.7, -4.2), 0.7, 9, flags)
    + pennants((0.0, 4.7, -4.2), (4.4, 4.5, -2.7), 0.7, 9, flags[::-1]))
model.save("scenes/square.glb")
