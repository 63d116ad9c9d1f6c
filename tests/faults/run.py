"""Every call of a kind fails once, and the program ends as it should: run.py VERISIM LIBRARY [options].

For each job (a render, a part, a merge, a diff, a check, a comparison) and each kind of call (write, read, open, mmap, rename, fsync,
malloc, thread) the calls are counted, and then the job is repeated with the first, the second, ... failing
(tests/faults/inject.cpp). Each time: no crash, no hang; exit status 0 only with exactly the bytes of an undisturbed run; otherwise an
error that is named, and under the final name nothing, or the whole old file, or the whole new one; and no temporary file.
With --signals N each job gets each signal of those that end programs at N moments instead: what counts is the same, but the signal may
end it, an interrupted render keeps its state, and SIGKILL leaves a temporary file.
Exit status 77: nothing can be injected here.
"""
import argparse
import collections
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import zlib

SCENE = b"""#version 3.7; global_settings { assumed_gamma 1 } camera { location <0,0,-5> look_at 0 }
light_source { <3,4,-9> rgb 1 } sphere { 0, 1 pigment { rgb <1,.5,.2> } }
#include "own.inc"
#debug "hello\\n"
"""
SIZE = ["+W16", "+H12", "-D"]
KINDS = ["write", "read", "open", "mmap", "rename", "fsync", "malloc", "thread"]
# The words of a job, the files that it makes, and whether there is something under their names before.
Job = collections.namedtuple("Job", "words outputs before", defaults=[False])
JOBS = {
    "render": Job(["render", "scene.pov", *SIZE, "+Oout.png", "+WT2", "--max-seconds=60"], ["out.png"]),
    "again": Job(["render", "scene.pov", *SIZE, "+Oout.png", "+WT2", "--stats=stats.json"], ["out.png"], True),
    "boxed": Job(["render", "scene.pov", *SIZE, "+Oout.ppm", "+FP", "--sandbox=best-effort"], ["out.ppm"]),
    "pipe": Job(["render", "scene.pov", *SIZE, "--output", "-"], []),
    "povray": Job(["+Iscene.pov", *SIZE, "+Oout.png"], ["out.png"]),
    "frames": Job(["render", "scene.pov", *SIZE, "+Oout.png", "+KFF2"], ["out1.png", "out2.png"]),
    "part": Job(["render", "scene.pov", *SIZE, "--part", "1/2", "--output", "out.part"], ["out.part"]),
    "merge": Job(["merge", "p1.part", "p2.part", "--output", "out.png"], ["out.png"], True),
    "diff": Job(["diff", "a.png", "b.png", "--heat-map", "out.png"], ["out.png"]),
    "check": Job(["check", "scene.pov", "--json"], []),
    "compare": Job(["compare", "scene.pov", *SIZE, "--baseline", "baseline", "--json", "out.json", "--quiet"], []),
    "store": Job(["compare", "scene.pov", *SIZE, "--baseline", "stored", "--update", "--quiet"], ["stored/scene.pov.png"]),
    "samples": Job(["render", "radiosity.pov", *SIZE, "+Oout.png", "+RFO", "+RFout.rca", "+WT1"], ["out.png", "out.rca"]),
}
SIGNALS = [signal.SIGKILL, signal.SIGTERM, signal.SIGINT, signal.SIGPIPE, signal.SIGHUP]
OLD = b"the picture of yesterday"


def is_whole(content):
    """Of a PNG file's essence, or of a PPM file."""
    if isinstance(content, tuple):
        return content[2]
    header = re.match(rb"P6\n(?:#[^\n]*\n)*(\d+)\s(\d+)\s255\s", content or b"")
    return bool(header) and len(content) == header.end() + 3 * int(header[1]) * int(header[2])


def essence(content):
    """Of a PNG file what is in it: its compressor has several ways to say the same. Of others the bytes; of what is not whole, too."""
    if content is None or not content.startswith(b"\x89PNG"):
        return content
    parts, packed, at = [], b"", 8
    while at + 12 <= len(content):
        size = int.from_bytes(content[at:at + 4], "big")
        kind, data = content[at + 4:at + 8], content[at + 8:at + 8 + size]
        if kind == b"IDAT":
            packed += data
        else:
            parts.append((kind, data))
        at += 12 + size
    try:
        return (parts, zlib.decompress(packed), at == len(content))
    except zlib.error:
        return content


class Faults:
    def __init__(self, verisim, library, folder, patience):
        self.verisim, self.library, self.folder, self.patience = verisim, library, folder, patience

    def path(self, name):
        return os.path.join(self.folder, name)

    def prepare(self):
        self.write("scene.pov", SCENE)
        self.write("own.inc", b"#declare Own = 1;\n")
        self.write("radiosity.pov", SCENE + b"global_settings { radiosity { count 20 } } plane { y, -1 pigment { rgb 1 } }\n")
        for k in (1, 2):
            self.plain(["render", "scene.pov", *SIZE, "--part", f"{k}/2", "--output", f"p{k}.part"])
        self.plain(["render", "scene.pov", *SIZE, "+Oa.png"])
        self.plain(["render", "scene.pov", *SIZE, "+Ob.png", "+Q3"])
        os.makedirs(self.path("baseline"), exist_ok=True)
        subprocess.run([self.verisim, "compare", "scene.pov", *SIZE, "--baseline", "baseline", "--update", "--quiet"], cwd=self.folder,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)

    def write(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content)

    def read(self, name):
        try:
            with open(self.path(name), "rb") as file:
                return essence(file.read())
        except FileNotFoundError:
            return None

    def plain(self, words):
        subprocess.run([self.verisim, *words], cwd=self.folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def lay(self, job):
        """What is there before a job."""
        for name in ("stats.json", "out.json"):
            if os.path.exists(self.path(name)):
                os.unlink(self.path(name))
        for name in job.outputs:
            if job.before:
                self.write(name, OLD)
            elif os.path.exists(self.path(name)):
                os.unlink(self.path(name))

    def run(self, job, **faults):
        self.lay(job)
        environment = {**os.environ, "LD_PRELOAD": self.library, **faults}
        try:
            ended = subprocess.run([self.verisim, *job.words], cwd=self.folder, env=environment, capture_output=True, timeout=self.patience, check=False)
        except subprocess.TimeoutExpired:
            return None
        return ended

    def leftovers(self):
        return [n for n in os.listdir(self.folder) if ".tmp" in n or n.startswith(".verisim") or n.endswith("-state")]

    def reference(self, job):
        ended = self.run(job)
        return ended, {name: self.read(name) for name in job.outputs}

    def count(self, job, kind, good):
        counts = self.path("counts.txt")
        if os.path.exists(counts):
            os.unlink(counts)
        ended = self.run(job, FAULT=kind, FAULT_COUNT=counts, **self.command(job))
        if ended is None or not os.path.exists(counts):
            return None
        if ended.returncode != good.returncode:
            sys.exit(f"{job.words[0]}: exit status {ended.returncode} where calls are only counted ({kind}): {ended.stderr.decode(errors='replace')}")
        with open(counts) as file:
            return int(file.read())

    @staticmethod
    def command(job):  # of compare and its renders, compare itself
        return {"FAULT_COMMAND": job.words[0]}

    def complaint(self, job, kind, ended, reference):
        good, whole = reference
        if ended is None:
            return "does not end"
        if ended.returncode < 0:
            return f"killed by {signal.Signals(-ended.returncode).name}"
        left = self.leftovers()
        for name in left:
            os.unlink(self.path(name))
        if kind == "signal":
            left = [name for name in left if not name.endswith("-state")]  # from which +C goes on
        if left and kind != "rename":
            return f"leaves {left}"
        for name in job.outputs:
            content = self.read(name)
            unfinished = kind == "signal" and ended.returncode != good.returncode and is_whole(content)  # what there was, as a whole file
            if content not in (None, OLD, whole[name]) and not unfinished:
                return f"half a file {name}"
            if content is None and job.before and job.words[0] != "render":  # which takes away the picture of an earlier run
                return f"{name} is gone"
            if ended.returncode == good.returncode and content != whole[name]:
                return f"exit status {ended.returncode} without {name}"
        if ended.returncode == good.returncode:
            if essence(ended.stdout) != essence(good.stdout) and job.words[0] in ("render", "check"):
                return "a cut output and exit status 0"
        elif not ended.stderr + ended.stdout and kind != "write":
            return f"exit status {ended.returncode} without a word"
        return ""


    def signalled(self, job, number, after):
        self.lay(job)
        running = subprocess.Popen([self.verisim, *job.words], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        time.sleep(after)
        running.send_signal(number)
        try:
            out, err = running.communicate(timeout=self.patience)
        except subprocess.TimeoutExpired:
            running.kill()
            running.communicate()
            return None
        return subprocess.CompletedProcess(running.args, running.returncode, out, err)


def after_signals(faults, job, reference, moments):
    """Of each signal and moment: the exit status and what is wrong."""
    start = time.monotonic()
    faults.run(job)
    whole = time.monotonic() - start
    for number in SIGNALS:
        for moment in range(moments):
            ended = faults.signalled(job, number, whole * moment / moments)
            by_it = ended is not None and ended.returncode == -number
            if by_it:  # before it was waited for, or SIGKILL
                ended.returncode, ended.stderr = 130, b"a signal"
                left = faults.leftovers() if number == signal.SIGKILL else []
                for name in left:
                    os.unlink(faults.path(name))
            why = faults.complaint(job, "signal", ended, reference)
            yield number, -number if by_it else ended and ended.returncode, why


def unsynced(faults):
    """Files that get their final name before all that was written to them is on the disk, of all jobs."""
    wrong, named = [], 0
    for name, job in JOBS.items():
        log = faults.path("order.txt")
        if os.path.exists(log):
            os.unlink(log)
        faults.run(job, FAULT="order", FAULT_LOG=log, **faults.command(job))
        with open(log) as file:
            events = [line.rstrip("\n").split("\t") for line in file]
        last = {}  # by file: what was done with it last
        for word, path, target in events:
            if word == "name" and path.endswith(".tmp") and ".tmp" not in target or "(deleted)" in path and word == "name" and ".tmp" not in target:
                named += 1
                if last.get(os.path.basename(path)) != "sync":
                    wrong.append(f"{name}: {target} is named when its bytes are not on the disk")
            elif word == "name":
                last[os.path.basename(target)] = last.get(os.path.basename(path))
            else:
                last[os.path.basename(path)] = word
    print(f"{named} files were named, {len(wrong)} before they were on the disk")
    return wrong if named else ["nothing was named"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("verisim")
    parser.add_argument("library")
    parser.add_argument("--order", action="store_true", help="only whether files are synced before they are named")
    parser.add_argument("--signals", type=int, metavar="N", help="signals at N moments of each job, and no failing calls")
    parser.add_argument("--jobs", default=",".join(JOBS))
    parser.add_argument("--kinds", default=",".join(KINDS))
    parser.add_argument("--most", type=int, default=0, help="of one job and kind, spread over all its calls; 0: all")
    parser.add_argument("--patience", type=float, default=60, help="seconds after which a job hangs")
    options = parser.parse_args()
    wrong = total = 0
    with tempfile.TemporaryDirectory() as folder:
        faults = Faults(os.path.abspath(options.verisim), os.path.abspath(options.library), folder, options.patience)
        faults.prepare()
        if options.order:
            wrong = unsynced(faults)
            print("\n".join(wrong))
            return 1 if wrong else 0
        for name in options.jobs.split(","):
            job = JOBS[name]
            reference = faults.reference(job)
            if reference[0] is None or reference[0].returncode not in (0, 1):
                print(f"{name}: does not run by itself: {reference[0] and reference[0].stderr.decode(errors='replace')}")
                return 1
            if options.signals:
                statuses = collections.Counter()
                for number, status, why in after_signals(faults, job, reference, options.signals):
                    statuses[status] += 1
                    total += 1
                    if why:
                        wrong += 1
                        print(f"WRONG {name}: {number.name}: {why}", flush=True)
                print(f"{name:8} signals, exit statuses {dict(statuses)}", flush=True)
                continue
            for kind in options.kinds.split(","):
                calls = faults.count(job, kind, reference[0])
                if calls is None:
                    print("nothing can be injected here")
                    return 77
                step = max(1, -(-calls // options.most)) if options.most else 1
                statuses = collections.Counter()
                for n in range(1, calls + 1, step):
                    ended = faults.run(job, FAULT=kind, FAULT_AT=str(n), **faults.command(job))
                    why = faults.complaint(job, kind, ended, reference)
                    statuses[ended.returncode if ended else "hung"] += 1
                    total += 1
                    if why:
                        wrong += 1
                        said = ended.stderr.decode(errors="replace").strip().splitlines()[-1:] if ended else []
                        print(f"WRONG {name}: {kind} {n} of {calls}: {why} {said}", flush=True)
                print(f"{name:8} {kind:7} {calls:6} calls, exit statuses {dict(statuses)}", flush=True)
    print(f"{total} {'signals' if options.signals else 'faults'}, {wrong} not endured")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
