"""Draws the ramps of `scenes/shadings.toml`: `scenes/ramp-*.png`.

Columns run from dark to light. In those with several rows, these run from near to far, from facing to
edge-on, or from sharp to blurred. Run it from the repository's root: `python3 tools/scenes/ramps.py`; it
needs NumPy.
"""

import struct
import zlib

import numpy as np

WIDTH, ROWS = 256, 64


def linear(hex_colour):
    srgb = np.array([int(hex_colour[i : i + 2], 16) for i in (1, 3, 5)], float) / 255.0
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


def encoded(light):
    srgb = np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1.0 / 2.4) - 0.055)
    return np.rint(np.clip(srgb, 0.0, 1.0) * 255.0).astype(np.uint8)


def bands(tones, soft):
    """A row of `(colour, from)` tones, whose borders are `soft` wide."""
    x = (np.arange(WIDTH) + 0.5) / WIDTH
    row = np.tile(linear(tones[0][0]), (WIDTH, 1))
    for colour, start in tones[1:]:
        share = np.clip((x - start) / max(soft, 1e-6) + 0.5, 0.0, 1.0)[:, None]
        row = row * (1.0 - share) + linear(colour) * share
    return row


def down(top, bottom, ease=1.0):
    """Rows from `top` to `bottom`."""
    share = (np.linspace(0.0, 1.0, ROWS) ** ease)[:, None, None]
    return top * (1.0 - share) + bottom * share


def save(path, picture):
    rgb = encoded(picture)
    height, width, _ = rgb.shape
    rows = b"".join(b"\0" + row.tobytes() for row in rgb)

    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))

    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)))
        file.write(chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


# Dusk: the hue turns with the light, and a warm band lies along the border of the shade.
dusk = [("#2f2a5a", 0.0), ("#5a3f7d", 0.1), ("#e0603f", 0.3), ("#f2a65a", 0.38), ("#f9dc9c", 0.68)]
save("scenes/ramp-dusk.png", bands(dusk, 0.03)[None])

# Air: tones near by, one pale colour far off.
tones = bands([("#23405e", 0.0), ("#4f7fa3", 0.22), ("#a9cfd8", 0.48), ("#f4f8ee", 0.8)], 0.004)
air = bands([("#d5dfe2", 0.0)], 0.0)
save("scenes/ramp-air.png", down(tones, air, 0.9))

# Velvet: dark where it faces the viewer, light where it is seen edge-on.
front = bands([("#3a1330", 0.0), ("#641c46", 0.25), ("#8d2c58", 0.6)], 0.05)
edge = bands([("#b9638a", 0.0), ("#f0a9b4", 0.3), ("#ffe3dc", 0.6)], 0.05)
save("scenes/ramp-velvet.png", down(front, edge, 1.6))

# Focus: crisp tones in it, a soft wash around.
crisp = bands([("#3d2f2a", 0.0), ("#8a5a3c", 0.2), ("#d9a066", 0.45), ("#fbeccb", 0.75)], 0.004)
wash = bands([("#cdb99f", 0.0), ("#ede1cb", 0.9)], 1.0)
save("scenes/ramp-focus.png", down(crisp, wash, 0.8))
