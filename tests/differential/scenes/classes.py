"""Classes of differences: scenes whose reduced forms have the same words, and those that known.json explains.

known.json has "classes" (a name, and patterns that all occur in a reduced scene of that class) and "scenes" (names of
classes by scenes of the fixed set). Each name must be explained in docs/differential.md.
"""
import collections
import json
import pathlib
import re

import sdl_text

KNOWN = json.loads(pathlib.Path(__file__).with_name("known.json").read_text())
EXPLAINED = (pathlib.Path(__file__).parents[3] / "docs" / "differential.md").read_text()
DULL = {
    "camera",
    "location",
    "look_at",
    "light_source",
    "rgb",
    "color",
    "colour",
    "global_settings",
    "assumed_gamma",
    "translate",
    "rotate",
    "x",
    "y",
    "z",
    "pigment",
}


def signature(difference, reduced):
    words = [w for w in sdl_text.keywords(reduced) if w not in DULL]
    note = re.sub(r"[\d.]+", "N", difference.note)[:60] if difference.kind != "picture" else ""
    size = (
        ""
        if difference.kind != "picture"
        else " few"
        if difference.pixels < 8
        else " small"
        if difference.largest < 6
        else ""
    )
    if difference.kind == "warnings":
        words = []
    return f"{difference.kind}{size}: {' '.join(sorted(words))} {note}".strip()


def known(scene, text):
    """The name of the class that explains a reduced scene (with its head line), or None."""
    name = KNOWN["scenes"].get(pathlib.Path(scene).stem)
    for entry in [] if name else KNOWN["classes"]:
        if all(re.search(pattern, text, re.S) for pattern in entry["patterns"]):
            name = entry["name"]
            break
    return name if name and f"**{name}**" in EXPLAINED else None


def write_table(out, state):
    """Writes classes.md, most frequent first; returns how many differences no known class explains."""
    groups = collections.defaultdict(list)
    unknown = 0
    for name, mark in state["found"].items():
        text = (out / "found" / name).read_text("latin-1")
        name_of = known(name, text)
        unknown += name_of is None
        groups[f"known: {name_of}" if name_of else mark].append(name)
    lines = ["| scenes | class | smallest |", "| --- | --- | --- |"]
    for mark, names in sorted(groups.items(), key=lambda g: -len(g[1])):
        smallest = min(names, key=lambda n: (out / "found" / n).stat().st_size)
        lines.append(f"| {len(names)} | {mark.replace('|', '/')} | found/{smallest} |")
    (out / "classes.md").write_text("\n".join(lines) + "\n")
    return unknown
