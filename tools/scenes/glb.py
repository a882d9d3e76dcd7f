"""Writes models as binary glTF 2.0: nodes, flat materials, vertex normals, animation.

A mesh here is a pair: places (n by 3) and triangles (m by 3 numbers of places), anticlockwise from
outside. Places are shared across hard edges; they are split on the way out, where normals differ.
"""

import json
import struct

import numpy as np

FLOAT, U16, U32 = 5126, 5123, 5125
VERTICES, INDICES = 34962, 34963


def linear(hex_colour):
    """glTF's colour factors are linear, the artist's hex colours are sRGB."""
    srgb = np.array([int(hex_colour[i : i + 2], 16) for i in (1, 3, 5)], float) / 255.0
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


def unit(vectors):
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-30)


def corner_normals(places, triangles, crease_degrees):
    """One normal a corner: the mean of the faces around, weighted by their angle there, without those
    that lie beyond a crease."""
    corners = places[triangles]
    faces = unit(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
    around = [[] for _ in places]
    for face, triangle in enumerate(triangles):
        for k, place in enumerate(triangle):
            ahead = unit(corners[face, (k + 1) % 3] - corners[face, k])
            back = unit(corners[face, (k + 2) % 3] - corners[face, k])
            around[place].append((face, k, np.arccos(np.clip(ahead @ back, -1.0, 1.0))))
    normals = np.zeros(corners.shape)
    limit = np.cos(np.radians(crease_degrees))
    for ring in around:
        ring_faces = np.array([face for face, _, _ in ring], int)
        angles = np.array([angle for _, _, angle in ring])
        for face, k, _ in ring:
            near = faces[ring_faces] @ faces[face] >= limit
            normals[face, k] = (angles[near, None] * faces[ring_faces[near]]).sum(axis=0)
    return unit(normals)


def split(places, triangles, normals):
    """Vertices as glTF wants them: one for each place and normal that occur together."""
    rows = np.concatenate([places[triangles].reshape(-1, 3), normals.reshape(-1, 3)], axis=1)
    rows = rows.astype(np.float32)
    _, first, of_corner = np.unique(rows.round(5), axis=0, return_index=True, return_inverse=True)
    # Numbered in the order of their first use, which keeps triangles and their vertices close.
    order = np.argsort(first)
    number = np.empty(len(order), int)
    number[order] = np.arange(len(order))
    vertices = rows[first[order]]
    return vertices[:, :3], vertices[:, 3:], number[of_corner.reshape(-1)].reshape(-1, 3)


class Glb:
    def __init__(self):
        self.binary = b""
        self.tree = {
            "asset": {"version": "2.0", "generator": "Fumetto's tools/scenes"},
            "scene": 0,
            "scenes": [{"nodes": []}],
            "nodes": [], "meshes": [], "materials": [],
            "accessors": [], "bufferViews": [],
        }
        self.channels, self.samplers = [], []
        self.triangles = 0

    def material(self, name, hex_colour, double_sided=False):
        factors = [round(float(f), 5) for f in linear(hex_colour)] + [1.0]
        material = {
            "name": name,
            "pbrMetallicRoughness": {"baseColorFactor": factors, "metallicFactor": 0.0, "roughnessFactor": 0.9},
        }
        if double_sided:
            material["doubleSided"] = True
        self.tree["materials"].append(material)
        return len(self.tree["materials"]) - 1

    def node(self, name, parts=(), parent=None, translation=None, crease_degrees=40.0):
        """`parts` are pairs of a material and a mesh; those of one material become one primitive. A
        mesh may bring normals of its own, one a place, as a third member."""
        node = {"name": name}
        if translation is not None:
            node["translation"] = [float(t) for t in translation]
        if parts:
            primitives = []
            for material in sorted({material for material, _ in parts}):
                same = [mesh for other, mesh in parts if other == material]
                primitives.append(self._primitive(material, same, crease_degrees))
            self.tree["meshes"].append({"name": name, "primitives": primitives})
            node["mesh"] = len(self.tree["meshes"]) - 1
        number = len(self.tree["nodes"])
        self.tree["nodes"].append(node)
        if parent is None:
            self.tree["scenes"][0]["nodes"].append(number)
        else:
            self.tree["nodes"][parent].setdefault("children", []).append(number)
        return number

    def animate(self, node, path, times, values):
        """`path` is "translation" or "rotation" (quaternions, x y z w)."""
        kind = "VEC4" if path == "rotation" else "VEC3"
        times = np.asarray(times, np.float32)
        reading = self._accessor(times, FLOAT, "SCALAR", None, [float(times[0])], [float(times[-1])])
        writing = self._accessor(np.asarray(values, np.float32), FLOAT, kind)
        self.samplers.append({"input": reading, "output": writing, "interpolation": "LINEAR"})
        self.channels.append({"sampler": len(self.samplers) - 1, "target": {"node": node, "path": path}})

    def save(self, path):
        if self.channels:
            self.tree["animations"] = [{"name": "run", "channels": self.channels, "samplers": self.samplers}]
        self.tree["buffers"] = [{"byteLength": len(self.binary)}]
        text = json.dumps(self.tree, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        with open(path, "wb") as file:
            file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(self.binary)))
            file.write(struct.pack("<I4s", len(text), b"JSON") + text)
            file.write(struct.pack("<I4s", len(self.binary), b"BIN\0") + self.binary)
        print(f"{path}: {self.triangles} triangles, {28 + len(text) + len(self.binary)} bytes")

    def _primitive(self, material, meshes, crease_degrees):
        places, normals, indices = [], [], []
        count = 0
        for mesh in meshes:
            if len(mesh) == 3:
                vertices, vertex_normals, triangles = mesh[0], mesh[2], mesh[1]
            else:
                corners = corner_normals(mesh[0], mesh[1], crease_degrees)
                vertices, vertex_normals, triangles = split(mesh[0], mesh[1], corners)
            places.append(vertices)
            normals.append(vertex_normals)
            indices.append(triangles + count)
            count += len(vertices)
        places = np.concatenate(places).astype(np.float32)
        indices = np.concatenate(indices)
        self.triangles += len(indices)
        low, high = ([float(v) for v in f(places, axis=0)] for f in (np.min, np.max))
        wide = count > 65535
        return {
            "attributes": {
                "POSITION": self._accessor(places, FLOAT, "VEC3", VERTICES, low, high),
                "NORMAL": self._accessor(np.concatenate(normals).astype(np.float32), FLOAT, "VEC3", VERTICES),
            },
            "indices": self._accessor(
                indices.reshape(-1).astype(np.uint32 if wide else np.uint16),
                U32 if wide else U16, "SCALAR", INDICES),
            "material": material,
        }

    def _accessor(self, values, component, kind, target=None, low=None, high=None):
        data = values.tobytes()
        view = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)}
        if target:
            view["target"] = target
        self.binary += data + b"\0" * (-len(data) % 4)
        self.tree["bufferViews"].append(view)
        accessor = {
            "bufferView": len(self.tree["bufferViews"]) - 1,
            "componentType": component, "count": len(values), "type": kind,
        }
        if low is not None:
            accessor.update(min=low, max=high)
        self.tree["accessors"].append(accessor)
        return len(self.tree["accessors"]) - 1
