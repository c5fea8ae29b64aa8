"""Pointed windows: splayed openings to cut from a wall, and tracery plates that stand in them."""
import math

import bpy

import plan
from mesh_kit import Solid, arch_outline, loft, make_mesh, place


def splayed_opening(half, sill, spring, rise, wall=plan.WALL, segments=3):
    """The void of a window through a wall lying in y = 0 .. wall (inside at 0): splayed both ways, sill sloped."""
    reveals = [(-0.05, 0.34, 0.46), (wall * 0.42, 0.0, 0.0), (wall * 0.72, 0.0, 0.0), (wall + 0.05, 0.20, 0.24)]
    rings = []
    for depth, wider, lower in reveals:
        outline = arch_outline(half + wider, sill - lower, spring, rise + wider, segments)
        rings.append([(x, depth, z) for x, z in outline])
    return loft(rings, metric_uv=False)


def _poly_curve(curve, points):
    spline = curve.splines.new("POLY")
    spline.points.add(len(points) - 1)
    for point, (x, z) in zip(spline.points, points):
        point.co = (x, z, 0.0, 1.0)
    spline.use_cyclic_u = True


def _plate(outer, holes, thickness, bevel):
    """A flat plate with holes in the xz plane, centred on y = 0, its edges chamfered by `bevel`."""
    curve = bpy.data.curves.new("plate", "CURVE")
    curve.dimensions, curve.fill_mode = "2D", "BOTH"
    curve.extrude, curve.bevel_depth, curve.bevel_resolution = thickness / 2 - bevel, bevel, 0
    curve.offset = -bevel
    for outline in [outer] + holes:
        _poly_curve(curve, outline)
    thing = bpy.data.objects.new("plate", curve)
    bpy.context.scene.collection.objects.link(thing)
    mesh = thing.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    points, index, remap = [], {}, []
    for vertex in mesh.vertices:
        key = tuple(round(c, 4) for c in (vertex.co.x, vertex.co.z, vertex.co.y))
        remap.append(index.setdefault(key, len(index)))
        if len(index) > len(points):
            points.append(key)
    faces = [tuple(remap[i] for i in p.vertices) for p in mesh.polygons]
    bpy.data.objects.remove(thing)
    return Solid().add(points, [f for f in faces if len(set(f)) == len(f)])


def _circle(cx, cz, radius, count):
    return [(cx + radius * math.cos(2 * math.pi * i / count),
        cz + radius * math.sin(2 * math.pi * i / count)) for i in range(count)]


def _quatrefoil(cx, cz, radius):
    """Four lobes of four points each."""
    ring, lobe = [], radius * 0.47
    for quarter in range(4):
        axis = math.pi / 2 * quarter
        for bend in (-1.5, -0.55, 0.55, 1.5):
            ring.append((cx + (radius - lobe) * math.cos(axis) + lobe * math.cos(axis + bend),
                         cz + (radius - lobe) * math.sin(axis) + lobe * math.sin(axis + bend)))
    return ring


def _light(cx, half, base, spring, rise, segments):
    return [(x + cx, z) for x, z in arch_outline(half, base, spring, rise, segments)]


def two_light_tracery(half, sill, spring, rise):
    """Two lancets under a quatrefoil."""
    bar, embed = 0.11, 0.05
    outer = arch_outline(half + embed, sill - embed, spring, rise + embed, 4)
    light = (half - 1.5 * bar) / 2
    holes = [_light(sign * (light + bar / 2), light, sill + bar * 0.6, spring - 0.25, light * 1.7, 3) for sign in (-1, 1)]
    holes.append(_quatrefoil(0.0, spring + rise * 0.45, half * 0.42))
    return _plate(outer, holes, 0.18, 0.0)


def three_light_tracery(half, sill, spring, rise):
    """Three lancets, the middle one taller, under two circles and a quatrefoil."""
    bar, embed = 0.13, 0.05
    outer = arch_outline(half + embed, sill - embed, spring, rise + embed, 7)
    light = (2 * half - 4 * bar) / 6
    step = 2 * light + bar
    holes = [_light(i * step, light, sill + bar * 0.6, spring - 0.55 + (0.3 if i == 0 else 0), light * 1.6, 3) for i in (-1, 0, 1)]
    holes += [_circle(sign * half * 0.44, spring + 0.58, half * 0.22, 14) for sign in (-1, 1)]
    holes.append(_quatrefoil(0.0, spring + rise * 0.60, half * 0.33))
    return _plate(outer, holes, 0.24, 0.04)


def lancet_tracery(half, sill, spring, rise):
    """A frame with one light and a transom, for narrow windows."""
    bar, embed = 0.09, 0.05
    outer = arch_outline(half + embed, sill - embed, spring, rise + embed, 4)
    middle = (sill + spring) / 2
    holes = [[(-half + bar, sill + bar), (half - bar, sill + bar), (half - bar, middle - bar / 2), (-half + bar, middle - bar / 2)],
             _light(0.0, half - bar, middle + bar / 2, spring, rise - bar, 4)]
    return _plate(outer, holes, 0.16, 0.0)


# Name, (half width, sill, spring, rise), tracery.
KINDS = {"Window": ((plan.WINDOW_HALF, plan.SILL, plan.WINDOW_SPRING, plan.WINDOW_RISE), two_light_tracery),
         "Great_Window": ((1.6, 3.6, 5.6, 2.35), three_light_tracery),
         "Lancet": ((0.42, 4.0, 5.7, 0.85), lancet_tracery)}


def opening(kind, **options):
    """The void of a kind of window."""
    return splayed_opening(*KINDS[kind][0], **options)


def tracery_meshes():
    """One mesh per kind of window."""
    return {kind: make_mesh(kind, draw(*sizes), "Stone", smooth_deg=30) for kind, (sizes, draw) in KINDS.items()}


def place_tracery(path, mesh, centre, inward_turn_deg):
    """Stands tracery where the opening is narrowest; the turn brings +y from the inside to the outside."""
    turn = math.radians(inward_turn_deg)
    depth = plan.WALL * 0.57
    x, y = centre[0] - math.sin(turn) * depth, centre[1] + math.cos(turn) * depth
    return place(path, mesh, (x, y, 0.0), inward_turn_deg)
