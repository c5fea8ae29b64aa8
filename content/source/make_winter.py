"""Writes a winter's day with a snowman: python3 content/source/make_winter.py [FILE]"""
import math
import os
import sys

sys.dont_write_bytecode = True
_HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(_HERE, "shop"))

from solid_kit import Model, ball, box, cylinder, joined, lathe, loft, lying, mapped, moved, plate, ring, torus, tube, turned  # noqa: E402

SIDE_M = 44.0


def height(x, z):
    """Of the snow: level around the cabin and the snowman, hills behind."""
    far = min(max((math.hypot(x, z) - 7.0) / 12.0, 0.0), 1.0)
    hills = 1.6 * math.sin(0.21 * x + 1.0) * math.cos(0.17 * z) + 1.4
    return far * far * (3 - 2 * far) * hills + 0.03 * math.sin(1.3 * x) * math.cos(1.1 * z)


def _ground():
    cells, low = 44, -1.5
    at = [-SIDE_M / 2 + SIDE_M * i / cells for i in range(cells + 1)]
    solid = []
    for i in range(cells):
        for j in range(cells):
            a, b, c, d = ((at[i], at[j + 1]), (at[i + 1], at[j + 1]), (at[i + 1], at[j]), (at[i], at[j]))
            solid.append([(x, height(x, z), z) for x, z in (a, b, c)])
            solid.append([(x, height(x, z), z) for x, z in (a, c, d)])
    edge = [(x, at[-1]) for x in at] + [(at[-1], z) for z in reversed(at[:-1])] + [(x, at[0]) for x in reversed(at[:-1])] + [(at[0], z) for z in at[1:-1]]
    for (x0, z0), (x1, z1) in zip(edge, edge[1:] + edge[:1]):
        solid.append([(x0, low, z0), (x1, low, z1), (x1, height(x1, z1), z1), (x0, height(x0, z0), z0)])
    solid.append([(x, low, z) for x, z in reversed(edge)])
    return solid


def _snowman():
    body = joined(moved(mapped(ball(0.46, 40), lambda p: (p[0], 0.92 * p[1], p[2])), 0.0, 0.36), moved(ball(0.33, 36), 0.0, 1.00), moved(ball(0.24, 32), 0.0, 1.46))
    coal = joined(*[moved(ball(0.028, 14), x, 1.53, 0.215) for x in (-0.085, 0.085)],
                  *[moved(ball(0.020, 12), 0.11 * math.sin(a), 1.43 - 0.055 * math.cos(a), 0.205 + 0.015 * math.cos(a)) for a in (-1.0, -0.5, 0.0, 0.5, 1.0)],
                  *[moved(ball(0.03, 14), 0.0, y, z) for y, z in ((1.14, 0.292), (1.0, 0.325), (0.86, 0.295))])
    nose = moved(lying(lathe([(0.034, 0.0), (0.026, 0.10), (0.014, 0.22), (0.0, 0.27)], 18), "z"), 0.0, 1.47, 0.21)
    hat = moved(turned(joined(lathe([(0.0, 0.0), (0.27, 0.0), (0.275, 0.012), (0.27, 0.025), (0.175, 0.03), (0.168, 0.26), (0.175, 0.27), (0.0, 0.275)], 40)), "z", -7.0), -0.01, 1.625)
    band = moved(turned(lathe([(0.172, 0.03), (0.18, 0.035), (0.178, 0.085), (0.17, 0.09)], 40), "z", -7.0), -0.01, 1.625)
    scarf = joined(moved(mapped(torus(0.215, 0.055, 40, 14), lambda p: (p[0], 0.9 * p[1], p[2])), 0.0, 1.265),
                   moved(turned(box(-0.055, 0.055, -0.42, 0.0, -0.018, 0.018, 0.012), "x", -14.0), 0.10, 1.24, 0.26))
    arms = joined(tube([(0.28, 1.08, 0.0), (0.52, 1.22, 0.02), (0.74, 1.42, 0.06)], 0.020), tube([(0.60, 1.29, 0.03), (0.76, 1.30, 0.10)], 0.012), tube([(0.64, 1.325, 0.04), (0.66, 1.47, 0.0)], 0.012),
                  tube([(-0.28, 1.08, 0.0), (-0.55, 1.10, 0.08), (-0.78, 1.02, 0.20)], 0.020), tube([(-0.64, 1.075, 0.12), (-0.76, 1.14, 0.12)], 0.012))
    broom = joined(tube([(-0.74, 0.0, 0.22), (-0.80, 1.62, 0.17)], 0.016))
    brush = moved(turned(lathe([(0.02, 0.0), (0.035, 0.05), (0.05, 0.10), (0.13, 0.38), (0.10, 0.40), (0.0, 0.39)], 18), "z", 2.0), -0.795, 1.45, 0.172)
    return [("Body", body, "Snow"), ("Coal", coal, "Coal"), ("Nose", nose, "Carrot"), ("Hat", hat, "Coal"), ("Band", band, "Red"), ("Scarf", scarf, "Red"), ("Arms", joined(arms, broom), "Bark"),
            ("Brush", brush, "Straw")]


def _fir(tall, tiers, seed):
    trunk = cylinder(0.045 * tall, -0.3, 0.3 * tall, 14)
    needles, snow = [], []
    for i in range(tiers):
        base, r = tall * (0.14 + 0.72 * i / tiers), 0.27 * tall * (1.0 - 0.82 * i / tiers)
        top = base + 1.35 * tall / tiers
        lobes = 9 + 2 * (tiers - i)

        def ragged(scale, y, lift, r=r, lobes=lobes, i=i):
            n = 2 * lobes
            return [((1.0 if k % 2 else 0.80) * scale * r * math.cos(2 * math.pi * (k + 0.4 * i + seed) / n), y + (0.0 if k % 2 else lift),
                     -(1.0 if k % 2 else 0.80) * scale * r * math.sin(2 * math.pi * (k + 0.4 * i + seed) / n)) for k in range(n)]
        needles.append(loft([ragged(0.15, base + 0.07 * tall, 0.0), ragged(1.0, base, 0.02 * tall), ragged(0.04, top, 0.0)]))
        snow.append(moved(loft([ragged(0.10, base + 0.52 * (top - base), 0.0), ragged(0.66, base + 0.40 * (top - base) - 0.02 * tall, 0.015 * tall), ragged(0.03, top + 0.03 * tall, 0.0)]), 0.0, 0.012 * tall))
    return [("Trunk", trunk, "Bark"), ("Needles", joined(*needles), "Fir"), ("Snow", joined(*snow), "Snow")]


def _cabin():
    """4 m by 3 m; its door looks towards +z."""
    logs = []
    for i in range(9):
        y = 0.12 + 0.24 * i
        for z in (-1.5, 1.5):
            for x0, x1 in (((-2.25, -0.45), (0.45, 0.75), (1.55, 2.25)) if z > 0 and 3 <= i < 7 else ((-2.25, -0.45), (0.45, 2.25)) if z > 0 and i < 8 else ((-2.25, 2.25),)):
                logs.append(moved(lying(cylinder(0.125, x0, x1, 18, 0.015), "x"), 0.0, y, z))
        for x in (-2.0, 2.0):
            logs.append(moved(lying(cylinder(0.125, -1.75, 1.75, 18, 0.015), "z"), x, y + 0.12, 0.0))
    gable = plate([(-1.62, 2.25), (1.62, 2.25), (0.0, 3.55)], -0.06, 0.06)
    gables = joined(*[moved(turned(gable, "y", 90.0), x) for x in (-1.94, 1.94)])
    slab = plate([(0.0, 3.60), (-2.05, 1.99), (-2.11, 2.07), (0.0, 3.72), (2.11, 2.07), (2.05, 1.99)][::-1], -2.55, 2.55)
    snow = plate([(0.0, 3.72), (-2.11, 2.07), (-2.20, 2.16), (-2.17, 2.30), (-0.12, 3.94), (0.12, 3.94), (2.17, 2.30), (2.20, 2.16), (2.11, 2.07)][::-1], -2.60, 2.60)
    door = joined(box(-0.40, 0.40, 0.05, 1.95, 1.44, 1.50), *[box(x - 0.19, x + 0.19, 0.09, 1.91, 1.50, 1.525, 0.01) for x in (-0.2, 0.2)])
    frame = joined(box(-0.50, -0.40, 0.0, 2.05, 1.38, 1.64, 0.01), box(0.40, 0.50, 0.0, 2.05, 1.38, 1.64, 0.01), box(-0.52, 0.52, 1.97, 2.09, 1.36, 1.66, 0.01),
                   moved(turned(ring([(0.72, 0.70), (1.58, 0.70), (1.58, 1.72), (0.72, 1.72)], [(0.80, 0.78), (1.50, 0.78), (1.50, 1.64), (0.80, 1.64)], 1.40, 1.64), "x", 90.0)),
                   box(1.13, 1.17, 0.78, 1.64, 1.50, 1.56), box(0.80, 1.50, 1.19, 1.23, 1.50, 1.56))
    glass = box(0.80, 1.50, 0.78, 1.64, 1.46, 1.49)
    chimney = joined(box(0.85, 1.35, 2.4, 4.15, -0.95, -0.45, 0.02), box(0.79, 1.41, 4.12, 4.24, -1.01, -0.39, 0.02))
    cap = moved(mapped(ball(0.36, 24), lambda p: (p[0], 0.42 * max(p[1], -0.12), p[2])), 1.10, 4.27, -0.70)
    knob = moved(ball(0.04, 14), 0.30, 0.98, 1.55)
    return [("Logs", joined(*logs), "Log"), ("Gables", gables, "Log"), ("Roof", turned(slab, "y", 90.0), "Bark"), ("Roof_Snow", turned(snow, "y", 90.0), "Snow"), ("Door", door, "Red"),
            ("Frames", frame, "Straw"), ("Glass", glass, "Window"), ("Chimney", chimney, "Brick"), ("Chimney_Snow", cap, "Snow"), ("Knob", knob, "Straw")]


def _fence(count):
    posts = [joined(box(x - 0.05, x + 0.05, -0.4, 0.92, -0.05, 0.05, 0.012)) for x in (1.1 * i for i in range(count))]
    rails = [box(-0.05, 1.1 * (count - 1) + 0.05, y, y + 0.09, 0.05, 0.085, 0.01) for y in (0.34, 0.68)]
    snow = [moved(mapped(ball(0.085, 16), lambda p: (p[0], 0.75 * max(p[1], -0.02), p[2])), 1.1 * i, 0.925) for i in range(count)]
    return [("Wood", joined(*posts, *rails), "Log"), ("Snow", joined(*snow), "Snow")]


def _sledge():
    runners = [tube([(0.62, 0.34, z), (0.60, 0.16, z), (0.48, 0.04, z), (0.30, 0.02, z), (-0.55, 0.02, z)], 0.018) for z in (-0.2, 0.2)]
    posts = [cylinder(0.014, 0.02, 0.24, 12) for _ in range(4)]
    stands = [moved(p, x, 0.0, z) for p, (x, z) in zip(posts, ((0.30, -0.2), (0.30, 0.2), (-0.42, -0.2), (-0.42, 0.2)))]
    slats = [box(-0.56, 0.46, 0.24, 0.265, z - 0.045, z + 0.045, 0.006) for z in (-0.2, -0.1, 0.0, 0.1, 0.2)]
    return [("Runners", joined(*runners, *stands), "Coal"), ("Slats", joined(*slats), "Straw")]


def _quarter(deg):
    half = math.radians(deg) / 2
    return [0.0, round(math.sin(half), 6), 0.0, round(math.cos(half), 6)]


def _place(model, name, parts, x, z, deg=0.0, scale=1.0):
    model.group(name, translation=[x, round(height(x, z), 4), z], rotation=_quarter(deg), scale=[scale] * 3)
    for part, solid, material in parts:
        model.add(f"{name}/{part}", solid, material)


def main():
    path = sys.argv[1] if len(sys.argv) > 1 else os.path.join(_HERE, "..", "models", "winter.glb")
    model = Model("make_winter.py")
    for name, colour in (("Snow", (246, 248, 252)), ("Coal", (44, 44, 50)), ("Carrot", (240, 128, 40)), ("Red", (206, 48, 52)), ("Bark", (112, 78, 54)), ("Straw", (226, 184, 104)),
                         ("Fir", (52, 124, 84)), ("Log", (168, 112, 66)), ("Brick", (176, 84, 66)), ("Window", (252, 220, 120))):
        model.material(name, colour, 0.8)
    model.add("Ground", _ground(), "Snow", 60.0)
    _place(model, "Snowman", _snowman(), 0.0, 0.0)
    _place(model, "Cabin", _cabin(), 3.3, -4.2, -18.0)
    _place(model, "Sledge", _sledge(), 1.55, 0.35, 30.0)
    firs = [_fir(3.4, 5, 0.0), _fir(3.4, 4, 0.5)]
    for i, (x, z, deg, scale) in enumerate(((-2.9, -3.0, 10.0, 1.0), (-4.6, -1.6, 50.0, 0.72), (-5.2, -5.4, 80.0, 1.35), (-1.2, -6.6, 25.0, 1.15), (0.2, -9.0, 70.0, 1.5), (6.9, -7.4, 15.0, 1.4),
                                           (8.2, -3.4, 60.0, 1.05), (-8.6, -8.0, 35.0, 1.6), (3.2, -11.5, 5.0, 1.7), (-12.5, -11.0, 45.0, 1.5), (11.5, -12.0, 30.0, 1.6), (-7.2, -12.8, 20.0, 1.7))):
        _place(model, f"Fir_{i + 1:02d}", firs[i % 2], x, z, deg, scale)
    _place(model, "Fence_1", _fence(5), -4.9, 0.5, -8.0)
    _place(model, "Fence_2", _fence(4), 3.6, 0.2, 6.0)
    model.write(path)


if __name__ == "__main__":
    main()
