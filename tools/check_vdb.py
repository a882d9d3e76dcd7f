"""Opens the volumes that `fumetto-formats` writes with OpenVDB and compares every voxel with what was meant.

Run it from the repository's root (Debian and Ubuntu: python3-openvdb), with Python's own OpenVDB:

    UPDATE_VOLUMES=1 cargo test -p fumetto-formats --test volumes
    /usr/bin/python3 tools/check_vdb.py

The grids are those of `own_grids` in `crates/fumetto-formats/tests/volumes.rs`.
"""

import gzip
import itertools
import sys
import tempfile
from pathlib import Path

import pyopenvdb

FIXTURES = Path(__file__).parents[1] / "crates/fumetto-formats/tests/fixtures/volumes"
CENTRE = (-1, 2, 0)
MAPS = {
    "density": ("UniformScaleTranslateMap", [(1, 2, 3), (1.5, 2, 3), (1, 2.5, 3), (1, 2, 3.5)]),
    "temperature": ("ScaleTranslateMap", [(0, 0, -1), (0.5, 0, -1), (0, 0.25, -1), (0, 0, 1)]),
    "vel": ("AffineMap", [(1, 0, 0), (1, 0.5, 0), (0.5, 0, 0), (1, 0.125, 0.5)]),
}
CLASSES = {"density": "fog volume", "temperature": "unknown", "vel": "staggered"}


def formula(x: int, y: int, z: int) -> float:
    return ((7 * x + 13 * y + 29 * z) % 64 + 1) / 16


def expected(name: str, index: tuple[int, int, int]):
    """The value at `index`, where a test says it, and whether it is active."""
    inside = sum((i - c) ** 2 for i, c in zip(index, CENTRE)) <= 25
    if name == "density":
        return (formula(*index) if inside else 0.0), inside
    if name == "vel":
        return ((formula(*index), -formula(*index), 1.0) if inside else (0.0, 0.0, 0.0)), inside
    # Where it is the background, nothing is active.
    active = inside and formula(*index) != 2.5
    return (formula(*index) if active else None), active


def check(grid) -> int:
    """Compares a grid; how many of its voxels were looked at."""
    name = grid.name
    accessor = grid.getConstAccessor()
    box = [range(c - 20, c + 21) for c in CENTRE]
    for index in itertools.product(*box):
        if name == "temperature" and max(index) > 15:
            continue  # There are tiles.
        value, active = expected(name, index)
        found = accessor.probeValue(index)
        assert found[1] == active and value in (None, found[0]), (name, index, found, value, active)
    if name == "temperature":
        for index, found in {
            (-1, 4095, 8191): (3.5, True),
            (-1, 4096, 8191): (2.5, False),
            (23, 31, 39): (1.5, True),
            (24, 31, 39): (2.5, False),
            (255, 383, 127): (2.0, False),
        }.items():
            assert accessor.probeValue(index) == found, (index, accessor.probeValue(index))
    assert grid.gridClass == CLASSES[name], grid.gridClass
    assert grid["file_voxel_count"] == grid.activeVoxelCount()
    assert (grid["file_bbox_min"], grid["file_bbox_max"]) == grid.evalActiveVoxelBoundingBox()
    return len(box[0]) ** 3


def main() -> None:
    paths = sorted(FIXTURES.glob("written-*.vdb.gz"))
    assert paths, "no written volumes; run the test first"
    for path in paths:
        with tempfile.NamedTemporaryFile(suffix=".vdb") as file:
            file.write(gzip.decompress(path.read_bytes()))
            file.flush()
            grids, _ = pyopenvdb.readAll(file.name)
        assert [grid.name for grid in grids] == ["density", "density", "temperature", "vel"]
        assert grids[0].sharesWith(grids[1])
        voxels = 0
        for place, grid in enumerate(grids):
            voxels += check(grid)
            assert grid.saveFloatAsHalf == ("half" in path.name)
            kind, corners = MAPS["temperature" if place == 1 else grid.name]
            assert grid.transform.typeName == kind, grid.transform.typeName
            for index, corner in zip([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], corners):
                assert grid.transform.indexToWorld(index) == corner
        print(f"{path.name}: {len(grids)} grids, {voxels} voxels as they should be")


if __name__ == "__main__":
    sys.exit(main())
