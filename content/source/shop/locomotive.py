"""A small steam locomotive, half a metre long, that faces +x and stands on its rails at y = 0: parts by name, as solids."""
import math

from solid_kit import ball, box, circle, cylinder, extruded, joined, lathe, lying, moved, plate, ring, torus, tube, turned

AXLE_Y, WHEEL_Z = 0.075, 0.06


def _wheel(radius, spokes):
    """Around z, in the middle of its width."""
    rim = ring(circle(radius), circle(radius - 0.011), -0.007, 0.007)
    flange = ring(circle(radius + 0.006), circle(radius - 0.008), -0.0105, -0.007)
    hub = cylinder(0.013, -0.010, 0.012, 20, 0.002)
    bars = [turned(box(0.010, radius - 0.009, -0.004, 0.004, -0.0035, 0.0035), "y", 360.0 * i / spokes) for i in range(spokes)]
    return turned(joined(rim, flange, hub, *bars), "x", 90.0)


def _wheels():
    parts = []
    big, small = _wheel(0.072, 10), _wheel(0.04, 8)
    for side in (1.0, -1.0):
        for x in (-0.115, 0.04):
            parts.append(moved(big if side > 0 else turned(big, "y", 180.0), x, 0.078, side * WHEEL_Z))
        parts.append(moved(small if side > 0 else turned(small, "y", 180.0), 0.185, 0.046, side * WHEEL_Z))
    axles = [moved(lying(cylinder(0.006, -WHEEL_Z, WHEEL_Z, 12), "z"), x, y, 0.0) for x, y in ((-0.115, 0.078), (0.04, 0.078), (0.185, 0.046))]
    return joined(*parts, *axles)


def _rods():
    parts = []
    for side in (1.0, -1.0):
        z = side * (WHEEL_Z + 0.019)
        coupling = box(-0.125, 0.05, 0.052, 0.062, -0.003, 0.003, 0.0012)
        pins = joined(*[moved(lying(cylinder(0.008, -0.010, 0.006, 16, 0.001), "z"), x, 0.057, 0.0) for x in (-0.115, 0.04)])
        main = moved(turned(box(-0.005, 0.165, -0.004, 0.004, -0.0025, 0.0025), "z", 5.0), 0.04, 0.057, side * 0.008)
        parts += [moved(joined(coupling, pins if side > 0 else turned(moved(pins, 0.0375), "y", 180.0)), 0.0, 0.0, z)
                  if side > 0 else moved(joined(coupling, moved(turned(moved(pins, 0.0375), "y", 180.0), -0.0375)), 0.0, 0.0, z), moved(main, 0.0, 0.0, z)]
    return joined(*parts)


def _boiler():
    profile = [(0.0, -0.10), (0.056, -0.10), (0.062, -0.094), (0.062, 0.145), (0.066, 0.145), (0.066, 0.215), (0.060, 0.224), (0.0, 0.228)]
    shell = lying(lathe(profile, 40), "x")
    bands = [lying(lathe([(0.060, x), (0.0655, x), (0.0655, x + 0.008), (0.060, x + 0.008)], 40), "x") for x in (-0.055, 0.01, 0.075)]
    return moved(joined(shell, *bands), 0.0, 0.165, 0.0)


def _brass():
    dome = lathe([(0.034, 0.0), (0.030, 0.006), (0.026, 0.010), (0.026, 0.030), (0.023, 0.042), (0.015, 0.051), (0.0, 0.054)], 32)
    cap = lathe([(0.021, 0.0), (0.030, 0.008), (0.031, 0.014), (0.024, 0.014), (0.020, 0.004)][:3] + [(0.030, 0.016), (0.022, 0.018)], 32)
    lamp = joined(box(-0.014, 0.012, 0.0, 0.030, -0.014, 0.014, 0.003), moved(lying(lathe([(0.009, 0.0), (0.0125, 0.003), (0.0125, 0.009), (0.009, 0.010)], 24), "x"), 0.011, 0.015, 0.0))
    rails = [tube([(-0.09, 0.208, side * 0.066), (0.20, 0.208, side * 0.066)], 0.0034) for side in (1.0, -1.0)]
    posts = [moved(ball(0.0068, 12), x, 0.208, side * 0.064) for side in (1.0, -1.0) for x in (-0.05, 0.06, 0.17)]
    bell = moved(lathe([(0.017, 0.0), (0.014, 0.005), (0.011, 0.016), (0.007, 0.022), (0.0, 0.023)], 24), 0.118, 0.232, 0.0)
    return joined(moved(dome, 0.055, 0.222, 0.0), moved(cap, 0.178, 0.300, 0.0), moved(lamp, 0.225, 0.222, 0.0), *rails, *posts, bell)


def _black():
    """Chimney, smokebox door, frame, steps, buffers."""
    chimney = lathe([(0.034, 0.0), (0.025, 0.008), (0.020, 0.018), (0.020, 0.080), (0.021, 0.082)], 32)
    door = lying(lathe([(0.048, 0.0), (0.048, 0.004), (0.036, 0.010), (0.0, 0.013)], 40), "x")
    handle = moved(lying(torus(0.013, 0.0022, 24, 8), "x"), 0.245, 0.165, 0.0)
    frame = joined(box(-0.235, 0.245, 0.085, 0.103, -0.044, 0.044), box(0.238, 0.252, 0.080, 0.125, -0.085, 0.085, 0.002))
    saddle = box(0.15, 0.212, 0.10, 0.125, -0.04, 0.04, 0.004)
    buffers = [moved(lying(lathe([(0.008, 0.0), (0.008, 0.018), (0.016, 0.019), (0.016, 0.023), (0.012, 0.025)], 24), "x"), 0.252, 0.106, z) for z in (-0.055, 0.055)]
    return joined(moved(chimney, 0.178, 0.222, 0.0), moved(door, 0.226, 0.165, 0.0), handle, frame, saddle, *buffers)


def _cylinders():
    return joined(*[moved(joined(lying(cylinder(0.026, -0.038, 0.038, 32, 0.004), "x"), box(-0.032, 0.032, 0.0, 0.040, -0.018, 0.018, 0.003),
                                 lying(cylinder(0.005, -0.075, -0.038, 12), "x")), 0.185, 0.098, side * 0.074) for side in (1.0, -1.0)])


def _cab():
    """Walls with their windows, as a frame of posts and panels; the footplate."""
    walls = []
    for side in (1.0, -1.0):
        outer = [(-0.105, 0.0), (0.0, 0.0), (0.0, 0.165), (-0.105, 0.165)]
        hole = [(-0.082, 0.085), (-0.022, 0.085), (-0.022, 0.140), (-0.082, 0.140)]
        frame = turned(ring([(x, y) for x, y in outer], [(x, y) for x, y in hole], -0.003, 0.003), "x", 90.0)
        walls.append(moved(frame, -0.095, 0.105, side * 0.070))
    front = plate([(-0.070, 0.0), (0.070, 0.0), (0.070, 0.165), (-0.070, 0.165)], -0.003, 0.003)
    walls.append(moved(turned(front, "y", 90.0), -0.098, 0.105, 0.0))
    plate_ = box(-0.235, 0.238, 0.103, 0.109, -0.082, 0.082, 0.0015)
    tanks = [box(-0.09, 0.10, 0.110, 0.180, side * 0.0745 - 0.0105, side * 0.0745 + 0.0105, 0.003) for side in (1.0, -1.0)]
    bunker = box(-0.235, -0.205, 0.109, 0.20, -0.070, 0.070, 0.004)
    return joined(*walls, plate_, *tanks, bunker)


def _roof():
    over = [(0.086 * math.sin(a), 0.262 + 0.075 * (math.cos(a) - math.cos(1.15))) for a in (1.15 - 2.3 * i / 12 for i in range(13))]
    outline = over + [(x * 0.97, y - 0.006) for x, y in reversed(over)]
    roof = plate(outline, -0.075, 0.075)
    return moved(turned(roof, "y", 90.0), -0.15, 0.0, 0.0)


def _track():
    sleepers = [box(x - 0.013, x + 0.013, -0.030, -0.012, -0.105, 0.105, 0.003) for x in (-0.25 + 0.0714 * i for i in range(8))]
    profile = [(-0.011, -0.012), (0.011, -0.012), (0.011, -0.009), (0.003, -0.006), (0.003, 0.0), (0.006, 0.001), (0.006, 0.006), (-0.006, 0.006),
               (-0.006, 0.001), (-0.003, 0.0), (-0.003, -0.006), (-0.011, -0.009)]
    rail = turned(plate(profile, -0.295, 0.295), "y", 90.0)
    return joined(*sleepers), joined(*[moved(rail, 0.0, 0.0, side * WHEEL_Z) for side in (1.0, -1.0)])


def parts():
    """Name, solid and material of each part."""
    sleepers, rails = _track()
    return [("Boiler", _boiler(), "Green"), ("Cab", _cab(), "Green"), ("Roof", _roof(), "Black"), ("Black", _black(), "Black"),
            ("Wheels", _wheels(), "Red"), ("Rods", _rods(), "Steel"), ("Cylinders", _cylinders(), "Red"), ("Brass", _brass(), "Brass"),
            ("Sleepers", sleepers, "Wood"), ("Rails", rails, "Steel")]


def materials(model):
    model.material("Green", (58, 110, 74), 0.35)
    model.material("Black", (52, 52, 56), 0.4)
    model.material("Red", (172, 52, 44), 0.45)
    model.material("Steel", (168, 172, 178), 0.35, 0.6)
    model.material("Brass", (214, 168, 76), 0.3, 0.6)
    model.material("Wood", (140, 100, 66), 0.8)
