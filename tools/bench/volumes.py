"""Compares Fumetto's volumes with a plain ray march, Mitsuba 3 and Blender's Cycles, on the same density and at the same
error.

Run it from the repository's root, after `cargo build --release -p fumetto-bench -p fumetto-cli`:

    python3 tools/bench/volumes.py [--bin target/release] [--voxels 128 256]

It needs NumPy, Pillow and a C compiler, and measures Mitsuba too if there is the module (`pip install mitsuba`), and
Cycles if there is Blender (Debian and Ubuntu: blender and python3-openvdb). `--without` leaves these out. The
density is that of `crates/fumetto-bench/src/imported.rs`; light is scattered once, at 640 x 480. The truth is the plain
march in steps of a voxel. Of every program the cheapest picture counts that is within an RMSE of 0.01 of it:

- *Fumetto*: the picture less that of an empty scene, and the grid of light, which is the difference of two columns of
  its benchmark.
- *plain*: `march.c`, compiled for this machine, in two threads, without a grid of light or leaps over what is empty.
- *Cycles*: `cycles.py`, with no bounces in volumes; its half a voxel beside the file's place is made up for.
- *Mitsuba*: `volpath` with two events, `llvm_ad_rgb`, or scalar if there is no LLVM; twice the samples until it is good.

Times are the fastest of several rounds, and all take turns, so that whatever else the machine does hits all alike.
"""

import argparse
import csv
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

import numpy as np
from PIL import Image

WIDTH, HEIGHT = 640, 480
WANTED = 0.01
EXTINCTION = 6.0
# Steps in voxels, and the pixels along the side of the square that a ray stands for.
OURS = [(2, 1), (4, 1), (8, 1), (4, 2), (8, 2)]
ROUNDS = 3
PLAIN = [1, 1.5, 2, 3, 4, 5, 6, 8, 10]
SCENE = """format = 1
camera = {{ eye = [0.0, 0.0, 4.0], target = [0.0, 0.0, 0.0], fov = 36 }}
light = [{{ kind = "sun", direction = [0.5, -1.0, -0.6] }}]
background = {{ colour = "#000000" }}
output = {{ size = [640, 480], antialias = 1 }}
style = {{ ink = {{ on = false }} }}
[[object]]
name = "ball"
kind = "volume"
volume = "density.npy"
transform = {{ scale = {side}, position = [{first}, {first}, {first}] }}
shape = {{ volume = {{ soft = 1.0, extinction = {extinction}, light_cells = 32, step = {step}, pixels = {pixels} }} }}
"""


def density(voxels):
    """Along z, y and x."""
    place = 2.0 * (np.arange(voxels, dtype=np.float64) + 0.5) / voxels - 1.0
    z, y, x = np.meshgrid(place, place, place, indexing="ij", sparse=True)
    lumps, frequency, height = 0.0, 9.0, 1.0
    while frequency <= np.pi * voxels / 8:
        lumps = lumps + height * np.sin(frequency * x) * np.sin(frequency * y + 1) * np.sin(frequency * z + 2)
        frequency, height = 2 * frequency, 0.7 * height
    return np.clip(12 * (0.75 - np.sqrt(x * x + y * y + z * z) + 0.15 * lumps), 0, 1).astype(np.float32)


def rmse(picture, truth):
    return float(np.sqrt(np.mean((picture - truth) ** 2)))


def linear(png):
    srgb = np.asarray(Image.open(png).convert("RGB"), dtype=np.float64)[..., 0] / 255
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


def plain(folder, voxels, step, rounds):
    words = [folder / "march", folder / "density.raw", str(voxels), str(step), folder / "plain.raw"]
    run = lambda: float(subprocess.run(words, check=True, capture_output=True, text=True).stdout)
    return min(run() for _ in range(rounds)), np.fromfile(folder / "plain.raw", dtype=np.float32).reshape(HEIGHT, WIDTH)


def ours(folder, binaries, voxels, step, pixels):
    side, first = 2 / voxels, 1 / voxels - 1
    scene = SCENE.format(side=side, first=first, extinction=EXTINCTION, step=step * side, pixels=pixels)
    (folder / "scene.toml").write_text(scene)
    words = [binaries / "fumetto", "render", folder / "scene.toml", "-o", folder / "ours.png"]
    subprocess.run(words, check=True, capture_output=True)
    return linear(folder / "ours.png")


def column(step, pixels):
    """Of the benchmark."""
    squares = "" if pixels == 1 else f", squares of {pixels} pixels"
    return f"soft 640x480, steps of {step} voxels{squares}"


def benchmark(folder, binaries, voxels):
    """The fewest milliseconds of all columns."""
    words = [binaries / "fumetto-bench", "--filter", "imported/", "--sizes", str(voxels), "--out", folder / "bench"]
    subprocess.run(words, check=True, capture_output=True)
    found = {}
    for path in (folder / "bench").glob("*.csv"):
        for row in csv.DictReader(path.open()):
            if row.get("subsystem") == "imported":
                found[row["variant"]] = float(row["min_ms"])
    return found


def mitsuba(field, truth):
    """Samples a pixel and milliseconds, or None without the module."""
    try:
        import mitsuba as mi
    except ImportError:
        return None
    try:
        mi.set_variant("llvm_ad_rgb")
    except ImportError:
        mi.set_variant("scalar_rgb")
    box = mi.ScalarTransform4f().translate([-1, -1, -1]).scale(2)
    view = mi.ScalarTransform4f().look_at(origin=[0, 0, 4], target=[0, 0, 0], up=[0, 1, 0])
    scene = mi.load_dict({
        "type": "scene",
        "integrator": {"type": "volpath", "max_depth": 2, "rr_depth": 100},
        "sensor": {
            "type": "perspective", "fov": 36, "fov_axis": "y", "to_world": view,
            "film": {"type": "hdrfilm", "width": WIDTH, "height": HEIGHT, "rfilter": {"type": "box"}},
        },
        # Their phase function is that of all directions, ours gives all to each.
        "sun": {"type": "directional", "direction": [0.5, -1.0, -0.6], "irradiance": 4 * np.pi},
        "ball": {
            "type": "cube",
            "bsdf": {"type": "null"},
            "interior": {
                "type": "heterogeneous",
                "sigma_t": {"type": "gridvolume", "grid": mi.VolumeGrid(field[..., None]), "to_world": box},
                "albedo": {"type": "constvolume", "value": 1.0},
                "scale": EXTINCTION,
            },
        },
    })
    samples = 4
    while samples <= 4096:
        begin = time.perf_counter()
        picture = np.array(mi.render(scene, spp=samples))[..., 0]
        spent = 1e3 * (time.perf_counter() - begin)
        error = rmse(picture, truth)
        if error <= WANTED:
            return samples, spent, error
        # Errors fall with the root of the samples.
        samples = int(samples * min(max((error / (0.9 * WANTED)) ** 2, 1.2), 8))
    return None


def cycles(folder, voxels, truth):
    """Step in voxels, samples a pixel, milliseconds and error, or None without Blender."""
    if not shutil.which("blender"):
        return None
    truth.astype(np.float32).tofile(folder / "truth.raw")
    script = pathlib.Path(__file__).parent / "cycles.py"
    words = ["blender", "-b", "-P", script, "--", folder, str(voxels), str(WANTED)]
    log = subprocess.run(words, check=True, capture_output=True, text=True).stdout
    told = next((line.split() for line in log.splitlines() if line.startswith("CYCLES")), ["", "none"])
    if told[1] == "none":
        print(f"Cycles does not come within {WANTED}: {' '.join(told)}", file=sys.stderr)
        return None
    return int(told[1]), int(told[2]), float(told[3]), float(told[4])


def compare(folder, binaries, voxels, without):
    field = density(voxels)
    field.tofile(folder / "density.raw")
    np.save(folder / "density.npy", np.ascontiguousarray(field.transpose(2, 1, 0)))
    _, truth = plain(folder, voxels, 1, 1)
    rows = []
    tried = [(step, *plain(folder, voxels, step, ROUNDS)) for step in PLAIN]
    good = [(spent, step, rmse(picture, truth)) for step, spent, picture in tried if rmse(picture, truth) <= WANTED]
    base = min(good)
    rows.append(("plain march", f"steps of {base[1]} voxels", base[0], base[2]))
    columns = benchmark(folder, binaries, voxels)
    light = max(columns["load, light 32"] - columns["load"], 0.0)
    for pixels in (1, 2):
        tried = [(columns[column(*how)] - columns["empty 640x480"] + light, how) for how in OURS if how[1] == pixels]
        errors = {how: rmse(ours(folder, binaries, voxels, *how), truth) for _, how in tried}
        spent, best = min(pair for pair in tried if errors[pair[1]] <= WANTED)
        how = f"steps of {best[0]} voxels, a ray for {pixels} x {pixels} pixels, {light:.0f} ms of it light"
        rows.append(("Fumetto", how, spent, errors[best]))
    theirs = None if "cycles" in without else cycles(folder, voxels, truth)
    if theirs:
        rows.append(("Cycles", f"{theirs[1]} samples, steps of {theirs[0]} voxels", theirs[2], theirs[3]))
    theirs = None if "mitsuba" in without else mitsuba(field, truth)
    if theirs:
        rows.append(("Mitsuba", f"{theirs[0]} samples", theirs[1], theirs[2]))
    for name, how, spent, error in rows:
        print(f"| {voxels}³ | {name} | {how} | {spent:.0f} | {error:.4f} | {base[0] / spent:.2f} |")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--bin", type=pathlib.Path, default=pathlib.Path("target/release"))
    parser.add_argument("--voxels", type=int, nargs="+", default=[128, 256])
    parser.add_argument("--without", nargs="*", choices=["cycles", "mitsuba"], default=[])
    args = parser.parse_args()
    source = pathlib.Path(__file__).parent / "march.c"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        flags = ["-O3", "-march=native", "-ffast-math", "-pthread"]
        subprocess.run(["cc", *flags, source, "-o", folder / "march", "-lm"], check=True)
        print("| density | program | how | ms | RMSE | times as fast |\n|---|---|---|---|---|---|")
        for voxels in args.voxels:
            compare(folder, args.bin.absolute(), voxels, args.without)
    return 0


sys.exit(main())
