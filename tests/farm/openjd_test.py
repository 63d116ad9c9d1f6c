#!/usr/bin/env python3
"""The job templates of share/verisim/openjd: they are what the specification says (openjd_check.py, which must find planted faults), and
their commands, run task by task as a worker runs them, make the files that one call of verisim makes.

    openjd_test.py VERISIM TEMPLATES
"""
import copy
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from openjd_check import REFERENCE, check, expand_range  # noqa: E402

SCENE = ('#version 3.7; global_settings { assumed_gamma 1 photons { spacing 0.05 } radiosity { count 20 error_bound 0.6 recursion_limit 1 } }\n'
         '#include "a folder\'s colours.inc"\n'
         "camera { location <0, 1, -5> look_at 0 } light_source { <3, 5, -6> rgb 1 }\n"
         "sphere { <clock, 0, 0>, 1 pigment { OWN } photons { target refraction on } interior { ior 1.4 } } plane { y, -1 pigment { checker rgb 1 rgb 0.3 } }\n")


def planted_faults(template):
    """Templates with one mistake each."""
    def changed(change):
        broken = copy.deepcopy(template)
        change(broken)
        return broken
    first = lambda t: t["steps"][0]["script"]["actions"]["onRun"]
    yield changed(lambda t: t.update(specificationVersion="jobtemplate-2024-01"))
    yield changed(lambda t: t.pop("steps"))
    yield changed(lambda t: t.update(step=[]))
    yield changed(lambda t: t["parameterDefinitions"][0].update(type="FILE"))
    yield changed(lambda t: t["parameterDefinitions"][0].update(objectType="SCENE"))
    yield changed(lambda t: t["parameterDefinitions"][0].update(name="a scene"))
    yield changed(lambda t: t["parameterDefinitions"].append(t["parameterDefinitions"][0]))
    yield changed(lambda t: first(t)["args"].append("{{Param.Nothing}}"))
    yield changed(lambda t: first(t)["args"].append("{{Task.Param.Nothing}}"))
    yield changed(lambda t: first(t)["args"].append("{{Param.Scene"))
    yield changed(lambda t: first(t)["args"].append(""))
    yield changed(lambda t: first(t)["cancelation"].update(notifyPeriodInSeconds=6000))
    yield changed(lambda t: t.update(name="{{Param.Scene}}"))  # a PATH, which is known in a session only
    yield changed(lambda t: t["steps"][0].update(dependencies=[{"dependsOn": "Nothing"}]))


def tasks_of(step, values):
    """What {{Task.Param.X}} stands for, task by task; chunks as a scheduler cuts them, the last one passing the end."""
    space = step.get("parameterSpace")
    if not space:
        return [{}]
    (parameter,) = space["taskParameterDefinitions"]
    name = f"Task.Param.{parameter['name']}"
    numbers = expand_range(expand(parameter["range"], values))
    if parameter["type"] == "INT":
        return [{name: str(n)} for n in numbers]
    size = int(expand(parameter["chunks"]["defaultTaskCount"], values))
    chunks = [numbers[i:i + size] for i in range(0, len(numbers), size)]
    chunks[-1] += range(chunks[-1][-1] + 1, chunks[-1][-1] + 3)
    return [{name: ",".join(map(str, chunk)) if i % 2 else f"{chunk[0]}-{chunk[-1]}" if len(chunk) > 1 else str(chunk[0])}
            for i, chunk in enumerate(chunks)]


def expand(text, values):
    return REFERENCE.sub(lambda m: values[m[1]], text)


def run_job(verisim, template, given, folder):
    """As a worker: no shell, a working folder for each session, the program from the PATH."""
    values = {f"Param.{p['name']}": str(given.get(p["name"], p.get("default"))) for p in template["parameterDefinitions"]}
    environment = {**os.environ, "PATH": f"{verisim.parent}:{os.environ['PATH']}"}
    for step in template["steps"]:
        for number, task in enumerate(tasks_of(step, values)):
            session = folder / f"session-{step['name']}-{number}"
            session.mkdir()
            action = step["script"]["actions"]["onRun"]
            words = [expand(w, {**values, **task, "Session.WorkingDirectory": str(session)}) for w in (action["command"], *action["args"])]
            done = subprocess.run(words, cwd=session, env=environment, capture_output=True, text=True)
            said = done.stdout + done.stderr
            if done.returncode != 0:
                sys.exit(f"{words}: status {done.returncode}\n{said}")
            if "openjd" in words and not re.search(r"^openjd_progress: 100\.0$", said, re.M):
                sys.exit(f"{words}: no progress was told\n{said}")


def render(verisim, folder, *words):
    done = subprocess.run([verisim, "render", *map(str, words)], cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{words}: {done.stderr}")


def same(a, b):
    if a.read_bytes() != b.read_bytes():
        sys.exit(f"{a} is not {b}")


def main():
    verisim, templates = (pathlib.Path(p).resolve() for p in sys.argv[1:3])
    loaded = {path.stem: json.loads(path.read_text()) for path in sorted(templates.glob("*.json"))}
    assert len(loaded) == 3, loaded.keys()
    for name, template in loaded.items():
        faults = check(template)
        if faults:
            sys.exit(f"{name}: " + "\n".join(faults))
        for number, broken in enumerate(planted_faults(template)):
            if not check(broken):
                sys.exit(f"{name}: planted fault {number} was not found")
    if not check({k: v for k, v in loaded["animation-chunked"].items() if k != "extensions"}):
        sys.exit("CHUNK[INT] without its extension was not found")
    with tempfile.TemporaryDirectory(prefix="verisim openjd 'ü' ") as name:
        folder = pathlib.Path(name)
        source, out = folder / 'a "scene"; $(touch gone)', folder / "out put"
        library = folder / 'the "library"'
        for new in (source, out, library, folder / "whole", folder / "parts"):
            new.mkdir()
        (source / "scene.pov").write_text(SCENE)
        (library / "a folder's colours.inc").write_text("#declare OWN = pigment { rgbf <1, 0.8, 0.4, 0.7> }\n")
        common = {"Scene": source / "scene.pov", "SceneFolder": library, "Settings": templates / "settings.ini", "OutputFolder": out,
                  "Width": 40, "Height": 30}
        words = [templates / "settings.ini", source / "scene.pov", "--library", library, "+W40", "+H30"]
        render(verisim, folder, *words, "+KFF7", "--output", folder / "whole" / "frame.png")
        for kind, more in (("animation", {}), ("animation-chunked", {"FramesPerTask": 3})):
            run_job(verisim, loaded[kind], {**common, "Frames": "1-7", "LastFrame": 7, **more}, folder)
            pictures = sorted(p.name for p in out.glob("*.png"))
            assert pictures == [f"frame{n}.png" for n in range(1, 8)], pictures
            for picture in pictures:
                same(out / picture, folder / "whole" / picture)
                (out / picture).unlink()
            for session in folder.glob("session-*"):
                session.rmdir()  # nothing is left in them
        render(verisim, folder, *words, "--output", folder / "whole" / "picture.png")
        run_job(verisim, loaded["still"], {**common, "PartsFolder": folder / "parts", "Parts": 3}, folder)
        same(out / "picture.png", folder / "whole" / "picture.png")
    print("templates: as specified; their tasks make the same bytes")


if __name__ == "__main__":
    sys.exit(main())
