#!/usr/bin/env python3
"""Invents scenes, has POV-Ray and verisim render them, reduces what differs to a few lines and files it by likeness.

usage: invent.py --out FOLDER [--verisim PROGRAM] [--seed N] [--count N] [--seconds S] [--mutate FOLDER | --people | --rare]
                 [--no-reduce]
                 [--size 32x24]

Scene K of a seed is always the same. What was done is in FOLDER/state.json, so that a run that was interrupted goes on
where it was; FOLDER/found/ has a reduced scene a difference and FOLDER/classes.md the table. Exit status 1 if a
difference was found that known.json does not explain.
"""
import argparse
import collections
import concurrent.futures
import json
import pathlib
import re
import shutil
import sys
import time

import classes
import grammar
import mutate
import people
import programs
import rare
import reducer

BATCH = 12  # scenes of one version in one animation


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--out", required=True, type=pathlib.Path)
    parser.add_argument("--verisim", default=shutil.which("verisim") or "build/release/bin/verisim")
    parser.add_argument("--povray", default="povray")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seconds", type=float, default=1e9)
    parser.add_argument("--jobs", type=int, default=3)
    parser.add_argument("--mutate", type=pathlib.Path, help="mutate the scenes of this folder instead of inventing")
    parser.add_argument("--people", action="store_true", help="scenes as people write them, with standard include files")
    parser.add_argument("--rare", action="store_true", help="scenes with what people and the grammar seldom say")
    parser.add_argument("--no-reduce", action="store_true")
    parser.add_argument("--size", default="32x24", help="of the pictures")
    return parser.parse_args()


def batches(options, first):
    """Scenes by their numbers from `first`, in batches of one version and (for mutations) one folder of images."""
    waiting = collections.defaultdict(list)
    sources = mutate.sources(options.mutate) if options.mutate else None
    for number in range(first, options.count):
        seed = options.seed * 1_000_003 + number
        folder, (version, text) = (
            mutate.scene(seed, sources, options.seed * 1_000_003 + number // BATCH)
            if sources
            else (None, (people if options.people else rare if options.rare else grammar).scene(seed))
        )
        group = waiting[version, folder]
        group.append((number, text))
        if len(group) == BATCH:
            yield version, folder, group
            del waiting[version, folder]
    for (version, folder), group in waiting.items():
        yield version, folder, group


class Run:
    def __init__(self, options):
        self.options = options
        options.verisim = str(pathlib.Path(options.verisim).resolve())
        self.out = options.out
        (self.out / "found").mkdir(parents=True, exist_ok=True)
        self.state_file = self.out / "state.json"
        self.state = (
            json.loads(self.state_file.read_text())
            if self.state_file.exists()
            else {"done": [], "found": {}, "tried": 0, "skipped": 0}
        )
        self.done = set(self.state["done"])
        self.end = time.monotonic() + options.seconds

    def work(self, job):
        """One batch: rendered, judged, and what differs reduced. Runs on a thread of its own."""
        version, folder, group = job
        name = f"batch{group[0][0]}"
        runner = programs.Programs(
            self.options.povray, self.options.verisim, (self.out / "work").resolve(), [folder] if folder else []
        )
        found = {}
        differences = runner.differences(name, [text for _, text in group], version)
        for (number, text), difference in zip(group, differences):
            if (
                isinstance(difference, programs.Difference)
                and time.monotonic() < self.end
                and self.comes_again(runner, name + "r", version, text, difference)
            ):
                reduced = text
                if not self.options.no_reduce:
                    # Of warnings, their text is the class: such scenes are asked again, but not reduced.
                    budget = 1 if difference.kind == "warnings" else 200
                    reduced = reducer.Reducer(runner, name + "r", version, difference, self.end, budget).reduce(text)
                if reduced is not None:
                    found[number] = (version, difference, text, reduced)
        shutil.rmtree(self.out / "work" / name, ignore_errors=True)
        shutil.rmtree(self.out / "work" / (name + "r"), ignore_errors=True)
        skipped = sum(d == "skipped" for d in differences)
        return group, found, skipped

    @staticmethod
    def comes_again(runner, name, version, text, difference):
        """A scene alone is the judge: of an animation's frames POV-Ray loses messages now and then."""
        times = 3 if difference.kind in ("messages", "warnings") else 1
        return all(
            getattr(runner.differences(name, [text], version)[0], "kind", None) == difference.kind for _ in range(times)
        )

    def file(self, group, found, skipped):
        self.state["tried"] += len(group)
        self.state["skipped"] += skipped
        self.state["done"] += [number for number, _ in group]
        for number, (version, difference, text, reduced) in found.items():
            head = f"#version {version};\n" if version else ""
            note = f"// {difference.kind}: {difference.pixels} px, largest {difference.largest}. {difference.note}\n".replace(
                "\r", " "
            )
            path = self.out / "found" / f"{self.options.seed}_{number:06d}.pov"
            path.write_text(note + head + reduced, "latin-1", "replace")
            path.with_suffix(".whole").write_text(head + text, "latin-1", "replace")
            self.state["found"][path.name] = classes.signature(difference, reduced)
        self.state_file.write_text(json.dumps(self.state))
        self.unknown = classes.write_table(self.out, self.state)

    def run(self):
        waiting, started = set(), time.monotonic()
        with concurrent.futures.ThreadPoolExecutor(self.options.jobs) as pool:
            for job in batches(self.options, 0):
                job = (job[0], job[1], [item for item in job[2] if item[0] not in self.done])
                if not job[2]:
                    continue
                if time.monotonic() > self.end:
                    break
                waiting.add(pool.submit(self.work, job))
                if len(waiting) >= self.options.jobs:
                    ready, waiting = concurrent.futures.wait(waiting, return_when=concurrent.futures.FIRST_COMPLETED)
                    for future in ready:
                        self.file(*future.result())
            for future in concurrent.futures.as_completed(waiting):
                self.file(*future.result())
        unknown = classes.write_table(self.out, self.state)
        print(
            f"{self.state['tried']} scenes, {self.state['skipped']} too slow, {len(self.state['found'])} differ, "
            f"{unknown} of them not explained; {time.monotonic() - started:.0f} s; {self.out}/classes.md"
        )
        return 1 if unknown else 0


if __name__ == "__main__":
    if not re.search(r"3\.7", sys.version) and sys.version_info < (3, 9):
        sys.exit("needs Python 3.9 or later")
    options = arguments()
    programs.set_size(*map(int, options.size.split("x")))
    sys.exit(Run(options).run())
