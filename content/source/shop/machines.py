"""The shop's machines, each as parts by name with their material; they stand on y = 0 and look towards +z."""
import math

from solid_kit import (ball, box, circle, cylinder, extruded, gear, joined, lathe, lying, moved, plate, ring, torus, tube, turned)


def handwheel(radius, spokes=4):
    """Around z, its handle towards +z."""
    rim = torus(radius, 0.09 * radius, 36, 10)
    hub = cylinder(0.22 * radius, -0.16 * radius, 0.16 * radius, 20, 0.02 * radius)
    bars = [turned(lying(cylinder(0.06 * radius, 0.15 * radius, 0.98 * radius, 10), "x"), "y", 360.0 * i / spokes) for i in range(spokes)]
    grip = moved(lathe([(0.05 * radius, 0.0), (0.09 * radius, 0.1 * radius), (0.1 * radius, 0.35 * radius), (0.06 * radius, 0.45 * radius)], 16),
                 0.98 * radius, 0.06 * radius, 0.0)
    return turned(joined(rim, hub, *bars, grip), "x", 90.0)


def lever(length, lean_deg):
    """Upright from its hub, a ball at its end."""
    bar = joined(lathe([(0.014, 0.0), (0.008, length)], 14), moved(ball(0.02, 16), 0.0, length + 0.008, 0.0), lying(cylinder(0.024, -0.016, 0.016, 20, 0.004), "z"))
    return turned(bar, "z", lean_deg)


def _bed(length):
    section = [(-0.16, 0.62), (0.16, 0.62), (0.16, 0.66), (0.09, 0.70), (0.09, 0.80), (0.17, 0.84), (0.17, 0.875), (0.13, 0.875), (0.115, 0.892),
               (0.10, 0.875), (-0.10, 0.875), (-0.115, 0.892), (-0.13, 0.875), (-0.17, 0.875), (-0.17, 0.84), (-0.09, 0.80), (-0.09, 0.70), (-0.16, 0.66)]
    return turned(plate(section, -length / 2, length / 2), "y", 90.0)


def engine_lathe():
    """2.3 m long along x."""
    pedestals = joined(*[joined(box(x - 0.26, x + 0.26, 0.06, 0.64, -0.21, 0.21, 0.03), box(x - 0.30, x + 0.30, 0.0, 0.07, -0.25, 0.25, 0.012)) for x in (-0.78, 0.82)])
    tray = box(-0.55, 0.62, 0.45, 0.475, -0.28, 0.30, 0.008)
    head = joined(box(-1.12, -0.46, 0.86, 1.30, -0.21, 0.21, 0.03), box(-1.06, -0.52, 1.30, 1.335, -0.16, 0.16, 0.012))
    belt = joined(box(-1.24, -1.12, 0.60, 1.27, -0.19, 0.19, 0.03), moved(lying(cylinder(0.10, 0.0, 0.012, 32, 0.004), "x"), -1.252, 1.09, 0.0))
    axis_y = 1.09
    nose = lying(cylinder(0.06, -0.46, -0.40, 32, 0.006), "x")
    chuck = lying(cylinder(0.125, -0.40, -0.30, 48, 0.010), "x")
    jaws = [turned(box(-0.31, -0.235, 0.034, 0.115, -0.018, 0.018, 0.004), "x", 120.0 * i + 20.0) for i in range(3)]
    work = lying(lathe([(0.0, -0.30), (0.034, -0.30), (0.034, -0.05), (0.046, -0.05), (0.046, 0.06), (0.030, 0.075), (0.030, 0.22), (0.038, 0.228), (0.038, 0.26),
                        (0.022, 0.27), (0.022, 0.40), (0.005, 0.415), (0.0, 0.416)], 32), "x")
    spindle = moved(joined(nose, chuck, *jaws), 0.0, axis_y, 0.0)
    tail_body = [(-0.10, 0.88), (0.17, 0.88), (0.17, 0.93), (0.13, 1.02), (0.13, 1.155), (0.10, 1.17), (-0.07, 1.17), (-0.09, 1.15), (-0.09, 1.00)]
    tail = joined(moved(plate(tail_body, -0.075, 0.075), 0.62, 0.0, 0.0),
                  moved(lying(lathe([(0.0, -0.135), (0.016, -0.10), (0.034, -0.095), (0.034, 0.06)], 24), "x"), 0.53, axis_y, 0.0))
    tail_wheel = moved(turned(handwheel(0.085), "y", 90.0), 0.79, axis_y, 0.0)
    tail_lever = moved(lever(0.13, -35.0), 0.64, 1.165, 0.05)
    saddle = joined(box(-0.17, 0.17, 0.878, 0.925, -0.20, 0.20, 0.01), box(-0.085, 0.085, 0.925, 0.965, -0.19, 0.21, 0.008),
                    box(-0.065, 0.065, 0.965, 1.00, -0.06, 0.18, 0.008), box(-0.03, 0.045, 1.00, 1.075, -0.035, 0.045, 0.006))
    tool = joined(box(-0.012, 0.018, 1.055, 1.083, -0.115, 0.06), moved(cylinder(0.012, 1.075, 1.105, 16, 0.003), 0.008, 0.0, 0.005))
    apron = joined(box(-0.17, 0.15, 0.66, 0.885, 0.20, 0.262, 0.015))
    carriage_x = 0.05
    wheels = joined(moved(handwheel(0.095), -0.08, 0.77, 0.30), moved(handwheel(0.05, 3), 0.0, 0.945, 0.262), moved(turned(handwheel(0.045, 3), "y", 90.0), 0.135, 0.985, 0.08),
                    moved(lever(0.10, 25.0), 0.07, 0.81, 0.285), moved(lever(0.10, -20.0), 0.10, 0.73, 0.285))
    screws = joined(moved(lying(cylinder(0.017, -0.50, 1.02, 16), "x"), 0.0, 0.735, 0.215), moved(lying(cylinder(0.012, -0.50, 1.02, 16), "x"), 0.0, 0.685, 0.215),
                    box(0.99, 1.06, 0.64, 0.80, 0.15, 0.245, 0.01))
    gearbox = joined(box(-1.08, -0.48, 0.60, 0.84, 0.14, 0.255, 0.02), *[moved(lever(0.09, lean), x, 0.73, 0.275) for x, lean in ((-0.96, 30.0), (-0.80, -15.0), (-0.64, 12.0))])
    dials = joined(*[moved(lying(lathe([(0.05, 0.0), (0.05, 0.012), (0.04, 0.018), (0.018, 0.018), (0.016, 0.04), (0.0, 0.042)], 32), "z"), x, 1.16, 0.205) for x in (-0.97, -0.80)],
                   moved(lever(0.14, 20.0), -0.60, 1.13, 0.235))
    return [("Pedestals", joined(pedestals, tray), "Grey_Green"), ("Bed", _bed(2.1), "Iron"), ("Headstock", joined(head, belt), "Grey_Green"), ("Gearbox", gearbox, "Grey_Green"),
            ("Dials", dials, "Iron"), ("Spindle", spindle, "Steel"), ("Work", moved(work, 0.0, axis_y, 0.0), "Brass"), ("Tailstock", tail, "Grey_Green"),
            ("Tailstock_Wheel", joined(tail_wheel, tail_lever), "Steel"), ("Carriage", moved(joined(saddle, apron), carriage_x), "Iron"),
            ("Tool", moved(tool, carriage_x), "Steel"), ("Wheels", moved(wheels, carriage_x), "Steel"), ("Screws", screws, "Steel")]


def drill_press():
    base = joined(box(-0.24, 0.24, 0.0, 0.075, -0.20, 0.34, 0.018), *[box(x - 0.012, x + 0.012, 0.073, 0.088, 0.02, 0.30) for x in (-0.16, 0.0, 0.16)])
    column = joined(cylinder(0.048, 0.05, 1.72, 32), lathe([(0.085, 0.06), (0.085, 0.13), (0.06, 0.16), (0.049, 0.16)], 32))
    table = joined(moved(cylinder(0.19, 0.86, 0.90, 48, 0.008), 0.0, 0.0, 0.24), box(-0.05, 0.05, 0.80, 0.865, 0.0, 0.22, 0.012), cylinder(0.085, 0.76, 0.92, 32, 0.01),
                   moved(lever(0.13, -80.0), 0.085, 0.84, 0.0))
    outline = circle(0.15, 28, at=(0.0, 0.24))[:15]
    head_outline = outline + [(-0.13, -0.12), (0.13, -0.12)]
    head = joined(extruded([(x, -z) for x, z in reversed(head_outline)], 1.34, 1.62), cylinder(0.085, 1.30, 1.66, 32, 0.01))
    cover = extruded([(x, -z) for x, z in reversed(circle(0.17, 24, at=(0.0, 0.24))[:13] + [(-0.17, -0.22), (0.17, -0.22)])], 1.62, 1.76)
    motor = moved(joined(cylinder(0.105, 1.28, 1.60, 36, 0.02), *[turned(box(0.100, 0.116, 1.33, 1.56, -0.006, 0.006), "y", 20.0 * i) for i in range(18)]), 0.0, 0.0, -0.24)
    quill = moved(joined(cylinder(0.036, 1.19, 1.35, 28, 0.004), lathe([(0.010, 1.06), (0.024, 1.07), (0.032, 1.12), (0.032, 1.17), (0.026, 1.19)], 28), cylinder(0.006, 0.95, 1.07, 12)), 0.0, 0.0, 0.24)
    arms = [turned(joined(lying(cylinder(0.009, 0.0, 0.24, 12), "x"), moved(ball(0.022, 16), 0.245)), "z", 20.0 + 120.0 * i) for i in range(3)]
    feed = moved(turned(joined(*arms, lying(cylinder(0.04, -0.05, 0.03, 24, 0.008), "z")), "y", 90.0), 0.185, 1.44, 0.20)
    return [("Base", base, "Iron"), ("Column", column, "Steel"), ("Table", table, "Iron"), ("Head", joined(head, cover), "Grey_Green"), ("Motor", motor, "Iron"),
            ("Quill", quill, "Steel"), ("Feed", feed, "Steel")]


def vise():
    body = joined(box(-0.075, 0.075, 0.0, 0.028, -0.10, 0.10, 0.008), box(-0.055, 0.055, 0.028, 0.125, -0.09, -0.005, 0.012), box(-0.05, 0.05, 0.045, 0.10, -0.09, 0.13, 0.006))
    jaw = joined(box(-0.06, 0.06, 0.035, 0.128, 0.055, 0.125, 0.012), box(-0.07, 0.07, 0.095, 0.128, -0.008, 0.002), box(-0.07, 0.07, 0.095, 0.128, 0.048, 0.058))
    screw = joined(moved(lying(cylinder(0.014, 0.12, 0.19, 20, 0.003), "z"), 0.0, 0.07, 0.0), moved(lying(cylinder(0.0065, -0.10, 0.10, 12), "x"), 0.0, 0.07, 0.175),
                   *[moved(ball(0.012, 14), x, 0.07, 0.175) for x in (-0.1, 0.1)])
    return [("Body", body, "Blue"), ("Jaw", jaw, "Blue"), ("Screw", screw, "Steel")]


def workbench():
    """2 m along x."""
    top = box(-1.0, 1.0, 0.83, 0.90, -0.36, 0.36, 0.008)
    legs = joined(*[box(x - 0.045, x + 0.045, 0.0, 0.84, z - 0.045, z + 0.045, 0.006) for x in (-0.9, 0.9) for z in (-0.29, 0.29)],
                  box(-0.86, 0.86, 0.16, 0.20, -0.30, 0.30, 0.004), *[box(-0.86, 0.86, 0.74, 0.83, z - 0.02, z + 0.02, 0.004) for z in (-0.29, 0.29)])
    drawers = joined(*[joined(box(0.36, 0.86, y, y + 0.16, -0.28, 0.315, 0.008)) for y in (0.38, 0.56)])
    handles = joined(*[tube([(0.53, y + 0.08, 0.31), (0.53, y + 0.08, 0.345), (0.54, y + 0.08, 0.352), (0.68, y + 0.08, 0.352), (0.69, y + 0.08, 0.345), (0.69, y + 0.08, 0.31)], 0.007)
                       for y in (0.38, 0.56)])
    return [("Top", top, "Wood"), ("Legs", legs, "Dark_Wood"), ("Drawers", drawers, "Wood"), ("Handles", handles, "Iron")]


def stool():
    seat = lathe([(0.0, 0.62), (0.165, 0.62), (0.175, 0.635), (0.17, 0.655), (0.10, 0.662), (0.0, 0.658)], 36)
    legs = [tube([(0.23 * math.cos(a), 0.0, 0.23 * math.sin(a)), (0.11 * math.cos(a), 0.625, 0.11 * math.sin(a))], 0.018) for a in (math.pi * (0.25 + 0.5 * i) for i in range(4))]
    foot = moved(torus(0.195, 0.011, 40, 10), 0.0, 0.22, 0.0)
    return [("Seat", seat, "Wood"), ("Legs", joined(*legs, foot), "Iron")]


def lamp(drop):
    """Hangs from y = 0."""
    shade = lathe([(0.23, -drop), (0.235, -drop), (0.205, -drop + 0.05), (0.06, -drop + 0.17), (0.045, -drop + 0.25), (0.03, -drop + 0.26), (0.0, -drop + 0.26)], 40)
    inner = moved(ball(0.055, 20), 0.0, -drop + 0.045, 0.0)
    cable = joined(cylinder(0.006, -drop + 0.25, -0.03, 10), lathe([(0.012, -0.05), (0.05, -0.02), (0.05, 0.0)], 24))
    return [("Shade", shade, "Blue"), ("Bulb", inner, "White"), ("Cable", cable, "Iron")]


def toolbox():
    body = joined(box(-0.24, 0.24, 0.0, 0.15, -0.11, 0.11, 0.008), box(-0.245, 0.245, 0.152, 0.205, -0.115, 0.115, 0.02))
    handle = tube([(-0.09, 0.20, 0.0), (-0.09, 0.24, 0.0), (-0.075, 0.25, 0.0), (0.075, 0.25, 0.0), (0.09, 0.24, 0.0), (0.09, 0.20, 0.0)], 0.009)
    latches = [box(x - 0.02, x + 0.02, 0.115, 0.175, 0.108, 0.122, 0.003) for x in (-0.14, 0.14)]
    return [("Body", body, "Red"), ("Fittings", joined(handle, *latches), "Steel")]


def wrench(length):
    """Flat in the xy plane, upright, its open jaw up."""
    r = 0.13 * length
    outline = [(-0.045 * length, 0.02 * length), (0.045 * length, 0.02 * length), (0.035 * length, 0.8 * length)]
    right_side = [(r * math.sin(a), length - r * math.cos(a)) for a in (math.radians(d) for d in (30, 60, 90, 120, 150))]
    notch = [(0.055 * length, length + 0.10 * length), (0.05 * length, length - 0.01 * length), (-0.05 * length, length - 0.01 * length), (-0.055 * length, length + 0.10 * length)]
    left_side = [(-x, y) for x, y in reversed(right_side)]
    return plate(outline + right_side + notch + left_side + [(-0.035 * length, 0.8 * length)], -0.006, 0.006)


def hammer():
    handle = tube([(0.0, 0.0, 0.0), (0.0, 0.30, 0.0)], 0.013, 12)
    head = moved(lying(lathe([(0.016, -0.07), (0.020, -0.062), (0.020, -0.03), (0.016, -0.02), (0.016, 0.02), (0.004, 0.06)], 20), "x"), 0.0, 0.305, 0.0)
    return handle, head


def tool_wall():
    """A board with tools, 1.6 m wide, at y = 0."""
    board = joined(box(-0.8, 0.8, 0.0, 0.62, -0.05, 0.0), *[box(x0, x1, y0, y1, 0.0, 0.025) for x0, x1, y0, y1 in ((-0.8, 0.8, 0.0, 0.03), (-0.8, 0.8, 0.59, 0.62), (-0.8, -0.77, 0.03, 0.59), (0.77, 0.8, 0.03, 0.59))])
    tools = [moved(wrench(0.20 + 0.045 * i), -0.66 + 0.13 * i, 0.10, 0.018) for i in range(5)]
    handle, head = hammer()
    handles = [moved(handle, x, 0.14, 0.022) for x in (0.12, 0.30)]
    heads = [moved(head, x, 0.14, 0.022) for x in (0.12, 0.30)]
    saw_blade = plate([(0.42, 0.16), (0.50, 0.13), (0.74, 0.44), (0.72, 0.50)], 0.012, 0.016)
    saw_grip = moved(turned(ring(circle(0.055, 24, 0.75), circle(0.03, 24, 0.7), -0.011, 0.011), "x", 90.0), 0.44, 0.135, 0.014)
    return [("Board", board, "Wood"), ("Wrenches", joined(*tools, saw_blade, *heads), "Steel"), ("Grips", joined(*handles, saw_grip), "Dark_Wood")]


def gears():
    """A train of three wheels on a plate, upright in the xy plane, 0.7 m wide."""
    wheels = [turned(gear(32, 0.20, 0.022, 0.05, 0.022), "x", 90.0), turned(gear(16, 0.105, 0.022, 0.05, 0.018), "x", 90.0), turned(gear(24, 0.152, 0.022, 0.05, 0.02), "x", 90.0)]
    places = [(-0.20, 0.0, 3.0), (0.083, 0.0, 0.0), (0.083 + 0.235 * math.cos(1.0), -0.235 * math.sin(1.0) * 1.0, 4.0)]
    turned_wheels = [moved(turned(w, "z", deg), x, y, 0.02) for w, (x, y, deg) in zip(wheels, places)]
    pins = [moved(lying(cylinder(0.019, 0.0, 0.09, 20, 0.003), "z"), x, y, 0.0) for x, y, _ in places]
    back = plate([(-0.46, -0.40), (0.43, -0.40), (0.43, 0.26), (-0.46, 0.26)], -0.02, 0.0)
    return [("Plate", back, "Grey_Green"), ("Wheels", joined(*turned_wheels), "Steel"), ("Pins", joined(*pins), "Brass")]


def barrel():
    body = lathe([(0.0, 0.0), (0.27, 0.0), (0.28, 0.02), (0.28, 0.28), (0.29, 0.29), (0.29, 0.31), (0.28, 0.32), (0.28, 0.57), (0.29, 0.58), (0.29, 0.60), (0.28, 0.61), (0.28, 0.86),
                  (0.27, 0.88), (0.265, 0.875), (0.0, 0.875)], 44)
    plug = moved(cylinder(0.035, 0.875, 0.895, 20, 0.005), 0.15, 0.0, 0.05)
    return [("Body", body, "Blue"), ("Plug", plug, "Steel")]
