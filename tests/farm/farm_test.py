#!/usr/bin/env python3
"""`verisim farm` without Slurm: programs in the place of Slurm's note how they are called, and the steps of a job are run by hand. What a job
makes is what one machine makes; bad use is refused with words that say what to do, and leaves nothing behind.

    farm_test.py VERISIM
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from scenes import SCENES, Folder  # noqa: E402

SBATCH = """#!/bin/sh
[ ! -e "$CALLS/refuse" ] || { echo "sbatch: error: invalid partition specified" >&2; exit 1; }
number=$(($(cat "$CALLS/number" 2>/dev/null || echo 100) + 1))
echo $number >"$CALLS/number"
for word in "$@"; do printf '%s\\n' "$word"; done >"$CALLS/$number"
echo $number
"""
SILENT = """#!/bin/sh
[ ! -e "$CALLS/down" ] || { echo "slurm_load_jobs error: Unable to contact slurm controller" >&2; exit 1; }
cat "$CALLS/queue" 2>/dev/null || :
"""
NO_ONE = 65534


class Test(Folder):
    def __init__(self, verisim, path):
        super().__init__(verisim, path)
        self.calls = path / "calls"
        self.calls.mkdir()
        programs = path / "programs"
        programs.mkdir()
        for name, text in (("sbatch", SBATCH), ("squeue", SILENT), ("scancel", SILENT), ("sacct", "#!/bin/sh\nexit 1\n")):
            (programs / name).write_text(text)
            (programs / name).chmod(0o755)
        self.environment = {**os.environ, "PATH": f"{programs}:{os.environ['PATH']}", "CALLS": str(self.calls), "HOME": str(path)}

    def farm(self, *words, status=0, **options):
        return self.call("farm", *words, status=status, **{"env": self.environment, **options})

    def by_hand(self, job, *steps, status=0):
        for step in steps:
            done = subprocess.run(["sh", str(self.path / job / "task.sh"), str(step)], capture_output=True, text=True, env=self.environment, cwd="/")
            if done.returncode != status:
                log = self.path / job / "logs" / f"{step}.log"
                sys.exit(f"{job}, {step}: status {done.returncode}, not {status}\n{done.stderr}\n{log.read_text() if log.exists() else ''}")

    def state(self, job, step):
        status = json.loads(self.farm("status", job, "--json"))
        return next(s for s in status["steps"] if s["step"] == str(step)) | {"complete": status["complete"]}

    def expect(self, true, what):
        if not true:
            sys.exit(what)

    def still(self):
        words = ["radiosity.pov", "+W70", "+H50", "+BS16", "+A0.3"]
        said = self.farm("submit", *words, "--job", "still.farm", "--output", "still.png", "--parts", 3, "--time", "1:00:00", "--partition", "render",
                         "--cpus", 4, "--engine-option=--account=films")
        self.expect("3 parts" in said and "101, 102, 103" in said, f"submit says {said}")
        prepass, tasks, merge = ((self.calls / str(n)).read_text().split("\n") for n in (101, 102, 103))
        for call in (prepass, tasks, merge):
            for option in ("--requeue", "--partition=render", "--time=1:00:00", "--cpus-per-task=4", "--account=films", "--signal=B:USR1@90"):
                self.expect(option in call, f"{option} is missing in {call}")
        self.expect("--array=1-3" in tasks and "--dependency=afterok:101" in tasks, f"{tasks}")
        self.expect("--dependency=afterany:101:102" in merge, f"{merge}")
        self.expect(self.state("still.farm", 1)["state"] == "missing", "nothing is done and nothing in the queue, and the status does not say so")
        name = json.loads((self.path / "still.farm" / "manifest.json").read_text())["job"]
        (self.calls / "queue").write_text(f"{name}-0|1|RUNNING|n7|102|None\n{name}-0|2|PENDING||102|Priority\n{name}-merge|N/A|PENDING||103|Dependency\n"
                                          f"{name}-0|3|FAILED|n8|102|NonZeroExitCode\n")
        self.expect(self.state("still.farm", 1)["state"] == "running" and self.state("still.farm", 1)["node"] == "n7", "it runs")
        self.expect(self.state("still.farm", 2)["state"] == "waiting", "it waits")
        self.expect("does its node see" in self.state("still.farm", 3)["note"], "it failed and said nothing")
        said = self.farm("resume", "still.farm", "--dry-run")
        self.expect("--array=3 " in said and "-merge" in said and "afterany:102" in said, f"what is missing alone: {said}")
        (self.calls / "down").touch()
        self.expect(self.state("still.farm", 1)["state"] == "unknown", "nobody knows")
        self.expect("Unable to contact" in self.farm("resume", "still.farm", status=5), "nobody knows what runs")
        (self.calls / "down").unlink(), (self.calls / "queue").unlink()
        self.by_hand("still.farm", "prepass", 1, 2)
        self.expect(self.state("still.farm", 2)["state"] == "done", "it is done")
        self.by_hand("still.farm", "merge", status=5)
        self.expect("of 3 parts 1 is missing: 3" in self.state("still.farm", "merge")["note"], "the merge says what is missing")
        self.by_hand("still.farm", 3, "merge")
        self.expect(self.state("still.farm", "merge")["complete"], "all is done")
        self.call("render", *words, "--output", "whole.png")
        self.same("still.png", "whole.png")
        self.expect("all is done" in self.farm("resume", "still.farm"), "nothing is missing")

    def animation(self):
        words = ["blur.pov", "+W24", "+H18", "+KFF7", "+SF2", "+STP2", "-A"]
        self.farm("submit", *words, "+Oanim.png", "--job", "film", "--frames-per-task", 2)
        self.by_hand("film", 1, 2)
        self.call("render", *words, "+Oone.png")
        for frame in (2, 4, 6):
            self.same(f"anim{frame}.png", f"one{frame}.png")
        self.expect(sorted(p.name for p in self.path.glob("anim*.png")) == ["anim2.png", "anim4.png", "anim6.png"], "other frames")
        self.expect(self.state("film", 2)["complete"], "all is done")

    def strange_names(self):
        name, job, picture = "a 'b' \"c\" $(touch hacked) `touch hacked`; é.pov", "job 'ü' $(touch hacked)\n*", "p ' %a $HOME.png"
        (self.path / name).write_text(SCENES["blur"][0])
        words = [name, "+W24", "+H18", "-A", "Declare=a=3"]
        self.farm("submit", *words, "--job", job, "--output", picture, "--parts", 2)
        self.by_hand(job, 1, 2, "merge")
        self.call("render", *words, "--output", "strange.png")
        self.same(picture, "strange.png")
        self.expect(not list(self.path.rglob("hacked")), "a name was run")

    def same(self, a, b):
        self.expect((self.path / a).read_bytes() == (self.path / b).read_bytes(), f"{a} is another picture than {b}")

    def recommended(self):
        for words, plan in ((["blur.pov", "+W24", "+H18", "-A"], "1 part"), (["blur.pov", "+W24", "+H18", "-A", "+KFF30"], "1 task of 30 frames")):
            said = self.farm("submit", *words, "--job", "never", "--dry-run", env={**self.environment, "PATH": "/usr/bin:/bin"})
            self.expect(plan in said.split("\n")[0] and "sbatch --parsable" in said and not (self.path / "never").exists(), f"a dry run: {said}")

    def bad_use(self):
        (self.path / "bad.pov").write_text("sphere { 0, 1 pigment { rgbx 1 } }\n")
        (self.path / "there").mkdir()
        (self.path / "old.png").write_text("a picture")
        (self.path / "broken").mkdir()
        (self.path / "broken" / "manifest.json").write_text("{ ")
        good = ["blur.pov", "+W8", "+H8", "--parts", "2", "--output", "new.png"]
        without = {**self.environment, "PATH": str(self.path)}
        for words, status, wanted, options in (
                ([], 2, "submit, status, wait, cancel or resume", {}),
                (["sumbit", "blur.pov"], 2, "may be submit", {}),
                (["submit"], 2, "no scene", {}),
                (["submit", *good], 5, "sbatch is not in PATH", {"env": without}),
                (["submit", *good, "--engine", "sge"], 2, "--engine is slurm", {}),
                (["submit", "nowhere.pov"], 5, "cannot find the scene 'nowhere.pov'", {}),
                (["submit", "bad.pov", "--parts", "2"], 3, "rgbx", {}),
                (["submit", "-", "--parts", "2"], 2, "not a stream", {}),
                (["submit", *good, "-F"], 2, "-F", {}),
                (["submit", *good, "--part", "1/2"], 2, "--part", {}),
                (["submit", *good, "--time", "soon"], 2, "--time is the limit", {}),
                (["submit", *good, "--time", "2", "--grace", "100"], 2, "less than half", {}),
                (["submit", *good, "+KFF4"], 2, "--frames-per-task", {}),
                (["submit", *good[:3], "--frames-per-task", "3"], 2, "--parts", {}),
                (["submit", *good, "--", "x"], 2, "leave out --", {}),
                (["submit", *good, "--job", "there"], 5, "is there already", {}),
                (["submit", *good[:-1], "old.png"], 5, "old.png' is there already", {}),
                (["submit", *good, "--job", "old.png/job"], 5, "cannot make the job folder", {}),
                (["submit", *good[:-1], "nofolder/new.png"], 5, "nofolder", {}),
                (["status", "nowhere"], 5, "no job folder", {}),
                (["resume", "there"], 5, "no job folder", {}),
                (["wait", "broken"], 5, "manifest.json", {}),
                (["wait"], 2, "one job folder", {})):
            said = self.farm(*words, status=status, **options)
            self.expect(wanted in said, f"{words}: {said}")
            self.expect(not list(self.path.glob("new*")), f"{words}: something was left behind")
        (self.calls / "refuse").touch()
        said = self.farm("submit", *good, status=5)
        self.expect("invalid partition" in said and not list(self.path.glob("new*")), f"sbatch refuses: {said}")
        (self.calls / "refuse").unlink()
        # Who may write everywhere cannot be refused; no one else may run a program in a closed folder, as in /root.
        if os.geteuid() == 0 and all(place.stat().st_mode & 0o001 for place in (self.verisim, *self.verisim.parents)):
            self.path.chmod(0o755)
            said = self.farm("submit", *good, status=5, user=NO_ONE, group=NO_ONE, extra_groups=[])
            self.expect("ermission denied" in said and not list(self.path.glob("new*")), f"a folder without permission: {said}")
        self.farm("submit", *good)
        manifest = self.path / "new.farm" / "manifest.json"
        script = self.path / "new.farm" / "task.sh"
        script.write_text(script.read_text().replace("directory=/", "directory=/not/here/"))
        done = subprocess.run(["sh", str(script), "1"], capture_output=True, text=True)
        self.expect(done.returncode == 5 and "must share the file system" in done.stderr, f"a node without the folder: {done.stderr}")
        manifest.write_text(manifest.read_text().replace('"tasks": 2', '"tasks": 0'))
        self.expect("impossible values" in self.farm("status", "new.farm", status=5), "a manifest that cannot be")


def main():
    with tempfile.TemporaryDirectory(prefix="verisim_farm_") as name:
        test = Test(sys.argv[1], pathlib.Path(name))
        for story in (test.still, test.animation, test.strange_names, test.recommended, test.bad_use):
            story()
            print(f"{story.__name__}: good", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
