#!/usr/bin/env python3
"""Broken scenes: the whole text of the first error, and the line POV-Ray names for the same mistake.

    check.py VERISIM [--update]

Each NAME.pov holds one mistake that people make; NAME.txt the text of verisim's first error (or, where it only warns, its
first warning) and a last line `POV-Ray: line N` (or `accepts it`). The part about POV-Ray is compared where POV-Ray is
installed: whatever stops POV-Ray must stop verisim, too. A mistake is one error: none that is gone when the first is
mended. --update writes the texts anew.
"""
import concurrent.futures
import pathlib
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
    print(f"{len(scenes)} broken scenes, {bad} wrong")
    return bad > 0


if __name__ == "__main__":
    sys.exit(main())
