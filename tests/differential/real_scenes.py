#!/usr/bin/env python3
"""Renders real scenes by POV-Ray and by verisim and says, scene by scene, how many pixels differ and by how much.

usage: real_scenes.py LIST... [--scenes DIR] [--verisim PROGRAM] [--size 160x120] [--switches=-A] [--replay] [--jobs N]
                      [--only TEXT] [--kept FOLDER] [--against FILE] [--out FILE]

A LIST names a scene a line, relative to DIR (default: where the LIST is), and after a tab switches of its own ("-": none).
POV-Ray's pictures (+WT1, 8 bits) are kept in FOLDER (default: ~/.cache/verisim/real) by size and switches, so that only the
first call waits for them; what POV-Ray refuses, or takes longer than --timeout for, is left out and named. Scenes with
random elements can be the same with --replay only. --out FILE gets the table, --against FILE is such a table of another
program: what has changed is told. Exit status 1 if one is worse than in it.
"""
import argparse
import concurrent.futures
import dataclasses
import hashlib
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile


@dataclasses.dataclass(frozen=True)
class Scene:
    name: str
    path: pathlib.Path
    switches: tuple


@dataclasses.dataclass
class Difference:
    pixels: int  # that are not the same; -1: no picture
    largest: int  # of all channels, in 8-bit units
    why: str = ""  # there is no picture

    def __str__(self):
        return self.why or ("exact" if not self.pixels else f"{self.pixels} px by {self.largest}")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("lists", nargs="+", type=pathlib.Path)
    parser.add_argument("--scenes", type=pathlib.Path)
    parser.add_argument("--verisim", default=shutil.which("verisim") or "build/release/bin/verisim")
    parser.add_argument("--povray", default="povray")
    parser.add_argument("--size", default="160x120")
    parser.add_argument("--switches", default="-A")
    parser.add_argument("--replay", action="store_true", help="POV-Ray's random numbers in POV-Ray's order")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--timeout", type=float, default=300, help="seconds for one picture")
    parser.add_argument("--only", default="", help="scenes whose names hold this text")
    parser.add_argument("--kept", type=pathlib.Path, default=pathlib.Path.home() / ".cache/verisim/real")
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("--against", type=pathlib.Path)
    return parser.parse_args()


def scenes_of(options):
    found = []
    for listed in options.lists:
        folder = options.scenes or listed.parent
        for line in listed.read_text().splitlines():
            name, _, switches = line.partition("\t")
            if name.strip() and not name.startswith("#") and options.only in name:
                switches = [] if switches.strip() in ("", "-") else shlex.split(switches)
                found.append(Scene(name, (folder / name).resolve(), tuple(switches)))
    return found


def render(program, scene, options, extra, picture):
    """'' if `picture` holds a picture then, else why it does not."""
    width, height = options.size.split("x")
    with tempfile.TemporaryDirectory() as folder:
        made = pathlib.Path(folder) / "picture.ppm"
        command = [program, f"+I{scene.path.name}", f"+O{made}", f"+W{width}", f"+H{height}", *shlex.split(options.switches)]
        command += ["-D", "-P", "+FP", *scene.switches, *extra]
        try:
            run = subprocess.run(
                command,
                cwd=scene.path.parent,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
                timeout=options.timeout,
            )
        except subprocess.TimeoutExpired:
            return "slow"
        if run.returncode < 0:
            return f"signal {-run.returncode}"
        if run.returncode or not made.exists():
            return "refused"
        picture.parent.mkdir(parents=True, exist_ok=True)
        shutil.move(made, picture)
    return ""


def samples(picture):
    """of a PPM file of 8 bits, behind its head, which may hold comments"""
    kept = picture.read_bytes()
    head = re.match(rb"P6\s+(?:#[^\n]*\n\s*)*\d+\s+(?:#[^\n]*\n\s*)*\d+\s+(?:#[^\n]*\n\s*)*\d+\s", kept)
    return kept[head.end() :]


def difference(reference, ours):
    a, b = samples(reference), samples(ours)
    if a == b:
        return Difference(0, 0)
    if len(a) != len(b):
        return Difference(-1, 0, "another size")
    pixels = sum(a[i : i + 3] != b[i : i + 3] for i in range(0, len(a), 3))
    return Difference(pixels, max(abs(x - y) for x, y in zip(a, b)))


def reference_of(scene, options):
    """POV-Ray's picture, made if it is not kept, and why there is none."""
    key = f"{scene.path}\n{scene.switches}\n{options.size} {options.switches}"
    kept = options.kept / hashlib.sha256(key.encode()).hexdigest()[:24]
    picture, refused = kept.with_suffix(".ppm"), kept.with_suffix(".why")
    if not picture.exists() and not refused.exists():
        why = render(options.povray, scene, options, ["+WT1"], picture)
        if why:
            refused.parent.mkdir(parents=True, exist_ok=True)
            refused.write_text(why)
    return picture, refused.read_text() if refused.exists() else ""


def compared(scene, options):
    """None: POV-Ray draws no picture."""
    reference, why = reference_of(scene, options)
    if why:
        print(f"{scene.name}\tPOV-Ray: {why}", file=sys.stderr)
        return None
    with tempfile.TemporaryDirectory() as folder:
        ours = pathlib.Path(folder) / "ours.ppm"
        # one thread a picture: there are as many jobs as threads
        why = render(options.verisim, scene, options, ["+WT1", *(["--replay"] if options.replay else [])], ours)
        return Difference(-1, 0, why) if why else difference(reference, ours)


def read_table(path):
    rows = (line.split("\t") for line in path.read_text().splitlines())
    return {name: Difference(int(pixels), int(largest), why) for name, pixels, largest, why in rows}


def worse_than_before(results, before):
    """Tells of all scenes that are not as they were; how many are worse."""
    worse = 0
    for name, now in results.items():
        was = before.get(name)
        if was and (was.pixels, was.largest, was.why) != (now.pixels, now.largest, now.why):
            worse += now.pixels < 0 <= was.pixels or (was.pixels >= 0 and now.pixels > was.pixels)
            print(f"{name}: {was} -> {now}")
    return worse


def main():
    options = arguments()
    options.verisim = str(pathlib.Path(options.verisim).resolve())
    scenes = scenes_of(options)
    results = {}
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for number, (scene, result) in enumerate(zip(scenes, pool.map(lambda s: compared(s, options), scenes)), 1):
            if result:
                results[scene.name] = result
            if sys.stderr.isatty():
                print(f"\r{number} of {len(scenes)}", end="", file=sys.stderr)
    for name, result in sorted(results.items(), key=lambda item: item[1].pixels):
        if result.pixels:
            print(f"{name}: {result}")
    exact = sum(r.pixels == 0 for r in results.values())
    one = sum(r.pixels == 1 for r in results.values())
    unit = sum(r.pixels > 1 and r.largest == 1 for r in results.values())
    print(f"{len(results)} scenes, {exact} exact; of the others {one} but for one pixel, {unit} more by one unit of 255")
    if options.out:
        options.out.write_text("".join(f"{n}\t{r.pixels}\t{r.largest}\t{r.why}\n" for n, r in results.items()))
    return 1 if options.against and worse_than_before(results, read_table(options.against)) else 0


if __name__ == "__main__":
    os.environ.setdefault("LC_ALL", "C")
    sys.exit(main())
