"""Uses verisim for a long time and looks at what it keeps: soak.py VERISIM view|merge [--minutes 60]

view: one `verisim view` whose scene is saved, looked at, zoomed and explained again and again; merge: parts rendered and merged again and
again. Memory must be flat (the last quarter at most 10 % or 8 MiB above the second), file handles must not grow, and the same question must
have the same bytes as its answer at the end as at the start. Exit status 1: it is not so.
"""
import argparse
import hashlib
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
import urllib.request

SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
#declare Size = %s; // @range 0.2 2
camera { location <0, 1, -5> look_at 0 }
light_source { <5, 8, -6> rgb 1 }
sphere { 0, Size pigment { bozo turbulence 1 color_map { [0 rgb 1] [1 rgb <1, 0.5, 0>] } } finish { reflection 0.2 } }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.2 } }
#include "own.inc"
"""


def memory(pid):
    with open(f"/proc/{pid}/status") as status:
        return next(int(line.split()[1]) * 1024 for line in status if line.startswith("VmRSS"))


def handles(pid):
    return len(os.listdir(f"/proc/{pid}/fd"))


def save(folder, name, text):
    with open(os.path.join(folder, name + ".new"), "w") as file:
        file.write(text)
    os.replace(os.path.join(folder, name + ".new"), os.path.join(folder, name))


def verdict(samples, first, last):
    """What is not as it should be, of (memory, handles) over time and the first and the last answer."""
    wrong = []
    quarter = max(1, len(samples) // 4)
    early, late = samples[quarter:2 * quarter], samples[-quarter:]
    if early and late:
        before, after = max(m for m, _ in early), max(m for m, _ in late)
        print(f"memory: {before >> 20} MiB in the second quarter, {after >> 20} MiB in the last; handles: {max(h for _, h in early)} and {max(h for _, h in late)}")
        if after > before * 1.1 and after > before + (8 << 20):
            wrong.append("memory grows")
        if max(h for _, h in late) > max(h for _, h in early) + 2:
            wrong.append("file handles are lost")
    if first != last:
        wrong.append("other bytes at the end than at the start")
    return wrong


def view(verisim, folder, minutes):
    program = subprocess.Popen([verisim, "view", "scene.pov", "+W160", "+H120", "--no-open", "--sandbox=best-effort"], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    address = program.stdout.readline().strip()

    def ask(path, body=None):
        with urllib.request.urlopen(address + path, data=body, timeout=60) as reply:
            return reply.read()

    def picture():
        """The finished picture of what is saved now."""
        generation = pieces = state = 0
        tiles = {}
        while True:
            reply = ask(f"update?generation={generation}&pieces={pieces}&state={state}&wait=5")
            size = int.from_bytes(reply[:4], "little")
            told = json.loads(reply[4:4 + size])
            if told.get("generation") != generation:
                tiles, pieces = {}, 0
            at = 4 + size + -size % 4
            generation, state = told.get("generation", generation), told.get("state", state)
            for x, y, width, height, cell in told.get("tiles", []):
                count = -(-width // cell) * -(-height // cell) * 16
                if cell == 1:
                    tiles[(x, y, width, height)] = reply[at:at + count]
                at += count
                pieces += 1
            if told["status"] in ("done", "error"):
                colours = b"".join(tiles[place] for place in sorted(tiles))
                return told["status"], hashlib.sha256(colours + ask(f"layers?generation={generation}")).hexdigest()

    samples, rounds, first, last = [], 0, None, None
    end = time.monotonic() + 60 * minutes
    try:
        while time.monotonic() < end:
            for size in ("1", "0.5", "1.5", "oops", "1"):
                save(folder, "scene.pov", SCENE % size)
                time.sleep(0.3)  # the watch sees it
                last = picture()
            for wish in ({"zoom": 4, "left": 100, "top": 100}, {"zoom": 1, "left": 0, "top": 0}):
                ask("wish", json.dumps(wish).encode())
                picture()
            last = picture()
            ask("explain?x=80&y=60")
            first = first or last
            rounds += 1
            samples.append((memory(program.pid), handles(program.pid)))
    finally:
        program.send_signal(signal.SIGINT)
        program.wait(30)
    print(f"view: {rounds} rounds of five saved files, two windows and a ray tree in {minutes} minutes")
    wrong = verdict(samples, first, last)
    if program.returncode not in (0, 130):
        wrong.append(f"exit status {program.returncode}")
    return wrong


def merge(verisim, folder, minutes):
    first = last = None
    rounds = 0
    end = time.monotonic() + 60 * minutes
    run = lambda *words: subprocess.run([verisim, *words], cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    while time.monotonic() < end:
        for k in range(1, 5):
            run("render", "scene.pov", "+W160", "+H120", "+A0.3", "--part", f"{k}/4", "--output", f"p{k}.part")
        run("merge", *(f"p{k}.part" for k in range(1, 5)), "--output", "whole.png")
        with open(os.path.join(folder, "whole.png"), "rb") as file:
            last = hashlib.sha256(file.read()).hexdigest()
        first = first or last
        rounds += 1
        if last != first:
            break
    left = sorted(set(os.listdir(folder)) - {"scene.pov", "own.inc", "whole.png", "p1.part", "p2.part", "p3.part", "p4.part"})
    print(f"merge: {rounds} rounds of four parts in {minutes} minutes")
    return verdict([], first, last) + ([f"leaves {left}"] if left else [])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("verisim")
    parser.add_argument("what", choices=["view", "merge"])
    parser.add_argument("--minutes", type=float, default=60)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        save(folder, "scene.pov", SCENE % "1")
        save(folder, "own.inc", "sphere { <1, 0, 0>, 0.3 pigment { rgb 1 } }\n")
        wrong = {"view": view, "merge": merge}[options.what](os.path.abspath(options.verisim), folder, options.minutes)
    print("; ".join(wrong) or "all is as it was")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
