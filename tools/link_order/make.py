#!/usr/bin/env python3
"""Which functions scenes use, most used first: tools/link_order/make.py PROGRAM [EXAMPLES] > tools/link_order/functions.txt

The linker puts these functions beside each other (cmake/LinkOrder.cmake). The kernel maps a program's file by 64 kB around each address that is asked for:
scattered over twelve megabytes, the one megabyte that a scene uses brings six into memory, together it brings three. Runs small pictures of some hundred and twenty scenes
of povray-examples under valgrind's callgrind (four minutes). Names that no longer exist are harmless; made again with each release.
"""
import collections
import os
import pathlib
import re
import subprocess
import sys
import tempfile

EXAMPLES = "/usr/share/doc/povray/examples"
SCENES = 120
MOST_SECONDS = 30  # scenes that take longer are left out
LONGEST_NAME = 250  # longer ones end in a star: the beginning of such a name tells it from all but its likes
SIZE = ["+W40", "+H30", "-A", "+WT2", "-D"]
# Kernels for other processors are used where ours are: names of one instruction set, and what they are for the next.
OTHER_SETS = [("6N_AVX2", "6N_AVX3"), ("4avx2", "6avx512")]


def functions_used(program, scene, folder):
    """The names of the functions that a picture of the scene calls; None: it takes too long, or fails."""
    profile = pathlib.Path(folder) / "profile"
    command = ["valgrind", "--tool=callgrind", "--demangle=no", f"--callgrind-out-file={profile}", program, scene.name,
               f"+O{folder}/picture.png", *SIZE]
    try:
        done = subprocess.run(command, cwd=scene.parent, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                              timeout=MOST_SECONDS)
    except subprocess.TimeoutExpired:
        return None
    if done.returncode:
        return None
    names = re.findall(r"^c?fn=\(\d+\) (\S+)$", profile.read_text(), re.MULTILINE)
    return {re.sub(r"'\d+$", "", name) for name in names}


def functions_by_place(program):
    """The program's functions, each with all names of its place: the compiler names the section of a constructor as one of them, callgrind may know
    another."""
    table = subprocess.run(["nm", "--defined-only", program], check=True, capture_output=True, text=True).stdout
    functions = [(line.split()[0], line.split()[-1]) for line in table.splitlines() if line.split()[-2] in "tTwW"]
    places = collections.defaultdict(list)
    for place, name in functions:
        places[place].append(name)
    return {name: places[place] for place, name in functions}


def pattern(name):
    return name if len(name) <= LONGEST_NAME else name[:LONGEST_NAME] + "*"


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__.split("\n", maxsplit=1)[0])
    program = os.path.abspath(sys.argv[1])
    scenes = sorted(pathlib.Path(sys.argv[2] if len(sys.argv) == 3 else EXAMPLES).rglob("*.pov"))
    used = collections.Counter()
    with tempfile.TemporaryDirectory() as folder:
        for scene in scenes[:: max(1, len(scenes) // SCENES)]:
            used.update(functions_used(program, scene, folder) or ())
            print(scene.name, len(used), file=sys.stderr)
    ours = functions_by_place(program)
    listed = {}
    for name, count in used.most_common():
        if name not in ours:
            continue
        for alias in ours[name]:
            listed.setdefault(pattern(alias), count)
            for here, other in OTHER_SETS:
                if here in alias and alias.replace(here, other) in ours:
                    listed.setdefault(pattern(alias.replace(here, other)), 0)
    for name, _ in sorted(listed.items(), key=lambda item: -item[1]):
        print(name)


if __name__ == "__main__":
    main()
