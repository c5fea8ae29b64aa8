"""Pointed groin vaults over nave and aisles: webs, ribs, arches, bosses. All ribs follow the web's own surface."""
import math

import plan
from mesh_kit import Solid, lathe, make_mesh, place, sweep

LEAN = 0.35                          # how far the arch centres lie beyond the axis, in half spans: pointedness
ARCH_RISE = 3.5                      # arcade and wall arches
STEPS = 4                            # spans from springing to crown, the same for webs and ribs, so that they touch
INTO_WALL = 0.12
EXTRADOS = plan.WALL_TOP - 0.05


class Bay:
    """One vault bay: half spans, rise of its crown and of its transverse arches."""

    def __init__(self, half_x, crown_rise, transverse_rise):
        self.half_x, self.half_y = half_x, plan.BAY / 2
        self.crown_rise, self.transverse_rise = crown_rise, transverse_rise

    def height(self, s, t):
        """Height of the web at (s, t) in [-1, 1]^2; s runs across the hall, t along it."""
        rise = (self.crown_rise + (ARCH_RISE - self.crown_rise) * s * s
                + (self.transverse_rise - self.crown_rise) * t * t * (1 - s * s))
        return plan.SPRING + rise * profile(min(abs(s), abs(t)))

    def point(self, s, t):
        return (s * self.half_x, t * self.half_y, self.height(s, t))


NAVE = Bay(plan.COLUMN_X, 4.4, 4.15)
AISLE = Bay((plan.HALL_X - plan.COLUMN_X) / 2, 3.6, 3.3)
AISLE_X = (plan.HALL_X + plan.COLUMN_X) / 2


def profile(d):
    """Pointed arch over d in [0, 1]: 1 at the crown, 0 at the springing."""
    return math.sqrt(max(0.0, (1 + LEAN) ** 2 - (d + LEAN) ** 2)) / math.sqrt(1 + 2 * LEAN)


def arch_steps(count):
    """Distances from the axis, 1 .. 0, at equal angles along the arc."""
    top = math.acos(LEAN / (1 + LEAN))
    steps = [(1 + LEAN) * math.cos(top * i / count) - LEAN for i in range(count + 1)]
    return steps[:-1] + [0.0]


def _arc_lengths(half_span, rise, steps):
    total, lengths = 0.0, {steps[0]: 0.0}
    for a, b in zip(steps, steps[1:]):
        total += math.dist((a * half_span, rise * profile(a)), (b * half_span, rise * profile(b)))
        lengths[b] = total
    return lengths


def _web_faces(solid, index, bay, centre):
    steps = arch_steps(STEPS)
    axis = [-d for d in steps] + list(reversed(steps[:-1]))
    up_s = _arc_lengths(bay.half_x, bay.crown_rise, steps)
    up_t = _arc_lengths(bay.half_y, bay.crown_rise, steps)

    def vertex(s, t):
        x, y, z = bay.point(s, t)
        at = (round(x + centre[0], 4), round(y + centre[1], 4))
        if at not in index:
            index[at] = len(solid.points)
            solid.points.append((at[0], at[1], z))
        return index[at]

    def uv(s, t, lateral):
        if lateral:
            return (s * bay.half_x, math.copysign(up_t[0.0] - up_t[abs(t)], t))
        return (t * bay.half_y, math.copysign(up_s[0.0] - up_s[abs(s)], s))

    for s0, s1 in zip(axis, axis[1:]):
        for t0, t1 in zip(axis, axis[1:]):
            corners = [(s0, t0), (s1, t0), (s1, t1), (s0, t1)]
            rising = (s0 + s1) * (t0 + t1) > 0
            triangles = [(0, 1, 2), (0, 2, 3)] if rising else [(1, 2, 3), (1, 3, 0)]
            for triangle in triangles:
                ids = [corners[i] for i in triangle]
                cs, ct = sum(p[0] for p in ids) / 3, sum(p[1] for p in ids) / 3
                solid.faces.append(tuple(vertex(*p) for p in ids))
                solid.uvs.append([uv(*p, abs(ct) < abs(cs)) for p in ids])


def _sheet_boundary(faces):
    directed = {(a, b) for f in faces for a, b in zip(f, f[1:] + f[:1])}
    after = {a: b for a, b in directed if (b, a) not in directed}
    start = min(after)
    loop, here = [start], after[start]
    while here != start:
        loop.append(here)
        here = after[here]
    return loop


def _close_upwards(solid):
    """Adds a rim that reaches into the walls and a flat top, so that the webs bound a solid."""
    loop = _sheet_boundary(solid.faces)
    rim, top = [], []
    for i in loop:
        x, y, z = solid.points[i]
        out_x = x + math.copysign(INTO_WALL, x) * (abs(x) > plan.HALL_X - 1e-3)
        out_y = y + math.copysign(INTO_WALL, y) * (abs(y) > plan.HALL_Y - 1e-3)
        rim.append((out_x, out_y, z))
        top.append((out_x, out_y, EXTRADOS))
    base, n = len(solid.points), len(loop)
    solid.points += rim + top
    for j in range(n):
        k = (j + 1) % n
        solid.faces.append((loop[k], loop[j], base + j, base + k))
        solid.faces.append((base + k, base + j, base + n + j, base + n + k))
        solid.uvs += [None, None]
    solid.faces.append(tuple(base + n + j for j in reversed(range(n))))
    solid.uvs.append(None)


def _webs():
    solid, index = Solid(), {}
    for y in plan.BAY_CENTRES:
        _web_faces(solid, index, NAVE, (0.0, y))
        for x in (-AISLE_X, AISLE_X):
            _web_faces(solid, index, AISLE, (x, y))
    _close_upwards(solid)
    return make_mesh("Vault", solid, "Plaster", smooth_deg=24)


ARCADE = [(-0.34, -0.02), (-0.34, 0.16), (-0.22, 0.20), (-0.22, 0.32), (0.22, 0.32), (0.22, 0.20), (0.34, 0.16), (0.34, -0.02)]
HEAVY = [(-0.17, -0.02), (-0.17, 0.14), (-0.09, 0.26), (0.09, 0.26), (0.17, 0.14), (0.17, -0.02)]
MEDIUM = [(-0.16, -0.02), (-0.08, 0.24), (0.08, 0.24), (0.16, -0.02)]
LIGHT = [(-0.11, -0.02), (-0.045, 0.19), (0.045, 0.19), (0.11, -0.02)]


def _both_halves(half_points, mirror):
    """A whole arch from one half (springing to crown)."""
    return half_points + [mirror(p) for p in reversed(half_points[:-1])]


def _arcade_rib(bay, profile_points, count):
    half = [(0.0, -d * bay.half_y, bay.height(1, d)) for d in arch_steps(count)]
    path = _both_halves(half, lambda p: (p[0], -p[1], p[2]))
    limit = bay.half_y
    return sweep(path, profile_points, (1, 0, 0), clamp=lambda p: (p[0], max(-limit, min(limit, p[1])), p[2]))


def _transverse_rib(bay, profile_points, count):
    half = [(-d * bay.half_x, 0.0, bay.height(d, 1)) for d in arch_steps(count)]
    path = _both_halves(half, lambda p: (-p[0], p[1], p[2]))
    limit = bay.half_x
    return sweep(path, profile_points, (0, -1, 0), clamp=lambda p: (max(-limit, min(limit, p[0])), p[1], p[2]))


def _diagonal_ribs(bay, count, boss_radius):
    solid, length = Solid(), math.hypot(bay.half_x, bay.half_y)
    for sign in (1, -1):
        half = [(-d * bay.half_x, -d * sign * bay.half_y, bay.height(d, d)) for d in arch_steps(count)]
        path = _both_halves(half, lambda p: (-p[0], -p[1], p[2]))
        solid.merge(sweep(path, LIGHT, (sign * bay.half_y / length, -bay.half_x / length, 0)))
    crown, r = plan.SPRING + bay.crown_rise, boss_radius
    boss = lathe([(r * 0.35, crown - 0.30, 0), (r, crown - 0.20, 0), (r * 0.9, crown - 0.1, 0)], 8)
    return solid.merge(boss)


def build():
    """Places the vault's webs, ribs and arches under Hall/."""
    place("Hall/Vault", _webs())
    arcade = make_mesh("Arcade_Arch", _arcade_rib(NAVE, ARCADE, STEPS), "Stone")
    wall_rib = make_mesh("Wall_Rib", _arcade_rib(NAVE, LIGHT, STEPS), "Stone")
    nave_arch = make_mesh("Nave_Arch", _transverse_rib(NAVE, HEAVY, STEPS), "Stone")
    aisle_arch = make_mesh("Aisle_Arch", _transverse_rib(AISLE, MEDIUM, STEPS), "Stone")
    nave_ribs = make_mesh("Nave_Ribs", _diagonal_ribs(NAVE, STEPS, 0.30), "Stone")
    aisle_ribs = make_mesh("Aisle_Ribs", _diagonal_ribs(AISLE, STEPS, 0.24), "Stone")
    _place_bays(arcade, wall_rib, nave_ribs, aisle_ribs)
    for i, y in enumerate([-plan.HALL_Y] + plan.COLUMN_Y + [plan.HALL_Y]):
        place(f"Hall/Vault_Arch_Nave_{i + 1:02d}", nave_arch, (0, y, 0))
        for side, x in (("West", -AISLE_X), ("East", AISLE_X)):
            place(f"Hall/Vault_Arch_{side}_{i + 1:02d}", aisle_arch, (x, y, 0))


def _place_bays(arcade, wall_rib, nave_ribs, aisle_ribs):
    for i, y in enumerate(plan.BAY_CENTRES):
        place(f"Hall/Vault_Ribs_Nave_{i + 1:02d}", nave_ribs, (0, y, 0))
        for side, sign in (("West", -1), ("East", 1)):
            place(f"Hall/Arch_{side}_{i + 1:02d}", arcade, (sign * plan.COLUMN_X, y, 0))
            place(f"Hall/Vault_Ribs_{side}_{i + 1:02d}", aisle_ribs, (sign * AISLE_X, y, 0))
            place(f"Hall/Vault_Wall_Rib_{side}_{i + 1:02d}", wall_rib, (sign * plan.HALL_X, y, 0))
