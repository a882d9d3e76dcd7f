#!/usr/bin/env python3
"""Times a step of a smoke simulation in other programs, to hold `fumetto-bench --filter grid` against.

Taichi (`pip install taichi`): MacCormack advection of velocity and smoke on a staggered grid, buoyancy, and a
pressure by 60 iterations of conjugate gradients, on the CPU. Blender's Mantaflow (`blender` on the path): a baked
frame, with the files that it writes.

    python3 tools/bench/grids.py [taichi] [mantaflow] [--cells 64 128]
"""

import argparse
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

ITERATIONS = 60
WARM_UP = 5
STEPS = 9


def taichi(cells):
    """Seconds of a step, and the root mean square of divergence before and after projection."""
    import taichi as ti

    ti.init(arch=ti.cpu, log_level=ti.ERROR, random_seed=1)
    n = cells
    dt = 0.04 * n  # of 1/24 s and a box of about a metre: velocity is in boxes, places are in cells
    shape = (n + 1, n + 1, n + 1)
    velocity = [ti.field(ti.f32, shape) for _ in range(3)]
    guess = [ti.field(ti.f32, shape) for _ in range(3)]
    moved = [ti.field(ti.f32, shape) for _ in range(3)]
    smoke, smoke_guess, smoke_moved = (ti.field(ti.f32, shape) for _ in range(3))
    x, r, d, q, b = (ti.field(ti.f32, (n, n, n)) for _ in range(5))
    u, v, w = velocity

    @ti.func
    def sample(f, p, last):
        p = ti.max(ti.Vector([0.0, 0.0, 0.0]), ti.min(p, last))
        i = ti.min(ti.floor(p, int), ti.cast(last, int) - 1)
        s = p - i
        c = 0.0
        for o in ti.static(ti.ndrange(2, 2, 2)):
            weight = 1.0
            for a in ti.static(range(3)):
                weight *= s[a] if ti.static(o[a] == 1) else 1 - s[a]
            c += weight * f[i + ti.Vector(o)]
        return c

    @ti.func
    def limits(f, p, last):
        p = ti.max(ti.Vector([0.0, 0.0, 0.0]), ti.min(p, last))
        i = ti.min(ti.floor(p, int), ti.cast(last, int) - 1)
        low, high = f[i], f[i]
        for o in ti.static(ti.ndrange(2, 2, 2)):
            low = ti.min(low, f[i + ti.Vector(o)])
            high = ti.max(high, f[i + ti.Vector(o)])
        return low, high

    @ti.func
    def at_face(axis: ti.template(), i):
        """Velocity in the middle of a face, or of a cell where `axis` is 3."""
        before, after = i, i
        if ti.static(axis < 3):
            before[axis] = ti.max(i[axis] - 1, 0)
            after[axis] = ti.min(i[axis], n - 1)
        sum = ti.Vector([0.0, 0.0, 0.0])
        for a in ti.static(range(3)):
            if ti.static(a == axis):
                sum[a] = velocity[a][i]
            else:
                e = ti.Vector.unit(3, a, int)
                f = ti.static(velocity[a])
                sum[a] = 0.25 * (f[before] + f[before + e] + f[after] + f[after + e])
        return sum

    @ti.kernel
    def forward(axis: ti.template(), f: ti.template(), out: ti.template()):
        extent = ti.Vector([n + (a == axis) for a in range(3)])
        for i in ti.grouped(ti.ndrange(*[n + (a == axis) for a in range(3)])):
            out[i] = sample(f, i - dt * at_face(axis, i), extent - 1.0)

    @ti.kernel
    def correct(axis: ti.template(), f: ti.template(), g: ti.template(), out: ti.template()):
        extent = ti.Vector([n + (a == axis) for a in range(3)])
        for i in ti.grouped(ti.ndrange(*[n + (a == axis) for a in range(3)])):
            shift = dt * at_face(axis, i)
            low, high = limits(f, i - shift, extent - 1.0)
            better = g[i] + 0.5 * (f[i] - sample(g, i + shift, extent - 1.0))
            out[i] = ti.max(low, ti.min(high, better))

    @ti.kernel
    def lift():
        for i in ti.grouped(ti.ndrange(n, n, n)):
            p = (i + 0.5) / n - ti.Vector([0.5, 0.1, 0.5])
            if p.norm() < 0.08:
                smoke[i] = 1.0
        for i in ti.grouped(ti.ndrange(n, (1, n), n)):
            v[i] += 0.04 * 1.0 * 0.5 * (smoke[i] + smoke[i - ti.Vector([0, 1, 0])])

    @ti.kernel
    def divergence() -> ti.f32:
        square = 0.0
        for i in ti.grouped(b):
            total = 0.0
            for a in ti.static(range(3)):
                total += velocity[a][i + ti.Vector.unit(3, a, int)] - velocity[a][i]
            b[i] = -total
            square += total * total
        return ti.sqrt(square / n**3)

    @ti.func
    def laplacian(f, i):
        total = 0.0
        for a in ti.static(range(3)):
            e = ti.Vector.unit(3, a, int)
            total += f[i] - f[i - e] if i[a] > 0 else 2 * f[i]
            total += f[i] - f[i + e] if i[a] < n - 1 else 2 * f[i]
        return total

    @ti.kernel
    def begin() -> ti.f32:
        square = 0.0
        for i in ti.grouped(x):
            x[i] = 0.0
            r[i] = b[i]
            d[i] = b[i]
            square += b[i] * b[i]
        return square

    @ti.kernel
    def apply() -> ti.f32:
        total = 0.0
        for i in ti.grouped(d):
            q[i] = laplacian(d, i)
            total += d[i] * q[i]
        return total

    @ti.kernel
    def advance(alpha: ti.f32) -> ti.f32:
        square = 0.0
        for i in ti.grouped(x):
            x[i] += alpha * d[i]
            r[i] -= alpha * q[i]
            square += r[i] * r[i]
        return square

    @ti.kernel
    def turn(beta: ti.f32):
        for i in ti.grouped(d):
            d[i] = r[i] + beta * d[i]

    @ti.kernel
    def project():
        for a in ti.static(range(3)):
            e = ti.Vector.unit(3, a, int)
            for i in ti.grouped(ti.ndrange(*[n + (c == a) for c in range(3)])):
                # Pressure is zero on the walls of the box.
                if i[a] == 0:
                    velocity[a][i] -= 2 * x[i]
                elif i[a] == n:
                    velocity[a][i] += 2 * x[i - e]
                else:
                    velocity[a][i] -= x[i] - x[i - e]

    def step():
        for axis, (f, g, out) in enumerate(zip(velocity + [smoke], guess + [smoke_guess], moved + [smoke_moved])):
            forward(axis, f, g)
            correct(axis, f, g, out)
        for f, out in zip(velocity + [smoke], moved + [smoke_moved]):
            f.copy_from(out)
        lift()
        before = divergence()
        rest = begin()
        for _ in range(ITERATIONS):
            if rest == 0:
                break
            product = apply()
            new = advance(rest / product)
            turn(new / rest)
            rest = new
        project()
        return before

    for _ in range(WARM_UP):
        before = step()
    times = []
    for _ in range(STEPS):
        start = time.perf_counter()
        before = step()
        times.append(time.perf_counter() - start)
    return statistics.median(times), before, divergence()


BLENDER = """
import bpy, time
cells, frames, folder = {cells}, {frames}, {folder!r}
bpy.data.objects.remove(bpy.data.objects["Cube"])
scene = bpy.context.scene
scene.frame_start, scene.frame_end = 1, frames
bpy.ops.mesh.primitive_cube_add(size=1, location=(0, 0, 0.5))
domain = bpy.context.object
domain.modifiers.new("fluid", "FLUID").fluid_type = "DOMAIN"
settings = domain.modifiers["fluid"].domain_settings
settings.domain_type = "GAS"
settings.resolution_max = cells
settings.use_adaptive_domain = False
settings.cache_type = "REPLAY"
settings.cache_directory = folder
settings.cache_frame_start, settings.cache_frame_end = 1, frames
bpy.ops.mesh.primitive_uv_sphere_add(radius=0.08, location=(0, 0, 0.12))
flow = bpy.context.object
flow.modifiers.new("fluid", "FLUID").fluid_type = "FLOW"
flow.modifiers["fluid"].flow_settings.flow_type = "SMOKE"
flow.modifiers["fluid"].flow_settings.flow_behavior = "INFLOW"
start = time.perf_counter()
for frame in range(1, frames + 1):
    scene.frame_set(frame)
print("SECONDS", (time.perf_counter() - start) / frames)
"""


def mantaflow(cells, frames=12):
    """Seconds of a baked frame, with the files that it writes; nothing where there is no Blender."""
    if shutil.which("blender") is None:
        return None
    with tempfile.TemporaryDirectory() as folder:
        script = pathlib.Path(folder) / "bake.py"
        script.write_text(BLENDER.format(cells=cells, frames=frames, folder=folder))
        command = ["blender", "--background", "--factory-startup", "--python", str(script)]
        outcome = subprocess.run(command, capture_output=True, text=True, check=False)
    seconds = [line.split()[1] for line in outcome.stdout.splitlines() if line.startswith("SECONDS")]
    if not seconds:
        sys.exit(f"Blender did not bake:\n{outcome.stdout[-2000:]}{outcome.stderr[-2000:]}")
    return float(seconds[0])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", nargs="*", default=["taichi", "mantaflow"])
    parser.add_argument("--cells", nargs="*", type=int, default=[64, 128])
    args = parser.parse_args()
    for cells in args.cells:
        if "taichi" in args.programs:
            seconds, before, after = taichi(cells)
            print(f"taichi     {cells:4}  {seconds:.3f} s a step, divergence from {before:.2g} to {after:.2g}")
        if "mantaflow" in args.programs:
            seconds = mantaflow(cells)
            print(f"mantaflow  {cells:4}  " + ("there is no blender" if seconds is None else f"{seconds:.3f} s a frame"))


if __name__ == "__main__":
    main()
