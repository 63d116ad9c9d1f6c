#!/usr/bin/env python3
"""Writes scenes/light/ and scenes/camera/: one small scene for every light, finish, interior, atmosphere and camera keyword and for their options.

usage: tools/make_light_scenes/generate.py [FOLDER]      (default: the scenes folder beside tools)
The scenes are checked in; run this again after changing the lists in light_lists.py and camera_lists.py.
"""
import pathlib
import sys

import camera_lists
import light_lists


def write(folder, groups):
    for group, (stage, entries) in groups.items():
        place = folder / group
        place.mkdir(parents=True, exist_ok=True)
        for name, entry in entries.items():
            if isinstance(entry, str):
                entry = {"it": entry}
            values = {"version": "3.7", "settings": "", "objects": "", "title": f"{group}: {name.replace('_', ' ')}"} | entry
            text = stage
            for key, value in values.items():
                text = text.replace(f"@{key}@", value.strip())
            lines = [line.replace("  }", " }") if line.startswith("global_settings") else line for line in text.splitlines() if line.strip()]
            (place / f"{name}.pov").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    root = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[2] / "scenes"
    write(root / "light", light_lists.GROUPS)
    write(root / "camera", camera_lists.GROUPS)
