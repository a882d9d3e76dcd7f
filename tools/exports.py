"""Looks at what `fumetto export` writes through another program: trimesh.

Run it from the repository's root, after `cargo build --release -p fumetto-cli`:

    python3 -m venv out/venv
    out/venv/bin/pip install numpy trimesh
    out/venv/bin/python tools/exports.py [PATH OF fumetto]

Every surface has to be watertight with its outside outside, and the same in all three formats: as many
vertices, triangles and materials, the same volume, normals that agree with the triangles. Particles have
to be as many in .ply as in .csv.
"""

import csv
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import trimesh

FUMETTO = sys.argv[1] if len(sys.argv) > 1 else "target/release/fumetto"
# Scene, frame, what is changed in it, and whether all of its objects are closed.
SCENES = [
    ("scenes/cloud.toml", 0, [], True),
    ("scenes/genie.toml", 48, [], True),
    ("scenes/chimney.toml", 60, ["object[0].shape={ surface = { subdivisions = 40 } }"], True),
    ("scenes/cottage.toml", 0, [], False),
]


def export(scene: str, frame: int, changes: list[str], out: Path, *more: str) -> dict:
    """What the program itself says of the file that it writes."""
    command = [FUMETTO, "export", scene, "-o", str(out), "--frame", str(frame), "--json", *more]
    for change in changes:
        command += ["--set", change]
    lines = subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()
    return json.loads(lines[0])


def load(path: Path) -> dict[str, trimesh.Trimesh]:
    """The meshes in a file, by material; vertices are left as they are."""
    options = {"process": False, "maintain_order": True}
    loaded = trimesh.load_scene(path, **options)
    return loaded.geometry


def check_mesh(name: str, mesh: trimesh.Trimesh) -> None:
    """Closed, with its outside outside, and with normals that look the same way."""
    assert mesh.is_watertight, f"{name}: not watertight"
    assert mesh.is_winding_consistent, f"{name}: triangles that are turned over"
    assert mesh.volume > 0, f"{name}: its inside is outside ({mesh.volume})"
    agree = np.einsum("fi,fci->fc", mesh.face_normals, mesh.vertex_normals[mesh.faces])
    assert (agree > 0).mean() > 0.99, f"{name}: {100 * (agree <= 0).mean():.1f} % of the normals look inward"


def check_scene(scene: str, frame: int, changes: list[str], closed: bool, folder: Path) -> None:
    told, found = {}, {}
    for format in ("glb", "obj", "ply"):
        out = folder / f"out.{format}"
        told[format] = export(scene, frame, changes, out)
        meshes = load(out)
        found[format] = trimesh.util.concatenate([mesh for mesh in meshes.values()])
        triangles = sum(len(mesh.faces) for mesh in meshes.values())
        assert triangles == told[format]["triangles"], f"{scene} {format}: {triangles} triangles"
        if closed:
            # Objects of several materials are closed only as a whole.
            check_mesh(f"{scene} {format}", found[format])
            assert len(found[format].vertices) == told[format]["vertices"], f"{scene} {format}: vertices"
    volumes = [mesh.volume for mesh in found.values()]
    assert np.allclose(volumes, volumes[0], rtol=1e-4), f"{scene}: volumes {volumes}"
    bounds = [mesh.bounds for mesh in found.values()]
    assert np.allclose(bounds, bounds[0], rtol=1e-5, atol=1e-5), f"{scene}: bounds {bounds}"
    one = told["glb"]
    print(f"{scene} frame {frame}: {one['triangles']} triangles, {one['vertices']} vertices, {volumes[0]:.3f} m³")


def check_particles(folder: Path) -> None:
    ply, table = folder / "out.ply", folder / "out.csv"
    told = export("scenes/chimney.toml", 60, [], ply, "--what", "particles")
    export("scenes/chimney.toml", 60, [], table)
    with table.open() as lines:
        rows = [[float(value) for value in row] for row in list(csv.reader(lines))[1:]]
    points = trimesh.load(ply, process=False).vertices
    assert len(points) == len(rows) == told["particles"] > 0
    assert np.allclose(points, np.array(rows)[:, :3], atol=1e-6)
    print(f"scenes/chimney.toml frame 60: {len(rows)} particles")


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        for scene, frame, changes, closed in SCENES:
            check_scene(scene, frame, changes, closed, Path(folder))
        check_particles(Path(folder))


if __name__ == "__main__":
    main()
