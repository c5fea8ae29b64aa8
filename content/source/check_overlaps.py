"""Finds drawn surfaces that lie on one another (z-fighting): python3 check_overlaps.py FILE.

Lists pairs of nodes with coplanar overlapping triangles that face the same way, largest area (square metres) first.
What lies inside a wall or under the floor is listed too: look before you mend.
"""
import collections
import sys

import numpy as np

from check_glb import read_accessor
from glb_file import read_glb

PLANE_GAP_M, AREA_M2 = 0.0015, 1e-4


def _matrix(node):
    matrix = np.eye(4)
    x, y, z, w = node.get("rotation", [0, 0, 0, 1])
    matrix[:3, :3] = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                      [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                      [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    matrix[:3, :3] *= node.get("scale", [1, 1, 1])
    matrix[:3, 3] = node.get("translation", [0, 0, 0])
    return matrix


def world_triangles(document, binary):
    """All drawn triangles (n x 3 x 3) and the path of the node of each."""
    triangles, owners = [], []

    def visit(index, above, path):
        node = document["nodes"][index]
        world, path = above @ _matrix(node), path + [node["name"]]
        for primitive in document["meshes"][node["mesh"]]["primitives"] if "mesh" in node else []:
            points = read_accessor(document, binary, primitive["attributes"]["POSITION"]).astype(float)
            corners = read_accessor(document, binary, primitive["indices"]).reshape(-1, 3).astype(int)
            triangles.append((points @ world[:3, :3].T + world[:3, 3])[corners])
            owners.extend(["/".join(path)] * len(corners))
        for child in node.get("children", []):
            visit(child, world, path)
    for root in document["scenes"][0]["nodes"]:
        visit(root, np.eye(4), [])
    return np.concatenate(triangles), owners


def _cross2(a, b):
    return a[0] * b[1] - a[1] * b[0]


def _clipped(polygon, start, end):
    kept, edge = [], end - start
    for p, q in zip(polygon, polygon[1:] + polygon[:1]):
        side_p, side_q = _cross2(edge, p - start), _cross2(edge, q - start)
        if side_p >= 0:
            kept.append(p)
        if (side_p >= 0) != (side_q >= 0):
            kept.append(p + (q - p) * side_p / (side_p - side_q))
    return kept


def shared_area(a, b, normal):
    """Area that two coplanar triangles with the same normal have in common."""
    u = np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))])
    u /= np.linalg.norm(u)
    frame = np.stack([u, np.cross(normal, u)], axis=1)
    p, q = a @ frame, b @ frame
    if (p.max(0) < q.min(0)).any() or (q.max(0) < p.min(0)).any():
        return 0.0
    polygon = list(p)
    for k in range(3):
        polygon = _clipped(polygon, q[k], q[(k + 1) % 3])
        if len(polygon) < 3:
            return 0.0
    return 0.5 * abs(sum(_cross2(s, t) for s, t in zip(polygon, polygon[1:] + polygon[:1])))


def overlaps(triangles, owners):
    """Overlapping area by pair of nodes."""
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    offsets = np.einsum("ij,ij->i", normals, triangles.mean(1))
    planes = collections.defaultdict(list)
    for i, normal in enumerate(normals):
        planes[(*np.round(normal * 200).astype(int), int(offsets[i] // (2 * PLANE_GAP_M)))].append(i)
    found = collections.Counter()
    for key, members in list(planes.items()):
        others = members + planes.get((*key[:3], key[3] + 1), [])
        for at, i in enumerate(members):
            for j in others[at + 1:]:
                if abs(offsets[i] - offsets[j]) < PLANE_GAP_M:
                    area = shared_area(triangles[i], triangles[j], normals[i])
                    if area > AREA_M2:
                        found[tuple(sorted((owners[i], owners[j])))] += area
    return found


def main():
    for (first, second), area in overlaps(*world_triangles(*read_glb(sys.argv[1]))).most_common():
        print(f"{area:8.4f} {first}  {second}")


if __name__ == "__main__":
    main()
