"""Uses verisim for a long time and looks at what it keeps: soak.py VERISIM view|python|farm|merge [--minutes 60]

view: one `verisim view` whose scene is saved, looked at, zoomed and explained again and again; python: the module in one process, by
several threads, with all that it offers and with scenes that fail (PYTHONPATH says where it is); farm: jobs of parts whose tasks are
killed now and then, with `verisim farm wait` beside them; merge: parts rendered and merged again and again. Memory must be flat (the last quarter at most 10 % or 8 MiB above the second), file handles must not grow, and the same question must
have the same bytes as its answer at the end as at the start. Exit status 1: it is not so.
"""
import argparse
import concurrent.futures
import hashlib
import json
import os
import random
import shutil
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


def python(_, folder, minutes):
    import numpy
    import verisim

    text = (SCENE % "1").replace('#include "own.inc"', "sphere { Place, 0.3 pigment { rgb 1 } }")
    corners = verisim.Mesh(numpy.random.default_rng(1).uniform(-1, 1, (300, 3)), numpy.arange(300).reshape(-1, 3))

    def drawn(_):
        return verisim.render(text, 160, 120, declare={"Place": (1, 0, 0)}, antialias=0.3, threads=1).png()

    def fails(wrong):
        try:
            verisim.render(wrong, 16, 12)
        except verisim.SceneError as error:
            return str(error)
        raise AssertionError("a wrong scene is drawn")

    def everything(_):
        picture = verisim.render(text, 80, 60, declare={"Place": numpy.array([1, 0, 0])}, layers=True)
        meshes = verisim.render(text + "object { M pigment { rgb 1 } }", 40, 30, declare={"Place": (1, 0, 0), "M": corners})
        return [picture.png(), picture.depth.tobytes(), meshes.png(), repr(verisim.diff(picture, picture).status),
                repr(verisim.check(text.replace("Place", "1")).tree)[:1000], str(verisim.explain(text.replace("Place", "1"), 40, 30, 80, 60)),
                fails("bx { 0, 1 }"), fails("sphere { 0, 1"), fails("#while (1) #error \"no\" #end")]  # fmt: skip

    samples, rounds, first, last = [], 0, None, None
    end = time.monotonic() + 60 * minutes
    with concurrent.futures.ThreadPoolExecutor(3) as pool:
        while time.monotonic() < end:
            last = hashlib.sha256(repr([*pool.map(drawn, range(3)), *pool.map(everything, range(3))]).encode()).hexdigest()
            first = first or last
            rounds += 1
            samples.append((memory(os.getpid()), handles(os.getpid())))
    print(f"python: {rounds} rounds of three threads with seven renders, a check, a diff, an explanation and three errors each, in {minutes} minutes")
    return verdict(samples, first, last)


SBATCH = """#!/bin/sh
number=$(($(cat "$CALLS" 2>/dev/null || echo 100) + 1))
echo $number >"$CALLS"
echo $number
"""


def farm(verisim, folder, minutes):
    """Without Slurm: its programs are stand-ins that know of one job only, and the tasks are run here."""
    programs = os.path.join(folder, "programs")
    os.mkdir(programs)
    for name, text in (("sbatch", SBATCH), ("squeue", '#!/bin/sh\ncat "$CALLS.queue"\n'), ("scancel", "#!/bin/sh\n"), ("sacct", "#!/bin/sh\nexit 1\n")):
        save(programs, name, text)
        os.chmod(os.path.join(programs, name), 0o755)
    environment = {**os.environ, "PATH": f"{programs}:{os.environ['PATH']}", "CALLS": os.path.join(folder, "calls")}
    chance = random.Random(1)

    def call(*words, check=True):
        return subprocess.run([verisim, *words], cwd=folder, env=environment, check=check, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def task(job, step):
        """Kills its render now and then, at any moment; the task goes on from the state."""
        running = subprocess.Popen(["sh", f"{job}/task.sh", step], cwd=folder, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        if chance.random() < 0.3:
            time.sleep(chance.uniform(0, 0.1))
            with open(f"/proc/{running.pid}/task/{running.pid}/children") as children:
                for child in children.read().split():
                    try:
                        os.kill(int(child), signal.SIGKILL)
                    except ProcessLookupError:
                        pass  # it was faster
        return running.wait()

    samples, rounds, kills, first, last = [], 0, 0, None, None
    call("farm", "submit", "scene.pov", "+W320", "+H240", "+A0.3", "--job", "long.farm", "--output", "long.png", "--parts", "9", "--cpus", "1")
    with open(os.path.join(folder, "long.farm", "manifest.json")) as file:
        save(folder, "calls.queue", f"{json.load(file)['job']}-merge|N/A|PENDING||103|Dependency\n")
    waiting = subprocess.Popen([verisim, "farm", "wait", "long.farm"], cwd=folder, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    end = time.monotonic() + 60 * minutes
    while time.monotonic() < end:
        call("farm", "submit", "scene.pov", "+W320", "+H240", "+A0.3", "--job", "one.farm", "--output", "one.png", "--parts", "4", "--cpus", "1")
        for step in ("1", "2", "3", "4", "merge"):
            while task("one.farm", step) != 0:
                kills += 1
                call("farm", "resume", "one.farm", check=False)
        with open(os.path.join(folder, "one.png"), "rb") as file:
            last = hashlib.sha256(file.read()).hexdigest()
        first = first or last
        rounds += 1
        shutil.rmtree(os.path.join(folder, "one.farm"))
        os.unlink(os.path.join(folder, "one.png"))
        samples.append((memory(waiting.pid), handles(waiting.pid)))
        if last != first:
            break
    for step in map(str, range(1, 10)):
        while task("long.farm", step) != 0:
            kills += 1
    while task("long.farm", "merge") != 0:
        kills += 1
    wrong = [] if waiting.wait(60) == 0 else [f"`farm wait` ends with {waiting.returncode}"]
    print(f"farm: {rounds} jobs of four parts in {minutes} minutes, {kills} tasks begun anew; `farm wait` looked on")
    return wrong + verdict(samples, first, last)


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
    parser.add_argument("what", choices=["view", "python", "farm", "merge"])
    parser.add_argument("--minutes", type=float, default=60)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        save(folder, "scene.pov", SCENE % "1")
        save(folder, "own.inc", "sphere { <1, 0, 0>, 0.3 pigment { rgb 1 } }\n")
        wrong = {"view": view, "python": python, "farm": farm, "merge": merge}[options.what](os.path.abspath(options.verisim), folder, options.minutes)
    print("; ".join(wrong) or "all is as it was")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
