#!/usr/bin/env python3
"""`verisim farm` on a real Slurm of two nodes that this test starts on this machine (slurm.py): whatever dies, what comes out is what one
machine draws, nothing that was whole is rendered again, and the status is true all the while. Skips itself (77), with the reason, where
Slurm cannot be started.

    slurm_test.py VERISIM               all stories: some minutes, most of them spent in Slurm's queue
    slurm_test.py VERISIM --quick       those of a minute
    slurm_test.py VERISIM STORY...
"""
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

sys.dont_write_bytecode = True
import accounting as slurm_accounting
import slurm as slurm_of_two  # noqa: E402
from scenes import SCENES, Folder  # noqa: E402


class Watcher(threading.Thread):
    """Asks for a job's status again and again, and holds it against what is there; remembers parts that were whole."""

    def __init__(self, test, job):
        super().__init__(daemon=True)
        self.test, self.job = test, job
        self.lies, self.seen, self.whole, self.over = [], [], {}, threading.Event()

    def run(self):
        while not self.over.is_set():
            self.look()
            self.over.wait(0.4)

    def look(self):
        status = self.test.status(self.job)
        self.seen.append(status)
        for step in status["steps"]:
            name = step["step"]
            part = self.test.path / self.job / "parts" / f"{name}.vsp"
            if not 0 <= step["fraction"] <= 1:
                self.lies.append(f"{name}: a fraction of {step['fraction']}")
            if step["state"] == "done" and name.isdigit() and part.parent.exists() and not part.exists():
                self.lies.append(f"{name}: done, and its part is not there")
            if step["state"] == "running" and not status["engine_answers"]:
                self.lies.append(f"{name}: running, says who?")
            if part.exists() and step["state"] == "done":
                self.whole.setdefault(name, part.stat().st_mtime_ns)

    def end(self, but=()):
        """Fails if the status lied, or parts that were whole were written again (`but`: those that were damaged)."""
        self.over.set()
        self.join()
        parts = self.test.path / self.job / "parts"
        for name, when in self.whole.items():
            if name not in but and (parts / f"{name}.vsp").stat().st_mtime_ns != when:
                self.lies.append(f"part {name} was whole and was rendered again")
        if self.lies:
            self.test.fail(self.job, "; ".join(self.lies[:5]))
        states = {step["state"] for status in self.seen for step in status["steps"]}
        print(f"  {self.job}: asked {len(self.seen)} times for the status, saw {', '.join(sorted(states))}")


class Test(Folder):
    def __init__(self, verisim, path):
        super().__init__(verisim, path)
        self.slurm = slurm_of_two.Slurm(self.path)

    def farm(self, *words, **options):
        return self.call("farm", *words, **options)

    def submit(self, job, scene, parts=12, *more):
        self.farm("submit", f"{scene}.pov", *SCENES[scene][1], "--job", job, "--output", f"{job}.png", "--parts", parts, *more)

    def status(self, job):
        done = subprocess.run([str(self.verisim), "farm", "status", job, "--json"], cwd=self.path, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"status of {job}: {done.stdout}{done.stderr}")
        return json.loads(done.stdout)

    def state(self, job, step):
        return next(s for s in self.status(job)["steps"] if s["step"] == step)

    def check(self, job, scene):
        """The job is complete, and its picture is that of one machine."""
        picture = self.path / f"{job}.png"
        if not self.status(job)["complete"]:
            self.fail(job, "it is not complete")
        if picture.read_bytes() != self.whole(scene):
            self.fail(job, "the picture is another one")
        print(f"  {job}: the same bytes")

    def fail(self, job, what):
        logs = "".join(f"== {log.name}\n{log.read_text(errors='replace')[-500:]}\n" for log in sorted((self.path / job / "logs").iterdir()))
        sys.exit(f"{job}: {what}\n{self.farm('status', job)}\n{logs[-6000:]}")

    def finish(self, job, scene):
        """Until nothing runs; what is missing is then resumed, once."""
        self.slurm.idle()
        if not self.status(job)["complete"]:
            said = self.farm("status", job)
            if "failed" not in said and "not in the queue" not in said:
                self.fail(job, f"it is not complete, and the status does not say so: {said}")
            self.farm("resume", job)
        self.farm("wait", job)
        self.check(job, scene)

    def processes(self, *words):
        """Numbers of the processes whose command lines have all these words in them."""
        found = []
        for entry in pathlib.Path("/proc").iterdir():
            if entry.name.isdigit():
                try:
                    line = (entry / "cmdline").read_bytes().decode(errors="replace")
                except OSError:
                    continue
                if all(w in line for w in words):
                    found.append(int(entry.name))
        return found

    def renders(self, job):
        return self.processes("render", str(self.verisim), f"/{job}/parts/")

    def until_rendering(self, job):
        self.slurm.until(lambda: self.renders(job), f"no task of {job} begins", 60)

    # ---- the stories

    def stills(self):
        jobs = {"radiosity": 12, "photons": 12, "blur": 12}
        for scene, parts in jobs.items():
            self.submit(f"still-{scene}", scene, parts)
        for scene in jobs:
            self.farm("wait", f"still-{scene}")
            self.check(f"still-{scene}", scene)

    def one_still(self):
        self.submit("one", "radiosity", 4)
        watcher = Watcher(self, "one")
        watcher.start()
        self.farm("wait", "one")
        self.check("one", "radiosity")
        watcher.end()

    def animation(self, frames=30, per_task=7):
        words = ["blur.pov", "+W64", "+H48", "+A0.3", f"+KFF{frames}"]
        self.farm("submit", *words, "+Oframe.png", "--job", "film", "--frames-per-task", per_task, "--nodes", 2)
        said = self.farm("wait", "film", "--progress", "json")
        if '"overall":1.0' not in said:
            sys.exit(f"film: the progress does not end in 1:\n{said}")
        self.call("render", *words, "+Owhole-frame.png")
        for number in range(1, frames + 1):
            if (self.path / f"frame{number:02}.png").read_bytes() != (self.path / f"whole-frame{number:02}.png").read_bytes():
                self.fail("film", f"frame {number} is another one")
        (self.path / "frame03.png").unlink()
        if "missing" not in {s["state"] for s in self.status("film")["steps"]} | {"missing" if self.state("film", "1")["state"] == "failed" else ""}:
            self.fail("film", "a picture is gone, and the status does not tell")
        kept = (self.path / "frame04.png").stat().st_mtime_ns
        self.farm("resume", "film")
        self.farm("wait", "film")
        if not (self.path / "frame03.png").exists() or (self.path / "frame04.png").stat().st_mtime_ns != kept:
            self.fail("film", "not just what was missing was rendered")
        print("  film: the same bytes")

    def strange_names(self):
        """Names from which a shell could make something else."""
        name = "a 'b' \"c\" $(touch hacked) `touch hacked`; %j %A é.pov"
        (self.path / name).write_text(SCENES["photons"][0])
        self.farm("submit", name, "+W64", "+H48", "Declare=odd=2", "--job", "job 'ü' %j $(touch hacked)", "--output", "pic ' %a.png", "--parts", 2)
        self.farm("wait", "job 'ü' %j $(touch hacked)")
        self.call("render", name, "+W64", "+H48", "Declare=odd=2", "--output", "whole-strange.png")
        if (self.path / "pic ' %a.png").read_bytes() != (self.path / "whole-strange.png").read_bytes() or (self.path / "hacked").exists():
            sys.exit("strange names: another picture, or a name was run")
        print("  strange names: the same bytes")

    def killed_renders(self):
        """Ten times kill -9 at random moments; tasks go on from their state."""
        self.submit("killed", "slow")
        watcher = Watcher(self, "killed")
        watcher.start()
        kills, rng, end = 0, random.Random(5), time.time() + 120
        while kills < 10 and time.time() < end:
            for pid in self.renders("killed")[:1]:
                try:
                    os.kill(pid, signal.SIGKILL)
                    kills += 1
                except ProcessLookupError:
                    pass
            time.sleep(rng.uniform(0.05, 1.5))
        if kills < 10:
            self.fail("killed", f"only {kills} were there to be killed")
        self.finish("killed", "slow")
        watcher.end()

    def killed_tasks(self):
        """The script dies with its render: Slurm calls that failed, and so does the status, until it is resumed."""
        self.submit("dead", "slow", 4)
        watcher = Watcher(self, "dead")
        watcher.start()
        self.until_rendering("dead")
        time.sleep(1)
        for pid in self.processes("slurm_script", "array", str(self.path)) + self.renders("dead"):
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        self.slurm.idle()
        if self.status("dead")["complete"] or not [s for s in self.status("dead")["steps"] if s["state"] == "failed"]:
            self.fail("dead", "tasks were killed, and the status does not tell")
        self.farm("wait", "dead", status=5)
        self.finish("dead", "slow")
        watcher.end()

    def damaged_part(self):
        self.submit("damaged", "radiosity", 5)
        self.farm("wait", "damaged")
        watcher = Watcher(self, "damaged")
        watcher.look()
        part = self.path / "damaged" / "parts" / "3.vsp"
        os.truncate(part, part.stat().st_size // 2)
        (self.path / "damaged.png").unlink()
        step = self.state("damaged", "3")
        if step["state"] != "failed" or "too early" not in step["note"]:
            self.fail("damaged", f"a truncated part is told as {step}")
        self.farm("resume", "damaged")
        self.farm("wait", "damaged")
        self.check("damaged", "radiosity")
        byte = self.path / "damaged" / "parts" / "2.vsp"  # of the same length, and wrong
        data = bytearray(byte.read_bytes())
        data[-100] ^= 1
        byte.write_bytes(data)
        (self.path / "damaged.png").unlink()
        self.farm("resume", "damaged")
        self.farm("wait", "damaged")
        self.check("damaged", "radiosity")
        watcher.start()
        watcher.end(but=("2", "3"))

    def dead_node(self):
        """A slurmd is killed while its tasks run, and comes back a little later."""
        self.submit("node", "slow")
        watcher = Watcher(self, "node")
        watcher.start()
        self.until_rendering("node")
        time.sleep(1)
        self.slurm.kill("n1")
        time.sleep(3)
        self.slurm.start("n1")
        self.finish("node", "slow")
        watcher.end()

    def dead_controller(self):
        self.submit("headless", "slow", 4, "+R3")  # all run at once
        watcher = Watcher(self, "headless")
        watcher.start()
        self.slurm.until(lambda: len(self.renders("headless")) == 4, "the tasks do not begin", 60)
        time.sleep(8)  # until slurmctld has written down that they run; what it has not, a plain Slurm loses
        self.slurm.kill("slurmctld")
        status = self.status("headless")
        if status["engine_answers"]:
            self.fail("headless", "slurmctld is dead, and answers?")
        self.farm("resume", "headless", status=5)  # nobody knows what still runs
        self.slurm.start("slurmctld")
        self.slurm.until(self.slurm.answers, "slurmctld does not come back")
        self.slurm.idle()
        self.farm("wait", "headless")
        self.call("render", "slow.pov", *SCENES["slow"][1], "+R3", "--output", "whole-headless.png")
        if (self.path / "headless.png").read_bytes() != (self.path / "whole-headless.png").read_bytes():
            self.fail("headless", "the picture is another one")
        watcher.end()

    def time_limit(self):
        """A task that needs longer than its limit saves its state, is queued again, and goes on."""
        self.submit("limit", "slow", 1, "+R3", "--time", "1", "--grace", "20")
        self.wholes.pop("slow", None)
        watcher = Watcher(self, "limit")
        watcher.start()
        self.slurm.until(lambda: '"requeue"' in (self.path / "limit/logs/1.log").read_text() if (self.path / "limit/logs/1.log").exists() else False,
                         "the limit does not come", 150)
        self.slurm.idle(600)
        self.farm("wait", "limit")
        self.call("render", "slow.pov", *SCENES["slow"][1], "+R3", "--output", "whole-limit.png")
        if (self.path / "limit.png").read_bytes() != (self.path / "whole-limit.png").read_bytes():
            self.fail("limit", "the picture is another one")
        watcher.end()
        print("  limit: the same bytes")

    def full_disk(self):
        disk = self.path / "small"
        disk.mkdir()
        if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=3m", "none", str(disk)], capture_output=True).returncode != 0:
            return print("  full disk: left out, nothing can be mounted here")
        try:
            self.farm("submit", "radiosity.pov", *SCENES["radiosity"][1], "--job", "small/full", "--output", "full.png", "--parts", 4)
            with open(disk / "ballast", "wb") as ballast:
                try:
                    while True:
                        ballast.write(bytes(65536))
                        ballast.flush()
                except OSError:
                    pass
            self.slurm.idle()
            status = self.status("small/full")
            if status["complete"] or not [s for s in status["steps"] if s["state"] == "failed"]:
                self.fail("small/full", "the disk was full, and the status does not tell")
            (disk / "ballast").unlink()
            self.farm("resume", "small/full")
            self.farm("wait", "small/full")
            if (self.path / "full.png").read_bytes() != self.whole("radiosity"):
                self.fail("small/full", "the picture is another one")
            print("  full disk: the same bytes")
        finally:
            subprocess.run(["umount", "--lazy", str(disk)], capture_output=True)

    def cancelled(self):
        self.submit("stopped", "slow", 6)
        self.until_rendering("stopped")
        self.farm("cancel", "stopped")
        self.slurm.idle()
        if not [s for s in self.status("stopped")["steps"] if s["state"] in ("failed", "missing")]:
            self.fail("stopped", "it was cancelled, and the status does not tell")
        self.farm("resume", "stopped", "--nodes", "1")
        self.farm("wait", "stopped")
        self.check("stopped", "slow")

    def no_shared_folder(self):
        """A node that does not see the folder: its tasks fail, and the status says where to look."""
        self.slurm.kill("n2", signal.SIGTERM)
        self.slurm.until(lambda: not self.processes("slurmd", str(self.slurm.conf), "-N", "n2"), "n2 does not end")
        hidden = self.path / "hidden"
        hidden.mkdir()
        try:
            self.slurm.start("n2", before=("unshare", "--mount", "sh", "-c", f'mount -t tmpfs none "{hidden}" && exec "$@"', "sh"))
        except slurm_of_two.CannotStart as error:
            self.slurm.start("n2")
            return print(f"  no shared folder: left out: {str(error).strip()}")
        self.slurm.until(lambda: self.slurm.ask("sinfo", "-h", "-o", "%T %D").strip() == "idle 2", "n2 does not come back")
        self.farm("submit", "blur.pov", "+W32", "+H24", "--job", "hidden/job", "--output", "hidden.png", "--parts", 4, "--engine-option=--nodelist=n2")
        self.slurm.idle()
        said = self.farm("status", "hidden/job")
        if "does its node see the job folder" not in said:
            sys.exit(f"no shared folder: {said}")
        self.slurm.kill("n2", signal.SIGTERM)
        self.slurm.until(lambda: not self.processes("slurmd", str(self.slurm.conf), "-N", "n2"), "n2 does not end")
        self.slurm.start("n2")
        print("  no shared folder: told")

    def accounting(self):
        """What Slurm has forgotten its accounting knows: a task that failed is told as failed."""
        why = slurm_accounting.why_not()
        if why:
            return print(f"  left out: {why}")
        with slurm_accounting.Accounting(self.slurm):
            self.submit("forgotten", "slow", 4)
            self.until_rendering("forgotten")
            for pid in self.processes("slurm_script", "array", str(self.path)) + self.renders("forgotten"):
                try:
                    os.kill(pid, signal.SIGKILL)
                except ProcessLookupError:
                    pass
            self.slurm.idle()
            self.slurm.until(lambda: not self.slurm.ask("squeue", "-h", "-t", "all").strip(), "Slurm does not forget", 200)
            failed = [s for s in self.status("forgotten")["steps"] if s["state"] == "failed" and s["note"] == "failed"]
            if not failed:
                self.fail("forgotten", f"the accounting is not asked: {self.status('forgotten')['steps']}")
            print(f"  accounting: {len(failed)} steps failed, and are told")
            self.finish("forgotten", "slow")

    def refusals(self):
        said = self.farm("submit", "blur.pov", "--job", "nowhere", "--parts", 2, "--partition", "nosuch", status=5)
        if "nosuch" not in said or "partition" not in said.lower() or (self.path / "nowhere").exists():
            sys.exit(f"a partition that is not there: {said}")
        print("  refusals: clear")


QUICK = ("one_still", "strange_names", "refusals")
ALL = ("stills", "animation", "strange_names", "damaged_part", "killed_renders", "killed_tasks", "dead_node", "dead_controller", "full_disk", "cancelled", "no_shared_folder", "refusals", "accounting", "time_limit")


def main():
    wanted = sys.argv[2:] or ALL
    why = slurm_of_two.why_not()
    if why:
        print(f"skipped: {why}")
        return 77
    path = tempfile.mkdtemp(prefix="verisim_slurm_")
    os.environ["HOME"] = path
    test = None
    try:
        try:
            test = Test(sys.argv[1], path)
        except slurm_of_two.CannotStart as error:
            print(f"skipped: Slurm does not start here: {error}")
            return 77
        for name in QUICK if list(wanted) == ["--quick"] else wanted:
            begin = time.time()
            print(name, flush=True)
            getattr(test, name)()
            print(f"  {time.time() - begin:.0f} s", flush=True)
    finally:
        if test:
            test.slurm.stop()
        shutil.rmtree(path, ignore_errors=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
