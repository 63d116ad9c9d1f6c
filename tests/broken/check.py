#!/usr/bin/env python3
"""Broken scenes: the whole text of the first error, and the line POV-Ray names for the same mistake.

    check.py VERISIM [--update]

Each NAME.pov holds one mistake that people make; NAME.txt the text of verisim's first error (or, where it only warns, its
first warning) and a last line `POV-Ray: line N` (or `accepts it`). The part about POV-Ray is compared where POV-Ray is
installed: whatever stops POV-Ray must stop verisim, too. A mistake is one error: none that is gone when the first is
mended. --update writes the texts anew.
"""
import concurrent.futures
import itertools
import json
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent


def first_message(verisim, scene):
    """(text of the first error or else warning, number of errors)."""
    run = subprocess.run([verisim, "check", scene.name], cwd=HERE, capture_output=True, timeout=60, errors="replace")
    lines = run.stderr.splitlines()
    heads = [i for i, line in enumerate(lines) if re.match(re.escape(scene.name) + r":.* \[[a-z-]+\]$", line)]
    errors = [i for i in heads if " error: " in lines[i]]
    start = (errors or heads or [len(lines)])[0]
    end = next((i for i in range(start + 1, len(lines)) if not lines[i].startswith(" ")), len(lines))
    # Folders of the installation are no part of the text.
    text = [re.sub(r"in /.*", "in ...", line) for line in lines[start:end]]
    return "\n".join(text), len(errors)


def povray_place(povray, scene):
    """The line of POV-Ray's error; None: it accepts the scene."""
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(scene, folder)
        run = subprocess.run([povray, "+I" + scene.name, "+W4", "+H3", "-D", "-P", "-F"], cwd=folder,
                             capture_output=True, timeout=120, errors="replace")
    if run.returncode == 0:
        return None
    found = re.search(r"line (\d+): (?:Parse Error|Fatal)", run.stderr.replace("\n", " "))
    return int(found.group(1)) if found else 0


HEAD = """#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1, -5> look_at 0 }
light_source { <10, 20, -30>, rgb 1 }
"""
SWALLOW = ("string-", "comment-", "union-", "macro-unclosed")  # what is never closed takes in what comes behind


def errors_of(verisim, folder, text):
    """(code, line) of each error."""
    (folder / "scene.pov").write_text(text)
    run = subprocess.run([verisim, "check", "scene.pov", "--json"], cwd=folder, capture_output=True, timeout=60)
    return {(d["code"], d["line"]) for d in json.loads(run.stdout)["diagnostics"] if d["severity"] == "error"}


def follow_ups(verisim, scenes, pairs):
    """Two mistakes in one scene: no error is told but theirs. Returns the number of pairs where one is."""
    bodies = {s.stem: s.read_text().partition("\n")[2].removeprefix(HEAD) for s in scenes}
    bad = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        alone = {stem: errors_of(verisim, folder, HEAD + body) for stem, body in bodies.items()}
        for first, second in random.Random(1).sample(list(itertools.permutations(bodies, 2)), pairs):
            if first.startswith(SWALLOW):
                continue
            down = bodies[first].count("\n")
            more = errors_of(verisim, folder, HEAD + bodies[first] + bodies[second])
            more -= alone[first] | {(code, line + down) for code, line in alone[second]}
            if more:
                bad += 1
                print(f"{first}, then {second}: these follow from others: {sorted(more)}")
    return bad


def main():
    verisim, update = str(pathlib.Path(sys.argv[1]).resolve()), "--update" in sys.argv
    povray = shutil.which("povray")
    scenes = sorted(HERE.glob("*.pov"))
    with concurrent.futures.ThreadPoolExecutor(8) as pool:
        messages = list(pool.map(lambda s: first_message(verisim, s), scenes))
        places = list(pool.map(lambda s: povray_place(povray, s), scenes)) if povray else [None] * len(scenes)
    bad = 0
    for scene, (text, errors), line in zip(scenes, messages, places):
        theirs = "accepts it" if line is None else f"line {line}"
        wanted_file = scene.with_suffix(".txt")
        if update and povray:
            wanted_file.write_text(f"{text}\n\nPOV-Ray: {theirs}\n")
            continue
        wanted, _, wanted_theirs = wanted_file.read_text().rpartition("\n\nPOV-Ray: ")
        if text != wanted:
            bad += 1
            print(f"{scene.name}: the message changed\n--- wanted\n{wanted}\n--- found\n{text}\n")
        if povray and theirs != wanted_theirs.strip():
            bad += 1
            print(f"{scene.name}: POV-Ray says {theirs}, not {wanted_theirs.strip()}")
        if errors > 1:
            bad += 1
            print(f"{scene.name}: {errors} errors, but there is one mistake: the others follow from it")
        if errors > 1:
            bad += 1
            print(f"{scene.name}: {errors} errors, but there is one mistake: the others follow from it")
        if wanted_theirs.strip() != "accepts it" and not errors:
            bad += 1
            print(f"{scene.name}: POV-Ray finds an error, verisim none")
    bad += follow_ups(verisim, scenes, 60)
    print(f"{len(scenes)} broken scenes, {bad} wrong")
    return bad > 0


if __name__ == "__main__":
    sys.exit(main())
