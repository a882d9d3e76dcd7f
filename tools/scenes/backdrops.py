"""Draws the pictures behind two scenes: `scenes/roof.png` and `scenes/lamp.png`.

Flat shapes with an ink line round each, as a background artist would paint them. Run it from the
repository's root: `python3 tools/scenes/backdrops.py`; it needs NumPy.
"""

import struct
import zlib

import numpy as np

WIDTH, HEIGHT, SAMPLES = 1280, 720, 3


def colour(hex_colour):
    return np.array([int(hex_colour[i : i + 2], 16) for i in (1, 3, 5)], float) / 255.0


class Canvas:
    def __init__(self, top, bottom):
        down = np.linspace(0.0, 1.0, HEIGHT * SAMPLES)[:, None, None]
        sky = colour(top) * (1.0 - down) + colour(bottom) * down
        self.pixels = np.repeat(sky, WIDTH * SAMPLES, axis=1)
        ys, xs = np.mgrid[0 : HEIGHT * SAMPLES, 0 : WIDTH * SAMPLES]
        self.x, self.y = (xs + 0.5) / SAMPLES, (ys + 0.5) / SAMPLES

    def polygon(self, points, fill, ink=None, width=3.0):
        inside = np.zeros(self.x.shape, bool)
        near = np.full(self.x.shape, np.inf)
        for (x0, y0), (x1, y1) in zip(points, points[1:] + points[:1]):
            crosses = (y0 > self.y) != (y1 > self.y)
            with np.errstate(divide="ignore", invalid="ignore"):
                inside ^= crosses & (self.x < (x1 - x0) * (self.y - y0) / (y1 - y0) + x0)
            along = np.array([x1 - x0, y1 - y0])
            t = ((self.x - x0) * along[0] + (self.y - y0) * along[1]) / max(along @ along, 1e-9)
            t = np.clip(t, 0.0, 1.0)
            near = np.minimum(near, np.hypot(self.x - x0 - t * along[0], self.y - y0 - t * along[1]))
        self.pixels[inside] = colour(fill)
        if ink:
            self.pixels[near < 0.5 * width] = colour(ink)

    def save(self, path):
        shape = (HEIGHT, SAMPLES, WIDTH, SAMPLES, 3)
        rgb = np.rint(self.pixels.reshape(shape).mean(axis=(1, 3)) * 255.0).astype(np.uint8)
        rows = b"".join(b"\0" + row.tobytes() for row in rgb)

        def chunk(kind, data):
            body = kind + data
            return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))

        header = struct.pack(">IIBBBBB", WIDTH, HEIGHT, 8, 2, 0, 0, 0)
        with open(path, "wb") as file:
            file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header))
            file.write(chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def curve(points, steps=14):
    """A smooth closed outline through `points` (Catmull–Rom)."""
    smooth = []
    count = len(points)
    for i in range(count):
        p0, p1, p2, p3 = (np.array(points[(i + k) % count], float) for k in (-1, 0, 1, 2))
        for t in np.linspace(0.0, 1.0, steps, endpoint=False):
            smooth.append(tuple(0.5 * (
                2 * p1 + (p2 - p0) * t + (2 * p0 - 5 * p1 + 4 * p2 - p3) * t**2
                + (3 * p1 - p0 - 3 * p2 + p3) * t**3)))
    return smooth


def roof():
    ink = "#2a2036"
    canvas = Canvas("#f2a977", "#fdeccf")
    hills = [(0, 640), (160, 596), (360, 622), (560, 585), (800, 618), (1010, 580), (1280, 612), (1280, 720), (0, 720)]
    canvas.polygon(hills, "#d98f74")
    canvas.polygon([(0, 672), (300, 640), (640, 664), (1000, 634), (1280, 660), (1280, 720), (0, 720)], "#b56f69")
    # The chimney: a lit side, a dark side, a cap.
    canvas.polygon([(196, 560), (258, 560), (258, 700), (196, 700)], "#c8624f", ink)
    canvas.polygon([(258, 560), (286, 552), (286, 690), (258, 700)], "#8c3f45", ink)
    for row, y in enumerate(range(580, 690, 22)):
        for x in range(200 + 15 * (row % 2), 252, 30):
            canvas.polygon([(x, y), (x + 16, y), (x + 16, y + 2), (x, y + 2)], "#a44b45")
    canvas.polygon([(186, 540), (266, 540), (266, 562), (186, 562)], "#d9785f", ink)
    canvas.polygon([(266, 540), (297, 531), (297, 552), (266, 562)], "#96464a", ink)
    # The roof in front of it.
    canvas.polygon([(-20, 720), (150, 636), (560, 720)], "#6d3b52", ink)
    canvas.polygon([(150, 636), (212, 628), (640, 720), (560, 720)], "#4f2b45", ink)
    canvas.save("scenes/roof.png")


def lamp():
    ink = "#140f2b"
    canvas = Canvas("#181534", "#5d3c74")
    canvas.polygon([(0, 664), (1280, 664), (1280, 720), (0, 720)], "#2c1d45")
    handle = curve([(806, 600), (862, 556), (912, 572), (906, 626), (842, 648), (850, 632), (884, 614), (888, 584), (862, 576), (822, 616)])
    canvas.polygon(handle, "#c98a2b", ink)
    canvas.polygon(curve([(690, 664), (730, 644), (790, 644), (828, 664), (760, 676)]), "#a86a24", ink)
    body = curve([(520, 560), (560, 572), (620, 590), (690, 576), (760, 570), (830, 590), (842, 620), (790, 648), (710, 652), (640, 640), (580, 602), (530, 586), (508, 572)])
    canvas.polygon(body, "#e9b13f", ink)
    canvas.polygon(curve([(640, 634), (720, 636), (800, 622), (834, 606), (836, 622), (788, 645), (712, 649), (660, 643)]), "#b97a2c")
    canvas.polygon(curve([(600, 596), (660, 596), (720, 586), (700, 596), (640, 606)]), "#ffe08a")
    canvas.polygon(curve([(706, 572), (760, 546), (812, 574), (760, 582)]), "#d79a34", ink)
    canvas.polygon(curve([(748, 546), (760, 526), (774, 546), (760, 552)]), "#e9b13f", ink)
    canvas.save("scenes/lamp.png")


roof()
lamp()
