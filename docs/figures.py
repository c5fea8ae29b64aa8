"""Draws the pictures of docs/report/figures.md, of the README and of the styles' pages.

    python3 docs/figures.py 13                          one figure
    python3 docs/figures.py teapot --model teapot.glb   a picture of a model that is not ours
    python3 docs/figures.py all                         all that need no model from elsewhere

Needs a built Hatchway (`--hatchway PROGRAM`, build/release/bin/hatchway) and nothing but Python. Figures 4, 5, 7 and 11 show
filters that the engine does not have: the script samples the map's levels itself.
"""
import argparse
import json
import math
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
FIGURES = os.path.join(ROOT, "docs", "report", "figures")
GAP = 8


# ---- Pictures: (width, height, rows of RGB bytes) ---------------------------------------------------------------------

def read_png(path):
    """Reads 8-bit gray or RGB without interlace: what Hatchway and content/source write."""
    with open(path, "rb") as file:
        data = file.read()
    place, chunks, header = 8, b"", None
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        body = data[place + 8:place + 8 + length]
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        if kind == b"IDAT":
            chunks += body
        place += 12 + length
    width, height, _, colour = header[:4]
    channels = {0: 1, 2: 3}[colour]
    raw, stride, rows = zlib.decompress(chunks), width * channels, []
    before = bytearray(stride)
    for y in range(height):
        start = y * (stride + 1)
        row = _unfiltered(raw[start], bytearray(raw[start + 1:start + 1 + stride]), before, channels)
        rows.append(row)
        before = row
    if channels == 1:
        rows = [bytearray(value for gray in row for value in (gray, gray, gray)) for row in rows]
    return width, height, rows


def _unfiltered(kind, row, before, step):
    if kind == 0:
        return row
    for i, value in enumerate(row):
        left = row[i - step] if i >= step else 0
        up = before[i]
        if kind == 1:
            guess = left
        elif kind == 2:
            guess = up
        elif kind == 3:
            guess = (left + up) // 2
        else:
            corner = before[i - step] if i >= step else 0
            p = left + up - corner
            a, b, c = abs(p - left), abs(p - up), abs(p - corner)
            guess = left if a <= b and a <= c else up if b <= c else corner
        row[i] = (value + guess) & 255
    return row


def write_png(path, picture):
    width, height, rows = picture
    os.makedirs(os.path.dirname(path), exist_ok=True)

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    is_gray = all(row[0::3] == row[1::3] == row[2::3] for row in rows)
    raw = b"".join(b"\0" + bytes(row[0::3] if is_gray else row) for row in rows)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0 if is_gray else 2, 0, 0, 0))
                   + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))
    print(os.path.relpath(path, ROOT))


def beside(pictures, gap=GAP):
    height = max(picture[1] for picture in pictures)
    rows = []
    for y in range(height):
        parts = [bytes(p[2][y]) if y < p[1] else b"\xff" * (3 * p[0]) for p in pictures]
        rows.append(bytearray((b"\xff" * (3 * gap)).join(parts)))
    return sum(p[0] for p in pictures) + gap * (len(pictures) - 1), height, rows


def below(pictures, gap=GAP):
    width = max(picture[0] for picture in pictures)
    rows = []
    for number, (own_width, _, own_rows) in enumerate(pictures):
        if number:
            rows += [bytearray(b"\xff" * (3 * width)) for _ in range(gap)]
        rows += [bytearray(row + b"\xff" * (3 * (width - own_width))) for row in own_rows]
    return width, len(rows), rows


def part(picture, left, top, width, height):
    return width, height, [row[3 * left:3 * (left + width)] for row in picture[2][top:top + height]]


def enlarged(picture, times):
    rows = []
    for row in picture[2]:
        wide = bytearray()
        for i in range(0, len(row), 3):
            wide += row[i:i + 3] * times
        rows += [wide] * times
    return picture[0] * times, picture[1] * times, rows


def framed(picture):
    black = bytearray(b"\0\0\0")
    line = black * (picture[0] + 2)
    return picture[0] + 2, picture[1] + 2, [line] + [black + row + black for row in picture[2]] + [line]


# ---- Running the program ----------------------------------------------------------------------------------------------

class Studio:
    """A project of its own, with the content's models and maps, and levels as figures want them."""

    def __init__(self, program):
        self.program = program
        self.folder = tempfile.mkdtemp(prefix="hatchway_figures_")
        open(os.path.join(self.folder, "hatchway.project"), "w").close()
        for name in ("maps", "models"):
            shutil.copytree(os.path.join(ROOT, "content", name), os.path.join(self.folder, name))
        os.mkdir(os.path.join(self.folder, "levels"))
        self.count = 0

    def run(self, *arguments):
        result = subprocess.run([self.program, *arguments], capture_output=True, text=True, check=False)
        if result.returncode != 0:
            sys.exit(f"{' '.join(arguments)}\n{result.stderr}")
        return result.stdout

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def render(self, level, *arguments, size="640x400"):
        """Draws a level, given as the content of its file."""
        self.count += 1
        file = self.path("levels", f"{self.count}.level.json")
        with open(file, "w", encoding="utf-8") as out:
            json.dump(level, out)
        if level["scene"] == "../models/hall.glb":
            shutil.copy(os.path.join(ROOT, "content", "levels", "hall.level.json.lightmap"), file + ".lightmap")
        picture = self.path(f"{self.count}.png")
        # One picture is not worth compiling what is seen from where.
        self.run("render", file, *arguments, "--no-pvs", "--no-cache", "--size", size, "--out", picture)
        return read_png(picture)

    def map(self, kind, *arguments):
        self.count += 1
        folder = self.path("maps", f"map_{self.count}")
        self.run("map", kind, *arguments, "--out", folder)
        return folder

    def close(self):
        shutil.rmtree(self.folder)


def level_of(name):
    """A level of the content, as its file says."""
    with open(os.path.join(ROOT, "content", "levels", f"{name}.level.json"), encoding="utf-8") as file:
        level = json.loads(re.sub(r"^\s*//.*$", "", file.read(), flags=re.M))
    level.pop("$schema", None)
    return level


def hall_level():
    return level_of("hall")


def hall_in(style, **params):
    """The hall all in one style, with the maps of its materials."""
    level = hall_level()
    level["styles"] = {"only": {"plugin": style, **params}}
    level["assign"] = [{"nodes": "*", "style": "only"}] + [rule for rule in level["assign"] if "materials" in rule]
    return level


def plugin_of(styles, name):
    """Of a style of a level, also where it is like another."""
    while "plugin" not in styles[name]:
        name = styles[name]["like"]
    return styles[name]["plugin"]


def hall_in_ink(**params):
    """The hall as its level draws it in ink, what was found as well; `params` change all of its ink."""
    level = hall_level()
    styles = level["styles"]
    level["styles"] = {name: {**style, **params} for name, style in styles.items() if plugin_of(styles, name) == "pen_and_ink"}
    level["assign"] = [rule for rule in level["assign"] if rule.get("style", "assumed") in level["styles"]]
    return level


def ground_level(studio, side_m=400.0, **params):
    """Level ground with texture coordinates in metres, in pen and ink."""
    h = side_m / 2
    floats = struct.pack("<12f", -h, 0, h, h, 0, h, h, 0, -h, -h, 0, -h)
    floats += struct.pack("<12f", *([0, 1, 0] * 4)) + struct.pack("<8f", -h, h, h, h, h, -h, -h, -h)
    data = floats + struct.pack("<6H", 0, 1, 2, 0, 2, 3)
    model = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, "name": "ground"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "indices": 3}]}],
        "buffers": [{"byteLength": len(data)}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 48},
                        {"buffer": 0, "byteOffset": 96, "byteLength": 32}, {"buffer": 0, "byteOffset": 128, "byteLength": 12}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-h, 0, -h], "max": [h, 0, h]},
                      {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC3"},
                      {"bufferView": 2, "componentType": 5126, "count": 4, "type": "VEC2"},
                      {"bufferView": 3, "componentType": 5123, "count": 6, "type": "SCALAR"}]}
    text = json.dumps(model).encode()
    text += b" " * (-len(text) % 4)
    with open(studio.path("models", "ground.glb"), "wb") as file:
        file.write(struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(data)) + struct.pack("<II", len(text), 0x4E4F534A)
                   + text + struct.pack("<II", len(data), 0x004E4942) + data)
    return {"format": "hatchway-level/1", "scene": "../models/ground.glb",
            "styles": {"ink": {"plugin": "pen_and_ink", "line_width_px": 0, "silhouette_width_px": 0, "border_width_px": 0, **params}},
            "assign": [{"nodes": "*", "style": "ink"}],
            "lights": [{"type": "sun", "direction": [0, -1, 0], "illuminance_lux": 50000}]}


# ---- The plane of figures 4 to 8, 11 and 12 ---------------------------------------------------------------------------

PLANE_SIZE, PLANE_FOV, PLANE_EYE_M, PLANE_PITCH = (640, 320), 40.0, 1.0, 19.0
PLANE_CAMERA = ("--eye", f"0,{PLANE_EYE_M},0", "--target",
                f"0,{PLANE_EYE_M - math.sin(math.radians(PLANE_PITCH))},{-math.cos(math.radians(PLANE_PITCH))}",
                "--fov-deg", str(PLANE_FOV))
INK = 61 / 255  # of hatch_colour, sRGB


def map_levels(folder):
    levels = []
    while os.path.exists(os.path.join(folder, f"level_{len(levels)}.png")):
        width, height, rows = read_png(os.path.join(folder, f"level_{len(levels)}.png"))
        levels.append((width, height, [[value / 255 for value in row[0::3]] for row in rows]))
    return levels


def box_filtered(levels):
    result = [levels[0]]
    while result[-1][0] > 1:
        width, height, rows = result[-1]
        above = rows if height > 1 else [rows[0], rows[0]]
        result.append((width // 2, max(height // 2, 1),
                       [[(above[2 * y][2 * x] + above[2 * y][2 * x + 1] + above[2 * y + 1][2 * x] + above[2 * y + 1][2 * x + 1]) / 4
                         for x in range(width // 2)] for y in range(max(height // 2, 1))]))
    return result


def texel(level, u, v):
    width, height, rows = level
    return rows[math.floor(v * height) % height][math.floor(u * width) % width]


def smooth_texel(level, u, v):
    width, height, _ = level
    x, y = u * width - 0.5, v * height - 0.5
    fx, fy = x - math.floor(x), y - math.floor(y)

    def at(dx, dy):
        return level[2][(math.floor(y) + dy) % height][(math.floor(x) + dx) % width]
    upper = at(0, 0) * (1 - fx) + at(1, 0) * fx
    return upper if height == 1 else upper * (1 - fy) + (at(0, 1) * (1 - fx) + at(1, 1) * fx) * fy


def plane(levels, map_m, choose):
    """The ground in perspective. `choose(level, u, v)` gives the paper at a level that is a real number."""
    width, height = PLANE_SIZE
    focal = height / 2 / math.tan(math.radians(PLANE_FOV / 2))
    sin, cos = math.sin(math.radians(PLANE_PITCH)), math.cos(math.radians(PLANE_PITCH))
    rows = []
    for j in range(height):
        row = bytearray()
        y = (height / 2 - j - 0.5) / focal
        down = sin - y * cos
        for i in range(width):
            paper = 1.0
            if down > 0.01:
                x = (i + 0.5 - width / 2) / focal
                far = PLANE_EYE_M / down
                forward = cos + y * sin
                u, v = x * far / map_m, -forward * far / map_m
                along_x = far / focal / map_m
                along_y = far * far / focal / PLANE_EYE_M / map_m
                step = along_x if levels[0][1] == 1 else max(along_x, along_y / 2)
                if levels[0][1] == 1:
                    step = math.hypot(along_x, abs(u) * along_y / max(forward * far / map_m, 1e-9))
                paper = choose(math.log2(max(step * levels[0][0], 1e-9)), u, v)
            linear = paper + (1 - paper) * INK ** 2.2
            row += bytes((round(255 * linear ** (1 / 2.2)),)) * 3
        rows.append(row)
    return width, height, rows


def unfiltered(levels):
    return lambda level, u, v: texel(levels[0], u, v)


def nearest_level(levels):
    return lambda level, u, v: smooth_texel(levels[min(max(round(level), 0), len(levels) - 1)], u, v)


def between_levels(levels):
    def choose(level, u, v):
        level = min(max(level, 0), len(levels) - 1)
        finer = min(int(level), len(levels) - 2)
        return smooth_texel(levels[finer], u, v) * (1 - level + finer) + smooth_texel(levels[finer + 1], u, v) * (level - finer)
    return choose


HATCH_M = 7.4  # width of the hatch map on the plane: a texel is a pixel at the lower edge


def hatch_levels():
    return map_levels(os.path.join(ROOT, "content", "maps", "hatch", "fine"))


def figure_4(studio):
    return framed(plane(hatch_levels(), HATCH_M, unfiltered(hatch_levels())))


def figure_5(studio):
    levels = box_filtered(hatch_levels())
    return framed(plane(levels, HATCH_M, between_levels(levels)))


def figure_7(studio):
    return framed(plane(hatch_levels(), HATCH_M, nearest_level(hatch_levels())))


def figure_8(studio):
    level = ground_level(studio, tone="plain", hatch="../maps/hatch/fine", hatch_deg=90, spacing_px=8)
    return framed(studio.render(level, *PLANE_CAMERA, size="640x320"))


# ---- Ink maps ---------------------------------------------------------------------------------------------------------

INK_M = 1.8


def drawing():
    return os.path.join(ROOT, "content", "maps", "ink", "stone_courses", "level_0.png")


def level_strip(folder):
    pictures = []
    for number in range(4):
        width, height, rows = read_png(os.path.join(folder, f"level_{number}.png"))
        pictures.append(framed(part(enlarged((width, height, rows), 1 << number), 0, 0, 256, 256)))
    return beside(pictures)


def figure_9(studio):
    """Above minimum filtering, below the same drawing inked anew; levels 0 to 3, enlarged to one size."""
    filtered = studio.map("ink", drawing(), "--filter", "minimum")
    inked = studio.map("ink", drawing())
    return below([level_strip(filtered), level_strip(inked)], 2 * GAP)


def figure_9_plane(studio):
    """The two maps on a plane: left minimum filtering, right inked anew."""
    pictures = []
    for arguments in (("--filter", "minimum"), ()):
        folder = studio.map("ink", drawing(), "--size-m", "1", *arguments)
        level = ground_level(studio, tone="none", ink="../maps/" + os.path.basename(folder), ink_map_detail=0.5)
        pictures.append(framed(part(studio.render(level, *PLANE_CAMERA, size="640x320"), 0, 0, 440, 320)))
    return beside(pictures)


def figure_11(studio):
    levels = map_levels(os.path.join(ROOT, "content", "maps", "ink", "stone_courses"))
    return framed(plane(levels, INK_M, nearest_level(levels)))


def figure_12(studio):
    level = ground_level(studio, tone="none", ink="../maps/ink/stone_courses", ink_map_detail=0.5)
    return framed(studio.render(level, *PLANE_CAMERA, size="640x320"))


# ---- The hall ---------------------------------------------------------------------------------------------------------

def figure_13(studio):
    """To the right a column that fades from find to conjecture as it rises."""
    camera = ("--eye", "-0.6,1.7,6.4", "--target", "1.6,2.5,0", "--fov-deg", "62")
    return framed(studio.render(hall_level(), *camera, size="800x520"))


def figure_14(studio):
    camera = ("--camera", "statue")
    plain = studio.render(hall_in_ink(tone="plain", spacing_px=6), *camera, size="420x560")
    shaded = studio.render(hall_in_ink(), *camera, size="420x560")
    return beside([framed(plain), framed(shaded)])


def figure_15(studio):
    """Left ordinary levels, right ink maps, of the roofs and walls of one view, which is cut through a roof."""
    camera = ("--eye", "14,6.5,11", "--target", "13,4.5,-8", "--fov-deg", "55")
    right = studio.render(hall_in_ink(tone="none"), *camera, size="800x520")
    for name in os.listdir(studio.path("maps", "ink")):
        folder = studio.path("maps", "ink", name)
        for number, (width, height, rows) in enumerate(box_filtered(map_levels(folder))):
            gray = [bytearray(value for texel_value in row for value in (round(255 * texel_value),) * 3) for row in rows]
            if os.path.exists(os.path.join(folder, f"level_{number}.png")):
                write_png_quietly(os.path.join(folder, f"level_{number}.png"), (width, height, gray))
    left = studio.render(hall_in_ink(tone="none"), *camera, size="800x520")
    return framed(beside([part(left, 0, 0, 400, 520), part(right, 400, 0, 400, 520)], 0))


def write_png_quietly(path, picture):
    out = sys.stdout
    with open(os.devnull, "w", encoding="ascii") as sys.stdout:
        write_png(path, picture)
    sys.stdout = out


# ---- Models that are not ours -----------------------------------------------------------------------------------------

def model_level(studio, model, style, light, exposure_ev):
    name = os.path.basename(model)
    shutil.copy(model, studio.path("models", name))
    return {"format": "hatchway-level/1", "scene": f"../models/{name}", "styles": {"ink": {"plugin": "pen_and_ink", **style}},
            "assign": [{"nodes": "*", "style": "ink"}], "exposure_ev": exposure_ev,
            "lights": [{"type": "sun", "direction": light, "illuminance_lux": 50000}]}


def on_ground(studio, model, side_m=60.0):
    """A copy of a model with level ground at height 0, a node "Ground" of its own: what shadows fall on."""
    with open(model, "rb") as file:
        data = file.read()
    length = struct.unpack("<I", data[12:16])[0]
    scene, binary = json.loads(data[20:20 + length]), data[28 + length:]
    binary += b"\0" * (-len(binary) % 4)
    h, start = side_m / 2, len(binary)
    binary += struct.pack("<12f", -h, 0, h, h, 0, h, h, 0, -h, -h, 0, -h) + struct.pack("<12f", *([0, 1, 0] * 4))
    binary += struct.pack("<6H", 0, 1, 2, 0, 2, 3)
    views, accessors = scene["bufferViews"], scene["accessors"]
    for offset, size, component, kind, count in ((0, 48, 5126, "VEC3", 4), (48, 48, 5126, "VEC3", 4), (96, 12, 5123, "SCALAR", 6)):
        views.append({"buffer": 0, "byteOffset": start + offset, "byteLength": size})
        accessors.append({"bufferView": len(views) - 1, "componentType": component, "type": kind, "count": count})
    first = len(accessors) - 3
    accessors[first].update({"min": [-h, 0, -h], "max": [h, 0, h]})
    scene["meshes"].append({"primitives": [{"attributes": {"POSITION": first, "NORMAL": first + 1}, "indices": first + 2}]})
    scene["nodes"].append({"name": "Ground", "mesh": len(scene["meshes"]) - 1})
    scene["scenes"][0]["nodes"].append(len(scene["nodes"]) - 1)
    scene["buffers"][0]["byteLength"] = len(binary)
    text = json.dumps(scene).encode()
    text += b" " * (-len(text) % 4)
    file_name = studio.path("on_ground.glb")
    with open(file_name, "wb") as file:
        file.write(struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(binary)) + struct.pack("<II", len(text), 0x4E4F534A)
                   + text + struct.pack("<II", len(binary), 0x004E4942) + binary)
    return file_name


def teapot(studio, model):
    tone = {"white_from": 0.84, "shadow_below": 0.3, "darkness": 0.74}
    form = {"hatch_direction": "principal", "hatch_deg": 0, "cross_deg": 62, "crease_deg": 60, "silhouette_width_px": 2.2}
    level = model_level(studio, on_ground(studio, model), {**tone, **form}, [-0.75, -0.62, -0.25], 14.3)
    level["styles"]["ground"] = {"plugin": "pen_and_ink", **tone, "border_width_px": 0, "silhouette_width_px": 0,
                                 "intersection_width_px": 0, "hatch_deg": 12, "cross_deg": 40}
    level["assign"].append({"nodes": "Ground", "style": "ground"})
    camera = ("--eye", "6.6,5.1,9.6", "--target", "-0.15,1.35,0", "--fov-deg", "22.5")
    return studio.render(level, *camera, size="1000x640")


def dungeon(studio, model):
    level = model_level(studio, model, {"white_from": 0.78, "shadow_below": 0.28, "darkness": 0.7, "cross_deg": 80}, [-0.45, -0.8, 0.42], 14.2)
    return framed(studio.render(level, "--eye", "20.5,3.4,9.5", "--target", "14,0.2,1", "--fov-deg", "58", size="1000x640"))


# ---- Edge-Enhancement, 2003, and ID-Based Rendering of Silhouettes, 2011 -----------------------------------------------

def one_locomotive(style, **params):
    """The locomotive of styles.level.json alone, in one style; its camera looks at one of eight, so it is drawn larger."""
    level = level_of("styles")
    level["styles"] = {"only": {"plugin": style, **params}}
    level["assign"] = [{"nodes": "*", "style": "only"}, {"nodes": "Locomotive_[2-8]", "visible": False}]
    return level


LOCOMOTIVE = ("--eye", "0.9,1.25,2.6", "--target", "-0.83,0.39,0.52", "--fov-deg", "9.5")


def image_of(studio, level, key, *camera, size):
    return studio.render(level, *camera, "--show-image", key, size=size)


def channel(picture, number):
    return picture[0], picture[1], [bytearray(value for i in range(number, len(row), 3) for value in (row[i],) * 3) for row in picture[2]]


def darkest(picture):
    """Both kinds of edges in one gray."""
    return picture[0], picture[1], [bytearray(value for i in range(0, len(row), 3) for value in (min(row[i], row[i + 1]),) * 3) for row in picture[2]]


def figure_2003_1(studio):
    """Profiles wide and dark, creases thin and red."""
    lines = {"profile_width_px": 2.6, "inner_width_px": 1.2, "inner_colour": "#c03028", "warm_colour": "#f4f1ea", "cool_colour": "#d5d9e2",
             "highlight": 0, "cool_from_material": 0, "warm_from_material": 0}
    return framed(studio.render(one_locomotive("technical", **lines), *LOCOMOTIVE, size="800x520"))


def figure_2003_4(studio):
    """Left what each of the three passes of C1 adds to, from above; right the edge map."""
    level, key = one_locomotive("technical", lines_from="none"), "edge_map operator=c1_three_passes format=rgba8 normal=geometric"

    def after(passes):
        return channel(image_of(studio, level, f"{key} passes={passes}", *LOCOMOTIVE, size="300x194"), 1)
    large = darkest(image_of(studio, level, key, *LOCOMOTIVE, size="932x598"))
    return beside([below([framed(after(1)), framed(after(2)), framed(after(3))]), framed(large)])


def figure_2003_5(studio):
    """Edges of depth, above by C1, below by the diagonal operator, each with a detail."""
    level, rows = one_locomotive("technical", lines_from="none"), []
    for operator in ("c1", "diagonal"):
        whole = channel(image_of(studio, level, f"edge_map operator={operator} format=rgba8 normal=geometric", *LOCOMOTIVE, size="640x400"), 1)
        rows.append(beside([framed(whole), framed(enlarged(part(whole, 330, 90, 100, 100), 4))]))
    return below(rows)


STATUE = ("--camera", "statue")


def figure_2003_6(studio):
    """Left edges by normals and by depth, right the statue, plainly shaded, with both."""
    level, key = hall_in("technical", lines_from="none"), "edge_map operator=diagonal format=rgba8 normal=geometric"
    small = image_of(studio, level, key, *STATUE, size="250x336")
    plain = hall_in("technical", warm_colour="#ffffff", cool_colour="#8d8d92", warm_from_material=0, cool_from_material=0, highlight=0,
                    inner_colour="#120f0f", inner_width_px=1)
    return beside([below([framed(channel(small, 0)), framed(channel(small, 1))]), framed(studio.render(plain, *STATUE, size="506x682"))])


def figure_2003_7(studio):
    """The lathe: white creases and black profiles; then other colours."""
    pictures = []
    for params in ({}, {"inner_colour": "#f7d774", "profile_colour": "#7a1f1f"}):
        level = level_of("workshop")
        level["styles"]["machine"].update(params)
        level["assign"] += [{"nodes": "Room", "visible": False}, {"nodes": "Gears", "visible": False}]
        camera = ("--eye", "-0.75,1.55,0.35", "--target", "0.3,0.78,-1.75", "--fov-deg", "46")
        pictures.append(framed(studio.render(level, *camera, size="600x440")))
    return beside(pictures)


def figure_2003_8(studio):
    """Halftoned strokes and the edge map on a statue. The paper's mirror is missing."""
    strokes = hall_in("halftone", screen="strokes", lines_from="edge_map", ink_colour="#2a2828", white_from=0.9)
    return framed(studio.render(strokes, *STATUE, size="560x740"))


def figure_2003_9(studio):
    """Left steps between bands as they are, right smoothed by the neighbours; below a detail of each."""
    columns = []
    for smoothing in ("none", "map"):
        level = level_of("cartoon")
        for style in level["styles"].values():
            if "plugin" in style:
                style["smoothing"] = smoothing
        whole = studio.render(level, "--eye", "-1.1,1.5,4.2", "--target", "0,0.98,0", "--fov-deg", "33", "--samples", "1", size="480x560")
        columns.append(below([framed(whole), framed(enlarged(part(whole, 210, 340, 120, 75), 4))]))
    return beside(columns)


def outlines(studio, model, *camera, size="900x580"):
    name = os.path.basename(model)
    shutil.copy(model, studio.path("models", name))
    level = {"format": "hatchway-level/1", "scene": f"../models/{name}", "styles": {"ids": {"plugin": "id_outline"}},
             "assign": [{"nodes": "*", "style": "ids"}]}
    return framed(studio.render(level, *camera, size=size))


def figure_2011_7(studio):
    """The paper's kitchen is not to be had: the machine shop."""
    level = level_of("workshop")
    level["styles"] = {"ids": {"plugin": "id_outline", "profile_width_px": 1.6}}
    level["assign"] = [{"nodes": "*", "style": "ids"}]
    return framed(studio.render(level, "--camera", "entrance", size="900x580"))


# ---- Contact sheets ---------------------------------------------------------------------------------------------------

SHEET_SIZE = "296x200"
SHEET_CAMERA = ("--eye", "12.6,1.6,-1.4", "--target", "15.7,1.45,-3.7", "--fov-deg", "52")
SHEET_LIGHT = {"white_from": 0.8, "shadow_below": 0.3}  # more shade than by default, to show what shades
INK_CONTROLS = {
    "colours": [{}, {"paper_colour": "#f3ead2", "uncertain_colour": "#f3ead2", "ink_colour": "#4a2c12", "crease_colour": "#4a2c12", "hatch_colour": "#6b4a2a"},
                {"paper_colour": "#1d3350", "uncertain_colour": "#1d3350", "ink_colour": "#f2f2ea", "crease_colour": "#f2f2ea", "hatch_colour": "#c9d2da"}],
    "from_material": [{}, {"paper_from_material": 0.8}, {"ink_from_material": 1}],
    "certainty": [{}, {"uncertain_colour": "#cfe0f2"}, {"uncertain_colour": "#f4c9a8"}],
    "tone_range": [{"white_from": 0.6, "shadow_below": 0.1}, {}, {"white_from": 1, "shadow_below": 0.4, "darkness": 0.8}],
    "light_response": [{"light_response": 0}, {"light_response": 0.5}, {}],
    "fade": [{}, {"fade": "height", "fade_from_m": 0.3, "fade_to_m": 2.2},
             {"fade": "height", "fade_from_m": 2.2, "fade_to_m": 0.3}],
    "hatch_direction": [{"hatch_deg": 0, "cross_deg": 90}, {}, {"hatch_direction": "principal", "hatch_deg": 0}],
    "tone": [{"tone": "plain"}, {}, {"tone": "halftone"}],
    "strokes": [{"spacing_px": 3, "stroke_width_px": 0.5}, {}, {"spacing_px": 9, "stroke_width_px": 1.6, "stroke_length_px": 0}],
    "lines": [{"line_width_px": 0, "valley_width_px": 0}, {}, {"line_width_px": 2.4, "silhouette_width_px": 4}],
    "line_character": [{"line_wobble_px": 2}, {"line_overshoot_px": 12, "line_taper_px": 20}, {"line_dash_px": 16}],
    "ink_map": [{"ink_map_strength": 0}, {"ink_map_detail": 0}, {"ink_map_detail": 2}],
}
HYBRID_CONTROLS = {
    "gradient": [{"gradient": "none", "ink_weight": 0.5}, {"gradient": "height", "from_m": 0.5, "to_m": 3}, {}],
    "tint": [{}, {"tint": "#cfe0f2"}, {"tint": "#f4c9a8"}],
    "colours": [{}, {"ink_colour": "#4a2c12", "hatch_colour": "#6b4a2a", "tint": "#f3ead2", "uncertain_colour": "#f3ead2"}, {"paper_from_material": 0.8}],
    "certainty": [{}, {"uncertain_colour": "#cfe0f2"}, {"uncertain_colour": "#f4c9a8"}],
    "tone_range": [{"white_from": 0.6, "shadow_below": 0.1}, {}, {"white_from": 1, "shadow_below": 0.4, "darkness": 0.8}],
    "light_response": [{"light_response": 0}, {"light_response": 0.5}, {}],
    "hatch_direction": [{"hatch_deg": 0}, {}, {"hatch_direction": "principal", "hatch_deg": 0}],
    "strokes": [{"spacing_px": 3, "stroke_width_px": 0.5}, {}, {"spacing_px": 9, "stroke_width_px": 1.6, "stroke_length_px": 0}],
    "ink_map": [{"ink_map_strength": 0}, {"ink_map_detail": 0}, {"ink_map_detail": 2}],
}


def contact_sheets(studio):
    for style, controls in (("pen_and_ink", INK_CONTROLS), ("hybrid", HYBRID_CONTROLS)):
        for name, choices in controls.items():
            pictures = []
            for params in choices:
                level = hall_in(style, **{**SHEET_LIGHT, **params})
                level["assign"].append({"nodes": "*", "certainty": 0.3})
                level["assign"].append({"nodes": "Courtyard/Well", "certainty": 1.0})
                pictures.append(studio.render(level, *SHEET_CAMERA, size=SHEET_SIZE))
            write_png(os.path.join(ROOT, "npr_plugins", style, "controls", f"{name}.png"), beside(pictures, 4))


OURS = {"4": figure_4, "5": figure_5, "7": figure_7, "8": figure_8, "9": figure_9, "9_plane": figure_9_plane, "11": figure_11,
        "12": figure_12, "13": figure_13, "14": figure_14, "15": figure_15, "2003_1": figure_2003_1, "2003_4": figure_2003_4,
        "2003_5": figure_2003_5, "2003_6": figure_2003_6, "2003_7": figure_2003_7, "2003_8": figure_2003_8, "2003_9": figure_2003_9,
        "2011_7": figure_2011_7}


def readme_pictures(studio):
    """The hall in each style and as its level says, its courtyard, and with and without its baked light."""
    entrance = ("--camera", "entrance")
    pictures = os.path.join(ROOT, "docs", "pictures")
    fading = hall_in("hybrid", gradient="height", from_m=0.5, to_m=4, white_from=0.64, shadow_below=0.14, darkness=0.74)
    for name, level in (("pen_and_ink", hall_in_ink()), ("hybrid", fading), ("photoreal", hall_in("photoreal"))):
        write_png(os.path.join(pictures, f"{name}.png"), studio.render(level, *entrance, size="960x600"))
    write_png(os.path.join(pictures, "hall.png"), studio.render(hall_level(), *entrance, size="1280x720"))
    write_png(os.path.join(pictures, "courtyard.png"), studio.render(hall_in_ink(), "--camera", "courtyard", size="1000x640"))
    for camera in ("entrance", "columns"):
        for name, more in (("with", ()), ("without", ("--no-baked-light",))):
            picture = studio.render(hall_in("photoreal"), "--camera", camera, *more, size="960x540")
            write_png(os.path.join(pictures, f"{'hall' if camera == 'entrance' else camera}_{name}_baked_light.png"), picture)
    pages = os.path.join(ROOT, "npr_plugins")
    for style, name, picture in (("pen_and_ink", "hall", "pen_and_ink"), ("pen_and_ink", "courtyard", "courtyard"),
                                 ("hybrid", "hybrid", "hybrid")):
        shutil.copy(os.path.join(pictures, f"{picture}.png"), os.path.join(pages, style, f"{name}.png"))
    by_hand = hall_in_ink(line_wobble_px=0.9, line_bend_px=60, line_overshoot_px=6, line_taper_px=10)
    write_png(os.path.join(pages, "pen_and_ink", "by_hand.png"), studio.render(by_hand, "--camera", "columns", size="960x600"))
    outside = studio.render(hall_in("photoreal"), "--camera", "courtyard", size="960x600")
    write_png(os.path.join(pages, "photoreal", "photoreal.png"), outside)
    write_png(os.path.join(pictures, "eight_styles.png"), eight_styles(studio))
    mirrors = os.path.join(ROOT, "content", "levels", "mirrors.level.json")
    write_png(os.path.join(pictures, "mirrors.png"), studio.render(mirrors, "--camera", "west", size="1200x750"))
    pages_of_lines(studio)


def eight_styles(studio):
    return studio.render(level_of("styles"), "--camera", "plate", size="1600x660")


def pages_of_lines(studio):
    """Places in the styles whose lines come from images."""
    for style, level, camera in (("technical", level_of("workshop"), "entrance"), ("cartoon", level_of("cartoon"), "snowman"),
                                 ("halftone", hall_in("halftone"), "entrance"), ("id_outline", hall_in("id_outline"), "entrance")):
        picture = studio.render(level, "--camera", camera, size="960x600")
        write_png(os.path.join(ROOT, "npr_plugins", style, f"{style}.png"), picture)


MODELS = {"teapot": teapot, "dungeon": dungeon, "2011_3": outlines, "2011_4": outlines, "2011_5": outlines,
          "2011_6": lambda studio, model: outlines(studio, model, "--eye", "26,17,30", "--target", "8,-4,8", "--fov-deg", "30")}


def figure_file(name):
    """Of the papers of 2003 and 2011, which are about edges in images, in a folder of their own."""
    folder = "edge_images" if name.startswith("20") else ""
    return os.path.join(FIGURES, folder, f"figure_{name}.png")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="+", choices=[*OURS, *MODELS, "controls", "readme", "all"])
    parser.add_argument("--hatchway", default=os.path.join(ROOT, "build", "release", "bin", "hatchway"))
    parser.add_argument("--model")
    arguments = parser.parse_args()
    names = [*OURS, "controls", "readme"] if "all" in arguments.names else arguments.names
    for name in names:
        studio = Studio(arguments.hatchway)
        try:
            if name == "controls":
                contact_sheets(studio)
            elif name == "readme":
                readme_pictures(studio)
            elif name in MODELS:
                if not arguments.model:
                    parser.error(f"{name} needs --model FILE.glb")
                file = figure_file(name) if name[0].isdigit() else os.path.join(ROOT, "docs", "pictures", f"{name}.png")
                write_png(file, MODELS[name](studio, arguments.model))
            else:
                write_png(figure_file(name), OURS[name](studio))
        finally:
            studio.close()


if __name__ == "__main__":
    main()
