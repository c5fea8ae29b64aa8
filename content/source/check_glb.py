"""Checks a binary glTF file: python3 check_glb.py FILE. Prints what is drawn; fails on broken geometry."""
import sys

import numpy as np

from glb_file import read_glb

COMPONENTS = {5121: np.uint8, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
WIDTH = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


def read_accessor(document, binary, index):
    """The accessor's values, one row per element."""
    accessor = document["accessors"][index]
    view = document["bufferViews"][accessor["bufferView"]]
    width, kind = WIDTH[accessor["type"]], COMPONENTS[accessor["componentType"]]
    start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    return np.frombuffer(binary, kind, accessor["count"] * width, start).reshape(-1, width)


def _welded(points):
    return np.unique(np.round(points, 5), axis=0, return_inverse=True)[1].reshape(-1)


def _open_edges(points, triangles):
    ids = _welded(points)[triangles]
    edges = np.sort(np.vstack([ids[:, [0, 1]], ids[:, [1, 2]], ids[:, [2, 0]]]), axis=1)
    return int((np.unique(edges, axis=0, return_counts=True)[1] % 2).sum())


def _signed_volume(points, triangles):
    a, b, c = (points[triangles[:, i]].astype(np.float64) for i in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6.0)


def check_primitive(document, binary, primitive):
    """Returns (triangle count, list of complaints)."""
    get = lambda name: read_accessor(document, binary, primitive["attributes"][name])  # noqa: E731
    missing = {"POSITION", "NORMAL", "TEXCOORD_0"} - set(primitive["attributes"])
    if missing or "indices" not in primitive:
        return 0, [f"lacks {sorted(missing)} or indices"]
    points, normals, uvs = get("POSITION"), get("NORMAL"), get("TEXCOORD_0")
    triangles = read_accessor(document, binary, primitive["indices"]).reshape(-1, 3).astype(np.int64)
    complaints = []
    if not all(np.isfinite(a).all() for a in (points, normals, uvs)):
        complaints.append("has NaN or infinity")
    if np.abs(np.linalg.norm(normals, axis=1) - 1.0).max() > 1e-3:
        complaints.append("has normals that are not unit vectors")
    a, b, c = (points[triangles[:, i]].astype(np.float64) for i in range(3))
    cross = np.cross(b - a, c - a)
    flat = np.linalg.norm(cross, axis=1) < 1e-8
    if flat.any():
        complaints.append(f"has {int(flat.sum())} degenerate triangles")
    against = np.einsum("ij,ij->i", cross, normals[triangles].sum(axis=1)) < 0
    if against.any():
        complaints.append(f"has {int(against.sum())} triangles against their normals")
    open_count = _open_edges(points, triangles)
    if open_count:
        complaints.append(f"has {open_count} open edges")
    elif _signed_volume(points, triangles) < 0:
        complaints.append("is inside out")
    return len(triangles), complaints


def _paths(document):
    nodes = document["nodes"]
    found = []

    def walk(index, above):
        path = f"{above}/{nodes[index]['name']}" if above else nodes[index]["name"]
        found.append((path, nodes[index].get("mesh")))
        for child in nodes[index].get("children", []):
            walk(child, path)
    for root in document["scenes"][document.get("scene", 0)]["nodes"]:
        walk(root, "")
    return found


def main():
    document, binary = read_glb(sys.argv[1])
    counts, bad = [], 0
    for mesh in document["meshes"]:
        total = 0
        for primitive in mesh["primitives"]:
            count, complaints = check_primitive(document, binary, primitive)
            total += count
            for complaint in complaints:
                bad += 1
                print(f"{mesh['name']} {complaint}")
        counts.append(total)
    paths = _paths(document)
    names = [p for p, _ in paths]
    if len(names) != len(set(names)):
        bad += 1
        print("two nodes share a path")
    if "--list" in sys.argv:
        for path, mesh in paths:
            print(f"{path:44s} {counts[mesh] if mesh is not None else ''}")
    drawn = sum(counts[m] for _, m in paths if m is not None)
    print(f"{len(paths)} nodes, {len(counts)} meshes, {sum(counts)} triangles stored, {drawn} drawn, "
          f"materials {[m['name'] for m in document.get('materials', [])]}")
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
