"""A robed king on a pedestal: parts are lofted, fused by a voxel remesh, smoothed and thinned to one closed surface."""
import math

import bpy

from mesh_kit import Solid, loft, make_mesh, place, temporary_object

FIGURE_TRIANGLES = 1850
AT = (0.0, 9.75, 0.30)               # on the dais; the figure faces south, to the entrance
PEDESTAL_TOP = 1.15


def _ellipse_stack(rows, folds):
    """Rings of (z, half width, half depth, forward shift, fold depth); folds run down the front and back."""
    count, rings = 64, []
    for z, half_x, half_y, shift, fold in rows:
        ring = []
        for j in range(count):
            a = 2 * math.pi * j / count
            wave = 1.0 + fold * (0.6 * math.cos(folds * a + 0.8 * math.sin(2 * a)) + 0.4 * math.cos((folds + 5) * a + 2.0 * z))
            ring.append((half_x * wave * math.cos(a), shift + half_y * wave * math.sin(a), z))
        rings.append(ring)
    return loft(rings, metric_uv=False)


def _limb(points, radii, count=12):
    """A round limb through points with a radius at each."""
    rings = []
    for i, (p, r) in enumerate(zip(points, radii)):
        a, b = points[max(0, i - 1)], points[min(len(points) - 1, i + 1)]
        d = [b[k] - a[k] for k in range(3)]
        length = math.sqrt(sum(c * c for c in d))
        d = [c / length for c in d]
        u = (d[1], -d[0], 0.0) if abs(d[2]) < 0.95 else (1.0, 0.0, 0.0)
        size = math.sqrt(sum(c * c for c in u))
        u = tuple(c / size for c in u)
        v = (d[1] * u[2] - d[2] * u[1], d[2] * u[0] - d[0] * u[2], d[0] * u[1] - d[1] * u[0])
        rings.append([tuple(p[k] + r * (u[k] * math.cos(t) + v[k] * math.sin(t)) for k in range(3))
                      for t in [2 * math.pi * j / count for j in range(count)]])
    return loft(rings, metric_uv=False)


def _ball(centre, sizes):
    rows = [(math.sin(math.pi * i / 12), -math.cos(math.pi * i / 12)) for i in range(1, 12)]
    rings = [[(centre[0] + sizes[0] * r * math.cos(t), centre[1] + sizes[1] * r * math.sin(t), centre[2] + sizes[2] * z)
              for t in [2 * math.pi * j / 20 for j in range(20)]] for r, z in rows]
    return loft(rings, metric_uv=False)


ROBE = [
    (0.00, 0.400, 0.330, 0.020, 0.20), (0.06, 0.385, 0.315, 0.020, 0.20), (0.35, 0.330, 0.270, 0.020, 0.18),
    (0.70, 0.280, 0.220, 0.010, 0.13), (0.98, 0.245, 0.185, 0.000, 0.08), (1.10, 0.225, 0.165, 0.000, 0.02),
    (1.30, 0.255, 0.170, 0.000, 0.02), (1.42, 0.265, 0.160, 0.010, 0.01), (1.50, 0.230, 0.135, 0.015, 0.00),
    (1.56, 0.150, 0.110, 0.015, 0.00), (1.60, 0.090, 0.090, 0.010, 0.00)]
MANTLE = [
    (0.05, 0.450, 0.190, 0.220, 0.17), (0.45, 0.400, 0.170, 0.180, 0.14), (0.90, 0.350, 0.150, 0.130, 0.10),
    (1.25, 0.300, 0.140, 0.090, 0.05), (1.42, 0.250, 0.120, 0.060, 0.02), (1.50, 0.180, 0.090, 0.040, 0.00)]


def _arms():
    solid = _limb([(0.25, 0.02, 1.42), (0.32, 0.0, 1.25), (0.33, -0.08, 1.08), (0.20, -0.24, 1.10), (0.10, -0.30, 1.16)],
        [0.09, 0.095, 0.085, 0.075, 0.045])
    solid.merge(_limb([(-0.25, 0.02, 1.42), (-0.33, -0.01, 1.24), (-0.34, -0.10, 1.06), (-0.26, -0.27, 1.14),
        (-0.23, -0.33, 1.22)], [0.09, 0.095, 0.09, 0.075, 0.05]))
    for side in (-1, 1):
        solid.merge(_ball((side * 0.245, 0.02, 1.42), (0.105, 0.105, 0.095)))
    # Wide sleeves hang from the forearms.
    solid.merge(_limb([(0.26, -0.17, 1.08), (0.26, -0.16, 0.92), (0.27, -0.13, 0.76)], [0.085, 0.075, 0.03]))
    solid.merge(_limb([(-0.30, -0.18, 1.08), (-0.31, -0.16, 0.92), (-0.32, -0.13, 0.74)], [0.09, 0.08, 0.03]))
    solid.merge(_ball((0.08, -0.31, 1.17), (0.055, 0.05, 0.06)))
    return solid.merge(_ball((-0.225, -0.345, 1.24), (0.05, 0.05, 0.055)))


def _head():
    """Face with brow, nose, cheeks, a long beard, and hair to the shoulders."""
    solid = _ball((0.0, -0.01, 1.745), (0.098, 0.118, 0.135))
    solid.merge(_limb([(0.0, 0.015, 1.52), (0.0, 0.01, 1.70)], [0.075, 0.07]))
    solid.merge(_limb([(0.0, -0.118, 1.785), (0.0, -0.140, 1.745), (0.0, -0.155, 1.715)], [0.014, 0.020, 0.026], 8))
    solid.merge(_limb([(-0.075, -0.085, 1.795), (0.0, -0.118, 1.80), (0.075, -0.085, 1.795)], [0.018, 0.024, 0.018], 8))
    for side in (-1, 1):
        solid.merge(_ball((side * 0.045, -0.092, 1.715), (0.032, 0.030, 0.026)))
        solid.merge(_limb([(side * 0.092, 0.0, 1.79), (side * 0.112, 0.01, 1.68), (side * 0.125, 0.0, 1.57),
            (side * 0.12, -0.01, 1.50)], [0.035, 0.045, 0.045, 0.02]))
    solid.merge(_limb([(0.0, -0.085, 1.675), (0.0, -0.125, 1.60), (0.0, -0.135, 1.50), (0.0, -0.14, 1.41)],
        [0.072, 0.066, 0.045, 0.015]))
    solid.merge(_ball((0.0, 0.045, 1.75), (0.108, 0.095, 0.14)))
    return solid.merge(_limb([(0.0, 0.07, 1.72), (0.0, 0.08, 1.54)], [0.10, 0.11]))


def _crown():
    count, rings = 32, []
    for t in range(count):
        a = 2 * math.pi * t / count
        top = 1.925 + 0.035 * math.cos(8 * a)
        rings.append([(r * math.cos(a), 0.01 + r * math.sin(a) * 1.1, z) for r, z in ((0.112, 1.815), (0.128, top),
            (0.092, top), (0.070, 1.815))])
    return loft(rings, closed_path=True, metric_uv=False)


def _sword_and_book():
    """A sword, point down, in his right hand; a book against his chest in the left."""
    solid = _limb([(-0.225, -0.36, 0.03), (-0.225, -0.36, 0.10), (-0.225, -0.36, 1.12)], [0.012, 0.03, 0.036], 8)
    solid.merge(_limb([(-0.36, -0.36, 1.13), (-0.09, -0.36, 1.13)], [0.03, 0.03], 8))
    solid.merge(_limb([(-0.225, -0.36, 1.13), (-0.225, -0.36, 1.36)], [0.027, 0.027], 8))
    solid.merge(_ball((-0.225, -0.36, 1.39), (0.05, 0.05, 0.05)))
    book = [[(x, y, z) for x, y in ((0.0, -0.29), (0.19, -0.22), (0.17, -0.15), (-0.02, -0.22))] for z in (1.10, 1.38)]
    return solid.merge(loft(book, metric_uv=False))


def _fused(solid):
    """One smooth closed skin around all parts."""
    thing = temporary_object(solid)
    remesh = thing.modifiers.new("fuse", "REMESH")
    remesh.mode, remesh.voxel_size = "VOXEL", 0.013
    smooth = thing.modifiers.new("smooth", "SMOOTH")
    smooth.factor, smooth.iterations = 0.5, 2
    graph = bpy.context.evaluated_depsgraph_get()
    count = len(thing.evaluated_get(graph).data.polygons) * 2
    thin = thing.modifiers.new("thin", "DECIMATE")
    thin.ratio = FIGURE_TRIANGLES / count
    mesh = thing.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    points = [tuple(v.co) for v in mesh.vertices]
    faces = [tuple(p.vertices) for p in mesh.polygons]
    bpy.data.objects.remove(thing)
    return Solid().add(points, faces, [_wrapped_uv([points[i] for i in face]) for face in faces])


def _wrapped_uv(corners):
    """Cylindrical UVs in metres around the figure's axis; the seam runs down the back."""
    angles = [math.atan2(x, -y) for x, y, _ in corners]
    middle = angles[0]
    angles = [a + 2 * math.pi * round((middle - a) / (2 * math.pi)) for a in angles]
    return [(0.42 * a, z) for a, (_, _, z) in zip(angles, corners)]


def _figure():
    solid = Solid()
    for part in (_ellipse_stack(ROBE, 9), _ellipse_stack(MANTLE, 11), _arms(), _head(), _crown(), _sword_and_book()):
        solid.merge(part)
    return _fused(solid)


def _pedestal():
    profile = [(0.62, -0.02, 1), (0.62, 0.16, 1), (0.56, 0.20, 1), (0.56, 0.24, 1), (0.47, 0.32, 1), (0.46, 0.90, 1),
        (0.50, 0.95, 1), (0.57, 1.02, 1),
               (0.60, 1.04, 1), (0.60, 1.13, 1), (0.58, PEDESTAL_TOP, 1)]
    rings = [[(-r, -r, z), (r, -r, z), (r, r, z), (-r, r, z)] for r, z, _ in profile]
    return loft(rings)


def build():
    """Places Statue/."""
    place("Statue/Pedestal", make_mesh("Pedestal", _pedestal(), "Stone", smooth_deg=30), AT)
    place("Statue/Figure", make_mesh("Figure", _figure(), "Marble", smooth_deg=75), (AT[0], AT[1], AT[2] + PEDESTAL_TOP - 0.01))
