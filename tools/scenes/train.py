"""Writes `scenes/train.glb`: a small steam engine that runs along its rails.

It runs from x = -TRAVEL / 2 to x = TRAVEL / 2 in SECS seconds: the node "engine" moves, its wheels turn
without slipping, the rods go round with their cranks, and the body bobs a little on its springs. Every
part is a closed solid.

Run it from the repository's root: `python3 tools/scenes/train.py`; it needs NumPy. It prints where the
funnel's mouth is.
"""

import numpy as np

from glb import Glb
from solids import TAU, box, circle, extrude, lathe, loft, move, surround, tube, turned

SECS, KEYS_PER_SEC, TRAVEL = 4.0, 15, 7.0
DRIVER, PILOT = 0.56, 0.31
DRIVER_X, PILOT_X = (-0.95, 0.4), 1.5
WHEEL_Z, ROD_Z, CRANK = 0.6, 0.74, 0.27
BOILER_Y, BOILER_RADIUS = 1.5, 0.6
FUNNEL_X, FUNNEL_TOP, FUNNEL_MOUTH = 1.45, 3.2, 0.27


def along_x(profile, y, count=24):
    """A profile of radius and x, turned about the boiler's line or one beside it."""
    return turned(lathe(profile, count), (1.0, 0.0, 0.0), np.array([0.0, y, 0.0]))


def boiler(paint, brass, dark):
    r = BOILER_RADIUS
    parts = [(paint, along_x([(r, -0.8), (r, 1.0)], BOILER_Y))]
    parts.append((dark, along_x([(r + 0.05, 1.0), (r + 0.05, 1.9), (r - 0.02, 1.96)], BOILER_Y)))
    # The smokebox's door is a shallow dome, with a knob and a hinge.
    parts.append((dark, along_x([(0.5, 1.9), (0.48, 2.02), (0.34, 2.08), (0.0, 2.11)], BOILER_Y)))
    parts.append((brass, along_x([(0.09, 2.0), (0.09, 2.16), (0.0, 2.19)], BOILER_Y, 12)))
    for x in (-0.25, 0.4, 0.98):
        hoop = [(r - 0.03, x - 0.045), (r + 0.045, x - 0.045), (r + 0.045, x + 0.045), (r - 0.03, x + 0.045)]
        parts.append((brass, along_x(hoop, BOILER_Y)))
    # Dome and whistle.
    dome = lathe([(0.34, -0.2), (0.34, 0.06), (0.27, 0.12), (0.26, 0.34), (0.2, 0.46), (0.09, 0.52), (0.0, 0.53)], 18)
    parts.append((brass, move(dome, (0.1, BOILER_Y + r - 0.02, 0.0))))
    whistle = lathe([(0.035, -0.1), (0.035, 0.16), (0.08, 0.18), (0.08, 0.34), (0.0, 0.4)], 10)
    parts.append((brass, move(whistle, (-0.55, BOILER_Y + r, 0.0))))
    return parts


def funnel(dark, brass):
    """A flared stack, open at its mouth: up the outside, over the lip, down the flue."""
    foot, top = BOILER_Y + 0.4, FUNNEL_TOP
    outside = [(0.3, foot), (0.3, foot + 0.24), (0.2, foot + 0.32), (0.2, foot + 0.62), (0.4, top - 0.34),
        (0.42, top - 0.26), (0.31, top)]
    flue = [(FUNNEL_MOUTH, top), (0.16, foot + 0.7), (0.16, foot + 0.4)]
    stack = lathe(outside + flue, 20)
    band = lathe([(0.36, top - 0.33), (0.445, top - 0.33), (0.455, top - 0.25), (0.36, top - 0.25)], 20)
    return [(dark, move(stack, (FUNNEL_X, 0, 0))), (brass, move(band, (FUNNEL_X, 0, 0)))]


def cab(paint, roof, glass, brass):
    """Walls that lean out under a bowed roof."""
    parts = []
    low, high = 0.72, 2.5
    front = [(-0.62, low), (0.62, low), (0.72, high), (-0.72, high)]
    parts.append((paint, loft([[(x, y, z) for z, y in front] for x in (-1.75, -0.8)], caps="strip")))
    half = np.linspace(-0.92, 0.92, 13)
    arch = [(z, high - 0.06 + 0.34 * np.sqrt(1.0 - (z / 1.0) ** 2) ** 1.2) for z in half]
    under = [(0.97 * z, y - 0.11) for z, y in arch]
    xs = (-2.0, -1.6, -1.2, -0.8, -0.55)
    rings = [[(x, y + 0.05 * (x + 1.25) ** 2, z) for z, y in arch + under[::-1]] for x in xs]
    parts.append((roof, loft(rings, caps="strip")))
    for side in (-1, 1):
        # Windows lie on the leaning walls, a frame round a pane.
        corners = [(-1.56, 1.62), (-1.0, 1.62), (-1.0, 2.24), (-1.56, 2.24)]
        inner = [(-1.5, 1.68), (-1.06, 1.68), (-1.06, 2.18), (-1.5, 2.18)]
        for material, mesh in ((brass, surround(corners, inner, -0.06, 0.05)), (glass, extrude(inner, -0.08, 0.015))):
            places = mesh[0].copy()
            out = 0.62 + 0.1 * (places[:, 1] - low) / (high - low) + places[:, 2]
            places[:, 2] = side * out
            parts.append((material, (places, mesh[1] if side > 0 else mesh[1][:, ::-1])))
    for side in (-1, 1):
        pane = turned(extrude(circle(0.17, 14), -0.05, 0.05), (0, 1, 0), np.zeros(3))
        places = pane[0][:, [2, 1, 0]] * (1, 1, -1) + (-0.8, 2.28, 0.42 * side)
        parts.append((glass, (places, pane[1])))
    return parts


def frame(dark, brass, glass, red):
    parts = [(dark, box((-2.0, 0.6, -0.4), (1.95, 0.86, 0.4)))]
    parts.append((red, box((1.9, 0.5, -0.72), (2.08, 0.84, 0.72))))
    parts.append((red, box((-2.12, 0.5, -0.72), (-1.95, 0.84, 0.72))))
    # Running boards over the wheels.
    for side in (-1, 1):
        parts.append((dark, box((-1.9, 1.13, side * 0.62 - 0.2), (1.7, 1.2, side * 0.62 + 0.2))))
        # The cylinder, and in front of it a buffer.
        at = np.array([0.0, DRIVER + 0.2, side * 0.66])
        cylinder = lathe([(0.2, 1.14), (0.22, 1.17), (0.22, 1.74), (0.2, 1.77)], 16)
        parts.append((red, turned(cylinder, (1, 0, 0), at)))
        buffer = lathe([(0.06, 1.96), (0.06, 2.2), (0.13, 2.21), (0.13, 2.26)], 12)
        parts.append((dark, turned(buffer, (1, 0, 0), np.array([0.0, 0.67, side * 0.5]))))
    # The cowcatcher: slats that fan out from under the beam.
    for k in range(7):
        z = -0.6 + 0.2 * k
        reach = 0.62 - 0.5 * abs(z) ** 1.5
        section = ((-0.03, -0.035), (0.03, -0.035), (0.03, 0.035), (-0.03, 0.035))
        ends = ((2.02, 0.6, 0.7 * z), (2.02 + reach, 0.1, z))
        slat = loft([[(x + a, y, end + b) for a, b in section] for x, y, end in ends], caps="strip")
        parts.append((dark, slat))
    line = [(2.02 + 0.62 - 0.5 * abs(z) ** 1.5, 0.11, z) for z in np.linspace(-0.64, 0.64, 9)]
    parts.append((dark, tube(line, 0.05, 6)))
    # A lamp on a bracket.
    parts.append((dark, box((1.82, 2.02, -0.07), (2.0, 2.2, 0.07))))
    parts.append((brass, along_x([(0.17, 1.76), (0.17, 2.06), (0.21, 2.08), (0.21, 2.13)], 2.32, 14)))
    parts.append((glass, along_x([(0.165, 2.05), (0.165, 2.14), (0.1, 2.18), (0.0, 2.2)], 2.32, 14)))
    return parts


def wheel(radius, spokes, red, steel):
    """Round the z axis, at both ends of an axle."""
    parts = [(steel, extrude(circle(0.06, 10), -WHEEL_Z, WHEEL_Z))]
    for side in (-1, 1):
        z = side * WHEEL_Z
        near, far = sorted((z - 0.06, z + 0.06))
        parts.append((steel, surround(circle(radius, 28), circle(0.84 * radius, 28), near, far)))
        inner = sorted((z - 0.085 * side, z - 0.03 * side))
        parts.append((steel, surround(circle(radius + 0.05, 28), circle(0.88 * radius, 28), *inner)))
        parts.append((red, extrude(circle(0.2 * radius, 14), near - 0.02, far + 0.02)))
        for k in range(spokes):
            a = TAU * k / spokes
            u, v = np.array([np.cos(a), np.sin(a)]), np.array([-np.sin(a), np.cos(a)])
            hub, rim = 0.1 * radius * u, 0.87 * radius * u
            outline = [hub - 0.05 * v, rim - 0.032 * v, rim + 0.032 * v, hub + 0.05 * v]
            parts.append((red, extrude(outline, near + 0.025, far - 0.025)))
    return parts


def crank_pins(steel):
    for side in (-1, 1):
        low, high = sorted((side * (WHEEL_Z - 0.02), side * (ROD_Z + 0.05)))
        yield steel, move(extrude(circle(0.055, 10), low, high), (CRANK, 0.0, 0.0))


def rods(steel):
    """From crank to crank, with an eye at each."""
    parts = []
    for side in (-1, 1):
        low, high = sorted((side * (ROD_Z - 0.03), side * (ROD_Z + 0.03)))
        a, b = DRIVER_X
        parts.append((steel, extrude([(a, -0.05), (b, -0.05), (b, 0.05), (a, 0.05)], low, high)))
        for x in DRIVER_X:
            parts.append((steel, move(extrude(circle(0.1, 14), low - 0.008, high + 0.008), (x, 0.0, 0.0))))
    return parts


def track(steel, wood, gravel, grass):
    half = 10.0
    bank = [(-1.5, -0.55), (1.5, -0.55), (1.05, -0.2), (-1.05, -0.2)]
    xs = np.linspace(-half, half, 20)
    rings = [[(x, y + 0.02 * np.sin(3.0 * x), z + 0.04 * np.sin(2.1 * x)) for z, y in bank] for x in xs]
    parts = [(gravel, loft(rings, caps="strip"))]
    meadow = lathe([(11.2, -1.3), (11.6, -1.0), (11.2, -0.72), (8.5, -0.52), (4.0, -0.42), (0.0, -0.4)], 48)
    parts.append((grass, (meadow[0] * (1.0, 1.0, 0.5), meadow[1])))
    for x in np.arange(-half + 0.3, half, 0.62):
        parts.append((wood, box((x - 0.13, -0.3, -0.95), (x + 0.13, -0.09, 0.95), 0.96)))
    for side in (-1, 1):
        z = side * (WHEEL_Z)
        parts.append((steel, box((-half, -0.11, z - 0.05), (half, -0.0, z + 0.05))))
    return parts


def about_z(angles):
    return np.stack([0.0 * angles, 0.0 * angles, np.sin(0.5 * angles), np.cos(0.5 * angles)], axis=1)


def main():
    glb = Glb()
    teal = glb.material("boiler", "#4f8f9c")
    red = glb.material("red", "#c9584d")
    dark = glb.material("iron", "#5a4a5f")
    brass = glb.material("brass", "#e6b350")
    steel = glb.material("steel", "#b3acb8")
    glass = glb.material("lamplight", "#ffdf8f")
    wood = glb.material("sleeper", "#8a6152")
    gravel = glb.material("gravel", "#c8b7a3")
    grass = glb.material("grass", "#a3bf69")

    glb.node("track", track(steel, wood, gravel, grass))
    engine = glb.node("engine", translation=(-0.5 * TRAVEL, 0.0, 0.0))
    body = glb.node("body", parent=engine)
    glb.node("boiler", boiler(teal, brass, dark), body)
    glb.node("funnel", funnel(dark, brass), body)
    glb.node("cab", cab(red, dark, glass, brass), body)
    glb.node("frame", frame(dark, brass, glass, red), body)

    times = np.linspace(0.0, SECS, int(SECS * KEYS_PER_SEC) + 1)
    gone = TRAVEL * times / SECS
    still = np.zeros(len(times))
    glb.animate(engine, "translation", times, np.stack([gone - 0.5 * TRAVEL, still, still], axis=1))
    bob = 0.018 * np.sin(2.0 * gone / DRIVER)
    glb.animate(body, "translation", times, np.stack([still, bob, still], axis=1))
    axles = [
        ("wheels rear", DRIVER_X[0], DRIVER, 9), ("wheels front", DRIVER_X[1], DRIVER, 9),
        ("wheels pilot", PILOT_X, PILOT, 6),
    ]
    for name, x, radius, spokes in axles:
        parts = wheel(radius, spokes, red, steel)
        if radius == DRIVER:
            parts += crank_pins(steel)
        # It rolls toward +x: clockwise, as seen from +z.
        glb.animate(glb.node(name, parts, engine, (x, radius, 0.0)), "rotation", times, about_z(-gone / radius))
    turn = -gone / DRIVER
    circle_of_cranks = np.stack([CRANK * np.cos(turn), DRIVER + CRANK * np.sin(turn), still], axis=1)
    glb.animate(glb.node("rods", rods(steel), engine, circle_of_cranks[0]), "translation", times, circle_of_cranks)
    glb.save("scenes/train.glb")
    print(f"funnel's mouth, in the node \"engine\": {[FUNNEL_X, FUNNEL_TOP, 0.0]}, radius {FUNNEL_MOUTH}")


main()
