"""Writes eight copies of one locomotive, side by side in the plane that the camera of styles.level.json looks at:
python3 content/source/make_styles.py [FILE]
"""
import math
import os
import sys

sys.dont_write_bytecode = True
_HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(_HERE, "shop"))

import locomotive  # noqa: E402
from solid_kit import Model  # noqa: E402

COLUMNS, ROWS = 4, 2
ACROSS_M, DOWN_M = 0.66, 0.52
DIRECTION = (0.62, 0.42, 1.0)  # from the locomotives to the eye


def places():
    """Where the copies stand: rows and columns in the picture's plane, so that each is seen from the same side."""
    length = math.sqrt(sum(c * c for c in DIRECTION))
    back = [c / length for c in DIRECTION]
    flat = math.hypot(back[0], back[2])
    right = (back[2] / flat, 0.0, -back[0] / flat)
    up = (-back[1] * back[0] / flat, flat, -back[1] * back[2] / flat)
    for row in range(ROWS):
        for column in range(COLUMNS):
            a, b = (column - (COLUMNS - 1) / 2) * ACROSS_M, ((ROWS - 1) / 2 - row) * DOWN_M
            yield [round(a * right[k] + b * up[k], 5) for k in range(3)]


def main():
    path = sys.argv[1] if len(sys.argv) > 1 else os.path.join(_HERE, "..", "models", "styles.glb")
    model = Model("make_styles.py")
    locomotive.materials(model)
    parts = locomotive.parts()
    for number, place in enumerate(places(), 1):
        model.group(f"Locomotive_{number}", translation=place)
        for name, solid, material in parts:
            model.add(f"Locomotive_{number}/{name}", solid, material)
    model.write(path)


if __name__ == "__main__":
    main()
