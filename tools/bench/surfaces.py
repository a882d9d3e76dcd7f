"""Compares Fumetto's surfaces with splashsurf and with VTK's flying edges, on the same particles and cells.

Run it from the repository's root, after `cargo build --release -p fumetto-bench`:

    python3 tools/bench/surfaces.py [--bench target/release/fumetto-bench] [--rounds 5]

It needs NumPy, `numba`, `vtk` and `pysplashsurf` (`pip install numba vtk pysplashsurf`). For every size it runs
Fumetto's benchmark and then the other two, so that whatever else the machine does hits all alike. Times are
the fastest of all rounds. Fumetto's is that of its column less that of `puffs`, which reads the same file.

- *VTK* is the fastest way that we know with public libraries: particles are splatted onto a grid by as many
  threads as there are cores (compiled by numba, slabs of the grid in parallel, the same field as ours), and
  `vtkFlyingEdges3D` contours it and works out normals, in threads too.
- *splashsurf* has a field of its own (a cubic spline of the same reach, normalised by the particles' density), its
  threshold is chosen so that the surface lies about where ours does.
"""

import argparse
import csv
import math
import os
import pathlib
import subprocess
import tempfile
import time

import numba
import numpy as np
import pysplashsurf
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D

# Particles, and cells along the longest side.
CASES = [(12, 22), (200, 64), (10_000, 64), (100_000, 128), (1_000_000, 256)]
THRESHOLD = 0.5
SHARES = (0.8191725133961644, 0.6710436067037893, 0.5497004779019703)


def cube(count):
    """The particles of `crates/fumetto-bench/src/cube.rs`: their places, and their radius."""
    index = np.arange(count, dtype=np.float64)
    places = np.stack([2.0 * (np.mod(share * index, 1.0) - 0.5) for share in SHARES], axis=1)
    return places.astype(np.float32), np.float32(2.5 / np.cbrt(float(count)))


def cell_of(places, radius, cells):
    """Cells come in steps of a quarter of an octave."""
    longest = float((places.max(axis=0) - places.min(axis=0)).max() + 2.0 * radius)
    return 2.0 ** (math.ceil(4.0 * math.log2(longest / cells)) / 4.0)


@numba.njit(parallel=True, fastmath=True, cache=False)
def splat(places, radius, cell, origin, shape, order, starts, field):
    """Adds (1 - (d/r)²)² to the points that particles reach; slabs across z are independent."""
    slabs = starts.size - 1
    reach = int(math.ceil(radius / cell))
    inverse = 1.0 / (radius * radius)
    for z in numba.prange(shape[0]):
        pz = origin[2] + z * cell
        for slab in range(max(z - reach - 1, 0), min(z + reach + 2, slabs)):
            for at in range(starts[slab], starts[slab + 1]):
                x, y, w = places[order[at]]
                left_z = radius * radius - (w - pz) ** 2
                if left_z <= 0.0:
                    continue
                span_y = math.sqrt(left_z)
                first_y = max(int(math.ceil((y - span_y - origin[1]) / cell)), 0)
                last_y = min(int(math.floor((y + span_y - origin[1]) / cell)), shape[1] - 1)
                for j in range(first_y, last_y + 1):
                    left = left_z - (origin[1] + j * cell - y) ** 2
                    if left <= 0.0:
                        continue
                    span_x = math.sqrt(left)
                    first_x = max(int(math.ceil((x - span_x - origin[0]) / cell)), 0)
                    last_x = min(int(math.floor((x + span_x - origin[0]) / cell)), shape[2] - 1)
                    for i in range(first_x, last_x + 1):
                        fall = (left - (origin[0] + i * cell - x) ** 2) * inverse
                        field[z, j, i] += fall * fall


def vtk_surface(places, radius, cell):
    """Triangles of the same field on a dense grid."""
    low = np.floor((places.min(axis=0) - radius) / cell).astype(np.int64) - 1
    high = np.ceil((places.max(axis=0) + radius) / cell).astype(np.int64) + 1
    origin = (low * cell).astype(np.float32)
    shape = tuple(int(n) for n in (high - low + 1)[::-1])
    slab = ((places[:, 2] - origin[2]) / cell).astype(np.int64)
    order = np.argsort(slab, kind="stable")
    starts = np.searchsorted(slab[order], np.arange(shape[0] + 1))
    field = np.zeros(shape, np.float32)
    splat(places, radius, np.float32(cell), origin, shape, order, starts, field)
    image = vtkImageData()
    image.SetDimensions(shape[2], shape[1], shape[0])
    image.SetSpacing(cell, cell, cell)
    image.SetOrigin(*(float(value) for value in origin))
    image.GetPointData().SetScalars(numpy_to_vtk(field.ravel()))
    contour = vtkFlyingEdges3D()
    contour.SetInputData(image)
    contour.SetValue(0, THRESHOLD)
    contour.ComputeNormalsOn()
    contour.ComputeScalarsOff()
    contour.Update()
    return contour.GetOutput().GetNumberOfPolys()


def splashsurf_surface(places, radius, cell):
    """Triangles of splashsurf's field: its kernel reaches four of its particles' radii."""
    own = radius / 4.0
    made = pysplashsurf.reconstruct_surface(
        places,
        particle_radius=own,
        rest_density=1000.0,
        smoothing_length=2.0,
        cube_size=cell / own,
        iso_surface_threshold=0.6 * THRESHOLD,
        multi_threading=True,
        global_neighborhood_list=False,
        subdomain_grid=True,
    )
    return len(made.mesh.triangles)


def fastest(rounds, work, *arguments):
    """Milliseconds, and what came of it. The first, which compiles, does not count."""
    work(*arguments)
    best, made = math.inf, 0
    for _ in range(rounds):
        begin = time.perf_counter()
        made = work(*arguments)
        best = min(best, 1e3 * (time.perf_counter() - begin))
    return best, made


def fumetto(bench, count, cells):
    """Milliseconds and triangles of our own benchmark."""
    with tempfile.TemporaryDirectory() as folder:
        for variant in ("puffs", f"{cells} cells"):
            command = [bench, "--out", f"{folder}/{variant[0]}", "--sizes", str(count)]
            command += ["--filter", f"surface/{variant}"]
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        rows = [next(csv.DictReader(open(path))) for path in sorted(pathlib.Path(folder).glob("*/bench.csv"))]
    surface = next(row for row in rows if row["variant"] != "puffs")
    puffs = next(row for row in rows if row["variant"] == "puffs")
    return float(surface["min_ms"]) - float(puffs["min_ms"]), int(surface["triangles"])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bench", default="target/release/fumetto-bench", help="our benchmark")
    parser.add_argument("--rounds", type=int, default=5, help="of the others")
    parser.add_argument("--most", type=int, default=CASES[-1][0], help="particles of the largest case")
    options = parser.parse_args()
    cores = len(os.sched_getaffinity(0))
    numba.set_num_threads(cores)
    vtkSMPTools.SetBackend("STDThread")
    vtkSMPTools.Initialize(cores)
    print("| particles | cells | Fumetto | VTK | splashsurf | µs a triangle: Fumetto | VTK | splashsurf |")
    print("| ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |")
    for count, cells in (case for case in CASES if case[0] <= options.most):
        places, radius = cube(count)
        cell = cell_of(places, radius, cells)
        ours = fumetto(options.bench, count, cells)
        vtk = fastest(options.rounds, vtk_surface, places, radius, cell)
        splash = fastest(options.rounds, splashsurf_surface, places, radius, cell)
        all_three = (ours, vtk, splash)
        times = " | ".join(f"{ms:.3g} ms, {made:,}" for ms, made in all_three)
        each = " | ".join(f"{1e3 * ms / max(made, 1):.2f}" for ms, made in all_three)
        print(f"| {count:,} | {cells} | {times} | {each} |", flush=True)


if __name__ == "__main__":
    main()
