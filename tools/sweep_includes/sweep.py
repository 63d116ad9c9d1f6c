#!/usr/bin/env python3
"""Every texture item that the standard include files declare, on a sphere before a box, compared with POV-Ray.

usage: tools/sweep_includes/sweep.py [--verisim PROGRAM] [--folder WORK] [include files ...]

The names are read from the installed include files (package povray-includes) when the script runs; twelve items share a scene. Compares with --replay,
because many stones have `crand`. Prints what `verisim compare` says of each scene, how many items are in scenes that are exact, and leaves scenes that differ in WORK. Exit status 1 if one differs.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys

INCLUDES = ["stones1", "stones2", "woods", "metals", "skies", "glass", "glass_old", "golds", "textures", "finish", "stars"]
WHERE = [pathlib.Path("/usr/share/povray-3.7/include"), pathlib.Path("/usr/share/povray/include")]
# How an item of a kind is worn.
WORN = {
    "texture": "texture { %s }",
    "pigment": "pigment { %s }",
    "color_map": "pigment { wrinkles color_map { %s } scale 0.4 }",
    "color": "pigment { %s }",
    "finish": "texture { pigment { rgb <0.8, 0.5, 0.3> } finish { %s } }",
    "material": "material { %s }",
    "interior": "pigment { rgbf <0.9, 0.95, 1, 0.9> } finish { reflection 0.1 } interior { %s }",
    "sky_sphere": None,  # one for a scene
}
COLUMNS, ROWS = 4, 3
HEAD = """#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
#include "colors.inc"
%s
light_source { <-30, 40, -50> rgb 1 }
"""
CAMERA = "camera { orthographic location <0, 0, -20> direction z right 12*x up 9*y }\nplane { z, 4 pigment { checker rgb 0.3, rgb 0.6 } }\n"


def items(include):
    """(kind, name) of what a file declares, in its order, each name once (the last kind counts)."""
    path = next((folder / f"{include}.inc" for folder in WHERE if (folder / f"{include}.inc").exists()), None)
    if not path:
        sys.exit(f"{include}.inc is missing: apt-get install povray-includes")
    text = re.sub(r"//.*|/\*[\s\S]*?\*/", "", path.read_text(errors="replace"))
    found = {}
    for name, kind in re.findall(r"#declare\s+(\w+)\s*=\s*(\w+)", text):
        if kind in WORN:
            found.pop(name, None)
            found[name] = kind
    return [(kind, name) for name, kind in found.items()]


def write_scenes(folder, include):
    """Writes the scenes of a file; {file name: items in it}."""
    declared = items(include)
    heading = HEAD % f'#include "{include}.inc"'
    written = {}
    grid = [(kind, name) for kind, name in declared if WORN[kind]]
    for first in range(0, len(grid), COLUMNS * ROWS):
        scene = heading + CAMERA
        part = grid[first:first + COLUMNS * ROWS]
        for i, (kind, name) in enumerate(part):
            x, y = 3 * (i % COLUMNS) - 4.5, 3 - 3 * (i // COLUMNS)
            worn = WORN[kind] % name
            scene += f"sphere {{ <{x - 0.3}, {y + 0.2}, 0>, 1 {worn} }}\n"
            scene += f"box {{ <{x - 1.4}, {y - 1.4}, 2>, <{x + 1.4}, {y + 1.4}, 2.5> {worn} }}\n"
        file = f"{include}_{first // (COLUMNS * ROWS):02}.pov"
        (folder / file).write_text(scene)
        written[file] = [name for _, name in part]
    for kind, name in declared:
        if WORN[kind]:
            continue
        file = f"{include}_{name}.pov"
        (folder / file).write_text(heading + f"camera {{ location -5*z look_at y angle 80 }}\nsky_sphere {{ {name} }}\nsphere {{ 0, 1 pigment {{ rgb 0.5 }} finish {{ reflection 0.6 }} }}\n")
        written[file] = [name]
    return written


def main():
    root = pathlib.Path(__file__).resolve().parents[2]
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("includes", nargs="*", default=INCLUDES)
    options.add_argument("--verisim", default=str(root / "build/release/bin/verisim"))
    options.add_argument("--folder", type=pathlib.Path, default=root / "build/sweep_includes")
    chosen = options.parse_args()
    chosen.folder.mkdir(parents=True, exist_ok=True)
    total, bad = {"exact": 0, "match": 0}, []
    for include in chosen.includes:
        written = write_scenes(chosen.folder, include)
        report = chosen.folder / f"{include}.json"
        subprocess.run([chosen.verisim, "compare", *(str(chosen.folder / f) for f in written), "+W320", "+H240", "-A", "--replay", "--json", str(report)],
                       stdout=subprocess.DEVNULL)
        counts = {}
        for scene in json.loads(report.read_text())["scenes"]:
            file = pathlib.Path(scene["scene"]).name
            counts[scene["status"]] = counts.get(scene["status"], 0) + len(written[file])
            if scene["status"] in total:
                total[scene["status"]] += len(written[file])
            else:
                bad.append((scene["status"], chosen.folder / file))
        print(f"{include:12}", ", ".join(f"{n} items in scenes that are {status}" for status, n in counts.items()), flush=True)
    print("all:", ", ".join(f"{n} {status}" for status, n in total.items()))
    for status, file in bad:
        print(status, file)
    sys.exit(bool(bad))


if __name__ == "__main__":
    main()
