#!/usr/bin/env python3
"""How often `verisim explain` names the cause first, over faults that were planted.

usage: one_side.py --verisim PROGRAM [--cases 100] [--first 0] [--work FOLDER] [--list]

Case N is always the same: a scene of a few objects, and one change of it. A script that draws the changed scene takes
POV-Ray's place, verisim draws the scene as it is, and the first suspect is right if it is one that the change allows
and, where the change is one object's, names that object. Even cases may be looked at while rules are tuned; odd ones
are only counted.
"""
import argparse
import collections
import concurrent.futures
import hashlib
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile

WIDTH, HEIGHT = 160, 120

SHAPES = (
    "sphere {{ {0}, {1} {2} }}",
    "box {{ -{1}, {1} {2} translate {0} }}",
    "cylinder {{ -{1}*y, {1}*y, {1} {2} rotate 20*x translate {0} }}",
    "cone {{ -{1}*y, {1}, {1}*y, 0.2 {2} translate {0} }}",
    "torus {{ {1}, 0.3 {2} rotate 60*x translate {0} }}",
    "superellipsoid {{ <0.4, 0.6> {2} scale {1} translate {0} }}",
    "difference {{ box {{ -{1}, {1} }} sphere {{ 0, {1}*1.2 }} {2} rotate 30*y translate {0} }}",
    "lathe {{ cubic_spline 5, <0,-1>, <0.4,-0.9>, <0.9,0>, <0.4,0.9>, <0,1> {2} scale {1} translate {0} }}",
    "blob {{ threshold 0.5 sphere {{ -0.4*x, 1, 1 }} sphere {{ 0.4*x, 1, 1 }} {2} scale {1}*1.4 translate {0} }}",
    "prism {{ -0.5, 0.5, 4 <-1,-1>, <1,-1>, <0,1>, <-1,-1> {2} scale {1} rotate -60*x translate {0} }}",
)
PIGMENTS = (
    "rgb {0}",
    "checker rgb {0} rgb {1} scale 0.3",
    "marble turbulence 0.4 color_map {{ [0 rgb {0}] [1 rgb {1}] }} scale 0.5",
    "granite color_map {{ [0 rgb {0}] [1 rgb {1}] }}",
    "bozo turbulence 0.3 color_map {{ [0 rgb {0}] [1 rgb {1}] }} scale 0.3",
    "gradient y color_map {{ [0 rgb {0}] [1 rgb {1}] }} scale 0.5",
    "wood turbulence 0.1 color_map {{ [0 rgb {0}] [1 rgb {1}] }} scale 0.3",
)


class Scene:
    """Lines by what they are; object K stands in a line of its own."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        r = self.random
        self.camera = dict(x=0.0, y=r.uniform(1, 3), z=-7.0, angle=55)
        self.lights = [
            dict(at=(r.uniform(-8, -3), r.uniform(5, 9), r.uniform(-9, -4)), color=self.color(0.5)),
            dict(at=(r.uniform(3, 8), r.uniform(4, 8), r.uniform(-9, -4)), color=self.color(0.3)),
        ]
        self.background = self.color(0.1)
        self.fog = r.choice([None, None, r.uniform(20, 60)])
        self.gamma = 1.0
        self.noise = 2
        self.objects = [self.object(k) for k in range(r.randint(3, 6))]
        self.floor = dict(height=-1.2, pigment=r.choice(PIGMENTS[1:]).format(self.color(), self.color()), finish={})
        self.finish_of(self.floor)

    def color(self, least=0.0):
        return "<{:.2f}, {:.2f}, {:.2f}>".format(*(self.random.uniform(least, 1) for _ in range(3)))

    def finish_of(self, thing):
        r = self.random
        f = thing["finish"] = dict(ambient=0.05, diffuse=r.choice([0.6, 0.7, 0.8]))
        if r.random() < 0.5:
            f["phong"], f["phong_size"] = r.choice([0.5, 0.9]), r.choice([20, 60])
        if r.random() < 0.25:
            f["reflection"] = r.choice([0.15, 0.3])

    def object(self, k):
        r = self.random
        out = dict(
            shape=r.choice(SHAPES),
            at=[-3 + 6 * (k + 0.5) / 5 + r.uniform(-0.5, 0.5), r.uniform(-0.4, 1.2), r.uniform(-1.5, 2.5)],
            size=r.uniform(0.5, 1.0),
            pigment=r.choice(PIGMENTS).format(self.color(), self.color()),
            extra="",
            turn=0.0,
            there=True,
            interior="",
        )
        self.finish_of(out)
        if r.random() < 0.25:
            out["normal"] = r.choice(["bumps 0.4 scale 0.1", "dents 0.5 scale 0.2", "ripples 0.4 scale 0.2"])
        if r.random() < 0.2:
            out["pigment"] = "rgbf <0.9, 0.95, 1, 0.8>"
            out["interior"] = "interior { ior 1.3 }"
            out["finish"] = dict(ambient=0, diffuse=0.2)
        return out

    @staticmethod
    def look(thing):
        finish = " ".join(f"{k} {v}" for k, v in thing["finish"].items())
        normal = f"normal {{ {thing['normal']} }} " if thing.get("normal") else ""
        return f"pigment {{ {thing['pigment']} }} {normal}finish {{ {finish} }}"

    def text(self):
        """The scene; object K stands in line 11 + K."""
        c = self.camera
        at = lambda v: "<{:.3f}, {:.3f}, {:.3f}>".format(*v)
        light = lambda l: f"light_source {{ {at(l['at'])}, rgb {l['color']} {l.get('extra', '')} }}" if l else "//"
        lines = [
            "#version 3.7;",
            f"global_settings {{ assumed_gamma {self.gamma} noise_generator {self.noise} }}",
            f"camera {{ location <{c['x']:.4f}, {c['y']:.4f}, {c['z']:.4f}> look_at <{c['x']:.4f}, 0.3, 0> angle {c['angle']} }}",
            light(self.lights[0]),
            light(self.lights[1]),
            f"background {{ rgb {self.background} }}",
            f"fog {{ distance {self.fog:.2f} rgb <0.6, 0.7, 0.8> }}" if self.fog else "//",
            "//",
            f"plane {{ y, {self.floor['height']} {self.look(self.floor)} }}",
            "//",
        ]
        for o in self.objects:
            inside = f"{self.look(o)} {o['interior']} {o['extra']} rotate {o['turn']:.2f}*z"
            lines.append(o["shape"].format(at(o["at"]), f"{o['size']:.4f}", inside) if o["there"] else "//")
        return "\n".join(lines) + "\n"


# Of these suspects one must name the object, too.
SURFACE = {"object", "texture", "brightness", "contrast", "color balance", "saturation", "hue", "offset", "gamma", "channels"}
OF_AN_OBJECT = SURFACE | {"transparency", "object added", "object moved", "object scaled", "object shape"}


def fault(scene):
    """Changes the scene; returns (kind, suspects that are right, number of the object's line or None)."""
    r = scene.random
    kind = r.choice(FAULTS)
    # What is wrong of an effect can be seen only where there is one.
    having = {
        "highlight": lambda o: o["finish"].get("phong"),
        "mirror": lambda o: o["finish"].get("reflection"),
        "bumps": lambda o: o.get("normal"),
        "ior": lambda o: o["interior"],
    }.get(kind, lambda o: True)
    candidates = [k for k, o in enumerate(scene.objects) if having(o)]
    if not candidates or kind == "fog" and not scene.fog:
        return kind, set(), None
    k = r.choice(candidates)
    o, line = scene.objects[k], 11 + k
    if kind == "object missing":
        o["there"] = False
        return kind, {"object added"}, line  # the test picture has it
    if kind == "object moved":
        o["at"][r.randrange(2)] += r.choice([-1, 1]) * r.uniform(0.1, 0.3)
        return kind, {"object moved"}, line
    if kind == "object scaled":
        o["size"] *= r.choice([0.85, 1.15])
        return kind, {"object scaled", "object shape", "object moved"}, line
    glass = {"transparency"} if o["interior"] else set()  # its color is what it lets through
    if kind == "pigment":
        o["pigment"] = r.choice(PIGMENTS[:1] + PIGMENTS[2:]).format(scene.color(), scene.color())
        return kind, SURFACE | glass, line
    if kind == "color":
        o["pigment"] = re.sub(r"<[\d., ]+>", lambda m: scene.color(), o["pigment"], count=1)
        return kind, SURFACE | glass, line
    if kind == "diffuse":
        o["finish"]["diffuse"] = round(o["finish"]["diffuse"] * r.choice([0.7, 1.3]), 3)
        return kind, SURFACE, line
    if kind == "highlights":
        for thing in scene.objects + [scene.floor]:
            thing["finish"].pop("phong", None), thing["finish"].pop("phong_size", None)
        return kind, {"highlights", "highlights added", "highlights missing"}, None
    if kind == "highlight":
        o["finish"]["phong_size"] *= 3
        return kind, {"highlights", "highlights added", "highlights missing"} | SURFACE, line
    if kind == "mirror":
        o["finish"]["reflection"] *= 0.5
        return kind, {"reflection", "reflection added", "reflection missing"} | SURFACE, line
    if kind == "bumps":
        o["normal"] = o["normal"].replace("0.4", "0.7").replace("0.5", "0.2")
        return kind, {"normals"} | SURFACE, line
    if kind == "light":
        light = scene.lights[r.randrange(2)]
        light["color"] = re.sub(r"<([\d.]+)", lambda m: f"<{float(m[1]) * 0.6:.2f}", light["color"])
        return kind, {"light color", "light strength"}, None
    if kind == "light missing":
        scene.lights[r.randrange(2)] = None
        return kind, {"light added", "light missing"}, None
    if kind == "light moved":
        light = scene.lights[r.randrange(2)]
        light["at"] = (light["at"][0] + r.choice([-2, 2]), light["at"][1], light["at"][2])
        return kind, {"light moved", "light", "shadows"}, None
    if kind == "shadows":
        scene.lights[r.randrange(2)]["extra"] = "shadowless"
        return kind, {"shadows", "highlights", "highlights added", "highlights missing"}, None
    if kind == "shadow":
        o["extra"] = "no_shadow"
        return kind, {"shadows"}, None
    if kind == "camera":
        scene.camera["x" if r.random() < 0.5 else "y"] += r.choice([-0.06, 0.06])
        return kind, {"camera moved", "camera turned", "shift"}, None
    if kind == "zoom":
        scene.camera["angle"] += r.choice([-1.5, 1.5])
        return kind, {"camera zoom", "zoom"}, None
    if kind == "background":
        scene.background = scene.color(0.1)
        return kind, {"background"}, None
    if kind == "fog":
        scene.fog *= 1.4
        return kind, {"fog", "fog added", "fog missing"}, None
    if kind == "gamma":
        scene.gamma = 1.15
        return kind, {"gamma", "brightness", "contrast"}, None
    if kind == "noise":
        scene.noise = 1
        return kind, {"noise functions", "texture", "normals"}, None
    if kind == "ior":
        o["interior"] = "interior { ior 1.45 }"
        return kind, {"transparency", "reflection or refraction", "object"} | SURFACE, line
    raise ValueError(kind)


FAULTS = (
    ["object missing", "object moved", "object scaled", "pigment", "color", "diffuse", "highlights", "highlight"]
    + ["mirror", "bumps", "light", "light missing", "light moved", "shadows", "shadow", "camera", "zoom"]
    + ["background", "fog", "gamma", "noise", "ior"]
)


def case(number):
    """(kind, scene as it is, scene with the fault, right suspects, line or None) or None where nothing changes."""
    base, changed = Scene(number), Scene(number)
    changed.random = random.Random(number * 7919 + 1)
    kind, right, line = fault(changed)
    if base.text() == changed.text():
        return None
    return kind, base.text(), changed.text(), right, line


def first_suspects(options, number):
    found = case(number)
    if not found:
        return number, None, None, None
    kind, base, changed, right, line = found
    folder = options.work / f"case{number}"
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "scene.pov").write_text(base)
    (folder / "other.pov").write_text(changed)
    script = folder / "oracle"
    script.write_text(
        f"#!/bin/bash\n# {hashlib.sha256(changed.encode()).hexdigest()}\n"
        "arguments=()\n"
        f'for a in "$@"; do case "$a" in +I*) a="+I{folder}/other.pov";; esac; arguments+=("$a"); done\n'
        f'exec {options.verisim} "${{arguments[@]}}"\n'
    )
    script.chmod(0o755)
    command = [options.verisim, "explain", "scene.pov", f"+W{WIDTH}", f"+H{HEIGHT}", "--oracle", str(script)]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=300)
    suspects = re.findall(r"^suspect (.+)$", done.stdout, re.M)
    (folder / "explain.txt").write_text(done.stdout + done.stderr)
    return number, found, suspects, done.stdout + done.stderr


def is_right(suspect, right, line):
    what = suspect.split(":")[0].strip()
    return what in right and (line is None or what not in OF_AN_OBJECT or f":{line})" in suspect)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--verisim", required=True)
    parser.add_argument("--cases", type=int, default=100)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--work", type=pathlib.Path)
    parser.add_argument("--list", action="store_true", help="the suspects of each even case that is wrong")
    options = parser.parse_args()
    options.verisim = str(pathlib.Path(options.verisim).resolve())
    options.work = (options.work or pathlib.Path(tempfile.mkdtemp(prefix="planted"))).resolve()
    tally = collections.defaultdict(lambda: [0, 0, 0, 0])
    numbers = range(options.first, options.first + options.cases)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for number, found, suspects, text in pool.map(lambda n: first_suspects(options, n), numbers):
            if not found or not found[3] or re.search(r"^0 of \d+ pixels differ", text, re.M):
                continue
            kind, _, _, right, line = found
            good = bool(suspects) and is_right(suspects[0], right, line)
            half = 2 * (number % 2)
            tally[kind][half] += good
            tally[kind][half + 1] += 1
            if options.list and not good and number % 2 == 0:
                print(f"{number} {kind} (line {line}): {suspects[:3] or text[-300:]}")
    for kind, (a, b, c, d) in sorted(tally.items()):
        print(f"{kind:16} even {a:3} of {b:3}, odd {c:3} of {d:3}")
    total = [sum(t[i] for t in tally.values()) for i in range(4)]
    print(f"first suspect right: even {total[0]} of {total[1]}, odd {total[2]} of {total[3]}")


if __name__ == "__main__":
    sys.exit(main())
