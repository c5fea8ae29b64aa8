"""Small solid-modelling kit of plain Python: closed solids of polygons, normals that split at folds, nodes of a glTF file.

Metres, y up. A solid is a list of polygons, each a list of points (x, y, z), counter-clockwise from outside.
"""
import array
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))

from glb_file import write_glb  # noqa: E402


# ---- Solids -----------------------------------------------------------------------------------------------------------

def joined(*solids):
    return [polygon for solid in solids for polygon in solid]


def mapped(solid, place):
    return [[place(p) for p in polygon] for polygon in solid]


def moved(solid, x=0.0, y=0.0, z=0.0):
    return mapped(solid, lambda p: (p[0] + x, p[1] + y, p[2] + z))


def turned(solid, axis, deg):
    """Around one of the axes through the origin, counter-clockwise seen against it."""
    c, s = math.cos(math.radians(deg)), math.sin(math.radians(deg))
    turn = {"x": lambda p: (p[0], c * p[1] - s * p[2], s * p[1] + c * p[2]),
            "y": lambda p: (c * p[0] + s * p[2], p[1], -s * p[0] + c * p[2]),
            "z": lambda p: (c * p[0] - s * p[1], s * p[0] + c * p[1], p[2])}[axis]
    return mapped(solid, turn)


def lying(solid, axis):
    """What was made upright, with its upper end towards +x or +z."""
    return turned(solid, "z", -90.0) if axis == "x" else turned(solid, "x", 90.0) if axis == "z" else solid


def loft(rings, closed_path=False):
    """A solid through rings of equal size, counter-clockwise seen against the path; ends are capped."""
    solid, n = [], len(rings[0])
    for low, high in zip(rings, rings[1:] + ([rings[0]] if closed_path else [])):
        for j in range(n):
            solid.append([low[j], low[(j + 1) % n], high[(j + 1) % n], high[j]])
    if not closed_path:
        solid += [list(reversed(rings[0])), list(rings[-1])]
    return [_without_doubles(polygon) for polygon in solid if len(_without_doubles(polygon)) > 2]


def _without_doubles(polygon):
    kept = [p for i, p in enumerate(polygon) if math.dist(p, polygon[i - 1]) > 1e-7]
    return kept


def lathe(profile, sides=32):
    """Turns (radius, height) around y, from below; radii of 0 close the ends."""
    return loft([[(r * math.cos(a), y, -r * math.sin(a)) for a in (2 * math.pi * j / sides for j in range(sides))]
                 for r, y in profile])


def cylinder(radius, low, high, sides=32, chamfer=0.0):
    c = chamfer
    profile = [(radius, low), (radius, high)] if c == 0.0 else [(radius - c, low), (radius, low + c), (radius, high - c), (radius - c, high)]
    return lathe(profile, sides)


def ball(radius, sides=20):
    rows = sides // 2
    return lathe([(radius * math.sin(math.pi * i / rows), -radius * math.cos(math.pi * i / rows)) for i in range(rows + 1)], sides)


def box(x0, x1, y0, y1, z0, z1, chamfer=0.0):
    c = chamfer

    def ring(y, inset, corner):
        a0, a1, b0, b1, k = x0 + inset, x1 - inset, z0 + inset, z1 - inset, corner
        if k == 0.0:
            return [(a0, y, b1), (a1, y, b1), (a1, y, b0), (a0, y, b0)]
        return [(a0 + k, y, b1), (a1 - k, y, b1), (a1, y, b1 - k), (a1, y, b0 + k), (a1 - k, y, b0), (a0 + k, y, b0), (a0, y, b0 + k),
                (a0, y, b1 - k)]
    if c == 0.0:
        return loft([ring(y0, 0.0, 0.0), ring(y1, 0.0, 0.0)])
    return loft([ring(y0, c, 0.4 * c), ring(y0 + c, 0.0, c), ring(y1 - c, 0.0, c), ring(y1, c, 0.4 * c)])


def extruded(outline, low, high):
    """An outline of (x, z), counter-clockwise seen from above, raised along y."""
    return loft([[(x, y, -z) for x, z in outline] for y in (low, high)])


def plate(outline, near, far):
    """An outline of (x, y), counter-clockwise seen from +z, from z = near to far."""
    return turned(extruded(outline, near, far), "x", 90.0)


def ring(outer, inner, low, high):
    """Between two outlines of (x, z) with equally many corners."""
    def raised(outline, y):
        return [(x, y, -z) for x, z in outline]
    return _ring_of(raised(outer, low), raised(outer, high), raised(inner, high), raised(inner, low))


def _ring_of(a, b, c, d):
    solid, n = [], len(a)
    for low, high in ((a, b), (b, c), (c, d), (d, a)):
        for j in range(n):
            k = (j + 1) % n
            solid.append([low[j], low[k], high[k], high[j]])
    return solid


def circle(radius, sides=32, squash=1.0, at=(0.0, 0.0)):
    return [(at[0] + radius * math.cos(a), at[1] + squash * radius * math.sin(a)) for a in (2 * math.pi * j / sides for j in range(sides))]


def gear(teeth, radius, depth, width, bore):
    """A spur gear around y with its rim, web and bore."""
    outer = []
    for i in range(teeth):
        for at, r in ((0.0, radius - depth), (0.22, radius - depth), (0.36, radius), (0.64, radius), (0.78, radius - depth)):
            a = 2 * math.pi * (i + at) / teeth
            outer.append((r * math.cos(a), r * math.sin(a)))
    n, rim, hub = len(outer), radius - 2.4 * depth, 2.0 * bore

    def around(r):
        return [(r * math.cos(math.atan2(y, x)), r * math.sin(math.atan2(y, x))) for x, y in outer]
    return joined(ring(outer, around(rim), 0.0, width), ring(around(rim), around(hub), 0.3 * width, 0.7 * width),
                  ring(around(hub), around(bore), -0.1 * width, 1.1 * width))


def torus(radius, thickness, sides=36, around=10):
    rings = []
    for i in range(sides):
        a = 2 * math.pi * i / sides
        rings.append([((radius + thickness * math.cos(b)) * math.cos(a), thickness * math.sin(b), -(radius + thickness * math.cos(b)) * math.sin(a))
                      for b in (-2 * math.pi * j / around for j in range(around))])
    return _outward(loft(rings, closed_path=True))


def tube(path, radius, sides=10):
    """A round bar along points; it must not turn back on itself."""
    rings = []
    for i, p in enumerate(path):
        before, after = path[max(i - 1, 0)], path[min(i + 1, len(path) - 1)]
        t = _unit([b - a for a, b in zip(before, after)])
        up = (0.0, 1.0, 0.0) if abs(t[1]) < 0.9 else (1.0, 0.0, 0.0)
        u = _unit(_cross(up, t))
        v = _cross(t, u)
        rings.append([tuple(p[k] + radius * (u[k] * math.cos(a) + v[k] * math.sin(a)) for k in range(3))
                      for a in (2 * math.pi * j / sides for j in range(sides))])
    return _outward(loft(rings))


def volume(solid):
    total = 0.0
    for polygon in solid:
        for i in range(1, len(polygon) - 1):
            total += _dot(polygon[0], _cross(polygon[i], polygon[i + 1])) / 6.0
    return total


def _outward(solid):
    return solid if volume(solid) > 0.0 else [list(reversed(polygon)) for polygon in solid]


# ---- Vectors ----------------------------------------------------------------------------------------------------------

def _cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _unit(a):
    length = math.sqrt(_dot(a, a)) or 1.0
    return (a[0] / length, a[1] / length, a[2] / length)


def _area_normal(polygon):
    n = [0.0, 0.0, 0.0]
    for a, b in zip(polygon, polygon[1:] + polygon[:1]):
        for k in range(3):
            n[k] += 0.5 * (a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])
    return tuple(n)


# ---- Triangles --------------------------------------------------------------------------------------------------------

def _triangles(polygon, normal):
    """By cutting ears; polygons may be concave."""
    left, cut = list(range(len(polygon))), []
    while len(left) > 3:
        for i in range(len(left)):
            a, b, c = (left[(i + k) % len(left)] for k in (-1, 0, 1))
            corner = _cross([polygon[b][k] - polygon[a][k] for k in range(3)], [polygon[c][k] - polygon[b][k] for k in range(3)])
            if _dot(corner, normal) <= 1e-16:
                continue
            if any(_is_inside(polygon[p], polygon[a], polygon[b], polygon[c], normal) for p in left if p not in (a, b, c)):
                continue
            cut.append((a, b, c))
            left.pop(i)
            break
        else:
            break
    return cut + [(left[0], left[i], left[i + 1]) for i in range(1, len(left) - 1)]


def _is_inside(p, a, b, c, normal):
    for u, v in ((a, b), (b, c), (c, a)):
        side = _cross([v[k] - u[k] for k in range(3)], [p[k] - u[k] for k in range(3)])
        if _dot(side, normal) < -1e-14:
            return False
    return True


def _corner_normals(solid, smooth_deg):
    """Of each polygon's corners: the mean of the faces at that place which are folded by less."""
    normals = [_area_normal(polygon) for polygon in solid]
    at = {}
    for number, polygon in enumerate(solid):
        for p in polygon:
            at.setdefault(_key(p), set()).add(number)
    least = math.cos(math.radians(smooth_deg))
    result = []
    for number, polygon in enumerate(solid):
        own = _unit(normals[number])
        corners = []
        for p in polygon:
            total = [0.0, 0.0, 0.0]
            for other in at[_key(p)]:
                if _dot(own, _unit(normals[other])) >= least:
                    for k in range(3):
                        total[k] += normals[other][k]
            corners.append(_unit(total))
        result.append(corners)
    return result


def _key(p):
    return tuple(round(c, 6) for c in p)


def _uv(p, normal):
    """Metres on the plane that the face is nearest to."""
    axis = max(range(3), key=lambda k: abs(normal[k]))
    return (p[2], -p[1]) if axis == 0 else (p[0], p[2]) if axis == 1 else (p[0], -p[1])


# ---- Files ------------------------------------------------------------------------------------------------------------

class Model:
    """Nodes by path ("Lathe/Bed"), each with a solid of one material; equal solids become instances."""

    def __init__(self, generator):
        self.generator, self.materials, self.meshes, self.nodes, self.paths = generator, [], [], [], {}
        self.binary, self.views, self.accessors, self.known = b"", [], [], {}

    def material(self, name, colour, roughness=0.6, metallic=0.0):
        """`colour` is sRGB, 0 to 255."""
        linear = [round((c / 255 / 12.92) if c < 11 else ((c / 255 + 0.055) / 1.055) ** 2.4, 5) for c in colour]
        self.materials.append({"name": name, "pbrMetallicRoughness": {
            "baseColorFactor": linear + [1.0], "metallicFactor": metallic, "roughnessFactor": roughness}})

    def add(self, path, solid, material, smooth_deg=32.0, **placed):
        """`placed`: translation, rotation of the node, as glTF has them."""
        key = (id(solid), material)
        if key not in self.known:
            self.known[key] = (self._mesh(path.rsplit("/", 1)[-1], solid, material, smooth_deg), solid)
        node = self._node(path)
        node["mesh"] = self.known[key][0]
        node.update(placed)

    def group(self, path, **placed):
        self._node(path).update(placed)

    def _node(self, path):
        if path not in self.paths:
            self.paths[path] = len(self.nodes)
            self.nodes.append({"name": path.rsplit("/", 1)[-1]})
            if "/" in path:
                self._node(path.rsplit("/", 1)[0]).setdefault("children", []).append(self.paths[path])
        return self.nodes[self.paths[path]]

    def _mesh(self, name, solid, material, smooth_deg):
        vertices, known, indices = [], {}, []
        for polygon, normals in zip(solid, _corner_normals(solid, smooth_deg)):
            face = _unit(_area_normal(polygon))
            numbers = []
            for p, n in zip(polygon, normals):
                vertex = tuple(round(c, 6) for c in p) + tuple(round(c, 5) for c in n) + tuple(round(c, 5) for c in _uv(p, face))
                numbers.append(known.setdefault(vertex, len(vertices)))
                if numbers[-1] == len(vertices):
                    vertices.append(vertex)
            indices += [numbers[i] for triangle in _triangles(polygon, face) for i in triangle]
        first = len(self.accessors)
        for part, kind, start in ((3, "VEC3", 0), (3, "VEC3", 3), (2, "VEC2", 6)):
            self._accessor("f", [v for vertex in vertices for v in vertex[start:start + part]], 5126, kind, part)
        low, high = ([pick(v[k] for v in vertices) for k in range(3)] for pick in (min, max))
        self.accessors[first].update({"min": low, "max": high})
        self._accessor("I" if len(vertices) > 65535 else "H", indices, 5125 if len(vertices) > 65535 else 5123, "SCALAR", 1)
        self.meshes.append({"name": name, "primitives": [{
            "attributes": {"POSITION": first, "NORMAL": first + 1, "TEXCOORD_0": first + 2}, "indices": first + 3,
            "material": [m["name"] for m in self.materials].index(material)}]})
        return len(self.meshes) - 1

    def _accessor(self, code, values, component, kind, size):
        data = array.array(code, values)
        if sys.byteorder == "big":
            data.byteswap()
        if kind == "VEC3":  # limits of the accessor are those of what is stored
            values = data
        self.binary += b"\0" * (-len(self.binary) % 4)
        self.views.append({"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data) * data.itemsize})
        self.binary += data.tobytes()
        self.accessors.append({"bufferView": len(self.views) - 1, "componentType": component, "count": len(values) // size, "type": kind})

    def write(self, path):
        children = {c for node in self.nodes for c in node.get("children", [])}
        document = {"asset": {"version": "2.0", "generator": self.generator, "copyright": "CC0-1.0, made by the scripts in content/source"},
                    "scene": 0, "scenes": [{"nodes": [i for i in range(len(self.nodes)) if i not in children]}],
                    "nodes": self.nodes, "meshes": self.meshes, "materials": self.materials,
                    "buffers": [{"byteLength": len(self.binary)}], "bufferViews": self.views, "accessors": self.accessors}
        write_glb(path, document, self.binary)
