"""How much of what a view holds a PVS lets through: the one that q3map2 stored in a game's map (IBSP 46), and ours of the same map as a model.

    python3 editor_tools/measure/visibility/game_map_share.py build/release/bin/hatchway oa_dm1.bsp oa_oa_dm1.glb docs/report/results/game_map.json

Views: eyes over the map's own starts and items, spread evenly, four directions each. Theirs: triangles of faces in leaves whose box meets the
view and whose cluster is in the row of the eye's, over those of all leaves whose box meets the view, as that engine draws. Ours:
`faces_drawn` of `render --json` with the PVS over the same without. Both count a triangle once, however many passes draw it. The two cut the map into other parts, so only the shares compare. Not judged: what
either hides. The map may be compressed (.xz); it has to be built from the same sources as the model, 1 unit = 1/32 m.
"""
import argparse
import json
import lzma
import math
import re
import struct
import subprocess
import tempfile
from datetime import date
from pathlib import Path

METRES = 1 / 32            # a unit of the game
EYE_HEIGHT = 26            # units
DIRECTIONS = (0.3, 1.87, 3.44, 5.01)
FOV_DEG, ASPECT = 60, 1.6  # vertical
NOT_DRAWN = 0x80 | 0x4 | 0x200  # flags of surfaces: no picture, sky, hint
POLYGON, PATCH, MESH = 1, 2, 3  # kinds of faces
PATCH_TRIANGLES = 32       # of each 3 x 3 piece of a patch, as the game draws it in full detail


class GameMap:
    """What of a map the measure needs."""

    def __init__(self, data):
        if data[:4] != b"IBSP":
            raise SystemExit("no IBSP file")
        lumps = [struct.unpack_from("<2i", data, 8 + 8 * i) for i in range(17)]
        lump = [data[at:at + size] for at, size in lumps]
        self.planes = list(struct.iter_unpack("<4f", lump[2]))
        self.nodes = list(struct.iter_unpack("<9i", lump[3]))
        self.leaves = list(struct.iter_unpack("<12i", lump[4]))
        self.faces_of_leaves = [face for face, in struct.iter_unpack("<i", lump[5])]
        flags = [flags for _, flags, _ in struct.iter_unpack("<64s2i", lump[1])]
        world = struct.unpack_from("<6f4i", lump[7])
        self.world_faces = range(world[6], world[6] + world[7])
        self.triangles = [0 if flags[face[0]] & NOT_DRAWN else _triangles_of(face) for face in struct.iter_unpack("<12i12f2i", lump[13])]
        self.row_bytes = struct.unpack_from("<2i", lump[16])[1]
        self.rows = lump[16][8:]
        blocks = re.findall(r"\{([^}]*)\}", lump[0].decode("latin-1"))
        self.entities = [dict(re.findall(r'"([^"]*)"\s+"([^"]*)"', block)) for block in blocks]

    def cluster_at(self, place):
        """-1 in solids."""
        child = 0
        while child >= 0:
            plane, front, back = self.nodes[child][:3]
            a, b, c, d = self.planes[plane]
            child = front if a * place[0] + b * place[1] + c * place[2] >= d else back
        return self.leaves[-1 - child][0]

    def is_seen(self, from_cluster, cluster):
        return self.rows[from_cluster * self.row_bytes + (cluster >> 3)] >> (cluster & 7) & 1

    def faces_of(self, leaf):
        faces = self.faces_of_leaves[leaf[8]:leaf[8] + leaf[9]]
        return [face for face in faces if face in self.world_faces]

    def eyes(self, wanted):
        kinds = re.compile("info_player_deathmatch|item_|weapon_|ammo_")
        places = [tuple(map(float, e["origin"].split())) for e in self.entities if "origin" in e and kinds.match(e.get("classname", ""))]
        eyes = [(x, y, z + EYE_HEIGHT) for x, y, z in places]
        eyes = [eye for eye in eyes if self.cluster_at(eye) >= 0]
        return eyes[::max(1, len(eyes) // wanted)][:wanted]


def _triangles_of(face):
    kind, corners, (width, height) = face[2], face[6], face[24:26]
    if kind == PATCH:
        return (width - 1) // 2 * ((height - 1) // 2) * PATCH_TRIANGLES
    return corners // 3 if kind in (POLYGON, MESH) else 0


def view_planes(eye, ahead):
    """Of a level view: (normal, least distance), inwards."""
    right, up = (ahead[1], -ahead[0], 0.0), (0.0, 0.0, 1.0)
    high = math.tan(math.radians(FOV_DEG / 2))
    sides = [(right, 1, high * ASPECT), (right, -1, high * ASPECT), (up, 1, high), (up, -1, high)]
    normals = [ahead] + [tuple(reach * a + sign * s for a, s in zip(ahead, side)) for side, sign, reach in sides]
    return [(normal, sum(n * e for n, e in zip(normal, eye))) for normal in normals]


def meets(planes, low, high):
    return all(sum(n * (h if n > 0 else l) for n, l, h in zip(normal, low, high)) >= least for normal, least in planes)


def their_triangles(game_map, views):
    """(let through, in view), summed over the views."""
    through = in_view = 0
    for eye, ahead in views:
        planes, cluster = view_planes(eye, ahead), game_map.cluster_at(eye)
        seen, met = set(), set()
        for leaf in game_map.leaves:
            if leaf[0] < 0 or not meets(planes, leaf[2:5], leaf[5:8]):
                continue
            met.update(game_map.faces_of(leaf))
            if game_map.is_seen(cluster, leaf[0]):
                seen.update(game_map.faces_of(leaf))
        through += sum(game_map.triangles[face] for face in seen)
        in_view += sum(game_map.triangles[face] for face in met)
    return through, in_view


def our_triangles(program, model, views):
    def in_metres(p):
        return [p[0] * METRES, p[2] * METRES, -p[1] * METRES]

    def key(second, eye, ahead):
        return {"t_s": second, "position": in_metres(eye), "look_at": in_metres([e + 32 * a for e, a in zip(eye, ahead)])}

    def run(*words):
        subprocess.run([program, *words], check=True, stdout=subprocess.DEVNULL)

    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        (folder / model.name).write_bytes(model.read_bytes())
        keys = [key(second, *view) for second, view in enumerate([views[0], *views])]  # what is drawn once comes first
        level = folder / "views.level.json"
        level.write_text(json.dumps({"format": "hatchway-level/1", "scene": model.name, "paths": {"views": {"fps": 1, "keys": keys}}}))
        (folder / "pictures").mkdir()
        run("compile", level, "--cache", folder / "cache")
        sums = []
        for pvs in (("--cache", folder / "cache"), ("--no-pvs",)):
            run("render", level, "--path", "views", "--size", "320x200", "--samples", "1", "--style", "*=photoreal", "--out", folder / "pictures",
                "--json", folder / "frames.json", *pvs)
            frames = json.loads((folder / "frames.json").read_text())["frames"][1:]
            assert len(frames) == len(views)
            sums.append(sum(frame["faces_drawn"] for frame in frames))
        return sums


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("program", "map", "model", "json"):
        arguments.add_argument(name, type=Path)
    arguments.add_argument("--eyes", type=int, default=12)
    options = arguments.parse_args()
    game_map = GameMap(lzma.open(options.map).read() if options.map.suffix == ".xz" else options.map.read_bytes())
    views = [(eye, (math.cos(angle), math.sin(angle), 0.0)) for eye in game_map.eyes(options.eyes) for angle in DIRECTIONS]
    theirs, ours = their_triangles(game_map, views), our_triangles(options.program, options.model, views)
    row = {"map": options.map.name.removesuffix(".xz"), "views": len(views), "q3map2_share": theirs[0] / theirs[1], "our_share": ours[0] / ours[1],
           "q3map2_triangles": theirs[0], "q3map2_triangles_in_view": theirs[1], "our_triangles": ours[0], "our_triangles_in_view": ours[1]}
    print(json.dumps(row))
    commit = subprocess.run(["git", "rev-parse", "--short=10", "HEAD"], cwd=Path(__file__).parent, check=True, capture_output=True, text=True)
    command = f"game_map_share.py hatchway {options.map.name} {options.model.name} {options.json.name} --eyes {options.eyes}"
    origin = {"commit": commit.stdout.strip(), "date": date.today().isoformat(), "command": command}
    options.json.write_text(json.dumps({"rows": [row], "origin": origin}, indent=2) + "\n")


if __name__ == "__main__":
    main()
