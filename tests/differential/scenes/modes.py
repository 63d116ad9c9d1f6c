#!/usr/bin/env python3
"""Invents scenes without chance and compares verisim's two orders of work.

By default rays go in packets, blocks in any order; with --replay they go one by one, as in POV-Ray. Both are to draw the
same pixels, but for what docs/differences.md names: what differs is a mistake of one of them, mostly of packets. No
POV-Ray is needed, so that some sixty scenes are looked at in a second; invent.py asks it for the scenes found.
"""
import argparse
import concurrent.futures
import pathlib
import re
import shutil
import subprocess
import tempfile

import grammar
import people
import rare

# What draws random numbers, which the two orders take from other sequences. Photons of objects do nothing here.
CHANCE = re.compile(
    r"\b(radiosity|photons|media|crand|jitter|subsurface|focal_point|blur_samples|aperture|adaptive|circular|rand|area_light)\b"
)
FLAGS = re.compile(r"photons\s*\{[^{}]*\}")


def picture(program, scene, size, folder, *switches):
    out = folder / "picture.ppm"
    out.unlink(missing_ok=True)
    width, height = size.split("x")
    command = [program, scene, f"+W{width}", f"+H{height}", "-A", "-D", "-P", "+FP", f"+O{out}", *switches]
    subprocess.run(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=60)
    return out.read_bytes() if out.exists() else b""


def differing(a, b):
    """Pixels of two PPM files that differ, and the largest step."""
    if len(a) != len(b):
        return max(len(a), len(b)) // 3, 255
    steps = [abs(x - y) for x, y in zip(a, b)]
    return sum(any(steps[i : i + 3]) for i in range(len(steps) % 3, len(steps), 3)), max(steps, default=0)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--out", required=True, type=pathlib.Path, help="a folder for scenes that differ")
    parser.add_argument("--verisim", default=shutil.which("verisim") or "build/release/bin/verisim")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--people", action="store_true", help="scenes as people write them")
    parser.add_argument("--rare", action="store_true", help="scenes with what is seldom said")
    parser.add_argument("--size", default="32x24", help="of the pictures")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    program = str(pathlib.Path(options.verisim).resolve())
    source = people if options.people else rare if options.rare else grammar

    def look(number):
        version, text = source.scene(options.seed * 1_000_003 + number)
        if CHANCE.search(FLAGS.sub("", text)):
            return None
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            scene = folder / "scene.pov"
            head = f"#version {version};\n" if version else ""
            scene.write_text(head + text, "latin-1", "replace")
            try:
                pictures = [picture(program, scene, options.size, folder, *s) for s in ((), ("--replay",))]
            except subprocess.TimeoutExpired:
                return None
            if pictures[0] == pictures[1]:
                return 0, 0
            shutil.copy(scene, options.out / f"{options.seed}_{number:06d}.pov")
            return differing(*pictures)

    looked = found = 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for number, result in enumerate(pool.map(look, range(options.count))):
            looked += result is not None
            if result and result != (0, 0):
                found += 1
                print(f"{options.seed}_{number:06d}.pov: {result[0]} px, largest {result[1]}", flush=True)
    print(f"{options.count} scenes, {looked} without chance, {found} differ; {options.out}")
    return 1 if found else 0


if __name__ == "__main__":
    raise SystemExit(main())
