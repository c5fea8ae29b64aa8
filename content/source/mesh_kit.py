"""Small solid-modelling kit on top of Blender: lofts, lathes, sweeps, booleans, metric UVs, placed instances.

Everything is built in metres with Blender's z up; the exporter turns it into glTF's y up.
"""
import math

import bmesh
import bpy
from mathutils import Vector


class Solid:
    """Points and polygons; `uvs[i]` holds one (u, v) per corner of face i, or None for box projection."""

    def __init__(self):
        self.points, self.faces, self.uvs = [], [], []

    def add(self, points, faces, uvs=None):
        base = len(self.points)
        self.points += [tuple(p) for p in points]
        self.faces += [tuple(base + i for i in face) for face in faces]
        self.uvs += uvs if uvs else [None] * len(faces)
        return self

    def merge(self, other, offset=(0, 0, 0), turn_deg=0.0):
        c, s = math.cos(math.radians(turn_deg)), math.sin(math.radians(turn_deg))
        moved = [(c * x - s * y + offset[0], s * x + c * y + offset[1], z + offset[2]) for x, y, z in other.points]
        return self.add(moved, other.faces, list(other.uvs))


def _distance(a, b):
    return math.dist(a, b)


def _running_lengths(points):
    lengths = [0.0]
    for a, b in zip(points, points[1:]):
        lengths.append(lengths[-1] + _distance(a, b))
    return lengths


def _perimeter(ring):
    return _running_lengths(list(ring) + [ring[0]])


def loft(rings, closed_path=False, metric_uv=True, whole_turns=False):
    """A closed solid through rings of equal size; the ends are capped unless the path is closed.

    `metric_uv` unrolls the surface (u around, v along); otherwise corners get box-projected UVs.
    `whole_turns` stretches u so that a two-metre tile meets itself at the seam.
    """
    solid, n, count = Solid(), len(rings[0]), len(rings)
    around = _perimeter(sorted(rings, key=lambda r: _perimeter(r)[-1])[count // 2])
    if whole_turns:
        turn = max(1, 2 * round(around[-1] / 2))
        around = [a * turn / around[-1] for a in around]
    path = list(rings) + ([rings[0]] if closed_path else [])
    along = [0.0]
    for a, b in zip(path, path[1:]):
        along.append(along[-1] + sum(_distance(p, q) for p, q in zip(a, b)) / n)
    faces, uvs = [], []
    for i in range(len(path) - 1):
        for j in range(n):
            k, m = (j + 1) % n, (i + 1) % count
            faces.append((i * n + j, i * n + k, m * n + k, m * n + j))
            uvs.append([(around[j], along[i]), (around[j + 1], along[i]),
                        (around[j + 1], along[i + 1]), (around[j], along[i + 1])] if metric_uv else None)
    if not closed_path:
        faces += [tuple(reversed(range(n))), tuple((count - 1) * n + j for j in range(n))]
        uvs += [None, None]
    return solid.add([p for ring in rings for p in ring], faces, uvs)


def prism(outline, axis, start, end):
    """Extrudes a 2-D outline along x, y or z; the outline's axes follow in cyclic order (x: yz, y: xz, z: xy)."""
    place = {"x": lambda p, d: (d, p[0], p[1]), "y": lambda p, d: (p[0], d, p[1]), "z": lambda p, d: (p[0], p[1], d)}[axis]
    return loft([[place(p, start) for p in outline], [place(p, end) for p in outline]], metric_uv=False)


def box(x0, x1, y0, y1, z0, z1, chamfer=0.0):
    """An axis-aligned box; `chamfer` cuts all twelve edges."""
    if chamfer <= 0.0:
        return prism([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], "z", z0, z1)
    c = chamfer

    def ring(inset, corner, z):
        a0, a1, b0, b1 = x0 + inset, x1 - inset, y0 + inset, y1 - inset
        return [(a0 + corner, b0, z), (a1 - corner, b0, z), (a1, b0 + corner, z), (a1, b1 - corner, z),
                (a1 - corner, b1, z), (a0 + corner, b1, z), (a0, b1 - corner, z), (a0, b0 + corner, z)]
    slight = c * 0.3
    return loft([ring(c, slight, z0), ring(0, c, z0 + c), ring(0, c, z1 - c), ring(c, slight, z1)], metric_uv=False)


def lathe(profile, sides, bulge=None):
    """Turns (radius, z, squareness) around z. Squareness 1 is a square of half width radius; sides must divide by 8.

    `bulge(angle, row)` may scale the radius to carve leaves or folds.
    """
    rings = []
    for row, (radius, z, square) in enumerate(profile):
        ring = []
        for j in range(sides):
            angle = 2 * math.pi * (j + 0.0) / sides
            c, s = math.cos(angle), math.sin(angle)
            to_square = 1.0 / max(abs(c), abs(s))
            r = radius * (1.0 + square * (to_square - 1.0)) * (bulge(angle, row) if bulge else 1.0)
            ring.append((r * c, r * s, z))
        rings.append(ring)
    return loft(rings, whole_turns=True)


def sweep(path, profile, side, closed=False, clamp=None):
    """Sweeps a profile of (across, outward) pairs along 3-D points.

    `side` is the fixed direction of `across`; outward is perpendicular to it and to the path (path x side).
    """
    side = Vector(side).normalized()
    points = [Vector(p) for p in path]
    rings = []
    for i, p in enumerate(points):
        before = points[i - 1] if i > 0 or closed else p
        after = points[(i + 1) % len(points)] if i + 1 < len(points) or closed else p
        d0, d1 = (p - before), (after - p)
        d0 = d0.normalized() if d0.length > 1e-9 else d1.normalized()
        d1 = d1.normalized() if d1.length > 1e-9 else d0
        tangent = (d0 + d1).normalized()
        miter = 1.0 / max(0.35, tangent.dot(d1))
        outward = tangent.cross(side).normalized() * miter
        ring = [tuple(p + side * a + outward * b) for a, b in profile]
        rings.append([clamp(q) for q in ring] if clamp else ring)
    return loft(rings, closed_path=closed)


def pointed_arch(half_width, spring, rise, segments):
    """Points (x, z) of a pointed arch from right springing over the apex to the left one."""
    lean = max(0.0, ((rise / half_width) ** 2 - 1.0) / 2.0)
    radius = 1.0 + lean
    top = math.acos(lean / radius)
    right = []
    for i in range(segments + 1):
        a = top * i / segments
        right.append((half_width * (radius * math.cos(a) - lean), spring + half_width * radius * math.sin(a)))
    right[-1] = (0.0, spring + rise)
    return right + [(-x, z) for x, z in reversed(right[:-1])]


def arch_outline(half_width, base, spring, rise, segments):
    """A closed door or window outline (x, z), counter-clockwise, with its sill."""
    return [(-half_width, base), (half_width, base)] + pointed_arch(half_width, spring, rise, segments)


# ---- Blender meshes -------------------------------------------------------------------------------------------------

def _box_uv(face, loop, grain):
    """Metres on the nearest upright plane, v measured up the slope; level faces are seen from above."""
    normal, p = face.normal, loop.vert.co
    if abs(normal.z) > 0.97:
        return (p.y, p.x) if grain == 1 else (p.x, p.y)
    along = 1 if abs(normal.x) >= abs(normal.y) else 0
    u, v = p[along], p.z / math.sqrt(1.0 - normal.z ** 2)
    return (v, u) if grain == 2 else (u, v)


def _apply_uvs(bm, known_uvs, grain):
    layer = bm.loops.layers.uv.verify()
    for face in bm.faces:
        known = known_uvs.get(face.index)
        for corner, loop in enumerate(face.loops):
            loop[layer].uv = known[corner] if known else _box_uv(face, loop, grain)


def _fill_bmesh(solid, grain):
    bm = bmesh.new()
    verts = [bm.verts.new(p) for p in solid.points]
    known = {}
    for face, uv in zip(solid.faces, solid.uvs):
        made = bm.faces.new([verts[i] for i in face])
        made.index = len(known)
        known[made.index] = uv
    bm.normal_update()
    _apply_uvs(bm, known, grain)
    return bm


def _finish(bm, name, material, smooth_deg):
    bmesh.ops.recalc_face_normals(bm, faces=bm.faces)
    bmesh.ops.dissolve_degenerate(bm, dist=1e-5, edges=bm.edges)
    flat = [f for f in bm.faces if len(f.verts) > 3]
    bmesh.ops.triangulate(bm, faces=flat, quad_method="BEAUTY", ngon_method="BEAUTY")
    for face in bm.faces:
        face.smooth, face.material_index = True, 0
    mesh = bpy.data.meshes.new(name)
    bm.to_mesh(mesh)
    bm.free()
    mesh.use_auto_smooth = True
    mesh.auto_smooth_angle = math.radians(smooth_deg)
    mesh.materials.append(bpy.data.materials[material])
    return mesh


def make_mesh(name, solid, material, smooth_deg=40.0, grain=None):
    """A Blender mesh with outward normals. `grain` (0..2) is the axis that wood fibres and u follow."""
    return _finish(_fill_bmesh(solid, grain), name, material, smooth_deg)


def temporary_object(solid):
    """A scene object to run modifiers on; the caller removes it."""
    bm = _fill_bmesh(solid, None)
    bmesh.ops.recalc_face_normals(bm, faces=bm.faces)
    mesh = bpy.data.meshes.new("temporary")
    bm.to_mesh(mesh)
    bm.free()
    thing = bpy.data.objects.new("temporary", mesh)
    bpy.context.scene.collection.objects.link(thing)
    return thing


def carve_mesh(name, solid, cutters, material, smooth_deg=30.0):
    """The solid minus each cutter (exact booleans), with box-projected UVs."""
    body = temporary_object(solid)
    tools = [temporary_object(c) for c in cutters]
    for tool in tools:
        modifier = body.modifiers.new("cut", "BOOLEAN")
        modifier.operation, modifier.object, modifier.solver = "DIFFERENCE", tool, "EXACT"
    result = body.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    bm = bmesh.new()
    bm.from_mesh(result)
    for thing in [body] + tools:
        bpy.data.objects.remove(thing)
    bmesh.ops.remove_doubles(bm, verts=bm.verts, dist=1e-4)
    bmesh.ops.dissolve_limit(bm, angle_limit=math.radians(0.2), verts=bm.verts, edges=bm.edges)
    bm.normal_update()
    _apply_uvs(bm, {}, None)
    return _finish(bm, name, material, smooth_deg)


# ---- Scene tree -----------------------------------------------------------------------------------------------------
# Object names are full paths, unique in Blender; glb_tree.py leaves only the last part in the glTF file.

def _link(path, data):
    thing = bpy.data.objects.new(path, data)
    bpy.context.scene.collection.objects.link(thing)
    if "/" in path:
        thing.parent = group(path.rsplit("/", 1)[0])
    return thing


def group(path):
    """The empty node at `path`, made with its parents when missing."""
    return bpy.data.objects.get(path) or _link(path, None)


def place(path, mesh, at=(0, 0, 0), turn_deg=0.0):
    """Puts a mesh into the scene tree; equal meshes become instances."""
    thing = _link(path, mesh)
    thing.location = at
    thing.rotation_euler = (0, 0, math.radians(turn_deg))
    return thing
