"""Writes the eight-sided prism of the paper: python3 content/source/make_prism.py [FILE].

28 triangles, 42 edges once equal positions are welded: 16 rim edges fold by 90 degrees, 8 upright ones by 45, and 18
diagonals and cap edges are flat. Sides have smooth normals, caps flat ones.
"""
import math
import os
import sys

import numpy as np

sys.dont_write_bytecode = True

from glb_file import write_glb  # noqa: E402

SIDES, RADIUS, HEIGHT = 8, 1.0, 2.0


def _side_surface():
    """Vertices (position, normal, uv) of the sides, one column more than sides for the seam, and their triangles."""
    vertices, triangles = [], []
    for i in range(SIDES + 1):
        angle = 2 * math.pi * (i % SIDES) / SIDES
        c, s = math.cos(angle), math.sin(angle)
        for y in (0.0, HEIGHT):
            u = i * 2 * RADIUS * math.sin(math.pi / SIDES)
            vertices.append((RADIUS * c, y, -RADIUS * s, c, 0.0, -s, u, HEIGHT - y))
    for i in range(SIDES):
        low, high, next_low, next_high = 2 * i, 2 * i + 1, 2 * i + 2, 2 * i + 3
        triangles += [(low, next_low, next_high), (low, next_high, high)]
    return vertices, triangles


def _cap(y, up):
    """One octagon as a fan of six triangles."""
    vertices = []
    for i in range(SIDES):
        angle = 2 * math.pi * i / SIDES
        x, z = RADIUS * math.cos(angle), -RADIUS * math.sin(angle)
        vertices.append((x, y, z, 0.0, up, 0.0, x, z))
    fan = [(0, i, i + 1) for i in range(1, SIDES - 1)]
    return vertices, fan if up > 0 else [(a, c, b) for a, b, c in fan]


def _mesh():
    vertices, triangles = _side_surface()
    for cap in (_cap(HEIGHT, 1.0), _cap(0.0, -1.0)):
        triangles += [tuple(len(vertices) + i for i in t) for t in cap[1]]
        vertices += cap[0]
    return np.array(vertices, np.float32), np.array(triangles, np.uint16)


def _document(vertices, triangles, lengths):
    starts = np.cumsum([0] + lengths).tolist()
    count, positions = len(vertices), vertices[:, :3]
    views = [{"buffer": 0, "byteOffset": s, "byteLength": n, "target": 34963 if i == 3 else 34962}
             for i, (s, n) in enumerate(zip(starts, lengths))]
    accessors = [{"bufferView": 0, "componentType": 5126, "count": count, "type": "VEC3",
                  "min": positions.min(0).tolist(), "max": positions.max(0).tolist()},
                 {"bufferView": 1, "componentType": 5126, "count": count, "type": "VEC3"},
                 {"bufferView": 2, "componentType": 5126, "count": count, "type": "VEC2"},
                 {"bufferView": 3, "componentType": 5123, "count": triangles.size, "type": "SCALAR"}]
    primitive = {"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "indices": 3, "material": 0}
    stone = {"name": "Stone", "pbrMetallicRoughness": {"baseColorFactor": [0.62, 0.56, 0.47, 1.0], "metallicFactor": 0.0,
        "roughnessFactor": 0.9}}
    return {"asset": {"version": "2.0", "generator": "make_prism.py", "copyright": "CC0-1.0"}, "scene": 0,
            "scenes": [{"nodes": [0]}], "nodes": [{"name": "Prism", "mesh": 0}],
            "meshes": [{"name": "Prism", "primitives": [primitive]}], "materials": [stone],
            "buffers": [{"byteLength": starts[-1]}], "bufferViews": views, "accessors": accessors}


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    path = sys.argv[1] if len(sys.argv) > 1 else os.path.join(here, "..", "models", "prism.glb")
    vertices, triangles = _mesh()
    parts = [np.ascontiguousarray(a).tobytes() for a in (vertices[:, :3], vertices[:, 3:6], vertices[:, 6:], triangles)]
    write_glb(path, _document(vertices, triangles, [len(p) for p in parts]), b"".join(parts))


if __name__ == "__main__":
    main()
