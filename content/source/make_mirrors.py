"""Writes a dressing room with two mirrors that face each other and a basin of water: python3 content/source/make_mirrors.py [FILE].

Needs nothing but Python. Metres, y up; the mirrors are flat panes before the walls x = -3 and x = 3.
"""
import math
import os
import struct
import sys

sys.dont_write_bytecode = True

from glb_file import write_glb  # noqa: E402

MATERIALS = {  # base colour, linear; roughness
    "Plaster": ((0.60, 0.55, 0.47), 0.9), "Boards": ((0.26, 0.15, 0.08), 0.7), "Beam": ((0.16, 0.09, 0.05), 0.8),
    "Gilt": ((0.62, 0.42, 0.13), 0.35), "Clay": ((0.50, 0.18, 0.09), 0.6), "Cloth": ((0.08, 0.16, 0.34), 0.9),
    "Stone": ((0.42, 0.40, 0.36), 0.8), "Glass": ((0.05, 0.06, 0.06), 0.2), "Water": ((0.010, 0.018, 0.020), 0.1)}


def _cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _unit(v):
    length = math.sqrt(sum(c * c for c in v))
    return tuple(c / length for c in v)


class Mesh:
    """Vertices (position, normal, uv) and triangles."""

    def __init__(self):
        self.vertices, self.triangles = [], []

    def quad(self, a, b, c, d):
        """A flat face of four corners, counter-clockwise as seen; one unit of its UV is a metre."""
        along = tuple(q - p for p, q in zip(a, b))
        normal = _unit(_cross(along, tuple(q - p for p, q in zip(a, d))))
        u = _unit(along)
        v = _cross(normal, u)
        first = len(self.vertices)
        for corner in (a, b, c, d):
            way = tuple(q - p for p, q in zip(a, corner))
            self.vertices.append((*corner, *normal, sum(x * y for x, y in zip(way, u)), sum(x * y for x, y in zip(way, v))))
        self.triangles += [(first, first + 1, first + 2), (first, first + 2, first + 3)]
        return self

    def box(self, low, high):
        """A closed box, seen from outside."""
        (x0, y0, z0), (x1, y1, z1) = low, high
        self.quad((x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1))
        self.quad((x1, y0, z0), (x0, y0, z0), (x0, y1, z0), (x1, y1, z0))
        self.quad((x1, y0, z1), (x1, y0, z0), (x1, y1, z0), (x1, y1, z1))
        self.quad((x0, y0, z0), (x0, y0, z1), (x0, y1, z1), (x0, y1, z0))
        self.quad((x0, y1, z1), (x1, y1, z1), (x1, y1, z0), (x0, y1, z0))
        return self.quad((x0, y0, z0), (x1, y0, z0), (x1, y0, z1), (x0, y0, z1))

    def frame(self, x, low, high, width, depth):
        """Four bars around a pane in the plane x that spans y and z from `low` to `high`, `depth` metres towards it."""
        (y0, z0), (y1, z1) = low, high
        x0, x1 = min(x, x + depth), max(x, x + depth)
        self.box((x0, y0 - width, z0 - width), (x1, y0, z1 + width)).box((x0, y1, z0 - width), (x1, y1 + width, z1 + width))
        return self.box((x0, y0, z0 - width), (x1, y1, z0)).box((x0, y0, z1), (x1, y1, z1 + width))

    def lathe(self, profile, sides=40):
        """Turns (radius, height) pairs, from below upwards, around y; smooth but where a pair is given twice."""
        lengths = [0.0]
        for (r0, y0), (r1, y1) in zip(profile, profile[1:]):
            lengths.append(lengths[-1] + math.hypot(r1 - r0, y1 - y0))
        slopes = [_unit((y1 - y0, r0 - r1, 0.0)) if (r0, y0) != (r1, y1) else None
                  for (r0, y0), (r1, y1) in zip(profile, profile[1:])]
        first = len(self.vertices)
        for i, (radius, y) in enumerate(profile):
            near = [s for s in slopes[max(i - 1, 0):i + 1] if s]
            out, up, _ = _unit(tuple(sum(c) for c in zip(*near)))
            for j in range(sides + 1):
                angle = 2 * math.pi * (j % sides) / sides
                c, s = math.cos(angle), math.sin(angle)
                self.vertices.append((radius * c, y, -radius * s, out * c, up, -out * s, j / sides, lengths[i]))
        row = sides + 1
        for i, slope in enumerate(slopes):
            for j in range(sides if slope else 0):
                a, b, c, d = (first + (i + k) * row + j + m for k, m in ((0, 0), (0, 1), (1, 1), (1, 0)))
                if profile[i][0] > 0:
                    self.triangles.append((a, b, c))
                if profile[i + 1][0] > 0:
                    self.triangles.append((a, c, d))
        return self


def _room():
    """Name, material, mesh and place of everything."""
    x, z, top = 3.0, 2.5, 3.0
    walls = Mesh()
    for a, b in (((-x, z), (-x, -z)), ((-x, -z), (x, -z)), ((x, -z), (x, z)), ((x, z), (-x, z))):
        walls.quad((a[0], 0, a[1]), (b[0], 0, b[1]), (b[0], top, b[1]), (a[0], top, a[1]))
    pane = ((0.35, -1.1), (2.45, 1.1))

    def glass(at, side):
        (y0, z0), (y1, z1) = pane
        mesh = Mesh().quad((at, y0, z1), (at, y0, z0), (at, y1, z0), (at, y1, z1))
        if side < 0:
            mesh = Mesh().quad((at, y0, z0), (at, y0, z1), (at, y1, z1), (at, y1, z0))
        return mesh
    vase = [(0.0, 0.0), (0.13, 0.0), (0.13, 0.0), (0.19, 0.12), (0.21, 0.24), (0.17, 0.38), (0.09, 0.48), (0.075, 0.54),
            (0.12, 0.62), (0.12, 0.62), (0.0, 0.62)]
    basin = [(0.0, 0.0), (0.20, 0.0), (0.20, 0.0), (0.16, 0.1), (0.14, 0.45), (0.30, 0.62), (0.60, 0.70), (0.62, 0.84),
             (0.62, 0.84), (0.55, 0.84), (0.55, 0.84), (0.54, 0.76), (0.54, 0.76), (0.0, 0.76)]
    stool = Mesh().box((-0.25, 0.42, -0.25), (0.25, 0.48, 0.25))
    table = Mesh().box((-0.75, 0.71, -0.4), (0.75, 0.77, 0.4))
    for i in (-1, 1):
        for j in (-1, 1):
            stool.box((i * 0.21 - 0.03, 0.0, j * 0.21 - 0.03), (i * 0.21 + 0.03, 0.42, j * 0.21 + 0.03))
            table.box((i * 0.68 - 0.04, 0.0, j * 0.33 - 0.04), (i * 0.68 + 0.04, 0.71, j * 0.33 + 0.04))
    beams = Mesh()
    for at in (-1.8, -0.6, 0.6, 1.8):
        beams.box((at - 0.09, top - 0.22, -z), (at + 0.09, top, z))
    water = Mesh().lathe([(0.0, 0.0), (0.545, 0.0)])
    water.triangles = [(a, c, b) for a, b, c in water.triangles]
    water.vertices = [(px, 0.0, pz, 0.0, 1.0, 0.0, px, pz) for px, _, pz, *_ in water.vertices]
    cushion = Mesh().lathe([(0.0, 0.0), (0.20, 0.0), (0.235, 0.05), (0.20, 0.1), (0.0, 0.12)])
    return [
        ("Room/Walls", "Plaster", walls, (0, 0, 0)),
        ("Room/Floor", "Boards", Mesh().quad((-x, 0, z), (x, 0, z), (x, 0, -z), (-x, 0, -z)), (0, 0, 0)),
        ("Room/Ceiling", "Plaster", Mesh().quad((-x, top, -z), (x, top, -z), (x, top, z), (-x, top, z)), (0, 0, 0)),
        ("Room/Beams", "Beam", beams, (0, 0, 0)),
        ("Mirror_West/Glass", "Glass", glass(-x + 0.04, 1), (0, 0, 0)),
        ("Mirror_West/Frame", "Gilt", Mesh().frame(-x, *pane, 0.09, 0.08), (0, 0, 0)),
        ("Mirror_East/Glass", "Glass", glass(x - 0.04, -1), (0, 0, 0)),
        ("Mirror_East/Frame", "Gilt", Mesh().frame(x, *pane, 0.09, -0.08), (0, 0, 0)),
        ("Table", "Boards", table, (-1.1, 0, -1.45)),
        ("Table/Vase", "Clay", Mesh().lathe(vase), (-0.35, 0.77, 0.05)),
        ("Table/Bowl", "Stone", Mesh().lathe([(0.0, 0.0), (0.08, 0.0), (0.08, 0.0), (0.2, 0.13), (0.2, 0.13), (0.18, 0.13),
                                              (0.18, 0.13), (0.0, 0.05)]), (0.3, 0.77, 0.0)),
        ("Stool", "Boards", stool, (-1.75, 0, 0.35)),
        ("Stool/Cushion", "Cloth", cushion, (0, 0.48, 0)),
        ("Basin", "Stone", Mesh().lathe(basin), (0.55, 0, 0.45)),
        ("Basin/Water", "Water", water, (0, 0.79, 0)),
        ("Vase", "Clay", Mesh().lathe([(1.35 * r, 1.6 * y) for r, y in vase]), (2.3, 0, -1.9)),
    ]


def _accessor(document, binary, rows, kind, code, target):
    data = b"".join(struct.pack("<" + code * len(row), *row) for row in rows)
    document["bufferViews"].append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(data), "target": target})
    binary += data + b"\0" * (-len(data) % 4)
    accessor = {"bufferView": len(document["bufferViews"]) - 1, "componentType": 5126 if code == "f" else 5125,
                "count": len(rows), "type": kind}
    if target == 34962 and kind == "VEC3":
        rounded = [struct.unpack("<3f", struct.pack("<3f", *row)) for row in rows]
        accessor["min"], accessor["max"] = [min(c) for c in zip(*rounded)], [max(c) for c in zip(*rounded)]
    document["accessors"].append(accessor)
    return len(document["accessors"]) - 1


def _primitive(document, binary, mesh, material):
    attributes = {"POSITION": _accessor(document, binary, [v[:3] for v in mesh.vertices], "VEC3", "f", 34962),
                  "NORMAL": _accessor(document, binary, [v[3:6] for v in mesh.vertices], "VEC3", "f", 34962),
                  "TEXCOORD_0": _accessor(document, binary, [v[6:] for v in mesh.vertices], "VEC2", "f", 34962)}
    corners = [(i,) for triangle in mesh.triangles for i in triangle]
    return {"attributes": attributes, "indices": _accessor(document, binary, corners, "SCALAR", "I", 34963),
            "material": list(MATERIALS).index(material)}


def _node_at(document, path):
    """The node at `path`, made with its parents when missing."""
    nodes, siblings = document["nodes"], document["scenes"][0]["nodes"]
    for name in path.split("/"):
        found = [i for i in siblings if nodes[i]["name"] == name]
        if not found:
            nodes.append({"name": name})
            siblings.append(len(nodes) - 1)
            found = siblings[-1:]
        node = nodes[found[0]]
        if name != path.rsplit("/", 1)[-1] or node["name"] != name:
            siblings = node.setdefault("children", [])
    return node


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    path = sys.argv[1] if len(sys.argv) > 1 else os.path.join(here, "..", "models", "mirrors.glb")
    materials = [{"name": name, "pbrMetallicRoughness": {"baseColorFactor": [*colour, 1.0], "metallicFactor": 0.0,
                                                          "roughnessFactor": rough}}
                 for name, (colour, rough) in MATERIALS.items()]
    document = {"asset": {"version": "2.0", "generator": "make_mirrors.py", "copyright": "CC0-1.0"}, "scene": 0,
                "scenes": [{"nodes": []}], "nodes": [], "meshes": [], "materials": materials, "bufferViews": [],
                "accessors": []}
    binary = bytearray()
    for name, material, mesh, place in _room():
        document["meshes"].append({"name": name.replace("/", "_"),
                                   "primitives": [_primitive(document, binary, mesh, material)]})
        node = _node_at(document, name)
        node["mesh"] = len(document["meshes"]) - 1
        node["translation"] = list(place)
    document["buffers"] = [{"byteLength": len(binary)}]
    write_glb(path, document, bytes(binary))


if __name__ == "__main__":
    main()
