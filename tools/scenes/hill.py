"""Writes `scenes/hill.glb` and `scenes/sky.glb`: land under a storm, and the air behind it.

The land is one sheet of rolling hills that fall away to a plain, with an oak on the nearest of them, its crown
blown to one side, and poplars farther down. The sky is a flat sheet whose normals lean back with its height, so
that light from above left fades toward the top: an engraver rules such skies with level lines.

Run it from the repository's root: `python3 tools/scenes/hill.py`; it needs NumPy.
"""

import numpy as np

from glb import Glb, unit
from solids import gradient, smooth_union, surface, tube

# The land: half its width, and from how far behind the middle to how far before it.
HALF_WIDTH, BACK, FRONT = 26.0, -24.0, 13.0
COLUMNS, ROWS = 120, 90

# A trunk: x, y, z and radius. A crown: the same of its lobes, leaning away from the wind.
OAK_TRUNK = [(0, -0.3, 0, 0.17), (0.01, 0.0, 0, 0.115), (0.04, 0.28, 0, 0.085), (0.1, 0.55, 0, 0.075),
    (0.2, 0.85, 0, 0.05)]
OAK = [
    (0.26, 1.12, 0.0, 0.36), (-0.06, 0.98, 0.08, 0.25), (0.62, 1.05, 0.04, 0.3), (0.42, 1.4, 0.0, 0.27),
    (0.08, 1.34, 0.06, 0.22), (0.32, 0.92, 0.26, 0.24), (0.88, 1.24, 0.0, 0.19), (-0.22, 1.16, 0.04, 0.14),
    (0.5, 1.2, 0.28, 0.17), (0.72, 1.4, 0.05, 0.15), (0.12, 0.86, 0.2, 0.17), (0.28, 1.6, 0.03, 0.14),
    (1.08, 1.1, 0.04, 0.11), (0.9, 0.92, 0.08, 0.15), (0.56, 0.82, 0.14, 0.16),
]
POPLAR = [(0.0, 0.3, 0.0, 0.16), (0.01, 0.52, 0.0, 0.17), (0.0, 0.76, 0.0, 0.14), (0.02, 0.98, 0.0, 0.1)]


def land_y(x, z):
    """A hill on the left, a lower one on the right, and a ridge behind them that hides the storm's foot."""
    hill = 1.35 * np.exp(-(((x + 3.6) / 3.6) ** 2) - ((z - 3.6) / 3.4) ** 2)
    shoulder = 1.0 * np.exp(-(((x - 5.6) / 4.4) ** 2) - ((z - 3.0) / 2.4) ** 2)
    ridge = 0.85 * np.exp(-(((z - 1.6) / 1.5) ** 2)) * (1.0 + 0.25 * np.sin(0.55 * x + 2.2))
    waves = 0.07 * np.sin(0.9 * x + 0.6 * z) + 0.05 * np.sin(0.7 * z - 1.3 * x + 2.0)
    return -0.55 + hill + shoulder + ridge + waves


def land():
    x, z = np.meshgrid(np.linspace(-HALF_WIDTH, HALF_WIDTH, COLUMNS), np.linspace(BACK, FRONT, ROWS))
    x, z = x.ravel(), z.ravel()
    step = 1e-3
    slope_x = (land_y(x + step, z) - land_y(x - step, z)) / (2.0 * step)
    slope_z = (land_y(x, z + step) - land_y(x, z - step)) / (2.0 * step)
    normals = unit(np.stack([-slope_x, np.ones_like(x), -slope_z], axis=1))
    return (np.stack([x, land_y(x, z), z], axis=1), quads(COLUMNS, ROWS), normals)


def quads(columns, rows):
    """Triangles of a sheet whose rows come toward the viewer."""
    corner = (np.arange(rows - 1)[:, None] * columns + np.arange(columns - 1)).ravel()
    a, b, c, d = corner, corner + 1, corner + columns, corner + columns + 1
    return np.concatenate([np.stack([a, c, d], axis=1), np.stack([a, d, b], axis=1)])


def crown(lobes, cell):
    lobes = np.array(lobes, float)
    def field(points):
        return smooth_union([np.linalg.norm(points - lobe[:3], axis=1) - lobe[3] for lobe in lobes], 0.06)
    reach = lobes[:, 3:] + 0.1
    places, triangles = surface(field, (lobes[:, :3] - reach).min(axis=0), (lobes[:, :3] + reach).max(axis=0), cell)
    return (places, triangles, unit(gradient(field, places)))


def stand(glb, name, leaf, bark, place, trunk, lobes, cell):
    x, z = place
    path, radii = zip(*[((px, py, pz), r) for px, py, pz, r in trunk])
    at = (x, float(land_y(x, z)), z)
    glb.node(f"{name} trunk", [(bark, tube(path, radii, 9))], translation=at, crease_degrees=60)
    glb.node(name, [(leaf, crown(lobes, cell))], translation=at)


def sky():
    columns, rows = 2, 40
    x, down = np.meshgrid([-30.0, 30.0], np.linspace(0.0, 1.0, rows))
    x, down = x.ravel(), down.ravel()
    lean = np.radians(60.0 - 135.0 * down)
    normals = np.stack([np.zeros_like(x), -np.sin(lean), np.cos(lean)], axis=1)
    return (np.stack([x, 20.0 - 22.0 * down, np.full_like(x, -26.0)], axis=1), quads(columns, rows), normals)


def main():
    glb = Glb()
    grass = glb.material("grass", "#a3bf69", double_sided=True)
    leaf = glb.material("leaf", "#6fa567")
    bark = glb.material("bark", "#8a6152")
    glb.node("land", [(grass, land())])
    stand(glb, "oak", leaf, bark, (-3.9, 4.6), OAK_TRUNK, OAK, 0.06)
    for number, place in enumerate([(4.1, 3.6), (4.55, 3.3), (4.95, 3.5), (6.3, 2.8)]):
        stand(glb, f"poplar {number + 1}", leaf, bark, place, [(0, -0.2, 0, 0.05), (0, 0.3, 0, 0.03)], POPLAR, 0.06)
    glb.save("scenes/hill.glb")

    glb = Glb()
    air = glb.material("air", "#ffffff", double_sided=True)
    glb.node("sky", [(air, sky())])
    glb.save("scenes/sky.glb")


main()
